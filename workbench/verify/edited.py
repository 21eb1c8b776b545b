"""Edits of an author's file: which characters are to go, and what is to stand there."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from dataclasses import dataclass, field
from io import StringIO

from workbench.papers.model import Span
from workbench.papers.texts import Source


@dataclass(frozen=True)
class SourceEdit:
    """For the characters `old` at `span`, `start` to `end` of the source, the author is to write `new`."""

    span: Span
    source: Source = field(repr=False, compare=False)
    start: int
    end: int
    old: str
    new: str

    def to_dict(self) -> dict[str, object]:
        """The place, counted from 1, the end behind the last character, and both texts."""
        place = {"file": str(self.span.file), "line": self.span.line, "column": self.span.column}
        end = {"end_line": self.span.end_line, "end_column": self.span.end_column}
        return place | end | {"old": self.old, "new": self.new}


@dataclass(frozen=True)
class Replacement:
    """A piece of the text by its place, and what to put there."""

    start: int
    end: int
    new: str


def applied(source: str, edits: Iterable[SourceEdit | Replacement]) -> str:
    """The source with the edits made; of two that overlap only the last."""
    end = len(source)
    for edit in sorted(edits, key=lambda each: (each.start, each.end), reverse=True):
        if edit.end <= end:
            source = source[: edit.start] + edit.new + source[edit.end :]
            end = edit.start
    return source


def patch_of(before: str, after: str, name: str) -> str:
    """A unified diff of a file for `patch`, which parts lines at newlines only; empty if nothing differs."""
    lines = [StringIO(text, newline="\n").readlines() for text in (before, after)]
    pieces = difflib.unified_diff(*lines, f"a/{name}", f"b/{name}", n=1)
    end = "\n\\ No newline at end of file\n"
    return "".join(piece if piece.endswith("\n") else piece + end for piece in pieces)
