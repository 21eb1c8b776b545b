"""The Taylor recursion of a serial chain, compiled: eight states at a time, one in each lane.

Sections: the number type `lanes`; the trigonometry; the recursion; the kernel. (One file, because
Numba's cache on disk watches only the file of the kernel.)
"""

import operator

import numpy as np
from llvmlite import ir
from numba import njit, types
from numba.core import cgutils
from numba.core.typing.templates import ConcreteTemplate, infer_global, signature
from numba.extending import intrinsic, lower_builtin, models, register_model

# -- eight doubles as one number ------------------------------------------------------------------
# LLVM keeps them in one AVX-512 register, or in several smaller ones. `memory` is the address of an
# array of such numbers.

WIDTH = 8
DOUBLE, INT32 = ir.DoubleType(), ir.IntType(32)
VECTOR = ir.VectorType(DOUBLE, WIDTH)


class Lanes(types.Type):
    def __init__(self):
        super().__init__(name="lanes")


lanes = Lanes()


@register_model(Lanes)
class LanesModel(models.PrimitiveModel):
    def __init__(self, manager, numba_type):
        super().__init__(manager, numba_type, VECTOR)


def _shuffle(builder, first, second, indices):
    mask = ir.Constant(ir.VectorType(INT32, WIDTH), indices)
    return builder.shuffle_vector(first, second, mask)


def _spread(builder, value):
    undefined = ir.Constant(VECTOR, ir.Undefined)
    first = builder.insert_element(undefined, value, INT32(0))
    return _shuffle(builder, first, undefined, [0] * WIDTH)


def _define_arithmetic(python_operator, instruction):
    @infer_global(python_operator)
    class Arithmetic(ConcreteTemplate):
        cases = (signature(lanes, lanes, lanes), signature(lanes, types.float64, lanes))

    @lower_builtin(python_operator, lanes, lanes)
    def lanes_with_lanes(context, builder, sig, args):
        return getattr(builder, instruction)(*args)

    @lower_builtin(python_operator, types.float64, lanes)
    def number_with_lanes(context, builder, sig, args):
        return getattr(builder, instruction)(_spread(builder, args[0]), args[1])


_define_arithmetic(operator.add, "fadd")
_define_arithmetic(operator.sub, "fsub")
_define_arithmetic(operator.mul, "fmul")


def _call(builder, name, args):
    function_type = ir.FunctionType(VECTOR, [VECTOR] * len(args))
    return builder.call(cgutils.get_or_insert_function(builder.module, function_type, name), args)


def _pointer(builder, memory, index):
    first = builder.inttoptr(memory, VECTOR.as_pointer())
    return builder.gep(first, [index], source_etype=VECTOR)


@intrinsic
def load(typing_context, memory, index):
    def generate(context, builder, sig, args):
        return builder.load(_pointer(builder, *args), align=64, typ=VECTOR)

    return lanes(types.int64, types.int64), generate


@intrinsic
def store(typing_context, memory, index, value):
    def generate(context, builder, sig, args):
        builder.store(args[2], _pointer(builder, args[0], args[1]), align=64)
        return context.get_dummy_value()

    return types.void(types.int64, types.int64, lanes), generate


@intrinsic
def spread(typing_context, value):
    def generate(context, builder, sig, args):
        return _spread(builder, args[0])

    return lanes(types.float64), generate


@intrinsic
def fused_multiply_add(typing_context, a, b, c):
    """a·b + c with one rounding, on any machine."""

    def generate(context, builder, sig, args):
        return _call(builder, "llvm.fma.v8f64", args)

    return lanes(lanes, lanes, lanes), generate


@intrinsic
def floor(typing_context, value):
    def generate(context, builder, sig, args):
        return _call(builder, "llvm.floor.v8f64", args)

    return lanes(lanes), generate


