"""Markdown: kramdown, MyST, GitHub and mdBook. Code, comments and front matter contain no formulas."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import replace

from workbench.source.documents.delimiters import Found, formulas
from workbench.source.documents.indented_code import IndentedCode
from workbench.source.documents.source_view import View
from workbench.source.documents.surrounding_words import plain
from workbench.source.documents.tex.displays import INLINE

_FENCE = re.compile(r"([ >\t]*)(`{3,}|~{3,}|:{3,})(.*)")
_FRONT_MATTER = re.compile(r"\A---[ \t]*\n(?:(?!---).*\n)*---[ \t]*\n")
_MATH_FENCE = re.compile(r"\s*(?:\{math\}|math)\s*(.*)")
#: Directives of MyST, such as ```{dropdown}, that contain Markdown and not code.
_DIRECTIVE = re.compile(
    r"\s*\{(?!code|raw|eval-rst|literal|mermaid|parsed|source|table|csv|list|math)[\w:+-]+\}.*"
)
_OPTION = re.compile(r"(?m)^[ \t]*:(\w+):[ \t]*(.*)\n?")
_LABEL = re.compile(r"[ \t]*\(([\w:.-]+)\)[ \t]*(?=\n|\Z)")
_HEADING = re.compile(r" {0,3}#{1,6}[ \t]+(\S.*)")
_UNDERLINE = re.compile(r"(?:={3,}|-{3,})[ \t]*")
#: A key in the options of a directive, between --- and ---.
_KEY = re.compile(r"[\w-]+:(?:\s|$)")
_QUOTE = re.compile(r"(?m)^[ \t]*>[ ]?")
_TICKS = re.compile(r"`+")
#: The beginning of a comment, of HTML that is code, or of code.
_UNREAD = re.compile(r"<!--|<(?P<name>pre|code|script|style|textarea)\b[^<>\n]*>|`+", re.IGNORECASE)
_SINGLE = re.compile(r"(?<![\\$])\$(?!\$)[^$\n]+\$(?!\$)")
_DOLLARS = re.compile(rf"\$\$.*?\$\$|{_SINGLE.pattern}", re.DOTALL)
#: The \\[4pt] after a row.
_ROW_GAP = re.compile(r"\\\\\[\s*-?[\d.]+\s*[a-z]{2}\s*\]")
_NEAR = 200
_ESCAPED = re.compile(r"\\([!-/:-@\[-`{-~])")

#: Characters that GitHub treats as a subscript, where \\ and _ are not in a word.
_UNDERSCORE = re.compile(
    r"(?P<kept>\\(?:text\w*|math(?:rm|it|sf|tt)|operatorname\*?|mbox|label|tag|ref)\s*\{[^{}]*\})|\\{1,2}_"
)
_BRACE = re.compile(r"\\(?:left|right|[bB]igg?[lrm]?)\s*\\[{}]|\\\\|\\?[{}]")


def markdown(view: View) -> Iterator[Found]:
    """Yields the formulas in reading order."""
    headings, position = _headings(view.text), 0
    for found, start in sorted(_all(view), key=lambda pair: pair[1]):
        yield replace(found, section=headings.at(start), passed=headings.between(position, start))
        position = start


def _all(view: View) -> Iterator[tuple[Found, int]]:
    searched, fenced, ticked = _without_code(view.text)
    for inner, inner_end, start, label in fenced:
        yield _fenced(view, inner, inner_end, start, label), start
    for start, inner, inner_end, end in ticked:
        environment = "\\[" if _is_a_paragraph(view.text, start, end) else "$"
        yield Found(view.cut(inner, inner_end), view.at[start], view.at[end - 1] + 1, environment), start
    escaped = _has_escaped_brackets(searched)
    in_paragraph = _is_kramdown(view.text, searched)
    for found, start, end in formulas(view, searched, escaped):
        environment = found.environment
        if environment in INLINE and _is_a_paragraph(searched, start, end):
            environment = "\\["
        if in_paragraph and searched.startswith("$$", start) and _stands_in_a_line(searched, start, end):
            environment = "$"
        match = _LABEL.match(searched, end)
        labelled = _unmarked(found, escaped).named(match[1] if match else None)
        yield replace(labelled, environment=environment), start


def _has_escaped_brackets(text: str) -> bool:
    """True if formulas are written \\\\[ … \\\\], and not only rows of a matrix begin with a bracket."""
    outside = _ROW_GAP.sub("", _DOLLARS.sub("", text))
    pairs = (("\\\\[", "\\\\]"), ("\\\\(", "\\\\)"))
    return any(opening in outside and closing in outside for opening, closing in pairs)


def _unmarked(found: Found, escaped: bool) -> Found:
    """Returns the formula without quotation marks, and without backslashes that Markdown removes before
    MathJax."""
    view = found.view
    line = view.source.text.rfind("\n", 0, found.start) + 1
    if ">" in view.source.text[line : found.start] and _QUOTE.match(view.source.text, line):
        view = view.replace(_QUOTE, lambda match: "")
    if escaped:
        view = view.replace(_ESCAPED, lambda match: match[1])
    else:
        view = view.replace(_UNDERSCORE, lambda match: match["kept"] or "_")
        braces = _escaped_braces(view.text)
        view = view.replace(_BRACE, lambda match: match[0][match.start() in braces :])
    return replace(found, view=view)


def _escaped_braces(formula: str) -> set[int]:
    """Returns the offsets where \\{ is the { that Markdown produces: before a }, if the other braces then
    balance."""
    opened: list[re.Match[str]] = []
    said: set[int] = set()
    for brace in _BRACE.finditer(formula):
        if brace[0] in ("{", "\\{"):
            opened.append(brace)
        elif brace[0] in ("}", "\\}"):
            if not opened or (brace[0], opened[-1][0]) == ("\\}", "{"):
                return set()
            opening = opened.pop()
            if opening[0][:-1] != brace[0][:-1]:
                said.add(opening.start())
    return set() if opened else said


def _fenced(view: View, inner: int, inner_end: int, start: int, label: str) -> Found:
    body = view.cut(inner, inner_end)
    options = {match[1]: match[2].strip() for match in _OPTION.finditer(body.text)}
    body = body.replace(_OPTION, lambda match: "")
    name = options.get("label") or options.get("name") or label
    return Found(body, view.at[start], view.at[inner_end], label=name or None)


def _is_kramdown(text: str, searched: str) -> bool:
    """True if $$ inside a sentence is an inline formula: kramdown has no single $."""
    return text.startswith("---") and "$$" in searched and not _SINGLE.search(searched)


def _stands_in_a_line(text: str, start: int, end: int) -> bool:
    line = text.rfind("\n", 0, start) + 1
    previous = text[:line].rstrip("\n").rpartition("\n")[2] if text[max(0, line - 2) : line] != "\n\n" else ""
    following = text[end : (text.find("\n", end) + 1 or len(text) + 1) - 1]
    before = text[line:start].strip(" \t>")
    return bool(before or previous.strip(" \t>") or following.strip(" \t.,;"))


def _is_a_paragraph(text: str, start: int, end: int) -> bool:
    """True if an equation is a separate paragraph, as GitHub's authors write displays."""
    before = text[max(0, start - _NEAR) : start].rpartition("\n\n")[2]
    after = text[end : end + _NEAR].partition("\n\n")[0]
    return "=" in text[start:end] and not (before.strip(" \t\n>") or after.strip(" \t\n>.,;"))


def _without_code(text: str) -> tuple[str, list[tuple[int, int, int, str]], list[tuple[int, int, int, int]]]:
    """Returns the text with code, comments and front matter blanked, math fences as (inner, end, start,
    label), and GitHub's $`…`$ as (start, inner, inner end, end)."""
    pieces: list[str] = []
    fenced: list[tuple[int, int, int, str]] = []
    front = _FRONT_MATTER.match(text)
    position = front.end() if front else 0
    if front:
        pieces.append(_blank(text[:position]))
    fence: tuple[str, int, int, str | None] | None = None
    directives: list[str] = []
    indented = IndentedCode()
    for line in text[position:].splitlines(keepends=True):
        match = _FENCE.match(line)
        after = position + len(line)
        if fence is not None:
            mark, start, inner, label = fence
            closes = match is not None and match[2].startswith(mark) and not match[3].strip("`~: \n\t")
            if closes:
                if label is not None:
                    fenced.append((inner, position, start, label))
                fence = None
                indented.end_block()
            pieces.append(_blank(line))
        elif indented.holds(line):
            pieces.append(_blank(line))
        elif match and directives and match[2].startswith(directives[-1]) and not match[3].strip():
            directives.pop()
            pieces.append(_blank(line))
        elif match and match[2][0] != ":" and _DIRECTIVE.fullmatch(match[3].rstrip("\n")):
            directives.append(match[2])
            indented.end_block()
            pieces.append(_blank(line))
        elif match and not (match[2][0] == "`" and "`" in match[3]):
            is_math = _MATH_FENCE.fullmatch(match[3].rstrip("\n"))
            if match[2][0] != ":" or is_math:
                fence = (match[2], position, after, is_math[1] if is_math else None)
                pieces.append(_blank(line))
            else:
                pieces.append(line)
        else:
            pieces.append(line)
        position = after
    if fence is not None and fence[3] is not None:
        fenced.append((fence[2], len(text), fence[1], fence[3]))
    searched, ticked = _without_spans("".join(pieces))
    return searched, fenced, ticked


def _without_spans(text: str) -> tuple[str, list[tuple[int, int, int, int]]]:
    """Returns the text without comments, HTML code and code spans, and the formulas of GitHub's $`…`$."""
    ticked: list[tuple[int, int, int, int]] = []
    by_length: dict[int, list[int]] = defaultdict(list)
    for run in _TICKS.finditer(text):
        by_length[len(run[0])].append(run.start())
    pieces, position = [], 0
    absent: set[str] = set()
    for match in _UNREAD.finditer(text):
        start = match.start()
        if start < position:
            continue
        if match[0][0] == "`":
            end = _end_of_ticks(text, match, by_length[len(match[0])])
            if end and text[start - 1 : start] == "$" and text[end : end + 1] == "$":
                ticked.append((start - 1, match.end(), end - len(match[0]), end + 1))
                start, end = start - 1, end + 1
        else:
            end = _end_of_markup(text, match, absent)
        if end:
            pieces += [text[position:start], _blank(text[start:end])]
            position = end
    return "".join([*pieces, text[position:]]), ticked


def _end_of_ticks(text: str, run: re.Match[str], same: list[int]) -> int | None:
    """Returns the end of the code span that begins with these backticks; None if they begin none.

    same: the offsets of backtick runs of the same length.
    """
    place = bisect_right(same, run.start())
    if place == len(same):
        return None
    end = same[place] + len(run[0])
    is_far = end - run.start() > 5000
    return None if is_far or "\n\n" in text[run.start() : end] else end


def _end_of_markup(text: str, match: re.Match[str], absent: set[str]) -> int | None:
    """Returns the end of the comment or element. A comment that begins a line and never ends extends to the
    end."""
    closing = f"</{match['name'].lower()}" if match["name"] else "-->"
    found = None if closing in absent else re.compile(closing, re.IGNORECASE).search(text, match.end())
    if found is not None:
        return found.end()
    absent.add(closing)
    begins_line = not text[text.rfind("\n", 0, match.start()) + 1 : match.start()].strip()
    return len(text) if begins_line and not match["name"] else None


def _blank(text: str) -> str:
    return re.sub(r"[^\n]", " ", text)


class _Headings:
    def __init__(self, entries: list[tuple[int, str]]) -> None:
        self.starts = [start for start, _ in entries]
        self.names = [name for _, name in entries]

    def at(self, position: int) -> str:
        place = bisect_right(self.starts, position)
        return self.names[place - 1] if place else ""

    def between(self, start: int, end: int) -> tuple[str, ...]:
        return tuple(
            self.names[bisect_right(self.starts, start) if start else 0 : bisect_right(self.starts, end)]
        )


def _headings(text: str) -> _Headings:
    searched, _, _ = _without_code(text)
    entries: list[tuple[int, str]] = []
    start, before = 0, ""
    for line in searched.split("\n"):
        if match := _HEADING.match(line):
            entries.append((start, plain(match[1].rstrip("# \t"))))
        elif _UNDERLINE.fullmatch(line) and before.strip() and not _KEY.match(before):
            entries.append((start - len(before) - 1, plain(before)))
        start, before = start + len(line) + 1, line
    return _Headings(entries)
