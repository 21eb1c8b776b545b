"""Terms at one instant: derivatives are moved to the free symbols, and operators are applied.

Each derivative of a free symbol has an independent value at the instant.
"""

from __future__ import annotations

from collections.abc import Sequence

from workbench.certificates.emission.emitted_nodes import NotCertified
from workbench.core.construct import apply, derivative, with_children, zero
from workbench.core.operations import COMPONENTWISE, PRODUCTS
from workbench.core.terms import Apply, Derivative, Head, Identity, Number, Symbol, Term, TimeOperator, Zero
from workbench.language.definitions import Definitions


def spread(term: Term, definitions: Definitions) -> Term:
    """Returns the term with derivatives of free symbols only, and without operators."""
    match term:
        case Derivative(body=body, order=order) if order.is_number:
            made = spread(body, definitions)
            for _ in range(int(order)):
                made = _rate(made, definitions)
            return made
        case Apply(head="mul", arguments=(operator, value)) if operator.type.kind == "operator":
            return _acted(operator, spread(value, definitions), definitions)
        case Symbol():
            meaning = definitions.lookup(term)
            return term if meaning is None else spread(meaning, definitions)
    return with_children(term, lambda child: spread(child, definitions))


def _rate(term: Term, definitions: Definitions) -> Term:
    match term:
        case Zero() | Number() | Identity():
            return zero(term.type)
        case Symbol(declaration=own):
            return zero(term.type) if own.constant else derivative(term, 1)
        case Derivative(body=body, order=order):
            return derivative(body, order + 1)
        case Apply(head=head, arguments=parts) if head == "add" or (
            head in COMPONENTWISE and len(parts) == 1
        ):
            return _linear(head, [_rate(part, definitions) for part in parts])
        case Apply(head=head, arguments=(left, right)) if head in PRODUCTS:
            rates = (
                _product(head, _rate(left, definitions), right),
                _product(head, left, _rate(right, definitions)),
            )
            return _linear("add", rates)
    raise NotCertified("the rate of more than products and sums at an instant")


def _product(head: Head, left: Term, right: Term) -> Term:
    made = apply(head, left, right)
    return zero(made.type) if isinstance(left, Zero) or isinstance(right, Zero) else made


def _linear(head: Head, parts: Sequence[Term]) -> Term:
    some = [part for part in parts if not isinstance(part, Zero)]
    if not some:
        return parts[0] if head == "add" else zero(apply(head, *parts).type)
    return some[0] if head == "add" and len(some) == 1 else apply(head, *some)


def _acted(operator: Term, value: Term, definitions: Definitions) -> Term:
    if operator.type.kind != "operator":
        return _product("mul", spread(operator, definitions), value)
    match operator:
        case TimeOperator():
            return _rate(value, definitions)
        case Identity():
            return value
        case Symbol() if (body := definitions.lookup(operator)) is not None:
            return _acted(body, value, definitions)
        case Apply(head="add", arguments=parts):
            return _linear("add", [_acted(part, value, definitions) for part in parts])
        case Apply(head="mul" | "compose", arguments=(outer, inner)):
            return _acted(outer, _acted(inner, value, definitions), definitions)
    raise NotCertified("an operator at an instant")
