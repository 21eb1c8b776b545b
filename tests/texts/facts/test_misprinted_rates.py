"""A rate of the wrong order in a product is false; what a model assumes something of is no definition."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import shown, verdicts
from workbench.core.verdict import Outcome

MODEL = r"""[symbols]
'm' = { kind = "scalar", constant = true, positive = true }
'b' = { kind = "scalar", constant = true, positive = true }
'r' = "vector"
'x' = "scalar"
[definitions]
'v' = '\dot{r}'
'p' = 'm v'
"""


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        (r"p = m v = m \ddot{r}", Outcome.REFUTED),
        (r"p = m v = m \dot{r}", Outcome.PROVED),
        (r"m v = m \ddot{r}", Outcome.REFUTED),
        (r"m \dot{v} = m r", Outcome.DEFINITION),
        (r"m \ddot{r} = -b v", Outcome.DEFINITION),
        (r"m \ddot{r} = -b r", Outcome.DEFINITION),
        (r"\ddot{x} = -x", Outcome.DEFINITION),
        (r"\dot{x} = x", Outcome.DEFINITION),
    ],
)
def test_products_with_a_rate(tmp_path: Path, formula: str, expected: Outcome) -> None:
    assert expected in [each.outcome for each in verdicts(tmp_path, shown(formula), MODEL)]


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        (r"2 m x + c = 0", Outcome.REFUTED),
        (r"x c = -m x^2", Outcome.PROVED),
        (r"2 m x + b d = 0", Outcome.REFUTED),
    ],
)
def test_an_assumed_symbol_is_not_said_anew(tmp_path: Path, formula: str, expected: Outcome) -> None:
    model = MODEL.replace("[definitions]\n", "'c' = 'scalar'\n'd' = 'scalar'\n[definitions]\n'e' = 'b d'\n")
    assume = r"c = -m x" if "c" in formula else r"e = -m x"
    model += f"[[claim]]\nat = 'line 1'\nassume = ['{assume}']\n"
    (found,) = verdicts(tmp_path, shown(formula), model)
    assert found.outcome == expected
