"""Sentences with formulas in them, the same for every format: runs of text and of mathematics."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import isqrt
from typing import Any

from workbench.typeset.differences import Change, Difference

_INLINE_MATH = re.compile(r"\$([^$\n]+)\$")
_QUOTED = re.compile(r"`([^`\n]+)`")
_LISTED = 8
_RATIONAL = re.compile(r"-?\d+(/[1-9]\d*)?")


@dataclass(frozen=True)
class Run:
    """A stretch of plain text, or of LaTeX if `is_math`."""

    content: str
    is_math: bool = False


def text(content: str) -> Run:
    return Run(content)


def formula(latex: str) -> Run:
    return Run(latex, is_math=True)


def runs_of(prose: str) -> list[Run]:
    """A note or statement: what stands between dollar signs is LaTeX, the rest is text; `so` it quotes."""
    pieces = _INLINE_MATH.split(_QUOTED.sub("“\\1”", prose))
    return [Run(piece, is_math=bool(i % 2)) for i, piece in enumerate(pieces) if piece]


def change_runs(change: Change, first_is: str, second_is: str) -> list[Run]:
    """One change as a sentence; what the first formula is (printed, read) and the second (meant, right)."""
    runs = [text(f"{change.kind.capitalize()}: ")]
    place = [text(" after "), formula(change.following)] if change.following else []
    if change.before is None:
        return [*runs, formula(change.after or ""), text(" is missing"), *place, text(".")]
    runs += [formula(change.before), text(f" is {first_is}")]
    if change.after is None:
        return [*runs, *place, text("; it should not be there.")]
    return [*runs, *place, text("; "), formula(change.after), text(f" is {second_is}.")]


def difference_runs(difference: Difference | None, first_is: str, second_is: str) -> list[list[Run]]:
    """The changes, a sentence each; or one sentence where there is no list of changes."""
    if difference is None:
        return [[text("One of the two forms cannot be taken apart; compare them as they stand.")]]
    if difference.rewritten:
        return [[text("The two forms have little in common; compare them as a whole.")]]
    if not difference.changes:
        return [[text("The two forms differ only in grouping or spacing.")]]
    sentences = [change_runs(change, first_is, second_is) for change in difference.changes]
    if len(sentences) > _LISTED:
        rest = f"And {len(sentences) - _LISTED} more places, marked in the formulas."
        sentences[_LISTED:] = [[text(rest)]]
    return sentences


@dataclass(frozen=True)
class Values:
    """A value of a counterexample. latex: laid out for pencil, None where an entry is no rational number."""

    plain: str
    latex: str | None
    is_zero: bool


def values_of(entries: Sequence[str] | str) -> Values:
    """A number, a vector, or a matrix by rows; a dual one (2, 6, 18 entries) as real part + ε dual part."""
    entries = [entries] if isinstance(entries, str) else list(entries)
    plain = ", ".join(entries)
    if not entries or not all(_RATIONAL.fullmatch(entry) for entry in entries):
        return Values(plain, None, is_zero=False)
    is_zero = all(Fraction(entry) == 0 for entry in entries)
    if len(entries) not in (2, 6, 18):
        return Values(plain, _laid_out(entries), is_zero)
    half = len(entries) // 2
    real, dual = entries[:half], entries[half:]
    if all(Fraction(entry) == 0 for entry in dual):
        return Values(plain, _laid_out(real), is_zero)
    sign, size = _signed(dual)
    if all(Fraction(entry) == 0 for entry in real):
        return Values(plain, f"{sign.strip('+ ')}{size}", is_zero)
    return Values(plain, f"{_laid_out(real)} {sign} {size}", is_zero)


def _signed(dual: Sequence[str]) -> tuple[str, str]:
    """The sign of the dual part behind the real one, and ε times the rest."""
    if len(dual) == 1 and dual[0] in ("1", "-1"):
        return ("-" if dual[0] == "-1" else "+"), r"\varepsilon"
    if len(dual) == 1 and dual[0].startswith("-"):
        return "-", rf"\varepsilon {_laid_out([dual[0][1:]])}"
    return "+", rf"\varepsilon {_laid_out(dual)}"


def _laid_out(entries: Sequence[str]) -> str:
    numbers = [_rational_latex(entry) for entry in entries]
    size = isqrt(len(numbers))
    if len(numbers) == 1:
        return numbers[0]
    if all(Fraction(entry) == 0 for entry in entries):
        return r"\mathbf{0}"
    columns = size if size > 2 and size * size == len(numbers) else 1  # four: a quaternion
    rows = [" & ".join(numbers[at : at + columns]) for at in range(0, len(numbers), columns)]
    return r"\begin{bmatrix} " + r" \\ ".join(rows) + r" \end{bmatrix}"


def subtract(left: Sequence[str] | str, right: Sequence[str] | str) -> list[str] | None:
    """left − right, entry by entry, exactly; None where they are not rationals of one shape."""
    sides = [[side] if isinstance(side, str) else list(side) for side in (left, right)]
    if len(sides[0]) != len(sides[1]):
        return None
    if not all(_RATIONAL.fullmatch(entry) for side in sides for entry in side):
        return None
    return [str(Fraction(a) - Fraction(b)) for a, b in zip(*sides, strict=True)]


def plain_value(value: Any) -> str:
    """A figure of the evidence as text."""
    if isinstance(value, str):
        return value
    if isinstance(value, list | tuple) and all(isinstance(item, str) for item in value):
        return ", ".join(value)
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def _rational_latex(number: str) -> str:
    sign, digits = ("-", number[1:]) if number.startswith("-") else ("", number)
    if "/" not in digits:
        return sign + digits
    numerator, denominator = digits.split("/")
    return rf"{sign}\frac{{{numerator}}}{{{denominator}}}"
