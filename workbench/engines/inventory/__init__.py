"""Inventory of a statement before any arithmetic; the only code that both engines share.

What is this? `inventory` lists the free quantities of a statement with their highest derivatives and its side
conditions; other modules recognize exponentials, inverses and angles. When do I come here? To add a kind of
free quantity or a side condition. What may it import? core, language. What checks it? tests/judge.
"""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass

from workbench.core.codes.engine_codes import EngineCode
from workbench.core.reasons import Reason
from workbench.core.terms import Symbol, Term
from workbench.language.definitions import Lookup

__all__ = ["Lookup", "NotExact", "With", "Without", "reached"]


@dataclass(frozen=True)
class WithDefinitions:
    """Definitions extended by further ones, which take precedence."""

    definitions: Lookup
    more: Mapping[Symbol, Term]

    def lookup(self, symbol: Symbol) -> Term | None:
        return self.more.get(symbol) or self.definitions.lookup(symbol)


class NoDefinitions:
    """Definitions that leave every symbol free. A statement that holds for any tensor holds for Φ₄."""

    def lookup(self, symbol: Symbol) -> None:
        return None


@dataclass(frozen=True)
class WithoutDefinitions:
    """Definitions without those of some symbols, which are free."""

    definitions: Lookup
    free: Collection[Symbol]

    def lookup(self, symbol: Symbol) -> Term | None:
        return None if symbol in self.free else self.definitions.lookup(symbol)


def reached(definitions: Lookup, *terms: Term) -> Iterator[Term]:
    """Yields the subterms of the terms and of the definitions that they use, each definition once."""
    waiting, seen = list(reversed(terms)), set(terms)
    while waiting:
        for part in waiting.pop().walk():
            yield part
            body = definitions.lookup(part) if isinstance(part, Symbol) else None
            if body is not None and body not in seen:
                seen.add(body)
                waiting.append(body)


class NotExact(ValueError):
    """The term is well-typed but cannot be evaluated exactly; the message states the part and the reason.

    message: a reason, or text without a code of its own.
    """

    def __init__(self, message: str) -> None:
        super().__init__(message if isinstance(message, Reason) else EngineCode.NOT_EVALUATED(what=message))