@intrinsic
def where_positive(typing_context, condition, chosen, otherwise):
    def generate(context, builder, sig, args):
        positive = builder.fcmp_ordered(">", args[0], _spread(builder, DOUBLE(0.0)))
        return builder.select(positive, args[1], args[2])

    return lanes(lanes, lanes, lanes), generate


def _transpose(builder, rows):
    for span in (1, 2, 4):
        low = [e if not e & span else WIDTH + e - span for e in range(WIDTH)]
        high = [e + span if not e & span else WIDTH + e for e in range(WIDTH)]
        for i in range(WIDTH):
            if not i & span:
                pair = rows[i], rows[i + span]
                rows[i] = _shuffle(builder, *pair, low)
                rows[i + span] = _shuffle(builder, *pair, high)
    return rows


def _row_pointer(builder, first, stride, row):
    address = builder.add(first, builder.mul(stride, row))
    return builder.inttoptr(address, VECTOR.as_pointer())


@intrinsic
def load_states(typing_context, source, stride, last, memory, index):
    """Eight doubles of each of eight states, `stride` bytes apart, into memory[index : index + 8].
    States beyond the `last` (0 to 7) repeat it."""

    def generate(context, builder, sig, args):
        source, stride, last, memory, index = args
        rows = []
        for lane in range(WIDTH):
            lane = ir.IntType(64)(lane)
            row = builder.select(builder.icmp_signed("<", lane, last), lane, last)
            pointer = _row_pointer(builder, source, stride, row)
            rows.append(builder.load(pointer, align=8, typ=VECTOR))
        first = _pointer(builder, memory, index)
        for i, row in enumerate(_transpose(builder, rows)):
            builder.store(row, builder.gep(first, [INT32(i)], source_etype=VECTOR), align=64)
        return context.get_dummy_value()

    return types.void(*[types.int64] * 5), generate


@intrinsic
def store_states(typing_context, memory, index, target, stride):
    """memory[index : index + 8] into eight doubles of each of eight states."""

    def generate(context, builder, sig, args):
        memory, index, target, stride = args
        first = _pointer(builder, memory, index)
        rows = [
            builder.load(builder.gep(first, [INT32(i)], source_etype=VECTOR), align=64, typ=VECTOR)
            for i in range(WIDTH)
        ]
        for lane, row in enumerate(_transpose(builder, rows)):
            pointer = _row_pointer(builder, target, stride, ir.IntType(64)(lane))
            builder.store(row, pointer, align=8)
        return context.get_dummy_value()

    return types.void(*[types.int64] * 4), generate


compiled = njit(fastmath={"contract"}, error_model="numpy")  # contract: a·b + c in one instruction

# -- trigonometry ---------------------------------------------------------------------------------

LARGEST_ANGLE = 2.0**50  # radians; beyond it the nearest multiple of π/2 is not exact
HALF_PI = (1.5707963267948966, 6.123233995736766e-17)  # π/2 as a sum of two doubles


@compiled
def cosine_and_sine(x):
    """Within 2^-52 of the values, by reduction to |r| ≤ π/4 and Taylor's polynomials there."""
    n = floor(0.6366197723675814 * x + spread(0.5))
    r = fused_multiply_add(n, spread(-HALF_PI[0]), x)
    r = fused_multiply_add(n, spread(-HALF_PI[1]), r)
    square = r * r
    c = spread(1 / 20922789888000)  # 16!
    c = c * square - spread(1 / 87178291200)
    c = c * square + spread(1 / 479001600)
    c = c * square - spread(1 / 3628800)
    c = c * square + spread(1 / 40320)
    c = c * square - spread(1 / 720)
    c = c * square + spread(1 / 24)
    c = c * square - spread(1 / 2)
    c = c * square + spread(1.0)
    s = spread(1 / 355687428096000)  # 17!
    s = s * square - spread(1 / 1307674368000)
    s = s * square + spread(1 / 6227020800)
    s = s * square - spread(1 / 39916800)
    s = s * square + spread(1 / 362880)
    s = s * square - spread(1 / 5040)
    s = s * square + spread(1 / 120)
    s = s * square - spread(1 / 6)
    s = s * (square * r) + r
    half = floor(0.5 * n)
    odd = n - 2.0 * half
    sign = spread(1.0) - 2.0 * (half - 2.0 * floor(0.5 * half))
    return sign * where_positive(odd, spread(0.0) - s, c), sign * where_positive(odd, c, s)


