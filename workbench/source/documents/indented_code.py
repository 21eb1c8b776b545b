"""Markdown code blocks indented by four columns, by the rules of CommonMark."""

from __future__ import annotations

import re

_QUOTES = re.compile(r"(?: {0,3}> ?)*")
_MARKER = re.compile(r" *(?:[-+*:]|\d{1,9}[.)])(?: +|$)")
#: A footnote, an admonition or a tab of MkDocs, whose contents are indented by four columns.
_BOX = re.compile(r" *(?:\[\^[^\]]+\]:|(?:!!!|\?\?\?\+?|===) )")
_RULE = re.compile(r" *(?:(?:\* *){3,}|(?:- *){3,}|(?:_ *){3,}|=+) *$")
_HEADING = re.compile(r" *#{1,6}(?: |$)")
_SPAN = re.compile(r"`[^`]*`")
_WIDTH = 4


class IndentedCode:
    """Decides line by line whether a line is indented code.

    A line is code if it is indented by four columns more than the list item around it and does not continue a
    paragraph. A formula that contains a blank line is not code.
    """

    def __init__(self) -> None:
        self._columns: list[int] = []  # columns at which the contents of the open list items begin
        self._quotes = 0
        self._is_after_blank = True
        self._in_paragraph = False
        self._dollars_open = False
        self._environments = 0

    def holds(self, line: str) -> bool:
        """True if the line is code; it must not be called for lines within fences."""
        written = line.rstrip("\n").expandtabs(_WIDTH)
        quoted = _QUOTES.match(written)
        assert quoted is not None, "the pattern takes the empty text, too"
        self._in_quotes(quoted[0].count(">"))
        rest = written[quoted.end() :]
        if not rest.strip():
            self._is_after_blank, self._in_paragraph = True, False
            return False
        indent = len(rest) - len(rest.lstrip())
        is_item = _MARKER.match(rest) is not None and not _RULE.match(rest)
        if self._is_after_blank or is_item or not self._in_paragraph:
            while self._columns and indent < self._columns[-1]:
                self._columns.pop()
        column = self._columns[-1] if self._columns else 0
        is_indented = indent - column >= _WIDTH and not self._in_paragraph
        self._is_after_blank = False
        if is_indented and not self._dollars_open and self._environments == 0:
            return True
        self._text(rest, indent, is_item)
        return False

    def end_block(self) -> None:
        """Ends the paragraph after a fence."""
        self._in_paragraph = False

    def _in_quotes(self, quotes: int) -> None:
        if quotes != self._quotes:
            self._columns.clear()
            self._in_paragraph = self._in_paragraph and quotes < self._quotes
        self._quotes = quotes

    def _text(self, rest: str, indent: int, is_item: bool) -> None:
        is_heading = _HEADING.match(rest) is not None
        self._in_paragraph = not (is_heading or _RULE.match(rest))
        if is_heading:
            self._dollars_open, self._environments = False, 0
        text = _SPAN.sub("", rest)
        self._dollars_open ^= text.count("$$") % 2 == 1
        self._environments = max(0, self._environments + text.count("\\begin{") - text.count("\\end{"))
        if _BOX.match(rest):
            self._columns.append(indent + _WIDTH)
        at = 0
        while is_item and (marker := _MARKER.match(rest, at)) is not None:
            at = marker.end()
            self._columns.append(at)
