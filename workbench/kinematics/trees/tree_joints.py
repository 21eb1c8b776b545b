"""The compiled steps of the pass over a tree: from a frame to the one that a joint moves."""

from __future__ import annotations

from workbench.kinematics.simd_lanes import SIZE, load, number, spread, store
from workbench.kinematics.trees.tree_arithmetic import (
    Axes,
    Vector,
    add_product,
    add_scaled,
    carry,
    carry_both,
    carry_last,
    compiled,
    constant3,
    inlined,
    load3,
    plus,
    scaled,
    store3,
    turned_axes,
    turned_constant,
    zero3,
)

TURN, SLIDE, SCREW, BALL = 0, 1, 2, 3  # kinds of steps


@inlined
def scaled_rates(Q: int, channel: int, factor: float, offset: float, F: int, N: int) -> int:
    """Returns the address of a drive's coefficients: [value, rate₀, rate₁, …] of factor · (channel) +
    offset."""
    source = Q + SIZE * channel * (N + 1)
    if factor == 1.0 and offset == 0.0:
        return source
    store(F, 0, factor * load(source, 0) + spread(offset))
    for k in range(1, N + 1):
        store(F, k, factor * load(source, k))
    return F


@inlined
def turned_by_quaternion(X: Vector, Y: Vector, Z: Vector, Q: int, first: int, columns: int) -> Axes:
    """Returns the axes times the rotation of a unit quaternion, the 0-th coefficients of four channels."""
    w, x = load(Q, first * columns), load(Q, (first + 1) * columns)
    y, z = load(Q, (first + 2) * columns), load(Q, (first + 3) * columns)
    one, two = spread(1.0), spread(2.0)
    first_column = one - two * (y * y + z * z), two * (x * y + w * z), two * (x * z - w * y)
    second_column = two * (x * y - w * z), one - two * (x * x + z * z), two * (y * z + w * x)
    third_column = two * (x * z + w * y), two * (y * z - w * x), one - two * (x * x + y * y)
    a, b, c = first_column
    new_x = add_scaled(add_scaled(scaled(a, X), b, Y), c, Z)
    a, b, c = second_column
    new_y = add_scaled(add_scaled(scaled(a, X), b, Y), c, Z)
    a, b, c = third_column
    return new_x, new_y, add_scaled(add_scaled(scaled(a, X), b, Y), c, Z)


@inlined
def store_rotation(
    slot: int, kind: int, X: Vector, Y: Vector, Z: Vector, E: int, Q: int, channel: int, columns: int
) -> None:
    """Stores the rotation after the joint, from the axes before it."""
    if kind == BALL:
        X, Y, Z = turned_by_quaternion(X, Y, Z, Q, channel, columns)
    elif kind != SLIDE:
        c, s = load(E, 0), load(E, 1)
        X, Y = add_scaled(scaled(c, X), s, Y), add_scaled(scaled(c, Y), spread(0.0) - s, X)
    store3(slot, 0, X)
    store3(slot, 3, Y)
    store3(slot, 6, Z)


@compiled
def first_step(
    row: int, kind: int, drives: tuple[int, ...], slot: int, u: int, N: int, reciprocals: int
) -> None:
    """Stores the frame of a joint on the world."""
    columns = N + 1
    E, Q, channel, turn_rate, slide_rate = drives
    p, w = slot + 9 * SIZE, slot + (9 + 3 * columns) * SIZE
    X, Y, Z = constant3(row, 13), constant3(row, 16), constant3(row, 19)
    store_rotation(slot, kind, X, Y, Z, E, Q, channel, columns)
    origin, zero = constant3(row, 10), zero3()
    if kind == BALL:
        store3(u, 0, X)
        store3(u, 3 * columns, Y)
        store3(u, 6 * columns, Z)
        for k in range(1, columns):
            store3(u, 3 * k, zero)
            store3(u, 3 * columns + 3 * k, zero)
            store3(u, 6 * columns + 3 * k, zero)
    else:
        store3(u, 0, Z)
        for k in range(1, columns):
            store3(u, 3 * k, zero)
    slides = kind in (SLIDE, SCREW)
    if slides:
        origin = add_scaled(origin, load(slide_rate, 0), Z)
    store3(p, 0, origin)
    for k in range(N):
        t = zero
        if kind == BALL:
            t = scaled(load(Q, (channel + 1) * columns + k + 1), X)
            t = add_scaled(t, load(Q, (channel + 2) * columns + k + 1), Y)
            t = add_scaled(t, load(Q, (channel + 3) * columns + k + 1), Z)
        elif kind != SLIDE:
            t = scaled(load(turn_rate, k + 1), Z)
        store3(w, 3 * k, t)
        t = zero
        if slides:
            t = scaled(number(reciprocals, k + 1) * load(slide_rate, k + 1), Z)
        store3(p, 3 * k + 3, t)


