"""Consistency check: the [motion] binding of a defined symbol must match its definition."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from workbench.core.construct import relation, symbol
from workbench.core.integer_instances import instantiate
from workbench.core.terms import Definition, IllFormed, Relation, Term
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.inventory import take_inventory
from workbench.language.definitions import Definitions
from workbench.language.printing.printer import to_latex
from workbench.prover.motions.motion_check import Subject, witness
from workbench.prover.motions.motion_source import Bindings, BoundFirst, Motion

#: The members that represent a family.
MEMBERS = (1, 2, 3)


class BindingError(ValueError):
    """A binding that contradicts the definition of its symbol."""


def require_consistent(
    definitions: Definitions, choices: Sequence[Bindings], motions: tuple[Motion, ...]
) -> None:
    """Raises BindingError for the first binding of a defined symbol that contradicts its definition."""
    for bindings in choices:
        for definition in definitions:
            for member in _members(definition):
                found = _tested(member, definitions, bindings, motions)
                if found is not None:
                    raise BindingError(found)


@dataclass(frozen=True)
class _Once:
    """The integers of a definition, at the members that are tested."""

    variables: tuple[str, ...]

    def assignments(self) -> Iterator[dict[str, int]]:
        for n in MEMBERS:
            yield dict.fromkeys(self.variables, n)


def _members(definition: Definition) -> Iterator[tuple[Relation, _Once | None]]:
    if definition.parameters:
        return
    variables = tuple(sorted({name for index in definition.index for name in index.variables}))
    left: Term = symbol(definition.declaration, definition.index)
    yield relation("=", left, definition.body), _Once(variables) if variables else None


def _tested(
    member: tuple[Relation, _Once | None],
    definitions: Definitions,
    bindings: Bindings,
    motions: tuple[Motion, ...],
) -> str | None:
    statement, orders = member
    numbered: Any = instantiate(statement.left, dict.fromkeys(orders.variables, MEMBERS[0]) if orders else {})
    found = bindings.find(numbered)
    if found is None or not _all_bound(statement.right, definitions, bindings):
        return None
    seen = witness(Subject(statement, (), orders, definitions, (bindings,), motions))
    if not seen.vetoed:
        return None
    assert seen.evidence is not None, "what vetoes has been seen"
    figures = seen.evidence.figures
    name, off = to_latex(statement.left), f"{100 * figures['residual']:.2g} %"
    place = f"at t = {figures['time']:g} s on {figures['motion']}"
    body, bound = to_latex(statement.right), found[0].text
    return f"motion: {name} is defined as {body}, and {bound} is off by {off} {place}"


def _all_bound(body: Term, definitions: Definitions, bindings: Bindings) -> bool:
    """True if the body has no free symbols: an unbound and undefined symbol could have any value."""
    variables = {v for t in body.symbols() for i in t.index for v in i.variables}
    try:
        body = instantiate(body, dict.fromkeys(variables, 1))
        inventory = take_inventory([body], BoundFirst(definitions, bindings))
    except (NotExact, IllFormed):
        return False
    return all(bindings.find(s) is not None for s in inventory.orders)
