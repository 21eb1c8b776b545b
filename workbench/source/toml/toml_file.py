"""TOML files with errors for people: every fault is one PaperError with its position."""

from __future__ import annotations

import difflib
import re
import tomllib
from collections.abc import Iterable
from copy import copy
from pathlib import Path
from typing import Any, Protocol

from workbench.core.codes.input_codes import InputCode
from workbench.core.formula_errors import place
from workbench.core.paper_errors import KeyPath, PaperError
from workbench.source.toml.file_bytes import file_bytes
from workbench.source.toml.toml_positions import MOST_DEEP, Places, TooDeep, deep_place

MOST_BYTES = 4_000_000
_TOMLLIB_PLACE = re.compile(r"(.*) \(at (?:line (\d+), column (\d+)|end of document)\)", re.DOTALL)
_LONG_KEY = re.compile(
    rf"""(?<![\w.-])(?:(?:[A-Za-z0-9_-]+|"[^"\n]*"|'[^'\n]*')[ \t]*\.[ \t]*){{{MOST_DEEP}}}"""
)
_TYPE_NAMES = {
    str: "a string",
    bool: "true or false",
    int: "an integer",
    float: "a number",
    list: "a list",
    dict: "a table",
}


class TomlTable(Protocol):
    """A TOML file, or a table in one that is read as if it were a file."""

    @property
    def path(self) -> Path: ...

    def value(self, path: KeyPath, expected: type, default: Any = None) -> Any: ...

    def text(self, path: KeyPath) -> str | None: ...

    def texts(self, path: KeyPath) -> tuple[str, ...]: ...

    def error_at_key(self, path: KeyPath, message: str) -> PaperError: ...

    def error_at_value(self, path: KeyPath, message: str) -> PaperError: ...

    def error_in_string(self, path: KeyPath, line: int, column: int, message: str) -> PaperError: ...

    def error_in_key(self, path: KeyPath, line: int, column: int, message: str) -> PaperError: ...


def present_text(table: TomlTable, path: KeyPath) -> str:
    """The text at a path that the table has."""
    text = table.text(path)
    assert text is not None, f"{'.'.join(map(str, path))} is not there"
    return text


