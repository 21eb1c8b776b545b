"""Arithmetic of the Taylor recursion of a serial chain from tip to base, on as many states at once as
`simd_lanes` holds.

A twist series is stored as V[6 k + (0, 1, 2, 3, 4, 5)], the k-th coefficients of ωx, ωy, vx, vy, ωz, vz; the
series of e^{iα} as E[2 k + (0, 1)], those of cos α and sin α.
"""

from __future__ import annotations

from typing import NamedTuple

from workbench.kinematics.simd_lanes import load, number, spread, store, store_side_by_side
from workbench.kinematics.trees.tree_arithmetic import MANY_REGISTERS, Number, compiled, inlined

FOURS = MANY_REGISTERS  # four coefficients at a time have 16 sums; with fewer registers it is two

Pair = tuple[Number, Number]
Across = tuple[Number, Number, Number, Number]
"""The parts across a joint's axis: ωx, ωy, vx, vy."""

Link = tuple[Number, Number, Number, Number, Number]
"""From a joint's entering frame to the frame on the axis before: cosine and sine of the twist angle, the
shift (a, b), and the offset along that axis."""


class Base(NamedTuple):
    """How results are stored: cosine and sine of the base's constant angle, the address of the results'
    factors, the bytes of an order, of a part, and to the next turn's."""

    cosine: float
    sine: float
    factors: int
    of_order: int
    of_part: int
    ahead: int


@inlined
def load2(E: int, first: int) -> Pair:
    return load(E, first), load(E, first + 1)


@inlined
def load4(V: int, first: int) -> Across:
    return load(V, first), load(V, first + 1), load(V, first + 2), load(V, first + 3)


@inlined
def add_turned(total: Pair, rate: Number, e: Pair) -> Pair:
    """Returns total + i · rate · e, for total and e as (cos, sin)."""
    return total[0] - rate * e[1], total[1] + rate * e[0]


@inlined
def store_exponential(E: int, k: int, reciprocals: int, total: Pair) -> Pair:
    """Store and return the k-th coefficient of E, given k times that."""
    c, s = number(reciprocals, k) * total[0], number(reciprocals, k) * total[1]
    store(E, 2 * k, c)
    store(E, 2 * k + 1, s)
    return c, s


@inlined
def extend_exponential(E: int, rate: int, terms: int, reciprocals: int) -> None:
    """Computes all coefficients of E = e^{iα} from the 0-th, by E' = i α' E.

    As many as FOURS allows are computed at a time, since they share their factors.
    """
    nothing = (spread(0.0), spread(0.0))
    first = 1
    if (terms - 1) & 1:
        store_exponential(E, 1, reciprocals, add_turned(nothing, load(rate, 0), load2(E, 0)))
        first = 2
    fours = first + ((terms - first) & 2) if FOURS else terms
    for k in range(first, fours, 2):
        t0, t1 = nothing, nothing
        r1 = load(rate, k)
        for j in range(k):
            e, r0 = load2(E, 2 * j), load(rate, k - 1 - j)
            t0, t1 = add_turned(t0, r0, e), add_turned(t1, r1, e)
            r1 = r0
        e = store_exponential(E, k, reciprocals, t0)
        store_exponential(E, k + 1, reciprocals, add_turned(t1, r1, e))
    for k in range(fours, terms, 4):
        t0, t1, t2, t3 = nothing, nothing, nothing, nothing
        r1, r2, r3 = load(rate, k), load(rate, k + 1), load(rate, k + 2)
        for j in range(k):
            e, r0 = load2(E, 2 * j), load(rate, k - 1 - j)
            t0, t1 = add_turned(t0, r0, e), add_turned(t1, r1, e)
            t2, t3 = add_turned(t2, r2, e), add_turned(t3, r3, e)
            r1, r2, r3 = r0, r1, r2
        e = store_exponential(E, k, reciprocals, t0)
        t1, t2, t3 = add_turned(t1, r1, e), add_turned(t2, r2, e), add_turned(t3, r3, e)
        e = store_exponential(E, k + 1, reciprocals, t1)
        t2, t3 = add_turned(t2, r1, e), add_turned(t3, r2, e)
        e = store_exponential(E, k + 2, reciprocals, t2)
        store_exponential(E, k + 3, reciprocals, add_turned(t3, r1, e))


@compiled
def step(W: int, k: int, across: Across, z: Number, vz: Number, link: Link, base: Base | None) -> None:
    """Store a coefficient that is given in a joint's entering frame, in the frame next to the axis before:
    turned by the twist angle, shifted by (a, b) and by the offset along that axis. At the base it is the
    result: turned about that axis by a constant angle, scaled, and stored as (ω; v)."""
    x, y, vx, vy = across
    cosine, sine, a, b, offset = link
    y1 = cosine * y - sine * z
    z1 = cosine * z + sine * y
    vx1 = vx + b * z1 - offset * y1
    vy1 = cosine * vy - sine * vz - a * z1 + offset * x
    vz1 = cosine * vz + sine * vy + a * y1 - b * x
    if base is not None:
        factor = number(base.factors, k)
        c, s = factor * base.cosine, factor * base.sine
        target, of_part, ahead = W + k * base.of_order, base.of_part, base.ahead
        store_side_by_side(target, ahead, c * x - s * y1)
        store_side_by_side(target + of_part, ahead, s * x + c * y1)
        store_side_by_side(target + 2 * of_part, ahead, factor * z1)
        store_side_by_side(target + 3 * of_part, ahead, c * vx1 - s * vy1)
        store_side_by_side(target + 4 * of_part, ahead, s * vx1 + c * vy1)
        store_side_by_side(target + 5 * of_part, ahead, factor * vz1)
    else:
        store(W, 6 * k, x)
        store(W, 6 * k + 1, y1)
        store(W, 6 * k + 2, vx1)
        store(W, 6 * k + 3, vy1)
        store(W, 6 * k + 4, z1)
        store(W, 6 * k + 5, vz1)


