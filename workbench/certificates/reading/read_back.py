"""Parser of the emitted subset of Coq: from the text of a statement to expressions.

A statement consists of definitions (`let x := … in`), premises (`… ->`) and a conclusion. Its expressions are
those that `emitter.py` writes. `meaning.py` compares them with the certified typed term, so that the text is
known to state the term.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction

_SIGNS = {"+": 50, "-": 50, "•": 40, "·": 40, "×": 40, "⊗": 40, "∘": 40, "@": 40, "⊕": 50, "⊚": 40}
_TOKEN = re.compile(r"\s*(<->|->|:=|=>|<=|%nat|/\\|≡ε|[()+\-•·×⊗∘@⊕⊚≡:,#~]|[A-Za-z_][\w']*|\d+)")


class Unread(ValueError):
    """A text outside the emitted subset."""


@dataclass(frozen=True)
class Expression:
    """An operation or a name with its arguments, as written in the text."""

    head: str
    arguments: tuple[Expression, ...] = ()

    def __str__(self) -> str:
        return self.at(100)

    def at(self, level: int) -> str:
        """Returns the text as the emitter writes it in a context of this precedence level."""
        text, own = self._text()
        return text if own <= level else f"({text})"

    def _text(self) -> tuple[str, int]:
        if self.head in _SIGNS and len(self.arguments) == 2:
            left, right = self.arguments
            level = _SIGNS[self.head]
            return f"{left.at(level)} {self.head} {right.at(level - 1)}", level
        if self.head == "neg":
            return f"- {self.arguments[0].at(35)}", 35
        if self.head == ":":
            return f"({self.arguments[0].at(100)} : {self.arguments[1]})", 0
        if self.head == "#":
            above = str(self.arguments[0]).replace("- ", "-")
            return f"({above} # {self.arguments[1]})", 0
        if self.head == "fun":
            return f"(fun {self.arguments[0]} => {self.arguments[1].at(100)})", 0
        if self.head == "":
            return " ".join(a.at(0) for a in self.arguments), 10
        return self.head, 0


class Parser:
    def __init__(self, text: str) -> None:
        self.tokens = _tokens(text)
        self.place = 0

    def peek(self) -> str:
        return self.tokens[self.place] if self.place < len(self.tokens) else ""

    def take(self, expected: str | None = None) -> str:
        token = self.peek()
        if not token or (expected is not None and token != expected):
            raise Unread(f"expected {expected or 'an expression'}, got {token or 'the end'}")
        self.place += 1
        return token

    def expression(self, level: int = 100) -> Expression:
        if self.peek() == "-":
            self.take()
            left = Expression("neg", (self.expression(35),))
        else:
            left = self.application()
        while (sign := self.peek()) in _SIGNS and _SIGNS[sign] <= level:
            self.take()
            left = Expression(sign, (left, self.expression(_SIGNS[sign] - 1)))
        return left

    def application(self) -> Expression:
        parts = [self.atom()]
        while self.peek() and (self.peek() == "(" or re.match(r"[A-Za-z_\d]", self.peek())):
            parts.append(self.atom())
        return parts[0] if len(parts) == 1 else Expression("", tuple(parts))

    def atom(self) -> Expression:
        token = self.take()
        if token != "(":
            if not re.match(r"[A-Za-z_\d]", token):
                raise Unread(f"expected a name, got {token}")
            return Expression(token + self.take() if self.peek() == "%nat" else token)
        if self.peek() == "fun":
            self.take()
            name = self.application()
            self.take("=>")
            made = Expression("fun", (name, self.expression()))
            self.take(")")
            return made
        inner = self.expression()
        if self.peek() in (":", "#"):
            sign = self.take()
            inner = Expression(sign, (inner, self.application()))
        self.take(")")
        return inner


def _tokens(text: str) -> list[str]:
    tokens, at = [], 0
    text = text.rstrip()
    while at < len(text):
        found = _TOKEN.match(text, at)
        if found is None:
            raise Unread(f"a sign outside the subset: {text[at : at + 10]!r}")
        tokens.append(found[1])
        at = found.end()
    return tokens


def expression(text: str) -> Expression:
    parser = Parser(text)
    made = parser.expression()
    if parser.peek():
        raise Unread(f"{parser.peek()} after the end of an expression")
    return made


def number(made: Expression) -> Fraction:
    if made.head == "#":
        above, below = made.arguments
        sign = -1 if above.head == "neg" else 1
        return sign * Fraction(int((above.arguments[0] if sign < 0 else above).head), int(below.head))
    return Fraction(int(made.head))
