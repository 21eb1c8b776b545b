"""Defined names of a symbol table: the members that definitions cover, and the symbols that they use."""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import dataclass, field, replace

from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.types import Type
from workbench.language.naming.spelling import Named


@dataclass(frozen=True)
class DefinedNames:
    """The names that definitions define.

    members: the indices (1, or n+1) at which each name is defined.   untyped: the names that are introduced
    as a bare 0 or I, and the types that they may have.   primitive: what definitions use although nothing
    defines it; it must stay primitive.   arguments: which of the table's arguments the definition of a name
    uses."""

    members: Mapping[Name, tuple[tuple[Linear, ...], ...]] = field(default_factory=dict)
    untyped: Mapping[Name, tuple[Type, ...]] = field(default_factory=dict)
    primitive: frozenset[Named] = frozenset()
    arguments: Mapping[Name, frozenset[Name]] = field(default_factory=dict)

    def with_member(self, name: Name, index: tuple[Linear, ...]) -> DefinedNames:
        """Returns these names with a definition of `name` at the index added."""
        return replace(self, members={**self.members, name: (*self.members.get(name, ()), index)})

    def covers(self, name: Name, index: tuple[Linear, ...]) -> bool:
        """True if a definition covers this member: its own, or one for n or n + c."""
        return any(
            all(
                place == wanted if place.is_number else not wanted.is_number or int(wanted) >= place.constant
                for place, wanted in zip(member, index, strict=True)
            )
            for member in self.members.get(name, ())
        )

    def part(self, names: Set[Name]) -> DefinedNames:
        """Returns the defined members of these names, without the data that only the reader of formulas
        needs."""
        return DefinedNames({name: own for name, own in self.members.items() if name in names})
