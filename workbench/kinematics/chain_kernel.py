"""The Taylor recursion of a serial chain, compiled once for all chains and orders."""

from pathlib import Path

from numba import njit

from workbench.kinematics import lanes
from workbench.kinematics.lanes import (
    REGISTERS,
    SIZE,
    WIDTH,
    fused_multiply_add,
    load,
    load_states,
    number,
    set_number,
    spread,
    store,
    store_states,
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
def step(V, k, x, y, vx, vy, z, vz, link):
    """Store a coefficient that is given in a joint's entering frame, in the frame next to the axis
    before: turned by the twist angle, shifted by (a, b) and by the offset along that axis."""
    cosine, sine, a, b, offset = link
    y1 = cosine * y - sine * z
    z1 = cosine * z + sine * y
    vx1 = vx + b * z1
    vy1 = cosine * vy - sine * vz - a * z1
    vz1 = cosine * vz + sine * vy + a * y1 - b * x
    store(V, 6 * k, x)
    store(V, 6 * k + 1, y1)
    store(V, 6 * k + 2, vx1 - offset * y1)
    store(V, 6 * k + 3, vy1 + offset * x)
    store(V, 6 * k + 4, z1)
    store(V, 6 * k + 5, vz1)


@compiled
def step_along(V, k, z, vz, link):
    """`step` for a twist along the joint axis."""
    cosine, sine, a, b, offset = link
    y1, z1 = spread(0.0) - sine * z, cosine * z
    store(V, 6 * k, spread(0.0))
    store(V, 6 * k + 1, y1)
    store(V, 6 * k + 2, b * z1 - offset * y1)
    store(V, 6 * k + 3, spread(0.0) - sine * vz - a * z1)
    store(V, 6 * k + 4, z1)
    store(V, 6 * k + 5, cosine * vz + a * y1)


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
def add_along_and_step(W, k, across, V, rate, link):
    x, y, vx, vy = across
    step(W, k, x, y, vx, vy, load(V, 6 * k + 4) + load(rate, k), load(V, 6 * k + 5), link)


@inlined
def rotate_and_step(V, W, E, rate, terms, link):
    """W = step(z α̇ + e^{iα} V), as many coefficients as FOURS allows at a time, since they share
    their factors."""
    zero = spread(0.0)
    nothing = (zero, zero, zero, zero)
    if terms & 1:
        add_along_and_step(W, 0, add_product(nothing, load2(E, 0), load4(V, 0)), V, rate, link)
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
        add_along_and_step(W, k, t0, V, rate, link)
        add_along_and_step(W, k + 1, t1, V, rate, link)
    for k in range(fours, terms, 4):
        t0, t1, t2, t3 = nothing, nothing, nothing, nothing
        e1, e2, e3 = load2(E, 2 * k + 2), load2(E, 2 * k + 4), load2(E, 2 * k + 6)
        for j in range(k + 1):
            v, e0 = load4(V, 6 * j), load2(E, 2 * (k - j))
            t0, t1 = add_product(t0, e0, v), add_product(t1, e1, v)
            t2, t3 = add_product(t2, e2, v), add_product(t3, e3, v)
            e1, e2, e3 = e0, e1, e2
        v = load4(V, 6 * k + 6)
        t1, t2, t3 = add_product(t1, e1, v), add_product(t2, e2, v), add_product(t3, e3, v)
        v = load4(V, 6 * k + 12)
        t2, t3 = add_product(t2, e1, v), add_product(t3, e2, v)
        t3 = add_product(t3, e1, load4(V, 6 * k + 18))
        add_along_and_step(W, k, t0, V, rate, link)
        add_along_and_step(W, k + 1, t1, V, rate, link)
        add_along_and_step(W, k + 2, t2, V, rate, link)
        add_along_and_step(W, k + 3, t3, V, rate, link)


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
def turn_and_step(V, W, cosine, sine, terms, link):
    """W = step(V turned about z by a constant angle)."""
    for k in range(terms):
        x, y, vx, vy = load4(V, 6 * k)
        x, y = cosine * x - sine * y, sine * x + cosine * y
        vx, vy = cosine * vx - sine * vy, sine * vx + cosine * vy
        step(W, k, x, y, vx, vy, load(V, 6 * k + 4), load(V, 6 * k + 5), link)


# -- the kernel -----------------------------------------------------------------------------------

HEADER, ROW = 5, 10  # numbers before the factors, and for each joint, in the plan


@compiled
def twist_of_block(Q, E, V, W, D, sizes, plan, joints, terms, output_factors, reciprocals, rows):
    """From Q[i (n + 2) + k], coordinate i and its scaled rates, to the scaled twist
    W[6 k + (0 … 5)] = k-th coefficient of (ω; v). Adds the squares of the angles to
    `sizes`."""
    columns = terms + 1
    zero = spread(0.0)
    squares = load(sizes, 0)
    for joint in range(joints - 1):
        row = rows + 8 * ROW * joint
        angle = int(number(row, 0))
        if angle >= 0:
            E_joint = E + 2 * SIZE * terms * joint
            alpha = load(Q, angle * columns)
            squares = squares + alpha * alpha
            c, s = cosine_and_sine(alpha)
            store(E_joint, 0, number(row, 8) * c - number(row, 9) * s)
            store(E_joint, 1, number(row, 8) * s + number(row, 9) * c)
    for joint in range(joints - 1):
        angle = int(number(rows + 8 * ROW * joint, 0))
        if angle >= 0:
            rate = Q + SIZE * (angle * columns + 1)
            extend_exponential(E + 2 * SIZE * terms * joint, rate, terms, reciprocals)
    for joint in range(joints - 1, -1, -1):
        row = rows + 8 * ROW * joint
        angle, sliding, pitch = int(number(row, 0)), int(number(row, 1)), number(row, 2)
        link = (
            spread(number(row, 3)),
            spread(number(row, 4)),
            spread(number(row, 5)),
            spread(number(row, 6)),
            spread(number(row, 7)),
        )
        rate = Q + SIZE * (angle * columns + 1)
        slide_rate = Q + SIZE * (sliding * columns + 1)
        if joint == joints - 1:
            for k in range(terms):
                z = load(rate, k) if angle >= 0 else zero
                vz = pitch * load(slide_rate, k) if sliding >= 0 else zero
                step_along(W, k, z, vz, link)
        else:
            if sliding >= 0:
                slide(V, D, slide_rate - SIZE, slide_rate, pitch, reciprocals, terms)
            if angle >= 0:
                rotate_and_step(V, W, E + 2 * SIZE * terms * joint, rate, terms, link)
            else:
                turn_and_step(V, W, number(row, 8), number(row, 9), terms, link)
        V, W = W, V
    for k in range(terms):
        factor = number(output_factors, k)
        c, s = factor * number(plan, 3), factor * number(plan, 4)
        for part in (0, 1):
            x, y = load(V, 6 * k + 2 * part), load(V, 6 * k + 2 * part + 1)
            store(W, 6 * k + 3 * part, c * x - s * y)
            store(W, 6 * k + 3 * part + 1, s * x + c * y)
            store(W, 6 * k + 3 * part + 2, factor * load(V, 6 * k + 4 + part))
    store(sizes, 0, squares)
    return W


def workspace_size(dof, joints, terms):
    """Doubles to leave at the end of a plan."""
    return WIDTH * (max(dof * (terms + 1), WIDTH) + 2 * terms * joints + 13 * terms + 2)


@compiled
def read_block(source, inputs, here, whole, factors, Q):
    """`here` states of `inputs` doubles, times their factors, into Q; the first one in all other lanes."""
    if whole:
        for i in range(0, inputs, WIDTH):
            i = max(0, min(i, inputs - WIDTH))
            load_states(source + 8 * i, 8 * inputs, factors + 8 * i, Q, i)
        return
    for i in range(inputs):
        store(Q, i, spread(number(factors, i) * number(source, i)))
    for lane in range(1, here):
        for i in range(inputs):
            set_number(Q, WIDTH * i + lane, number(factors, i) * number(source, inputs * lane + i))


@compiled
def write_block(result, outputs, here, whole, target):
    if whole:
        for i in range(0, outputs, WIDTH):
            i = max(0, min(i, outputs - WIDTH))
            store_states(result, i, target + 8 * i, 8 * outputs)
        return
    for lane in range(here):
        for i in range(outputs):
            set_number(target, outputs * lane + i, number(result, WIDTH * i + lane))


def _twists_of_states(q, plan, out):
    """q (states · dof, n + 2) → out (states · (n + 1), 6), scaled by the factors of the plan, given
    by its address. Returns False, with `out` unusable, if an angle exceeds LARGEST_ANGLE.

    The workspace is the end of the plan: two calls cannot meet there, for Python's global lock is
    held throughout."""
    joints, dof, terms = int(number(plan, 0)), int(number(plan, 1)), int(number(plan, 2))
    inputs, outputs = dof * (terms + 1), 6 * terms
    states = q.shape[0] // dof
    factors = plan + 8 * HEADER
    output_factors = factors + 8 * max(inputs, WIDTH)
    reciprocals = output_factors + 8 * terms
    rows = reciprocals + 8 * terms
    Q = (rows + 8 * ROW * joints + SIZE - 1) // SIZE * SIZE
    E = Q + SIZE * max(inputs, WIDTH)
    V = E + 2 * SIZE * terms * joints
    W = V + 6 * SIZE * terms
    D = W + 6 * SIZE * terms
    sizes = D + SIZE * terms
    store(sizes, 0, spread(0.0))
    for first in range(0, states, WIDTH):
        here = min(WIDTH, states - first)
        before = first + WIDTH - 1  # a whole block is read and written by WIDTH doubles of each state
        whole = here == WIDTH and before * inputs + WIDTH <= states * inputs
        read_block(q.ctypes.data + 8 * inputs * first, inputs, here, whole, factors, Q)
        result = twist_of_block(Q, E, V, W, D, sizes, plan, joints, terms, output_factors, reciprocals, rows)
        whole = here == WIDTH and before * outputs + WIDTH <= states * outputs
        write_block(result, outputs, here, whole, out.ctypes.data + 8 * outputs * first)
    largest = 0.0
    for lane in range(WIDTH):
        largest = max(largest, number(sizes, lane))
    return largest <= LARGEST_ANGLE**2


def _compile():
    """The kernel, kept on disk if there is a place for it. Numba would not notice that lanes.py has
    changed since, so what is older than that file is removed first."""
    try:
        kernel = njit(cache=True, **OPTIONS)(_twists_of_states)
        for index in Path(kernel.stats.cache_path).glob("chain_kernel._twists_of_states*.nbi"):
            if index.stat().st_mtime < Path(lanes.__file__).stat().st_mtime:
                index.unlink(missing_ok=True)
    except (RuntimeError, OSError):
        kernel = njit(**OPTIONS)(_twists_of_states)
    kernel.compile("boolean(float64[:,::1], int64, float64[:,::1])")
    kernel.disable_compile()
    return kernel


_kernel = _compile()
(twist_kernel,) = (overload.entry_point for overload in _kernel.overloads.values())
"""`_twists_of_states`, called without Numba's look at the arguments' types, which takes 0.1 µs: nothing but
C-contiguous matrices of native doubles and an int may be given."""
