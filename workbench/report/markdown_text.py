"""GitHub Markdown: escaped text, formulas between dollar signs."""

from __future__ import annotations

import re
from collections.abc import Iterable

from workbench.report.mixed_prose import Run, minus, one_line
from workbench.source.typeset.latex_atoms import LatexNotTypesettable, atoms_of

#: Characters that are inline markup: emphasis at the edge of a word, links, tags, entities.
_SPECIAL = re.compile(
    r"[\\`\[\]|$]|\*(?=\S)|(?<=\S)\*|(?<![^\W_])_|_(?![^\W_])|<(?=[A-Za-z/!?])|&(?=#|\w+;)|~(?=~)"
)
_AT_START = re.compile(r"^(?:[#>+-]|\d+[.)](?=\s))")


def escaped(plain: str) -> str:
    """Returns text on one line with exactly the markup characters escaped."""
    line = _SPECIAL.sub(lambda sign: "\\" + sign[0], " ".join(plain.split()))
    return _AT_START.sub(lambda sign: sign[0][:-1] + "\\" + sign[0][-1], line)


def code(plain: str) -> str:
    """Returns a code span, with a fence longer than any run of backticks inside it."""
    plain = " ".join(plain.split())
    longest = max((len(ticks) for ticks in re.findall("`+", plain)), default=0)
    fence = "`" * (longest + 1)
    pad = " " if plain.startswith("`") or plain.endswith("`") else ""
    return f"{fence}{pad}{plain}{pad}{fence}"


def inline_math(latex: str) -> str:
    return f"${one_line(latex)}$" if _is_safe(latex) else code(latex)


def runs(sentence: Iterable[Run]) -> str:
    pieces = []
    for run in sentence:
        if run.is_math:
            pieces.append(inline_math(run.content))
        else:
            lead, trail = run.content[:1].isspace(), run.content[-1:].isspace()
            pieces.append(
                " " * lead + escaped(minus(run.content)) + " " * (trail and bool(run.content.strip()))
            )
    return "".join(pieces).strip()


def cell(sentence: Iterable[Run]) -> str:
    """Returns the text for a table cell, where bars are escaped."""
    spelled = [
        Run(r.content.replace("|", r"\vert "), True) if r.is_math and _is_safe(r.content) else r
        for r in sentence
    ]
    return runs(spelled).replace("|", r"\|").replace(r"\\|", r"\|")


def _is_safe(latex: str) -> bool:
    """True if the formula can be typeset; others are shown as source."""
    try:
        return bool(atoms_of(latex))
    except LatexNotTypesettable:
        return False


FILTERS = {"text": escaped, "imath": inline_math, "runs": runs, "cell": cell}
