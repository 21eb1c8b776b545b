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
SPINS = {"R": "rotation", "a": "vector"}
SPIN = "[definitions]\n'\\omega' = '\\operatorname{vect}(\\dot{R} R^T)'\n"
AXIS = r"\begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix}"
PASSIVE = r"R = \begin{bmatrix} \cos x & \sin x & 0 \\ -\sin x & \cos x & 0 \\ 0 & 0 & 1 \end{bmatrix}"
GRADIENT = r"\frac{\partial (a \cdot q)}{\partial q} = a"
COLUMNS = """source = "p.md"
guessed = ["[conventions]"]
conventions = { gradient = "row" }
symbols = { a = { kind = "vector", constant = true }, q = { kind = "vector", independent = true } }
"""
FRAMED = r"\frac{{}^N d}{d t} a = \dot{a} + {}^N \omega^B \times a"
FRAMES = r"""source = "p.md"
guessed = ["[frames]"]
symbols = { a = "vector" }
[frames]
base = "N"
names = ["B"]
dot = "N"
'{}^F\frac{d}{dt}' = "derivative"
'{}^F\omega^G' = "angular velocity of G in F"
"""
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
        ([r"\dot{R} = -R \operatorname{skew}(\omega)"], model(SPINS, SPIN), "other way"),
        (
            [PASSIVE, rf"\dot{{R}} = \dot{{x}} \operatorname{{skew}}({AXIS}) R"],
            model({"R": "rotation", "x": "scalar"}),
            "active or passive",
        ),
        (
            [r"w := \operatorname{vect}(R^T \dot{R})", r"\dot{R} = \operatorname{skew}(w) R"],
            model({"R": "rotation", "w": "vector"}),
            "left or right Jacobian",
        ),
        ([GRADIENT], COLUMNS, "row and column"),
        ([FRAMED], FRAMES, "another frame"),
    ],
)
def test_convention_that_makes_a_falsehood_true_is_named(
    tmp_path: Path, texts: list[str], of: str, convention: str
) -> None:
    *_, verdict = judged(tmp_path, text_of(texts), of)
    assert verdict.outcome in (Outcome.REFUTED, Outcome.ILL_FORMED)
    assert any(convention in each for each in verdict.unless)
    assert verdict.grade is Grade.WARNING


@pytest.mark.parametrize(
    ("formula", "of"),
    [
        ("i j = -k", QUATERNIONS),
        (FRAMED, FRAMES.replace('guessed = ["[frames]"]\n', "")),
        (
            r"\dot{R} = \operatorname{skew}(\omega) R",
            model(SPINS, SPIN.replace(r"\dot{R} R^T", r"R^T \dot{R}")),
        ),
        (r"\dot{R} = \operatorname{skew}(\omega) R + R", model(SPINS, SPIN)),
    ],
)
def test_declared_convention_is_not_tried(tmp_path: Path, formula: str, of: str) -> None:
    (verdict,) = judged(tmp_path, text_of([formula]), of)
    assert (verdict.grade, verdict.unless) == (Grade.ERROR, ())


def test_declared_gradient_is_kept(tmp_path: Path) -> None:
    (verdict,) = judged(tmp_path, text_of([GRADIENT]), COLUMNS.replace('guessed = ["[conventions]"]\n', ""))
    assert verdict.outcome is Outcome.ILL_FORMED
