"""Derivatives of symbolic order, such as R⁽ⁿ⁾ with an unbound n, as free functions.

A statement that holds with any function in place of x⁽ⁿ⁾ holds for the n-th derivative, for any n; x⁽ⁿ⁺ᶜ⁾ is
the c-th derivative of that function. First dⁿ/dtⁿ moves to the factors that are not constant: it is linear,
so that (ρ_Q + R r)⁽ⁿ⁾ = ρ_Q⁽ⁿ⁾ + R⁽ⁿ⁾ r for a constant r.
"""

from __future__ import annotations

from collections.abc import Iterable

from workbench.core.construct import apply, block, derivative, symbol, with_children, zero
from workbench.core.construct import relation as equated
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.operations import COMPONENTWISE, PRODUCTS
from workbench.core.terms import Apply, Block, Derivative, Relation, Symbol, Term, TimeOperator, Zero
from workbench.core.types import Declaration
from workbench.engines.inventory import NotExact
from workbench.language.printing.printer import to_latex


def symbolic_orders(terms: Iterable[Term]) -> list[Linear]:
    """Returns the symbolic orders of derivatives in the terms. Raises NotExact for orders other than n + c,
    and sums such as k + m + c with c ≥ 0."""
    orders = []
    for term in terms:
        for part in term.walk():
            if isinstance(part, Derivative) and not part.order.is_number:
                coefficients = [coefficient for _, coefficient in part.order.coefficients]
                if {*coefficients} != {1} or (len(coefficients) > 1 and part.order.constant < 0):
                    raise NotExact(f"a derivative of order {part.order}")
                orders.append(part.order)
    return orders


def with_free_derivatives(term: Term) -> Term:
    """Returns the term with x⁽ⁿ⁺ᶜ⁾ as the c-th derivative of a free function, c ≥ 0.

    Definitions must have been expanded. Raises NotExact for the n-th derivative of a constant, which is 0 for
    n ≥ 1 only.
    """
    if isinstance(term, Derivative) and not term.order.is_number:
        if isinstance(inner := term.body, Derivative):
            return with_free_derivatives(derivative(inner.body, inner.order + term.order))
        return _differentiated(with_free_derivatives(term.body), term.order)
    return with_children(term, with_free_derivatives)


def with_free_orders(relation: Relation) -> Relation:
    """Returns the relation with free derivatives on both sides.

    If linearity alone makes the sides equal, it is returned as a difference that is 0.
    """
    left, right = with_free_derivatives(relation.left), with_free_derivatives(relation.right)
    if left != right or relation.left == relation.right:
        return equated(relation.operator, left, right)
    return equated(relation.operator, apply("add", left, apply("neg", right)), zero(left.type))


def _differentiated(term: Term, order: Linear) -> Term:
    if isinstance(term, Zero):
        return term
    if _constant(term):
        if order.constant >= 1:
            return zero(term.type)
        raise NotExact(f"the derivative of order {order} of a constant")
    match term:
        case Derivative():
            return _differentiated(term.body, order + term.order)
        case Block():
            return block([[_differentiated(entry, order) for entry in row] for row in term.entries])
        case Apply() if term.head == "add" or (term.head in COMPONENTWISE and len(term.arguments) == 1):
            return apply(term.head, *(_differentiated(a, order) for a in term.arguments))
        case Apply(arguments=(left, right)) if term.head in PRODUCTS and _constant(left):
            return apply(term.head, left, _differentiated(right, order))
        case Apply(arguments=(left, right)) if term.head in PRODUCTS and _constant(right):
            return apply(term.head, _differentiated(left, order), right)
    lowest = order - order.constant
    free = _free(term, lowest)
    return derivative(free, order.constant) if order.constant else free


def _free(term: Term, order: Linear) -> Symbol:
    """Returns the free function for a derivative of symbolic order; different functions give different
    symbols."""
    if term.type.kind == "operator":
        raise NotExact(f"a {term.type} differentiated {order} times")
    weight = None if term.weight is None else term.weight + order
    uniform = all(part.declaration.uniform for part in term.symbols())
    name = Name(rf"\left({to_latex(term)}\right)", sup=(f"({order})",), of=(term, order))
    return symbol(Declaration(name, term.type, weight).with_flags(uniform=uniform))


def _constant(term: Term) -> bool:
    """True if nothing in the term depends on time, according to its declarations."""
    return not any(
        isinstance(part, TimeOperator) or (isinstance(part, Symbol) and not part.declaration.constant)
        for part in term.walk()
    )
