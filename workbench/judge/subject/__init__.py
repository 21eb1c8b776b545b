"""What a statement is about, before any arithmetic: the one thing that the two engines share."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol

from workbench.language.terms import Symbol, Term


class Lookup(Protocol):
    """One step of definition: the body of a defined symbol, None for a free one."""

    def lookup(self, symbol: Symbol) -> Term | None: ...


@dataclass(frozen=True)
class With:
    """The definitions, and more of them."""

    definitions: Lookup
    more: Mapping[Symbol, Term]

    def lookup(self, symbol: Symbol) -> Term | None:
        return self.more.get(symbol) or self.definitions.lookup(symbol)


class NotExact(ValueError):
    """The term is well-formed but outside the exact world; the message says which part and why."""
