"""Inventory of a statement before any arithmetic: the only code that the two engines share."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass

from workbench.core.terms import Symbol, Term
from workbench.language.definitions import Lookup

__all__ = ["Lookup", "NotExact", "With", "Without", "reached"]


@dataclass(frozen=True)
class With:
    """A lookup with additional definitions."""

    definitions: Lookup
    more: Mapping[Symbol, Term]

    def lookup(self, symbol: Symbol) -> Term | None:
        return self.more.get(symbol) or self.definitions.lookup(symbol)


@dataclass(frozen=True)
class Without:
    """A lookup without the definitions of some symbols, which become free."""

    definitions: Lookup
    free: Collection[Symbol]

    def lookup(self, symbol: Symbol) -> Term | None:
        return None if symbol in self.free else self.definitions.lookup(symbol)


def reached(term: Term, definitions: Lookup) -> Iterator[Term]:
    """Yields the subterms of a term and of all definitions in it; each definition is visited once."""
    waiting, seen = [term], {term}
    while waiting:
        for part in waiting.pop().walk():
            yield part
            body = definitions.lookup(part) if isinstance(part, Symbol) else None
            if body is not None and body not in seen:
                seen.add(body)
                waiting.append(body)


class NotExact(ValueError):
    """A well-formed term that exact arithmetic does not cover; the message says which part and why."""
