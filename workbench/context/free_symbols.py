"""The symbols of a statement that have no definition."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from workbench.core.names import Name
from workbench.core.statement_parts import concluded
from workbench.core.terms import (
    Apply,
    IllFormed,
    Relation,
    Statement,
    Symbol,
    Term,
    sides_of,
)
from workbench.core.types import Declaration
from workbench.language.definitions import Definitions


def terms_of(statement: Statement) -> Iterator[Term]:
    """Yields the terms of a statement, each as often as it is written."""
    for side in sides_of(statement):
        yield from parts_as_written(side)


def parts_as_written(term: Term) -> Iterator[Term]:
    """Yields the term and its parts; the x of tan x = sin x / cos x once."""
    yield term
    children = term.children
    match term:
        case Apply(head="div", arguments=(Apply(head=one, arguments=x), Apply(head=other, arguments=y))):
            if {one, other} == {"sin", "cos"} and x == y:
                children = children[:1]
    for child in children:
        yield from parts_as_written(child)


def equations_of(statement: Statement) -> Iterator[Relation]:
    """Yields the equations that a statement concludes."""
    for part in concluded(statement):
        if isinstance(part, Relation) and part.operator == "=":
            yield part


def names_in(statement: Statement) -> set[Name]:
    """Returns the names of the symbols that are written in the statement."""
    return {part.declaration.name for part in terms_of(statement) if isinstance(part, Symbol)}


def free_in(terms: Iterable[Term], definitions: Definitions) -> set[Declaration]:
    """Returns the declarations of the undefined symbols in the terms and in the definitions that they use."""
    found: set[Declaration] = set()
    seen: set[Symbol] = set()
    waiting = list(terms)
    while waiting:
        for part in waiting.pop().walk():
            if isinstance(part, Symbol) and part not in seen:
                seen.add(part)
                body = body_of(part, definitions)
                if body is None:
                    found.add(part.declaration)
                else:
                    waiting.append(body)
    return found


def body_of(symbol: Symbol, definitions: Definitions) -> Term | None:
    """Returns the term by which a definition replaces the symbol; None without one."""
    if symbol.declaration.positive and not definitions.about(symbol):
        return None
    try:
        return definitions.lookup(symbol)
    except IllFormed:
        return None
