"""An index without a stated range: of a family of which the definitions hold some members, it means these."""

from pathlib import Path

import pytest

from tests.context.judged_texts import judged, text_of
from workbench.core.verdict import Grade, Outcome

MODEL = r"""source = "p.md"
[symbols]
'q_n' = { kind = "scalar", independent = true }
'f' = { kind = "scalar", constant = true }
[definitions]
'x' = 'f \cos(q_1)'
'y' = 'f \cos(q_1) + f \cos(q_2)'
'z' = 'f \cos(q_1) + f \cos(q_3)'
"""


@pytest.mark.parametrize(("defined", "values"), [("x", "k = 1..1"), ("y", "k = 1..2")])
def test_formula_that_holds_for_known_members_is_conditional(
    tmp_path: Path, defined: str, values: str
) -> None:
    (verdict,) = judged(
        tmp_path, text_of([rf"\frac{{\partial {defined}}}{{\partial q_k}} = -f \sin(q_k)"]), MODEL
    )
    assert (verdict.outcome, verdict.grade) == (Outcome.CONDITIONAL, Grade.NOTE)
    assert str(verdict.hypothesis) == values and values in str(verdict.reason)


@pytest.mark.parametrize(
    "formula",
    [
        r"\frac{\partial x}{\partial q_k} = f \sin(q_k)",  # false for the member, too
        r"\frac{\partial z}{\partial q_k} = -f \sin(q_k)",  # no range has these members alone
        r"q_k + q_k = q_k",  # no member is known
    ],
)
def test_other_falsehood_with_an_index_stays(tmp_path: Path, formula: str) -> None:
    (verdict,) = judged(tmp_path, text_of([formula]), MODEL)
    assert (verdict.outcome, verdict.grade) == (Outcome.REFUTED, Grade.ERROR)


def test_denominator_that_may_vanish_stays_a_condition(tmp_path: Path) -> None:
    formula = r"\frac{\partial x}{\partial q_k} = -\frac{f \sin(q_k) q_k}{q_k}"
    (verdict,) = judged(tmp_path, text_of([formula]), MODEL)
    assert (verdict.outcome, verdict.grade, str(verdict.hypothesis)) == (
        Outcome.CONDITIONAL,
        Grade.NOTE,
        "k = 1..1",
    )


def test_stated_range_is_kept(tmp_path: Path) -> None:
    formula = r"\frac{\partial x}{\partial q_k} = -f \sin(q_k), \quad k = 1, \dots, 3"
    (verdict,) = judged(tmp_path, text_of([formula]), MODEL)
    assert (verdict.outcome, verdict.grade) == (Outcome.REFUTED, Grade.ERROR)
