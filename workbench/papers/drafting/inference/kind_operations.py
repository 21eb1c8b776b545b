"""Operation trees: the operations of a formula on its symbols, before any kind is known."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

#: The operations that are symbols: a plain one, and a letter under a mark that may be an operation.
SYMBOL, MARKED = "symbol", "marked"
#: A letter that is the unit tensor, or a symbol.
UNIT = "unit"
NAMED = frozenset((SYMBOL, MARKED, UNIT))


@dataclass(frozen=True, eq=False, slots=True)
class Operation:
    """One operation and its parts, or a leaf.

    Attributes:
        text: The name of a symbol, a number, the size of a matrix, or the shape of a bracket after a letter.
        names: The symbols in it, sorted.
    """

    op: str
    parts: tuple[Operation, ...] = ()
    text: str = ""
    names: tuple[str, ...] = field(default=())

    def walk(self) -> Iterator[Operation]:
        """Yields the operation and everything below it."""
        yield self
        for part in self.parts:
            yield from part.walk()

    @property
    def head(self) -> Operation:
        """The first leaf."""
        return self.parts[0].head if self.parts else self

    @property
    def mark(self) -> str:
        """The mark over a marked letter that may be an operation."""
        return "\\tilde" if "\\tilde{" in self.text else "\\hat"


class Forest:
    """Factory of operations; equal operations are one object, so that results are shared."""

    def __init__(self) -> None:
        self._made: dict[tuple[str, tuple[Operation, ...], str], Operation] = {}

    def make(self, op: str, *parts: Operation, text: str = "") -> Operation:
        key = (op, parts, text)
        known = self._made.get(key)
        if known is None:
            names = {name for part in parts for name in part.names}
            names |= {text} if op in NAMED else set()
            known = self._made[key] = Operation(op, parts, text, tuple(sorted(names)))
        return known

    def symbol(self, name: str) -> Operation:
        return self.make("number" if name == "\\pi" else SYMBOL, text=name)

    def anything(self, *parts: Operation) -> Operation:
        """Returns a value of any kind that is made of these parts in an unknown way."""
        return self.make("any", *parts)
