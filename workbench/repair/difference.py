"""What differs between a printed formula and a proposed one, token by token.

Tokens are what a reader would point at: a letter with its fonts and accents, a number, a sign; and the
openings and closings of scripts, fractions and wide accents. What only formats is no difference: spacing,
alignment, which command makes bold, braces that group nothing, the size of brackets and, outside of scripts,
their shape. Any text has tokens, also one that cannot be read.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from difflib import SequenceMatcher

_RAW = re.compile(r"\\[A-Za-z]+\*?|\\.|\d+(?:\.\d+)?|\S", re.DOTALL)
_FORMATTING = re.compile(r"\\(?:left|right|[bB]igg?[lrm]?|displaystyle|quad|qquad|limits|[,;:! ])$|~$")
_BOLD = frozenset(("\\mathbf", "\\boldsymbol", "\\bm", "\\bf"))
_SAME = {"\\ne": "\\neq", "\\top": "T", "\\triangleq": "=", "\\dfrac": "\\frac", "\\tfrac": "\\frac",
         "\\widetilde": "\\tilde", "\\iff": "\\Leftrightarrow", "\\implies": "\\Rightarrow",
         "\\lvert": "|", "\\rvert": "|", "\\lVert": "\\|", "\\rVert": "\\|"}  # fmt: skip
#: Fonts and accents, from the letter outwards.
_MARKS = ("\\mathrm", "\\mathcal", "\\mathbb", "\\mathbf", "\\underline", "\\overline", "\\bar", "\\hat",
          "\\vec", "\\tilde", "\\dot", "\\ddot", "\\dddot", "\\ddddot")  # fmt: skip
_WORDS = frozenset(("\\text", "\\operatorname", "\\operatorname*", "\\textrm", "\\mbox"))
_TWO_ARGUMENTS = frozenset(("\\frac", "\\binom", "\\overset", "\\stackrel", "\\underset"))

#: How what is only printed, and what is only proposed, is marked in plain text.
REMOVED = ("[-", "-]")
ADDED = ("{+", "+}")
_ALIGNED = frozenset(("aligned", "align", "split", "gathered"))
_ROUND = {"[": "(", "]": ")"}
_DEEPEST = 80


@dataclass(frozen=True)
class Token:
    """text: its LaTeX; leaf: it can stand alone, so that it can be highlighted; of: what a brace closes."""

    text: str
    leaf: bool = True
    marks: tuple[str, ...] = ()
    of: str = ""

    @property
    def latex(self) -> str:
        text = self.text
        for mark in self.marks:
            name = "\\boldsymbol" if mark == "\\mathbf" and text.startswith("\\") else mark
            text = f"{name}{{{text}}}"
        return text

    def with_mark(self, mark: str) -> Token:
        return replace(self, marks=tuple(sorted({*self.marks, mark}, key=_MARKS.index)))


@dataclass(frozen=True)
class Part:
    """A stretch of the formula: what is printed there and what is proposed; the same tokens if `same`."""

    printed: tuple[Token, ...]
    proposed: tuple[Token, ...]
    same: bool


@dataclass(frozen=True)
class Difference:
    """Two formulas side by side. The printed parts in a row are the printed formula, the proposed parts the
    proposed one."""

    parts: tuple[Part, ...]

    def __bool__(self) -> bool:
        return any(not part.same for part in self.parts)

    @property
    def printed(self) -> str:
        return _joined(token for part in self.parts for token in part.printed)

    @property
    def proposed(self) -> str:
        return _joined(token for part in self.parts for token in part.proposed)

    def to_list(self) -> list[dict[str, str]]:
        """For JSON: {"same": latex}, or {"printed": latex, "proposed": latex}, either of which may be ""."""
        return [
            {"same": _joined(part.printed)}
            if part.same
            else {"printed": _joined(part.printed), "proposed": _joined(part.proposed)}
            for part in self.parts
        ]

    def __str__(self) -> str:
        """In one line of plain text: [-only printed-] and {+only proposed+}."""
        pieces = []
        for part in self.parts:
            if part.same:
                pieces.append(_joined(part.printed))
                continue
            for tokens, (opening, closing) in (
                (part.printed, REMOVED),
                (part.proposed, ADDED),
            ):
                if tokens:
                    pieces.append(f"{opening}{_joined(tokens)}{closing}")
        return " ".join(pieces)

    def highlighted(self, mark: Callable[[str], str], proposed: bool = True) -> str:
        """LaTeX of the proposed formula (or the printed one) with each leaf that differs passed through
        `mark`; where a script, a fraction or a wide accent differs, all that is in it."""
        pieces, depth = [], 0  # depth: of the braces since one that differs
        for part in self.parts:
            for token in part.proposed if proposed else part.printed:
                is_new = not part.same or depth > 0
                pieces.append(mark(token.latex) if is_new and token.leaf else token.latex)
                opened = 0 if token.leaf else token.text.count("{") - token.text.count("}")
                if depth > 0 or (not part.same and opened > 0):
                    depth = max(0, depth + opened)
        return _spaced(pieces)


def difference(printed: str, proposed: str) -> Difference:
    """What differs between two formulas in LaTeX."""
    first, second = tokens_of(printed), tokens_of(proposed)
    matcher = SequenceMatcher(None, first, second, autojunk=False)
    return Difference(
        tuple(
            Part(tuple(first[a:b]), tuple(second[c:d]), operation == "equal")
            for operation, a, b, c, d in matcher.get_opcodes()
        )
    )


def in_colour(latex: str) -> str:
    """What MathJax sets in green: notebooks and Markdown."""
    return f"{{\\color{{green}}{{{latex}}}}}"


def tokens_of(latex: str) -> list[Token]:
    """The tokens of a formula, in canonical form; braces that are never opened or closed stay as they are."""
    raw = [_SAME.get(t, t) for t in _RAW.findall(latex) if not _FORMATTING.match(t)]
    return _Tokens(raw).sequence()


def _joined(tokens: Iterable[Token]) -> str:
    return _spaced(token.latex for token in tokens)


def _spaced(pieces: Iterable[str]) -> str:
    """The pieces with a space between, but none just inside of braces and before scripts."""
    text = ""
    for piece in pieces:
        is_close = not text or text.endswith("{") or piece.startswith(("_{", "^{", "}"))
        text += piece if is_close else f" {piece}"
    return text


class _Tokens:
    def __init__(self, raw: Sequence[str]) -> None:
        self.raw = raw
        self.place = 0
        self.depth = 0
        self.in_scripts = 0
        self.aligned = 0

    def peek(self) -> str | None:
        return self.raw[self.place] if self.place < len(self.raw) else None

    def take(self) -> str:
        self.place += 1
        return self.raw[self.place - 1]

    def sequence(self, closing: str | None = None) -> list[Token]:
        tokens: list[Token] = []
        while self.peek() is not None and self.peek() != closing:
            tokens += self.item()
        if closing is not None and self.peek() == closing:
            self.take()
        return tokens

    def item(self) -> list[Token]:
        """One thing with its scripts, the subscript first."""
        nucleus = [] if self.peek() in ("_", "^") else self.nucleus()
        scripts: dict[str, list[Token]] = {}
        while self.peek() in ("_", "^") and self.peek() not in scripts:
            sign = self.take()
            self.in_scripts += 1
            scripts[sign] = _enclosed(sign + "{", self.argument())
            self.in_scripts -= 1
        if scripts and len(nucleus) > 1 and _is_group(nucleus):
            nucleus = _enclosed("{", nucleus)
        return [*nucleus, *scripts.get("_", ()), *scripts.get("^", ())]

    def nucleus(self) -> list[Token]:
        token = self.take()
        if token == "{" and self.depth < _DEEPEST:
            self.depth += 1
            inner = self.sequence("}")
            self.depth -= 1
            return inner or [Token("{}")]
        if token in _WORDS:
            return [self.word(token)]
        if token == "\\begin" or token == "\\end":
            name = self.name()
            if name in _ALIGNED:
                self.aligned += 1 if token == "\\begin" else -1
                return []
            return [Token(f"{token}{{{name}}}", False)]
        if self.aligned > 0 and token in ("&", "\\\\"):
            return []
        if not self.in_scripts:
            token = _ROUND.get(token, token)
        if token in _TWO_ARGUMENTS:
            first, second = self.argument(), self.argument()
            if token in ("\\stackrel", "\\overset") and [t.text for t in second] == ["="]:
                return second
            return _enclosed(token + "{", first, second)
        mark = "\\mathbf" if token in _BOLD else token
        if mark in _MARKS:
            return self.marked(mark)
        return [Token(token, token not in ("{", "}", "&", "\\\\"))]

    def argument(self) -> list[Token]:
        return self.nucleus() if self.peek() not in (None, "}", "^", "_", "&") else []

    def marked(self, mark: str) -> list[Token]:
        inner = self.argument()
        if inner and inner[0].leaf and _is_one_symbol(inner):
            return [inner[0].with_mark(mark), *inner[1:]]
        if mark == "\\mathrm" and inner and all(t.leaf and t.text.isalpha() for t in inner):
            return [_word("".join(t.text for t in inner))]
        wide = "\\widetilde" if mark == "\\tilde" else mark
        return _enclosed(wide + "{", inner)

    def word(self, command: str) -> Token:
        return _word(self.name()) if self.peek() == "{" else Token(command)

    def name(self) -> str:
        if self.peek() != "{":
            return ""
        self.take()
        start = self.place
        while self.peek() not in (None, "}"):
            self.take()
        name = "".join(self.raw[start : self.place])
        if self.peek() == "}":
            self.take()
        return name


def _enclosed(opening: str, inner: Sequence[Token], between: Sequence[Token] = ()) -> list[Token]:
    """{inner}, or {inner}{between} for a command of two arguments."""
    more = [Token("}{", False, of=opening), *between] if opening[:-1] in _TWO_ARGUMENTS else []
    return [Token(opening, False), *inner, *more, Token("}", False, of=opening)]


def _word(name: str) -> Token:
    return Token(f"\\operatorname{{{name}}}")


def _is_one_symbol(tokens: Sequence[Token]) -> bool:
    """Whether all after the first token are its scripts."""
    depth = 0
    for place, token in enumerate(tokens[1:], start=1):
        if depth == 0 and token.text not in ("_{", "^{"):
            return False
        depth += 0 if token.leaf else token.text.count("{") - token.text.count("}")
        if depth < 0 or (depth > 0 and place == len(tokens) - 1):
            return False
    return True


def _is_group(tokens: Sequence[Token]) -> bool:
    """Whether what was in braces is more than one symbol, fraction or wide accent."""
    if tokens[0].leaf:
        return not _is_one_symbol(tokens)
    depth = 0
    for token in tokens[:-1]:
        depth += 0 if token.leaf else token.text.count("{") - token.text.count("}")
        if depth <= 0:
            return True
    return False
