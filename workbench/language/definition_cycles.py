"""Checks of definitions: rejects members that two definitions cover, and circular definitions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from workbench.core.codes.declaration_codes import DeclarationCode
from workbench.core.formula_errors import SpecError
from workbench.core.integer_expressions import Linear, as_linear
from workbench.core.names import Name
from workbench.core.terms import Definition
from workbench.language.definitions import solve
from workbench.language.naming.spelling import Named
from workbench.language.naming.symbols import SymbolTable


def entered(key: str, definition: Definition, table: SymbolTable) -> SymbolTable:
    """Returns the table with the definition added. Raises SpecError for its key."""
    _refuse_circle(key, definition, table)
    _refuse_overlap(key, definition, table)
    name = definition.declaration.name
    known = table.defined.with_member(name, definition.index)
    primitive = known.primitive.union(_primitives(definition, known.members))
    names = {each.declaration.name for each in definition.body.symbols()}
    used = (table.arguments & names).union(*(known.arguments.get(each, ()) for each in (name, *names)))
    arguments = {**known.arguments, name: used}
    return replace(table, defined=replace(known, primitive=primitive, arguments=arguments))


def _refuse_overlap(key: str, definition: Definition, table: SymbolTable) -> None:
    """Raises SpecError if two definitions cover one member.

    a_{n+1} and a_{n+2} would both define a₂, K_{m,0} and K_{0,n} both K_{0,0}. A single member may be defined
    separately.
    """
    name = definition.declaration.name
    if all(place.is_number for place in definition.index):
        return
    for other in table.defined.members.get(name, ()):
        if all(place.is_number for place in other):
            continue
        tried = [_common(one, two) for one, two in zip(definition.index, other, strict=True)]
        common = [place for place in tried if place is not None]
        if len(common) == len(tried):
            both, known = (name.shown(index) for index in (tuple(map(as_linear, common)), other))
            raise SpecError(
                DeclarationCode.DEFINES_SO_DOES_EACH(both=both, known=known),
                key,
            )


def _common(one: Linear, other: Linear) -> int | None:
    """Returns the least number that both indices can equal, with letters ≥ 0; None if there is none."""
    least = max(one.constant, other.constant)
    is_open = [not place.is_number or place.constant == least for place in (one, other)]
    return least if all(is_open) else None


def _refuse_circle(key: str, definition: Definition, table: SymbolTable) -> None:
    name = definition.declaration.name
    for used, index in table.defined.primitive:
        if used == name and solve(definition.index, index) is not None:
            raise SpecError(DeclarationCode.USED_ABOVE(), key)
    own = definition.index
    members = [term.index for term in definition.body.symbols() if term.declaration.name == name]
    exact = [place for place in table.defined.members.get(name, ()) if all(i.is_number for i in place)]
    descending = [m for m in members if m not in exact or not _may_be_base(m, own)]
    if descending and not _all_lower(descending, own):
        raise SpecError(DeclarationCode.DEFINITION_USES_SYMBOL_ITSELF(), key)


def _may_be_base(member: tuple[Linear, ...], own: tuple[Linear, ...]) -> bool:
    """True if the member, defined separately, precedes Φ_own or is the first of these: Φ₁ for Φ_{n+1}."""
    return any(not place.is_number for place in own) and _is_before(member, own)


def _is_before(member: tuple[Linear, ...], own: tuple[Linear, ...]) -> bool:
    return all(_step(i, place) >= 0 for i, place in zip(member, own, strict=True))


def _all_lower(members: Sequence[tuple[Linear, ...]], own: tuple[Linear, ...]) -> bool:
    """True if the members precede Φ_own in a well-founded order: by one index, or by all together."""
    by_one = any(all(_step(m[at], place) > 0 for m in members) for at, place in enumerate(own))
    return by_one or all(
        _is_before(m, own) and any(_step(i, p) > 0 for i, p in zip(m, own, strict=True)) for m in members
    )


def _step(used: Linear, own: Linear) -> int:
    """Returns how far the used index is below that of the definition, at least; -1 if that is unknown."""
    step = own - used
    grows = all(coefficient > 0 for _, coefficient in step.coefficients)
    return step.constant if step.is_number or (grows and used.is_number) else -1


def _primitives(
    definition: Definition, defined: Mapping[Name, tuple[tuple[Linear, ...], ...]]
) -> Iterator[Named]:
    for term in definition.body.symbols():
        name = term.declaration.name
        if name != definition.declaration.name and not any(
            solve(member, term.index) is not None for member in defined.get(name, ())
        ):
            yield name, term.index
