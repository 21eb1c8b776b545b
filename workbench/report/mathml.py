"""LaTeX to MathML that browsers show without scripts; None if the result is not certain.

The LaTeX is that of the author, or what `language.printing` makes of a term. MathML needs no printer of terms
of its own: nothing that this printer prints is lost here (tests/report/test_report_mathml.py).

latex2mathml does the conversion. This adapter corrects what browsers render badly or MathML Core dropped
(accents, bold italic letters, `aligned`), and compares every character of the result with those that the
formula must have (`glyphs`). A formula that fails the comparison is never shown as MathML.
"""

from __future__ import annotations

import unicodedata
import xml.etree.ElementTree as ElementTree
from collections import Counter
from collections.abc import Collection, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise

from latex2mathml.converter import convert

from workbench.source.typeset import glyphs
from workbench.source.typeset.latex_atoms import Atom, LatexNotTypesettable, atoms_of, latex_of

_XMLNS = "http://www.w3.org/1998/Math/MathML"
_ACCENT_MADE_BY_CONVERTER = {
    "\u02d9": r"\dot", "\u00a8": r"\ddot", "\u20db": r"\dddot", "\u20dc": r"\ddddot",
    "~": r"\tilde", "^": r"\hat", "\u00af": r"\bar", "\u2015": r"\overline", "→": r"\vec",
}  # fmt: skip
_LINES = frozenset((r"\overline", r"\bar"))
_STRETCHING = frozenset((r"\tilde", r"\hat", r"\vec"))
_SIGNS_ENDING_AN_OPERAND = frozenset(")]}|⟩‖!…⋯⌋⌉")
_THIN = "0.17em"
_BRACKETS = frozenset("⟨⟩⌊⌋⌈⌉")
_BARE_FUNCTIONS = frozenset(glyphs.FUNCTION_NAMES.values())


@lru_cache(maxsize=4096)
def mathml(
    latex: str, display: bool = False, marked: frozenset[int] = frozenset(), mark: str = "changed"
) -> str | None:
    """Returns the MathML of a formula; None if a part cannot be typeset reliably.

    marked: indices of the atoms that get the class `mark`.
    """
    try:
        atoms = atoms_of(latex)
        return mathml_of_atoms(atoms, display, marked, latex, mark)
    except LatexNotTypesettable:
        return None


def mathml_of_atoms(
    atoms: Sequence[Atom], display: bool, marked: Collection[int], alternative: str, mark: str
) -> str:
    """Returns the MathML of atoms. Raises LatexNotTypesettable if the result lacks or adds a character."""
    source = latex_of(
        [_for_converter(atom) for atom in atoms], marked, lambda a: rf"\class{{{mark}}}{{{a.latex}}}"
    )
    try:
        tree = ElementTree.fromstring(convert(source, display="block" if display else "inline"))
    except Exception as error:  # the converter raises a dozen kinds, and may write broken XML
        raise LatexNotTypesettable(str(error)) from error
    for element in tree.iter():
        element.tag = element.tag.removeprefix("{" + _XMLNS + "}")
    _mend(tree, mark)
    _require_same_characters(tree, atoms, alternative)
    _require_same_marks(tree, atoms, marked, alternative, mark)
    tree.set("xmlns", _XMLNS)
    tree.set("alttext", alternative)
    return ElementTree.tostring(tree, encoding="unicode")


def _for_converter(atom: Atom) -> Atom:
    """Returns `aligned`, `split` and `gathered` as arrays, since the converter does not know them."""
    for name, columns in (("aligned", "rl" * 4), ("split", "rl" * 4), ("gathered", "c")):
        if atom.latex == f"\\begin{{{name}}}":
            return replace(atom, latex=rf"\begin{{array}}{{{columns}}}")
        if atom.latex == f"\\end{{{name}}}":
            return replace(atom, latex=r"\end{array}")
    return atom


