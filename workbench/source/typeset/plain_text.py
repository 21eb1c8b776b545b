"""Formulas as one line of text, for terminals and messages: ω_B/A × v_rel, θ̇₂ as θ̇_2, (a + b)/c."""

from __future__ import annotations

import re
from collections.abc import Sequence

from workbench.source.typeset import glyphs
from workbench.source.typeset.latex_atoms import Atom, LatexNotTypesettable, atoms_of, closing_of

_COMBINING = {
    glyphs.ACCENTS[command]: mark
    for command, mark in {
        r"\dot": "\u0307", r"\ddot": "\u0308", r"\dddot": "\u20db", r"\ddddot": "\u20dc",
        r"\tilde": "\u0303", r"\hat": "\u0302", r"\bar": "\u0304", r"\vec": "\u20d7",
        r"\underline": "\u0332", r"\mathring": "\u030a",
    }.items()
}  # fmt: skip
_MARKS = sorted(_COMBINING, key=len, reverse=True)
_RAISED = {"2": "²", "3": "³", "T": "ᵀ", "−1": "⁻¹", "*": "*"}
_MATH = re.compile(r"\$([^$\n]+)\$")
_FUNCTIONS = frozenset((*glyphs.FUNCTION_NAMES.values(), "tr", "skew", "rank", "diag", "sinc"))
_FENCES = {"bmatrix": "[]", "pmatrix": "()", "vmatrix": "||", "matrix": "[]", "array": "[]", "cases": "{}"}


def plain_text(latex: str) -> str:
    """Returns one line of text for a formula; its LaTeX if it has an unknown command."""
    try:
        atoms = atoms_of(latex)
    except LatexNotTypesettable:
        return " ".join(latex.split())
    return re.sub(r"  +", " ", _Line(atoms).text()).strip()


def in_plain_text(prose: str) -> str:
    """Returns prose with its formulas between dollar signs as text."""
    return _MATH.sub(lambda match: plain_text(match[1]), prose)


class _Line:
    def __init__(self, atoms: Sequence[Atom]) -> None:
        self._atoms, self._place = atoms, 0

    def text(self) -> str:
        pieces: list[str] = []
        while self._place < len(self._atoms):
            piece = self._next(pieces)
            if pieces and _needs_blank(pieces[-1], piece):
                pieces.append(" ")
            pieces.append(piece)
        return "".join(pieces)

    def _next(self, before: Sequence[str]) -> str:
        atom = self._atoms[self._place]
        if atom.leaf:
            self._place += 1
            return self._leaf(atom, before)
        if atom.latex.startswith("\\begin{"):
            return self._matrix(atom)
        if atom.latex in ("^{", "_{"):
            return _script(atom.latex[0], self._inside(), self._is_word)
        if atom.latex == "{":
            return self._inside()
        if atom.latex[:-1] in glyphs.TWO_ARGUMENTS:
            return self._fraction()
        if atom.latex == r"\sqrt{":
            return f"√({self._inside()})"
        if atom.latex[:-1] in glyphs.ACCENTS:
            mark = _COMBINING.get(glyphs.ACCENTS[atom.latex[:-1]], "")
            return f"({self._inside()}){mark}"
        if atom.latex.endswith("{") and not atom.latex.endswith(r"\{"):
            return self._inside()
        self._place += 1
        return atom.glyphs

    def _leaf(self, atom: Atom, before: Sequence[str]) -> str:
        if atom.family in ("bin", "rel"):
            last = "".join(before).rstrip()
            is_sign = atom.family == "bin" and (not last or last[-1] in "(=,+−×·[/;")
            return atom.glyphs if is_sign else f" {atom.glyphs} "
        base = atom.glyphs
        accents = ""
        while base and (mark := _trailing_mark(base, atom.identity or "")):
            base, accents = base[: -len(mark)], _COMBINING[mark] + accents
        return ", " if base == "," else base + accents

    def _inside(self) -> str:
        """Returns the text between the opening at the current index and its closing, and moves past it."""
        end = closing_of(self._atoms, self._place)
        inner = self._atoms[self._place + 1 : end]
        self._is_word = all(each.leaf and each.glyphs.isalpha() for each in inner)
        self._place = end + 1
        return re.sub(r"  +", " ", _Line(inner).text()).strip()

    def _fraction(self) -> str:
        end = closing_of(self._atoms, self._place)
        inner = self._atoms[self._place + 1 : end]
        self._place = end + 1
        depth = 0
        for place, atom in enumerate(inner):
            if atom.latex == "}{" and depth == 0:
                above, below = _Line(inner[:place]).text(), _Line(inner[place + 1 :]).text()
                return f"{_in_brackets(above)}/{_in_brackets(below, chr(32))} "
            depth += atom.latex.count("{") - atom.latex.count("}") if not atom.leaf else 0
        return _Line(inner).text()

    def _matrix(self, opening: Atom) -> str:
        name = opening.latex[len("\\begin{") :].split("}")[0]
        depth, end = 0, self._place
        for end in range(self._place, len(self._atoms)):
            latex = self._atoms[end].latex
            depth += latex.startswith("\\begin{") - latex.startswith("\\end{")
            if depth == 0:
                break
        rows: list[list[list[Atom]]] = [[[]]]
        depth = 0
        for atom in self._atoms[self._place + 1 : end]:
            depth += atom.latex.startswith("\\begin{") - atom.latex.startswith("\\end{")
            if depth == 0 and atom.latex == "&":
                rows[-1].append([])
            elif depth == 0 and atom.latex == r"\\":
                rows.append([[]])
            else:
                rows[-1][-1].append(atom)
        self._place = end + 1
        text = "; ".join(", ".join(_Line(cell).text().strip() for cell in row) for row in rows)
        fences = _FENCES.get(name, "[]")
        return f"{fences[0]}{text}{fences[1]}"

    _is_word = False


def _trailing_mark(text: str, identity: str) -> str:
    """Returns the accent at the end of a letter's glyphs; "" for a letter that is itself a mark, such as a
    bar."""
    if "(" not in identity or len(text) < 2:
        return ""
    return next((mark for mark in _MARKS if text.endswith(mark)), "")


def _script(sign: str, inner: str, is_word: bool) -> str:
    if sign == "^" and inner in _RAISED:
        return _RAISED[inner]
    tight = inner.replace(" / ", "/").replace(", ", ",")
    if is_word:
        tight = tight.replace(" ", "")
    simple = re.fullmatch(r"[\w/,′*×⊤\u0300-\u036f]+", tight) is not None
    return f"{sign}{tight}" if simple else f"{sign}({inner})"


def _in_brackets(text: str, more: str = "") -> str:
    text = text.strip()
    is_sum = any(sign in text for sign in (" + ", " − ", " · ", " × ")) or (more and more in text)
    return f"({text})" if is_sum else text


def _needs_blank(left: str, right: str) -> bool:
    if left in _FUNCTIONS:
        return not right.startswith(("(", "^", "_", "²", "³", " "))
    if right in _FUNCTIONS:
        return not left.endswith(("(", " ", "−", "["))
    return left[-1:] in ")ᵀ²³" and right[:1].isalpha()
