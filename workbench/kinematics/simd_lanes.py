"""SIMD lanes: a Numba type of a few doubles whose operations act on as many states at once.

Their number is that of one register of the processor for which Numba compiles. In compiled code `memory` is
the byte address of an array of them, aligned to SIZE bytes; indices count numbers.
"""

import operator
from collections.abc import Callable
from typing import Any

import llvmlite.binding as llvm
from llvmlite import ir
from numba import config, types
from numba.core import cgutils
from numba.core.typing.templates import ConcreteTemplate, infer_global, signature
from numba.extending import intrinsic as untyped_intrinsic
from numba.extending import lower_builtin, models, register_model

_CONFIG: Any = config  # it takes its names from the environment
intrinsic: Callable[[Callable[..., Any]], Any] = untyped_intrinsic


def _width() -> int:
    """Returns the number of doubles in one register of the processor: AVX-512, AVX, or others (SSE2,
    NEON)."""
    return 8 if "avx512f" in FEATURES else 4 if "avx" in FEATURES else 2


def _features() -> set[str]:
    """Returns the features of the processor for which Numba compiles; empty if only its name is known."""
    features, name = _CONFIG.CPU_FEATURES, _CONFIG.CPU_NAME
    if features is not None:
        return {feature[1:] for feature in features.split(",") if feature.startswith("+")}
    if name is not None:
        return set()
    return {feature for feature, there in llvm.get_host_cpu_features().items() if there}


FEATURES = _features()
WIDTH = _width()
SIZE = 8 * WIDTH  # bytes of a number, to which it is aligned
REGISTERS = 16 if "x86_64" in llvm.get_default_triple() and "avx512vl" not in FEATURES else 32
CHUNK = min(WIDTH, 4)  # states are read and written in pieces of so many doubles
PIECES = WIDTH // CHUNK
DOUBLE, INT32, INT64 = ir.DoubleType(), ir.IntType(32), ir.IntType(64)
PIECE, VECTOR = ir.VectorType(DOUBLE, CHUNK), ir.VectorType(DOUBLE, WIDTH)


class Lanes(types.Type):
    def __init__(self):
        super().__init__(name="lanes")


lanes = Lanes()


@register_model(Lanes)
class LanesModel(models.PrimitiveModel):
    def __init__(self, manager, numba_type):
        super().__init__(manager, numba_type, VECTOR)


def _shuffle(builder, first, second, indices):
    mask = ir.Constant(ir.VectorType(INT32, len(indices)), indices)
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
        return builder.load(_pointer(builder, *args), align=SIZE, typ=VECTOR)

    return lanes(types.int64, types.int64), generate


@intrinsic
def store(typing_context, memory, index, value):
    def generate(context, builder, sig, args):
        builder.store(args[2], _pointer(builder, args[0], args[1]), align=SIZE)
        return context.get_dummy_value()

    return types.void(types.int64, types.int64, lanes), generate


@intrinsic
def spread(typing_context, value):
    def generate(context, builder, sig, args):
        return _spread(builder, args[0])

    return lanes(types.float64), generate


@intrinsic
def fused_multiply_add(typing_context, a, b, c):
    """Returns a·b + c with one rounding, on any machine."""

    def generate(context, builder, sig, args):
        return _call(builder, f"llvm.fma.v{WIDTH}f64", args)

    return lanes(lanes, lanes, lanes), generate


@intrinsic
def turned_by_quarters(typing_context, shifted, c, s):
    """Returns (c, s) turned by as many quarter turns as the last two bits of `shifted` say."""
    pair = types.UniTuple(lanes, 2)

    def generate(context, builder, sig, args):
        shifted, c, s = args
        bits = ir.VectorType(INT64, WIDTH)

        def constant(value):
            return ir.Constant(bits, [value] * WIDTH)

        count = builder.bitcast(shifted, bits)
        odd = builder.trunc(count, ir.VectorType(ir.IntType(1), WIDTH))
        results = []
        for value, first, second in ((builder.add(count, constant(1)), c, s), (count, s, c)):
            sign = builder.shl(builder.and_(value, constant(2)), constant(62))
            chosen = builder.bitcast(builder.select(odd, second, first), bits)
            results.append(builder.bitcast(builder.xor(chosen, sign), VECTOR))
        return context.make_tuple(builder, pair, results)

    return pair(lanes, lanes, lanes), generate


def _transpose_pieces(builder, rows):
    """Transposes each square of CHUNK by CHUNK doubles in CHUNK rows, in stages of span 1, 2, …"""
    span = 1
    while span < CHUNK:
        low = [e if not e & span else WIDTH + e - span for e in range(WIDTH)]
        high = [e + span if not e & span else WIDTH + e for e in range(WIDTH)]
        for i in range(CHUNK):
            if not i & span:
                pair = rows[i], rows[i + span]
                rows[i], rows[i + span] = (_shuffle(builder, *pair, order) for order in (low, high))
        span *= 2


def _pieces(builder, first, stride):
    """Returns pointers to CHUNK doubles of each of WIDTH states, `stride` bytes apart."""
    addresses = (builder.add(first, builder.mul(stride, INT64(lane))) for lane in range(WIDTH))
    return [builder.inttoptr(address, PIECE.as_pointer()) for address in addresses]


