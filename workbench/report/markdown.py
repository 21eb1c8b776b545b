"""Markdown as GitHub reads it: escaped text, mathematics between dollar signs."""

from __future__ import annotations

import re
from collections.abc import Iterable

from workbench.report.prose import Run, one_line
from workbench.typeset.latex_atoms import LatexNotTypesettable, atoms_of, in_colour

_SPECIAL = re.compile(r"([\\`*_{}\[\]()<>#+\-.!|~$&])")


def escaped(plain: str) -> str:
    """Text with every character that Markdown gives a meaning escaped, on one line."""
    return _SPECIAL.sub(r"\\\1", " ".join(plain.split()))


def code(plain: str) -> str:
    """A code span, with a fence longer than any run of backticks inside it."""
    plain = " ".join(plain.split())
    longest = max((len(ticks) for ticks in re.findall("`+", plain)), default=0)
    fence = "`" * (longest + 1)
    pad = " " if plain.startswith("`") or plain.endswith("`") else ""
    return f"{fence}{pad}{plain}{pad}{fence}"


def inline_math(latex: str) -> str:
    return f"${one_line(latex)}$" if _is_safe(latex) else code(latex)


def display_math(latex: str, marked: frozenset[int] = frozenset(), colour: str = "green") -> str:
    """A displayed formula, with the marked leaves (indices into its atoms) in a colour."""
    if not _is_safe(latex):
        return code(latex)
    return f"$$\n{one_line(in_colour(latex, marked, colour))}\n$$"


def runs(sentence: Iterable[Run]) -> str:
    pieces = []
    for run in sentence:
        if run.is_math:
            pieces.append(inline_math(run.content))
        else:
            lead, trail = run.content[:1].isspace(), run.content[-1:].isspace()
            pieces.append(" " * lead + escaped(run.content) + " " * (trail and bool(run.content.strip())))
    return "".join(pieces).strip()


def _is_safe(latex: str) -> bool:
    """Only what the report knows goes between dollars; anything else is shown as source."""
    try:
        return bool(atoms_of(latex))
    except LatexNotTypesettable:
        return False


FILTERS = {"text": escaped, "code": code, "imath": inline_math, "dmath": display_math, "runs": runs}
