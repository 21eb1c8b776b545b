"""Views of an author's file: texts whose characters have offsets in the file."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from workbench.core.codes.input_codes import InputCode
from workbench.core.paper_errors import PaperError
from workbench.source.documents.list_items import with_item_marks
from workbench.source.toml.file_bytes import file_bytes

MOST_BYTES = 20_000_000
_BOMS = ((b"\xef\xbb\xbf", "utf-8-sig"), (b"\xff\xfe", "utf-16"), (b"\xfe\xff", "utf-16"))
#: Formats in which a dash at the beginning of a line makes no item.
_WITHOUT_MARKS = frozenset({".tex", ".latex", ".ltx", ".html", ".htm", ".xhtml"})

#: Separators in a notebook: between two lines of a cell, and between two cells.
_NOTEBOOK_LINE = re.compile(r'\\n"[,\s]*"')
_NOTEBOOK_CELL = re.compile(r'(?:\A|"\s*\]?[,\s]*\}).*?"source":\s*\[?\s*"', re.DOTALL)


@dataclass(frozen=True, eq=False)
class Source:
    """A file of an author. Lines and columns count from 1, columns in characters."""

    path: Path
    text: str
    warnings: list[str] = field(default_factory=list)

    @staticmethod
    def open(path: Path) -> Source:
        """Returns the file as UTF-8, or by its byte-order mark, or as Latin-1 with a warning. Raises
        PaperError."""
        raw = file_bytes(path, "a text", MOST_BYTES)
        encoding = next((name for mark, name in _BOMS if raw.startswith(mark)), "utf-8")
        warnings = []
        try:
            text = raw.decode(encoding)
        except UnicodeDecodeError as error:
            if b"\0" in raw:
                reason = InputCode.NOT_A_TEXT(fault="holds NUL bytes; expected a text")
                raise PaperError(path, None, None, reason) from None
            line = raw.count(b"\n", 0, error.start) + 1
            warnings.append(f"line {line}: byte 0x{raw[error.start]:02x} is not UTF-8; read as Latin-1")
            text = raw.decode("latin-1")
        if "\0" in text:
            reason = InputCode.NOT_A_TEXT(fault="holds NUL characters; expected a text")
            raise PaperError(path, None, None, reason)
        return Source(path, text.replace("\r\n", "\n").replace("\r", "\n"), warnings)

    def place(self, offset: int) -> tuple[int, int]:
        line = bisect_right(self._line_starts, offset)
        return line, offset - self._line_starts[line - 1] + 1

    def offset(self, line: int, column: int) -> int:
        """Returns the offset of a place, the inverse of `place`."""
        return self._line_starts[line - 1] + column - 1

    def line(self, number: int) -> str:
        start = self._line_starts[number - 1]
        end = self.text.find("\n", start)
        return self.text[start:] if end < 0 else self.text[start:end]

    def view(self) -> View:
        return View(self.text, self, range(len(self.text) + 1))

    @cached_property
    def prose(self) -> str:
        """The text with unchanged offsets and MARK for items of Markdown; a notebook without its JSON."""
        if self.path.suffix.lower() in _WITHOUT_MARKS:
            return self.text
        return with_item_marks(self._cells if self.path.suffix == ".ipynb" else self.text)

    @property
    def _cells(self) -> str:
        lines = _NOTEBOOK_LINE.sub(lambda found: "\n".rjust(len(found[0])), self.text)
        return _NOTEBOOK_CELL.sub(lambda found: "\n\n".rjust(len(found[0])), lines)

    @cached_property
    def _line_starts(self) -> list[int]:
        return [0, *(match.end() for match in re.finditer("\n", self.text))]


@dataclass(frozen=True, eq=False)
class View:
    """Text whose character i is at offset `at[i]` of the file; at[len(text)] is the end."""

    text: str
    source: Source
    at: Sequence[int]

    def cut(self, start: int, end: int) -> View:
        return View(self.text[start:end], self.source, self.at[start : end + 1])

    def replace(self, pattern: str | re.Pattern[str], new: Callable[[re.Match[str]], str]) -> View:
        """Returns the view with each match replaced; new characters have the offset of the match."""
        pieces: list[str] = []
        at: list[int] = []
        done = 0
        for match in re.finditer(pattern, self.text):
            replacement = new(match)
            pieces += [self.text[done : match.start()], replacement]
            at += self.at[done : match.start()]
            at += [self.at[match.start()]] * len(replacement)
            done = match.end()
        if not pieces:
            return self
        pieces.append(self.text[done:])
        at += self.at[done:]
        return View("".join(pieces), self.source, at)
