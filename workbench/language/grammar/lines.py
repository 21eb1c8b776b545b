"""The lines of a formula that is typeset in several: slices of it, each of which can be read by itself."""

from __future__ import annotations

import re
from dataclasses import dataclass

from workbench.language.grammar.context import join_lines
from workbench.language.grammar.tokens import MOST_CHARACTERS, Tokenizer
from workbench.language.typed.errors import place

_LEFT_BRACE = re.compile(r"\s*(?:\\left\s*\\\{\s*)?")
_RIGHT_NOTHING = re.compile(r"\s*\\right\s*\.")
_CLOSING = " \t\r\n.,;"


@dataclass(frozen=True)
class Line:
    """One line of a formula, without alignment marks. slices: where it stands in the whole formula."""

    latex: str
    whole: str
    slices: tuple[slice, ...]

    def place(self, line: int, column: int) -> tuple[int, int]:
        """Where in the whole formula this line's character at (line, column) stands."""
        left = sum(len(text) + 1 for text in self.latex.split("\n")[: line - 1]) + column - 1
        for piece in self.slices:
            if left < piece.stop - piece.start:
                return place(self.whole, piece.start + left)
            left -= piece.stop - piece.start
        return place(self.whole, self.slices[-1].stop)


def whole_line(latex: str) -> Line:
    return Line(latex, latex, (slice(0, len(latex)),))


def split_lines(latex: str) -> list[Line]:
    """The lines of a formula that is one aligned or cases environment; any other formula is one line.

    What stands behind the environment (such as ", n \\geq 1") belongs to each line. A map f : A \\to B and
    what f(x) is are one line.
    """
    if r"\\" not in latex or len(latex) > MOST_CHARACTERS:
        return [whole_line(latex)]
    tokenizer = Tokenizer(latex)
    tokens = tokenizer.legible()
    kept = {token.start_pos for token in join_lines(tokens)}
    rows: list[list[slice]] = []
    row: list[slice] = []
    inside: list[int] = []
    depth = breaks = start = 0
    text = _unaligned(tokenizer)
    for token in tokens:
        depth += (token.type == "BEGIN_LINES") - (token.type == "END_LINES")
        if token is tokens[0] and depth == 1:
            start = token.end_pos
        elif depth == 0 or (depth == 1 and token.type == "BREAK"):
            end = token.start_pos
            while inside and inside[-1] not in kept:  # a comma or a repeated sign: the line goes on
                end = inside.pop()
            row += [_trimmed(text, start, end)] if inside else []
            if row and token.start_pos in kept:
                rows.append(row)
                row = []
            inside, start, breaks = [], token.end_pos, breaks + depth
            if depth == 0:
                break
        else:
            inside.append(token.start_pos)
    if any(token == "→" for token in tokens):
        return [whole_line(latex)]
    if not breaks or depth > 0 or not _LEFT_BRACE.fullmatch(latex[: tokens[0].start_pos]):
        return [whole_line(latex)]
    right = _RIGHT_NOTHING.match(latex, start)
    behind = slice(right.end() if right else start, len(latex))
    return [_line(text, latex, (*row, behind)) for row in rows]


def _unaligned(tokenizer: Tokenizer) -> str:
    """The formula with a blank for each alignment mark of its lines."""
    shown = list(tokenizer.text)
    for at, environments in tokenizer.alignments:
        if environments == 1:
            shown[at] = " "
    return "".join(shown)


def _line(text: str, latex: str, slices: tuple[slice, ...]) -> Line:
    first = text[slices[0]]
    blank = len(first) - len(first.lstrip())
    slices = (slice(slices[0].start + blank, slices[0].stop), *slices[1:])
    return Line("".join(text[piece] for piece in slices), latex, slices)


def _trimmed(text: str, start: int, end: int) -> slice:
    """Without the punctuation and the blanks at its end."""
    while end > start and text[end - 1] in _CLOSING and text[end - 2] != "\\":
        end -= 1
    return slice(start, end)
