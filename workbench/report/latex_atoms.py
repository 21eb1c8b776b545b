"""LaTeX formulas as flat lists of atoms: what is compared, highlighted and typeset.

This is not the claim language: a printed form may be garbled and must still be shown. An atom is the
smallest part a reader would point at: a symbol with its marks, a sign, a number, a function name.
Braces, scripts, fractions, tables and sized delimiters are atoms too, but only leaves can be marked.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace

from workbench.report import glyphs as table

_TOKEN = re.compile(r"\\[A-Za-z]+\*?|\\.|\d+|\s+|.", re.DOTALL)
_DEEPEST = 60
_COLUMNS = {"cases": 2, "gathered": 1, "split": 2, "aligned": 8}


class LatexNotTypesettable(ValueError):
    """The formula holds something the report cannot typeset for certain; it is shown as source."""


@dataclass(frozen=True)
class Atom:
    """latex: its source. identity: what it is compared by (None: it does not count).

    shape: the identity with bold and upright letters taken as the same. leaf: it may be marked by itself.
    """

    latex: str
    identity: str | None
    shape: str | None = None
    leaf: bool = False
    family: str = "ord"
    glyphs: str = ""

    @property
    def is_accent(self) -> bool:
        """A mark over (or under) several symbols, opening."""
        return not self.leaf and self.latex[:-1] in table.ACCENTS

    @property
    def is_script(self) -> bool:
        """The opening of an exponent or index."""
        return self.latex in ("^{", "_{")


def atoms_of(latex: str) -> list[Atom]:
    """The atoms of a formula. Raises LatexNotTypesettable, naming what is unknown or unbalanced."""
    return _Parser(latex).formula()


def latex_of(
    atoms: Sequence[Atom],
    marked: Collection[int] = (),
    mark: Callable[[Atom], str] | None = None,
) -> str:
    """LaTeX of the atoms, with each marked leaf passed through `mark`."""
    pieces = [
        mark(atom) if mark and index in marked and atom.leaf else atom.latex
        for index, atom in enumerate(atoms)
    ]
    return " ".join(pieces)


def _closing(latex: str = "}", identity: str | None = None) -> Atom:
    return Atom(latex, identity, identity)


class _Parser:
    def __init__(self, latex: str):
        self.tokens = [token for token in _TOKEN.findall(latex)]
        self.position = 0
        self.depth = 0

    def formula(self) -> list[Atom]:
        atoms = self.sequence()
        if self.peek() is not None:
            raise LatexNotTypesettable(f"unexpected {self.peek()}")
        return atoms

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
        """Items up to a closing; `columns` of a table row, 0 outside tables."""
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
            return [Atom("{", None), *inner, _closing()]
        if token in ("^", "_"):
            return [Atom(token + "{", token, token), *self.argument(), _closing()]
        if token in ("&", r"\\"):
            return [Atom(token, token, token)]
        if token in table.SPACES:
            return [Atom(token, None)]
        if token in table.SYMBOLS:
            return [_symbol(token)]
        if token in table.ACCENTS:
            return self.accent(token)
        if token in table.STYLES:
            return self.style(token)
        if token in table.TEXT_COMMANDS:
            return [self.text(token)]
        if token in table.TWO_ARGUMENTS:
            return self.two_arguments(token)
        if token == r"\sqrt":
            return [Atom(r"\sqrt{", "√", "√"), *self.argument(), _closing()]
        if token == r"\left":
            return self.left_right()
        if token in table.SIZES:
            delimiter = self.delimiter()
            sized = Atom(token + delimiter, delimiter, delimiter)
            return [replace(sized, glyphs=_glyph(delimiter))]
        if token == r"\begin":
            return self.environment()
        if token.isascii() and token.isalnum():
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

    def accent(self, command: str) -> list[Atom]:
        return self.decorated(command, "~" if command == r"\widetilde" else command[1:])

    def style(self, command: str) -> list[Atom]:
        return self.decorated(command, command[1:])

    def decorated(self, command: str, name: str) -> list[Atom]:
        """One leaf where a single symbol is decorated, else an opening, the content and a brace."""
        inner = self.argument()
        name = {"tilde": "~"}.get(name, name)
        mark = table.ACCENTS.get(command, "")
        counted = [atom for atom in inner if atom.identity is not None]
        word = command in table.STYLES and all(re.fullmatch("[A-Za-z]", a.latex) for a in counted)
        if counted and (word or (len(counted) == 1 and counted[0].leaf)):
            content = "".join(atom.latex for atom in counted) if word else latex_of(inner)
            shape = "".join(atom.shape or "" for atom in counted)
            identity = "".join(atom.identity or "" for atom in counted)
            plain = command in table.WEIGHT_STYLES
            return [
                Atom(
                    f"{command}{{{content}}}",
                    f"{name}({identity})",
                    shape if plain else f"{name}({shape})",
                    leaf=True,
                    glyphs="".join(atom.glyphs for atom in counted) + mark,
                )
            ]
        opening = Atom(f"{command}{{", name, name, glyphs=mark)
        return [opening, *inner, _closing()]

    def text(self, command: str) -> Atom:
        self.expect("{")
        content = ""
        while self.position < len(self.tokens) and self.tokens[self.position] != "}":
            content += self.tokens[self.position]
            self.position += 1
        self.expect("}")
        if not re.fullmatch(r"[A-Za-z0-9 ,.;:()=+\-]*", content):
            raise LatexNotTypesettable(f"cannot typeset {command}{{{content}}}")
        return Atom(f"{command}{{{content}}}", content, content, leaf=True, glyphs=content)

    def two_arguments(self, command: str) -> list[Atom]:
        first, second = self.argument(), self.argument()
        opening = Atom(command + "{", command, command)
        if command == r"\binom":
            opening = replace(opening, glyphs="()")
        return [opening, *first, Atom("}{", "}{", "}{"), *second, _closing()]

    def delimiter(self) -> str:
        token = self.take()
        if token not in table.DELIMITERS:
            raise LatexNotTypesettable(f"expected a delimiter, got {token}")
        return token

    def left_right(self) -> list[Atom]:
        opening = self.delimiter()
        inner = self.sequence()
        self.expect(r"\right")
        ends = [opening, self.delimiter()]
        left, right = (
            Atom(f"{side}{end}", end, end, glyphs="" if end == "." else _glyph(end))
            for side, end in zip((r"\left", r"\right"), ends, strict=True)
        )
        return [left, *inner, right]

    def environment(self) -> list[Atom]:
        name = self.brace_word()
        if name not in table.ENVIRONMENTS:
            raise LatexNotTypesettable(f"cannot typeset the environment {name}")
        columns = "{" + self.brace_word() + "}" if name == "array" else ""
        width = len(columns) - 2 if columns else _COLUMNS.get(name, 10)
        inner = self.sequence(width)
        self.expect(r"\end")
        ended = self.brace_word()
        if ended != name:
            raise LatexNotTypesettable(f"{name} is ended by {ended}")
        fences = {"cases": "{", "bmatrix": "[]", "pmatrix": "()", "vmatrix": "||"}.get(name, "")
        begin = Atom(f"\\begin{{{name}}}{columns}", name, name, glyphs=fences)
        return [begin, *inner, _closing(f"\\end{{{name}}}", f"end {name}")]

    def brace_word(self) -> str:
        self.expect("{")
        word = ""
        while (token := self.take()) != "}":
            if not token.isalpha():
                raise LatexNotTypesettable(f"expected a name in braces, got {token}")
            word += token
        return word


def _glyph(symbol: str) -> str:
    return table.SYMBOLS[symbol]


def _symbol(token: str) -> Atom:
    family = "ord"
    if token in table.BINARY_OPERATORS:
        family = "bin"
    elif token in table.RELATIONS:
        family = "rel"
    glyph = _glyph(token)
    return Atom(token, glyph, glyph, leaf=True, family=family, glyphs=glyph)