class TomlFile:
    """The data of a TOML file and the positions of its keys and values.

    text: the contents, if known. Raises PaperError if the file is missing, too big, or not TOML in UTF-8.
    """

    def __init__(self, path: Path, text: str | None = None) -> None:
        self.path = path
        self._origin: TomlFile | None = None
        text = self._text() if text is None else text
        if _LONG_KEY.search(text) and (offset := deep_place(text)) is not None:  # tomllib would take minutes
            raise self._too_deep(text, offset)
        try:
            self.data: dict[str, Any] = tomllib.loads(text)
            self.places = Places.scan(text)
        except TooDeep as fault:
            raise self._too_deep(text, fault.offset) from None
        except tomllib.TOMLDecodeError as error:
            raise self._syntax_error(error, text) from None
        except RecursionError:
            raise self._too_deep(text, deep_place(text) or 0) from None
        except ValueError as error:  # such as an integer of more digits than Python converts
            raise PaperError(path, 1, 1, InputCode.NOT_TOML(why=error)) from None

    def value(self, path: KeyPath, expected: type, default: Any = None) -> Any:
        """Returns the value at `path`, which must have the expected type; `default` if the key is missing."""
        node: Any = self.data
        for depth, part in enumerate(path):
            if isinstance(node, list) and isinstance(part, int):
                node = node[part]
            elif not isinstance(node, dict):
                raise self._wrong_kind(path[:depth], dict, node)
            elif part in node:
                node = node[part]
            else:
                return default
        if type(node) is not expected:
            raise self._wrong_kind(path, expected, node)
        return node

    def _wrong_kind(self, path: KeyPath, expected: type, node: Any) -> PaperError:
        got = _TYPE_NAMES.get(type(node), f"a {type(node).__name__}")
        reason = InputCode.VALUE_TYPE(key=path[-1], expected=_TYPE_NAMES[expected], got=got)
        return self.error_at_value(path, reason)

    def text(self, path: KeyPath) -> str | None:
        """Returns a string that is not blank, or None if the key is missing."""
        text = self.value(path, str)
        if text is not None and not text.strip():
            reason = InputCode.VALUE_TYPE(key=path[-1], expected="some text", got="an empty string")
            raise self.error_at_value(path, reason)
        return text

    def texts(self, path: KeyPath) -> tuple[str, ...]:
        items = self.value(path, list, [])
        for index, item in enumerate(items):
            place = (*path, index)
            if type(item) is not str or not item.strip():
                raise self.error_at_value(place, f"{path[-1]}: expected a list of strings that are not empty")
        return tuple(items)

    def tables(self, path: KeyPath) -> list[dict[str, Any]]:
        """Returns the tables written [[path]]."""
        items = self.value(path, list, [])
        for index, item in enumerate(items):
            if not isinstance(item, dict):
                message = f"{path[-1]}: expected tables, written [[{path[-1]}]]"
                raise self.error_at_value((*path, index), message)
        return items

    def allow_keys(self, path: KeyPath, allowed: Iterable[str]) -> None:
        """Raises PaperError at the first key of the table at `path` that is not among `allowed`."""
        allowed = list(allowed)
        table = self.value(path, dict, {}) if path else self.data
        for key in table:
            if key not in allowed:
                near = difflib.get_close_matches(key, allowed, 1)
                hint = f"did you mean {near[0]}?" if near else f"expected one of {', '.join(allowed)}"
                raise self.error_at_key((*path, key), InputCode.UNKNOWN_KEY(key=repr(key), hint=hint))

    @property
    def origin(self) -> TomlFile:
        """The file that this is a view of; the file itself if it is no view."""
        return self._origin or self

    def without(self, path: KeyPath) -> TomlFile | None:
        """Returns a view of the file without the entry. Returns None if there is no such entry, or if it is a
        table of a list."""
        *above, key = path or ("",)
        holder: Any = self.data
        for part in above:
            holder = holder[part]
        if isinstance(key, int):
            return None if isinstance(holder[key], dict) else self.without(tuple(above))
        if key not in holder:
            return None
        view = copy(self)
        view._origin, view.data = self.origin, _removed(self.data, path)
        return view

    def error_at_key(self, path: KeyPath, message: str) -> PaperError:
        return PaperError(self.path, *self.places.of_key(path), message, self.origin, path)

    def error_at_value(self, path: KeyPath, message: str) -> PaperError:
        return PaperError(self.path, *self.places.of_value(path), message, self.origin, path)

    def error_in_string(self, path: KeyPath, line: int, column: int, message: str) -> PaperError:
        place = self.places.in_string(path, line, column)
        return PaperError(self.path, *place, message, self.origin, path, self.value(path, str))

    def error_in_key(self, path: KeyPath, line: int, column: int, message: str) -> PaperError:
        place = self.places.in_key(path, line, column)
        return PaperError(self.path, *place, message, self.origin, path, str(path[-1]))

    def _text(self) -> str:
        raw = file_bytes(self.path, "a TOML file", MOST_BYTES)
        try:
            text = raw.decode("utf-8")
        except UnicodeDecodeError as error:
            line = raw.count(b"\n", 0, error.start) + 1
            column = error.start - (raw.rfind(b"\n", 0, error.start) + 1) + 1
            byte = raw[error.start]
            reason = InputCode.NOT_A_TEXT(fault=f"byte 0x{byte:02x} is not UTF-8")
            raise PaperError(self.path, line, column, reason) from None
        if text.startswith("\ufeff"):
            reason = InputCode.NOT_A_TEXT(fault="begins with a byte-order mark; save it as plain UTF-8")
            raise PaperError(self.path, 1, 1, reason)
        if not text.strip():
            raise PaperError(self.path, 1, 1, "is empty; expected a paper file with [[claim]] tables")
        return text

    def _too_deep(self, text: str, offset: int) -> PaperError:
        message = f"tables or lists are nested too deep; expected at most {MOST_DEEP} in each other"
        return PaperError(self.path, *place(text.replace("\r\n", "\n"), offset), message)

    def _syntax_error(self, error: tomllib.TOMLDecodeError, text: str) -> PaperError:
        message, line, column = str(error), None, None
        if match := _TOMLLIB_PLACE.fullmatch(message):
            message = match[1]
            line = int(match[2]) if match[2] else text.count("\n") + 1
            column = int(match[3]) if match[3] else len(text) - text.rfind("\n")
        return PaperError(self.path, line or 1, column or 1, InputCode.NOT_TOML(why=message))


def _removed(node: Any, path: KeyPath) -> Any:
    """Returns a copy of the data without the entry; the rest is shared."""
    first, *rest = path
    if not rest:
        return {key: value for key, value in node.items() if key != first}
    made = node.copy()
    made[first] = _removed(node[first], tuple(rest))
    return made
