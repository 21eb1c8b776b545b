"""Reader of [frames] and [points]: the spellings of the quantities of `frame_families`."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from itertools import product
from typing import Any, NamedTuple

from workbench.core.construct import apply, block, identity, zero
from workbench.core.formula_errors import Fault, ReadError, SpecError
from workbench.core.names import Name
from workbench.core.properties import PROPERTIES
from workbench.core.schema import key_names
from workbench.core.terms import Definition, IllFormed, Term
from workbench.core.types import TENSOR, VECTOR, Declaration
from workbench.language.definitions import Definitions
from workbench.language.grammar.parser import parse
from workbench.language.naming.declarations import key_spelling
from workbench.language.naming.known_frames import KnownFrames
from workbench.language.naming.spelling import Spelling, in_bracket, spell_label, under_accent
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read_term
from workbench.papers.declared_properties import unseen
from workbench.papers.frame_families import PHRASES, RESOLVED_IN_F, Frames, plus, turned
from workbench.source.toml.toml_file import TomlTable

_FRAME_KEYS = key_names("frames")
#: The meanings of {}^F\dot{x} of a resolved vector.
_RATES = ("resolved", "of components")
_POINT_KEYS = key_names("points")
#: The beginnings of phrases about points.
_PLACES = ("to", "origin", "place")
_OF_COMPONENTS = rf"resolved in|^(?:rotation|transform|{'|'.join(RESOLVED_IN_F)})"
_RESOLVED = re.compile(r",? resolved in (?P<R>\w)$")


class Turn(NamedTuple):
    """A matrix that a file gives for the orientation of a frame."""

    file: TomlTable
    frame: str
    matrix: Term


def require_rotations(turns: Sequence[Turn], definitions: Definitions) -> None:
    """Raises PaperError for a matrix that is not proved to be a rotation wherever it is defined."""
    for turn in turns:
        if (why := unseen(PROPERTIES["rotation"].statement_of(turn.matrix), definitions)) is not None:
            message = f"orientation: that of {turn.frame} is not seen to be a rotation: {why}"
            raise turn.file.error_at_key(("frames", "orientation"), message)


def frame_labels(files: Sequence[TomlTable]) -> frozenset[str]:
    """Returns the labels of frames and points in [frames] and [points], if these are lists of texts."""
    found = [file.value((table, "names"), list, []) for file in files for table in ("frames", "points")]
    bases = [file.value(("frames", "base"), str, "") for file in files]
    return frozenset(label for labels in (*found, bases) for label in labels if isinstance(label, str))


def framed(
    files: Sequence[TomlTable], table: SymbolTable
) -> tuple[SymbolTable, list[Definition], list[Turn]]:
    """Returns the table with the declarations of [frames] and [points], its definitions, and the
    orientations.

    Raises:
        PaperError: An entry cannot be used.
    """
    entries: dict[str, dict[str, Any]] = {"frames": {}, "points": {}}
    owners: dict[tuple[str, str], TomlTable] = {}
    for file in files:
        for table_name, found in entries.items():
            found |= file.value((table_name,), dict, {})
            owners |= dict.fromkeys(((table_name, key) for key in file.value((table_name,), dict, {})), file)
    if not owners:
        return table, [], []
    try:
        reader = _Reader(entries["frames"], entries["points"], table)
        known, definitions = reader.read()
        turns = [Turn(owners["frames", "orientation"], *turn) for turn in reader.turns.items()]
        return known, definitions, turns
    except SpecError as error:
        place = next(
            ((name, error.key) for name in entries if (name, error.key) in owners), next(iter(owners))
        )
        raise owners[place].error_at_key(place, str(error)) from None


class _Reader:
    def __init__(self, frames: Mapping[str, Any], points: Mapping[str, Any], table: SymbolTable) -> None:
        self.table = table
        self.entries = {"frames": frames, "points": points}
        self.turns: dict[str, Term] = {}  # frame → its given matrix
        self.resolved: dict[Name, tuple[str, Term]] = {}  # {}^F x → F and x
        base = frames.get("base")
        if not isinstance(base, str):
            raise SpecError("[frames] needs base = …, the frame that the others move in", "base")
        names = (base, *_names(frames))
        self.frames = Frames(label(base), tuple(dict.fromkeys(label(name) for name in names)))
        self.frames.points = tuple(label(name) for name in _names(points))

    def read(self) -> tuple[SymbolTable, list[Definition]]:
        frames = self.frames
        orientations = _table(self.entries["frames"], "orientation")
        for index, (frame, said) in enumerate(orientations.items()):
            self.known(label(frame), frames.labels, "orientation")
            later = {label(other) for other in list(orientations)[index:]}
            frames.given[label(frame)] = self.orientation(label(frame), said, later)
        phrases = [
            str(said)
            for table in self.entries.values()
            for key, said in table.items()
            if key not in (*_FRAME_KEYS, *_POINT_KEYS)
        ]
        has_components = any(re.search(_OF_COMPONENTS, said) for said in phrases)
        dot = self.entries["frames"].get("dot", frames.base if self.are_columns(phrases) else None)
        if dot is not None:
            self.known(label(str(dot)), frames.labels, "dot")
            if not has_components:
                self.keep_constants(label(dot))
        fixed = _table(self.entries["points"], "fixed")
        for point, carriers in fixed.items():
            self.known(label(point), frames.points, "fixed")
            for frame in [carriers] if isinstance(carriers, str) else carriers:
                self.known(label(frame), frames.labels, "fixed")
                frames.fix(label(point), label(frame))
        placed = _table(self.entries["points"], "place")
        for point in placed:
            self.known(label(point), frames.points, "place")
            frames.put(label(point))
        spins = {frame: frames.spin(frame) for frame in frames.labels}
        for entry in ("frames", "points"):
            reserved = _FRAME_KEYS if entry == "frames" else _POINT_KEYS
            for key, phrase in self.entries[entry].items():
                if key not in reserved:
                    self.spelling(key, phrase)
        for frame, axes in _table(self.entries["frames"], "axes").items():
            self.axes(label(frame), axes)
        for at, (point, said) in enumerate(placed.items()):
            later = {label(other) for other in list(placed)[at:]}
            frames.define(label(point), self.placed(said, later))
        turns = {} if has_components else {frame: frames.orientation(frame) for frame in frames.labels}
        for declaration in frames.declarations.values():
            if self.table.symbols.get(declaration.name) is declaration:
                continue
            if declaration.name in self.table.symbols:
                raise SpecError("this symbol is known already", str(declaration.name))
            self.table = self.table.with_symbol(declaration)
        defined = {each.declaration.name: (each.index,) for each in frames.definitions}
        table = replace(
            self.table,
            frames=KnownFrames(
                velocities=spins,
                orientations={frame: identity() if turn is None else turn for frame, turn in turns.items()},
                dot=None if dot is None else label(dot),
                resolved=self.rates(),
                constant=self.table.frames.constant,
                directions=frozenset(frames.directions),
                places=dict(frames.places),
                fixed=frozenset(map(label, fixed)),
            ),
            defined=replace(self.table.defined, members={**self.table.defined.members, **defined}),
        )
        return table, frames.definitions

    def rates(self) -> dict[Name, tuple[Term, Term] | None]:
        """Returns the rates as KnownFrames has them; empty if the frame in which a dot differentiates is
        unknown."""
        dot, said = (self.entries["frames"].get(key) for key in ("dot", "rates"))
        if said is not None and said not in _RATES:
            raise SpecError(f"expected {' or '.join(map(repr, _RATES))}, got {said!r}", "rates")
        if dot is None or said == "of components":
            return {}
        others = {name: each for name, each in self.resolved.items() if each[0] != label(str(dot))}
        if said is None:
            return dict.fromkeys(others)
        made: dict[Name, tuple[Term, Term] | None] = {}
        for name, (frame, vector) in others.items():
            turn = self.frames.orientation(frame)
            made[name] = identity() if turn is None else apply("transpose", turn), vector
        return made

    def keep_constants(self, dot: str) -> None:
        """Gives constant vectors and tensors a zero rate in the frame of the dot."""
        if dot == self.frames.base:
            return
        moved = {
            declaration.name: self.frames.kept(declaration, dot)
            for declaration in dict.fromkeys(self.table.symbols.values())
            if declaration.constant and declaration.type in (VECTOR, TENSOR)
        }
        symbols = {name: moved.get(own.name, own) for name, own in self.table.symbols.items()}
        known = replace(self.table.frames, constant=frozenset(moved))
        self.table = replace(self.table, symbols=symbols, frames=known)

    def are_columns(self, phrases: Sequence[str]) -> bool:
        """True if all vectors are columns of components, whose dot needs no frame."""
        known = [
            phrase
            for phrase in phrases
            if any(re.fullmatch(p, _RESOLVED.sub("", phrase)) for p, *_ in PHRASES)
        ]
        resolved = [phrase for phrase in phrases if re.search(_OF_COMPONENTS, phrase)]
        return known == resolved == phrases and "axes" not in self.entries["frames"] and bool(phrases)

    def orientation(self, frame: str, said: Any, later: Collection[str]) -> Term:
        """Returns the given orientation Q of a frame in components of the base: a matrix, a frame with a
        matrix, or three axes."""
        texts = said if isinstance(said, list) else [said]
        if not all(isinstance(text, str) for text in texts) or len(texts) > 3:
            raise SpecError("expected a matrix, [frame, matrix] or three axes", "orientation")
        try:
            terms = [read_term(text, self.table) for text in (texts[1:] if len(texts) == 2 else texts)]
            turn = block([terms]) if len(texts) == 3 else terms[0]
        except (ReadError, IllFormed) as error:
            raise SpecError(str(error), "orientation") from None
        if turn.type != TENSOR:
            raise SpecError(f"expected a tensor, got a {turn.type}", "orientation")
        self.turns[frame] = turn
        if len(texts) != 2:
            return turn
        self.known(label(texts[0]), self.frames.labels, "orientation")
        if label(texts[0]) in later:
            raise SpecError(f"that of {texts[0]} is to be given before", "orientation")
        outer = self.frames.orientation(label(texts[0]))
        return turn if outer is None else apply("mul", outer, turn)

    def placed(self, said: Any, later: Collection[str]) -> Term:
        """Returns the given position p of a point: another point, and the vector from there."""
        if not isinstance(said, list) or len(said) != 2 or not all(isinstance(text, str) for text in said):
            raise SpecError("expected another point and the vector from there", "place")
        self.known(label(said[0]), self.frames.points, "place")
        start, unknown = self.frames.place(label(said[0])), [self.frames.place(point) for point in later]
        if any(part in unknown for part in start.walk()):
            raise SpecError(f"that of {said[0]} is to be given before", "place")
        table = self.table
        for declaration in self.frames.axes:
            if declaration.name not in table.symbols:
                table = table.with_symbol(declaration)
        try:
            shift = read_term(said[1], table)
        except (ReadError, IllFormed) as error:
            raise SpecError(str(error), "place") from None
        if shift.type != VECTOR:
            raise SpecError(f"expected a vector, got a {shift.type}", "place")
        return plus(start, shift)

    def known(self, name: str, names: Sequence[str], key: str) -> None:
        if name not in names:
            raise SpecError(f"{name} is not among the names {', '.join(names)}", key)

    def spelling(self, key: str, phrase: Any) -> None:
        """Adds one definition of the spelling for each choice of frames and points for its letters."""
        if phrase == "derivative":
            return
        text = phrase if isinstance(phrase, str) else ""
        resolved = _RESOLVED.search(text)
        what = _RESOLVED.sub("", text)
        phrases = ((re.fullmatch(entry[0], what), *entry[1:]) for entry in PHRASES)
        found = next((entry for entry in phrases if entry[0] is not None), None)
        match, type_, in_frames, make = found or (None, VECTOR, "", None)
        vector = None
        if match is None:
            vector = self.vector(what) if resolved else None
            if vector is None:
                known = "; ".join(re.sub(r"\(\?P<(\w)>\\w\)", r"\1", pattern) for pattern, *_ in PHRASES)
                said = f"{phrase!r}; expected derivative, or one of: {known}; [, resolved in F]"
                raise SpecError(f"{said}; or a vector resolved in F", key)
        if resolved is not None and type_ is not VECTOR:
            raise SpecError("only a vector is resolved in a frame", key)
        letters = {match[role]: role for role in match.groupdict()} if match else {}
        texts, named = _spelled(key)
        where = resolved["R"] if resolved else None
        if match is not None and resolved is None and text.startswith(RESOLVED_IN_F):
            where = match["F"]
        names = [*letters, *([where] if where and where not in letters else [])]
        choices = []
        for letter in names:
            is_frame = letters.get(letter, "R") in (*in_frames, "R")
            labels = self.frames.labels if is_frame else self.frames.points
            if letter not in texts and letter not in labels:
                raise SpecError(f"{letter} does not stand in it", key)
            choices.append(labels if letter in texts else (letter,))  # ω in "ω of B in A"
        for chosen in product(*choices):
            given = dict(zip(names, chosen, strict=True))
            arguments = {role: given[letter] for letter, role in letters.items()}
            is_zero = len(letters) > 1 and len(set(arguments.values())) < 2  # {}^A ω^A
            if is_zero and type_ is not VECTOR:
                continue
            name = named(given)
            body = vector or zero(VECTOR)
            if make is not None and not is_zero:
                body = make(self.frames, **arguments)
            if where is not None and not is_zero:
                body = self.frames.resolved(given[where], body)
                if vector is not None:
                    self.resolved[name] = given[where], vector
            if name not in self.table.symbols:
                self.frames.defined(name, type_, body)
            if text.split()[0] not in _PLACES:
                self.frames.directions.add(name)

    def vector(self, text: str) -> Term | None:
        """Returns the vector that a declared symbol or a formula denotes; None if it is none."""
        try:
            term = read_term(text, self.table)
        except (ReadError, IllFormed):
            return None
        return term if term.type == VECTOR else None

    def axes(self, frame: str, axes: Any) -> None:
        self.known(frame, self.frames.labels, frame)
        if not isinstance(axes, list) or len(axes) != 3:
            raise SpecError(f"expected its three axes, got {axes!r}", frame)
        for index, key in enumerate(axes):
            body = turned(self.frames.orientation(frame), _unit(index))
            name = _spelling(key).exact
            self.frames.directions.add(name)
            self.frames.axes.append(self.table.symbols.get(name) or Declaration(name, VECTOR))
            if (declared := self.table.symbols.get(name)) is None:
                self.frames.defined(name, VECTOR, body)
            else:
                self.frames.declarations[name] = declared
                self.frames.definitions.append(Definition(declared, (), (), body))


def _names(entries: Mapping[str, Any]) -> list[str]:
    names = entries.get("names", [])
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        raise SpecError(f"expected a list of labels, got {names!r}", "names")
    return names


def _table(entries: Mapping[str, Any], key: str) -> Mapping[str, Any]:
    found = entries.get(key, {})
    if not isinstance(found, Mapping):
        raise SpecError(f"expected a table, got {found!r}", key)
    return found


def _unit(place: int) -> Term:
    rows = " \\\\ ".join("1" if row == place else "0" for row in range(3))
    return read_term(f"\\begin{{bmatrix}} {rows} \\end{{bmatrix}}", SymbolTable())


def _spelled(key: str) -> tuple[set[Any], Callable[[Mapping[str, str]], Name]]:
    """Returns the labels in a spelling (including [BN]), and a function to its name with other labels."""
    spelling = _spelling(key)
    node = parse(key).lines[0][0]
    if (pair := in_bracket(node) or under_accent(node)) is not None:
        return set(pair.labels), lambda given: pair.exchanged(given).name
    texts = {piece for _, pieces in spelling.scripts for piece in pieces} | {spelling.letter.letter}
    return texts, lambda given: spelling.exchanged(given).exact


def _spelling(key: str) -> Spelling:
    try:
        return key_spelling(parse(key).lines[0][0], key)
    except Fault as fault:
        raise SpecError(f"column {fault.at + 1}: {fault}", key) from None


def label(text: str) -> str:
    """Returns a label in normal form: B_{c} for B_c."""
    try:
        found = spell_label(parse(text).lines[0][0])
    except (Fault, IndexError):
        found = None
    if found is None:
        raise SpecError("expected a label such as A or B_c", text)
    return found