def _mend(tree: ElementTree.Element, mark: str) -> None:
    for parent in list(tree.iter()):
        _collapse_marked_leaf(parent, mark)
    for parent in list(tree.iter()):
        _tell_signs_from_operators(parent)
        if parent.tag in ("mover", "munder") and len(parent) == 2 and parent[1].tag == "mo":
            _mend_accent(parent)
        if parent.tag == "mtable" and parent.find("mtr/mtd[@columnalign='right']") is not None:
            parent.set("displaystyle", "true")
            parent.set("class", "aligned")
        if parent.tag == "mo" and not parent.text:
            parent.text = ""
        variant = parent.get("mathvariant")
        if variant and variant != "normal" and parent.text:
            parent.text = in_variant(parent.text, variant)
            del parent.attrib["mathvariant"]
        if parent.get("width") == "negativethinmathspace":
            parent.set("width", "-0.167em")
        if parent.tag == "mi" and parent.text in _BRACKETS:
            parent.tag = "mo"
            parent.set("form", "prefix" if parent.text in "⟨⌊⌈" else "postfix")
            parent.set("stretchy", "false")
        if parent.tag == "mo" and parent.text in ("|", "‖"):
            parent.attrib.update({"lspace": "0", "rspace": "0"})
        if parent.tag in ("mi", "mo") and (parent.text in _BARE_FUNCTIONS or _is_word(parent)):
            parent.tag = "mo"
            parent.attrib.update({"form": "prefix", "lspace": _THIN, "rspace": _THIN})
    for parent in tree.iter("mrow"):
        _space_function_names(parent)


def _space_function_names(parent: ElementTree.Element) -> None:
    """Keeps the thin space of a function's name beside operands only, as TeX sets it: none by an operator,
    before a bracket, and at the beginning of a formula."""
    row = [None, *parent, None]
    for before, name, after in zip(row, row[1:], row[2:], strict=False):
        if name is None or name.get("lspace") != _THIN:
            continue
        if before is None or (before.tag == "mo" and before.text not in _SIGNS_ENDING_AN_OPERAND):
            name.set("lspace", "0")
        if after is not None and after.tag == "mo" and after.text in ("(", "["):
            name.set("rspace", "0")


def _tell_signs_from_operators(parent: ElementTree.Element) -> None:
    """Marks + and − that do not follow an operand as prefixes, and removes the space of a single operator."""
    if parent.tag == "math" and len(parent[0]) == 1 and parent[0][0].tag == "mo":
        parent[0][0].attrib.update({"lspace": "0", "rspace": "0"})
    for before, sign in pairwise(parent):
        follows_operand = before.tag != "mo" or before.text in _SIGNS_ENDING_AN_OPERAND
        if sign.tag == "mo" and sign.text in ("+", "−") and not follows_operand:
            sign.set("form", "prefix")


def _is_word(element: ElementTree.Element) -> bool:
    text = element.text or ""
    return element.tag == "mo" and len(text) > 1 and text.isascii() and text.isalpha()


def _collapse_marked_leaf(parent: ElementTree.Element, mark: str) -> None:
    """Moves a mark from a row around a single sign to the sign, so that the sign keeps its spacing."""
    for index, child in enumerate(parent):
        if child.get("class") == mark and len(child) == 1 and child[0].tag == "mo":
            child[0].set("class", mark)
            child[0].tail = child.tail
            parent[index] = child[0]


def _mend_accent(parent: ElementTree.Element) -> None:
    base, mark = parent
    command = _ACCENT_MADE_BY_CONVERTER.get(mark.text or "")
    if command is None:
        return
    if parent.tag == "munder":
        command = r"\underline"
    mark.text = glyphs.ACCENTS[command]
    is_wide = len(list(base.iter("mi"))) + len(list(base.iter("mn"))) > 1
    stretches = command in _STRETCHING and is_wide
    mark.attrib.clear()
    mark.attrib.update({"stretchy": "true" if stretches else "false", "lspace": "0", "rspace": "0"})
    parent.attrib.clear()
    if command == r"\underline":
        parent.set("class", "under-line")
    elif command in _LINES:
        parent.set("class", "over-line")
    else:
        parent.set("accent", "true")


