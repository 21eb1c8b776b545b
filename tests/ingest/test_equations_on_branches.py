"""Equations of a draft that are false on other branches of roots and inverse functions only."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.drafts import judged_draft_of
from workbench.core.verdict import Grade

TEXT = r"""The wrist is at

$$
x = \rho\cos\theta, \qquad y = \rho\sin\theta .
$$

Conversely

$$
%s
$$
"""
RIGHT = [r"\rho = \sqrt{x^2 + y^2}", r"\theta = \operatorname{atan2}(y, x)", r"\theta = \arccos(x/\rho)"]
WRONG = [r"\theta = \operatorname{atan2}(x, y)", r"\theta = \arccos(y/\rho)"]


@pytest.mark.parametrize("formula", RIGHT)
def test_equation_on_a_branch_is_no_warning(formula: str, tmp_path: Path) -> None:
    path = tmp_path / "polar.md"
    path.write_text(TEXT % formula)
    assert judged_draft_of(path)[-1].verdict.grade is not Grade.WARNING


@pytest.mark.parametrize("formula", WRONG)
def test_misprint_holds_on_no_branch(formula: str, tmp_path: Path) -> None:
    path = tmp_path / "polar.md"
    path.write_text(TEXT % formula)
    assert judged_draft_of(path)[-1].verdict.grade is Grade.WARNING
