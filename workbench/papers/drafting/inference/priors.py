"""Prior costs of kinds: by the typeface of a symbol, its letter, and the words next to it."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from functools import cache

from workbench.core.types import type_of_kind
from workbench.papers.drafting.inference.kind_signatures import SCALAR, TENSOR, VECTOR, Kind
from workbench.papers.drafting.typefaces import Guess, GuessOrigin, without_bold
from workbench.papers.drafting.words_on_symbols import Prose

#: Typeface → costs of a scalar, a 3-vector, a 3×3 tensor, another column, another square matrix, any other
#: matrix, a quaternion.
FACES = {
    "bold small": (30, 0, 25, 9, 32, 35, 20),
    "bold capital": (35, 14, 0, 18, 8, 12, 40),
    "marked capital": (20, 2, 8, 18, 16, 20, 35),
    "tilde": (14, 5, 5, 16, 20, 25, 25),
    "turn": (25, 18, 0, 25, 8, 14, 35),
    "hat": (14, 0, 18, 14, 30, 35, 14),
    "marked": (9, 0, 25, 11, 30, 35, 12),
    "capital": (13, 16, 4, 18, 8, 12, 35),
    "energy": (6, 20, 9, 22, 10, 20, 40),
    "identity": (10, 40, 0, 50, 4, 60, 60),
    "unit": (14, 8, 30, 30, 40, 40, 0),
    "component": (0, 45, 42, 42, 40, 45, 60),
    "omega": (4, 0, 20, 12, 30, 30, 25),
    "greek": (0, 14, 30, 18, 36, 38, 30),
    "small": (0, 16, 32, 18, 36, 38, 22),
    "mass": (0, 35, 45, 40, 50, 50, 45),
    "position": (3, 4, 32, 14, 36, 38, 18),
    "coordinate": (0, 12, 32, 7, 36, 38, 22),
    "framed small": (10, 0, 25, 12, 30, 35, 20),
    "framed capital": (30, 6, 0, 15, 5, 10, 35),
    "script capital": (25, 14, 8, 6, 10, 16, 35),
    "word": (10, 20, 15, 20, 10, 12, 30),
}
#: Words next to a symbol → costs, in the same order.
SAID = {
    "scalar": (0, 40, 45, 45, 50, 50, 45),
    "vector": (35, 0, 35, 4, 40, 40, 10),
    "unit vector": (45, 0, 45, 10, 50, 50, 20),
    "tensor": (40, 35, 0, 25, 3, 4, 40),
    "inertia": (0, 45, 3, 45, 10, 40, 60),
    "rotation": (50, 45, 0, 45, 25, 40, 12),
    "transform": (50, 45, 25, 45, 0, 40, 40),
    "quaternion": (30, 14, 45, 2, 50, 50, 0),
    "hamilton quaternion": (25, 18, 40, 25, 45, 50, 0),
}
#: A component of a vector: its letter, with a digit or an axis below.
_PART = re.compile(r"(\\?[A-Za-z]+)_\{[0-3xyz]\}")
#: Words that determine no size.
KINDS_BY_WORDS = frozenset(SAID) - {"transform"}
#: The bonus of a kind that the text states explicitly.
_SURE = 40
#: The letters of joint spaces, and the bonus of a kind whose size is the number of joints.
_OF_JOINTS = re.compile(
    r"(?:\\(?:mathbf|boldsymbol)\{)?(?:[quJ]|\\theta|\\tau|\\boldsymbol\{\\(?:theta|tau))\}?(?:_\{.*)?|[MCBDHGg](?:_\{.*)?"
)
_OPEN = 9
#: The costs of a quaternion in a text that does not mention quaternions, and of a row.
_NO_QUATERNIONS, _ROW = 60, 14
#: The cost of a scalar s in a × (s a) or aᵀ s a.
_NO_MAP = 30

#: A word for a map of twists.
MAP_OF_TWISTS = re.compile(r"\\operatorname\{[aA]d\b")
_LEFT = re.compile(r"^\{\}(?:[_^]\{(?:[^{}]|\{[^{}]*\})*\})+")
_PREFIX = re.compile(r"^\\[Dd]elta[\s{]")
_COMPONENT = re.compile(
    r"_\{(?:[^{}]*_\{)?[ijkl][ ,]*[ijkl]\}+$|"
    r"_\{(?:[xyz]{1,2}|[0-9] ?[0-9]|[0-9],[0-9])\}$|^\\(?:Delta|delta)[\s{]"
)
_LIKENESS = re.compile(r"[_^]\{\\?[A-Za-z0-9]+(?:[ /,]*\\?[A-Za-z0-9]+)?\}|'+")


@cache
def face(name: str) -> str:
    """Returns the typeface of a name: a key of `FACES`."""
    inner = _LEFT.sub("", name)
    found = re.match(r"((?:\\[a-z]+\{)*)(\\?[A-Za-z]+)", _PREFIX.sub("", inner))
    marks, letter = (found[1], found[2]) if found else ("", inner)
    is_capital = letter.lstrip("\\")[:1].isupper()
    if "operatorname" in marks + letter:
        return "word"
    if not marks and _COMPONENT.search(inner):
        return "component"
    if "tilde" in marks:
        return "tilde"
    if re.search(r"mathbf|boldsymbol|mathsf", marks) and not re.search(r"hat|vec|bar|underline", marks):
        return "bold capital" if is_capital else "bold small"
    if re.search(r"vec|underline|overline|hat|bar", marks):
        return "marked capital" if is_capital else "hat" if "hat" in marks else "marked"
    if "mathcal" in marks and is_capital:
        return "script capital"
    if inner != name:
        return "framed capital" if is_capital else "framed small"
    return _plain_face(inner, letter, is_capital)


def _plain_face(inner: str, letter: str, is_capital: bool) -> str:
    if inner == "I":
        return "identity"
    if letter == "R":
        return "turn"
    if is_capital:
        return "energy" if re.match(r"[TVULHKEWP](?![A-Za-z])", letter) else "capital"
    if letter in ("\\omega", "\\alpha"):
        return "omega"
    if inner in ("q", "\\tau", "\\xi", "\\eta"):
        return "coordinate"
    if letter in ("p", "m"):
        return "position" if letter == "p" else "mass"
    return "greek" if letter.startswith("\\") else "small"


@cache
def likeness(name: str) -> str:
    """Returns the key that names share which are written alike: all but indices and labels."""
    return _LIKENESS.sub("", name)


def components_in(names: Collection[str]) -> frozenset[str]:
    """Returns the plain letters with a digit or an axis below of which the same letter stands in bold or
    under an arrow."""
    plain = {without_bold(name) for name in names if without_bold(name) != name}
    found = ((name, _PART.fullmatch(name)) for name in names)
    return frozenset(name for name, part in found if part is not None and part[1] in plain)


class Priors:
    """The prior costs of the kinds of a text's symbols.

    Attributes:
        functions: Letters before brackets.
        units: i, j and k, if they are those of quaternions.
        parted: Symbols whose scalar or vector part the text takes.
        maps: Symbols T of formulas with a × (T a) or aᵀ T a.
        components: Symbols as Ω_1 in a text with a bold Ω.
    """

    def __init__(
        self,
        prose: Prose,
        kinds: Sequence[Kind],
        functions: Collection[str],
        units: Collection[str] = (),
        parted: Collection[str] = (),
        maps: Collection[str] = (),
        components: Collection[str] = (),
    ) -> None:
        self.prose, self.kinds, self.functions = prose, kinds, functions
        self.units, self.parted, self.maps, self.components = units, parted, maps, components

    def is_said(self, name: str) -> bool:
        """True if words next to a symbol, or a set that it is in, state its kind."""
        said = self.prose.guess(name)
        return said is not None and said.is_said

    def of(self, name: str) -> dict[Kind, int]:
        """Returns the cost of each kind, the cheapest kind first."""
        has_quaternions = self.prose.has_quaternions or name in (*self.units, *self.parted)
        written = "unit" if name in self.units else "component" if name in self.components else face(name)
        by_shape, said = list(FACES[written]), self.prose.guess(name)
        if name in self.functions and written in ("capital", "energy"):
            by_shape[0], by_shape[1] = by_shape[0] + 12, by_shape[1] + 8
        sure: Kind | None = (6, 6) if MAP_OF_TWISTS.match(name) else None
        if said is not None and said.origin is not GuessOrigin.FORMULAS:
            words = _words(said)
            if words in SAID:
                by_shape = [cost // 4 + own for cost, own in zip(by_shape, SAID[words], strict=True)]
            exact = type_of_kind(words)
            if exact is not None and words not in KINDS_BY_WORDS:
                sure = (exact.rows, exact.columns)
        if name in self.parted:
            by_shape = [cost // 4 + own for cost, own in zip(by_shape, SAID["quaternion"], strict=True)]
        if name in self.maps:
            by_shape[0] += _NO_MAP
        by_shape[6] += 0 if has_quaternions else _NO_QUATERNIONS
        kinds = {*self.kinds, *([] if sure is None else [sure])}
        bonus = _OPEN if _OF_JOINTS.fullmatch(_LEFT.sub("", name)) else 0
        costs = {
            kind: cost_of(kind, by_shape) - (_SURE if kind == sure else 0) - (bonus if is_open(kind) else 0)
            for kind in kinds
        }
        return dict(sorted(costs.items(), key=lambda item: (item[1], str(item[0]))))


def is_open(kind: Kind) -> bool:
    """True if a size of the kind is a dimension that no formula determines."""
    return isinstance(kind, tuple) and 0 in kind


def _words(said: Guess) -> str:
    if said.is_inertia:
        return "inertia"
    return "unit vector" if said.unit and said.kind == "vector" else said.kind


def cost_of(kind: Kind, by_shape: Sequence[int]) -> int:
    """Returns the cost of a kind for a symbol with these costs by shape."""
    if isinstance(kind, str):
        return by_shape[6]
    usual = {SCALAR: 0, VECTOR: 1, TENSOR: 2}
    rows, columns = kind
    shape = usual.get(kind, 3 if columns == 1 else 4 if rows == columns else 5)
    size = 0 if kind in usual or not (rows and columns) else rows + columns - 2
    return by_shape[shape] + size + (_ROW if rows == 1 < columns else 0)
