"""Keys of LaTeX, equal for formulas that differ only in marks that print nothing or the same."""

from __future__ import annotations

import re
from enum import Flag, auto
from functools import cache


class Ignored(Flag):
    """The marks that a key leaves out, with all white space."""

    BRACES = auto()
    SIZES = auto()
    GAPS = auto()
    ALIGNMENT = auto()


_PATTERNS = {
    Ignored.BRACES: r"[{}]",
    Ignored.SIZES: r"\\(?:left|right|[bB]igg?[lrm]?)(?![A-Za-z])",
    Ignored.GAPS: r"\\[,;!]",
    Ignored.ALIGNMENT: "&",
}


def latex_key(latex: str, ignored: Ignored = Ignored.BRACES) -> str:
    """Returns the LaTeX without white space and without the marks that are ignored."""
    return _pattern(ignored).sub("", latex)


@cache
def _pattern(ignored: Ignored) -> re.Pattern[str]:
    return re.compile("|".join([r"\s", *(_PATTERNS[each] for each in ignored)]))
