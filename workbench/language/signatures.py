"""Which arguments each operation takes, and the type and weight of its value."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from workbench.language.integers import Linear
from workbench.language.shapes import filling, shaped
from workbench.language.terms import Identity, IllFormed, Term, Zero
from workbench.language.types import COVECTOR, OPERATOR, SCALAR, TENSOR, VECTOR, Type, Weight

Signature = Callable[[tuple[Term, ...]], tuple[Type, Weight]]


def agree(terms: Sequence[Term], what: str) -> tuple[Term, ...]:
    """The terms brought to one kind: multiples of 0 or I take the kind of the others, a tensor beside an
    operator counts as an operator of degree 0. Raises IllFormed where kinds or weights differ."""
    units = [t for t in terms if filling(t) == "identity"]
    firm = [t for t in terms if filling(t) is None]
    kinds = {(t.type.kind, t.type.rows, t.type.columns) for t in firm}
    if any(t.type.kind == "operator" for t in firm) and {k[0] for k in kinds} <= {"operator", "tensor"}:
        shape = OPERATOR
    elif len(kinds) > 1:
        raise IllFormed(f"{what} differ in type: " + " and ".join(dict.fromkeys(str(t.type) for t in firm)))
    else:
        shape = (firm or units or terms)[0].type
    is_square = shape.kind in ("tensor", "operator") or (
        shape.kind == "block" and sum(shape.rows) == sum(shape.columns)
    )
    if units and not is_square:
        raise IllFormed(f"{what} differ in type: the unit tensor and {shape}")
    weights = dict.fromkeys(t.weight for t in terms if t.weight is not None)
    if len(weights) > 1:
        raise IllFormed(f"{what} differ in weight (power of 1/time): " + " and ".join(map(str, weights)))
    return tuple(_in_shape(t, shape) for t in terms)


def _in_shape(term: Term, shape: Type) -> Term:
    if isinstance(term, Zero | Identity):
        return replace(term, type=shape.with_dual(False))
    counts_as_operator = shape.kind == "operator" and term.type.kind == "tensor"
    if filling(term) is None or counts_as_operator:
        return term
    return shaped(term, shape)


def _dual(arguments: Sequence[Term]) -> bool:
    return any(a.type.dual for a in arguments)


def _total_weight(arguments: Sequence[Term]) -> Weight:
    total = Linear(0)
    for argument in arguments:
        if argument.weight is None:
            return None
        total = total + argument.weight
    return total


def _common_weight(arguments: Sequence[Term]) -> Weight:
    return next((a.weight for a in arguments if a.weight is not None), None)


def _add(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    kinds = [a.type for a in arguments]
    base = next((k for k in kinds if k.kind == "operator"), kinds[0])
    return base.with_dual(_dual(arguments)), _common_weight(arguments)


def _neg(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    return arguments[0].type, arguments[0].weight


_PRODUCTS = {
    ("tensor", "tensor"): TENSOR,
    ("tensor", "vector"): VECTOR,
    ("covector", "tensor"): COVECTOR,
    ("covector", "vector"): SCALAR,
    ("vector", "covector"): TENSOR,
    ("operator", "operator"): OPERATOR,
    ("tensor", "operator"): OPERATOR,
    ("operator", "tensor"): TENSOR,
    ("operator", "vector"): VECTOR,
}


def _mul(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    """Juxtaposition: a scalar scales, tensors compose and act, an operator acts on what follows it."""
    left, right = (a.type for a in arguments)
    dual = _dual(arguments)
    weight = _total_weight(arguments)
    if left.kind == "operator" and right.kind == "scalar":
        raise IllFormed("an operator with tensor coefficients acts on a vector or a tensor, got a scalar")
    if left.kind == "scalar":
        return right.with_dual(dual), weight
    if right.kind == "scalar":
        return left.with_dual(dual), weight
    if left.kind == "block" and right.kind == "block":
        if sum(left.columns) != sum(right.rows):
            raise IllFormed(f"matrix product of {left} and {right}")
        return Type("block", dual, left.rows, right.columns), weight
    if "block" in (left.kind, right.kind):
        return _block_with_plain(left, right, dual), weight
    product = _PRODUCTS.get((left.kind, right.kind))
    if product is None:
        intent = {
            ("vector", "vector"): "a scalar product, written with \\cdot",
            (
                "vector",
                "tensor",
            ): "a scalar product with the vector that the tensor gives, x \\cdot (T y)",
        }.get((left.kind, right.kind))
        raise IllFormed(f"juxtaposition of a {left} and a {right} has no meaning", intent)
    return product.with_dual(dual), weight


def _block_with_plain(left: Type, right: Type, dual: bool) -> Type:
    """Beside a block matrix a tensor is a 3×3 matrix; an operator acts on a block matrix entry by entry."""
    plain = {"tensor": ((3,), (3,)), "vector": ((3,), (1,)), "covector": ((1,), (3,))}
    if left.kind == "operator" and right.kind == "block":
        return right.with_dual(dual)
    rows_columns = [(t.rows, t.columns) if t.kind == "block" else plain.get(t.kind) for t in (left, right)]
    if None in rows_columns or sum(rows_columns[0][1]) != sum(rows_columns[1][0]):
        raise IllFormed(f"matrix product of {left} and {right}")
    return Type("block", dual, rows_columns[0][0], rows_columns[1][1])


def _compose(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    """∘: the product of operators, where a tensor counts as an operator of degree 0."""
    _expect(arguments, {"operator", "tensor"}, {"operator", "tensor"})
    return OPERATOR.with_dual(_dual(arguments)), _total_weight(arguments)


def _div(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    numerator, denominator = arguments
    if denominator.type.kind != "scalar":
        raise IllFormed(f"division by a {denominator.type}; expected a scalar")
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
            raise IllFormed(f"expected {article} {expected}, {place} a {argument.type}")


def _function(takes: Sequence[str], gives: Type, weight: Callable[[tuple[Term, ...]], Weight]) -> Signature:
    def signature(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
        _expect(arguments, *({t} for t in takes))
        return gives.with_dual(_dual(arguments)), weight(arguments)

    return signature


def _times(factor: int) -> Callable[[tuple[Term, ...]], Weight]:
    return lambda arguments: None if arguments[0].weight is None else arguments[0].weight * factor


def _weightless(arguments: tuple[Term, ...]) -> Weight:
    weight = arguments[0].weight
    if weight is not None and weight != Linear(0):
        raise IllFormed(f"the argument of a transcendental function has weight {weight}, expected 0")
    return Linear(0)


def _transpose(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    type_ = arguments[0].type
    turned = {"vector": COVECTOR, "covector": VECTOR, "tensor": TENSOR}
    if type_.kind == "block":
        return Type("block", type_.dual, type_.columns, type_.rows), arguments[0].weight
    if type_.kind not in turned:
        raise IllFormed(f"the transpose of a {type_}")
    return turned[type_.kind].with_dual(type_.dual), arguments[0].weight


def _inverse(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    type_ = arguments[0].type
    if type_.kind not in ("scalar", "tensor") and not (type_.kind == "block" and type_.rows == type_.columns):
        raise IllFormed(f"the inverse of a {type_}")
    return type_, _times(-1)(arguments)


def _norm(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    _expect(arguments, {"scalar", "vector"})
    return SCALAR.with_dual(_dual(arguments)), arguments[0].weight


def _part(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    return arguments[0].type.with_dual(False), arguments[0].weight


def _exp(arguments: tuple[Term, ...]) -> tuple[Type, Weight]:
    _expect(arguments, {"scalar", "tensor"})
    return arguments[0].type, _weightless(arguments)


SIGNATURES: dict[str, Signature] = {
    "add": _add,
    "neg": _neg,
    "mul": _mul,
    "compose": _compose,
    "div": _div,
    "dot": _function(("vector", "vector"), SCALAR, _total_weight),
    "cross": _function(("vector", "vector"), VECTOR, _total_weight),
    "outer": _function(("vector", "vector"), TENSOR, _total_weight),
    "triple": _function(("vector", "vector", "vector"), SCALAR, _total_weight),
    "skew": _function(("vector",), TENSOR, _times(1)),
    "vect": _function(("tensor",), VECTOR, _times(1)),
    "symmetric": _function(("tensor",), TENSOR, _times(1)),
    "antisymmetric": _function(("tensor",), TENSOR, _times(1)),
    "transpose": _transpose,
    "inverse": _inverse,
    "adjugate": _function(("tensor",), TENSOR, _times(2)),
    "det": _function(("tensor",), SCALAR, _times(3)),
    "trace": _function(("tensor",), SCALAR, _times(1)),
    "re": _part,
    "du": _part,
    "norm": _norm,
    "sin": _function(("scalar",), SCALAR, _weightless),
    "cos": _function(("scalar",), SCALAR, _weightless),
    "exp": _exp,
    "divergence": _function(("vector",), SCALAR, _times(1)),
    "curl": _function(("vector",), VECTOR, _times(1)),
}
