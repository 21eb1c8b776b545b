"""The LaTeX of the erratum note: escaped text, formulas with their changes in colour."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable

from workbench.report.prose import Run
from workbench.typeset import glyphs
from workbench.typeset.latex_atoms import Atom, LatexNotTypesettable, atoms_of, latex_of

_SPECIAL = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "&": r"\&", "#": r"\#",
    "%": r"\%", "_": r"\_", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}",
    "<": r"\textless{}", ">": r"\textgreater{}", "|": r"\textbar{}", '"': "''",
    "–": "--", "—": "---", "‘": "`", "’": "'", "“": "``", "”": "''", "…": r"\ldots{}",
    "\u00a0": "~", "`": r"\textasciigrave{}", "'": "'", "-": "{-}",
}  # fmt: skip
_MATH_CHARACTERS = {
    glyph: command
    for command, glyph in glyphs.SYMBOLS.items()
    if command.startswith("\\") and len(glyph) == 1 and not glyph.isascii()
}
# The last of two commands for one character would win; these are the plain ones.
_MATH_CHARACTERS |= {"→": r"\to", "≠": r"\neq", "≤": r"\leq", "≥": r"\geq", "−": "-"}
_COMBINING = {
    "\u0307": r"\dot", "\u0308": r"\ddot", "\u20db": r"\dddot", "\u20dc": r"\ddddot",
    "\u0303": r"\tilde", "\u0332": r"\underline",
}  # fmt: skip
_RAISED = {"<sub>": r"\textsubscript", "<super>": r"\textsuperscript", "<font>": ""}
_KNOWN = frozenset("0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ+=()−") | set(
    _MATH_CHARACTERS
)
_LATIN = frozenset("ßæÆøØœŒłŁ")
_ACCENTS_OF_TEXT = frozenset("\u0300\u0301\u0302\u0303\u0308\u030a\u030c\u0327")
_LONG = 40
_COMMANDS_OF_FAMILY = {"ord": r"\Changed", "bin": r"\ChangedBin", "rel": r"\ChangedRel"}


def escaped(plain: str) -> str:
    """Text for pdfLaTeX: specials escaped, Greek and signs as mathematics, the rest by code point."""
    pieces: list[str] = []
    base = ""
    for character in " ".join(unicodedata.normalize("NFC", plain).split()):
        if character in _COMBINING and base.strip():
            mark = _COMBINING[character]
            pieces[-1] = rf"\ensuremath{{{mark}{{{_MATH_CHARACTERS.get(base, base)}}}}}"
        else:
            pieces.append(_character(character))
        base = (
            character
            if character in _MATH_CHARACTERS or (character.isascii() and character.isalnum())
            else ""
        )
    return "".join(pieces)


def _character(character: str) -> str:
    if character in _SPECIAL:
        return _SPECIAL[character]
    if character in _MATH_CHARACTERS:
        return rf"\ensuremath{{{_MATH_CHARACTERS[character]}}}"
    if character.isascii():
        return character if character.isprintable() else f"[U+{ord(character):04X}]"
    if character in _LATIN or unicodedata.normalize("NFD", character)[1:] in _ACCENTS_OF_TEXT:
        return character
    kind, _, plain = unicodedata.decomposition(character).partition(" ")
    if kind in _RAISED and len(plain) == 4 and (shown := chr(int(plain, 16))) in _KNOWN:
        return rf"{_RAISED[kind]}{{{_character(shown)}}}"
    return f"[U+{ord(character):04X}]"


def source(latex: str) -> str:
    return rf"\texttt{{{escaped(latex)}}}"


def inline_math(latex: str) -> str:
    """A formula within a line, or on a line of its own where it is too long to be broken well."""
    try:
        atoms = atoms_of(latex)
    except LatexNotTypesettable:
        return source(latex)
    if sum(len(atom.glyphs) for atom in atoms) > _LONG:
        return display_math(latex)
    return rf"\({latex_of(atoms)}\)"


def display_math(latex: str, marked: frozenset[int] = frozenset()) -> str:
    """A displayed formula, scaled down where it is wider than the line, its changes in colour."""
    try:
        atoms = atoms_of(latex)
    except LatexNotTypesettable:
        return rf"\begin{{quote}}\raggedright {source(latex)}\end{{quote}}"
    return rf"\DisplayedFormula{{{latex_of(atoms, marked, _in_colour)}}}"


def runs(sentence: Iterable[Run]) -> str:
    pieces = []
    for run in sentence:
        if run.is_math:
            pieces.append(inline_math(run.content))
            continue
        lead, trail = run.content[:1].isspace(), run.content[-1:].isspace()
        pieces.append(" " * lead + escaped(run.content) + " " * trail)
    return re.sub(" +", " ", "".join(pieces)).strip()


def _in_colour(atom: Atom) -> str:
    return f"{_COMMANDS_OF_FAMILY[atom.family]}{{{atom.latex}}}"


FILTERS = {
    "text": escaped,
    "source": source,
    "imath": inline_math,
    "dmath": display_math,
    "runs": runs,
}
