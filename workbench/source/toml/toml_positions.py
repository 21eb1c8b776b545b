"""Positions of the keys and values of a TOML file, which `tomllib` does not report.

The scanner takes text that `tomllib` has accepted, so it checks nothing again.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field

from workbench.core.formula_errors import place
from workbench.core.paper_errors import KeyPath

#: Limit on nested tables and lists.
MOST_DEEP = 100

_BLANK = re.compile(r"(?:[ \t\r\n]|#[^\n]*)*")
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")
_BARE_VALUE = re.compile(r"[^,\]}\n#]+")
_PLAIN = re.compile(r'[^"\\]*')
_LINE_END_ESCAPE = re.compile(r"\\[ \t]*\n[ \t\n]*")
_ESCAPE_LENGTH = {"u": 6, "U": 10, "x": 4}


class TooDeep(Exception):
    """More than MOST_DEEP tables or lists are nested at this offset."""

    def __init__(self, offset: int) -> None:
        super().__init__(offset)
        self.offset = offset


@dataclass
class Places:
    """Offsets of keys and of values in `text`; the methods return lines and columns, as an editor shows
    them."""

    text: str
    keys: dict[KeyPath, int] = field(default_factory=dict)
    values: dict[KeyPath, int] = field(default_factory=dict)

    @staticmethod
    def scan(text: str) -> Places:
        places = Places(text.replace("\r\n", "\n"))
        _Scanner(places).document()
        return places

    def of_key(self, path: KeyPath) -> tuple[int, int]:
        """Returns the line and column of a key, or of the nearest enclosing table in the file."""
        while path and path not in self.keys:
            path = path[:-1]
        return place(self.text, self.keys.get(path, 0))

    def of_value(self, path: KeyPath) -> tuple[int, int]:
        return place(self.text, self.values[path]) if path in self.values else self.of_key(path)

    def in_string(self, path: KeyPath, line: int, column: int) -> tuple[int, int]:
        """Returns the position in the file of the character at (line, column) of a string value."""
        return self._inside(self.values.get(path), line, column) or self.of_value(path)

    def in_key(self, path: KeyPath, line: int, column: int) -> tuple[int, int]:
        """Returns the position in the file of the character at (line, column) of a quoted key."""
        return self._inside(self.keys.get(path), line, column) or self.of_key(path)

    def _inside(self, start: int | None, line: int, column: int) -> tuple[int, int] | None:
        if start is None or self.text[start] not in "\"'":
            return None
        at_line, at_column = 1, 1
        for offset, character in characters(self.text, start):
            if (at_line, at_column) >= (line, column):
                return place(self.text, offset)
            at_line, at_column = (at_line + 1, 1) if character == "\n" else (at_line, at_column + 1)
        return place(self.text, string_end(self.text, start) - 1)


def deep_place(text: str) -> int | None:
    """Returns the offset at which a text, perhaps not TOML, nests too deep; None if it does not."""
    with suppress(IndexError, AttributeError, ValueError, RecursionError):
        try:
            Places.scan(text)
        except TooDeep as fault:
            return fault.offset
    return None


def characters(text: str, start: int) -> Iterator[tuple[int, str]]:
    """Yields (offset, character) for the TOML string at `start`; an escape is `?` or a line feed."""
    end = string_end(text, start)
    quote = text[start]
    width = 3 if text.startswith(quote * 3, start) and end - start >= 6 else 1
    position, end = start + width, end - width
    if width == 3 and text[position] == "\n":
        position += 1
    while position < end:
        character, length = text[position], 1
        if quote == '"' and character == "\\":
            if skipped := _LINE_END_ESCAPE.match(text, position):
                position = skipped.end()
                continue
            kind = text[position + 1]
            character, length = "\n" if kind == "n" else "?", _ESCAPE_LENGTH.get(kind, 2)
        yield position, character
        position += length


def _end_of(pattern: re.Pattern[str], text: str, start: int) -> int:
    """Returns the offset just behind what matches at `start`, in a text that is valid TOML."""
    match = pattern.match(text, start)
    assert match is not None, f"{pattern.pattern} at {start}"
    return match.end()


def string_end(text: str, start: int) -> int:
    """Returns the offset after the closing quotes of the TOML string that opens at `start`."""
    quote = text[start]
    long = text.startswith(quote * 3, start)
    closing = quote * 3 if long else quote
    position = start + len(closing)
    if quote == "'":
        position = text.index(closing, position)
    else:
        while not text.startswith(closing, position := _end_of(_PLAIN, text, position)):
            position += 2 if text[position] == "\\" else 1
    position += len(closing)
    if long:  # up to two quotes before the closing ones belong to the text
        for _ in range(2):
            position += text.startswith(quote, position)
    return position


class _Scanner:
    def __init__(self, places: Places) -> None:
        self.places, self.text, self.at = places, places.text, 0
        self.array_lengths: dict[KeyPath, int] = {}

    def document(self) -> None:
        table: KeyPath = ()
        while self._skip_blank() < len(self.text):
            if self.text[self.at] == "[":
                table = self._header()
            else:
                self._key_value(table)

    def _header(self) -> KeyPath:
        start, double = self.at, self.text.startswith("[[", self.at)
        self.at += 2 if double else 1
        path: KeyPath = ()
        parts = self._dotted_key()
        for depth, (part, _) in enumerate(parts, start=1):
            path = (*path, part)
            if double and depth == len(parts):
                self.array_lengths[path] = self.array_lengths.get(path, 0) + 1
            if path in self.array_lengths:
                path = (*path, self.array_lengths[path] - 1)
        self.at += 2 if double else 1
        self.places.keys[path] = start
        self.places.keys.setdefault(path[:-1] if double else path, start)
        return path

    def _key_value(self, table: KeyPath) -> None:
        path = table
        for part, offset in self._dotted_key():
            path = (*path, part)
            self.places.keys.setdefault(path, offset)
        self.at += 1  # the equals sign
        self._value(path)

    def _dotted_key(self) -> list[tuple[str, int]]:
        parts: list[tuple[str, int]] = []
        while True:
            start = self._skip_blank()
            if len(parts) > MOST_DEEP:
                raise TooDeep(parts[0][1])
            if self.text[start] in "\"'":
                self.at = string_end(self.text, start)
                name = self._quoted(start)
            else:
                self.at = _end_of(_BARE_KEY, self.text, start)
                name = self.text[start : self.at]
            parts.append((name, start))
            if self.text[self._skip_blank()] != ".":
                return parts
            self.at += 1

    def _quoted(self, start: int) -> str:
        if self.text[start] == "'":
            return self.text[start + 1 : self.at - 1]
        return next(iter(tomllib.loads(self.text[start : self.at] + "=0")))

    def _value(self, path: KeyPath) -> None:
        start = self._skip_blank()
        if len(path) > MOST_DEEP:
            raise TooDeep(start)
        self.places.values[path] = start
        opening = self.text[start]
        if opening in "\"'":
            self.at = string_end(self.text, start)
        elif opening == "[":
            self._items("]", lambda index: self._value((*path, index)))
        elif opening == "{":
            self._items("}", lambda index: self._key_value(path))
        else:
            self.at = _end_of(_BARE_VALUE, self.text, start)

    def _items(self, closing: str, item: Callable[[int], None]) -> None:
        self.at += 1
        index = 0
        while self.text[self._skip_blank()] != closing:
            item(index)
            index += 1
            if self.text[self._skip_blank()] == ",":
                self.at += 1
        self.at += 1

    def _skip_blank(self) -> int:
        self.at = _end_of(_BLANK, self.text, self.at)
        return self.at
