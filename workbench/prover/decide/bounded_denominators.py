"""Denominators that are nowhere 0 by the bounds of their terms: 16 − 9 cos² x lies between 7 and 16."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from fractions import Fraction
from math import inf, isinf
from typing import TypeAlias

from workbench.algebra.differential_ring import Polynomial
from workbench.core.terms import Apply, Integer, Number, Power, Symbol, Term, Zero
from workbench.engines.inventory import Lookup
from workbench.engines.polynomial.polynomial_engine import ExactEngine
from workbench.prover.decide.denominators import divisors_in, factors_in

#: The least and the greatest value of a real term.
Bounds: TypeAlias = "tuple[Fraction | float, Fraction | float]"
_ANY: Bounds = (-inf, inf)
_NOT_NEGATIVE: Bounds = (Fraction(0), inf)
_DEEPEST = 40


def not_bounded_away(
    engine: ExactEngine, sides: Iterable[Term], definitions: Lookup, gaps: Collection[Polynomial]
) -> list[Polynomial]:
    """Returns the polynomials that are no factor of a denominator whose bounds exclude 0."""
    if not gaps:
        return []
    apart: set[str] = set()
    for divisor in divisors_in(sides, definitions):
        low, high = bounds_of(divisor, definitions)
        if low > 0 or high < 0:
            apart |= factors_in(engine, divisor)
    return [gap for gap in gaps if str(gap) not in apart]


def bounds_of(term: Term, definitions: Lookup, depth: int = 0) -> Bounds:
    """Returns bounds of the values of a real scalar; (-∞, ∞) where nothing is known."""
    if term.type.kind != "scalar" or term.type.dual or depth > _DEEPEST:
        return _ANY
    match term:
        case Number(value=value):
            return value, value
        case Zero():
            return Fraction(0), Fraction(0)
        case Integer(value=value) if value.is_number:
            return Fraction(int(value)), Fraction(int(value))
        case Symbol():
            body = definitions.lookup(term)
            if body is not None:
                return bounds_of(body, definitions, depth + 1)
            return _NOT_NEGATIVE if term.declaration.positive else _ANY
        case Power(base=base, exponent=exponent) if exponent.is_number and int(exponent) > 0:
            if base.type.kind != "scalar":
                return _NOT_NEGATIVE if base.type.kind == "vector" and int(exponent) == 2 else _ANY
            return _power(bounds_of(base, definitions, depth + 1), int(exponent))
        case Apply(head="dot", arguments=(one, other)) if one == other:
            return _NOT_NEGATIVE
        case Apply(head="norm" | "exp"):
            return _NOT_NEGATIVE
        case Apply(head="sin" | "cos"):
            return Fraction(-1), Fraction(1)
        case Apply(head="mul", arguments=(one, other)) if one == other:
            return _power(bounds_of(one, definitions, depth + 1), 2)
        case Apply(head="neg" | "add" | "mul", arguments=arguments):
            return _joined(term.head, [bounds_of(each, definitions, depth + 1) for each in arguments])
    return _ANY


def _joined(head: str, parts: list[Bounds]) -> Bounds:
    if head == "neg":
        ((low, high),) = parts
        return -high, -low
    if head == "add":
        return sum(low for low, _ in parts), sum(high for _, high in parts)
    found = parts[0]
    for other in parts[1:]:
        products = [_times(x, y) for x in found for y in other]
        found = min(products), max(products)
    return found


def _power(bounds: Bounds, exponent: int) -> Bounds:
    ends = [_raised(each, exponent) for each in bounds]
    if exponent % 2:
        return ends[0], ends[1]
    return (Fraction(0) if bounds[0] <= 0 <= bounds[1] else min(ends)), max(ends)


def _raised(value: Fraction | float, exponent: int) -> Fraction | float:
    return value if isinf(value) and exponent % 2 else inf if isinf(value) else value**exponent


def _times(one: Fraction | float, other: Fraction | float) -> Fraction | float:
    """Returns the product of two ends; 0 times infinity is 0, as 0 is attained and infinity is not."""
    return Fraction(0) if one == 0 or other == 0 else one * other
