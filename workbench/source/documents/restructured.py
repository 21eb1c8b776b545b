"""reStructuredText: the math directive and role, by the rules of docutils and Sphinx."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from workbench.source.documents.delimiters import Found
from workbench.source.documents.source_view import View
from workbench.source.documents.surrounding_words import plain

_DIRECTIVE = re.compile(r"(\s*)\.\. math::[ \t]*(.*)")
_OPTION = re.compile(r"\s*:(label|name|nowrap|class|no-wrap|width):\s*(.*)")
#: The label of a formula; Sphinx also accepts it below the formula.
_LABEL = re.compile(r":label:\s*(.*)")
_CODE = re.compile(
    r"\s*\.\. (code|code-block|sourcecode|raw|literalinclude|comment|jupyter-\w+|parsed-literal)\b"
)
_UNDERLINE = re.compile(r"([=\-~^\"'`#*+.:_])\1{2,}\s*")
#: The beginning of a comment: two dots without a directive, target, footnote or substitution.
_COMMENT = re.compile(r"\s*\.\.(?:[ \t]+(?![\[_|]|[\w:+.-]+::)\S.*|[ \t]*)")
_ROLE = re.compile(r":math:`([^`]+)`")


@dataclass(frozen=True)
class _Line:
    start: int
    text: str

    @property
    def indent(self) -> int:
        return len(self.text) - len(self.text.lstrip())

    @property
    def end(self) -> int:
        return self.start + len(self.text)


def restructured(view: View) -> Iterator[Found]:
    lines = _lines(view.text)
    place, literal, section = 0, None, ""
    while place < len(lines):
        line = lines[place]
        if literal is not None and line.text.strip() and line.indent <= literal:
            literal = None
        if literal is None:
            if match := _DIRECTIVE.fullmatch(line.text):
                place, found = _directive(view, lines, place, match, section)
                yield from found
                continue
            if place and _UNDERLINE.fullmatch(line.text) and lines[place - 1].text.strip():
                section = plain(lines[place - 1].text)
            yield from _roles(view, line, section)
            is_note = line.text.lstrip().startswith(".. ")
            if (
                _CODE.match(line.text)
                or (line.text.rstrip().endswith("::") and not is_note)
                or _is_comment(line, lines[place + 1 : place + 2])
            ):
                literal = line.indent
        place += 1


def _is_comment(line: _Line, following: list[_Line]) -> bool:
    """True if the line begins a comment with contents; two dots alone before an empty line have none."""
    is_alone = line.text.strip() == ".."
    return _COMMENT.fullmatch(line.text) is not None and not (
        is_alone and (not following or not following[0].text.strip())
    )


def _directive(
    view: View, lines: list[_Line], place: int, match: re.Match[str], section: str
) -> tuple[int, Iterator[Found]]:
    """Returns the index of the line after the directive, and its formula if it has one."""
    opening = lines[place]
    label = None
    spans: list[tuple[int, int]] = []
    parted: set[int] = set()  # the lines with an empty line after them
    if match[2].strip():
        spans.append((opening.start + match.start(2), opening.end))
    is_head = True
    place += 1
    while place < len(lines) and (not lines[place].text.strip() or lines[place].indent > len(match[1])):
        line = lines[place]
        if _ROLE.search(line.text):  # a sentence, which is indented
            break
        if is_head and (option := _OPTION.fullmatch(line.text)):
            label = option[2].strip() if option[1] in ("label", "name") else label
        elif line.text.strip():
            spans.append((line.start + line.indent, line.end))
            is_head = False
            if not lines[place - 1].text.strip() and len(spans) > 1:
                parted.add(len(spans) - 2)
        else:
            is_head = False
        place += 1
    if len(spans) > 1 and (option := _LABEL.fullmatch(view.text[slice(*spans[-1])])):
        label, _ = option[1].strip(), spans.pop()
    if not spans:
        return place, iter(())
    start, end = view.at[opening.start + len(match[1])], view.at[spans[-1][1]]
    return place, iter([Found(_body(view, spans, parted), start, end, "\\[", label or None, section)])


def _body(view: View, spans: list[tuple[int, int]], parted: set[int]) -> View:
    """Returns the lines without their indentation, joined by line feeds; an empty line separates rows, as in
    Sphinx."""
    text = ""
    at: list[int] = []
    for place, (start, end) in enumerate(spans):
        text += view.text[start:end]
        at += view.at[start:end]
        is_open = text.count("\\begin{") > text.count("\\end{") or text.rstrip().endswith("\\\\")
        between = "\\\\\n" if place in parted and not is_open else "\n"
        text += between
        at += [view.at[end]] * len(between)
    return View(text[:-1], view.source, at[:-1])


def _roles(view: View, line: _Line, section: str) -> Iterator[Found]:
    for match in _ROLE.finditer(line.text):
        inner, inner_end = line.start + match.start(1), line.start + match.end(1)
        start, end = line.start + match.start(), line.start + match.end()
        yield Found(view.cut(inner, inner_end), view.at[start], view.at[end - 1] + 1, "$", None, section)


def _lines(text: str) -> list[_Line]:
    made, start = [], 0
    for line in text.split("\n"):
        made.append(_Line(start, line))
        start += len(line) + 1
    return made
