"""Conventions on which the field is divided: named where one makes a false formula true, never where declared."""

from pathlib import Path

import pytest

from tests.context.judged_texts import judged, model, text_of
from workbench.core.verdict import Grade, Outcome

KINDS = {"R": "rotation", "a": "vector", "b": "vector", r"\phi": "vector", "T": "tensor"}
TURN = r"\exp(\operatorname{skew}(\phi))"
UNITS = "".join(
    f"{name} = '\\begin{{bmatrix}} {entries} \\end{{bmatrix}}'\n"
    for name, entries in (("i", r"0 \\ 1 \\ 0 \\ 0"), ("j", r"0 \\ 0 \\ 1 \\ 0"), ("k", r"0 \\ 0 \\ 0 \\ 1"))
)
QUATERNIONS = model(dict.fromkeys("ijk", "hamilton quaternion"), f"[definitions]\n{UNITS}")


@pytest.mark.parametrize(
    ("texts", "of", "convention"),
    [
        (["i j = -k"], 'guessed = ["[conventions]"]\n' + QUATERNIONS, "JPL"),
        ([f"T := {TURN} R", f"T a = R {TURN} a"], model(KINDS), "left or right perturbation"),
        (
            [
                r"V := \begin{bmatrix} a \\ b \end{bmatrix}",
                r"V + V = 2 \begin{bmatrix} b \\ a \end{bmatrix}",
            ],
            model({**KINDS, "V": "matrix 6×1"}),
            "other order",
        ),
    ],
)
def test_convention_that_makes_a_falsehood_true_is_named(
    tmp_path: Path, texts: list[str], of: str, convention: str
) -> None:
    *_, verdict = judged(tmp_path, text_of(texts), of)
    assert verdict.outcome is Outcome.REFUTED and any(convention in each for each in verdict.unless)
    assert verdict.grade is not Grade.ERROR


def test_declared_convention_is_not_tried(tmp_path: Path) -> None:
    (verdict,) = judged(tmp_path, text_of(["i j = -k"]), QUATERNIONS)
    assert (verdict.grade, verdict.unless) == (Grade.ERROR, ())
