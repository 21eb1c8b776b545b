"""Decimals that a text has rounded: 1/30 = 0.033."""

from __future__ import annotations

import re
from fractions import Fraction

from workbench.judge.verdict import Counterexample

_DECIMAL = re.compile(r"\d*\.(\d+)")

ROUNDED = "the sides differ by no more than its decimals may be rounded by"


def is_rounded(latex: str, against: Counterexample) -> bool:
    """Whether the sides of a formula differ there by no more than half a unit of the last place of each of
    its decimals, put together, as a part of what is largest. Of roots it may be so."""
    parts = []
    for found in _DECIMAL.finditer(latex):
        value, half = Fraction(found[0]), Fraction(1, 2 * 10 ** len(found[1]))
        parts.append(half / value if value else half)
    if not parts:
        return False
    try:
        left, right = ([Fraction(entry) for entry in side] for side in (against.left, against.right))
    except ValueError:
        return True
    largest = max(map(abs, (*left, *right)))
    return all(abs(a - b) <= sum(parts) * largest for a, b in zip(left, right, strict=True))
