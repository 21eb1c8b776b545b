"""LaTeX formulas as flat lists of atoms, which are compared, highlighted and typeset.

This is not the claim language: a printed form may be garbled and must still be shown. An atom is the smallest
part a reader would point at: a symbol with its marks, a sign, a number, a function name. Braces, scripts,
fractions, tables and sized delimiters are atoms too, but only leaves can be marked.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace

from workbench.source.documents.tex.tex_tokens import COMMENT, tokens_of
from workbench.source.typeset import glyphs as table

_DEEPEST = 60
_NAMES = {r"\widetilde": "~", r"\tilde": "~", **dict.fromkeys(table.WEIGHT_STYLES, "bold")}
_ALIGNMENTS = frozenset(("aligned", "split", "gathered"))
_COLUMNS = {"cases": 2, "gathered": 1, "split": 2, "aligned": 8}


class LatexNotTypesettable(ValueError):
    """The formula contains something that the report cannot typeset reliably; it is shown as source."""


@dataclass(frozen=True)
class Atom:
    """An atom.

    latex: its source.   identity: its key in comparisons (None: it does not count).
    shape: the identity with bold and upright letters treated as the same.   leaf: it can be marked
    separately.
    place: its index among the atoms of the formula.
    """

    latex: str
    identity: str | None
    shape: str | None = None
    leaf: bool = False
    family: str = "ord"
    glyphs: str = ""
    place: int = 0

    @property
    def is_accent(self) -> bool:
        """True for the opening of a mark over (or under) several symbols."""
        return not self.leaf and self.latex[:-1] in table.ACCENTS

    @property
    def is_script(self) -> bool:
        """True for the opening of an exponent or index."""
        return self.latex in ("^{", "_{")


def atoms_of(latex: str) -> list[Atom]:
    """Returns the atoms of a formula. Raises LatexNotTypesettable, naming what is unknown or unbalanced."""
    return _Parser(latex).formula()


def latex_of(
    atoms: Sequence[Atom], marked: Collection[int] = (), mark: Callable[[Atom], str] | None = None
) -> str:
    """Returns the LaTeX of the atoms, with each marked leaf passed through `mark`."""
    pieces = [
        mark(atom) if mark and index in marked and atom.leaf else atom.latex
        for index, atom in enumerate(atoms)
    ]
    return " ".join(pieces)


def in_colour(latex: str, marked: Collection[int], colour: str = "green") -> str:
    """Returns the formula with the marked leaves in a colour, for MathJax in GitHub and notebooks; signs keep
    their spacing."""
    around = {"bin": r"\mathbin", "rel": r"\mathrel"}

    def coloured(atom: Atom) -> str:
        return rf"{around.get(atom.family, '')}{{\color{{{colour}}}{{{atom.latex}}}}}"

    return latex_of(atoms_of(latex), marked, coloured) if marked else latex


def decorated(command: str, atom: Atom, latex: str) -> Atom:
    """Returns a leaf, or several letters as one, with an accent or in a style. latex: its source without
    that."""
    name = _NAMES.get(command, command[1:])
    is_plain = command in table.WEIGHT_STYLES
    return replace(
        atom,
        latex=f"{command}{{{latex}}}",
        identity=f"{name}({atom.identity})",
        shape=atom.shape if is_plain else f"{name}({atom.shape})",
        leaf=True,
        family="ord",
        glyphs=atom.glyphs + table.ACCENTS.get(command, ""),
    )


def closing_of(atoms: Sequence[Atom], opening: int) -> int:
    """Returns the index of the closing for the opening at an index, or that index if nothing opens there."""
    depth = 0
    for place in range(opening, len(atoms)):
        depth += opens(atoms[place])
        if depth <= 0:
            return place
    return len(atoms) - 1


def opens(atom: Atom) -> int:
    """Returns 1 for an opening, -1 for a closing brace, else 0."""
    if atom.leaf or atom.latex.endswith((r"\{", r"\}")):
        return 0
    return atom.latex.count("{") - atom.latex.count("}")


def _enclosed(opening: Atom, *parts: Sequence[Atom]) -> list[Atom]:
    """Returns an opening and its arguments, with separators and the closing."""
    between = Atom("}{", "}{", "}{")
    inner = [atom for part in parts for atom in (between, *part)][1:]
    end = opening.identity and f"end {opening.identity}"
    return [opening, *inner, Atom("}", end, end)]


def _tokens(latex: str) -> list[str]:
    """Returns the tokens of TeX; figures in a row are one, and a star belongs to the command before it."""
    if COMMENT.search(latex):
        raise LatexNotTypesettable("cannot typeset %")
    made: list[str] = []
    end = 0
    for token in tokens_of(latex):
        text = " " if latex[token.start].isspace() else token.text
        before = made[-1] if made else ""
        is_figure = text.isdecimal() and before.isdecimal()
        if token.start == end and (is_figure or (text == "*" and before[1:].isalpha())):
            made[-1] += text
        else:
            made.append(text)
        end = token.end
    return made


class _Parser:
    def __init__(self, latex: str):
        self.tokens = [table.LETTERS.get(token, token) for token in _tokens(latex)]
        self.position = 0
        self.depth = 0
        self.aligned = False

    def formula(self) -> list[Atom]:
        atoms = self.sequence()
        if self.peek() is not None:
            raise LatexNotTypesettable(f"unexpected {self.peek()}")
        return [replace(atom, place=place) for place, atom in enumerate(atoms)]

    def peek(self) -> str | None:
        while self.position < len(self.tokens) and self.tokens[self.position].isspace():
            self.position += 1
        return self.tokens[self.position] if self.position < len(self.tokens) else None

    def take(self) -> str:
        token = self.peek()
        if token is None:
            raise LatexNotTypesettable("the formula ends too early")
        self.position += 1
        return token

    def expect(self, token: str) -> None:
        found = self.take()
        if found != token:
            raise LatexNotTypesettable(f"expected {token}, got {found}")

    def sequence(self, columns: int = 0) -> list[Atom]:
        """Returns the items up to a closing; `columns` of a table row, 0 outside tables."""
        atoms: list[Atom] = []
        cells, scripts = 1, ""
        while (token := self.peek()) not in (None, "}", r"\right", r"\end"):
            if token in ("&", r"\\"):
                cells = cells + 1 if token == "&" else 1
                if cells > columns:
                    raise LatexNotTypesettable(f"{token} has no place here")
            if token in ("^", "_", "'"):
                script = "_" if token == "_" else "^"
                if script in scripts and not scripts.endswith("'"):
                    raise LatexNotTypesettable(f"a second {token}")
                scripts += script + ("'" if token == "'" else "")
            else:
                scripts = ""
            atoms.extend(self.item())
        return atoms

    def item(self) -> list[Atom]:
        if self.depth == _DEEPEST:
            raise LatexNotTypesettable(f"nested more than {_DEEPEST} deep")
        self.depth += 1
        atoms = self.item_here()
        self.depth -= 1
        return atoms

    def item_here(self) -> list[Atom]:
        token = self.take()
        if token == "{":
            inner = self.sequence()
            self.expect("}")
            return _enclosed(Atom("{", None), inner)
        if token in ("^", "_"):
            return _enclosed(Atom(token + "{", token, token), self.argument())
        if token in ("&", r"\\"):
            return [Atom(token, None) if self.aligned else Atom(token, token, token)]
        if token in table.SPACES:
            return [Atom(token, None)]
        if token in table.SYMBOLS:
            return [_symbol(token)]
        if token in table.ACCENTS or token in table.STYLES:
            return self.decorated(token)
        if token in table.TEXT_COMMANDS:
            return [self.text(token)]
        if token in table.TWO_ARGUMENTS:
            return self.two_arguments(token)
        if token == r"\sqrt":
            return _enclosed(Atom(r"\sqrt{", "√", "√"), self.argument())
        if token == r"\left":
            return self.left_right()
        if token in table.SIZES:
            return [_sized(token, self.delimiter())]
        if token == r"\begin":
            return self.environment()
        if token.isalnum():
            return [Atom(token, token, token, leaf=True, glyphs=token)]
        raise LatexNotTypesettable(f"cannot typeset {token}")

    def argument(self) -> list[Atom]:
        token = self.peek()
        if token == "{":
            return self.item()[1:-1]
        if token is not None and token.isdigit() and len(token) > 1:
            self.tokens[self.position : self.position + 1] = [token[0], token[1:]]
        if token in ("^", "_", "&", "}", r"\\", r"\right", r"\end"):
            raise LatexNotTypesettable(f"expected an argument, got {token}")
        return self.item()

    def decorated(self, command: str) -> list[Atom]:
        """Returns one leaf for a decorated single symbol, else an opening, the content and a brace."""
        inner = self.argument()
        counted = [atom for atom in inner if atom.identity is not None]
        letters = command in table.STYLES and all(re.fullmatch(r"[^\W\d_]", a.latex) for a in counted)
        if counted and (letters or (len(counted) == 1 and counted[0].leaf)):
            word, shape, glyphs = (
                "".join(getattr(atom, name) or "" for atom in counted)
                for name in ("identity", "shape", "glyphs")
            )
            latex = "".join(atom.latex for atom in counted) if letters else latex_of(inner)
            return [decorated(command, Atom(latex, word, shape, glyphs=glyphs), latex)]
        name = _NAMES.get(command, command[1:])
        return _enclosed(Atom(f"{command}{{", name, name, glyphs=table.ACCENTS.get(command, "")), inner)

    def text(self, command: str) -> Atom:
        self.expect("{")
        content = ""
        while self.position < len(self.tokens) and self.tokens[self.position] != "}":
            content += self.tokens[self.position]
            self.position += 1
        self.expect("}")
        if not re.fullmatch(r"[A-Za-z0-9 ,.;:()=+\-]*", content):
            raise LatexNotTypesettable(f"cannot typeset {command}{{{content}}}")
        word = content.strip()
        return Atom(f"{command}{{{content}}}", word, word, leaf=True, glyphs=content)

    def two_arguments(self, command: str) -> list[Atom]:
        first, second = self.argument(), self.argument()
        name = r"\frac" if command in (r"\dfrac", r"\tfrac") else command
        glyphs = "()" if command == r"\binom" else ""
        return _enclosed(Atom(command + "{", name, name, glyphs=glyphs), first, second)

    def delimiter(self) -> str:
        token = self.take()
        if token not in table.DELIMITERS:
            raise LatexNotTypesettable(f"expected a delimiter, got {token}")
        return token

    def left_right(self) -> list[Atom]:
        opening = self.delimiter()
        inner = self.sequence()
        self.expect(r"\right")
        return [_sized(r"\left", opening), *inner, _sized(r"\right", self.delimiter())]

    def environment(self) -> list[Atom]:
        name = self.brace_word()
        if name not in table.ENVIRONMENTS:
            raise LatexNotTypesettable(f"cannot typeset the environment {name}")
        columns = "{" + self.brace_word() + "}" if name == "array" else ""
        width = len(columns) - 2 if columns else _COLUMNS.get(name, 10)
        outer, self.aligned = self.aligned, name in _ALIGNMENTS
        inner = self.sequence(width)
        self.aligned = outer
        self.expect(r"\end")
        ended = self.brace_word()
        if ended != name:
            raise LatexNotTypesettable(f"{name} is ended by {ended}")
        fences = {"cases": "{", "bmatrix": "[]", "pmatrix": "()", "vmatrix": "||"}.get(name, "")
        begin, end = (None, None) if name in _ALIGNMENTS else (name, f"end {name}")
        opening = Atom(f"\\begin{{{name}}}{columns}", begin, begin, glyphs=fences)
        return [opening, *inner, Atom(f"\\end{{{name}}}", end, end)]

    def brace_word(self) -> str:
        self.expect("{")
        word = ""
        while (token := self.take()) != "}":
            if not token.isalpha():
                raise LatexNotTypesettable(f"expected a name in braces, got {token}")
            word += token
        return word


def _sized(size: str, delimiter: str) -> Atom:
    if delimiter == ".":
        return Atom(size + delimiter, None)
    return replace(_symbol(delimiter), latex=size + delimiter, leaf=False)


def _symbol(token: str) -> Atom:
    family = "ord"
    if token in table.BINARY_OPERATORS:
        family = "bin"
    elif token in table.RELATIONS:
        family = "rel"
    glyph = table.SYMBOLS[token]
    meant = table.SAME.get(glyph, glyph)
    return Atom(token, meant, meant, leaf=True, family=family, glyphs=glyph)
