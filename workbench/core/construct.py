"""Constructors of terms. Each checks types and weights, and raises IllFormed on a mismatch."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

from workbench.core.codes.type_codes import Compared, TypeCode
from workbench.core.integer_expressions import Linear, as_linear
from workbench.core.operations import OPERATORS
from workbench.core.shapes import (
    filling,
    fitted,
    is_sized,
    layout,
    multiple,
    scalar_and_vector,
    shaped,
    with_units,
)
from workbench.core.signatures import agree
from workbench.core.terms import (
    Apply,
    BigSum,
    Block,
    Counting,
    CountingName,
    Derivative,
    DualUnit,
    Head,
    Identity,
    IllFormed,
    Integer,
    Integral,
    Number,
    Power,
    Relation,
    Sign,
    Symbol,
    Term,
    TimeOperator,
    Unsupported,
    Zero,
)
from workbench.core.types import OPERATOR, SCALAR, TENSOR, VECTOR, Declaration, Type, Weight


def number(value: int | Fraction) -> Number:
    return Number(SCALAR, Linear(0), Fraction(value))


def integer(value: Linear | int) -> Term:
    value = as_linear(value)
    return number(value.constant) if value.is_number else Integer(SCALAR, Linear(0), value)


def counting(name: CountingName, *arguments: Linear | int) -> Counting:
    return Counting(SCALAR, Linear(0), name, tuple(as_linear(a) for a in arguments))


def zero(type_: Type = SCALAR, printed: str = "") -> Zero:
    return Zero(type_, None, printed=printed)


def identity(type_: Type = TENSOR, printed: str = "") -> Identity:
    return Identity(type_, Linear(0), printed=printed)


def dual_unit() -> DualUnit:
    return DualUnit(SCALAR.with_dual(True), Linear(0))


def time_operator() -> TimeOperator:
    return TimeOperator(OPERATOR, Linear(1))


def symbol(
    declaration: Declaration, index: Sequence[Linear | int] = (), arguments: Sequence[Term] = ()
) -> Symbol:
    places = tuple(as_linear(i) for i in index)
    if len(places) != declaration.indices:
        raise IllFormed(
            TypeCode.INDEX_COUNT(name=declaration.name, indices=declaration.indices, count=len(places))
        )
    if len(arguments) != declaration.parameters:
        raise IllFormed(
            TypeCode.FUNCTION_ARGUMENT_COUNT(
                name=declaration.name, expected=declaration.parameters, count=len(arguments)
            )
        )
    weight = declaration.weight
    if weight is not None:
        weight = weight.substitute({f"@{i}": value for i, value in enumerate(places)})
    type_ = declaration.type.with_dual(declaration.type.dual or any(a.type.dual for a in arguments))
    return Symbol(type_, weight, declaration, places, tuple(arguments))


def derivative(body: Term, order: Linear | int) -> Term:
    order = as_linear(order)
    if order.is_number and order.constant < 0:
        raise IllFormed(TypeCode.NEGATIVE_ORDER(order=order))
    if body.type.kind == "operator":
        raise IllFormed(TypeCode.DOTTED_OPERATOR())
    weight = None if body.weight is None else body.weight + order
    return Derivative(body.type, weight, body, order)


def power(base: Term, exponent: Linear | int) -> Term:
    exponent = as_linear(exponent)
    type_ = base.type
    if exponent.is_number and exponent.constant < 0:
        raise IllFormed(TypeCode.NEGATIVE_EXPONENT(exponent=exponent))
    if type_.is_column:
        if exponent.is_number and exponent.constant % 2:
            raise IllFormed(TypeCode.ODD_POWER_OF_VECTOR(exponent=exponent))
        type_ = SCALAR.with_dual(type_.dual)
    elif not type_.algebra and not type_.is_square:
        raise IllFormed(TypeCode.POWER(type=type_))
    weight: Weight = None
    if base.weight is not None:
        if exponent.is_number:
            weight = base.weight * exponent.constant
        elif base.weight.is_number:
            weight = exponent * base.weight.constant
    return Power(type_, weight, base, exponent)


def big_sum(variables: Sequence[str], lower: Linear | int | None, upper: Linear | int, body: Term) -> BigSum:
    upper = as_linear(upper)
    lower = None if lower is None else as_linear(lower)
    weight = body.weight
    if weight is not None:
        if lower is None:
            others = Linear(0)
            for name in variables[:-1]:
                others = others + Linear.variable(name)
            weight = weight.substitute({variables[-1]: upper - others})
        if weight.variables & set(variables):
            raise IllFormed(
                TypeCode.ADDENDS_OF_DIFFERENT_WEIGHTS(variables=", ".join(variables), weight=weight)
            )
    return BigSum(body.type, weight, tuple(variables), lower, upper, body)


def integral(sign: str, measure: str, variable: str, body: Term, place: tuple[Term, ...] = ()) -> Integral:
    """Returns an integral or a limit. Its weight is open, since the weight of dm is."""
    if body.type.kind == "operator":
        raise Unsupported(TypeCode.INTEGRAL_OF_OPERATOR())
    return Integral(body.type, None, sign, measure, variable, body, place)


def block(entries: Sequence[Sequence[Term]]) -> Block:
    """Returns a block matrix; zeros and unit tensors take the shape of their row and column."""
    if len({len(row) for row in entries}) != 1:
        raise IllFormed(TypeCode.UNEQUAL_ROWS())
    rows, columns = layout(entries := with_units(entries))
    typed = tuple(
        tuple(fitted(entry, rows[i], columns[j]) for j, entry in enumerate(row))
        for i, row in enumerate(entries)
    )
    dual = any(entry.type.dual for row in typed for entry in row)
    return Block(Type(sum(rows), sum(columns), dual), _block_weight(typed), typed)


def _block_weight(entries: Sequence[Sequence[Term]]) -> Weight:
    """Returns the weight that all entries share, else None. A homogeneous matrix [Φ a; 0 0] has a weight."""
    weights = {entry.weight for row in entries for entry in row if multiple(entry) != "zero"}
    return weights.pop() if len(weights) == 1 else None


#: Operations on vectors; a bare 0 among their arguments is a zero vector.
_OF_VECTORS = frozenset({"cross", "outer", "triple", "skew"})


def relation(operator: Sign, left: Term, right: Term) -> Relation:
    """Returns a relation of two terms of one kind and weight; a bare 0 or I takes the other side's type."""
    left, right = agree(_as_quaternions((left, right)), Compared.SIDES)
    return Relation(operator, left, right)


