"""Tokens of TeX with their origin, read lazily from a view of the author's text."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from workbench.core.brackets import end_of_group
from workbench.source.documents.source_view import Source, View

_TOKEN = re.compile(
    r"""\\(?P<word>[A-Za-z@]+)(?P<gap>[ \t]*(?:\n(?![ \t]*\n)[ \t]*)?)
    | \\(?P<symbol>.|\n)
    | %(?P<comment>[^\n]*)(?:\n[ \t]*(?P<blank>\n\s*)?)?
    | (?P<paragraph>\n[ \t]*\n\s*)
    | (?P<space>\s+)
    | \#+\d
    | .""",
    re.VERBOSE | re.DOTALL,
)
#: A comment, for those who look for words only.
COMMENT = re.compile(r"(?<!\\)%[^\n]*")
_PROSE = re.compile(r"(?:[^\\$%\n{}]|\n(?![ \t]*\n))+")
_PROSE_OF_CELL = re.compile(r"(?:[^\\$%\n{}&]|\n(?![ \t]*\n))+")
_LETTERS = re.compile(r"[A-Za-z]+")

PARAGRAPH = "\\par"


@dataclass(frozen=True, slots=True)
class Call:
    """A use of a macro, from which the tokens of its body come."""

    name: str
    outer: Call | None
    depth: int

    def chain(self) -> Iterator[Call]:
        """Yields this call and the enclosing ones, the innermost first."""
        call: Call | None = self
        while call is not None:
            yield call
            call = call.outer


@dataclass(slots=True)
class Token:
    """A token. `start` to `end`: its characters in the source; for a token of a macro's body, those of the
    call.

    final: it has TeX's meaning, even if the author has redefined it.
    """

    text: str
    source: Source
    start: int
    end: int
    call: Call | None = None
    final: bool = False

    @property
    def word(self) -> str | None:
        """The name of a control sequence, without its backslash."""
        return self.text[1:] if len(self.text) > 1 and self.text[0] == "\\" else None

    def standing_for(self, text: str) -> Token:
        """Returns another token at the same position."""
        return Token(text, self.source, self.start, self.end, self.call)


class Lexer:
    """The tokens of a view, read lazily: \\makeatletter and \\verb change the rules for what follows."""

    def __init__(
        self, view: View, directive: Callable[[str, Source, int], None] | None = None, at_letter: bool = False
    ) -> None:
        self.view, self.text, self.directive, self.at_letter = view, view.text, directive, at_letter
        self.position = 0

    def next(self) -> Token | None:
        while self.position < len(self.text):
            match = _TOKEN.match(self.text, self.position)
            assert match is not None, "the pattern takes every character"
            self.position = match.end()
            match match.lastgroup:
                case "word" | "gap":
                    return self._word(match)
                case "comment" | "blank":
                    if self.directive and match["comment"].startswith("!"):
                        offset = self.view.at[match.start()]
                        self.directive(match["comment"][1:], self.view.source, offset)
                    if match["blank"] is not None:
                        return self._token(PARAGRAPH, match.end() - 1, match.end())
                case "paragraph":
                    return self._token(PARAGRAPH, match.start(), match.start() + 1)
                case "space":
                    return self._token(" ", match.start(), match.start() + 1)
                case _:
                    return self._token(match[0], match.start(), match.end())
        return None

    def skip_prose(self, in_cell: bool = False) -> None:
        """Moves to the next character with a meaning outside formulas."""
        if match := (_PROSE_OF_CELL if in_cell else _PROSE).match(self.text, self.position):
            self.position = match.end()

    def skip_past(self, mark: str) -> str | None:
        """Returns the characters up to `mark`, and moves past it; at the end of the text returns None."""
        found = self.text.find(mark, self.position)
        start, self.position = self.position, len(self.text) if found < 0 else found + len(mark)
        return None if found < 0 else self.text[start:found]

    def _word(self, match: re.Match[str]) -> Token:
        name = match["word"]
        if "@" in name and not self.at_letter:
            letters = _LETTERS.match(name)
            if letters is None:  # \@ is a control symbol
                self.position = match.start() + 2
                return self._token("\\@", match.start(), match.start() + 2)
            name = letters[0]
            self.position = match.start() + 1 + len(name)
        return self._token(f"\\{name}", match.start(), match.start() + 1 + len(name))

    def _token(self, text: str, start: int, end: int) -> Token:
        at = self.view.at
        return Token(text, self.view.source, at[start], at[end - 1] + 1)


def lex(view: View) -> list[Token]:
    lexer = Lexer(view)
    return list(iter(lexer.next, None))


def tokens_of(latex: str) -> list[Token]:
    """Returns the tokens of a formula without macros; `start` and `end` are offsets in it."""
    return lex(Source(Path(), latex).view())


def first_group(tokens: Sequence[Token]) -> tuple[list[Token], list[Token]]:
    """Returns the first token, with braces the whole group, and the tokens after it."""
    end = end_of_group(token.text for token in tokens) or len(tokens)
    return list(tokens[:end]), list(tokens[end:])


def joined(tokens: Iterable[Token]) -> str:
    return spelled(tokens)[0]


def spelled(tokens: Iterable[Token]) -> tuple[str, list[Token]]:
    """Returns the LaTeX of the tokens, and for each of its characters the token."""
    pieces: list[str] = []
    owners: list[Token] = []
    after_word: Token | None = None
    for token in tokens:
        text = " " if token.text == PARAGRAPH else token.text
        if after_word is not None and text[0].isalpha():
            pieces.append(" ")
            owners.append(after_word)
        pieces.append(text)
        owners += [token] * len(text)
        after_word = token if token.word and token.text[-1].isalpha() else None
    return "".join(pieces), owners
