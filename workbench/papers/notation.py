"""The notation of a paper file: its symbols, its definitions, and what they are on Drake's motions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from difflib import get_close_matches
from typing import Any

from workbench.drake.bindings import BINDINGS
from workbench.language.defining import read_definition, read_definitions
from workbench.language.definitions import Definitions
from workbench.language.errors import IllFormedAt, ReadError, SpecError
from workbench.language.integers import as_linear
from workbench.language.reader import read_term
from workbench.language.symbols import SymbolTable
from workbench.language.terms import Definition, Symbol
from workbench.language.types import Type
from workbench.papers.model import Notation
from workbench.papers.toml_file import TomlFile

_SHAPES = {"scalar": (), "vector": (3,), "tensor": (3, 3)}


def notation_of(files: Sequence[TomlFile]) -> Notation:
    """The notation that the files give together, the first one first. Raises PaperError."""
    table = _table(files)
    definitions: list[Definition] = []
    for file, key, body in _entries(files, "definitions"):
        definition, table = _definition(file, key, body, table)
        definitions.append(definition)
    motion = dict(_binding(file, key, name, table) for file, key, name in _entries(files, "motion"))
    return Notation(table, Definitions(definitions), motion)


def extended(notation: Notation, specs: Mapping[str, Any]) -> Notation:
    """The notation and more symbols, which it must not know yet. Raises SpecError."""
    return replace(notation, symbols=notation.symbols.with_specs(specs))


def with_definitions(notation: Notation, entries: Mapping[str, str]) -> Notation:
    """The notation and more definitions, in their order. Raises SpecError, ReadError and IllFormedAt."""
    more, symbols = read_definitions(entries, notation.symbols)
    return replace(notation, symbols=symbols, definitions=Definitions([*notation.definitions, *more]))


def _table(files: Sequence[TomlFile]) -> SymbolTable:
    specs: dict[str, Any] = {}
    owners: dict[str, TomlFile] = {}
    for file in files:
        for key, spec in file.value(("symbols",), dict, {}).items():
            if key in specs:
                raise file.error_at_key(("symbols", key), f"{key} is declared in {owners[key].path.name} too")
            file.value(("symbols", key), dict)
            specs[key], owners[key] = spec, file
    try:
        return SymbolTable.build(specs)
    except SpecError as error:
        raise owners[error.key].error_at_key(("symbols", error.key), str(error)) from None


def _entries(files: Sequence[TomlFile], table: str) -> Iterator[tuple[TomlFile, str, str]]:
    owners: dict[str, TomlFile] = {}
    for file in files:
        for key in file.value((table,), dict, {}):
            if key in owners:
                message = f"{key} stands in [{table}] of {owners[key].path.name} too"
                raise file.error_at_key((table, key), message)
            owners[key] = file
            yield file, key, file.text((table, key))


def _definition(file: TomlFile, key: str, body: str, table: SymbolTable) -> tuple[Definition, SymbolTable]:
    path = ("definitions", key)
    try:
        return read_definition(key, body, table)
    except SpecError as error:
        raise file.error_at_key(path, str(error)) from None
    except (ReadError, IllFormedAt) as error:
        message = f"{key}: {error.message}"
        raise file.error_in_string(path, error.line, error.column, message) from None


def _binding(file: TomlFile, key: str, name: str, table: SymbolTable) -> tuple[Symbol, str]:
    path = ("motion", key)
    try:
        symbol = read_term(key, table)
    except (ReadError, IllFormedAt) as error:
        raise file.error_in_key(path, error.line, error.column, f"motion: {error.message}") from None
    if not isinstance(symbol, Symbol):
        raise file.error_at_key(path, "motion: expected one symbol on the left")
    binding = BINDINGS.get(name)
    if binding is None:
        near = get_close_matches(name, BINDINGS, 3, 0.5) or sorted(BINDINGS)
        raise file.error_at_value(path, f"motion: unknown quantity {name!r}; expected {' or '.join(near)}")
    if binding.shape != _shape(symbol.type):
        wrong = f"{key} is a {symbol.type}, but {name} has the shape {binding.shape}"
        raise file.error_at_value(path, f"motion: {wrong}: {binding.meaning}")
    if symbol.weight is not None and symbol.weight != as_linear(binding.weight):
        wrong = f"{key} has weight {symbol.weight}, but {name} has weight {binding.weight}"
        raise file.error_at_value(path, f"motion: {wrong}: {binding.meaning}")
    return symbol, name


def _shape(type_: Type) -> tuple[int, ...] | None:
    shape = _SHAPES.get(type_.kind)
    return (2, *shape) if type_.dual and shape is not None else shape
