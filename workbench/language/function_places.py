"""Values of functions at other places, which are symbols of their own: the places of each function.

Two places may coincide, at t = 0 or x = y, and then the values do: a counterexample must keep them apart.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations

from workbench.core.construct import relation, symbol
from workbench.core.operations import GRADIENTS, PARTIALS
from workbench.core.terms import Apply, Integral, Relation, Statement, Symbol, Term, sides_of
from workbench.core.types import CLOCK

#: The mark of such a symbol: its name is `of` this, the function and the place.
PLACE = "at"


def is_elsewhere(term: Term) -> bool:
    """True for the value of a function at another place than its arguments."""
    return isinstance(term, Symbol) and term.declaration.name.of[:1] == (PLACE,)


def function_of(value: Symbol) -> tuple[Symbol, tuple[Term, ...]]:
    """Returns the function of such a value, and the place."""
    _, function, *at = value.declaration.name.of
    return function, tuple(at)


def arguments_of_function(function: Symbol) -> tuple[Term, ...]:
    """Returns what the symbol is declared to be a function of."""
    declared = function.declaration
    return declared.of or ((symbol(CLOCK),) if declared.timed else ())


def symbols_behind(value: Symbol) -> list[Symbol]:
    """Returns the symbols that a symbol is a function of, with those of the place at which it is taken."""
    if not is_elsewhere(value):
        return [each for part in value.declaration.of for each in part.symbols()]
    function, places = function_of(value)
    return [function, *symbols_behind(function), *(each for place in places for each in place.symbols())]


def places_in(terms: Iterable[Term]) -> dict[Symbol, list[tuple[Term, ...]]]:
    """Returns the places at which each function is taken; its own arguments first, where it stands there."""
    found: dict[Symbol, dict[tuple[Term, ...], None]] = {}
    parts = [part for term in terms for part in term.walk() if isinstance(part, Symbol)]
    for value in filter(is_elsewhere, parts):
        function, at = function_of(value)
        found.setdefault(function, {})[at] = None
    for part in parts:
        if part in found:
            found[part] = {arguments_of_function(part): None, **found[part]}
    return {function: list(places) for function, places in found.items()}


def places_apart(statements: Iterable[Statement]) -> list[Relation]:
    """Returns x ≠ y for each two places of one function that stand in the statements."""
    sides = [side for statement in statements for side in sides_of(statement)]
    return [
        relation("≠", one, other)
        for places in places_in(sides).values()
        for some, others in combinations(places, 2)
        for one, other in [_differing(some, others)]
    ]


def _differing(some: tuple[Term, ...], others: tuple[Term, ...]) -> tuple[Term, Term]:
    return next((one, other) for one, other in zip(some, others, strict=True) if one != other)


def has_moved_place(statements: Iterable[Statement]) -> bool:
    """True if a value at another place stands below ∂, ∇, an integral or a limit, whose variable may move
    the place."""
    sides = [side for statement in statements for side in sides_of(statement)]
    below = (part for side in sides for part in side.walk() if _moves_places(part))
    return any(is_elsewhere(part) for each in below for part in each.walk())


def _moves_places(term: Term) -> bool:
    return isinstance(term, Integral) or (isinstance(term, Apply) and term.head in PARTIALS | GRADIENTS)
