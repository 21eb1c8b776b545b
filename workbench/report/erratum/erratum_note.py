"""LaTeX of the erratum note: escaped text, and formulas with their changes in colour."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable

from workbench.report import ReportError
from workbench.report.erratum.errata import Change
from workbench.report.mixed_prose import Run, minus
from workbench.source.typeset import glyphs
from workbench.source.typeset.latex_atoms import Atom, LatexNotTypesettable, atoms_of, latex_of

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
# Where two commands print one character, the plainer one is used.
_MATH_CHARACTERS |= {
    "→": r"\to",
    "≠": r"\neq",
    "≤": r"\leq",
    "≥": r"\geq",
    "−": "-",
    "↦": r"\mapsto",
    "′": "'",
    "∗": "*",
}
_MATH_CHARACTERS |= {"½": r"\tfrac{1}{2}"}
_COMBINING = {
    "\u0307": r"\dot", "\u0308": r"\ddot", "\u20db": r"\dddot", "\u20dc": r"\ddddot",
    "\u0303": r"\tilde", "\u0332": r"\underline", "\u02d9": r"\dot",
}  # fmt: skip
_RAISED = {"<sub>": r"\textsubscript", "<super>": r"\textsuperscript", "<font>": ""}
_KNOWN = frozenset("0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ+=()−") | set(
    _MATH_CHARACTERS
)
_LATIN = frozenset("ßæÆøØœŒłŁđ")
_ACCENTS_OF_TEXT = frozenset("\u0300\u0301\u0302\u0303\u0308\u030a\u030c\u0327\u0328")
_LAST_ACCENTED = "\u0180"
#: A one-letter index, as in A_ρ, and a placeholder for its underscore.
_INDEX = re.compile(r"(?<=\w)_([^\W\d_])(?!\w)")
_INDEX_SIGN = "\ue000"
_LONG = 40
#: The number of glyphs that fit a third of a page.
_COLUMN = 38
_COMMANDS_OF_FAMILY = {"ord": r"\Changed", "bin": r"\ChangedBin", "rel": r"\ChangedRel"}


def escaped(plain: str, indices: bool = True) -> str:
    """Returns text for pdfLaTeX: special characters escaped, Greek and signs as mathematics.

    indices: whether A_ρ is an A with an index. Raises ReportError for a character that it cannot typeset.
    """
    pieces: list[str] = []
    letter = ""
    normal = " ".join(unicodedata.normalize("NFC", plain).split())
    if indices:
        normal = _INDEX.sub(lambda index: _INDEX_SIGN + index[1], normal)
    for character in normal:
        if character in _COMBINING:
            base = _unaccented(letter) if letter.strip() else r"\ "
            letter = rf"{_COMBINING[character]}{{{base}}}"
            pieces = pieces or [""]
            pieces[-1] = rf"\ensuremath{{{letter}}}"
        elif pieces and pieces[-1] == _INDEX_SIGN:
            pieces[-1] = rf"\textsubscript{{{_character(character)}}}"
            letter = ""
        elif character == _INDEX_SIGN:
            pieces.append(character)
        else:
            pieces.append(_character(character))
            letter = _MATH_CHARACTERS.get(character, character)
    return "".join(pieces)


def _unaccented(letter: str) -> str:
    """Returns a letter for mathematics: a letter with an accent becomes its base under a command."""
    decomposed = unicodedata.normalize("NFD", letter)
    base, marks = decomposed[0], decomposed[1:]
    if letter.startswith("\\") or not marks:
        return letter
    return rf"{_COMBINING[marks[0]]}{{{base}}}" if marks[0] in _COMBINING else letter


def _character(character: str) -> str:
    if character in _SPECIAL:
        return _SPECIAL[character]
    if character in _MATH_CHARACTERS:
        return rf"\ensuremath{{{_MATH_CHARACTERS[character]}}}"
    if character.isascii() and character.isprintable():
        return character
    decomposed = unicodedata.normalize("NFD", character)
    base, marks = decomposed[0], decomposed[1:]
    in_text = character < _LAST_ACCENTED and len(marks) == 1 and marks[0] in _ACCENTS_OF_TEXT
    if character in _LATIN or (in_text and base.isascii()):
        return character
    if len(marks) == 1 and marks[0] in _COMBINING and (base in _MATH_CHARACTERS or base.isascii()):
        return rf"\ensuremath{{{_COMBINING[marks[0]]}{{{_MATH_CHARACTERS.get(base, base)}}}}}"
    kind, _, code = unicodedata.decomposition(character).partition(" ")
    if kind in _RAISED and len(code) == 4 and (shown := chr(int(code, 16))) in _KNOWN:
        return rf"{_RAISED[kind]}{{{_character(shown)}}}"
    name = unicodedata.name(character, "no name")
    raise ReportError(f"erratum.tex: expected what pdfLaTeX sets, got U+{ord(character):04X} ({name})")


def source(latex: str) -> str:
    return rf"\texttt{{{escaped(latex, indices=False)}}}"


def inline_math(latex: str) -> str:
    """Returns an inline formula, or a displayed one if it is too long to break well."""
    try:
        atoms = atoms_of(latex)
    except LatexNotTypesettable:
        return source(latex)
    if sum(len(atom.glyphs) for atom in atoms) > _LONG and "bmatrix" not in latex:
        return display_math(latex)
    return rf"\({latex_of(atoms).replace('bmatrix', 'bsmallmatrix')}\)"


def display_math(latex: str, marked: frozenset[int] = frozenset()) -> str:
    """Returns a displayed formula, scaled down if it is wider than the line, with its changes in colour."""
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
        pieces.append(" " * lead + escaped(minus(run.content)) + " " * trail)
    return re.sub(" +", " ", "".join(pieces)).strip()


def old(change: Change) -> str:
    return _changed(change.old, change.marked_old)


def new(change: Change) -> str:
    return _changed(change.new or (), change.marked_new)


def stop(change: Change) -> str:
    """Returns the full stop after a change; "" after a displayed formula."""
    return "" if _changed(change.new or (), frozenset()).startswith(r"\DisplayedFormula") else "."


def is_wide(change: Change) -> bool:
    """True if the change needs the whole width of a table: a long formula, or one of several lines."""
    return any(_width(side) > _COLUMN for side in (change.old, change.new or ()))


def _width(sentence: tuple[Run, ...]) -> int:
    width = 0
    for run in sentence:
        try:
            width += sum(len(a.glyphs) for a in atoms_of(run.content)) if run.is_math else len(run.content)
        except LatexNotTypesettable:
            return 2 * _COLUMN
        width += 2 * _COLUMN * (run.is_math and r"\begin" in run.content)
    return width


def old_in_cell(change: Change) -> str:
    return _in_cell(change.old, change.marked_old)


def new_in_cell(change: Change) -> str:
    return _in_cell(change.new, change.marked_new) if change.new else "nothing"


def _in_cell(sentence: tuple[Run, ...], marked: frozenset[int]) -> str:
    if len(sentence) == 1 and sentence[0].is_math:
        try:
            formula = latex_of(atoms_of(sentence[0].content), marked, _in_colour)
        except LatexNotTypesettable:
            return source(sentence[0].content)
        return rf"\Fitted{{\linewidth}}{{{formula}}}"
    return f"`{runs(sentence)}'"


def _changed(sentence: tuple[Run, ...], marked: frozenset[int]) -> str:
    if len(sentence) != 1 or not sentence[0].is_math:
        return f"`{runs(sentence)}'"
    latex = sentence[0].content
    try:
        atoms = atoms_of(latex)
    except LatexNotTypesettable:
        return source(latex)
    coloured = latex_of(atoms, marked, _in_colour)
    if sum(len(atom.glyphs) for atom in atoms) > _LONG or r"\begin" in latex:
        return rf"\DisplayedFormula{{{coloured}}}"
    return rf"\({coloured}\)"


def _in_colour(atom: Atom) -> str:
    return f"{_COMMANDS_OF_FAMILY[atom.family]}{{{atom.latex}}}"


FILTERS = {
    "text": escaped,
    "source": source,
    "imath": inline_math,
    "dmath": display_math,
    "runs": runs,
    "old": old,
    "new": new,
    "stop": stop,
    "is_wide": is_wide,
    "old_in_cell": old_in_cell,
    "new_in_cell": new_in_cell,
}
