"""The input stack of files and expansions, and TeX's ways of reading arguments."""

from __future__ import annotations

from collections.abc import Sequence

from workbench.core.brackets import nesting
from workbench.source.documents.tex.tex_tokens import PARAGRAPH, Lexer, Token, joined

#: Limit on the expansion of one token, which only recursive macros exceed.
MOST_PUSHED = 100_000


class TokenStream:
    """A stack of tokens and files; those to be read later are deeper."""

    def __init__(self) -> None:
        self.waiting: list[Token | Lexer] = []
        self.pushed = 0
        self.contained = 0  # number of arguments being read: none extends past the end of its file

    def open(self, lexer: Lexer) -> None:
        self.waiting.append(lexer)

    def push(self, tokens: Sequence[Token]) -> None:
        self.pushed += len(tokens)
        self.waiting.extend(reversed(tokens))

    def pop(self) -> Token | None:
        while self.waiting:
            top = self.waiting[-1]
            if isinstance(top, Token):
                self.waiting.pop()
                return top
            token = top.next()
            if token is not None:
                self.pushed = 0
                return token
            if self.contained:
                return None
            self.waiting.pop()
            self.close(top)
        return None

    def close(self, lexer: Lexer) -> None:
        """Called at the end of a file."""

    def peek(self) -> Token | None:
        token = self.pop()
        if token is not None:
            self.waiting.append(token)
        return token

    def lexer(self) -> Lexer | None:
        """Returns the file being read, if no tokens are pending before it."""
        top = self.waiting[-1] if self.waiting else None
        return top if isinstance(top, Lexer) else None

    def skip_spaces(self) -> None:
        while (token := self.peek()) is not None and token.text == " ":
            self.pop()

    def take(self, text: str) -> bool:
        """Consumes `text` if it comes next; True if it did."""
        token = self.peek()
        if token is None or token.text != text:
            return False
        self.pop()
        return True

    def star(self) -> bool:
        self.skip_spaces()
        return self.take("*")

    def argument(self) -> list[Token]:
        """Returns the next token, or the contents of the next braces."""
        self.skip_spaces()
        token = self.pop()
        if token is None or token.text == "}":
            return []
        return self.rest_of_group() if token.text == "{" else [token]

    def rest_of_group(self) -> list[Token]:
        """Returns the tokens before the brace that closes the group just opened."""
        taken: list[Token] = []
        depth = 1
        while (token := self.pop_within()) is not None:
            depth += nesting(token.text)
            if depth == 0:
                break
            taken.append(token)
        return taken

    def pop_within(self) -> Token | None:
        """Returns the next token of the same file; None at its end."""
        self.contained += 1
        try:
            return self.pop()
        finally:
            self.contained -= 1

    def optional(self, opening: str = "[", closing: str = "]") -> list[Token] | None:
        self.skip_spaces()
        if not self.take(opening):
            return None
        taken: list[Token] = []
        depth = brackets = 0
        while (token := self.pop_within()) is not None:
            if token.text == closing and depth == 0 and brackets == 0:
                break
            depth += nesting(token.text)
            brackets += nesting(token.text, (opening,), (closing,))
            taken.append(token)
        return taken

    def word(self) -> str:
        """Returns an argument that is a name."""
        return joined(self.argument()).strip()

    def until(self, stop: Sequence[str]) -> list[Token]:
        """Returns the tokens before the tokens `stop`, and moves past these; braces are respected."""
        taken: list[Token] = []
        depth = 0
        while (token := self.pop_within()) is not None:
            taken.append(token)
            depth += nesting(token.text)
            if depth <= 0 and [_mark(each) for each in taken[-len(stop) :]] == list(stop):
                return taken[: -len(stop)]
        return taken


def _mark(token: Token) -> str:
    """Returns the text of a token for comparison with a mark; a blank line counts as a space."""
    return " " if token.text == PARAGRAPH else token.text
