"""HTML with MathJax delimiters, and notebooks: unescaped characters with their offsets."""

from __future__ import annotations

import html
import json
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from workbench.source.documents.delimiters import Found, formulas
from workbench.source.documents.markdown import markdown
from workbench.source.documents.source_view import View

_PIECE = re.compile(
    r"<!--|<(/?)([A-Za-z][A-Za-z0-9]*)\b([^<>]*)>|&(?:#\d{1,7}|#[xX][0-9a-fA-F]{1,6}|\w{1,32});"
)
_NO_TEXT = frozenset({"script", "style", "pre", "code", "textarea", "noscript"})
_HEADING = re.compile(r"h[1-6]")
_CELL = re.compile(r'"cell_type"\s*:\s*"(\w+)"')
_STRING = re.compile(r'"(?:[^"\\]|\\.)*"')
_SOURCE = re.compile(r'"source"\s*:\s*')
_ESCAPE = re.compile(r"\\u[0-9a-fA-F]{4}|\\.|[^\\]+", re.DOTALL)


class _Text:
    """A text under construction, with the offsets of its characters."""

    def __init__(self, view: View) -> None:
        self.view = view
        self.pieces: list[str] = []
        self.at: list[int] = []
        self.length = 0

    def copy(self, start: int, end: int) -> None:
        self._put(self.view.text[start:end], self.view.at[start:end])

    def put(self, text: str, offset: int) -> None:
        self._put(text, [self.view.at[offset]] * len(text))

    def _put(self, text: str, at: Sequence[int]) -> None:
        self.pieces.append(text)
        self.at.extend(at)
        self.length += len(text)

    def made(self) -> View:
        end = self.at[-1] + 1 if self.at else self.view.at[0]
        return View("".join(self.pieces), self.view.source, [*self.at, end])


def web(view: View) -> Iterator[Found]:
    text, headings, scripts = _page(view)
    page = text.made()
    found = [
        (replace(each, section=_last(headings, start)), each.start)
        for each, start, _ in formulas(page, page.text, escaped=False)
    ]
    found += [(each, each.start) for each in scripts]
    for each, _ in sorted(found, key=lambda pair: pair[1]):
        yield each


def _page(view: View) -> tuple[_Text, list[tuple[int, str]], list[Found]]:
    """Returns the page's text, the offsets of its headings, and MathJax 2's <script type="math/tex">."""
    text, source = _Text(view), view.text
    headings: list[tuple[int, str]] = []
    scripts: list[Found] = []
    position, heading = 0, None
    while match := _PIECE.search(source, position):
        text.copy(position, match.start())
        position = match.end()
        name = (match[2] or "").lower()
        if match[0] == "<!--":
            end = source.find("-->", position)
            position = len(source) if end < 0 else end + 3
        elif match[0][0] == "&":
            text.put(html.unescape(match[0]), match.start())
        elif name in _NO_TEXT and not match[1]:
            end = _end_of(source, name, position)
            if "math/tex" in match[3] and "mode=display" in match[3]:
                scripts.append(Found(view.cut(position, end), view.at[match.start()], view.at[end]))
            position = end
        else:
            if _HEADING.fullmatch(name):
                if match[1] and heading is not None:
                    headings.append((text.length, " ".join("".join(text.pieces[heading:]).split())))
                heading = None if match[1] else len(text.pieces)
            text.put("\n" if name in ("br", "p", "div", "li", "tr") else " ", match.start())
    text.copy(position, len(source))
    return text, headings, scripts


def _end_of(source: str, name: str, position: int) -> int:
    match = re.compile(rf"</{name}\s*>", re.IGNORECASE).search(source, position)
    return len(source) if match is None else match.start()


def _last(headings: list[tuple[int, str]], position: int) -> str:
    return next((name for start, name in reversed(headings) if start <= position), "")


def notebook(view: View) -> Iterator[Found]:
    """Yields the formulas in the Markdown cells of an .ipynb, whose lines are JSON strings."""
    for cell in _CELL.finditer(view.text):
        if cell[1] == "markdown" and (source := _SOURCE.search(view.text, cell.end())):
            yield from markdown(_unescaped(view, source.end()))


def _unescaped(view: View, position: int) -> View:
    """Returns the JSON string, or list of strings, that begins at `position`."""
    text = _Text(view)
    is_list = view.text.startswith("[", position)
    position += is_list
    while True:
        while position < len(view.text) and view.text[position] in " \t\r\n,":
            position += 1
        string = _STRING.match(view.text, position)
        if string is None:
            break
        for piece in _ESCAPE.finditer(view.text, string.start() + 1, string.end() - 1):
            if piece[0][0] == "\\":
                text.put(_character(piece[0]), piece.start())
            else:
                text.copy(piece.start(), piece.end())
        position = string.end()
        if not is_list:
            break
    return text.made()


def _character(escape: str) -> str:
    try:
        return json.loads(f'"{escape}"')
    except ValueError:
        return escape
