"""Statements with each of their relations replaced, and their terms."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from workbench.core.terms import (
    Conjunction,
    Equivalence,
    Extremum,
    Implication,
    Naming,
    Relation,
    Statement,
    Term,
    sides_of,
)
from workbench.engines.inventory import NotExact


def all_terms(statements: Iterable[Statement]) -> Iterator[Term]:
    for statement in statements:
        yield from terms(statement)


def mapped(statement: Statement, of: Callable[[Relation], Relation]) -> Statement:
    """Returns the statement with `of` applied to each of its relations."""
    match statement:
        case Relation():
            return of(statement)
        case Equivalence() | Implication():
            return type(statement)(mapped(statement.left, of), mapped(statement.right, of))
        case Extremum() | Naming():
            raise NotExact("a minimum, a set or a map for all n at once")
    return Conjunction(tuple(mapped(part, of) for part in statement.parts))


def terms(statement: Statement) -> Iterator[Term]:
    yield from sides_of(statement)
    if isinstance(statement, Naming):
        yield from all_terms((*statement.parts, *statement.given))
