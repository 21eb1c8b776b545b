"""The parts of a statement: of conjunctions, and of what implications conclude."""

from __future__ import annotations

from collections.abc import Iterator

from workbench.core.terms import Conjunction, Implication, Statement


def conjuncts(statement: Statement) -> Iterator[Statement]:
    """Yields the parts of nested conjunctions; a statement that is none, as it is."""
    if not isinstance(statement, Conjunction):
        yield statement
        return
    for part in statement.parts:
        yield from conjuncts(part)


def concluded(statement: Statement) -> Iterator[Statement]:
    """Yields the parts of a statement; of an implication those of its right side."""
    for part in conjuncts(statement):
        if isinstance(part, Implication):
            yield from concluded(part.right)
        else:
            yield part
