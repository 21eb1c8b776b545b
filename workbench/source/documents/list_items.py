"""Lists in the words of a text: each item is a sentence of its own, which the words before the list begin."""

from __future__ import annotations

import re
from bisect import bisect_left
from functools import lru_cache

#: Stands in place of the mark of an item, such as "-" or "2.", that begins a line; it is white space.
MARK = "\x1e"
_DISPLAY = (
    r"\$\$.*?\$\$|\\\[.*?\\\]|\\begin\s*\{(?P<name>\w+\*?)\}.*?\\end\s*\{(?P=name)\}"
    r"|^(?P<fence>[ \t]*(?:`{3,}|~{3,})).*?^(?P=fence)"
    r"|^(?P<indent>[ \t]*)\.\. math::.*?(?=^(?!(?P=indent)[ \t])[ \t]*\S|\Z)"
)
_INLINE = r"(?<![\\$])\$(?:[^$\n]|\n(?![ \t]*\n))+\$"
_MARKED = re.compile(
    rf"{_DISPLAY}|{_INLINE}|(?P<before>^[ \t>]*)(?P<mark>[-*+]|(?:\d{{1,9}}|#)[.)])(?=[ \t\n])",
    re.DOTALL | re.MULTILINE,
)
_LIST = r"\{(?:itemize|enumerate|description)\*?\}"
LIST_END = re.compile(rf"\\end\s*{_LIST}|(?i:</[ou]l>)")
_LIST_EDGE = re.compile(rf"(?P<end>{LIST_END.pattern})|\\begin\s*{_LIST}(?:\[[^\]]*\])?|(?i:<[ou]l\b[^<>]*>)")
ITEM = re.compile(rf"\\item\b|(?i:<li\b[^<>]*>)|{MARK}")
_ITEM_OR_EDGE = re.compile(rf"(?P<item>\\item\b|(?i:<li\b[^<>]*>))|{_LIST_EDGE.pattern}")
#: The beginning of a paragraph without indentation, which ends a list of marks.
_OUTSIDE = re.compile(rf"\n[ \t]*\n(?=[^\s{MARK}$\\`])")


def with_item_marks(text: str) -> str:
    """Returns a text in Markdown or reStructuredText with MARK in place of the marks of items; offsets are
    unchanged."""

    def marked(match: re.Match[str]) -> str:
        return match[0] if match["mark"] is None else match["before"] + MARK.ljust(len(match["mark"]))

    return _MARKED.sub(marked, text)


def list_begin(text: str, start: int) -> int | None:
    """Returns the offset at which the innermost list around `start` begins; None outside of lists."""
    edges, marks = _edges(text), _marks(text)
    closed = 0
    for offset, is_end in reversed(edges[: bisect_left(edges, (start, False))]):
        closed += 1 if is_end else -1
        if closed < 0:
            return offset
    first, own = None, 0
    for offset, column in reversed(marks[: bisect_left(marks, (start, 1))]):
        if column == 0 or (first is not None and column < own):  # outside, or the item around the list
            break
        own = column if first is None else own
        first = offset
    return first


def item_around(text: str, start: int) -> tuple[int, int] | None:
    """Returns the start and end of the innermost item around `start`, with the lists in it; None outside of
    lists."""
    begin = list_begin(text, start)
    if begin is None:
        return None
    marks = _marks(text)
    at = bisect_left(marks, (start, 1)) - 1
    if at >= 0 and marks[at][0] >= begin:  # a list of marks
        offset, column = marks[at]
        return offset, next((end for end, other in marks[at + 1 :] if other <= column), len(text))
    depth, first = 0, begin
    for match in _ITEM_OR_EDGE.finditer(text, begin):
        if match["item"] is None:
            depth += -1 if match["end"] else 1
        if not depth or (depth == 1 and match["item"] is not None):
            if match.start() > start:
                return first, match.start()
            first = match.start()
    return first, len(text)


@lru_cache(maxsize=8)
def _edges(text: str) -> list[tuple[int, bool]]:
    """Returns the begins and ends of lists in TeX and HTML, each with whether it is an end."""
    return [(match.start(), match["end"] is not None) for match in _LIST_EDGE.finditer(text)]


@lru_cache(maxsize=8)
def _marks(text: str) -> list[tuple[int, int]]:
    """Returns the marks with their columns from 1, and the paragraphs that end a list, with 0."""
    marks = (match.start() for match in re.finditer(MARK, text))
    outside = [(match.end(), 0) for match in _OUTSIDE.finditer(text)]
    return sorted([*outside, *((at, at - text.rfind("\n", 0, at)) for at in marks)])
