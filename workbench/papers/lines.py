"""The lines of a formula that is typeset in several, each with its places in the whole."""

from __future__ import annotations

import re
from dataclasses import dataclass

from workbench.language.errors import place

_LINE_ENVIRONMENTS = frozenset({"aligned", "cases", "gathered", "split", "align", "align*", "array"})
_TOKEN = re.compile(r"\\(begin|end)\s*\{([A-Za-z]+\*?)\}|\\\\(?:[ \t]*\[[^\]\n]*\])?|\\.|[{}&]", re.DOTALL)
_LEFT_BRACE = re.compile(r"\s*\\left\s*\\\{\s*")
_SPACE = re.compile(r"\s*")
_COLUMNS = re.compile(r"\s*\{[lcr|\s]*\}")
_RIGHT_NOTHING = re.compile(r"\s*\\right\s*\.")
_BLANK = re.compile(r"(?:\s|\\(?:quad|qquad|[,;:! ])|~)*")
_SIGN = re.compile(r"[+-]")
_RELATION = re.compile(r"=|\\neq?\b")


@dataclass(frozen=True)
class Line:
    """One line of a formula, without alignment marks. `places`: the (line, column) of its characters in the
    whole formula, and of its end."""

    latex: str
    places: tuple[tuple[int, int], ...] = ()

    def place(self, line: int, column: int) -> tuple[int, int]:
        """Where in the whole formula this line's character at (line, column) stands."""
        if not self.places:
            return line, column
        lines = self.latex.split("\n")
        offset = sum(len(text) + 1 for text in lines[: line - 1]) + column - 1
        return self.places[min(offset, len(self.places) - 1)]


def split_lines(latex: str) -> list[Line]:
    """The lines of a formula that is one aligned or cases environment; any other formula is one line.

    A line that begins with a relation, or with a sign and holds no relation, goes on with the line before it;
    what stands behind the environment (such as ", n \\geq 1") belongs to each line.
    """
    left = _LEFT_BRACE.match(latex)
    opening = _TOKEN.match(latex, _SPACE.match(latex, left.end() if left else 0).end())
    if opening is None or opening[1] != "begin" or opening[2] not in _LINE_ENVIRONMENTS:
        return [Line(latex)]
    columns = _COLUMNS.match(latex, opening.end()) if opening[2] == "array" else None
    depth, start = 0, columns.end() if columns else opening.end()
    unmarked, rows = list(latex), [[]]
    for token in _TOKEN.finditer(latex, opening.start()):
        if token[0] == "{" or token[1] == "begin":
            depth += 1
        elif token[0] == "}" or token[1] == "end":
            depth -= 1
        if depth == 1 and token[0] == "&":
            unmarked[token.start()] = " "
        if depth == 0 or (depth == 1 and token[0].startswith("\\\\")):
            rows[-1] += range(start, token.start())
            rows.append([])
            start = token.end()
        if depth == 0:
            break
    else:
        return [Line(latex)]
    right = _RIGHT_NOTHING.match(latex, start) if left else None
    trailer = list(range(right.end() if right else start, len(latex)))
    joined = _joined(unmarked, rows)
    if len(rows) == 2 or not joined:  # the last one ends with the environment
        return [Line(latex)]
    return [_line(latex, unmarked, _trimmed(unmarked, row) + trailer) for row in joined]


def _joined(characters: list[str], rows: list[list[int]]) -> list[list[int]]:
    """The rows that say something, as offsets of characters, with their continuations."""
    joined: list[list[int]] = []
    for row in rows:
        text = "".join(characters[offset] for offset in row)
        content = text[_BLANK.match(text).end() :]
        if not content:
            continue
        goes_on = _RELATION.match(content) or (_SIGN.match(content) and not _RELATION.search(content))
        if joined and goes_on:
            joined[-1] = _trimmed(characters, joined[-1]) + row
        else:
            joined.append(row)
    return joined


def _trimmed(characters: list[str], offsets: list[int]) -> list[int]:
    """Without blanks around and without the punctuation that ends a line."""
    while characters[offsets[0]].isspace():
        offsets = offsets[1:]
    while characters[offsets[-1]] in " \t\r\n.,;" and characters[offsets[-2]] != "\\":
        offsets = offsets[:-1]
    return offsets


def _line(latex: str, characters: list[str], offsets: list[int]) -> Line:
    places = tuple(place(latex, offset) for offset in [*offsets, offsets[-1] + 1])
    return Line("".join(characters[offset] for offset in offsets), places)
