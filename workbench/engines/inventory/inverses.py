"""Inverses without a division: of exponentials, which are always invertible, and of products with them."""

from __future__ import annotations

from collections.abc import Callable

from workbench.core.construct import apply
from workbench.core.terms import Apply, Symbol, Term
from workbench.engines.inventory import Lookup
from workbench.engines.inventory.rodrigues import rotation_vector

#: Function that inverts the exponential of a square matrix, given the exponent.
OfExponential = Callable[[Term], Term]


def negated(exponent: Term) -> Term:
    return apply("exp", apply("neg", exponent))


def inverse_of_exponential(definitions: Lookup) -> OfExponential:
    """Returns a function that inverts exponentials: transposes that of a skew tensor, negates other
    exponents."""

    def inverse(exponent: Term) -> Term:
        is_turn = exponent.type.kind == "tensor" and rotation_vector(exponent, definitions) is not None
        return apply("transpose", apply("exp", exponent)) if is_turn else negated(exponent)

    return inverse


def inverted(term: Term, definitions: Lookup, of_exponential: OfExponential) -> Term | None:
    """Returns the inverse of an exponential, or of a product, transpose or multiple of one; None for other
    terms."""
    match term:
        case Symbol() if (body := definitions.lookup(term)) is not None:
            return inverted(body, definitions, of_exponential)
        case Apply(head="exp", arguments=(exponent,)) if term.type.kind != "scalar":
            return of_exponential(exponent)
        case Apply(head="transpose", arguments=(turned,)):
            inner = inverted(turned, definitions, of_exponential)
            return None if inner is None else apply("transpose", inner)
        case Apply(head="neg", arguments=(opposite,)):
            inner = inverted(opposite, definitions, of_exponential)
            return None if inner is None else apply("neg", inner)
        case Apply(head="mul", arguments=factors) if all(factor.type.is_square for factor in factors):
            return _of_product(factors, definitions, of_exponential)
    return None


def _of_product(factors: tuple[Term, ...], definitions: Lookup, of_exponential: OfExponential) -> Term | None:
    found = [inverted(factor, definitions, of_exponential) for factor in factors]
    if found == [None, None]:
        return None
    for scalar, other in zip(factors, reversed(found), strict=True):
        if scalar.type.kind == "scalar" and other is not None:
            return apply("div", other, scalar)
    left, right = (known or apply("inverse", factor) for known, factor in zip(found, factors, strict=True))
    return apply("mul", right, left)
