"""The model of a text: `paper.toml` with `source = "paper.tex"`, or comments in the text."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from workbench.context.claims import Notation
from workbench.core.codes.model_codes import ModelCode
from workbench.core.names import Name
from workbench.core.paper_errors import KeyPath, PaperError
from workbench.core.schema import key_names
from workbench.language.naming.declarations import read_key
from workbench.language.naming.spelling import INDEX_LETTERS
from workbench.papers.notation_tables import notation_of
from workbench.papers.reading_stages import ErrorLog, Stage, stage
from workbench.source.documents import Directive, Display, Text
from workbench.source.documents.surrounding_words import headings
from workbench.source.toml.toml_file import TomlFile, present_text

T = TypeVar("T")

MODEL_KEYS = key_names("model")
CLAIM_KEYS = key_names("claim of a model")
_SCOPE_KEYS = key_names("scope")
_CLAIM_KEY = re.compile(rf"\s*({'|'.join(CLAIM_KEYS)})\s*=")
_LINE = re.compile(r"line\s+(\d+)")


@dataclass(frozen=True)
class Table:
    """A table inside of a TOML file, which is read like a file."""

    toml: TomlFile
    prefix: KeyPath

    @property
    def path(self) -> Path:
        return self.toml.path

    def of(self, file: TomlFile) -> Table:
        """Returns the same table of a view of the file."""
        return replace(self, toml=file)

    def value(self, path: KeyPath, expected: type, default: Any = None) -> Any:
        return self.toml.value((*self.prefix, *path), expected, default)

    def text(self, path: KeyPath) -> str | None:
        return self.toml.text((*self.prefix, *path))

    def texts(self, path: KeyPath) -> tuple[str, ...]:
        return self.toml.texts((*self.prefix, *path))

    def error_at_key(self, path: KeyPath, message: str) -> PaperError:
        return self.toml.error_at_key((*self.prefix, *path), message)

    def error_at_value(self, path: KeyPath, message: str) -> PaperError:
        return self.toml.error_at_value((*self.prefix, *path), message)

    def error_in_string(self, path: KeyPath, line: int, column: int, message: str) -> PaperError:
        return self.toml.error_in_string((*self.prefix, *path), line, column, message)

    def error_in_key(self, path: KeyPath, line: int, column: int, message: str) -> PaperError:
        return self.toml.error_in_key((*self.prefix, *path), line, column, message)


@dataclass(frozen=True)
class Entry:
    """An entry of the model for one claim or display.

    Attributes:
        at: A label, number, id, or "line N"; for a comment in the text, the display that it precedes or is
            in.
    """

    table: Table
    at: str | Display


@dataclass
class TextModel:
    """The content of a model.

    Attributes:
        chain: The notation files.
        scopes: Redeclarations from a display on: its index, the table, and the file and line where it begins.
        guessed: Symbols whose kinds are unconfirmed.
        faults: Entries of the model that cannot be used.
    """

    chain: list[TomlFile] = field(default_factory=list)
    scopes: list[tuple[int, Table, tuple[Path, int]]] = field(default_factory=list)
    guessed: tuple[str, ...] = ()
    entries: list[Entry] = field(default_factory=list)
    faults: ErrorLog = field(default_factory=ErrorLog)
    _made: list[tuple[int, Notation]] | None = None

    def notations(self) -> list[tuple[int, Notation]]:
        """Returns the notations, each with the index of the display from which on it holds. Raises
        PaperError."""
        if self._made is None:
            self._made = self._notations()
        return self._made

    def _notations(self) -> list[tuple[int, Notation]]:
        made: list[tuple[int, Notation]] = []
        for count in range(len(self.scopes) + 1):
            start = self.scopes[count - 1][0] if count else 0
            tables = [table for _, table, _ in self.scopes[:count]]
            notation = self.faults.past(self._notation(tables))
            if notation is not None:
                made.append((start, self._with_places(notation, count)))
        if len(made) <= len(self.scopes):
            self.faults.stop()
        return made

    def _notation(self, tables: Sequence[Table]) -> Stage[Notation]:
        """Returns the notation of the chain with these scopes."""

        def read(*files: TomlFile) -> Notation:
            count = len(self.chain)
            scopes = [table.of(file) for table, file in zip(tables, files[count:], strict=True)]
            return notation_of(files[:count], scopes)

        return stage(read, *self.chain, *(table.toml for table in tables))

    def _with_places(self, notation: Notation, count: int) -> Notation:
        """Returns the notation of the first `count` scopes, with the positions where they redeclare
        symbols."""
        since: dict[Name, tuple[Path, int]] = {}
        for _, table, place in self.scopes[:count]:
            keys = [key for part in ("symbols", "definitions") for key in table.value((part,), dict, {})]
            names = [read_key(key, letters)[0] for key in keys for letters in (INDEX_LETTERS, frozenset())]
            since |= dict.fromkeys(names, place)
        return replace(notation, since=since)


def with_entries(read: Callable[[Sequence[Entry]], T], entries: Sequence[Entry]) -> Stage[T]:
    """Returns what `read` makes of the entries, without the keys at fault."""

    def of(*files: TomlFile) -> T:
        views = zip(entries, files, strict=True)
        return read([replace(entry, table=entry.table.of(file)) for entry, file in views])

    return stage(of, *(entry.table.toml for entry in entries))


def read_entries(toml: TomlFile, faults: ErrorLog) -> list[Entry]:
    """Returns the [[claim]] tables that state their position."""
    entries = []
    for index in range(len(faults.past(stage(lambda file: file.tables(("claim",)), toml)) or ())):
        path = ("claim", index)
        faults.past(stage(partial(TomlFile.allow_keys, path=path, allowed=CLAIM_KEYS), toml))
        places = faults.past(stage(partial(_places, path=path), toml)) or ()
        entries += [Entry(Table(toml, path), at) for at in places]
    return entries


def _places(toml: TomlFile, path: KeyPath) -> Sequence[str]:
    at = toml.value(path, dict).get("at")
    if at is None:
        raise toml.error_at_key(path, ModelCode.MISSING_PLACE(key="at"))
    places = toml.texts((*path, "at")) if isinstance(at, list) else (present_text(toml, (*path, "at")),)
    if not places:
        raise toml.error_at_value((*path, "at"), "at: expected a place, or a list of places, got none")
    return places


def read_scopes(toml: TomlFile, text: Text, model: TextModel) -> None:
    """Adds the [[scope]] tables to the model, each from its position on."""
    for index in range(len(model.faults.past(stage(lambda file: file.tables(("scope",)), toml)) or ())):
        path = ("scope", index)
        model.faults.past(stage(partial(TomlFile.allow_keys, path=path, allowed=_SCOPE_KEYS), toml))
        place = model.faults.past(stage(partial(_start, path=path, text=text), toml))
        if place is not None:
            model.scopes.append((place, Table(toml, path), _beginning(place, text.displays)))
    model.scopes.sort(key=lambda scope: scope[0])


def _start(toml: TomlFile, path: KeyPath, text: Text) -> int:
    start = toml.text((*path, "from"))
    if start is None:
        raise toml.error_at_key(path, ModelCode.MISSING_START(key="from"))
    place = place_of(start, text.displays)
    place = text.starts.get(start) if place is None else place
    place = _behind_line(start, text.displays) if place is None else place
    if place is None or place >= len(text.displays):
        raise toml.error_at_value((*path, "from"), f"from: the text has no {start!r}")
    return place


def _beginning(place: int, displays: Sequence[Display]) -> tuple[Path, int]:
    """Returns the file and line from which a scope is in force that begins with this display.

    That is the end of the display before it, or the last heading between them.
    """
    first = displays[place]
    source = first.source
    before = [each.end for each in displays[:place] if each.source.path == source.path]
    starts = [start for start, _ in headings(source.prose) if start < first.start]
    at = max([0, *before, *starts])
    return source.path, source.place(at)[0] + (at in before)


def _behind_line(name: str, displays: Sequence[Display]) -> int | None:
    """Returns the first display that ends after the line, in the file of the first display."""
    if (match := _LINE.fullmatch(name)) is None or not displays:
        return None
    path, line = displays[0].source.path, int(match[1])
    ends = ((p, d.source.place(d.end)[0]) for p, d in enumerate(displays) if d.source.path == path)
    return next((place for place, end in ends if end > line), None)


def place_of(name: str, displays: Sequence[Display]) -> int | None:
    """Returns the first display that the name denotes: by label, number, section or line."""
    tests: tuple[Callable[[Display], bool], ...] = (
        lambda display: name in display.labels,
        lambda display: name.strip("()") in display.numbers,
        lambda display: bool(name) and name in (display.section, display.heading),
    )
    if match := _LINE.fullmatch(name):
        line = int(match[1])
        return next((index for index, display in enumerate(displays) if _covers(display, line)), None)
    for test in tests:
        if (found := next((p for p, d in enumerate(displays) if test(d)), None)) is not None:
            return found
    return None


def _covers(display: Display, line: int) -> bool:
    return display.line <= line <= display.source.place(display.end)[0]


def read_directives(directives: Sequence[Directive], displays: Sequence[Display], model: TextModel) -> None:
    """Reads comments `%! workbench: key = value`: for the notation, or for the next display."""
    notation: dict[Path, dict[int, str]] = {}
    for directive in directives:
        line, column = directive.source.place(directive.start)
        text = directive.source.line(line)
        at = text.find(directive.text, column - 1)
        payload = " " * at + directive.text
        if _CLAIM_KEY.match(directive.text):
            content = "\n" * (line - 1) + payload
            toml = model.faults.past(stage(partial(TomlFile, directive.source.path, content)))
            display = _following(directive, displays)
            if display is None:
                message = "no display follows this comment"
                model.faults.tell(PaperError(directive.source.path, line, column, message))
            elif toml is not None:
                model.faults.past(stage(lambda file: file.allow_keys((), CLAIM_KEYS), toml))
                model.entries.append(Entry(Table(toml, ()), display))
        else:
            notation.setdefault(directive.source.path, {})[line] = payload
    for path, lines in notation.items():
        text = "\n".join(lines.get(number, "") for number in range(1, max(lines) + 1))
        toml = TomlFile(path, text)
        known = key_names("directive")
        model.faults.past(stage(partial(TomlFile.allow_keys, path=(), allowed=known), toml))
        model.chain.append(toml)


def _following(directive: Directive, displays: Sequence[Display]) -> Display | None:
    behind = (d for d in displays if d.source.path == directive.source.path and d.end > directive.start)
    return next(iter(sorted(behind, key=lambda display: display.start)), None)


def names_of(displays: Sequence[Display]) -> Iterator[str]:
    """Yields every name of a display of the text, for messages."""
    for display in displays:
        yield from display.labels
        yield from display.numbers
