"""Texts in Markdown with the expected mark behind each display, as a comment: `<!-- refuted: unless … -->`.

A file has a section for each text, below a heading of the second level: its model in a block of TOML (without one
that of the section before it), and the text. A mark is the outcome of a claim as `told` gives it; behind a colon
stand words that its reason or its doubts contain. A display of several steps has a mark for each.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

HERE = Path(__file__).parent / "marked"

_MARK = re.compile(r"<!-- (?P<told>[\w-]+)(?:: (?P<words>.+))? -->")
_MODEL = re.compile(r"```toml\n(.*?)```\n", re.DOTALL)


class Mark(NamedTuple):
    """line: the last line of the text before the mark."""

    line: int
    told: str
    words: str


class MarkedText(NamedTuple):
    """A text without its marks, the model beside it, and the marks in order."""

    name: str
    model: str
    text: str
    marks: list[Mark]


def marked_texts(*files: str) -> Iterator[MarkedText]:
    """Yields the texts of the files; of all files if none is named."""
    for path in sorted(HERE.glob("*.md")):
        if not files or path.stem in files:
            yield from _texts_of(path)


def _texts_of(path: Path) -> Iterator[MarkedText]:
    model = ""
    for section in path.read_text("utf-8").split("\n## ")[1:]:
        heading, _, body = section.partition("\n")
        if own := _MODEL.search(body):
            model, body = own[1], body.replace(own[0], "")
        lines: list[str] = []
        marks: list[Mark] = []
        for line in body.strip("\n").splitlines():
            if mark := _MARK.fullmatch(line):
                marks.append(Mark(len(lines), mark["told"], mark["words"] or ""))
            else:
                lines.append(line)
        yield MarkedText(f"{path.stem}: {heading}", model, "\n".join(lines) + "\n", marks)
