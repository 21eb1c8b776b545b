"""The title of a text."""

from __future__ import annotations

import html
import re
from pathlib import Path
from typing import TYPE_CHECKING

from workbench.source.documents.surrounding_words import group_end
from workbench.source.documents.tex.tex_tokens import COMMENT

if TYPE_CHECKING:
    from workbench.source.documents import Text

_TEX = re.compile(r"\\title\s*(?:\[[^\]]*\]\s*)?\{")
_WEB = re.compile(r"<title[^>]*>(.*?)</title>|<h1\b[^>]*>(.*?)</h1>", re.DOTALL | re.IGNORECASE)
_MARKED = re.compile(r"^title:\s*[\"']?([^\n\"']+)[\"']?\s*$|^#\s+([^\n]+)$", re.MULTILINE)
_UNDERLINED = re.compile(r"^([^\s|=\-~^#*+][^\n]*)\n([=*#~^\"-])\2{2,}[ \t]*$", re.MULTILINE)
#: Commands of a title page that are not part of the title: notes, marks, sizes, and line breaks.
_ASIDE = re.compile(r"\\(?:thanks|footnote|footnotemark|label|vspace|hspace)\*?\s*(?:\[[^\]]*\])?\s*\{")
_COMMAND = re.compile(r"\\[A-Za-z]+\*?\s*|[{}]|\\\\(?:\[[^\]]*\])?")
_TAG = re.compile(r"<[^>]+>")


def title_of(text: str, path: Path) -> str | None:
    """Returns the title by `\\title`, the first heading or `<title>`; None for a text without a title.

    Markup is removed, except formulas between dollar signs.
    """
    suffix = path.suffix.lower()
    if suffix in (".html", ".htm", ".xhtml"):
        found = _WEB.search(text)
        raw = html.unescape(_TAG.sub(" ", found[1] or found[2] or "")) if found else ""
    elif suffix == ".tex":
        start = _TEX.search(COMMENT.sub(lambda m: " " * len(m[0]), text))
        raw = _plain(_group(text, start.end())) if start else ""
    else:
        pattern = _UNDERLINED if suffix == ".rst" else _MARKED
        found = pattern.search(text)
        raw = next((group for group in found.groups() if group), "") if found else ""
    title = " ".join(raw.split())
    return title or None


def own_title(text: Text) -> str | None:
    """Returns the title of the first of its files that has one."""
    return next(filter(None, (title_of(source.text, source.path) for source in text.sources)), None)


def _group(text: str, start: int) -> str:
    """Returns the text up to the closing brace."""
    return COMMENT.sub("", text[start : group_end(text, start) - 1])


def _plain(latex: str) -> str:
    while (aside := _ASIDE.search(latex)) is not None:
        inside = _group(latex, aside.end())
        latex = latex[: aside.start()] + latex[aside.end() + len(inside) + 1 :]
    pieces = latex.split("$")
    for at in range(0, len(pieces), 2):
        words = pieces[at].replace("---", "—").replace("--", "–").replace("~", " ")
        pieces[at] = _COMMAND.sub(" ", words.replace("``", "“").replace("''", "”"))
    return "$".join(pieces)
