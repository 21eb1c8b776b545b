"""Sums and products of terms in their usual printed form."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from workbench.core.construct import apply, number
from workbench.core.operations import PRODUCTS
from workbench.core.terms import Apply, Number, Term, Zero


def coefficient(term: Term) -> Fraction:
    """Returns the number in front of a product."""
    while isinstance(term, Apply) and term.head in (*PRODUCTS, "neg", "div"):
        term = term.arguments[0]
    return term.value if isinstance(term, Number) else Fraction(1)


def number_and_rest(addend: Term) -> tuple[Fraction, tuple[Term, ...]]:
    """Returns the signed number of an addend, and its other factors."""
    sign = Fraction(1)
    while isinstance(addend, Apply) and addend.head == "neg":
        addend, sign = addend.arguments[0], -sign
    number_ = coefficient(addend)
    if isinstance(addend, Number) or number_ in (0, 1):
        return sign * number_, () if isinstance(addend, Number) else tuple(factors_of(addend))
    sign_after = Fraction(1)
    rest = times(1 / number_, addend)
    while isinstance(rest, Apply) and rest.head == "neg":
        rest, sign_after = rest.arguments[0], -sign_after
    return sign * number_ * sign_after, tuple(factors_of(rest))


def times(factor: Fraction | int, term: Term) -> Term:
    """Returns factor·term in printed form: the sign before the addend, the number in front of the product."""
    factor = Fraction(factor)
    if isinstance(term, Number):
        value = factor * term.value
        return number(value) if value >= 0 else apply("neg", number(-value))
    if isinstance(term, Apply) and term.head == "neg":
        return times(-factor, term.arguments[0])
    if factor < 0:
        return apply("neg", times(-factor, term))
    if factor == 1:
        return term
    if isinstance(term, Apply) and term.head in PRODUCTS and coefficient(term) != 1:
        left, right = term.arguments
        if isinstance(left, Number) and term.head == "mul":
            scaled = factor * left.value
            return right if scaled == 1 else apply("mul", number(scaled), right)
        return apply(term.head, times(factor, left), right)
    if isinstance(term, Apply) and term.head == "div" and coefficient(term) != 1:
        return apply("div", times(factor, term.arguments[0]), term.arguments[1])
    return apply("mul", number(factor), term)


def sum_of(addends: Sequence[Term]) -> Term:
    return addends[0] if len(addends) == 1 else apply("add", *addends)


def with_addend(term: Term, addend: Term) -> Term:
    """Returns term + addend as one sum."""
    present = term.arguments if isinstance(term, Apply) and term.head == "add" else (term,)
    return apply("add", *(t for t in present if not isinstance(t, Zero)), addend)


def factors_of(term: Term) -> list[Term]:
    """Returns the factors of a product written in a row."""
    if isinstance(term, Apply) and term.head == "mul":
        return [*factors_of(term.arguments[0]), term.arguments[1]]
    return [term]


def product_of(factors: Sequence[Term]) -> Term:
    result = factors[0]
    for factor in factors[1:]:
        result = apply("mul", result, factor)
    return result