def apply(head: Head, *arguments: Term) -> Term:
    """Returns the term head(arguments). OPERATORS lists the heads and what arguments each takes."""
    if head == "add":
        arguments = agree(_as_quaternions(arguments), Compared.ADDENDS)
    if head == "quaternion":
        arguments = _with_shapes(arguments, (SCALAR, VECTOR))
    if head in _OF_VECTORS:
        arguments = tuple(zero(VECTOR) if a == zero() and not is_sized(a) else a for a in arguments)
    if head == "mul" and not any(filling(a) == "zero" or a.type.kind == "scalar" for a in arguments):
        is_product = any(a.type.kind == "quaternion" for a in arguments)
        arguments = _as_quaternions(arguments) if is_product else arguments
    is_made = arguments[0].type.kind == "scalar" and not isinstance(arguments[0], Symbol)
    if is_made and head in ("transpose", "trace"):
        return arguments[0]  # (x^T A y)^T, and tr(x^T y)
    if head == "adjugate" and arguments[0].type.kind == "quaternion":
        head = "conjugate"  # the adjoint and the conjugate are both written with a star
    if head == "mul" and arguments[1].type.kind == "quaternion" and arguments[0].type.columns == 4:
        is_narrow = arguments[0].type.rows != 4
        arguments = (arguments[0], _column_of_four(arguments[1])) if is_narrow else arguments
    is_row = head == "mul" and arguments[1].type.rows == 1 < arguments[1].type.columns
    if is_row and arguments[0].type.kind == "quaternion":
        arguments = (_column_of_four(arguments[0]), arguments[1])  # q q^T
    if head == "transpose" and arguments[0].type.kind == "quaternion":
        arguments = (_column_of_four(arguments[0]),)
    if head == "mul":
        arguments = _beside_matrix(*arguments)
    type_, weight = OPERATORS[head].signature(arguments)
    return Apply(type_, weight, head, arguments)


