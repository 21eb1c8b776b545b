"""Arithmetic of the Taylor recursion over a tree of joints, on as many states at once as `simd_lanes` holds.

A series of vectors is stored as u[3 k + (0, 1, 2)], its k-th Taylor coefficient. A frame is stored as a slot:
its rotation's three columns R (9 numbers), then the series of its origin p (N + 1 vectors) and of its angular
velocity w (N vectors), all in the world's axes.
"""

from __future__ import annotations

from typing import Any

from numba import njit

from workbench.kinematics.simd_lanes import (
    REGISTERS,
    fused_multiply_add,
    load,
    number,
    spread,
    store,
    turned_by_quarters,
)

OPTIONS: dict[str, Any] = {"fastmath": {"contract"}, "error_model": "numpy"}  # contract: a·b + c at once
compiled = njit(**OPTIONS)
inlined = njit(forceinline=True, **OPTIONS)  # a call would put all registers into memory
MANY_REGISTERS = REGISTERS >= 32  # two series of two coefficients have 12 sums and 9 factors

Number = Any
"""As many doubles as `lanes` says, one a state. In compiled code an int is a count, or an address."""

Vector = tuple[Number, Number, Number]
Axes = tuple[Vector, Vector, Vector]

# -- trigonometry ---------------------------------------------------------------------------------

LARGEST_ANGLE = 2.0**50  # radians; beyond it the nearest multiple of π/2 is not exact
HALF_PI = (1.5707963267948966, 6.123233995736766e-17)  # π/2 as a sum of two doubles
ROUNDING = 1.5 * 2.0**52  # adding it rounds to a whole number, which the last bits then hold


@compiled
def cosine_and_sine(x: Number) -> tuple[Number, Number]:
    """Returns cos and sin within 2^-52, by reduction to |r| ≤ π/4 and the polynomials of Sun's fdlibm
    there."""
    shifted = 0.6366197723675814 * x + spread(ROUNDING)
    n = shifted - spread(ROUNDING)
    r = fused_multiply_add(n, spread(-HALF_PI[0]), x)
    r = fused_multiply_add(n, spread(-HALF_PI[1]), r)
    square = r * r
    c = spread(-1.13596475577881948265e-11)
    c = c * square + spread(2.08757232129817482790e-09)
    c = c * square - spread(2.75573143513906633035e-07)
    c = c * square + spread(2.48015872894767294178e-05)
    c = c * square - spread(1.38888888888741095749e-03)
    c = c * square + spread(4.16666666666666019037e-02)
    c = c * square - spread(0.5)
    c = c * square + spread(1.0)
    s = spread(1.58969099521155010221e-10)
    s = s * square - spread(2.50507602534068634195e-08)
    s = s * square + spread(2.75573137070700676789e-06)
    s = s * square - spread(1.98412698298579493134e-04)
    s = s * square + spread(8.33333333332248946124e-03)
    s = s * square - spread(1.66666666666666324348e-01)
    s = s * (square * r) + r
    return turned_by_quarters(shifted, c, s)


# -- vectors --------------------------------------------------------------------------------------


@inlined
def load3(memory: int, at: int) -> Vector:
    return load(memory, at), load(memory, at + 1), load(memory, at + 2)


@inlined
def store3(memory: int, at: int, v: Vector) -> None:
    store(memory, at, v[0])
    store(memory, at + 1, v[1])
    store(memory, at + 2, v[2])


@inlined
def zero3() -> Vector:
    zero = spread(0.0)
    return zero, zero, zero


@inlined
def plus(a: Vector, b: Vector) -> Vector:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


