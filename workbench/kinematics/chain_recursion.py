"""The arithmetic of the Taylor recursion of a serial chain, on as many states at once as `lanes` says."""

from numba import njit

from workbench.kinematics.lanes import (
    REGISTERS,
    fused_multiply_add,
    load,
    number,
    spread,
    store,
    store_side_by_side,
    turned_by_quarters,
)

OPTIONS = {"fastmath": {"contract"}, "error_model": "numpy"}  # contract: a·b + c at once
compiled = njit(**OPTIONS)
inlined = njit(forceinline=True, **OPTIONS)  # a call would put all registers into memory
FOURS = REGISTERS >= 32  # four coefficients at a time have 16 sums; with fewer registers it is two

# -- trigonometry ---------------------------------------------------------------------------------

LARGEST_ANGLE = 2.0**50  # radians; beyond it the nearest multiple of π/2 is not exact
HALF_PI = (1.5707963267948966, 6.123233995736766e-17)  # π/2 as a sum of two doubles


ROUNDING = 1.5 * 2.0**52  # adding it rounds to a whole number, which the last bits then hold


@compiled
def cosine_and_sine(x):
    """Within 2^-52 of the values, by reduction to |r| ≤ π/4 and the polynomials of Sun's fdlibm there."""
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


# -- the recursion --------------------------------------------------------------------------------
# A twist series is stored as V[6 k + (0, 1, 2, 3, 4, 5)] = k-th coefficient of ωx, ωy, vx, vy, ωz,
# vz; the series of e^{iα} as E[2 k + (0, 1)] = k-th coefficient of cos α, sin α.


@compiled
def load2(E, first):
    return load(E, first), load(E, first + 1)


@compiled
def load4(V, first):
    return load(V, first), load(V, first + 1), load(V, first + 2), load(V, first + 3)


@compiled
def add_turned(total, rate, e):
    """total + i · rate · e, for total and e as (cos, sin)."""
    return total[0] - rate * e[1], total[1] + rate * e[0]


@compiled
def store_exponential(E, k, reciprocals, total):
    """Store and return the k-th coefficient of E, given k times that."""
    c, s = number(reciprocals, k) * total[0], number(reciprocals, k) * total[1]
    store(E, 2 * k, c)
    store(E, 2 * k + 1, s)
    return c, s


@inlined
def extend_exponential(E, rate, terms, reciprocals):
    """All coefficients of E = e^{iα} from the 0-th, by E' = i α' E; as many as FOURS allows at a
    time, since they share their factors."""
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
def step(W, k, x, y, vx, vy, z, vz, link, base):
    """Store a coefficient that is given in a joint's entering frame, in the frame next to the axis
    before: turned by the twist angle, shifted by (a, b) and by the offset along that axis. At the base
    it is the result: turned about that axis by a constant angle, scaled, and stored as (ω; v), coefficient
    k from W + k · of_order on, its parts of_part bytes apart, the next turn's `ahead` bytes further."""
    cosine, sine, a, b, offset = link
    y1 = cosine * y - sine * z
    z1 = cosine * z + sine * y
    vx1 = vx + b * z1 - offset * y1
    vy1 = cosine * vy - sine * vz - a * z1 + offset * x
    vz1 = cosine * vz + sine * vy + a * y1 - b * x
    if base is not None:
        cosine, sine, factors, of_order, of_part, ahead = base
        factor = number(factors, k)
        c, s = factor * cosine, factor * sine
        target = W + k * of_order
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
def add_product(total, e, v):
    """total + e^{iα} v, for e = (cos, sin) and the across-axis parts (ωx, ωy, vx, vy)."""
    c, s = e
    x, y, vx, vy = v
    return (
        total[0] + c * x - s * y,
        total[1] + s * x + c * y,
        total[2] + c * vx - s * vy,
        total[3] + s * vx + c * vy,
    )


@compiled
def add_along_and_step(W, k, across, V, rate, link, base):
    x, y, vx, vy = across
    step(W, k, x, y, vx, vy, load(V, 6 * k + 4) + load(rate, k), load(V, 6 * k + 5), link, base)


@inlined
def rotate_and_step(V, W, E, rate, terms, link, base):
    """W = step(z α̇ + e^{iα} V), as many coefficients as FOURS allows at a time, since they share
    their factors."""
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
def slide(V, D, q, rate, pitch, reciprocals, terms):
    """v ← v + z ḋ + d z × ω in place, for the slide d = pitch · q."""
    store(D, 0, pitch * load(q, 0))
    for k in range(1, terms):
        store(D, k, (pitch * number(reciprocals, k)) * load(rate, k - 1))
    for k in range(terms):
        vx, vy = load(V, 6 * k + 2), load(V, 6 * k + 3)
        for j in range(k + 1):
            d = load(D, k - j)
            vx = vx - d * load(V, 6 * j + 1)
            vy = vy + d * load(V, 6 * j)
        store(V, 6 * k + 2, vx)
        store(V, 6 * k + 3, vy)
        store(V, 6 * k + 5, load(V, 6 * k + 5) + pitch * load(rate, k))


@compiled
def turn_and_step(V, W, cosine, sine, terms, link, base):
    """W = step(V turned about z by a constant angle)."""
    for k in range(terms):
        x, y, vx, vy = load4(V, 6 * k)
        x, y = cosine * x - sine * y, sine * x + cosine * y
        vx, vy = cosine * vx - sine * vy, sine * vx + cosine * vy
        step(W, k, x, y, vx, vy, load(V, 6 * k + 4), load(V, 6 * k + 5), link, base)