VARIANTS = {
    "bold": (0x1D400, 0x1D6A8, 0x1D7CE),
    "italic": (0x1D434, 0x1D6E2, None),
    "bold-italic": (0x1D468, 0x1D71C, 0x1D7CE),
    "fraktur": (0x1D504, None, None),
    "double-struck": (0x1D538, None, 0x1D7D8),
    "script": (0x1D49C, None, None),
    "sans-serif": (0x1D5A0, None, 0x1D7E2),
}
_HOLES = {
    ("fraktur", "C"): "ℭ", ("fraktur", "H"): "ℌ", ("fraktur", "I"): "ℑ", ("fraktur", "R"): "ℜ",
    ("fraktur", "Z"): "ℨ", ("double-struck", "C"): "ℂ", ("double-struck", "H"): "ℍ",
    ("double-struck", "N"): "ℕ", ("double-struck", "P"): "ℙ", ("double-struck", "Q"): "ℚ",
    ("double-struck", "R"): "ℝ", ("double-struck", "Z"): "ℤ", ("italic", "h"): "ℎ",
    ("script", "B"): "ℬ", ("script", "E"): "ℰ", ("script", "F"): "ℱ", ("script", "H"): "ℋ",
    ("script", "I"): "ℐ", ("script", "L"): "ℒ", ("script", "M"): "ℳ", ("script", "R"): "ℛ",
    ("script", "e"): "ℯ", ("script", "g"): "ℊ", ("script", "o"): "ℴ",
}  # fmt: skip
_GREEK_SYMBOLS = "∂ϵϑϰϕϱϖ"


def in_variant(text: str, variant: str) -> str:
    """Returns letters of a MathML 3 `mathvariant` as the Unicode letters that MathML Core requires."""
    latin, greek, digit = VARIANTS.get(variant, (None, None, None))

    def letter(character: str) -> str:
        if (variant, character) in _HOLES:
            return _HOLES[variant, character]
        code = None
        if "A" <= character <= "Z" and latin:
            code = latin + ord(character) - ord("A")
        elif "a" <= character <= "z" and latin:
            code = latin + 26 + ord(character) - ord("a")
        elif "Α" <= character <= "Ω" and greek:
            code = greek + ord(character) - ord("Α")
        elif "α" <= character <= "ω" and greek:
            code = greek + 26 + ord(character) - ord("α")
        elif character in _GREEK_SYMBOLS and greek:
            code = greek + 51 + _GREEK_SYMBOLS.index(character)
        elif character.isascii() and character.isdigit() and digit:
            code = digit + int(character)
        return chr(code) if code else character

    return "".join(letter(character) for character in text)


def _characters(text: str) -> Counter[str]:
    return Counter(c for c in unicodedata.normalize("NFKC", text) if not c.isspace())


def _require_same_characters(tree: ElementTree.Element, atoms: Sequence[Atom], alternative: str) -> None:
    shown = _characters("".join(tree.itertext()))
    meant = _characters("".join(atom.glyphs for atom in atoms))
    if shown != meant:
        raise LatexNotTypesettable(f"MathML of {alternative!r} differs: {shown - meant}, {meant - shown}")


def _require_same_marks(
    tree: ElementTree.Element, atoms: Sequence[Atom], marked: Collection[int], alternative: str, mark: str
) -> None:
    meant = sum(1 for index in marked if atoms[index].leaf)
    shown = sum(1 for element in tree.iter() if element.get("class") == mark)
    if shown != meant:
        raise LatexNotTypesettable(f"{shown} marks in the MathML of {alternative!r}, not {meant}")
