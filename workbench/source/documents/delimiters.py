"""Formulas between delimiters in a text other than TeX, found in one pass."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace

from workbench.source.documents.source_view import View
from workbench.source.documents.tex.displays import DISPLAYS

ENVIRONMENTS = "|".join(re.escape(name) for name in sorted(DISPLAYS, key=len, reverse=True))
_ENVIRONMENT = re.compile(rf"\s*\\begin\{{({ENVIRONMENTS})\}}")
#: Opening delimiter → (closing delimiter, whether it is a display).
_PAIRS = {
    "$$": ("$$", True),
    "\\[": ("\\]", True),
    "\\\\[": ("\\\\]", True),
    "\\(": ("\\)", False),
    "\\\\(": ("\\\\)", False),
    **{f"{mark}f$": (f"{mark}f$", False) for mark in "\\@"},
    **{f"{mark}f[": (f"{mark}f]", True) for mark in "\\@"},
}
_INLINE = re.compile(r"(?=[^\s$])[^$\n]*?(?<![\s\\])\$(?![\d$])")


@dataclass(frozen=True)
class Found:
    """A formula in the view of its text.

    view: the text inside the delimiters.   start, end: offsets in the author's file.
    environment: as for Display.   section: its heading.   passed: the headings between it and the previous
    formula.
    """

    view: View
    start: int
    end: int
    environment: str = "\\["
    label: str | None = None
    section: str = ""
    passed: tuple[str, ...] = ()

    def named(self, label: str | None) -> Found:
        return replace(self, label=label)


def formulas(view: View, searched: str, escaped: bool) -> Iterator[tuple[Found, int, int]]:
    """Yields each formula with its offsets in the view.

    searched: the view's text with code and comments blanked.   escaped: brackets are written \\\\[ … \\\\].
    """
    brackets = r"\\\\[\[(]" if escaped else r"(?<!\\)\\[\[(]"
    opening = re.compile(rf"[\\@]f[$\[]|(?<!\\)\$\$?|{brackets}|\\begin\{{({ENVIRONMENTS})\}}")
    absent: set[str] = set()
    position = 0
    while match := opening.search(searched, position):
        position = match.end()
        if match[0] == "$":
            if close := _INLINE.match(searched, position):
                yield _found(view, match.start(), position, close.end() - 1, close.end(), "$")
                position = close.end()
            continue
        closing, is_display = (f"\\end{{{match[1]}}}", True) if match[1] else _PAIRS[match[0]]
        end = -1 if closing in absent else _find(searched, closing, position)
        if end < 0:
            absent.add(closing)
            continue
        after = end + len(closing)
        if match[1]:
            yield _found(view, match.start(), match.start(), after, after, match[1])
        else:
            yield _found(view, match.start(), position, end, after, "\\[" if is_display else "\\(")
        position = after


def _find(text: str, closing: str, position: int) -> int:
    """Returns the offset of the closing delimiter, ignoring escaped ones; -1 if there is none."""
    while (found := text.find(closing, position)) > 0 and text[found - 1] == "\\" and closing[0] != "\\":
        position = found + 1
    return found


def _found(
    view: View, start: int, inner: int, inner_end: int, end: int, environment: str
) -> tuple[Found, int, int]:
    at = view.at
    found = Found(view.cut(inner, inner_end), at[start], at[end - 1] + 1, environment)
    return found, start, end


def within(found: Found) -> Found:
    """Returns $$ \\begin{align} … \\end{align} $$ as an align; its `view` then starts after \\begin{…}."""
    opening = _ENVIRONMENT.match(found.view.text)
    if opening is None:
        return found
    name = opening[1]
    if not found.view.text.rstrip().endswith(f"\\end{{{name}}}"):
        return found
    inside = found.view.cut(opening.end(), len(found.view.text))
    return replace(found, view=inside, environment=name)