# -- the recursion --------------------------------------------------------------------------------
# A twist series is stored as V[6 k + (0, 1, 2, 3, 4, 5)] = k-th coefficient of ωx, ωy, vx, vy, ωz,
# vz; the series of e^{iα} as E[2 k + (0, 1)] = k-th coefficient of cos α, sin α.


@compiled
def exponential_term(E, rate, k, reciprocal):
    """One more coefficient of E = e^{iα}, from E' = i α' E."""
    c, s = spread(0.0), spread(0.0)
    for j in range(k):
        w = load(rate, k - 1 - j)
        c = c - w * load(E, 2 * j + 1)
        s = s + w * load(E, 2 * j)
    store(E, 2 * k, reciprocal * c)
    store(E, 2 * k + 1, reciprocal * s)


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
def rotate_and_step(V, W, E, rate, terms, link):
    """W = step(z α̇ + e^{iα} V): two coefficients at a time, since they share their factors."""
    for k in range(0, terms - 1, 2):
        x0, y0, vx0, vy0 = spread(0.0), spread(0.0), spread(0.0), spread(0.0)
        c1, s1 = load(E, 2 * k + 2), load(E, 2 * k + 3)
        x1, y1, vx1, vy1 = spread(0.0), spread(0.0), spread(0.0), spread(0.0)
        for j in range(k + 1):
            c0, s0 = load(E, 2 * (k - j)), load(E, 2 * (k - j) + 1)
            x, y, vx, vy = load(V, 6 * j), load(V, 6 * j + 1), load(V, 6 * j + 2), load(V, 6 * j + 3)
            x0 = x0 + c0 * x - s0 * y
            y0 = y0 + s0 * x + c0 * y
            vx0 = vx0 + c0 * vx - s0 * vy
            vy0 = vy0 + s0 * vx + c0 * vy
            x1 = x1 + c1 * x - s1 * y
            y1 = y1 + s1 * x + c1 * y
            vx1 = vx1 + c1 * vx - s1 * vy
            vy1 = vy1 + s1 * vx + c1 * vy
            c1, s1 = c0, s0
        j = k + 1
        x, y, vx, vy = load(V, 6 * j), load(V, 6 * j + 1), load(V, 6 * j + 2), load(V, 6 * j + 3)
        x1 = x1 + c1 * x - s1 * y
        y1 = y1 + s1 * x + c1 * y
        vx1 = vx1 + c1 * vx - s1 * vy
        vy1 = vy1 + s1 * vx + c1 * vy
        z0, z1 = load(V, 6 * k + 4) + load(rate, k), load(V, 6 * k + 10) + load(rate, k + 1)
        step(W, k, x0, y0, vx0, vy0, z0, load(V, 6 * k + 5), link)
        step(W, k + 1, x1, y1, vx1, vy1, z1, load(V, 6 * k + 11), link)
    if terms % 2 == 1:
        k = terms - 1
        x0, y0, vx0, vy0 = spread(0.0), spread(0.0), spread(0.0), spread(0.0)
        for j in range(k + 1):
            c0, s0 = load(E, 2 * (k - j)), load(E, 2 * (k - j) + 1)
            x, y, vx, vy = load(V, 6 * j), load(V, 6 * j + 1), load(V, 6 * j + 2), load(V, 6 * j + 3)
            x0 = x0 + c0 * x - s0 * y
            y0 = y0 + s0 * x + c0 * y
            vx0 = vx0 + c0 * vx - s0 * vy
            vy0 = vy0 + s0 * vx + c0 * vy
        z0 = load(V, 6 * k + 4) + load(rate, k)
        step(W, k, x0, y0, vx0, vy0, z0, load(V, 6 * k + 5), link)