@inlined
def store_turning(before: int, w: int, u: int, rate: int, N: int) -> None:
    """Stores ω' = ω + z α̇, two coefficients at a time."""
    for k in range(0, N - 1, 2):
        t, s, r = load3(before, 3 * k), load3(before, 3 * k + 3), load(rate, k + 2)
        for j in range(k + 1):
            z, q = load3(u, 3 * j), load(rate, k + 1 - j)
            t, s, r = add_scaled(t, q, z), add_scaled(s, r, z), q
        store3(w, 3 * k, t)
        store3(w, 3 * k + 3, add_scaled(s, r, load3(u, 3 * k + 3)))
    if N & 1:
        store3(w, 3 * (N - 1), add_product(load3(before, 3 * (N - 1)), N - 1, u, rate, 1))


@inlined
def turn_ball(before: int, w: int, u: int, Q: int, N: int, reciprocals: int) -> None:
    """Carry the three axes u of a ball, and ω' = ω + Σ axis · rate, the rates in the channels Q after the
    first."""
    of_axis = 3 * SIZE * (N + 1)
    for axis in range(3):
        carry(before, u + of_axis * axis, N, reciprocals)
    for k in range(N):
        t = load3(before, 3 * k)
        for axis in range(3):
            t = add_product(t, k, u + of_axis * axis, Q + SIZE * (N + 1) * (axis + 1), 1)
        store3(w, 3 * k, t)


@inlined
def add_shift(t: Vector, k: int, u: int, rate: int, reciprocals: int) -> Vector:
    """Returns t + (z d)₍ₖ₎ of a shift d, whose coefficients after the first are those of its rate over 1, 2,
    …"""
    for j in range(k):
        t = add_scaled(t, number(reciprocals, k - j) * load(rate, k - j), load3(u, 3 * j))
    return add_scaled(t, load(rate, 0), load3(u, 3 * k))


@compiled
def next_step(
    row: int,
    kind: int,
    drives: tuple[int, ...],
    before: int,
    slot: int,
    u: int,
    v: int,
    keep: bool,
    N: int,
    reciprocals: int,
) -> None:
    """Stores the frame of a joint on the frame in the slot `before`.

    u receives its axis (three for a ball), v is space for its offset. keep: whether the last coefficient of
    the axis is also needed.
    """
    columns = N + 1
    E, Q, channel, turn_rate, slide_rate = drives
    before_p, before_w = before + 9 * SIZE, before + (9 + 3 * columns) * SIZE
    p, w = slot + 9 * SIZE, slot + (9 + 3 * columns) * SIZE
    X, Y, Z = turned_axes(before, row, 13, int(number(row, 3)))
    store_rotation(slot, kind, X, Y, Z, E, Q, channel, columns)
    apart = number(row, 22) != 0.0
    if apart:
        store3(v, 0, turned_constant(before, row, 10))
    if kind == BALL:
        store3(u, 0, X)
        store3(u, 3 * columns, Y)
        store3(u, 6 * columns, Z)
        turn_ball(before_w, w, u, Q + SIZE * columns * channel, N, reciprocals)
        if apart:
            carry(before_w, v, N, reciprocals)
    else:
        store3(u, 0, Z)
        last = N if kind != TURN or keep else max(N - 1, 0)
        if apart:
            carry_both(before_w, u, v, last, reciprocals)
            if last < N:
                carry_last(before_w, v, N, reciprocals)
        else:
            carry(before_w, u, last, reciprocals)
        if kind == SLIDE:
            for k in range(N):
                store3(w, 3 * k, load3(before_w, 3 * k))
        else:
            store_turning(before_w, w, u, turn_rate, N)
    slides = kind in (SLIDE, SCREW)
    for k in range(columns):
        t = load3(before_p, 3 * k)
        if apart:
            t = plus(t, load3(v, 3 * k))
        if slides:
            t = add_shift(t, k, u, slide_rate, reciprocals)
        store3(p, 3 * k, t)
