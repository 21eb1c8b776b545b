"""Terms that are a symbol with accents or dots."""

from __future__ import annotations

from workbench.core.terms import Apply, Derivative, Symbol, Term


def is_rate(term: Term) -> bool:
    """True if the term is a symbol or a time derivative of one."""
    while isinstance(term, Derivative):
        term = term.body
    return isinstance(term, Symbol)


def is_accented_symbol(term: Term) -> bool:
    """True if the term is a symbol under dots, derivatives and tildes only."""
    while isinstance(term, Derivative) or (isinstance(term, Apply) and term.head == "skew"):
        (term,) = term.children
    return isinstance(term, Symbol)
