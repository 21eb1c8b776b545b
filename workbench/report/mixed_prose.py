"""Sentences with formulas, the same for every format: runs of text and of mathematics."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

#: A formula between single or double dollar signs.
_MATH = re.compile(r"\$\$([^$]+)\$\$|\$([^$\n]+)\$")
_QUOTED = re.compile(r"`([^`\n]+)`")


@dataclass(frozen=True)
class Run:
    """A stretch of plain text, or of LaTeX if `is_math`."""

    content: str
    is_math: bool = False


def is_one_formula(sentence: Sequence[Run]) -> bool:
    return len(sentence) == 1 and sentence[0].is_math


def text(content: str) -> Run:
    return Run(content)


def formula(latex: str) -> Run:
    return Run(latex, is_math=True)


def runs_of(prose: str) -> list[Run]:
    """Returns the runs of a note: LaTeX between dollar signs, text elsewhere; `so` is quoted."""
    return _runs(_QUOTED.sub("“\\1”", prose), _MATH)


_GROUP = r"\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}"
#: A formula in brackets that stretch, up to two within each other.
_INSIDE = r"(?:(?!\\(?:left|right)(?![A-Za-z])).)*"
_RIGHT = r"\\right\s*(?:\\[A-Za-z]+|\\?.)"
_BRACKETS = rf"\\left(?![A-Za-z])(?:{_INSIDE}\\left(?![A-Za-z]){_INSIDE}{_RIGHT})*{_INSIDE}{_RIGHT}"
_SCRIPTS = rf"(?:[_^](?:{_GROUP}|[A-Za-z0-9]))*"
_SYMBOL = re.compile(rf"(?:{_BRACKETS}|\\[A-Za-z]+(?:{_GROUP})*|(?<![A-Za-z\\])[A-Za-z](?=[_^])){_SCRIPTS}")


def runs_with_symbols(text: str) -> list[Run]:
    """Returns the runs of a reason that contains symbols as bare LaTeX, such as `a_1`."""
    if "$" in text:
        return runs_of(text)
    return _runs(text, _SYMBOL)


def _runs(text: str, mathematics: re.Pattern[str]) -> list[Run]:
    """Returns the runs of a text. mathematics: matches LaTeX, as a whole or in its one group that matches."""
    found, at = [], 0
    for match in mathematics.finditer(text):
        latex = next(filter(None, match.groups()), match[0])
        found += [Run(text[at : match.start()]), Run(latex, is_math=True)]
        at = match.end()
    return [run for run in [*found, Run(text[at:])] if run.content]


def plain_value(value: Any) -> str:
    """Returns a figure of the evidence as text."""
    if isinstance(value, str):
        return value
    if isinstance(value, list | tuple) and all(isinstance(item, str) for item in value):
        return ", ".join(value)
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def minus(plain: str) -> str:
    """Returns the text with minus signs before numbers."""
    return re.sub(r"(?<![\w-])-(?=\d)", "−", plain)


def power_of_ten(exponent: int, factor: int = 1) -> str:
    """Returns a power of ten as text: 10⁻¹⁴, 3·10⁻¹⁴."""
    return f"{'' if factor == 1 else f'{factor}·'}10{str(exponent).translate(_RAISED)}"


def one_line(latex: str) -> str:
    return " ".join(latex.split())