@compiled
def add_product(total: Across, e: Pair, v: Across) -> Across:
    """Returns total + e^{iα} v, for e = (cos, sin)."""
    c, s = e
    x, y, vx, vy = v
    return (
        total[0] + c * x - s * y,
        total[1] + s * x + c * y,
        total[2] + c * vx - s * vy,
        total[3] + s * vx + c * vy,
    )


@compiled
def add_along_and_step(
    W: int, k: int, across: Across, V: int, rate: int, link: Link, base: Base | None
) -> None:
    step(W, k, across, load(V, 6 * k + 4) + load(rate, k), load(V, 6 * k + 5), link, base)


@inlined
def rotate_and_step(V: int, W: int, E: int, rate: int, terms: int, link: Link, base: Base | None) -> None:
    """Stores W = step(z α̇ + e^{iα} V).

    As many coefficients as FOURS allows are computed at a time, since they share their factors.
    """
    zero = spread(0.0)
    nothing = (zero, zero, zero, zero)
    if terms & 1:
        add_along_and_step(W, 0, add_product(nothing, load2(E, 0), load4(V, 0)), V, rate, link, base)
    first = terms & 1
    fours = first + ((terms - first) & 2) if FOURS else terms
    for k in range(first, fours, 2):
        t0, t1 = nothing, nothing
        e1 = load2(E, 2 * k + 2)
        for j in range(k + 1):
            v, e0 = load4(V, 6 * j), load2(E, 2 * (k - j))
            t0, t1 = add_product(t0, e0, v), add_product(t1, e1, v)
            e1 = e0
        t1 = add_product(t1, e1, load4(V, 6 * k + 6))
        add_along_and_step(W, k, t0, V, rate, link, base)
        add_along_and_step(W, k + 1, t1, V, rate, link, base)
    for k in range(fours, terms, 4):
        t0, t1, t2, t3 = nothing, nothing, nothing, nothing
        e1, e2, e3 = load2(E, 2 * k + 2), load2(E, 2 * k + 4), load2(E, 2 * k + 6)
        for j in range(k + 1):
            v, e0 = load4(V, 6 * j), load2(E, 2 * (k - j))
            t0, t1 = add_product(t0, e0, v), add_product(t1, e1, v)
            t2, t3 = add_product(t2, e2, v), add_product(t3, e3, v)
            e1, e2, e3 = e0, e1, e2
        add_along_and_step(W, k, t0, V, rate, link, base)
        v = load4(V, 6 * k + 6)
        t1, t2, t3 = add_product(t1, e1, v), add_product(t2, e2, v), add_product(t3, e3, v)
        add_along_and_step(W, k + 1, t1, V, rate, link, base)
        v = load4(V, 6 * k + 12)
        t2, t3 = add_product(t2, e1, v), add_product(t3, e2, v)
        add_along_and_step(W, k + 2, t2, V, rate, link, base)
        t3 = add_product(t3, e1, load4(V, 6 * k + 18))
        add_along_and_step(W, k + 3, t3, V, rate, link, base)


@compiled
def slide(V: int, D: int, q: int, pitch: float, reciprocals: int, terms: int) -> None:
    """Applies v ← v + z ḋ + d z × ω in place, for the slide d = pitch · q.

    At q are its value and then the coefficients of its rate.
    """
    store(D, 0, pitch * load(q, 0))
    for k in range(1, terms):
        store(D, k, (pitch * number(reciprocals, k)) * load(q, k))
    for k in range(terms):
        vx, vy = load(V, 6 * k + 2), load(V, 6 * k + 3)
        for j in range(k + 1):
            d = load(D, k - j)
            vx = vx - d * load(V, 6 * j + 1)
            vy = vy + d * load(V, 6 * j)
        store(V, 6 * k + 2, vx)
        store(V, 6 * k + 3, vy)
        store(V, 6 * k + 5, load(V, 6 * k + 5) + pitch * load(q, k + 1))


@compiled
def turn_and_step(
    V: int, W: int, cosine: float, sine: float, terms: int, link: Link, base: Base | None
) -> None:
    """Stores W = step(V rotated about z by a constant angle)."""
    for k in range(terms):
        x, y, vx, vy = load4(V, 6 * k)
        across = (
            cosine * x - sine * y,
            sine * x + cosine * y,
            cosine * vx - sine * vy,
            sine * vx + cosine * vy,
        )
        step(W, k, across, load(V, 6 * k + 4), load(V, 6 * k + 5), link, base)
