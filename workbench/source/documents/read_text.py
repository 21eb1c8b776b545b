"""Reads a text by the suffix of its file: .tex, .md, .rst, .html, .ipynb."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from workbench.core.paper_errors import PaperError
from workbench.source.documents.delimiters import Found, within
from workbench.source.documents.includes import includes, unread
from workbench.source.documents.markdown import markdown
from workbench.source.documents.restructured import restructured
from workbench.source.documents.source_view import Source, View
from workbench.source.documents.tex.display_list import add
from workbench.source.documents.tex.displays import CLOSING, INLINE, read_display
from workbench.source.documents.tex.expander_state import Names
from workbench.source.documents.tex.macros import named
from workbench.source.documents.tex.tex_document import TexReader, Text
from workbench.source.documents.tex.tex_tokens import Lexer, Token
from workbench.source.documents.web import notebook, web

Find = Callable[[View], Iterator[Found]]

TEX_SUFFIXES = frozenset({".tex", ".latex", ".ltx"})
_MARKUP: dict[str, Find] = {
    **dict.fromkeys((".md", ".markdown", ".mdx", ".qmd", ".rmd"), markdown),
    ".rst": restructured,
    **dict.fromkeys((".html", ".htm", ".xhtml"), web),
    ".ipynb": notebook,
}
SUFFIXES = TEX_SUFFIXES | set(_MARKUP)

_DECLARATION = re.compile(r"\s*\\(?:re)?newcommand|\s*\\g?def\b|\s*\\DeclareMathOperator|\s*\\let\b")


def is_text(path: Path) -> bool:
    return path.suffix.lower() in SUFFIXES


def read_text(
    path: Path | str,
    macros: Path | str | None = None,
    bodies: Mapping[str, str] | None = None,
) -> Text:
    """Returns the displays of a text, macros expanded, each token with its position in the author's file.

    macros: a TeX file of macros that a site or a class stores elsewhere; they override those of the text.
    bodies: more such macros, each by its body.

    Raises PaperError for an unusable file.
    """
    path = Path(path)
    if not is_text(path):
        raise PaperError(path, None, None, f"expected one of {', '.join(sorted(SUFFIXES))}")
    overrides = Names() if macros is None else _macros(Path(macros))
    overrides.macros |= named(bodies or {}, path)
    reader = TexReader(path.parent, overrides)
    find = _MARKUP.get(path.suffix.lower())
    if find is None:
        reader.read_file(path)
    else:
        source = Source.open(path)
        reader.formulas_are_groups = False  # MathJax keeps the declarations of a formula
        reader.sources.append(source)
        for start, name in includes(source.text, path.suffix.lower()):
            reader.warn(Token("", source, start, start), unread(path, name))
        for found in find(source.view()):
            _read_found(reader, found)
    return _text(path, reader)


def _macros(path: Path) -> Names:
    reader = TexReader(path.parent)
    reader.read_file(path)
    return reader.names


def _read_found(reader: TexReader, found: Found) -> None:
    found = within(found)
    for heading in found.passed:
        reader.starts.setdefault(heading, len(reader.displays))
    reader.heading = found.section
    opening = Token("\\[", found.view.source, found.start, found.start + 1)
    if (closing := CLOSING.get(found.environment)) is not None:
        reader.push([Token(closing, found.view.source, found.end, found.end)])
    reader.open(Lexer(found.view))
    told = len(reader.warnings)
    if _DECLARATION.match(found.view.text) and not reader.has_more_than_declarations(closing):
        reader.waiting.clear()
        return
    display = read_display(reader, opening, found.environment)
    reader.waiting.clear()
    if found.environment in INLINE:
        del reader.warnings[told:]
        reader.inline.append(replace(display, start=found.start, end=found.end))
        return
    rows = display.rows
    if found.label is not None and rows:
        first = rows[0]
        number = first.number
        if number is None and not display.numbers:
            reader.counters.step("equation")
            number = reader.counters.number("equation")
        rows = (replace(first, labels=(*first.labels, found.label), number=number), *rows[1:])
        reader.labels.setdefault(found.label, number)
    add(reader.displays, replace(display, start=found.start, end=found.end, rows=rows))


def _text(path: Path, reader: TexReader) -> Text:
    warnings = [
        PaperError(source.path, None, None, message)
        for source in reader.sources
        for message in source.warnings
    ]
    warnings += [
        PaperError(token.source.path, *token.source.place(token.start), message)
        for token, message in reader.warnings
    ]
    return Text(
        path,
        reader.sources,
        reader.displays,
        reader.labels,
        reader.directives,
        warnings,
        reader.names,
        reader.fences,
        reader.inline,
        reader.starts,
    )
