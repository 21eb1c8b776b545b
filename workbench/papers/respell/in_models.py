"""A formula that an author has copied out of his text into its model."""

from __future__ import annotations

from collections.abc import Callable, Collection
from contextlib import suppress
from pathlib import Path
from typing import TypeVar

from workbench.language.typed.errors import IllFormedAt, ReadError
from workbench.papers.respell.respelling import respelled
from workbench.papers.texts import spelled
from workbench.papers.texts.tex.tokens import lex
from workbench.papers.texts.view import Source

Result = TypeVar("Result")


def or_respelled(latex: str, words: Collection[str], read: Callable[[str], Result]) -> Result:
    """What is read of it as it stands or, where that is nothing, as it would be in a text. Raises as the
    first does, whose places are those of the model."""
    try:
        return read(latex)
    except ReadError:
        as_in_a_text, _ = spelled(respelled(lex(Source(Path(), latex).view()), words))
        with suppress(ReadError, IllFormedAt):
            return read(as_in_a_text)
        raise
