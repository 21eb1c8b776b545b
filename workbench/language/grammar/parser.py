"""The parser: LALR grammar, from tokens to syntax nodes."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from pathlib import Path
from typing import Any, cast

from lark import Lark, Token, Transformer
from lark.exceptions import UnexpectedInput
from lark.lexer import Lexer

from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault
from workbench.core.operations import FUNCTIONS
from workbench.language.grammar.formula_tokens import MOST_CHARACTERS, tokenize
from workbench.language.grammar.syntax import (
    Accented,
    Binomial,
    Bracket,
    Chain,
    Conditional,
    Extremal,
    Fraction,
    Given,
    Group,
    Infix,
    Integration,
    Joined,
    Leaf,
    Lines,
    Matrix,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
    Summation,
    core,
    in_a_row,
)


class _Builder(Transformer):
    """Builds nodes from grammar rules; a rule with one child returns that child."""

    def start(self, children):
        return children[0]

    def lines(self, children):
        rows = [child for child in children if isinstance(child, list)]
        return Lines(rows[0][0].at if rows[0] else 0, tuple(tuple(row) for row in rows if row))

    def line(self, children):
        return [child for child in children if isinstance(child, Node)]

    def clause(self, children):
        if len(children) == 1:
            return children[0]
        signs = tuple((str(sign), sign.start_pos) for sign in children[1::2])
        return Conditional(children[0].at, tuple(children[::2]), signs)

    def joined(self, children):
        statements = tuple(child for child in children if isinstance(child, Node))
        return statements[0] if len(statements) == 1 else Joined(statements[0].at, statements)

    def given(self, children):
        return Given(children[0].start_pos, tuple(c for c in children if isinstance(c, Node)))

    def statement(self, children):
        universal = isinstance(children[0], Token)
        parts = children[universal:]
        if len(parts) == 1 and not universal:
            inner = core(parts[0])
            return inner if isinstance(inner, Chain) else parts[0]
        relations = tuple((str(sign), sign.start_pos) for sign in parts[1::2])
        return Chain(parts[0].at, tuple(parts[::2]), relations, universal)

    def sum(self, children):
        if len(children) == 1:
            return children[0]
        addends, sign = [], ("", children[0].at if isinstance(children[0], Node) else 0)
        for child in children:
            if isinstance(child, Token):
                sign = (str(child), child.start_pos)
            elif sign[0] == "-" and addends and _lacks_body(addends[-1][2]):
                *before, head = addends.pop()
                items = head.items if isinstance(head, Product) else (head,)
                body = Group(sign[1], (Sum(sign[1], ((*sign, child),)),))
                addends.append((*before, Product(head.at, (*items, body))))
            else:
                addends.append((*sign, child))
        return (
            addends[0][2] if len(addends) == 1 and not addends[0][0] else Sum(addends[0][1], tuple(addends))
        )

    def product(self, children):
        return in_a_row(children[0].at, children)

    def infix(self, children):
        return Infix(children[0].start_pos, str(children[0]))

    def summation(self, children):
        at = children[0].start_pos
        sub, sup, primes, factorial = _scripts(children[1:])
        if primes or factorial:
            raise Fault(SyntaxCode.SUM_HAS_LOWER_UPPER(), at)
        return (
            Summation(at, sub, sup) if children[0] == "sum" else Integration(at, sub, sup, str(children[0]))
        )

    def extremal(self, children):
        at = children[0].start_pos
        sub, sup, primes, factorial = _scripts(children[1:])
        if primes or factorial or sup is not None:
            raise Fault(SyntaxCode.EXPECTED_NOTHING_BUT_LETTERS(), at)
        return Extremal(at, children[0] == "min", sub)

    def factor(self, children):
        nucleus, *scripts = children
        return Scripted(nucleus.at, nucleus, *_scripts(scripts)) if scripts else nucleus

    def sup(self, children):
        return ("sup", children[0].start_pos, _braced(children[1]))

    def sub(self, children):
        return ("sub", children[0].start_pos, _braced(children[1]))

    def prime(self, children):
        return ("prime", children[0].start_pos, None)

    def bang(self, children):
        return ("bang", children[0].start_pos, None)

    def leaf(self, children):
        token = children[0]
        if token.type == "FUNCTION":
            name = token.removeprefix("\\")
            return Leaf(token.start_pos, token.type, FUNCTIONS.get(name, name), name, bare=name == token)
        return Leaf(token.start_pos, token.type, str(token))

    def group(self, children):
        return Group(children[0].start_pos, children[1] if isinstance(children[1], tuple) else ())

    def list(self, children):
        return tuple(child for child in children if isinstance(child, Node))

    def bracket(self, children):
        """Returns a bracket. [ and ] around a matrix without brackets belong to the matrix; ||x|| is one
        sign."""
        kind, parts = str(children[0]), children[1]
        inner = core(parts[0]) if len(parts) == 1 else None
        if kind == "[" and isinstance(inner, Matrix) and inner.bare:
            return replace(inner, bare=False)
        if kind == "|" and isinstance(inner, Bracket) and inner.kind == "|":
            kind, parts = "\\|", inner.parts
        return Bracket(children[0].start_pos, kind, parts)

    def styled(self, children):
        return Styled(children[0].start_pos, str(children[0]), _braced(children[1]))

    def accented(self, children):
        return Accented(children[0].start_pos, str(children[0]), _braced(children[1]))

    def fraction(self, children):
        return Fraction(children[0].start_pos, _braced(children[1]), _braced(children[2]))

    def binomial(self, children):
        return Binomial(children[0].start_pos, _braced(children[1]), _braced(children[2]))

    def row(self, children):
        return _Cells(tuple(children[::2]), tuple(children[1::2]))

    def matrix(self, children):
        begin, cells = children[0], [child for child in children if isinstance(child, _Cells)]
        rows = tuple(without_room(cells, begin.end_pos))
        return Matrix(begin.start_pos, rows, str(begin) in ("matrix", "smallmatrix", "array"))

    def environment(self, children):
        return children[1]


@dataclass(frozen=True)
class _Cells:
    """A row of a matrix: the contents of its cells, None for an empty cell, and the marks between them."""

    contents: tuple[Node | None, ...]
    marks: tuple[Token, ...]

    @property
    def room(self) -> frozenset[int]:
        """Returns the empty columns between the two marks of &&."""
        doubled = (place for place, mark in enumerate(self.marks) if mark == "&&")
        return frozenset(place for place in doubled if self.contents[place] is None)

    def nodes(self, left_out: Collection[int], at: int) -> tuple[Node, ...]:
        """Returns the entries; an empty one is {}, at the mark before it."""
        places = [at, *(mark.start_pos or 0 for mark in self.marks)]
        cells = zip(self.contents, places, strict=True)
        kept = (cell for place, cell in enumerate(cells) if place not in left_out)
        return tuple(Group(where, ()) if node is None else node for node, where in kept)


def without_room(rows: Sequence[_Cells], at: int) -> Iterator[tuple[Node, ...]]:
    """Yields the entries of the rows.

    Two marks && in each row leave space between two columns, and also if the rows have equally many entries
    only without it. A line break after the last row begins no row.
    """
    if len(rows) > 1 and rows[-1].contents == (None,):
        rows = rows[:-1]
    shared = frozenset.intersection(*(row.room for row in rows))
    is_even = len({len(row.contents) for row in rows}) == 1
    for row in rows:
        yield row.nodes(shared if is_even else row.room, at)


def _lacks_body(node: Node) -> bool:
    """True if the node ends in a \\sum, as before the sign of \\sum_i -x_i."""
    return isinstance(node.items[-1] if isinstance(node, Product) else node, Summation)


def _braced(argument: Node) -> Node:
    """Returns the argument of a command. Raises Fault for a number without braces: TeX takes one digit of
    it."""
    if isinstance(argument, Leaf) and argument.kind == "NUMBER" and len(argument.text) > 1:
        raise Fault(SyntaxCode.TEX_TAKES_ONLY_FIRST(text=argument.text), argument.at)
    return argument


def _scripts(scripts: Sequence[tuple[str, int, Node | None]]) -> tuple[Node | None, Node | None, int, bool]:
    """Returns the subscript, the superscript, the number of primes, and whether there is a factorial."""
    found: dict[str, Node | None] = {}
    primes, factorial = 0, False
    for kind, at, body in scripts:
        if factorial:
            raise Fault(SyntaxCode.NOTHING_MAY_FOLLOW_FACTORIAL(), at)
        if kind == "prime":
            primes += 1
        elif kind == "bang":
            factorial = True
        elif kind in found:
            raise Fault(f"a second {kind}erscript".replace("suberscript", "subscript"), at)
        else:
            found[kind] = body
    return found.get("sub"), found.get("sup"), primes, factorial


class _Tokens(Lexer):
    def __init__(self, lexer_conf) -> None:
        pass

    def lex(self, data: Any) -> Any:  # type: ignore[override]  # called with the text alone
        return tokenize(data)


@cache
def _parser() -> Lark:
    grammar = (Path(__file__).parent / "formula.lark").read_text(encoding="utf-8")
    return Lark(grammar, parser="lalr", lexer=_Tokens, transformer=_Builder(), maybe_placeholders=True)


_NAMES = {
    "BREAK": "the end of the line",
    "RBRACE": "}",
    "CLOSE": "the closing bracket",
    "END_MATRIX": "the end of the matrix",
    "END_LINES": "the end of the environment",
    "$END": "the end of the formula",
}


@lru_cache(maxsize=4096)
def parse(text: str) -> Lines:
    """Returns the lines of a formula. Raises Fault."""
    if len(text) > MOST_CHARACTERS:
        raise Fault(SyntaxCode.FORMULA_CHARACTERS_UP_READ(text=len(text), MOST_CHARACTERS=MOST_CHARACTERS), 0)
    try:
        return cast(Lines, _parser().parse(text))
    except UnexpectedInput as error:
        token = getattr(error, "token", None)
    # Raised outside of the handler: the context of a fault would hold the parser, which cannot be pickled.
    if token is None or token.type == "$END":
        raise Fault(SyntaxCode.FORMULA_ENDS_TOO_EARLY(), len(text))
    shown = _NAMES.get(token.type, str(token))
    raise Fault(SyntaxCode.UNEXPECTED_TOKEN(shown=shown), token.start_pos)


@cache
def parses(text: str) -> bool:
    """True if the text is syntactically a formula."""
    try:
        parse(text)
    except Fault:
        return False
    return True
