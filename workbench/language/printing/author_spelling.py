"""The author for whom terms are printed, with the spellings of the paper."""

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
    """is_plain: the author uses canonical spellings only.   owns_unit: \\mathbf{I} is a symbol of the paper
    other than the unit tensor.   has_columns: ∂f/∂x of a scalar by a vector is printed as a column."""

    @property
    def is_plain(self) -> bool: ...

    @property
    def owns_unit(self) -> bool: ...

    @property
    def has_columns(self) -> bool: ...

    def spellings(self, term: Term) -> Iterator[tuple[Notation, Mapping[str, Term]]]:
        """Yields the entries of [notation] that may match the term, the most specific first, with their
        arguments."""

    def reads(self, text: str, term: Term) -> bool:
        """True if the text is read as the term."""


_author: ContextVar[Author | None] = ContextVar("author", default=None)
author = _author.get


@contextmanager
def printed_for(one: Author) -> Iterator[None]:
    """Prints terms within the context in the author's notation."""
    token = _author.set(None if one.is_plain else one)
    try:
        yield
    finally:
        _author.reset(token)


#: Precedence level of a notation, by its form.
_FORMS = {"closed": ATOM, "marked": FACTOR, "infix": INFIX, "open": SUM}


def is_spelt_as_one(term: Term) -> bool:
    """True if the author's spelling contains a repeated subterm only once, as x in the derivative of x in a
    frame.

    Then no occurrence of it can be changed separately.
    """
    own = author()
    spellings = list(own.spellings(term)) if own is not None else ()
    if not spellings:
        return False
    parts = Counter(term.walk())
    return any(parts[argument] > 1 for _, arguments in spellings for argument in arguments.values())


OverLetter = Callable[..., Text | None]


def declared(term: Term, printed: Callable[[Term], Text], over_letter: OverLetter) -> Text | None:
    """Returns the term in the paper's own notation, if that is read back as this term; else None.

    printed: prints any other term.   over_letter: prints a term whose accents stand over its letter only.
    """
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
    """Yields the spellings: an accent over the letter only; then with as few brackets as possible first."""
    if entry.accent is not None and (text := over_letter(term)) is not None:
        yield text
    parts = {letter: printed(argument) for letter, argument in arguments.items()}
    for level in (PRODUCT, FACTOR, ATOM):
        levels = {"alone": SUM, "beside": level, "marked": ATOM}
        texts = {letter: text.at_least(levels[entry.places[letter]]) for letter, text in parts.items()}
        yield Text(entry.spelt(texts), _FORMS[entry.form], "symbol" if entry.is_constant else "")


def accent_of(term: Term, over_letter: OverLetter) -> tuple[str, Term] | None:
    """Returns the accent that the paper uses for the operation, and its argument; else None."""
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
