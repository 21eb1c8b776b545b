"""Completion in an editor: the keys of a model, or their values, at a position in a file."""

from __future__ import annotations

import re
from collections.abc import Sequence

from workbench.core.schema import SCHEMA, Key

_HEADER = re.compile(r"^\s*\[{1,2}\s*([\w-]+)\s*(?:\.\s*([^\]]+?)\s*)?\]{1,2}")
_DIRECTIVE = re.compile(r"%!\s*workbench:\s*")
#: An inline table that is open at the end of a line: `'a' = { kind = "vector", `.
_INLINE = re.compile(r"\{[^{}]*$")
_VALUE = re.compile(r"([\w-]+)\s*=\s*\"?[\w ,-]*$")
_TABLES = {"conventions": "conventions", "frames": "frames", "points": "points", "budget": "budget"}
_TABLES |= {"citation": "citation", "scope": "scope"}


def completions(lines: Sequence[str], line: int, column: int) -> list[tuple[str, str]]:
    """Returns the possible insertions at a position, counted from 0, each with its meaning."""
    before = lines[line][:column] if line < len(lines) else ""
    if (directive := _DIRECTIVE.search(before)) is not None:
        return _within("directive", before[directive.end() :])
    table = _table(lines, line)
    if table is None or before.lstrip().startswith(("#", "[")):
        return []
    if (inline := _INLINE.search(before)) is not None:
        inner = "symbol" if table == "symbols" else "notation entry" if table == "notation" else None
        return _within(inner, re.split(r"[{,]", inline[0])[-1]) if inner else []
    return [] if table in ("symbols", "notation") else _within(table, before)


def _within(table: str, before: str) -> list[tuple[str, str]]:
    """Returns the keys of a table, or the values after `key =`."""
    keys = SCHEMA[table]
    if (value := _VALUE.search(before)) is not None:
        known = {key.name: key for key in keys}
        return (
            [(f'"{each}"', known[value[1]].meaning) for each in known[value[1]].choices]
            if (value[1] in known)
            else []
        )
    return [] if "=" in before else [(key.name, _meaning(key)) for key in keys]


def _meaning(key: Key) -> str:
    return f"{key.meaning} ({key.type})" + (f"\n\nExample: `{key.example}`" if key.example else "")


def _table(lines: Sequence[str], line: int) -> str | None:
    """Returns the table of the schema that contains a line; None if it is unknown.

    For keys of the author it is "symbols" or "notation".
    """
    is_model = any(re.match(r"\s*source\s*=", each) for each in lines)
    header = next((found for each in reversed(lines[:line]) if (found := _HEADER.match(each))), None)
    if header is None:
        return "model" if is_model else "paper file"
    name, rest = header[1], header[2]
    if name == "claim":
        return "claim of a model" if is_model else "claim of a paper file"
    if name == "motion" and rest == "robot":
        return "motion robot"
    if name in ("symbols", "notation"):
        return {"symbols": "symbol", "notation": "notation entry"}[name] if rest else name
    return _TABLES.get(name)
