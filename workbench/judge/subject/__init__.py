"""What a statement is about, before any arithmetic: the one thing that the two engines share."""

from typing import Protocol

from workbench.language.terms import Symbol, Term


class Lookup(Protocol):
    """One step of definition: the body of a defined symbol, None for a free one."""

    def lookup(self, symbol: Symbol) -> Term | None: ...


class NotExact(ValueError):
    """The term is well-formed but outside the exact world; the message says which part and why."""
