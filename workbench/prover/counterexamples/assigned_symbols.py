"""Assumed equations that assign values: ẋ = v cos φ gives ẋ at any point, with the real sine of φ."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from workbench.core.terms import Derivative, Relation, Symbol, Term
from workbench.core.types import SCALAR, VECTOR, Declaration
from workbench.engines.inventory import Lookup
from workbench.engines.inventory.inventory import Inventory, take_inventory
from workbench.engines.inventory.parameters import Parameter
from workbench.language.definitions import expand


class Assigned(NamedTuple):
    """A scalar or vector, or the rate of that order of one, and the term that is its value."""

    symbol: Symbol
    order: int
    value: Term

    @property
    def parameters(self) -> list[Parameter]:
        count = 1 if self.symbol.type == SCALAR else 3
        return [Parameter(self.symbol, "value", self.order, each) for each in range(count)]


def assigned_by(
    equations: Sequence[Relation], inventory: Inventory, definitions: Lookup
) -> list[Assigned] | None:
    """Returns what each equation assigns, after all that its value depends on; None if one assigns nothing,
    or assigns an angle of a sine.

    Raises NotExact, IllFormed.
    """
    angles = [*inventory.angles, *inventory.circles.values()]
    taken = {each for angle in angles for each in _quantities(angle, definitions)}
    waiting: list[Assigned] = []
    for equation in equations:
        own = next((each for each in _assigned(equation, definitions) if each[:2] not in taken), None)
        if own is None:
            return None
        taken.add((own.symbol, own.order))
        waiting.append(own)
    found: list[Assigned] = []
    while waiting:
        later = {(each.symbol, each.order) for each in waiting}
        ready = [each for each in waiting if later.isdisjoint(_quantities(each.value, definitions))]
        if not ready:
            return None
        found += ready
        waiting = [each for each in waiting if each not in ready]
    return found


def _assigned(equation: Relation, definitions: Lookup) -> Iterator[Assigned]:
    """Yields the quantities of any value that are a side of the equation, each with the other side."""
    for side, value in ((equation.left, equation.right), (equation.right, equation.left)):
        own: Term = side
        order = 0
        while isinstance(own, Derivative) and own.order.is_number:
            order += int(own.order)
            own = own.body
        if isinstance(own, Symbol) and own.type in (SCALAR, VECTOR) and definitions.lookup(own) is None:
            flags = {"constant"} if not order else set()
            plain = Declaration(own.declaration.name, own.type)
            if replace(own.declaration, flags=own.declaration.flags - flags, weight=None) == plain:
                yield Assigned(own, order, value)


def _quantities(term: Term, definitions: Lookup) -> set[tuple[Symbol, int]]:
    """Returns the symbols that the term may depend on, each with every order of its rates."""
    orders = take_inventory([expand(term, definitions)], definitions).orders
    return {(symbol, order) for symbol, highest in orders.items() for order in range(highest + 1)}
