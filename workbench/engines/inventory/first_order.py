"""Approximations a ≈ b: both sides to first order in all symbols that are declared small.

Each small s becomes ε s, with its rates; with ε² = 0 the engines for dual numbers compare the sides. The
value f(x + s) is f + s ∂f/∂x. Sides with a quotient by s are multiplied by s, and so compared to order 0.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from workbench.core.construct import apply, derivative, dual_unit, relation
from workbench.core.numeric_multiples import numeric_multiple
from workbench.core.operations import OPERATORS
from workbench.core.terms import (
    Apply,
    BigSum,
    Block,
    Derivative,
    DualUnit,
    Number,
    Power,
    Relation,
    Statement,
    Symbol,
    Term,
    sides_of,
)
from workbench.core.types import SCALAR
from workbench.engines.inventory import NotExact
from workbench.language.definitions import Lookup, expand, replaced
from workbench.language.function_places import arguments_of_function, function_of, is_elsewhere

_BEYOND = 2


class FirstOrder(NamedTuple):
    """relation: between dual quantities.   names: the small symbols.   has_plain_side: True if one side
    contains no small symbol; the author may then mean order 0.   order: how far the sides are compared."""

    relation: Relation
    names: str
    has_plain_side: bool
    order: str = "to first order"


def to_first_order(said: Relation, assume: Iterable[Statement], definitions: Lookup) -> FirstOrder:
    """Returns the relation to first order. Raises NotExact if a reader may understand it otherwise."""
    sides = [expand(side, definitions) for side in (said.left, said.right)]
    parts = [part for side in sides for part in side.walk()]
    small = {part: part.declaration for part in parts if isinstance(part, Symbol) and _is_small(part)}
    if not small:
        raise NotExact("nothing in it is declared small")
    if any(isinstance(part, DualUnit) or part.type.dual for part in parts):
        raise NotExact("≈ between dual quantities")
    if any(isinstance(part, Symbol) and _reaches_small(part) for part in parts):
        raise NotExact("≈ with a function of what is small")
    supposed = [expand(side, definitions) for condition in assume for side in sides_of(condition)]
    if any(_is_small(part) for side in supposed for part in side.walk()):
        raise NotExact("≈ under a condition on what is small")
    sides = [replaced(side, _near) for side in sides]
    divisors = {part for side in sides for part in side.walk() if _is_small(part) and _divides(part, side)}
    sides = [_times(side, part) for part in divisors for side in sides] if len(divisors) == 1 else sides
    degrees = [_degree(side) for side in sides]
    if min(degrees) >= _BEYOND:
        raise NotExact("≈ where no side is seen to be of first order")
    left, right = (replaced(side, _scaled) for side in sides)
    names = ", ".join(sorted({str(declaration.name) for declaration in small.values()}))
    if len(divisors) == 1:
        return FirstOrder(relation("=", left, right), names, False, "terms of order 0")
    return FirstOrder(relation("=", left, right), names, min(degrees) == 0)


def _near(value: Symbol) -> Term | None:
    """Returns f + s ∂f/∂x for f(x + s); None for other symbols. Raises NotExact for values at places that are
    not near."""
    if not is_elsewhere(value):
        return None
    function, places = function_of(value)
    found: Term = function
    for own, place in zip(arguments_of_function(function), places, strict=True):
        if place == own:
            continue
        if not isinstance(own, Symbol) or own.type != SCALAR or not isinstance(place, Apply):
            raise NotExact("≈ with a value at a place that is not near")
        addends = place.arguments if place.head == "add" else ()
        steps = [each for each in addends if each != own]
        if len(steps) != len(addends) - 1 or any(_degree(step) != 1 for step in steps):
            raise NotExact("≈ with a value at a place that is not near")
        slope = derivative(function, 1) if own.declaration.clock else apply("partial", function, own)
        found = apply("add", found, *(apply("mul", step, slope) for step in steps))
    return found


def _divides(small: Term, side: Term) -> bool:
    """True if a divisor of the side is the small symbol or a multiple of it, so that it vanishes."""
    divisors = (part.arguments[1] for part in side.walk() if isinstance(part, Apply) and part.head == "div")
    return any(numeric_multiple(divisor)[1] == small for divisor in divisors)


def _times(side: Term, small: Term) -> Term:
    """Returns the side times the small symbol by which it divides. Raises NotExact for other quotients."""
    match side:
        case Apply(head="add", arguments=addends):
            return apply("add", *(_times(each, small) for each in addends))
        case Apply(head="neg", arguments=(inner,)):
            return apply("neg", _times(inner, small))
        case Apply(head="div", arguments=(above, below)) if below == small and not _divides(small, above):
            return above
        case Apply(
            head="div", arguments=(above, Apply(head="mul", arguments=(Number() as factor, below)))
        ) if below == small and not _divides(small, above):
            return apply("div", above, factor)
        case Apply(head="mul", arguments=(Number() as factor, rest)) if _divides(small, rest):
            return apply("mul", factor, _times(rest, small))
    if _divides(small, side):
        raise NotExact("≈ with a quotient by what is small")
    return apply("mul", small, side)


def _is_small(term: Term) -> bool:
    return isinstance(term, Symbol) and term.declaration.small


def _reaches_small(symbol: Symbol) -> bool:
    return any(_is_small(each) or _reaches_small(each) for each in symbol.declaration.of)


def _scaled(symbol: Symbol) -> Term | None:
    return apply("mul", dual_unit(), symbol) if _is_small(symbol) else None


def _degree(term: Term) -> int:
    """Returns the degree in the small symbols; _BEYOND if it exceeds 1 or is unknown."""
    degrees = [_degree(child) for child in term.children]
    if _is_small(term):
        return 1
    if not any(degrees):
        return 0
    match term:
        case Derivative() | Block() | BigSum() | Apply(head="add" | "quaternion"):
            return max(degrees)
        case Power(exponent=exponent) if exponent.is_number:
            return min(degrees[0] * abs(int(exponent)), _BEYOND)
        case Apply(head="div") if not degrees[1]:
            return degrees[0]
        case Apply(head=head) if OPERATORS[head].linear:
            return min(sum(degrees), _BEYOND)
    return _BEYOND
