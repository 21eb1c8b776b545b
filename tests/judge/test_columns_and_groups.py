"""Columns of four beside quaternions, the groups of motions as sets, Ad as a name, ω × R: identities, and the same
with one sign or one factor changed."""

from __future__ import annotations

import pytest

from workbench import check
from workbench.core.verdict import Outcome


@pytest.mark.parametrize(
    "entries", [("f", "0", "1", "g"), ("f", "0", "g", "h"), ("f", "g", "0", "h"), ("f", "g", "1", "h")]
)
@pytest.mark.parametrize("duals", ["", "f", "g", "fg", "fgh"])
def test_the_inverse_of_a_2x2_matrix_of_real_or_dual_numbers(entries: tuple, duals: str) -> None:
    a, b, c, d = (rf"\underline{{{x}}}" if x in duals and x.isalpha() else x for x in entries)
    symbols = {"f": "scalar", "g": "scalar", "h": "scalar"}
    symbols |= {rf"\underline{{{x}}}": "dual scalar" for x in duals}
    inverse = rf"\begin{{bmatrix}} {a} & {b} \\ {c} & {d} \end{{bmatrix}}^{{-1}} = "
    cofactors = rf"\frac{{1}}{{{a} \cdot {d} - {b} \cdot {c}}} \begin{{bmatrix}} {d} & -{b} \\ -{c} & {a} \end{{bmatrix}}"
    assert check(inverse + cofactors, symbols=symbols).outcome is Outcome.CONDITIONAL
    assert check(f"{inverse} 2 {cofactors}", symbols=symbols).outcome is Outcome.REFUTED
