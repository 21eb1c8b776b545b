"""Shapes of terms that decide how they are printed."""

from __future__ import annotations

from workbench.core.operations import GRADIENTS, PARTIALS
from workbench.core.terms import (
    Apply,
    Derivative,
    Term,
)
from workbench.language.printing import author_spelling


def is_column(term: Term) -> bool:
    """True if the term is ∂f/∂x of a scalar by a vector, for which the author writes a column."""
    author = author_spelling.author()
    return (
        author is not None
        and author.has_columns
        and isinstance(term, Apply)
        and term.head in PARTIALS
        and (term.type.kind, term.arguments[0].type.kind) == ("covector", "scalar")
    )


def is_dotted(term: Term) -> bool:
    """True if the term prints with dots over its letter, so that a superscript -1 would be ambiguous."""
    while isinstance(term, Apply) and term.head == "skew":
        (term,) = term.arguments
    return isinstance(term, Derivative)


def ends_in_gradient(term: Term) -> bool:
    while isinstance(term, Apply) and is_mul(term):
        term = term.arguments[1]
    return isinstance(term, Apply) and term.head in GRADIENTS


def is_mul(term: Term) -> bool:
    return isinstance(term, Apply) and term.head == "mul"
