"""The compiled results of the pass over a tree: a body's pose, twists and Jacobians."""

from __future__ import annotations

from typing import Any

from workbench.kinematics.simd_lanes import (
    SIZE,
    load,
    number,
    spread,
    store,
    store_past_caches,
    store_side_by_side,
)
from workbench.kinematics.trees.tree_arithmetic import (
    Number,
    add_cross,
    carry,
    compiled,
    constant3,
    inlined,
    load3,
    minus,
    plus,
    scaled,
    store3,
    turned_axes,
    turned_constant,
    zero3,
)

POSE = 16  # numbers of a pose in the result
COLUMN = 6  # doubles of a column of the Jacobian in the plan
ALIGNED, AT_ONCE, PAST_CACHES = 0, 1, 2  # where the numbers of a body go


@inlined
def put(target: int, way: int, value: Number) -> None:
    """Stores a number of one row in the workspace (aligned) or in the caller's memory."""
    if way == ALIGNED:
        store(target, 0, value)
    elif way == AT_ONCE:
        store_side_by_side(target, 2 * SIZE, value)
    else:
        store_past_caches(target, value)


@compiled
def body_out(row: int, slot: int, v: int, N: int, constants: Any, rows: tuple[int, ...], way: int) -> None:
    """Writes the pose and the twists to `rows`, and the series of the body's origin to v.

    rows: (address of the pose, bytes of its row, address of the twists, bytes of an order and of a part). In
    the workspace the pose's last row is already set.
    """
    columns = N + 1
    frame_p, w = slot + 9 * SIZE, slot + (9 + 3 * columns) * SIZE
    pose, of_row, twists, of_order, of_part = rows
    base, factors, reciprocals = constant3(constants.origin, 0), constants.out_factors, constants.reciprocals
    if number(row, 18) != 0.0:
        store3(v, 0, turned_constant(slot, row, 3))
        carry(w, v, N, reciprocals)
        for k in range(columns):
            store3(v, 3 * k, plus(load3(v, 3 * k), load3(frame_p, 3 * k)))
    else:
        for k in range(columns):
            store3(v, 3 * k, load3(frame_p, 3 * k))
    X, Y, Z = turned_axes(slot, row, 6, int(number(row, 1)))
    p = plus(load3(v, 0), base)
    for i in range(3):
        put(pose + 4 * i * of_row, way, X[i])
        put(pose + (4 * i + 1) * of_row, way, Y[i])
        put(pose + (4 * i + 2) * of_row, way, Z[i])
        put(pose + (4 * i + 3) * of_row, way, p[i])
    if way != ALIGNED:
        for i in range(3):
            put(pose + (12 + i) * of_row, way, spread(0.0))
        put(pose + 15 * of_row, way, spread(1.0))
    for k in range(N):
        a, t = load3(w, 3 * k), scaled(number(reciprocals, -k - 1), load3(v, 3 * k + 3))
        a, t = scaled(number(factors, k), a), scaled(number(factors, k), t)
        target = twists + k * of_order
        for i in range(3):
            put(target + i * of_part, way, a[i])
            put(target + (3 + i) * of_part, way, t[i])


@compiled
def jacobian_out(
    entries: int, count: int, where: tuple[int, ...], J: int, orders: int, velocities: int, factors: int
) -> None:
    """Writes J(k, a, velocity), k < orders, of the body whose origin has the series v.

    The rows are those of its `count` columns. where: the addresses and size of slots, the axes, v, and d,
    space for a series.
    """
    S, slot_size, U, v, d = where
    zero = spread(0.0)
    for i in range(orders * 6 * velocities):
        store(J, i, zero)
    for entry in range(count):
        row = entries + 8 * COLUMN * entry
        slides, u = int(number(row, 0)), U + SIZE * int(number(row, 1))
        p, velocity = S + slot_size * int(number(row, 2)) + 9 * SIZE, int(number(row, 3))
        factor = number(row, 4)
        for k in range(orders):
            store3(d, 3 * k, minus(load3(v, 3 * k), load3(p, 3 * k)))
        for k in range(orders):
            f = factor * number(factors, k)
            z = scaled(f, load3(u, 3 * k))
            at = 6 * velocities * k + velocity
            if slides:
                for a in range(3):
                    to = at + (3 + a) * velocities
                    store(J, to, load(J, to) + z[a])
                continue
            t = zero3()
            for j in range(k + 1):
                t = add_cross(t, load3(u, 3 * j), load3(d, 3 * (k - j)))
            t = scaled(f, t)
            for a in range(3):
                store(J, at + a * velocities, load(J, at + a * velocities) + z[a])
                store(J, at + (3 + a) * velocities, load(J, at + (3 + a) * velocities) + t[a])


@compiled
def turning_out(
    entries: int, count: int, U: int, w: int, D: int, orders: int, velocities: int, factors: int
) -> None:
    """Writes D(k, a, velocity), k < orders: ż − ω × z and its derivatives for the axes z of rotations.

    ω is the body's own angular velocity, with the series w. D is 0 for translations.
    """
    zero = spread(0.0)
    for i in range(orders * 3 * velocities):
        store(D, i, zero)
    for entry in range(count):
        row = entries + 8 * COLUMN * entry
        if int(number(row, 0)):
            continue
        u, velocity, factor = U + SIZE * int(number(row, 1)), int(number(row, 3)), number(row, 4)
        for k in range(orders):
            t = scaled(-float(k + 1), load3(u, 3 * k + 3))
            for j in range(k + 1):
                t = add_cross(t, load3(w, 3 * j), load3(u, 3 * (k - j)))
            t = scaled(-factor * number(factors, k), t)
            for a in range(3):
                at = (3 * k + a) * velocities + velocity
                store(D, at, load(D, at) + t[a])
