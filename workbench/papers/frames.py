"""[frames] and [points]: what {}^A ω^B, {}^A R_B and r^{P/O} are, by definitions over symbols of our own.

Each frame has an orientation Q (I for the base), an angular velocity w = vect(Q̇ Qᵀ) and an origin o; each
point a place p. These families are just what frames and points can do, so that what is proved by them holds,
and what they refute is false. Written in columns of the base:

    rotation to F from G    Q_Fᵀ Q_G           angular velocity of G in F    w_G − w_F
    to P from O             p_P − p_O          derivative in F               ẋ − w_F × x
    axes of F               Q_F e₁, Q_F e₂, Q_F e₃
    P fixed in F            p_P = o_F + Q_F c, c constant
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import product
from typing import Any

from workbench.language.construct import apply, derivative, symbol, zero
from workbench.language.declarations import key_spelling
from workbench.language.errors import Fault, ReadError, SpecError
from workbench.language.names import Name
from workbench.language.reader import read_term
from workbench.language.spelling import Spelling, spell_label
from workbench.language.symbols import SymbolTable
from workbench.language.syntax import parse
from workbench.language.terms import Definition, IllFormed, Term, Zero
from workbench.language.types import TENSOR, VECTOR, Declaration, Type
from workbench.papers.toml_file import TomlFile

_FRAME_KEYS = ("base", "names", "axes", "dot", "orientation")
_POINT_KEYS = ("names", "fixed")


@dataclass
class Frames:
    """What the tables declare: the definitions, and the angular velocity of each frame."""

    base: str
    labels: tuple[str, ...]
    points: tuple[str, ...] = ()
    definitions: list[Definition] = field(default_factory=list)
    declarations: dict[Name, Declaration] = field(default_factory=dict)
    origins: dict[str, Term] = field(default_factory=dict)
    places: dict[str, Term] = field(default_factory=dict)
    given: dict[str, Term] = field(default_factory=dict)

    # the symbols behind them

    def orientation(self, frame: str) -> Term | None:
        """Q_F; None for the base, whose is I."""
        name = _own("Q", frame)
        if frame in self.given:
            return self.defined(name, TENSOR, self.given[frame])
        return None if frame == self.base else self.free(name, TENSOR, rotation=True)

    def spin(self, frame: str) -> Term:
        """w_F, which its orientation gives."""
        turn = self.orientation(frame)
        if turn is None:
            return zero(VECTOR)
        name = _own("w", frame)
        body = apply("vect", apply("mul", derivative(turn, 1), apply("transpose", turn)))
        return self.defined(name, VECTOR, body)

    def origin(self, frame: str) -> Term:
        if frame == self.base:
            return zero(VECTOR)
        if frame not in self.origins:
            self.origins[frame] = self.free(_own("o", frame), VECTOR)
        return self.origins[frame]

    def place(self, point: str) -> Term:
        if point not in self.places:
            self.places[point] = self.free(_own("p", point), VECTOR)
        return self.places[point]

    def fix(self, point: str, frame: str) -> None:
        """p = o_F + Q_F c. The first point that is fixed in a frame may be its origin."""
        if point in self.places and frame in self.origins:
            raise SpecError(
                f"{point} closes a loop of frames; that is no family that can be written down", "fixed"
            )
        if point in self.places:
            self.origins[frame] = self.places[point]
        elif frame not in self.origins and frame != self.base:
            self.places[point] = self.origin(frame)
        else:
            offset = self.free(_own("c", point), VECTOR, constant=True)
            self.places[point] = plus(self.origin(frame), turned(self.orientation(frame), offset))

    def free(self, name: Name, type_: Type, **flags: bool) -> Term:
        if name not in self.declarations:
            self.declarations[name] = Declaration(name, type_, **flags)
        return symbol(self.declarations[name], ())

    def defined(self, name: Name, type_: Type, body: Term) -> Term:
        if name not in self.declarations:
            self.declarations[name] = Declaration(name, type_)
            self.definitions.append(Definition(self.declarations[name], (), (), body))
        return symbol(self.declarations[name], ())

    # what the texts write

    def angular_velocity(self, of: str, seen_from: str) -> Term:
        return minus(self.spin(of), self.spin(seen_from))

    def rate(self, frame: str, body: Term) -> Term:
        spin = self.spin(frame)
        rate = derivative(body, 1)
        return rate if isinstance(spin, Zero) else minus(rate, apply("cross", spin, body))

    def velocity(self, point: str, frame: str) -> Term:
        return self.rate(frame, minus(self.place(point), self.origin(frame)))

    def resolved(self, frame: str, body: Term) -> Term:
        turn = self.orientation(frame)
        return body if turn is None else apply("mul", apply("transpose", turn), body)


def minus(one: Term, other: Term) -> Term:
    if isinstance(other, Zero):
        return one
    negative = apply("neg", other)
    return negative if isinstance(one, Zero) else apply("add", one, negative)


def plus(one: Term, other: Term) -> Term:
    return other if isinstance(one, Zero) else apply("add", one, other)


def turned(turn: Term | None, body: Term) -> Term:
    return body if turn is None else apply("mul", turn, body)


def _rotation(frames: Frames, to: str, origin: str) -> Term:
    one, other = frames.orientation(to), frames.orientation(origin)
    if one is None or one == other:
        return apply("mul", apply("transpose", one), one) if one is not None and one == other else other
    return apply("transpose", one) if other is None else apply("mul", apply("transpose", one), other)


#: What a spelling may be said to be → its kind, which of its letters are frames, and what it is.
_PHRASES: tuple[tuple[str, Type, str, Callable[..., Term]], ...] = (
    (r"rotation to (?P<F>\w) from (?P<G>\w)", TENSOR, "FG", lambda f, F, G: _rotation(f, F, G)),
    (r"angular velocity of (?P<G>\w) in (?P<F>\w)", VECTOR, "FG", lambda f, F, G: f.angular_velocity(G, F)),
    (
        r"angular acceleration of (?P<G>\w) in (?P<F>\w)",
        VECTOR,
        "FG",
        lambda f, F, G: f.rate(F, f.angular_velocity(G, F)),
    ),
    (r"to (?P<P>\w) from (?P<Q>\w)", VECTOR, "", lambda f, P, Q: minus(f.place(P), f.place(Q))),
    (r"velocity of (?P<P>\w) in (?P<F>\w)", VECTOR, "F", lambda f, P, F: f.velocity(P, F)),
    (r"acceleration of (?P<P>\w) in (?P<F>\w)", VECTOR, "F", lambda f, P, F: f.rate(F, f.velocity(P, F))),
)
_RESOLVED = re.compile(r",? resolved in (?P<R>\w)$")


def framed(files: Sequence[TomlFile], table: SymbolTable) -> tuple[SymbolTable, list[Definition]]:
    """The table with what [frames] and [points] declare, and its definitions. Raises PaperError."""
    entries: dict[str, dict[str, Any]] = {"frames": {}, "points": {}}
    owners: dict[tuple[str, str], TomlFile] = {}
    for file in files:
        for table_name, found in entries.items():
            found |= file.value((table_name,), dict, {})
            owners |= dict.fromkeys(((table_name, key) for key in file.value((table_name,), dict, {})), file)
    if not owners:
        return table, []
    try:
        return _Reader(entries["frames"], entries["points"], table).read()
    except SpecError as error:
        place = next(
            ((name, error.key) for name in entries if (name, error.key) in owners), next(iter(owners))
        )
        raise owners[place].error_at_key(place, str(error)) from None


class _Reader:
    def __init__(self, frames: Mapping[str, Any], points: Mapping[str, Any], table: SymbolTable) -> None:
        self.table = table
        self.entries = {"frames": frames, "points": points}
        base = frames.get("base")
        if not isinstance(base, str):
            raise SpecError("[frames] needs base = …, the frame that the others move in", "base")
        names = (base, *_names(frames))
        self.frames = Frames(label(base), tuple(dict.fromkeys(label(name) for name in names)))
        self.frames.points = tuple(label(name) for name in _names(points))

    def read(self) -> tuple[SymbolTable, list[Definition]]:
        frames = self.frames
        for frame, text in _table(self.entries["frames"], "orientation").items():
            self.known(label(frame), frames.labels, "orientation")
            frames.given[label(frame)] = self.term(text)
        for point, fixed in _table(self.entries["points"], "fixed").items():
            self.known(label(point), frames.points, "fixed")
            for frame in [fixed] if isinstance(fixed, str) else fixed:
                self.known(label(frame), frames.labels, "fixed")
                frames.fix(label(point), label(frame))
        spins = {frame: frames.spin(frame) for frame in frames.labels}
        for entry in ("frames", "points"):
            reserved = _FRAME_KEYS if entry == "frames" else _POINT_KEYS
            for key, phrase in self.entries[entry].items():
                if key not in reserved:
                    self.spelling(key, phrase)
        for frame, axes in _table(self.entries["frames"], "axes").items():
            self.axes(label(frame), axes)
        dot = self.entries["frames"].get("dot")
        if dot is not None:
            self.known(label(str(dot)), frames.labels, "dot")
        for declaration in frames.declarations.values():
            if self.table.symbols.get(declaration.name) is declaration:
                continue
            if declaration.name in self.table.symbols:
                raise SpecError("this symbol is known already", str(declaration.name))
            self.table = self.table.with_symbol(declaration)
        defined = {definition.declaration.name: ((),) for definition in frames.definitions}
        table = replace(
            self.table,
            frames=spins,
            dot=None if dot is None else label(dot),
            defined={**self.table.defined, **defined},
        )
        return table, frames.definitions

    def term(self, text: Any) -> Term:
        """Q of a frame, in columns of the base, where the text says what it is."""
        try:
            term = read_term(str(text), self.table)
        except (ReadError, IllFormed) as error:
            raise SpecError(str(error), "orientation") from None
        if term.type != TENSOR:
            raise SpecError(f"expected a tensor, got a {term.type}", "orientation")
        return term

    def known(self, name: str, names: Sequence[str], key: str) -> None:
        if name not in names:
            raise SpecError(f"{name} is not among the names {', '.join(names)}", key)

    def spelling(self, key: str, phrase: Any) -> None:
        """One definition for each choice of frames and points in the places of the letters."""
        if phrase == "derivative":
            return
        text = phrase if isinstance(phrase, str) else ""
        resolved = _RESOLVED.search(text)
        phrases = ((re.fullmatch(entry[0], _RESOLVED.sub("", text)), *entry[1:]) for entry in _PHRASES)
        match, type_, in_frames, make = next(
            (entry for entry in phrases if entry[0]), (None, VECTOR, "", minus)
        )
        if match is None:
            known = "; ".join(re.sub(r"\(\?P<(\w)>\\w\)", r"\1", pattern) for pattern, *_ in _PHRASES)
            raise SpecError(f"{phrase!r}; expected derivative, or one of: {known}; [, resolved in F]", key)
        if resolved is not None and type_ is not VECTOR:
            raise SpecError("only a vector is resolved in a frame", key)
        letters = {match[role]: role for role in match.groupdict()}
        spelling = _spelling(key)
        texts = {piece for _, pieces in spelling.scripts for piece in pieces} | {spelling.letter.letter}
        where = resolved["R"] if resolved else None
        names = [*letters, *([where] if where and where not in letters else [])]
        choices = []
        for letter in names:
            known = (
                self.frames.labels if letters.get(letter, "R") in (*in_frames, "R") else self.frames.points
            )
            if letter not in texts and letter not in known:
                raise SpecError(f"{letter} does not stand in it", key)
            choices.append(known if letter in texts else (letter,))  # ω for the ω of B in A
        for chosen in product(*choices):
            given = dict(zip(names, chosen, strict=True))
            arguments = {role: given[letter] for letter, role in letters.items()}
            if len(letters) > 1 and len(set(arguments.values())) < 2:
                continue  # {}^A ω^A
            name = spelling.exchanged(given).exact
            body = make(self.frames, **arguments)
            if where is not None:
                body = self.frames.resolved(given[where], body)
            if name not in self.table.symbols:
                self.frames.defined(name, type_, body)

    def axes(self, frame: str, axes: Any) -> None:
        self.known(frame, self.frames.labels, frame)
        if not isinstance(axes, list) or len(axes) != 3:
            raise SpecError(f"expected its three axes, got {axes!r}", frame)
        for place, key in enumerate(axes):
            body = turned(self.frames.orientation(frame), _unit(place))
            name = _spelling(key).exact
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


def _own(letter: str, label: str) -> Name:
    """Of the symbols behind the author's."""
    return Name(letter, ("\\mathsf",), sub=(label,))


def _spelling(key: str) -> Spelling:
    try:
        return key_spelling(parse(key).lines[0][0], key)
    except Fault as fault:
        raise SpecError(f"column {fault.at + 1}: {fault}", key) from None


def label(text: str) -> str:
    """A label as names have it: B_{c} for B_c."""
    try:
        found = spell_label(parse(text).lines[0][0])
    except (Fault, IndexError):
        found = None
    if found is None:
        raise SpecError("expected a label such as A or B_c", text)
    return found
