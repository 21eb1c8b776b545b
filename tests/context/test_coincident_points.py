"""The one-point theorem without its words: true where a point of the body is at the place of the moving one."""

from pathlib import Path

import pytest

from tests.context.judged_texts import judged, text_of
from workbench.core.verdict import Grade, Outcome

MODEL = r"""source = "p.md"
[frames]
base = "N"
names = ["B"]
'{}^F\omega^G' = "angular velocity of G in F"
[points]
names = ["S", "T", "P"]
'r^{P/O}' = "to P from O"
'{}^Fv^P' = "velocity of P in F"
'{}^Fa^P' = "acceleration of P in F"
fixed = { S = "B", T = "B" }
"""
ONE_POINT = [
    "{}^Nv^P = {}^Bv^P + {}^Nv^T",
    r"{}^Na^P = {}^Ba^P + {}^Na^T + 2 {}^N\omega^B \times {}^Bv^P",
]


@pytest.mark.parametrize("formula", ONE_POINT)
def test_formula_of_coincident_points_is_doubted(tmp_path: Path, formula: str) -> None:
    (verdict,) = judged(tmp_path, text_of([formula]), MODEL)
    assert (verdict.outcome, verdict.grade) == (Outcome.REFUTED, Grade.WARNING)
    assert "P and T: at one place" in str(verdict.unless)


@pytest.mark.parametrize(
    "formula",
    [
        "{}^Nv^P = {}^Bv^P - {}^Nv^T",
        r"{}^Nv^P = {}^Bv^P + {}^Nv^T + {}^N\omega^B \times r^{T/P} + {}^N\omega^B \times r^{P/T}",
        r"{}^Nv^P = {}^Bv^P + {}^Nv^S + 2 {}^N\omega^B \times r^{P/S}",
        r"{}^Na^P = {}^Ba^P + {}^Na^T + {}^N\omega^B \times {}^Bv^P",
    ],
)
def test_other_falsehood_of_points_is_an_error(tmp_path: Path, formula: str) -> None:
    (verdict,) = judged(tmp_path, text_of([formula]), MODEL)
    assert (verdict.outcome, verdict.grade, verdict.unless) == (Outcome.REFUTED, Grade.ERROR, ())
