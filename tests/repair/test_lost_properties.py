"""A matrix that the text calls a rotation and that is none is mended by one change, or by a few signs."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.judge.test_stated_rotations import MATRICES, SAID, judged, misprints
from workbench.app.pipeline.result_proposals import asks_for_proposals, with_proposals
from workbench.context.read_formulas import read_statement
from workbench.core.verdict import Outcome
from workbench.repair.propose.repair import repair
from workbench.repair.propose.search_limits import Limits

_STEP = 4


def proposed(folder: Path, left: str, rows: list[str], words: str = SAID) -> list[object]:
    """The statements proposed for a matrix, the likeliest first."""
    result = judged(folder, words, left, rows)
    assert asks_for_proposals(result)
    claim = result.claim
    found = repair(claim, Limits(seconds=60.0)).proposals
    assert all(each.verdict.outcome is Outcome.UNCHECKED for each in found), "other values are as good"
    return [read_statement(each.latex, claim.notation, claim.orders)[0] for each in found]


def right_form(folder: Path, left: str, rows: list[str], wrong: list[str]) -> object:
    claim = judged(folder, SAID, left, wrong).claim
    matrix = r" \\ ".join(rows)
    latex = rf"{left} = \begin{{bmatrix}} {matrix} \end{{bmatrix}}"
    return read_statement(latex, claim.notation, claim.orders)[0]


@pytest.mark.parametrize("name", MATRICES)
def test_one_misprint_of_a_rotation_is_mended(name: str, tmp_path: Path) -> None:
    left, rows = MATRICES[name]
    for wrong in [*misprints(rows)][1::_STEP]:
        assert right_form(tmp_path, left, rows, wrong) in proposed(tmp_path, left, wrong), wrong


def test_several_signs_are_mended_together(tmp_path: Path) -> None:
    """The lower triangle is a copy of the upper one."""
    left, rows = MATRICES["of a quaternion"]
    copied = [
        rows[0],
        "2 (x y - w z) & 1 - 2 (x^2 + z^2) & 2 (y z - w x)",
        "2 (x z + w y) & 2 (y z - w x) & 1 - 2 (x^2 + y^2)",
    ]
    assert right_form(tmp_path, left, rows, copied) in proposed(tmp_path, left, copied)


@pytest.mark.parametrize(
    "rows", [["0 & 0", "0 & 0"], [r"2 \cos\theta & 3 \sin\theta", r"5 \theta & 7"], ["x & y", "z & w"]]
)
def test_a_matrix_far_from_a_rotation_has_no_proposal(rows: list[str], tmp_path: Path) -> None:
    result = judged(tmp_path, SAID, "R", rows)
    assert not asks_for_proposals(result) or not repair(result.claim, Limits(seconds=20.0)).proposals


def test_a_search_for_another_value_keeps_the_reason(tmp_path: Path) -> None:
    left, (first, second) = MATRICES["plane"]
    result = judged(tmp_path, SAID, left, [first.replace("-", ""), second])
    (searched,) = with_proposals([result])
    assert searched.proposed and "rotation" in str(searched.verdict.reason)
