"""The file formats of the campaign's documents: how words, displays and what is not printed are written."""

from __future__ import annotations

import html
import json
import re
from random import Random

_EQUATION = re.compile(r"\\begin\{equation\}(.*)\\end\{equation\}", re.DOTALL)
_LABEL = re.compile(r" *\\label\{(\w+)\}")


class Format:
    """Lines of a file, written from top to bottom."""

    suffix = "tex"

    def __init__(self, random: Random) -> None:
        self.random = random
        self.lines: list[str] = []

    @property
    def file(self) -> str:
        return f"text.{self.suffix}"

    def begin(self, macros: list[str]) -> None:
        """What stands before the text."""

    def section(self, title: str) -> None:
        """A heading."""
        self._put(f"# {title}", "")

    def words(self, words: str) -> None:
        """A line of prose, or of declarations."""
        self._put(words, "")

    def display(self, source: str) -> tuple[int, int]:
        """A display; its first and last line in the file."""
        return self._put(*self.shown(source).split("\n"), "")

    def hidden(self, source: str) -> tuple[int, int]:
        """A display that is not printed."""
        return self._put(*self.unseen(source).split("\n"), "")

    def shown(self, source: str) -> str:
        return source

    def unseen(self, source: str) -> str:
        raise NotImplementedError

    def end(self) -> str:
        """The whole file."""
        return "\n".join(self.lines) + "\n"

    def _put(self, *lines: str) -> tuple[int, int]:
        first = len(self.lines) + 1
        self.lines += lines
        return first, len(self.lines)


class Tex(Format):
    def begin(self, macros: list[str]) -> None:
        self._put(
            r"\documentclass{article}",
            r"\usepackage{amsmath,comment}",
            r"\newif\ifdraft",
            *macros,
            r"\begin{document}",
        )

    def section(self, title: str) -> None:
        self._put(rf"\section{{{title}}}")

    def words(self, words: str) -> None:
        self._put(words)

    def display(self, source: str) -> tuple[int, int]:
        return self._put(*self.shown(source).split("\n"))

    def unseen(self, source: str) -> str:
        return self.random.choice((
            "\\begin{comment}\n" + source + "\n\\end{comment}",
            "\\iffalse\n" + source + "\n\\fi",
            "% " + source.replace("\n", "\n% "),
            "\\begin{verbatim}\n" + source + "\n\\end{verbatim}",
        ))  # fmt: skip

    def end(self) -> str:
        self._put(r"\end{document}")
        return super().end()


class Markdown(Format):
    suffix = "md"

    def begin(self, macros: list[str]) -> None:
        self._put("# Text", "")
        for each in macros:
            self._put(f"$${each}$$", "")

    def shown(self, source: str) -> str:
        alone = _EQUATION.fullmatch(source)
        if alone is not None and "\\begin" not in alone[1]:
            return f"$$\n{alone[1].strip()}\n$$"
        return source if self.random.random() < 0.5 else f"$$\n{source}\n$$"

    def unseen(self, source: str) -> str:
        return self.random.choice((f"```tex\n{source}\n```", f"<!--\n{self.shown(source)}\n-->"))


class Restructured(Format):
    suffix = "rst"

    def section(self, title: str) -> None:
        self._put(title, "=" * len(title), "")

    def begin(self, macros: list[str]) -> None:
        self.section("Text")

    def shown(self, source: str) -> str:
        alone, label = _EQUATION.fullmatch(source), _LABEL.search(source)
        if alone is not None and label is not None:
            return f".. math::\n   :label: {label[1]}\n\n" + _indented(_LABEL.sub("", alone[1]).strip())
        return ".. math::\n   :nowrap:\n\n" + _indented(source)

    def unseen(self, source: str) -> str:
        return self.random.choice(("..\n" + _indented(source), "::\n\n" + _indented(source)))


class Html(Format):
    suffix = "html"

    def begin(self, macros: list[str]) -> None:
        self._put("<html><body><h1>Text</h1>")
        for each in macros:
            self._put(rf"<p>\[{html.escape(each)}\]</p>")

    def section(self, title: str) -> None:
        self._put(f"<h2>{title}</h2>")

    def words(self, words: str) -> None:
        self._put(f"<p>{words}</p>")

    def shown(self, source: str) -> str:
        alone = _EQUATION.fullmatch(source)
        body = source
        if alone is not None and "\\begin" not in alone[1]:
            body = f"\\[\n{alone[1].strip()}\n\\]"
        return f"<p>\n{html.escape(body)}\n</p>"

    def unseen(self, source: str) -> str:
        if self.random.random() < 0.5:
            return f"<!-- {self.shown(source)} -->"
        return f"<pre>\n{html.escape(source)}\n</pre>"

    def end(self) -> str:
        self._put("</body></html>")
        return super().end()


class Notebook(Markdown):
    suffix = "ipynb"

    def __init__(self, random: Random) -> None:
        super().__init__(random)
        self.cells: list[dict] = []

    def hidden(self, source: str) -> tuple[int, int]:
        self._cut()
        kind = self.random.choice(("raw", "code"))
        text = source if kind == "raw" else f'r"""\n{source}\n"""'
        self._cell(kind, text.split("\n"))
        return 0, 0

    def display(self, source: str) -> tuple[int, int]:
        super().display(source)
        if self.random.random() < 0.3:
            self._cut()
        return 0, 0

    def _cut(self) -> None:
        if self.lines:
            self._cell("markdown", self.lines)
            self.lines = []

    def _cell(self, kind: str, lines: list[str]) -> None:
        cell = {"cell_type": kind, "metadata": {}, "source": [f"{each}\n" for each in lines]}
        if kind == "code":
            cell |= {"execution_count": None, "outputs": []}
        self.cells.append(cell)

    def end(self) -> str:
        self._cut()
        return json.dumps({"cells": self.cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 5}, indent=1)


def _indented(text: str) -> str:
    return "\n".join(f"   {each.strip()}" for each in text.split("\n"))


FORMATS = {"tex": Tex, "md": Markdown, "rst": Restructured, "html": Html, "ipynb": Notebook}
