"""Whom terms are printed for: the author of a paper, who may have spellings of his own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Protocol

from workbench.core.terms import Term
from workbench.language.naming.notations import Notation
from workbench.language.printing.precedence_text import ATOM, FACTOR, INFIX, PRODUCT, SUM, Text


class Author(Protocol):
    """is_plain: all is written as it is read everywhere.   owns_unit: \\mathbf{I} is a symbol of the paper,
    and the unit tensor is not.   has_columns: ∂f/∂x is written for the column, of a scalar by a vector."""

    @property
    def is_plain(self) -> bool: ...

    @property
    def owns_unit(self) -> bool: ...

    @property
    def has_columns(self) -> bool: ...

    def spellings(self, term: Term) -> Iterator[tuple[Notation, Mapping[str, Term]]]:
        """The entries of [notation] that may mean the term, those that say most first, and what stands in
        their places."""

    def reads(self, text: str, term: Term) -> bool:
        """Whether the text is read as the term."""


_author: ContextVar[Author | None] = ContextVar("author", default=None)
author = _author.get


@contextmanager
def in_the_hand_of(one: Author) -> Iterator[None]:
    """Within, terms are printed as the author of a paper writes them."""
    token = _author.set(None if one.is_plain else one)
    try:
        yield
    finally:
        _author.reset(token)


#: How tightly a notation holds, by its form.
_FORMS = {"closed": ATOM, "marked": FACTOR, "infix": INFIX, "open": SUM}


def is_spelt_as_one(term: Term) -> bool:
    """Whether the author has a spelling for it in which something stands once that is in it more often, as x
    is in the derivative of x in a frame: no part of it can be changed by itself then."""
    own = author()
    spellings = list(own.spellings(term)) if own is not None else ()
    if not spellings:
        return False
    parts = Counter(term.walk())
    return any(parts[argument] > 1 for _, arguments in spellings for argument in arguments.values())


OverLetter = Callable[..., Text | None]


def declared(term: Term, printed: Callable[[Term], Text], over_letter: OverLetter) -> Text | None:
    """The term in the paper's own notation, if it has one that is read as this term. printed: any other
    term.   over_letter: a term whose accents stand over its letter alone."""
    own = author()
    if own is None:
        return None
    for entry, arguments in own.spellings(term):
        for text in _spelt(entry, arguments, term, printed, over_letter):
            if own.reads(text.text, term):
                return text
    return None


def _spelt(
    entry: Notation,
    arguments: Mapping[str, Term],
    term: Term,
    printed: Callable[[Term], Text],
    over_letter: OverLetter,
) -> Iterator[Text]:
    """An accent over the letter alone; then with as few brackets as may do."""
    if entry.accent is not None and (text := over_letter(term)) is not None:
        yield text
    parts = {letter: printed(argument) for letter, argument in arguments.items()}
    for level in (PRODUCT, FACTOR, ATOM):
        levels = {"alone": SUM, "beside": level, "marked": ATOM}
        texts = {letter: text.at_least(levels[entry.places[letter]]) for letter, text in parts.items()}
        yield Text(entry.spelt(texts), _FORMS[entry.form], "symbol" if entry.is_constant else "")


def accent_of(term: Term, over_letter: OverLetter) -> tuple[str, Term] | None:
    """The accent that the paper has for the operation, and what is below it."""
    own = author()
    if own is None:
        return None
    for entry, arguments in own.spellings(term):
        if entry.accent is not None:
            (body,) = arguments.values()
            text = over_letter(body, (entry.accent,))
            if text is not None and own.reads(text.text, term):
                return entry.accent, body
    return None
