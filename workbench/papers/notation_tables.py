"""The notation of a paper file: its symbols, its definitions, and their bindings to Drake's motions."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, TypeAlias

from workbench.context.claims import Notation
from workbench.core.codes.declaration_codes import DeclarationCode
from workbench.core.codes.syntax_codes import UNKNOWN_SYMBOLS, SyntaxCode
from workbench.core.formula_errors import IllFormedAt, ReadError, SpecError
from workbench.core.names import Name
from workbench.core.paper_errors import PaperError
from workbench.core.reasons import Reason
from workbench.core.schema import choices
from workbench.core.terms import Definition, Symbol
from workbench.language.definition_entries import read_definition, read_definitions
from workbench.language.definitions import Definitions
from workbench.language.naming.declarations import read_key
from workbench.language.naming.reading_conventions import Conventions
from workbench.language.naming.spelling import INDEX_LETTERS
from workbench.language.naming.symbols import SymbolTable
from workbench.papers.bound_symbols import ties
from workbench.papers.declared_properties import Promise, require_kept, without_promises
from workbench.papers.motion_table import CLAIMS, ROBOT, bindings, formulas, robot
from workbench.papers.paper_frames import frame_labels, framed, require_rotations
from workbench.source.rewriting.formulas_in_models import or_respelled
from workbench.source.toml.toml_file import TomlFile, TomlTable, present_text

HAMILTON = "hamilton, scalar first"
#: The allowed values of each convention.
CONVENTIONS = choices("conventions")
#: (file, key, body) of a definition.
_Entry: TypeAlias = tuple[TomlTable, str, str]
_GROUPS = re.compile(r"[\s{}]")
_DOTS = re.compile(r"^\s*\\d{1,4}ot(?![A-Za-z])")
#: The functions that a text may write without the backslash, if its model says so.
FUNCTIONS = ("cos", "cot", "csc", "exp", "sec", "sin", "tan")


def notation_of(files: Sequence[TomlFile], scopes: Sequence[TomlTable] = ()) -> Notation:
    """Returns the notation that the files give together, the first one first.

    Each of the scopes redeclares the symbols that it names, and removes their definitions. Raises PaperError.
    """
    table, promises = _table(files, scopes)
    table = replace(
        table,
        arguments=_arguments(files),
        conventions=Conventions.build(
            {key: text for key in CONVENTIONS if (text := _convention(files, key)) is not None},
            [name for file in files for name in file.texts(("conventions", "functions"))],
        ),
    )
    table = _spellings(files, table)
    table, definitions, turns = framed([*files, *scopes], table)
    made_by_frames = frozenset(definition.declaration.name for definition in definitions)
    entries = _in_order(list(_in_scope(files, scopes)), table) if scopes else list(_in_scope(files, scopes))
    written, table = _definitions(entries, scopes, table)
    definitions += written
    if made_by_frames:
        _refuse_circle(entries, written, Definitions(definitions))
    bound: dict[Symbol, str] = {}
    for file, keys in _keys(files, "motion"):
        bound |= bindings(file, table, [key for key in keys if key not in (ROBOT, CLAIMS)])
    robots = [each for file in files if (each := robot(file)) is not None]
    tied = ties(bound, Definitions(definitions))
    known = Definitions([*definitions, *tied])
    require_rotations(turns, known)
    require_kept(promises, {key: file for file, key, _ in entries}, table, known)
    notation = Notation(table, known, bound, robots[-1] if robots else None)
    notation = replace(notation, words=_words(files), framed=made_by_frames)
    return replace(notation, on_motions=dict(f for file in files for f in formulas(file, notation)))


@dataclass
class _Order:
    """Orders definitions so that each can be read.

    Attributes:
        made: Definitions that are read, each with the symbols known before it.
        waiting: Definitions that are not read yet.
    """

    table: SymbolTable
    made: list[tuple[_Entry, Definition, SymbolTable]] = field(default_factory=list)
    waiting: list[_Entry] = field(default_factory=list)

    def entries(self) -> list[_Entry]:
        return [*(entry for entry, _, _ in self.made), *self.waiting]

    def read(self, tried: Sequence[_Entry]) -> list[_Entry] | None:
        """Reads entries, and those that waited for them.

        Returns the entries to read again, in a possible order, if an entry that is already read uses one of
        them. Returns None if there is no such order.
        """
        while tried:
            keys: list[str] = []
            for each in tried:
                try:
                    definition, known = _read(*each[1:], self.table)
                except (ReadError, IllFormedAt, SpecError) as error:
                    if isinstance(error, SpecError) and error.code is DeclarationCode.USED_ABOVE:
                        return self._with_users_behind(each)
                    continue
                self.made.append((each, definition, self.table))
                self.table = known
                self.waiting.remove(each)
                keys.append(_GROUPS.sub("", each[1]))
            tried = [each for each in self.waiting if any(key in _GROUPS.sub("", each[2]) for key in keys)]
        return []

    def _with_users_behind(self, entry: _Entry) -> list[_Entry] | None:
        using = [each for each, definition, _ in self.made if _uses(definition, entry[1])]
        if not using:
            return None
        first = next(at for at, made in enumerate(self.made) if made[0] is using[0])
        others = [each for each, _, _ in self.made[first:] if each not in using]
        waiting = [each for each in self.waiting if each != entry]
        self.table, self.waiting = self.made[first][2], []
        del self.made[first:]
        return [*others, entry, *using, *waiting]


def _in_order(entries: list[_Entry], table: SymbolTable) -> list[_Entry]:
    """Returns the entries with each before those that use it; unchanged if there is no such order."""
    order = _Order(table)
    rest, kept = deque(entries), list(entries)
    last, moves = -1, 0
    while rest or len(order.made) != last:
        if rest:
            order.waiting.append(rest.popleft())
            again = order.read(order.waiting[-1:])
        else:  # those whose symbols are spelled in another way
            last = len(order.made)
            again = order.read(list(order.waiting))
        if again is None:
            return kept
        if again:
            moves += 1
            rest.extendleft(reversed(again))
            kept = [*order.entries(), *rest]
        if moves > len(entries) ** 2:
            return entries
    return order.entries()


def _uses(definition: Definition, key: str) -> bool:
    names = {read_key(key, letters)[0] for letters in (INDEX_LETTERS, frozenset())}
    return any(part.declaration.name in names for part in definition.body.symbols())


def _definitions(
    entries: list[_Entry], scopes: Sequence[TomlTable], table: SymbolTable
) -> tuple[list[Definition], SymbolTable]:
    """Returns the definitions in their order, and the symbols.

    In a scope, a definition that needs a later one comes after it. An earlier definition that does not fit
    the scope's declarations is dropped.
    """
    found: list[Definition] = []
    waiting: list[_Entry] = []
    refused: list[PaperError] = []
    for file, key, body in entries:
        try:
            definition, table = _definition(file, key, body, table)
        except PaperError as error:
            if not scopes:
                raise
            waiting.append((file, key, body))
            refused += [error] if file is scopes[-1] else []
        else:
            found.append(definition)
    if len(waiting) < len(entries) and refused:
        more, table = _definitions(waiting, scopes, table)
        return [*found, *more], table
    if refused:  # an unknown symbol may only follow from another fault
        raise min(refused, key=_is_of_unknown_symbol)
    return found, table


def _is_of_unknown_symbol(error: PaperError) -> bool:
    return isinstance(error.message, Reason) and bool(error.message.codes & UNKNOWN_SYMBOLS)


def _refuse_circle(entries: Sequence[_Entry], found: Sequence[Definition], known: Definitions) -> None:
    """Raises PaperError for a definition of [frames] or [points] that leads back to itself."""
    for definition in found:
        behind = () if definition.index else known.symbols_in(definition.body)
        if any(each.declaration == definition.declaration for each in behind):
            name = str(definition.declaration.name)
            file, key = next(((file, key) for file, key, _ in entries if key == name), entries[0][:2])
            message = f"{name}: its definition leads back to it, by way of [frames] or [points]"
            raise file.error_at_key(("definitions", key), message)


def _spellings(files: Sequence[TomlFile], table: SymbolTable) -> SymbolTable:
    """Returns the table with the spellings that [notation] explains."""
    specs: dict[str, Any] = {}
    owners: dict[str, TomlTable] = {}
    for file in files:
        entries = file.data.get("notation")
        for key, spec in entries.items() if isinstance(entries, dict) else ():
            if key != "from":
                specs[key], owners[key] = spec, file
    try:
        return table.with_notations(specs) if specs else table
    except SpecError as error:
        raise owners[error.key].error_at_key(("notation", error.key), error.reason) from None


def extended(notation: Notation, specs: Mapping[str, Any]) -> Notation:
    """Returns the notation with new symbols. Raises SpecError, also for a symbol that is already declared."""
    return replace(notation, symbols=notation.symbols.with_specs(specs))


def with_definitions(notation: Notation, entries: Mapping[str, str]) -> Notation:
    """Returns the notation with more definitions, in their order. Raises SpecError, ReadError and
    IllFormedAt."""
    more, symbols = read_definitions(entries, notation.symbols)
    return replace(notation, symbols=symbols, definitions=Definitions([*notation.definitions, *more]))


def _table(files: Sequence[TomlTable], scopes: Sequence[TomlTable]) -> tuple[SymbolTable, list[Promise]]:
    specs: dict[str, Any] = {}
    owners: dict[str, TomlTable] = {}
    hamilton = any([_says_hamilton(file) for file in files])
    for file in (*files, *scopes):
        for key, spec in file.value(("symbols",), dict, {}).items():
            if key in specs and file not in scopes:
                raise file.error_at_key(("symbols", key), f"{key} is declared in {owners[key].path.name} too")
            spec = {"kind": spec} if isinstance(spec, str) else file.value(("symbols", key), dict)
            if hamilton and str(spec.get("kind")).removeprefix("dual ") == "quaternion":
                spec = {**spec, "kind": spec["kind"].replace("quaternion", "hamilton quaternion")}
            specs[key], owners[key] = spec, file
    try:
        bodies = {key: body for _, key, body in _in_scope(files, scopes)}
        anew = {key for scope in scopes for key in scope.value(("definitions",), dict, {})}
        plain, promises = without_promises(specs, bodies, anew)
        return SymbolTable.build(plain, frame_labels((*files, *scopes)), bodies), promises
    except SpecError as error:
        raise owners[error.key].error_at_key(("symbols", error.key), error.reason) from None


def _says_hamilton(file: TomlTable) -> bool:
    for key in file.value(("conventions",), dict, {}):
        if key in ("arguments", "functions") or file.text(("conventions", key)) in CONVENTIONS.get(key, ()):
            continue
        known = (f"{name} = " + " or ".join(f'"{each}"' for each in may) for name, may in CONVENTIONS.items())
        message = f"conventions: expected {', '.join(known)}, arguments = […] or functions = […]"
        raise file.error_at_key(("conventions", key), message)
    return "quaternion" in file.value(("conventions",), dict, {})


def _arguments(files: Sequence[TomlTable]) -> frozenset[Name]:
    """Returns the arguments that only state a dependence; with q, its rates are included."""
    found = set()
    for file in files:
        for index, text in enumerate(file.texts(("conventions", "arguments"))):
            try:
                found.add(read_key(_DOTS.sub("", text))[0])
            except SpecError as error:
                at = ("conventions", "arguments", index)
                raise file.error_at_value(at, f"arguments: {error}") from None
    return frozenset(found)


def _words(files: Sequence[TomlTable]) -> frozenset[str]:
    r"""Returns the functions that a text writes as letters: cos for \cos."""
    found = set()
    for file in files:
        for index, word in enumerate(file.texts(("conventions", "functions"))):
            if word not in FUNCTIONS:
                message = f"functions: expected some of {', '.join(FUNCTIONS)}, got {word!r}"
                raise file.error_at_value(("conventions", "functions", index), message)
            found.add(word)
    return frozenset(found)


def _convention(files: Sequence[TomlTable], key: str) -> str | None:
    """Returns the value of a convention; the last file that has one counts."""
    found = [text for file in files if (text := file.text(("conventions", key))) is not None]
    return found[-1] if found else None


def _in_scope(files: Sequence[TomlTable], scopes: Sequence[TomlTable]) -> Iterator[_Entry]:
    """Yields the definitions; those of the last scope replace others of the same key."""
    found = {key: (file, key, body) for file, key, body in _entries(files, "definitions")}
    for scope in scopes:
        for key in scope.value(("symbols",), dict, {}):
            found.pop(key, None)
        found |= {key: (file, key, body) for file, key, body in _entries([scope], "definitions")}
    yield from found.values()


def _entries(files: Sequence[TomlTable], table: str) -> Iterator[_Entry]:
    for file, keys in _keys(files, table):
        for key in keys:
            yield file, key, present_text(file, (table, key))


def _keys(files: Sequence[TomlTable], table: str) -> Iterator[tuple[TomlTable, list[str]]]:
    owners: dict[str, TomlTable] = {}
    for file in files:
        keys = list(file.value((table,), dict, {}))
        for key in keys:
            if key in owners and key != CLAIMS:
                message = f"{key} stands in [{table}] of {owners[key].path.name} too"
                raise file.error_at_key((table, key), message)
            owners[key] = file
        yield file, keys


def _definition(file: TomlTable, key: str, body: str, table: SymbolTable) -> tuple[Definition, SymbolTable]:
    path = ("definitions", key)
    try:
        return _read(key, body, table)
    except SpecError as error:
        raise file.error_at_key(path, error.reason) from None
    except (ReadError, IllFormedAt) as error:
        message = SyntaxCode.FAULT_OF_KEY(key=key, message=error.message)
        raise file.error_in_string(path, error.line, error.column, message) from None


def _read(key: str, body: str, table: SymbolTable) -> tuple[Definition, SymbolTable]:
    return or_respelled(body, (), lambda text: read_definition(key, text, table))
