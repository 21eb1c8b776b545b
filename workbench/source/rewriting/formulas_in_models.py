"""Formulas that an author has copied from the text into its model."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import suppress
from typing import TypeVar

from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.source.documents import Token, spelled
from workbench.source.documents.tex.tex_tokens import tokens_of
from workbench.source.rewriting.author_habits import everywhere
from workbench.source.rewriting.column_separators import ROWS
from workbench.source.rewriting.rewrite import argument, respelled

Result = TypeVar("Result")


def with_rows(latex: str) -> str:
    """Returns the formula with [a \\quad -b] and the like as rows of matrices."""
    if "[" not in latex and "matrix" not in latex:
        return latex
    made = tokens = list(with_environments(tokens_of(latex)))
    for pattern in ROWS:
        made = everywhere(made, pattern)
    is_changed = [token.text for token in made] != [token.text for token in tokens]
    return spelled(made)[0] if is_changed else latex


def with_environments(tokens: Sequence[Token]) -> Iterator[Token]:
    """Yields the tokens with \\begin{name} as one, as in displays."""
    place = 0
    while place < len(tokens):
        token = tokens[place]
        place += 1
        if token.text in ("\\begin", "\\end"):
            inside, place = argument(tokens, place)
            name = f"{token.text}{{{spelled(inside)[0]}}}"
            token = Token(name, token.source, token.start, tokens[place - 1].end)
        yield token


def or_respelled(latex: str, words: Collection[str], read: Callable[[str], Result]) -> Result:
    """Returns the result of `read` on the formula, or else on its rewritten form.

    Raises the error of the first attempt, whose positions are those of the model.
    """
    try:
        return read(latex)
    except ReadError:
        as_in_a_text, _ = spelled(respelled(tokens_of(latex), words))
        with suppress(ReadError, IllFormedAt):
            return read(as_in_a_text)
        raise
