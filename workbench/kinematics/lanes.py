"""Eight doubles as one number: a Numba type whose operations act on eight states at once.

LLVM keeps such a number in one AVX-512 register, or in several smaller ones. In compiled code
`memory` is the byte address of an array of them, aligned to 64 bytes; indices count numbers.
"""

import operator

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.core.typing.templates import ConcreteTemplate, infer_global, signature
from numba.extending import intrinsic, lower_builtin, models, register_model

WIDTH = 8
DOUBLE, INT32, INT64 = ir.DoubleType(), ir.IntType(32), ir.IntType(64)
HALF, VECTOR = ir.VectorType(DOUBLE, WIDTH // 2), ir.VectorType(DOUBLE, WIDTH)


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
def turned_by_quarters(typing_context, shifted, c, s):
    """(c, s) turned by as many quarter turns as the last two bits of `shifted` say."""
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


def _exchange(builder, rows, span):
    """One of the three stages (span 1, 2, 4) of the transposition of eight rows of eight."""
    low = [e if not e & span else WIDTH + e - span for e in range(WIDTH)]
    high = [e + span if not e & span else WIDTH + e for e in range(WIDTH)]
    for i in range(WIDTH):
        if not i & span:
            pair = rows[i], rows[i + span]
            rows[i], rows[i + span] = (_shuffle(builder, *pair, order) for order in (low, high))


def _half_rows(builder, first, stride, last):
    """Pointers to the two halves of each of eight rows; rows beyond the `last` repeat it."""
    halves = []
    for lane in range(WIDTH):
        lane = INT64(lane)
        row = builder.select(builder.icmp_signed("<", lane, last), lane, last)
        address = builder.add(first, builder.mul(stride, row))
        half = builder.inttoptr(address, HALF.as_pointer())
        halves.append((half, builder.gep(half, [INT64(1)], source_etype=HALF)))
    return halves


@intrinsic
def load_states(typing_context, source, stride, last, factors, memory, index):
    """Eight doubles of each of eight states, `stride` bytes apart, times eight factors, into
    memory[index : index + 8]. States beyond the `last` (0 to 7) repeat it."""

    def generate(context, builder, sig, args):
        source, stride, last, factors, memory, index = args
        halves = _half_rows(builder, source, stride, last)
        factor = builder.inttoptr(factors, HALF.as_pointer())
        rows = []
        for half in (0, 1):
            pointer = builder.gep(factor, [INT64(half)], source_etype=HALF)
            four = builder.load(pointer, align=8, typ=HALF)
            twice = _shuffle(builder, four, four, [0, 1, 2, 3] * 2)
            for i in range(4):
                pair = [builder.load(halves[lane][half], align=8, typ=HALF) for lane in (i, i + 4)]
                rows.append(builder.fmul(_shuffle(builder, *pair, list(range(8))), twice))
        for span in (1, 2):
            _exchange(builder, rows, span)
        first = _pointer(builder, memory, index)
        for i, row in enumerate(rows):
            builder.store(row, builder.gep(first, [INT64(i)], source_etype=VECTOR), align=64)
        return context.get_dummy_value()

    return types.void(*[types.int64] * 6), generate


@intrinsic
def store_states(typing_context, memory, index, target, stride):
    """memory[index : index + 8] into eight doubles of each of eight states, in their order."""

    def generate(context, builder, sig, args):
        memory, index, target, stride = args
        first = _pointer(builder, memory, index)
        rows = []
        for i in range(WIDTH):
            pointer = builder.gep(first, [INT64(i)], source_etype=VECTOR)
            rows.append(builder.load(pointer, align=64, typ=VECTOR))
        for span in (1, 2):
            _exchange(builder, rows, span)
        halves = _half_rows(builder, target, stride, INT64(WIDTH - 1))
        for lane in range(WIDTH):
            four = [e % 4 + lane // 4 * 4 for e in range(4)]
            for half in (0, 1):
                part = _shuffle(builder, rows[lane % 4 + 4 * half], rows[0], four)
                builder.store(part, halves[lane][half], align=8)
        return context.get_dummy_value()

    return types.void(*[types.int64] * 4), generate


@intrinsic
def number(typing_context, memory, index):
    """One double of an array of doubles."""

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
