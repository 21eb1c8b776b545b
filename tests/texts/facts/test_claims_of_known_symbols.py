"""A formula of symbols that the model determines is a claim; it seems a law or a condition where it is misprinted."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import shown, verdicts
from workbench.core.verdict import Outcome

SYMBOLS = r"""[symbols]
'm' = { kind = "scalar", constant = true, positive = true }
'b' = { kind = "scalar", constant = true }
'c' = { kind = "scalar", constant = true }
'r' = "vector"
's' = { kind = "scalar", independent = true }
'x' = { kind = "scalar", independent = true }
'y' = { kind = "scalar", independent = true }
'z' = { kind = "scalar", independent = true }
'f' = "scalar"
'g' = "scalar"
'h' = "scalar"
'R' = { kind = "scalar", positive = true }
'\phi' = "scalar"
"""
MODEL = (
    SYMBOLS
    + r"""[definitions]
'v' = '\dot{r}'
'p' = 'm v'
'M' = 'b \dot{f} - c \dot{g}'
'N' = 'm \ddot{f}'
'X' = 'R \cos\phi'
'Y' = 'R \sin\phi'
"""
)


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        (r"p = m v = m \ddot{r}", Outcome.REFUTED),
        (r"p = m v = m \dot{r}", Outcome.PROVED),
        (r"m v = m \ddot{r}", Outcome.REFUTED),
        (r"m \ddot{r} = -b v", Outcome.DEFINITION),
        (r"m \ddot{r} = -b r", Outcome.DEFINITION),
        (r"\ddot{f} = -f", Outcome.DEFINITION),
        (r"\dot{f} = f", Outcome.DEFINITION),
        (r"M = b \dot{f} - c \dot{f}", Outcome.REFUTED),
        (r"M = b \dot{f} + c \dot{g}", Outcome.REFUTED),
        (r"M = -c \dot{g} + b \dot{f}", Outcome.PROVED),
        (r"N = -b f", Outcome.DEFINITION),
        (r"N = m x - b \dot{f}", Outcome.DEFINITION),
        (r"R = \sqrt{X^2 + Y^2}", Outcome.PROVED),
        (r"R = \sqrt{X^2 + f^2}", Outcome.DEFINITION),
        (
            r"\left. \frac{\partial}{\partial s} \begin{bmatrix} s x \\ s^2 y + s y \\ z \end{bmatrix} \right|_{s = 0} = (-x, y, 0)",
            Outcome.REFUTED,
        ),
        (
            r"\left. \frac{\partial}{\partial s} \begin{bmatrix} s x \\ s^2 y + s y \\ z \end{bmatrix} \right|_{s = 0} = (x, y, 0)",
            Outcome.PROVED,
        ),
    ],
)
def test_the_model_determines_it(tmp_path: Path, formula: str, expected: Outcome) -> None:
    assert expected in [each.outcome for each in verdicts(tmp_path, shown(formula), MODEL)]


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        (r"f = 2 \frac{b g}{m}", Outcome.REFUTED),
        (r"m f = 2 b g", Outcome.REFUTED),
        (r"m f = b g \cos(\pi)", Outcome.REFUTED),
        (r"m^2 f^2 = b^2 g^2", Outcome.PROVED),
        (r"m h = b g", Outcome.DEFINITION),
        (r"m f = h", Outcome.DEFINITION),
    ],
)
@pytest.mark.parametrize("assume", [r"m f = b g", r"U = b g", r"\frac{U}{b} = g"])
def test_what_assumptions_determine(tmp_path: Path, assume: str, formula: str, expected: Outcome) -> None:
    model = f"{SYMBOLS}[definitions]\n'U' = 'f m'\n[[claim]]\nat = 'line 1'\n"
    model += f"assume = ['{assume}', 'b \\neq 0']\n"
    (found,) = verdicts(tmp_path, shown(formula), model)
    assert found.outcome == expected
