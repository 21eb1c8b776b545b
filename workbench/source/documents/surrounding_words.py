"""Sentences and headings around a display."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import inf

from workbench.source.documents.list_items import ITEM, LIST_END, list_begin
from workbench.source.documents.tex.tex_tokens import COMMENT

_FAR = 800
#: White space but for the mark of an item.
_BLANKS = " \t\n"
_BLANK_LINES = re.compile(r"\n[ \t]*\n")
_DISPLAY_END = re.compile(
    r"\\end\s*\{[^}]*\}|\\\]|\$\$|\\(?:sub)*section\*?\s*\{[^}]*\}|^#+ .*$|^.*\n[=\-~^]{4,}$", re.MULTILINE
)
_LEVELS = ("part", "chapter", "section", "subsection", "subsubsection", "paragraph", "subparagraph")
_HEADING = re.compile(
    rf"\\(?P<tex>{'|'.join(_LEVELS)})\*?\s*(?:\[[^\]]*\]\s*)?\{{[^{{}}]*(?:\{{[^{{}}]*\}}[^{{}}]*)*\}}"
    r"|^(?P<marks>#{1,6}) [^\n]*$|<h(?P<html>[1-6])\b.*?</h[1-6]>"
    r"|^(?P<title>[^\s|][^\n]*)\n(?P<line>[=\-~^\"'+*#])(?P=line){2,}[ \t]*$",
    re.MULTILINE | re.DOTALL | re.IGNORECASE,
)
_CAPTION = re.compile(
    r"(?P<tex>\\(?:sub)?caption(?:of\s*\{[^}]*\})?\*?\s*(?:\[[^\]]*\]\s*)?\{)|!\[[^\]\n]*\]\([^)\n]*\)"
)
_SENTENCE = re.compile(r"(?<=[.!?])\s+(?=[A-Z$\\*`(])")
_ITEM = re.compile(f"{ITEM.pattern}|(?P<end>{LIST_END.pattern})")
_STOP = re.compile(r"[.!?]\s*(?:\\end\s*\{[^}]*\}|\\\]|\$\$)?$")
_THEN = re.compile(r"\s*(?:then|hence|thus|therefore|so|consequently|it follows)\b", re.IGNORECASE)
_SUPPOSES = re.compile(
    r"\s*(?:\\(?:begin|end|label|noindent|item)\b\s*(?:\{[^}]*\})?\s*)*"
    r"(?:(?:now|here|first|next|we|let us|also|further(?:more)?|moreover|again)\b,? ?){0,2}"
    r"(?:suppose|assume|let|set|put|take)\b",
    re.IGNORECASE,
)
_COMMAND = re.compile(r"\\[A-Za-z]+\*?\s*|[{}]")
_RELATION = re.compile(r"[=<>]|\\(?:neq?|[lg]eq?|[lg]t|perp|parallel|approx|equiv)(?![A-Za-z])")


def sentence_before(text: str, start: int) -> str:
    """Returns the last sentence of the paragraph before the display at `start`, even if it is incomplete."""
    chunk = COMMENT.sub("", text[max(0, start - _FAR) : start]).rstrip()
    chunk = _BLANK_LINES.split(chunk)[-1]
    for match in reversed(list(_DISPLAY_END.finditer(chunk))):
        chunk = chunk[match.end() :]
        break
    return _SENTENCE.split(" ".join(chunk.split()))[-1].strip()


#: What goes on with the display before it, though it has a capital: "Here, m is …", "If f = 0."
_GOES_ON = re.compile(r"(?:(?P<always>Here|Where|In which)|With|For|If|When|Since|Because|As)\b")
_FORMULA = re.compile(r":math:`[^`]*`|\$[^$]*\$|\\\([^)]*\\\)|`[^`]*`")
#: What another clause begins with, with # for a formula: "If f = 0, we have", "If f = 0 then".
_CLAUSE = re.compile(
    r",\s*(?!(?:and|or|where|with|in which|for|if|when|since|because|as|but|i\.e|that is)\b)[A-Za-z=]"
    r"|\bthen\b|\b(?:we|it) (?:have|get|find|obtain|see|follows)\b"
)


def _begins_sentence(after: str) -> bool:
    """True if another sentence begins behind a display without a full stop.

    A condition with a clause of its own is one: "If f = 0, g = 0." says nothing of the display before it."""
    if re.match(r"[A-Z][a-z]*\b", after) is None:
        return False
    if (goes_on := _GOES_ON.match(after)) is None:
        return True
    stops = [match.start() for sign in (_BLANK_LINES, _SENTENCE) if (match := sign.search(after))]
    own = after[: min(stops, default=len(after))]
    words = _FORMULA.sub(lambda match: "=" if _RELATION.search(match[0]) else "#", own)
    return goes_on["always"] is None and _CLAUSE.search(words) is not None


def is_of_next_sentence(text: str, start: int, said: int) -> bool:
    """True if the words at `said` belong to a sentence that begins behind the display at `start`."""
    ends = [m.end() for sign in (_DISPLAY_END, _BLANK_LINES) for m in sign.finditer(text, start, said)]
    return bool(ends) and _begins_sentence(text[max(ends) :].lstrip(_BLANKS))


def sentence_around(text: str, start: int, end: int) -> tuple[int, int]:
    """Returns the start and end of the sentence that contains the display from `start` to `end`. A heading or
    another item of a list ends it."""
    first = max(0, start - _FAR)
    before = text[first:start].rstrip(_BLANKS)
    ends = [m.end() for sign in (_BLANK_LINES, _SENTENCE, _HEADING) for m in sign.finditer(before)]
    end += len(text[end : end + _FAR]) - len(text[end : end + _FAR].lstrip(_BLANKS))
    after = text[end : end + _FAR]
    closed = _STOP.search(text[start:end].rstrip()[-40:]) or _begins_sentence(after)
    stops = [m.start() for sign in (_BLANK_LINES, _SENTENCE, _HEADING) if (m := sign.search(after))]
    items = [m for m in _ITEM.finditer(before) if m.end() > max(ends, default=0)]
    if items:
        ends.append(items[-1].end())
    if list_begin(text, start) is not None:  # the next item is another sentence
        stops += [m.start() for m in _ITEM.finditer(after)][:1]
    return first + max(ends, default=0), end if closed else end + min(stops, default=len(after))


def leads_of(text: str, start: int) -> Iterator[tuple[int, int]]:
    """Yields the start and end of the words that introduce the list around `start`: If f = 0, then: …

    The list around that list follows. Words that end with a full stop introduce nothing."""
    while (begin := list_begin(text, start)) is not None:
        start, _ = sentence_around(text, begin, begin)
        words = text[start:begin].rstrip()
        if not words or _STOP.search(words):
            return
        yield start, begin


def sentence_ends(text: str) -> list[int]:
    """Returns the ends of the sentences of a text: at a full stop, a blank line or a heading."""
    return sorted(
        {match.end() for sign in (_BLANK_LINES, _SENTENCE, _HEADING) for match in sign.finditer(text)}
    )


@lru_cache(maxsize=8)
def headings(text: str) -> tuple[tuple[int, int], ...]:
    """Returns the offset and level of each heading of the text, 1 for the highest."""
    found, lines = [], []
    for match in _HEADING.finditer(text):
        if match["tex"]:
            level = _LEVELS.index(match["tex"].lower()) + 1
        elif match["line"]:
            lines += [] if match["line"] in lines else [match["line"]]
            level = lines.index(match["line"]) + 1
        else:
            level = int(match["html"] or len(match["marks"]))
        found.append((match.start(), level))
    return tuple(found)


@dataclass(frozen=True)
class Sections:
    """The sections of a text. starts: the offsets of the headings.   ends: the ends of the sections.

    captions: the starts and ends of the captions, which speak of their pictures."""

    starts: tuple[int, ...]
    ends: tuple[float, ...]
    captions: tuple[tuple[int, int], ...] = ()

    @staticmethod
    def of(headings: Sequence[tuple[int, int]], captions: Sequence[tuple[int, int]] = ()) -> Sections:
        """Returns the sections for headings with their levels, in order."""
        ends: list[float] = [inf] * len(headings)
        opened: list[int] = []
        for at, (start, level) in enumerate(headings):
            while opened and headings[opened[-1]][1] >= level:
                ends[opened.pop()] = start
            opened.append(at)
        return Sections(tuple(start for start, _ in headings), tuple(ends), tuple(captions))

    def holds(self, said: int, place: int) -> bool:
        """True if the offset `place` is in the section of the offset `said`, or in one of its subsections.

        A statement before the first heading covers every offset; one in a caption covers the caption.
        """
        if any(start <= said < end and not start <= place < end for start, end in self.captions):
            return False
        at = bisect_right(self.starts, said) - 1
        return at < 0 or self.starts[at] <= place < self.ends[at]


@lru_cache(maxsize=8)
def sections_of(text: str) -> Sections:
    return Sections.of(headings(text), [*_captions(text)])


def _captions(text: str) -> Iterator[tuple[int, int]]:
    for caption in _CAPTION.finditer(text):
        yield caption.start(), group_end(text, caption.end()) if caption["tex"] else caption.end()


def group_end(text: str, start: int) -> int:
    """Returns the offset behind the brace that closes the group whose contents begin at `start`."""
    depth, at = 1, start
    while at < len(text) and depth:
        depth += (text[at] == "{") - (text[at] == "}")
        at += 1 + (text[at] == "\\")
    return at


def supposed_before(text: str, first: int) -> str:
    """Returns the sentence before the one at `first` in its paragraph if it supposes something, or if the one
    at `first` begins with "then": Suppose it is so. Then …"""
    before = text[:first].rstrip()
    if not before:
        return ""
    begins = sentence_around(text, len(before) - 1, len(before))[0]
    if _HEADING.search(text, begins, first):
        return ""
    supposes = _SUPPOSES.match(text, begins) and not _BLANK_LINES.search(text, len(before), first)
    return text[begins:first] if supposes or _THEN.match(text, first) else ""


#: The break before another paragraph of words, or an item; displays and words in lower case begin none.
_BREAK = re.compile(
    r"(?<!math::)\n[ \t]*\n\s*(?!\s|\$\$|\\\[|\\begin\b|```|\.\. |[a-z])"
    rf"|(?={_ITEM.pattern})"
)
_DISPLAY = re.compile(r"\$\$|\\\[|\\begin\b|```|\.\. math::")


@lru_cache(maxsize=8)
def _breaks(text: str) -> list[int]:
    ends = [match.end() for match in _BREAK.finditer(text)]
    return sorted({*ends, *(start for start, _ in headings(text))})


def paragraph_around(text: str, start: int) -> tuple[int, int]:
    """Returns the start and end of the paragraph at `start`, with the displays in it and behind it."""
    breaks = _breaks(text)
    at = bisect_right(breaks, start)
    return breaks[at - 1] if at else 0, breaks[at] if at < len(breaks) else len(text)


def holds_display(text: str, start: int, end: int) -> bool:
    """True if a display begins between the offsets."""
    return _DISPLAY.search(text, start, end) is not None


def plain(latex: str) -> str:
    """Returns a heading without its markup."""
    return " ".join(_COMMAND.sub("", latex).split())
