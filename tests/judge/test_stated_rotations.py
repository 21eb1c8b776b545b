"""A matrix that the text calls a rotation is one: the definition that is none is a warning."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.drafts import draft_of
from workbench.app.pipeline.judge_claims import judge_claims
from workbench.core.codes.context_codes import ContextCode
from workbench.core.verdict import Grade, Outcome
from workbench.papers.drafting.judged_draft import on_drafted_kinds
from workbench.prover.results.claim_results import ClaimResult

#: Rotations as texts print them: the left side, and the rows.
MATRICES = {
    "plane": ("R", [r"\cos\theta & -\sin\theta", r"\sin\theta & \cos\theta"]),
    "about x": (
        r"\mathbf{R}_x(\theta)",
        ["1 & 0 & 0", r"0 & \cos\theta & -\sin\theta", r"0 & \sin\theta & \cos\theta"],
    ),
    "homogeneous": (
        "T_z",
        [
            r"\cos\theta & -\sin\theta & 0 & 0",
            r"\sin\theta & \cos\theta & 0 & 0",
            "0 & 0 & 1 & 0",
            "0 & 0 & 0 & 1",
        ],
    ),
    "of a quaternion": (
        "R",
        [
            "1 - 2 (y^2 + z^2) & 2 (x y - w z) & 2 (x z + w y)",
            "2 (x y + w z) & 1 - 2 (x^2 + z^2) & 2 (y z - w x)",
            "2 (x z - w y) & 2 (y z + w x) & 1 - 2 (x^2 + y^2)",
        ],
    ),
    "of a quaternion by its numbers": (
        "C",
        [
            "q_0^2 + q_1^2 - q_2^2 - q_3^2 & 2 (q_1 q_2 - q_0 q_3) & 2 (q_1 q_3 + q_0 q_2)",
            "2 (q_1 q_2 + q_0 q_3) & q_0^2 - q_1^2 + q_2^2 - q_3^2 & 2 (q_2 q_3 - q_0 q_1)",
            "2 (q_1 q_3 - q_0 q_2) & 2 (q_2 q_3 + q_0 q_1) & q_0^2 - q_1^2 - q_2^2 + q_3^2",
        ],
    ),
    "by two angles": (
        "R",
        [
            r"\cos\alpha \cos\beta & -\sin\alpha & \cos\alpha \sin\beta",
            r"\sin\alpha \cos\beta & \cos\alpha & \sin\alpha \sin\beta",
            r"-\sin\beta & 0 & \cos\beta",
        ],
    ),
}
#: Every so many misprints are tried.
_STEP = 5
SAID = "The rotation matrix is"


def judged(folder: Path, words: str, left: str, rows: list[str]) -> ClaimResult:
    path = folder / "p.tex"
    matrix = r" \\ ".join(rows)
    path.write_text(rf"{words} \[ {left} = \begin{{bmatrix}} {matrix} \end{{bmatrix}} \] as usual.")
    draft = draft_of(path)
    (result,) = on_drafted_kinds(draft, judge_claims(draft.paper.claims, motions=False))
    return result


def misprints(rows: list[str]) -> Iterator[list[str]]:
    """Yields the rows with one sign or one function changed."""
    for at, row in enumerate(rows):
        for sign in re.finditer(r"[+-]|\\sin|\\cos", row):
            other = {"+": "-", "-": "+", r"\sin": r"\cos", r"\cos": r"\sin"}[sign[0]]
            yield [*rows[:at], row[: sign.start()] + other + row[sign.end() :], *rows[at + 1 :]]


@pytest.mark.parametrize("name", MATRICES)
def test_a_rotation_is_a_definition(name: str, tmp_path: Path) -> None:
    left, rows = MATRICES[name]
    result = judged(tmp_path, SAID, left, rows)
    assert result.verdict.outcome is Outcome.DEFINITION and not result.is_wrong


@pytest.mark.parametrize("name", MATRICES)
def test_a_misprint_of_a_rotation_is_a_warning(name: str, tmp_path: Path) -> None:
    left, rows = MATRICES[name]
    for wrong in [*misprints(rows)][::_STEP]:
        result = judged(tmp_path, SAID, left, wrong)
        assert result.verdict.code is ContextCode.LACKS_PROPERTY, wrong
        assert result.shown is Grade.WARNING


@pytest.mark.parametrize(
    "words",
    [
        "We have",
        "The derivative of the rotation matrix is",
        "For small angles the rotation matrix is",
        "This is not a rotation matrix:",
        "The rotation is slow. The matrix is",
    ],
)
def test_other_words_state_no_rotation(words: str, tmp_path: Path) -> None:
    left, (first, second) = MATRICES["plane"]
    result = judged(tmp_path, words, left, [first, second.replace(r"\sin", r"2 \sin")])
    assert result.verdict.code is not ContextCode.LACKS_PROPERTY


def test_a_matrix_that_names_its_entries_is_no_error(tmp_path: Path) -> None:
    rows = [" & ".join(f"r_{{{i}{j}}}" for j in (1, 2, 3)) for i in (1, 2, 3)]
    assert judged(tmp_path, SAID, "R", rows).verdict.outcome is Outcome.DEFINITION
