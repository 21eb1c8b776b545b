"""Likely kinds of symbols by their typography."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass, field
from enum import Enum
from functools import cache

from workbench.language.grammar.latex_keys import latex_key

_OPERATION = re.compile(r"(?:\^\{(?:T|-?\d+|\(\d+\)|\*|-T|\\top|-1|[^A-Za-z0-9{}\\]+)\}|'+)$")
_MARKED = re.compile(r"(?:\\(?:mathbf|boldsymbol|mathsf|underline|vec|overline|bar|hat)\{?)+(\\?[A-Za-z]+)")
_LEFT = re.compile(r"^(?:\{\}[_^]\{(?:[^{}]|\{[^{}]*\})*\})+")
_GREEK_CAPITALS = re.compile("Gamma|Delta|Theta|Lambda|Xi|Pi|Sigma|Upsilon|Phi|Psi|Omega")
_GREEK = {
    chr(code): "\\" + unicodedata.name(chr(code)).split()[-1].lower().replace("lamda", "lambda")
    for code in range(0x3B1, 0x3CA)
}
_BOLD = re.compile(r"^\\(?:mathbf|boldsymbol|vec)\{?(\\?[A-Za-z]+)\}?")
_VECTORS = frozenset({"\\omega", "\\alpha"})
#: ω_x, R_{31} and, for forces, moments and similar, M_1 and F_{O_x}; v_1 and R_1 may be vectors and matrices.
_COMPONENTS = re.compile(
    r"\\?[A-Za-z]+_\{(?:[xyz]{1,2}|[1-3][1-3])\}|[EFHILMNPUVW]_\{(?:[^{}]*_\{)?[xyz1-3]\}+"
)
#: R_{A B}, R_A^B and {}^A R_B, with labels that are letters.
_BETWEEN_FRAMES = re.compile(
    r"_\{\s*[A-Za-z]\s*[A-Za-z]\s*\}$|_\{[A-Za-z]\}\^\{[A-Za-z]\}|^\{\}[_^]\{[A-Za-z]\}[A-Z][_^]\{[A-Za-z]\}$"
)
_LETTER = (
    r"(?:\\(?:math(?:bf|rm|sf|cal|it)|boldsymbol|bar|vec|hat|underline)\s*\{?\s*)*"
    r"(?:\\[A-Za-z]+|[A-Za-df-z])\}*"
)
_BELOW = r"\s*_\s*(?:\w|\\[A-Za-z]+|\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\})"
_ABOVE = (
    r"\s*\^\s*(?:[A-SU-Z](?![A-Za-z])|\{\s*(?:(?!T\s*\})[A-Z][A-Za-z0-9]{0,3}(?:\s*[/,]\s*[A-Z])?"
    r"|\\math(?:scr|cal|frak|rm|sf|bf)\s*\{?\s*[A-Za-z]+\s*\}?)\s*\})"
)
#: A letter with a capital as superscript.
LABELLED = re.compile(rf"{_LETTER}(?:{_ABOVE}{_BELOW}|(?:{_BELOW})?{_ABOVE})")
#: Adjoint maps of twists.
ADJOINT = re.compile(
    rf"(?:\\(?:operatorname|mathrm|text)\s*\{{\s*[Aa]d\s*\}}|(?<![\\A-Za-z])Ad(?![A-Za-z])){_BELOW}"
)


class GuessOrigin(Enum):
    """Where the kind of a symbol comes from."""

    FORMULAS = "its typeface, or the formulas that it fits"
    QUATERNIONS = "a text on quaternions"
    WORDS = "words of the text, which outweigh a typeface"


@dataclass(frozen=True)
class Guess:
    """The guessed kind and properties of a symbol.

    Attributes:
        why: The reason, in words.
        words: The words of the text that state the kind.
        origin: Where the kind comes from.
        is_inertia: Whether words say that it is an inertia, which is a scalar or a tensor.
        of: The letters that it is a function of, if the text takes it at other values of them.
    """

    name: str
    kind: str
    why: str = field(default="", compare=False)
    unit: bool = False
    constant: bool = False
    independent: bool = False
    free: bool = False
    is_inertia: bool = False
    words: str = field(default="", compare=False)
    of: tuple[str, ...] = ()
    origin: GuessOrigin = field(default=GuessOrigin.FORMULAS, compare=False)

    @property
    def is_said(self) -> bool:
        """True if the guess rests on words of the text."""
        return self.origin is GuessOrigin.WORDS

    @property
    def spec(self) -> dict[str, object]:
        flags = {name: getattr(self, name) for name in ("unit", "constant", "independent", "free")}
        places: dict[str, object] = {"of": list(self.of)} if self.of else {}
        return {"kind": self.kind, **{name: True for name, is_so in flags.items() if is_so}, **places}


def bare_name(name: str) -> str:
    """Returns the name without powers, transposes and primes, which the reader takes as operations."""
    while (shorter := _OPERATION.sub("", name)) != name:
        name = shorter
    return name


def by_typeface(name: str) -> Guess:
    core = _LEFT.sub("", name)
    if core.startswith("\\operatorname"):
        return Guess(name, "matrix 6×6", "a map of twists")
    marked = _MARKED.match(core)
    letter = (marked[1] if marked else core).lstrip("\\")
    word = re.match(r"[A-Za-z]+", letter)
    letter = word[0] if word else ""
    is_capital = bool(_GREEK_CAPITALS.fullmatch(letter)) or (len(letter) == 1 and letter.isupper())
    if marked is not None:
        if is_capital:
            return Guess(name, "rotation" if letter == "R" else "tensor", "a bold capital letter")
        return Guess(name, "vector", "a bold or marked letter")
    if _COMPONENTS.fullmatch(core):
        return Guess(name, "scalar", "a component")
    if f"\\{letter}" in _VECTORS:
        return Guess(name, "vector", "what mechanics calls so")
    if letter in ("R", "C") and _BETWEEN_FRAMES.search(name):
        return Guess(name, "rotation", "a letter of rotations between two labels")
    if core != name and not is_capital:
        return Guess(name, "vector", "a letter with labels on its left")
    if is_capital:
        return Guess(name, "tensor", "a capital letter")
    return Guess(name, "scalar", "a letter in italics")


def without_bold(name: str) -> str:
    """Returns the plain letter of a vector in bold or under an arrow."""
    return _BOLD.sub(r"\1", name)


@cache
def flat(latex: str) -> str:
    """Returns LaTeX in comparable form: without blanks and braces, Greek letters as commands."""
    return latex_key("".join(_GREEK.get(letter, letter) for letter in latex)).replace("\\bm", "\\boldsymbol")
