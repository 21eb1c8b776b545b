"""Edits of an author's file: the characters to remove, and their replacement."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from io import StringIO
from itertools import pairwise

from workbench.core.spans import Span
from workbench.source.documents import Source, Token
from workbench.source.rows.display_vocabulary import RELATIONS

#: Edits with at most this many characters between them are merged.
_CLOSE = 2
_LEFT, _RIGHT = re.compile(r"\\left(?![A-Za-z])"), re.compile(r"\\right(?![A-Za-z])")
_NEXT_CELL = re.compile(r"(?<!\\)&|\\\\")
_MATRIX = re.compile(r"\\begin\{(\w+\*?)\}.*?\\end\{\1\}", re.DOTALL)
#: Tokens after which a formula continues.
_GOES_ON = RELATIONS | {"+", "-", "(", "[", "{", "\\left", "\\times", "\\cdot"}
#: Number of characters around an edit that decide whether a space must separate it from a command.
_LONGEST = 60


@dataclass(frozen=True)
class SourceEdit:
    """An edit that replaces the characters `old` at `span`, `start` to `end` of the source, by `new`."""

    span: Span
    source: Source = field(repr=False, compare=False)
    start: int
    end: int
    old: str
    new: str

    def to_dict(self) -> dict[str, object]:
        """Returns the position, counted from 1 with an exclusive end, and both texts."""
        place = {"file": str(self.span.file), "line": self.span.line, "column": self.span.column}
        end = {"end_line": self.span.end_line, "end_column": self.span.end_column}
        return place | end | {"old": self.old, "new": self.new}


@dataclass(frozen=True)
class Replacement:
    """A range of the text with its replacement."""

    start: int
    end: int
    new: str


@dataclass(frozen=True)
class Piece:
    """The replacement of the characters `start` to `end` of the formula, for the reader (macros expanded) and
    as the author writes it."""

    start: int
    end: int
    expanded: str
    written: str


def applied(source: str, edits: Iterable[SourceEdit | Replacement]) -> str:
    """Returns the source with the edits applied; of two that overlap only the later one."""
    end = len(source)
    for edit in sorted(edits, key=lambda each: (each.start, each.end), reverse=True):
        if edit.end <= end:
            source = source[: edit.start] + edit.new + source[edit.end :]
            end = edit.start
    return source


def patch_of(before: str, after: str, name: str) -> str:
    """Returns a unified diff of a file for `patch`, with lines split at newlines only; "" if nothing
    differs."""
    old, new = (StringIO(text, newline="\n").readlines() for text in (before, after))
    pieces = difflib.unified_diff(old, new, f"a/{name}", f"b/{name}", n=1)
    end = "\n\\ No newline at end of file\n"
    return "".join(piece if piece.endswith("\n") else piece + end for piece in pieces)


def edits_in_source(pieces: Sequence[Piece], owners: Sequence[Token]) -> tuple[SourceEdit, ...] | None:
    """Returns the edits of the source; None if one is not within a single file."""
    found = []
    for piece in pieces:
        edit = _edit_of(piece, owners)
        if edit is None:
            return None
        found.append(edit)
    found.sort(key=lambda each: each.start)
    overlap = any(a.end > b.start for a, b in pairwise(found))
    return None if overlap or _closes_elsewhere(found) else tuple(found)


def _closes_elsewhere(edits: Sequence[SourceEdit]) -> bool:
    """True if a bracket inserted in one cell of a display closes in another one, which TeX rejects."""
    depth = 0
    for edit, after in pairwise(edits):
        depth += len(_LEFT.findall(edit.new)) - len(_RIGHT.findall(edit.new))
        if depth > 0 and _is_parted(edit.source.text[edit.end : after.start]):
            return True
    return False


def _is_parted(between: str) -> bool:
    """True if a cell ends in this part of the source; cells of a matrix within it do not count."""
    return bool(_NEXT_CELL.search(_MATRIX.sub("", between)))


def merged(edits: Sequence[SourceEdit]) -> tuple[SourceEdit, ...]:
    """Returns the edits with nearly adjacent ones merged."""
    found: list[SourceEdit] = []
    for edit in edits:
        if found and found[-1].end + _CLOSE >= edit.start and found[-1].source is edit.source:
            before, between = found.pop(), edit.source.text
            kept = between[before.end : edit.start]
            span = replace(before.span, end_line=edit.span.end_line, end_column=edit.span.end_column)
            found.append(
                replace(
                    before,
                    span=span,
                    end=edit.end,
                    old=before.old + kept + edit.old,
                    new=before.new + kept + edit.new,
                )
            )
        else:
            found.append(edit)
    return tuple(found)


def _edit_of(piece: Piece, owners: Sequence[Token]) -> SourceEdit | None:
    start, end = piece.start, piece.end
    written = piece.written
    if start == end:
        left = owners[start - 1] if start else None
        right = owners[start] if start < len(owners) else None
        if left is not None and right is not None and _overlap(left, right):
            return None  # within what one macro prints
        token = left if left is not None and _stays(left, right) else right
        if token is None or token.end <= token.start:
            return None
        offset = token.start if token is right else token.end
        return _edit(token, offset, offset, written)
    tokens = owners[start:end]
    if len({id(token.source) for token in tokens}) != 1:
        return None
    begin, stop = min(token.start for token in tokens), max(token.end for token in tokens)
    source = tokens[0].source
    others = (each for each in (*owners[:start], *owners[end:]) if each.source is source)
    if any(each.start < stop and begin < each.end for each in others):
        return None  # a macro prints more than the range
    return _edit(tokens[0], begin, stop, written)


def _stays(left: Token, right: Token | None) -> bool:
    """True if text inserted between two tokens belongs to the cell of the left one; a sign or a bracket at
    its end continues in the next cell."""
    if right is None:
        return True
    if left.source is not right.source or left.end > right.start:
        return False
    return _is_parted(left.source.text[left.end : right.start]) and left.text not in _GOES_ON


def _overlap(left: Token, right: Token) -> bool:
    return left.source is right.source and left.start < right.end and right.start < left.end


def _edit(token: Token, begin: int, stop: int, written: str) -> SourceEdit:
    source = token.source
    before = source.text[max(0, begin - _LONGEST) : begin]
    behind = source.text[stop : stop + _LONGEST]
    if written and re.search(r"\\[A-Za-z]+$", before) and written[0].isalpha():
        written = f" {written}"
    if re.search(r"\\[A-Za-z]+$", written or before) and behind[:1].isalpha():
        written = f"{written} "
    if not written:  # a space between the removed text and the next text is removed, too
        stop += len(behind) - len(behind.lstrip(" ")) if before[-1:] in " &" else 0
    span = Span(source.path, *source.place(begin), *source.place(stop))
    return SourceEdit(span, source, begin, stop, source.text[begin:stop], written)
