"""The words around a display."""

from __future__ import annotations

import re

_FAR = 800
_COMMENT = re.compile(r"(?<!\\)%[^\n]*")
_BLANK_LINES = re.compile(r"\n[ \t]*\n")
_DISPLAY_END = re.compile(
    r"\\end\s*\{[^}]*\}|\\\]|\$\$|\\(?:sub)*section\*?\s*\{[^}]*\}|^#+ .*$|^.*\n[=\-~^]{4,}$", re.MULTILINE
)
_SENTENCE = re.compile(r"(?<=[.!?])\s+(?=[A-Z$\\*`(])")
_COMMAND = re.compile(r"\\[A-Za-z]+\*?\s*|[{}]")


def sentence_before(text: str, start: int) -> str:
    """The last sentence of the paragraph before the display at `start`; what begins there counts as one."""
    chunk = _COMMENT.sub("", text[max(0, start - _FAR) : start]).rstrip()
    chunk = _BLANK_LINES.split(chunk)[-1]
    for match in reversed(list(_DISPLAY_END.finditer(chunk))):
        chunk = chunk[match.end() :]
        break
    return _SENTENCE.split(" ".join(chunk.split()))[-1].strip()


def plain(latex: str) -> str:
    """A heading without its markup."""
    return " ".join(_COMMAND.sub("", latex).split())
