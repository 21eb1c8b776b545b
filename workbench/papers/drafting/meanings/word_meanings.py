"""Formulas that words give to a symbol: a velocity is a rate, a speed the size of one, a Jacobian of partial
derivatives."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain, combinations, permutations, product

from workbench.core.types import Type

#: The most coordinates of a Jacobian.
_MOST_COORDINATES = 4
_MASS = re.compile(r"[mM](?:_\{?\w+\}?)?")


@dataclass(frozen=True)
class Meaning:
    """A formula for a symbol that words give.

    Attributes:
        name, body: The symbol and the formula in LaTeX.
        why: The words.
        coordinates: Symbols that partial derivatives by one another keep fixed.
    """

    name: str
    body: str
    why: str
    coordinates: frozenset[str] = frozenset()


@dataclass(frozen=True)
class Subject:
    """A symbol that a formula gives for the first time.

    Attributes:
        words: The words before the display and beside the symbol in sentences.
        row: The row of the formula among those of its display for numbers; and how many these are.
    """

    name: str
    type: Type
    words: str
    row: tuple[int, int] = (0, 1)


@dataclass(frozen=True)
class Scene:
    """The quantities of a text.

    Attributes:
        types: Symbol → its type.
        defined: The symbols with a definition, in order.
        groups: The numbers that one display defines.
        moving: Numbers of which the text takes rates, or that it calls angles.
        uses: Defined symbol → the free symbols in its definitions.
    """

    types: Mapping[str, Type]
    defined: Sequence[str]
    groups: Sequence[tuple[str, ...]]
    moving: frozenset[str]
    uses: Mapping[str, frozenset[str]]

    @cached_property
    def columns(self) -> list[str]:
        """The vectors and the columns of numbers."""
        known = [(name, self.types[name]) for name in self.defined if name in self.types]
        return [name for name, own in known if own.kind == "vector" or (own.columns == 1 < own.rows)]

    @cached_property
    def rotations(self) -> list[str]:
        known = [name for name in self.defined if name in self.types and self.types[name].kind == "tensor"]
        return [name for name in known if re.search(r"[A-Z]", name)]

    @cached_property
    def masses(self) -> list[str]:
        return [name for name, own in self.types.items() if own.kind == "scalar" and _MASS.fullmatch(name)]


def _rate(name: str, order: int = 1) -> str:
    power = f"^{order}" if order > 1 else ""
    return rf"\frac{{d{power} {name}}}{{dt{power}}}"


def _rates(own: Subject, scene: Scene) -> Iterator[Meaning]:
    """Yields the rates of the defined symbols of the same type, those with the same label first."""
    label = own.name.partition("_")[2]
    same = [name for name in scene.defined if scene.types.get(name) == own.type and name != own.name]
    same.sort(key=lambda name: not (label and label.strip("{}") in name))
    for order in (1, 2, 3):
        for name in same:
            yield Meaning(own.name, _rate(name, order), "words call it a rate")
    along = [
        name for name in scene.columns if label and name.partition("_")[2].strip("{}") == label.strip("{}")
    ]
    for axis in along if own.type.kind == "scalar" else ():
        for order in (1, 2, 3):
            for name in scene.columns:
                body = rf"{_rate(name, order)} \cdot {axis}"
                yield Meaning(own.name, body, "words call it the component of a rate")


def _sizes(own: Subject, scene: Scene) -> Iterator[Meaning]:
    """Yields the size of the rate of each vector, and of each group of coordinates."""
    if own.type.kind != "scalar":
        return
    for square in _squares(scene):
        yield Meaning(own.name, rf"\sqrt{{{square}}}", "words call it a speed")


def _squares(scene: Scene) -> Iterator[str]:
    """Yields the square of the rate of each group of coordinates, and of each vector."""
    for group in scene.groups:
        yield " + ".join(rf"({_rate(name)})^2" for name in group)
    yield from (rf"\|{_rate(name)}\|^2" for name in scene.columns)


def _kinetic_energies(own: Subject, scene: Scene) -> Iterator[Meaning]:
    """Yields ½ m v² for each mass and velocity, and the sums of two of them."""
    one = [(m, rf"\frac{{1}}{{2}} {m} ({square})") for square in _squares(scene) for m in scene.masses]
    free = [(m, rf"\frac{{1}}{{2}} {m} ({_rate(name)})^2") for name in scene.moving for m in scene.masses]
    why = "words call it a kinetic energy"
    yield from (Meaning(own.name, body, why) for _, body in one)
    for (m, first), (other, second) in chain(combinations(one, 2), product(one, free)):
        if m != other:
            yield Meaning(own.name, f"{first} + {second}", why)


def _moments(own: Subject, scene: Scene) -> Iterator[Meaning]:
    """Yields m r × v and r × v for each vector, and their third component for two coordinates."""
    for mass in (*scene.masses, ""):
        if own.type.kind == "vector":
            for name in scene.columns:
                body = rf"{mass} {name} \times {_rate(name)}"
                yield Meaning(own.name, body, "words call it an angular momentum")
        for x, y in (group for group in scene.groups if len(group) == 2):
            body = rf"{mass} ({x} {_rate(y)} - {y} {_rate(x)})"
            yield Meaning(own.name, body, "words call it an angular momentum")


def _spins(own: Subject, scene: Scene) -> Iterator[Meaning]:
    """Yields the angular velocity of each defined rotation in both frames, and its components."""
    for name in scene.rotations:
        for body in (rf"\dot{{{name}}} {name}^T", rf"{name}^T \dot{{{name}}}"):
            spin = rf"\operatorname{{vect}}({body})"
            if own.type.kind == "vector":
                yield Meaning(own.name, spin, "words call it an angular velocity")
            elif own.type.kind == "scalar" and own.row[1] == 3:
                unit = " & ".join(str(int(at == own.row[0])) for at in range(3))
                yield Meaning(
                    own.name,
                    rf"\begin{{bmatrix}} {unit} \end{{bmatrix}} {spin}",
                    "words call it an angular velocity",
                )


def _jacobian(own: Subject, scene: Scene) -> Iterator[Meaning]:
    """Yields the partial derivatives of each group of numbers by the moving symbols in it."""
    rows, columns = own.type.rows, own.type.columns
    if own.type.kind not in ("matrix", "tensor") or columns > _MOST_COORDINATES:
        return
    for group in (group for each in scene.groups for group in combinations(each, rows)):
        free = sorted(set().union(*(scene.uses.get(name, frozenset()) for name in group)) & scene.moving)
        for chosen in combinations(free, columns):
            for order in permutations(chosen) if columns < 3 else (chosen,):
                cells = (
                    " & ".join(rf"\frac{{\partial {of}}}{{\partial {each}}}" for each in order)
                    for of in group
                )
                body = r"\begin{bmatrix} " + r" \\ ".join(cells) + r" \end{bmatrix}"
                yield Meaning(own.name, body, "words call it a Jacobian", frozenset(free))


Maker = Callable[[Subject, Scene], Iterator[Meaning]]
#: Words → the quantities that they call for.
_CUES: tuple[tuple[re.Pattern[str], Maker], ...] = (
    (re.compile(r"kinetic energ", re.IGNORECASE), _kinetic_energies),
    (re.compile(r"angular momentum|moment of (?:the )?momentum", re.IGNORECASE), _moments),
    (re.compile(r"\bspeed|magnitude of (?:the|its) velocity", re.IGNORECASE), _sizes),
    (re.compile(r"angular (?:velocit|rate)|body rates?|\brates?\b", re.IGNORECASE), _spins),
    (re.compile(r"jacobian|partial derivative", re.IGNORECASE), _jacobian),
    (
        re.compile(r"velocit|\brates?\b|differentia|derivative|accelerat|\bjerk|\bspeed", re.IGNORECASE),
        _rates,
    ),
)


def meanings_of(own: Subject, scene: Scene) -> Iterator[Meaning]:
    """Yields the formulas that the words about a symbol may give it."""
    for cue, make in _CUES:
        if cue.search(own.words):
            yield from make(own, scene)