@intrinsic
def load_states(typing_context, source, stride, factors, memory, index, step):
    """Loads CHUNK doubles of each of WIDTH states, `stride` bytes apart, to memory[index + i step], i <
    CHUNK, times factors[index + i step]."""

    def generate(context, builder, sig, args):
        source, stride, factors, memory, index, step = args
        rows = [builder.load(piece, align=8, typ=PIECE) for piece in _pieces(builder, source, stride)]
        if PIECES == 2:
            rows = [_shuffle(builder, rows[i], rows[i + CHUNK], list(range(WIDTH))) for i in range(CHUNK)]
        _transpose_pieces(builder, rows)
        factor = builder.inttoptr(factors, DOUBLE.as_pointer())
        for row in rows:
            scale = builder.load(builder.gep(factor, [index], source_etype=DOUBLE), typ=DOUBLE)
            product = builder.fmul(_spread(builder, scale), row)
            builder.store(product, _pointer(builder, memory, index), align=SIZE)
            index = builder.add(index, step)
        return context.get_dummy_value()

    return types.void(*[types.int64] * 6), generate


@intrinsic
def store_states(typing_context, memory, index, step, target, stride):
    """Stores memory[index + i step], i < CHUNK, as CHUNK doubles of each of WIDTH states, `stride` bytes
    apart."""

    def generate(context, builder, sig, args):
        memory, index, step, target, stride = args
        rows = []
        for _ in range(CHUNK):
            rows.append(builder.load(_pointer(builder, memory, index), align=SIZE, typ=VECTOR))
            index = builder.add(index, step)
        _transpose_pieces(builder, rows)
        for lane, piece in enumerate(_pieces(builder, target, stride)):
            mine = [lane // CHUNK * CHUNK + e for e in range(CHUNK)]
            row = rows[lane % CHUNK]
            builder.store(_shuffle(builder, row, row, mine), piece, align=8)
        return context.get_dummy_value()

    return types.void(*[types.int64] * 5), generate


def _ask_for(builder, address, will_write):
    """Prefetches the cache line of an address, if the address exists."""
    pointer = builder.inttoptr(address, ir.IntType(8).as_pointer())
    function_type = ir.FunctionType(ir.VoidType(), [pointer.type, INT32, INT32, INT32])
    fetch = cgutils.get_or_insert_function(builder.module, function_type, "llvm.prefetch.p0")
    builder.call(fetch, [pointer, INT32(will_write), INT32(3), INT32(1)])


@intrinsic
def load_side_by_side(typing_context, source, ahead):
    """Returns the number of the WIDTH doubles from the address `source` on, which need not be aligned.

    The memory `ahead` bytes further is prefetched.
    """

    def generate(context, builder, sig, args):
        source, ahead = args
        _ask_for(builder, builder.add(source, ahead), 0)
        return builder.load(builder.inttoptr(source, VECTOR.as_pointer()), align=8, typ=VECTOR)

    return lanes(types.int64, types.int64), generate


@intrinsic
def store_side_by_side(typing_context, target, ahead, value):
    """Stores a number from the address `target` on, which need not be aligned."""

    def generate(context, builder, sig, args):
        target, ahead, value = args
        builder.store(value, builder.inttoptr(target, VECTOR.as_pointer()), align=8)
        _ask_for(builder, builder.add(target, ahead), 1)
        return context.get_dummy_value()

    return types.void(types.int64, types.int64, lanes), generate


@intrinsic
def number(typing_context, memory, index):
    """Returns one double of an array of doubles."""

    def generate(context, builder, sig, args):
        pointer = builder.inttoptr(args[0], DOUBLE.as_pointer())
        return builder.load(builder.gep(pointer, [args[1]], source_etype=DOUBLE), typ=DOUBLE)

    return types.float64(types.int64, types.int64), generate


@intrinsic
def set_number(typing_context, memory, index, value):
    def generate(context, builder, sig, args):
        pointer = builder.inttoptr(args[0], DOUBLE.as_pointer())
        builder.store(args[2], builder.gep(pointer, [args[1]], source_etype=DOUBLE))
        return context.get_dummy_value()

    return types.void(types.int64, types.int64, types.float64), generate


@intrinsic
def store_past_caches(typing_context, target, value):
    """Stores a number at an aligned address, past the caches: no cache line is read before it is written."""

    def generate(context, builder, sig, args):
        pointer = builder.inttoptr(args[0], VECTOR.as_pointer())
        done = builder.store(args[1], pointer, align=SIZE)
        done.set_metadata("nontemporal", builder.module.add_metadata([INT32(1)]))
        return context.get_dummy_value()

    return types.void(types.int64, lanes), generate


@intrinsic
def scalar_cosines_and_sines(typing_context, x):
    """Returns cos x and sin x by the C library, one lane after the other: of any size of x."""
    pair = types.UniTuple(lanes, 2)

    def generate(context, builder, sig, args):
        results = [ir.Constant(VECTOR, ir.Undefined)] * 2
        function_type = ir.FunctionType(DOUBLE, [DOUBLE])
        functions = [cgutils.get_or_insert_function(builder.module, function_type, f) for f in ("cos", "sin")]
        for lane in range(WIDTH):
            value = builder.extract_element(args[0], INT32(lane))
            for i, function in enumerate(functions):
                result = builder.call(function, [value])
                results[i] = builder.insert_element(results[i], result, INT32(lane))
        return context.make_tuple(builder, pair, results)

    return pair(lanes), generate