@compiled
def slide(V, D, q, rate, pitch, reciprocals, terms):
    """v ← v + z ḋ + d z × ω in place, for the slide d = pitch · q."""
    store(D, 0, pitch * load(q, 0))
    for k in range(1, terms):
        store(D, k, (pitch * reciprocals[k]) * load(rate, k - 1))
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
def turn(V, W, cosine, sine, terms):
    """W = V turned about z by a constant angle."""
    for k in range(terms):
        for part in (0, 2):
            x, y = load(V, 6 * k + part), load(V, 6 * k + part + 1)
            store(W, 6 * k + part, cosine * x - sine * y)
            store(W, 6 * k + part + 1, sine * x + cosine * y)
            store(W, 6 * k + 4 + part // 2, load(V, 6 * k + 4 + part // 2))


# -- the kernel -----------------------------------------------------------------------------------

HEADER, ROW = 3, 10  # of `links`: see pack_links


def pack_links(links):
    """One array for the kernel: dof and the base's turn; then for each joint its angle, slide,
    pitch, twist angle (cos, sin), shift, the offset along the axis before, its turn (cos, sin)."""
    rows = np.column_stack(
        [
            links.angle,
            links.slide,
            links.pitch,
            links.twist_angle,
            links.shift,
            links.offset[:-1],
            links.turn[1:],
        ]
    )
    return np.concatenate([[links.dof], links.turn[0], rows.ravel()])


@compiled
def twist_of_block(Q, E, V, W, D, links, scales, terms):
    """From Q[i (n + 2) + k], coordinate i and its derivatives, to the scaled twist series in V."""
    dof = int(links[0])
    joints = (links.size - HEADER) // ROW
    columns = terms + 1
    reciprocals = scales[2 * terms :]
    for i in range(dof):
        for k in range(terms):
            store(Q, i * columns + k + 1, scales[k] * load(Q, i * columns + k + 1))
    for joint in range(joints - 1):
        row = HEADER + joint * ROW
        angle = int(links[row])
        if angle >= 0:
            c, s = cosine_and_sine(load(Q, angle * columns))
            store(E, 2 * terms * joint, links[row + 8] * c - links[row + 9] * s)
            store(E, 2 * terms * joint + 1, links[row + 8] * s + links[row + 9] * c)
    for k in range(1, terms):
        for joint in range(joints - 1):
            angle = int(links[HEADER + joint * ROW])
            if angle >= 0:
                rate = Q + 64 * (angle * columns + 1)
                exponential_term(E + 128 * terms * joint, rate, k, reciprocals[k])
    for joint in range(joints - 1, -1, -1):
        row = HEADER + joint * ROW
        angle, sliding, pitch = int(links[row]), int(links[row + 1]), links[row + 2]
        link = (
            spread(links[row + 3]),
            spread(links[row + 4]),
            spread(links[row + 5]),
            spread(links[row + 6]),
            spread(links[row + 7]),
        )
        rate = Q + 64 * (angle * columns + 1)
        slide_rate = Q + 64 * (sliding * columns + 1)
        zero = spread(0.0)
        if joint == joints - 1:
            for k in range(terms):
                z = load(rate, k) if angle >= 0 else zero
                vz = pitch * load(slide_rate, k) if sliding >= 0 else zero
                step(W, k, zero, zero, zero, zero, z, vz, link)
        elif sliding < 0:
            rotate_and_step(V, W, E + 128 * terms * joint, rate, terms, link)
        else:
            if angle >= 0:
                still = (spread(1.0), zero, zero, zero, zero)
                rotate_and_step(V, W, E + 128 * terms * joint, rate, terms, still)
            else:
                turn(V, W, links[row + 8], links[row + 9], terms)
            slide(W, D, slide_rate - 64, slide_rate, pitch, reciprocals, terms)
            for k in range(terms):
                step(
                    W,
                    k,
                    load(W, 6 * k),
                    load(W, 6 * k + 1),
                    load(W, 6 * k + 2),
                    load(W, 6 * k + 3),
                    load(W, 6 * k + 4),
                    load(W, 6 * k + 5),
                    link,
                )
        V, W = W, V
    for k in range(terms):
        factor = scales[terms + k]
        c, s = factor * links[1], factor * links[2]
        for part in (0, 1):
            x, y = load(V, 6 * k + 2 * part), load(V, 6 * k + 2 * part + 1)
            store(W, 6 * k + 3 * part, c * x - s * y)
            store(W, 6 * k + 3 * part + 1, s * x + c * y)
            store(W, 6 * k + 3 * part + 2, factor * load(V, 6 * k + 4 + part))
    return W


def _twists_of_states(q, links, scales, out):
    """q (states · dof, n + 2) → out (states · (n + 1), 6), with coefficient k of a rate multiplied
    by scales[k] on the way in and coefficient k of the twist by scales[n + 1 + k] on the way out;
    scales[2 (n + 1) + k] = 1/k."""
    dof = int(links[0])
    joints = (links.size - HEADER) // ROW
    terms = q.shape[1] - 1
    states = q.shape[0] // dof
    inputs, outputs = dof * (terms + 1), 6 * terms
    longest = max(inputs, outputs, WIDTH)
    numbers = inputs + 2 * terms * joints + 13 * terms + longest
    workspace = np.empty(WIDTH * (numbers + WIDTH + 1))
    Q = (workspace.ctypes.data + 63) // 64 * 64
    E = Q + 64 * max(inputs, WIDTH)
    V = E + 128 * terms * joints
    W = V + 384 * terms
    D = W + 384 * terms
    spare_address = D + 64 * terms
    spare = workspace[(spare_address - workspace.ctypes.data) // 8 :]
    for first in range(0, states, WIDTH):
        here = min(WIDTH, states - first)
        source, stride = q.ctypes.data + 8 * inputs * first, 8 * inputs
        if inputs < WIDTH:
            for lane in range(here):
                for i in range(inputs):
                    spare[WIDTH * lane + i] = q[(first + lane) * dof + i // (terms + 1), i % (terms + 1)]
            source, stride = spare_address, 64
        for i in range(0, inputs - WIDTH + 1, WIDTH):
            load_states(source + 8 * i, stride, here - 1, Q, i)
        if inputs % WIDTH:
            i = max(0, inputs - WIDTH)
            load_states(source + 8 * i, stride, here - 1, Q, i)
        result = twist_of_block(Q, E, V, W, D, links, scales, terms)
        whole = here == WIDTH and outputs >= WIDTH
        row = outputs if whole else longest
        target = out.ctypes.data + 8 * outputs * first if whole else spare_address
        for i in range(0, outputs - WIDTH + 1, WIDTH):
            store_states(result, i, target + 8 * i, 8 * row)
        if outputs % WIDTH:
            i = max(0, outputs - WIDTH)
            store_states(result, i, target + 8 * i, 8 * row)
        if not whole:
            for lane in range(here):
                for i in range(outputs):
                    out[(first + lane) * terms + i // 6, i % 6] = spare[row * lane + i]


def _compile():
    argument_types = "void(float64[:,::1], float64[::1], float64[::1], float64[:,::1])"
    options = {"fastmath": {"contract"}, "error_model": "numpy"}
    try:
        return njit(argument_types, cache=True, **options)(_twists_of_states)
    except RuntimeError:  # no directory to keep the cache in
        return njit(argument_types, **options)(_twists_of_states)


twist_kernel = _compile()