@inlined
def minus(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@inlined
def scaled(s: Number, v: Vector) -> Vector:
    return s * v[0], s * v[1], s * v[2]


@inlined
def add_scaled(t: Vector, s: Number, v: Vector) -> Vector:
    return t[0] + s * v[0], t[1] + s * v[1], t[2] + s * v[2]


@inlined
def add_cross(t: Vector, a: Vector, b: Vector) -> Vector:
    """Returns t + a × b."""
    return (
        t[0] + a[1] * b[2] - a[2] * b[1],
        t[1] + a[2] * b[0] - a[0] * b[2],
        t[2] + a[0] * b[1] - a[1] * b[0],
    )


@inlined
def constant3(row: int, at: int) -> Vector:
    return spread(number(row, at)), spread(number(row, at + 1)), spread(number(row, at + 2))


@inlined
def turned_constant(slot: int, row: int, at: int) -> Vector:
    """Returns R c of a constant vector c (three doubles at row[at]) and the rotation R of a slot."""
    x, y, z = number(row, at), number(row, at + 1), number(row, at + 2)
    X, Y, Z = load3(slot, 0), load3(slot, 3), load3(slot, 6)
    return add_scaled(add_scaled(scaled(x, X), y, Y), z, Z)


IDENTITY, ABOUT_X, GENERAL = 0, 1, 2  # kinds of constant rotations


@inlined
def turned_axes(slot: int, row: int, at: int, turn: int) -> Axes:
    """Returns the columns of R C for the rotation R of a slot and a constant rotation C, its columns at
    row[at]."""
    X, Y, Z = load3(slot, 0), load3(slot, 3), load3(slot, 6)
    if turn == ABOUT_X:
        c, s = number(row, at + 4), number(row, at + 5)
        Y, Z = add_scaled(scaled(c, Y), s, Z), add_scaled(scaled(c, Z), -s, Y)
    elif turn == GENERAL:
        X = turned_constant(slot, row, at)
        Y = turned_constant(slot, row, at + 3)
        Z = turned_constant(slot, row, at + 6)
    return X, Y, Z


# -- series ---------------------------------------------------------------------------------------


@inlined
def store_carried(u: int, k: int, reciprocals: int, t: Vector) -> Vector:
    t = scaled(number(reciprocals, k), t)
    store3(u, 3 * k, t)
    return t


@inlined
def carry(w: int, u: int, last: int, reciprocals: int) -> None:
    """Fill the series u up to u_last, of which u_0 is there: u' = w × u. Two coefficients at a time, since
    they share their factors; each is the same whatever `last` is."""
    for k in range(1, last, 2):
        t, s, a = zero3(), zero3(), load3(w, 0)
        for j in range(k):
            b, c = load3(w, 3 * j + 3), load3(u, 3 * (k - 1 - j))
            t, s, a = add_cross(t, a, c), add_cross(s, b, c), b
        t = store_carried(u, k, reciprocals, t)
        store_carried(u, k + 1, reciprocals, add_cross(s, load3(w, 0), t))
    if last & 1:
        carry_last(w, u, last, reciprocals)


@inlined
def carry_last(w: int, u: int, k: int, reciprocals: int) -> None:
    """Fills u_k alone, adding its terms in the same order as `carry`."""
    t, even = zero3(), 1 - (k & 1)
    for j in range(even, k):
        t = add_cross(t, load3(w, 3 * j), load3(u, 3 * (k - 1 - j)))
    if even:
        t = add_cross(t, load3(w, 0), load3(u, 3 * (k - 1)))
    store_carried(u, k, reciprocals, t)


@inlined
def carry_both(w: int, u: int, v: int, last: int, reciprocals: int) -> None:
    """Applies `carry` to two series."""
    if not MANY_REGISTERS:
        carry(w, u, last, reciprocals)
        carry(w, v, last, reciprocals)
        return
    for k in range(1, last, 2):
        t, s, x, y, a = zero3(), zero3(), zero3(), zero3(), load3(w, 0)
        for j in range(k):
            b, c, d = load3(w, 3 * j + 3), load3(u, 3 * (k - 1 - j)), load3(v, 3 * (k - 1 - j))
            t, s, x, y, a = add_cross(t, a, c), add_cross(s, b, c), add_cross(x, a, d), add_cross(y, b, d), b
        t, x, a = store_carried(u, k, reciprocals, t), store_carried(v, k, reciprocals, x), load3(w, 0)
        store_carried(u, k + 1, reciprocals, add_cross(s, a, t))
        store_carried(v, k + 1, reciprocals, add_cross(y, a, x))
    if last & 1:
        carry_last(w, u, last, reciprocals)
        carry_last(w, v, last, reciprocals)


@inlined
def add_product(t: Vector, k: int, u: int, rate: int, rate_first: int) -> Vector:
    """Returns t + Σⱼ uⱼ · rate₍ₖ₋ⱼ₎, the coefficients of the rate from index rate_first on."""
    for j in range(k + 1):
        t = add_scaled(t, load(rate, rate_first + k - j), load3(u, 3 * j))
    return t
