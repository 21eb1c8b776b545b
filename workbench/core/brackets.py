"""Brackets in rows of texts: the characters of a formula, or its tokens."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator


def nesting(text: str, opening: Collection[str] = "{", closing: Collection[str] = "}") -> int:
    """Returns 1 for an opening bracket, -1 for a closing one, else 0."""
    return (text in opening) - (text in closing)


def end_of_group(
    texts: Iterable[str], opening: Collection[str] = "{", closing: Collection[str] = "}"
) -> int | None:
    """Returns the index after the bracket that closes the first one; None if it stays open.

    A first text that opens nothing is a group by itself.
    """
    depth = 0
    for end, text in enumerate(texts, 1):
        depth += nesting(text, opening, closing)
        if depth <= 0:
            return end
    return None


def outside(
    texts: Iterable[str], opening: Collection[str] = "{", closing: Collection[str] = "}"
) -> Iterator[int]:
    """Yields the indices of the texts outside all brackets, with those of the outermost closing brackets."""
    depth = 0
    for place, text in enumerate(texts):
        depth += nesting(text, opening, closing)
        if depth == 0:
            yield place
