"""Signatures of the operations: the arguments each takes, and the type and weight of its value."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from workbench.core.codes.type_codes import Compared, TypeCode
from workbench.core.integer_expressions import Linear
from workbench.core.shapes import filling, has_open_zeros, is_sized, shaped, sizes, stretched
from workbench.core.terms import Apply, Block, Identity, IllFormed, Number, Symbol, Term, Unsupported, Zero
from workbench.core.types import OPERATOR, QUATERNION, SCALAR, TENSOR, VECTOR, Type, Weight

Signature = Callable[[tuple[Term, ...]], tuple[Type, Weight]]


def _abbreviated(terms: Sequence[Term]) -> str | None:
    """Returns what authors commonly abbreviate when sizes differ: the last of four rows, a second ^T; else
    None."""
    if any(map(has_open_zeros, terms)):
        return "a row or column of more zeros"
    is_written_out = any(isinstance(t, Block) and len(t.children) == 1 for t in terms)
    if {t.type.with_dual(False) for t in terms} == {VECTOR, Type(4, 1)} and not is_written_out:
        return "the column of four, with a 1 (a point) or a 0 (a direction) below the vector"
    lengths = [t.type.rows for t in terms if t.type.is_column]
    rows = [t for t in terms if not t.type.is_column]
    if lengths and rows and all(sum(p.type.rows for p in _turned_row(row)) == lengths[0] for row in rows):
        return "the column of these columns below each other"
    return None


def _turned_row(term: Term) -> tuple[Term, ...]:
    """Returns the columns side by side in a bracket with ^T; () if the term is not of this form."""
    match term:
        case Apply(head="transpose", arguments=(Block(entries=(columns,)),)):
            return columns if all(each.type.is_column for each in columns) else ()
    return ()


def agree(terms: Sequence[Term], what: Compared) -> tuple[Term, ...]:
    """Returns the terms converted to one kind: multiples of 0 or I take the kind of the others, and a tensor
    next to an operator is an operator of degree 0. Raises IllFormed if kinds or weights differ."""
    terms = stretched(terms)
    units = [t for t in terms if filling(t) == "identity"]
    firm = [t for t in terms if filling(t) is None]
    types = {t.type.with_dual(False) for t in firm}
    if OPERATOR in types and types <= {OPERATOR, TENSOR}:
        shape = OPERATOR
    elif len(types) > 1:
        types_of = " and ".join(dict.fromkeys(str(t.type) for t in firm))
        message = TypeCode.DIFFERENT_TYPES(what=what, types=types_of)
        if any(map(is_sized, firm)):
            raise IllFormed(TypeCode.DIFFERENT_SIZES(message=message, sizes=sizes(t.type for t in firm)))
        if (usual := _abbreviated(firm)) is not None:
            raise Unsupported(TypeCode.ABBREVIATED_SUMMAND(message=message, usual=usual))
        raise IllFormed(message)
    else:
        of_one_number = [t for t in terms if isinstance(t, Zero) and t.printed]
        shape = (firm or units or of_one_number or terms)[0].type
    may_be_unit = shape.kind == "operator" or (shape.is_square and shape.kind != "scalar")
    if units and not may_be_unit:
        raise IllFormed(TypeCode.UNIT_TENSOR_BESIDE_OTHERS(what=what, shape=shape))
    weights = dict.fromkeys(t.weight for t in terms if t.weight is not None and not _is_example(t))
    if len(weights) > 1:
        raise IllFormed(TypeCode.DIFFERENT_WEIGHTS(what=what, weights=" and ".join(map(str, weights))))
    return tuple(_in_shape(t, shape) for t in terms)


def _is_example(term: Term) -> bool:
    """True if the term is a matrix of numbers only, whose entries are values in some unit."""
    return isinstance(term, Block) and not any(isinstance(each, Symbol) for each in term.walk())


def _in_shape(term: Term, shape: Type) -> Term:
    if isinstance(term, Zero) and term.printed.isdecimal():
        return shaped(term, shape)
    if isinstance(term, Zero | Identity):
        return replace(term, type=shape.with_dual(False))
    counts_as_operator = shape.kind == "operator" and term.type.kind == "tensor"
    if filling(term) is None or counts_as_operator:
        return term
    return shaped(term, shape)


def _dual(arguments: Sequence[Term]) -> bool:
    return any(a.type.dual for a in arguments)


def total_weight(arguments: Sequence[Term]) -> Weight:
    total = Linear(0)
    for argument in arguments:
        if argument.weight is None:
            return None
        total = total + argument.weight
    return total


def _common_weight(arguments: Sequence[Term]) -> Weight:
    return next((a.weight for a in arguments if a.weight is not None), None)


def add(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    kinds = [a.type for a in arguments]
    base = next((k for k in kinds if k.kind == "operator"), kinds[0])
    return base.with_dual(_dual(arguments)), _common_weight(arguments)


def as_argument(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    return arguments[0].type, arguments[0].weight


_OPERATOR_PRODUCTS = {
    ("operator", "operator"): OPERATOR,
    ("tensor", "operator"): OPERATOR,
    ("operator", "tensor"): TENSOR,
    ("operator", "vector"): VECTOR,
}
_INTENTS = {
    ("vector", "vector"): "a scalar product, written with \\cdot",
    ("vector", "tensor"): "a scalar product with the vector that the tensor gives, x \\cdot (T y)",
}


def mul(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    """Returns the type and weight of a juxtaposition. A scalar scales, matrices multiply, an operator acts on
    the next factor, quaternions multiply by Hamilton's rules, a 4×4 matrix acts on the column of a
    quaternion."""
    left, right = (a.type for a in arguments)
    dual = _dual(arguments)
    weight = total_weight(arguments)
    if left.kind == "operator" and right.kind == "scalar":
        raise IllFormed(TypeCode.OPERATOR_ON_SCALAR())
    if left.kind == "scalar":
        return right.with_dual(dual), weight
    if right.kind == "scalar":
        return left.with_dual(dual), weight
    if "operator" in (left.kind, right.kind):
        product = _OPERATOR_PRODUCTS.get((left.kind, right.kind))
        if left.kind == "operator" and right.kind == "matrix":
            product = right  # entry by entry
    elif right.kind == "quaternion":
        product = QUATERNION if left.kind == "quaternion" or (left.rows, left.columns) == (4, 4) else None
    elif left.kind == "quaternion":
        product = None
    elif left.columns == right.rows:
        product = Type(left.rows, right.columns)
    else:
        entry = entries_acted_on(left, arguments[1])
        product = None if entry is None else Type(left.rows * entry.rows, entry.columns)
    if product is None:
        if any(map(is_sized, arguments)):
            raise IllFormed(TypeCode.PRODUCT_OF_SIZES(sizes=sizes([left]), sizes_2=sizes([right])))
        if "matrix" in (left.kind, right.kind):
            message = TypeCode.MATRIX_PRODUCT(left=left, right=right)
            if any(map(has_open_zeros, arguments)):
                raise Unsupported(TypeCode.OPEN_ZEROS(message=message))
            raise IllFormed(message)
        raise IllFormed(TypeCode.JUXTAPOSITION(left=left, right=right), _INTENTS.get((left.kind, right.kind)))
    return product.with_dual(dual), weight


def entries_acted_on(left: Type, right: Term) -> Type | None:
    """Returns the type of the entries of a literal column, such as a triad, that a matrix multiplies from the
    left; None if the term is not such a column with as many entries as the matrix has columns."""
    if not isinstance(right, Block) or len(right.entries[0]) > 1 or len(right.entries) != left.columns:
        return None
    types = {entry.type.with_dual(False) for (entry,) in right.entries}
    return types.pop() if len(types) == 1 else None


def compose(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    """Returns the type and weight of ∘, the product of operators; a tensor is an operator of degree 0."""
    _expect(arguments, {"operator", "tensor"}, {"operator", "tensor"})
    return OPERATOR.with_dual(_dual(arguments)), total_weight(arguments)


def div(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    numerator, denominator = arguments
    if denominator.type.kind == "quaternion":
        raise Unsupported(TypeCode.DIVISION_BY_QUATERNION())
    if denominator.type.kind != "scalar":
        raise IllFormed(TypeCode.DIVISION_BY_NO_SCALAR(type=denominator.type))
    weight = None
    if numerator.weight is not None and denominator.weight is not None:
        weight = numerator.weight - denominator.weight
    return numerator.type.with_dual(_dual(arguments)), weight


def _expect(arguments: tuple[Term, ...], *kinds: set[str]) -> None:
    for position, (argument, allowed) in enumerate(zip(arguments, kinds, strict=True), start=1):
        if argument.type.kind not in allowed:
            expected = " or ".join(sorted(allowed))
            place = f"argument {position} is" if len(kinds) > 1 else "got"
            article = "an" if expected[0] in "aeiou" else "a"
            raise IllFormed(
                TypeCode.EXPECTED_ARGUMENT(
                    article=article, expected=expected, place=place, type=argument.type
                )
            )


def function(takes: Sequence[str], gives: Type, weight: Callable[[tuple[Term, ...]], Weight]) -> Signature:
    def signature(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
        _expect(arguments, *({t} for t in takes))
        return gives.with_dual(_dual(arguments)), weight(arguments)

    return signature


def times(factor: int) -> Callable[[tuple[Term, ...]], Weight]:
    return lambda arguments: None if arguments[0].weight is None else arguments[0].weight * factor


def weightless(arguments: tuple[Term, ...]) -> Weight:
    """Returns weight 0 for an angle, or None if it contains the time: \\sin 2t omits the unit of a rate, so
    that its derivative has no weight."""
    weight = arguments[0].weight
    if weight is not None and weight != Linear(0):
        raise IllFormed(TypeCode.ARGUMENT_WITH_WEIGHT(weight=weight))
    has_time = any(part.declaration.clock for part in arguments[0].symbols())
    return None if has_time else Linear(0)


def transpose(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    type_ = arguments[0].type
    if type_.algebra or type_.kind == "scalar":
        raise IllFormed(TypeCode.TRANSPOSE(type=type_))
    return Type(type_.columns, type_.rows, type_.dual), arguments[0].weight


_MATRICES = {"tensor", "matrix"}
_KRONECKER = {*_MATRICES, "covector"}


def kronecker(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    """Returns the type and weight of A ⊗ B, the block matrix of the A_ij B, for two matrices or rows."""
    _expect(arguments, _KRONECKER, _KRONECKER)
    left, right = (a.type for a in arguments)
    if any(filling(a) is not None for a in arguments):
        raise Unsupported(TypeCode.KRONECKER_OF_UNIT())
    size = (left.rows * right.rows, left.columns * right.columns)
    return Type(*size, _dual(arguments)), total_weight(arguments)


def columns_below(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    """Returns the type and weight of vec A, the columns of a matrix below each other."""
    (matrix,) = arguments
    if matrix.type.kind not in _MATRICES:
        raise Unsupported(TypeCode.VEC(type=matrix.type))
    return Type(matrix.type.rows * matrix.type.columns, 1, matrix.type.dual), matrix.weight


def inverse(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    type_ = arguments[0].type
    if not type_.is_square and type_.kind != "quaternion":
        raise IllFormed(TypeCode.INVERSE(type=type_))
    return type_, times(-1)(arguments)


def norm(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    if not arguments[0].type.is_column:
        _expect(arguments, {"scalar", "vector", "quaternion"})
    return SCALAR.with_dual(_dual(arguments)), arguments[0].weight


def root(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    if arguments[0].type.is_square and arguments[0].type.kind != "scalar":
        raise Unsupported(TypeCode.ROOT(type=arguments[0].type))
    _expect(arguments, {"scalar"})
    weight = arguments[0].weight
    if weight is None:
        return arguments[0].type, None
    if not weight.is_number or weight.constant % 2:
        raise Unsupported(TypeCode.ROOT_OF_WEIGHT(weight=weight))
    return arguments[0].type, Linear(weight.constant // 2)


def part(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    return arguments[0].type.with_dual(False), arguments[0].weight


def exp(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    if not arguments[0].type.is_square:
        _expect(arguments, {"scalar", "tensor", "quaternion"})
    return arguments[0].type, weightless(arguments)


def log(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    """Returns the type and weight of the logarithm of a scalar, a square matrix or a quaternion."""
    type_ = arguments[0].type
    if type_.dual:
        raise Unsupported(TypeCode.LOGARITHM(type=type_))
    if not type_.is_square:
        _expect(arguments, {"scalar", "tensor", "quaternion"})
    return type_, weightless(arguments)


def power_of_scalars(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    """Returns the type and weight of x^y for two real scalars; the weight of x^y is known for a number y."""
    _expect(arguments, {"scalar"}, {"scalar"})
    if _dual(arguments):
        raise Unsupported(TypeCode.POWER(type=arguments[0].type))
    base, exponent = arguments
    if base.weight is None or base.weight == Linear(0):
        weightless((exponent,))
        return SCALAR, base.weight
    share = (
        exponent.value * base.weight.constant
        if isinstance(exponent, Number) and base.weight.is_number
        else None
    )
    if share is None or share.denominator != 1:
        raise Unsupported(TypeCode.ROOT_OF_WEIGHT(weight=base.weight))
    return SCALAR, Linear(int(share))


def dot(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    """Returns the type and weight of x · y for two vectors of any length."""
    left, right = (a.type.with_dual(False) for a in arguments)
    if left != right or not left.is_column:
        _expect(arguments, {"vector"}, {"vector"})
    return SCALAR.with_dual(_dual(arguments)), total_weight(arguments)


def of_square(gives: Type | None, degree: int | None) -> Signature:
    """Returns the signature of a function of a square matrix. Without `gives` the value has the type of the
    matrix; without `degree` the degree is the number of rows."""

    def signature(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
        type_ = arguments[0].type
        if not type_.is_square or type_.kind == "scalar":
            _expect(arguments, {"tensor"})
        weight = times(type_.rows if degree is None else degree)(arguments)
        return (gives or type_).with_dual(type_.dual), weight

    return signature


def quaternion(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    """Returns the type and weight of a quaternion with a scalar and a vector part of one weight."""
    _expect(arguments, {"scalar"}, {"vector"})
    weights = dict.fromkeys(a.weight for a in arguments if a.weight is not None)
    if len(weights) > 1:
        raise IllFormed(TypeCode.QUATERNION_OF_DIFFERENT_WEIGHTS(weights=" and ".join(map(str, weights))))
    return QUATERNION.with_dual(_dual(arguments)), next(iter(weights), None)


def arc_of_two(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    """Returns the type and weight of atan2(y, x) for two scalars of one weight."""
    _expect(arguments, {"scalar"}, {"scalar"})
    weights = dict.fromkeys(a.weight for a in arguments if a.weight is not None)
    if len(weights) > 1 or _dual(arguments):
        raise IllFormed(TypeCode.ATAN2_ARGUMENTS())
    return SCALAR, Linear(0)


def partial(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    """Returns the type and weight of ∂f/∂x. For a scalar x it has the type of f. For a column x of n it is a
    row of n, or a matrix whose row i belongs to the component i of f. For a scalar f and a matrix X it is the
    matrix of the ∂f/∂X_ij."""
    body, by = arguments
    if body.type.kind == "operator":
        raise IllFormed(TypeCode.PARTIAL_DERIVATIVE_OF_OPERATOR())
    is_by_matrix = not (by.type.algebra or by.type.is_column or by.type.kind == "scalar")
    if by.type.dual or (by.type.algebra and not by.type.is_column):
        raise Unsupported(TypeCode.PARTIAL_DERIVATIVE_BY(type=by.type))
    weight = None if body.weight is None or by.weight is None else body.weight - by.weight
    if by.type.kind == "scalar":
        return body.type, weight
    if body.type.kind != "scalar" and (is_by_matrix or not body.type.is_column):
        raise Unsupported(TypeCode.DERIVATIVE_BY_VECTOR(type=body.type, by=by.type))
    if is_by_matrix:
        return by.type.with_dual(body.type.dual), weight
    return Type(body.type.rows, by.type.rows, body.type.dual), weight
