"""Approximations a ≈ b: both sides to first order in all symbols that are declared small.

Each small s becomes ε s, with its rates; with ε² = 0 the engines for dual numbers compare the sides.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from workbench.core.construct import apply, dual_unit, relation
from workbench.core.operations import OPERATORS
from workbench.core.terms import (
    Apply,
    BigSum,
    Block,
    Derivative,
    DualUnit,
    Power,
    Relation,
    Statement,
    Symbol,
    Term,
    sides_of,
)
from workbench.engines.inventory import NotExact
from workbench.language.definitions import Lookup, expand, replaced

_BEYOND = 2


class FirstOrder(NamedTuple):
    """relation: between dual quantities.   names: the small symbols.   has_plain_side: True if one side
    contains no small symbol; the author may then mean order 0."""

    relation: Relation
    names: str
    has_plain_side: bool


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
    degrees = [_degree(side) for side in sides]
    if min(degrees) >= _BEYOND:
        raise NotExact("≈ where no side is seen to be of first order")
    left, right = (replaced(side, _scaled) for side in sides)
    names = ", ".join(sorted({str(declaration.name) for declaration in small.values()}))
    return FirstOrder(relation("=", left, right), names, min(degrees) == 0)


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