def _column_of_four(term: Term) -> Term:
    return block([[apply("scalar part", term)], [apply("vector part", term)]])


def _as_quaternions(terms: Sequence[Term]) -> tuple[Term, ...]:
    """Returns the terms, with scalars and vectors next to a quaternion converted to quaternions."""
    if not any(term.type.kind == "quaternion" for term in terms):
        return tuple(terms)
    return tuple(map(as_quaternion, terms))


def as_quaternion(term: Term) -> Term:
    """Returns a scalar, a vector or a column of four as a quaternion; other terms unchanged."""
    if term.type.kind == "quaternion":
        return term
    if (parts := scalar_and_vector(term)) is not None:
        return apply("quaternion", *parts)
    if (term.type.rows, term.type.columns) != (4, 1):
        return term
    match term:
        case Apply(head="neg" | "add" as head, arguments=addends):
            return apply(head, *map(as_quaternion, addends))
        case Apply(head="mul", arguments=(factor, column)) if column.type == term.type:
            return apply("mul", factor, as_quaternion(column))
    if isinstance(term, Block):
        raise Unsupported(TypeCode.COLUMN_BESIDE_QUATERNION())
    first, *rest = ([number(int(i == j)) if i == j else zero() for j in range(4)] for i in range(4))
    return apply("quaternion", apply("mul", block([first]), term), apply("mul", block(rest), term))


def _with_shapes(terms: Sequence[Term], types: Sequence[Type]) -> tuple[Term, ...]:
    """Returns the terms, with each zero given the corresponding type."""
    if len(terms) != len(types):
        raise IllFormed(TypeCode.ARGUMENT_COUNT(expected=len(types), count=len(terms)))
    pairs = zip(terms, types, strict=True)
    return tuple(shaped(term, type_) if filling(term) == "zero" else term for term, type_ in pairs)


def _beside_matrix(left: Term, right: Term) -> tuple[Term, Term]:
    """Returns the two factors of a product; a unit tensor takes the size of the matrix next to it."""
    if filling(left) == "identity" and right.type.kind == "matrix" and right.type.rows != 3:
        left = shaped(left, Type(right.type.rows, right.type.rows))
    if filling(right) == "identity" and left.type.kind == "matrix" and left.type.columns != 3:
        right = shaped(right, Type(left.type.columns, left.type.columns))
    return left, right


def with_children(term: Term, change: Callable[[Term], Term]) -> Term:
    """Returns the term with its children changed; the same object if each child stays the same object."""
    children = tuple(map(change, term.children))
    unchanged = all(new is old for new, old in zip(children, term.children, strict=True))
    return term if unchanged else rebuild(term, children)


def rebuild(term: Term, children: Sequence[Term]) -> Term:
    """Returns the same node with other children; types and weights are checked again."""
    match term:
        case Apply():
            return apply(term.head, *children)
        case Symbol() if term.arguments:
            return symbol(term.declaration, term.index, children)
        case Derivative():
            return derivative(children[0], term.order)
        case Power():
            return power(children[0], term.exponent)
        case BigSum():
            return big_sum(term.variables, term.lower, term.upper, children[0])
        case Integral():
            return integral(term.sign, term.measure, term.variable, children[0], term.place)
        case Block():
            width = len(term.entries[0])
            return block([children[i : i + width] for i in range(0, len(children), width)])
    return term
