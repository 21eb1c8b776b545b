"""Normal form of products: brackets to the right, scalars in front, no factor I, (A B)ᵀ = Bᵀ Aᵀ, det A B =
det A det B. It makes equal sums to a symbolic n textually equal."""

from __future__ import annotations

from collections import Counter
from functools import lru_cache
from itertools import dropwhile, pairwise

from workbench.core.construct import apply, derivative, relation, with_children
from workbench.core.terms import Apply, Derivative, Identity, Relation, Term, Zero
from workbench.engines.inventory.addend_expansion import addends


def tidy(equation: Relation) -> Relation:
    return relation(equation.operator, _tidy(equation.left), _tidy(equation.right))


def is_same_sum(equation: Relation) -> bool:
    """True if both sides have the same addends in any order; opposite addends cancel."""
    left: Counter[Term] = Counter()
    for is_subtracted, addend in (*addends(equation.left), *addends(equation.right, negative=True)):
        if not isinstance(addend, Zero):
            left[addend] += -1 if is_subtracted else 1
    return not any(left.values())


@lru_cache(maxsize=50_000)
def _tidy(term: Term) -> Term:
    term = with_children(term, _tidy)
    match term:
        case Apply(head="mul", arguments=(left, right)):
            return _product(left, right)
        case Apply(head="neg", arguments=(Apply(head="neg", arguments=(inner,)),)):
            return inner
        case Apply(head="transpose", arguments=(Identity() as same,)):
            return same
        case Apply(head="transpose", arguments=(Apply(head="transpose", arguments=(inner,)),)):
            return inner
        case Apply(head="transpose", arguments=(Apply(head="mul", arguments=(left, right)),)):
            if left.type.kind == right.type.kind == "tensor":
                return _product(*(_tidy(apply("transpose", factor)) for factor in (right, left)))
        case Apply(head="det", arguments=(Apply(head="mul", arguments=(left, right)),)):
            if left.type.kind == right.type.kind == "tensor":
                return _product(*(_tidy(apply("det", factor)) for factor in (left, right)))
        case Derivative(body=body, order=order) if order.is_number and order.constant == 0:
            return body
        case Derivative(body=Apply(head="add" | "neg" as head, arguments=arguments), order=order):
            return _tidy(apply(head, *(derivative(argument, order) for argument in arguments)))
    return term


def _product(left: Term, right: Term) -> Term:
    kinds = left.type.kind, right.type.kind
    match left, right:
        case Identity(), _ if kinds in (("tensor", "tensor"), ("tensor", "vector")):
            return right
        case _, Identity() if kinds == ("tensor", "tensor"):
            return left
        case Apply(head="neg", arguments=(inner,)), _:
            return apply("neg", _product(inner, right))
        case _, Apply(head="neg", arguments=(inner,)):
            return apply("neg", _product(left, inner))
        case Apply(head="mul", arguments=(one, other)), _ if _associates(one, other, right):
            return _product(one, _product(other, right))
        case _, Apply(head="mul", arguments=(scalar, rest)) if kinds[0] in ("tensor", "matrix"):
            if scalar.type.kind == "scalar":
                return _product(scalar, _product(left, rest))
    return apply("mul", left, right)


def _associates(*factors: Term) -> bool:
    """True for tensors, or matrices that match, perhaps with scalars before and a vector after them."""
    types = [factor.type for factor in factors]
    rest = list(dropwhile(lambda type_: type_.kind == "scalar", types))
    if not rest or any(type_.kind not in ("tensor", "matrix") for type_ in rest[:-1]):
        return False
    in_reach = rest[-1].kind in ("tensor", "matrix", "vector")
    return in_reach and all(one.columns == other.rows for one, other in pairwise(rest))
