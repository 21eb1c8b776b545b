"""Sums to an n that nothing states a range for: proved for every n, addend by addend, or not at all."""

from __future__ import annotations

import pytest

from workbench import check

SYMBOLS = {
    "m_i": {"kind": "scalar", "constant": True},
    "a_i": "scalar",
    "b_i": "scalar",
    "x_i": "vector",
    "y_i": "vector",
    "M": "scalar",
    r"\omega": "vector",
}


def test_a_sum_over_nothing_or_in_a_definition_needs_bounds() -> None:
    for formula, definitions in ((r"\sum_k \omega = \omega", []), ("M = 0", [r"M = \sum_i a_i"])):
        with pytest.raises(ValueError, match="expected the bounds of the sum"):
            check(formula, SYMBOLS, definitions=definitions)
