"""Logarithms of rotations and unit quaternions: true and false equations, the branch, and what is asked."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.linalg import logm
from scipy.spatial.transform import Rotation

from workbench import Checked, check
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.formula_errors import ReadError
from workbench.core.verdict import Outcome

SYMBOLS: dict[str, Any] = {
    "R": "rotation",
    "Q": "rotation",
    "q": {"kind": "hamilton quaternion", "unit": True},
    "n": {"kind": "vector", "unit": True},
    r"\theta": "scalar",
    "x": "vector",
    "y": "vector",
}
TURN = r"(\exp(\theta \operatorname{skew} n))"
ROTATION = r"\exp(\operatorname{skew} x)"


@pytest.mark.parametrize(
    ("true", "false"),
    [
        (r"\log(R^T) = -\log R", r"\log(R^T) = \log R"),
        (r"\log(R^{-1}) = -\log R", r"\log(R^{-1}) = 2 \log R"),
        (r"\log(Q R Q^T) = Q \log(R) Q^T", r"\log(Q R Q^T) = Q^T \log(R) Q"),
        (r"\log(Q^T R Q) = Q^T \log(R) Q", r"\log(Q^T R Q) = Q \log(R) Q^T"),
        (r"\exp(\log R) = R", r"\exp(\log R) = R^T"),
        (r"R \log(R) = \log(R) R", r"R \log(R) = -\log(R) R"),
        (r"\operatorname{tr}(\log R) = 0", r"\operatorname{tr}(\log R) = 1"),
        (r"\log(q^*) = -\log q", r"\log(q^*) = \log q"),
        (r"\exp(\frac{1}{2} \log q) \exp(\frac{1}{2} \log q) = q", r"\exp(\frac{1}{2} \log q) = q"),
    ],
)
def test_logarithm_of_a_free_rotation(true: str, false: str) -> None:
    assert check(true, SYMBOLS).outcome is Outcome.PROVED
    assert check(false, SYMBOLS).outcome is Outcome.REFUTED


@pytest.mark.parametrize(
    ("true", "false", "branch"),
    [
        (rf"\ln {{{TURN}}} = \theta \operatorname{{skew}} n", rf"\ln {{{TURN}}} = \operatorname{{skew}} n", r"-\pi < \theta < \pi"),
        (rf"\log({ROTATION}) = \operatorname{{skew}} x", rf"\log({ROTATION}) = -\operatorname{{skew}} x", r"\left\|x\right\| < \pi"),
        (
            rf"\ln {{{TURN}}} = \frac{{\theta}}{{2 \sin\theta}} ({TURN} - {TURN}^T)",
            rf"\ln {{{TURN}}} = \frac{{1}}{{2 \sin\theta}} ({TURN} - {TURN}^T)",
            r"-\pi < \theta < \pi",
        ),
        (rf"\log({ROTATION}) x = 0", rf"\log({ROTATION}) y = 0", r"\left\|x\right\| < \pi"),
    ],
)  # fmt: skip
def test_logarithm_on_its_branch(true: str, false: str, branch: str) -> None:
    verdict = check(true, SYMBOLS).verdict
    assert verdict.outcome is Outcome.CONDITIONAL and verdict.hypothesis == branch
    assert verdict.counterexample is not None
    assert check(false, SYMBOLS).outcome is Outcome.REFUTED


@pytest.mark.parametrize(
    ("latex", "outcome"),
    [
        (r"\log(R Q) = \operatorname{skew} x", Outcome.UNCHECKED),
        (rf"\log({ROTATION} \exp(\operatorname{{skew}} y)) = \operatorname{{skew}}(x + y)", Outcome.REFUTED),
        (rf"\log({ROTATION} {ROTATION}) = 2 \operatorname{{skew}} x", Outcome.UNCHECKED),
        (r"\log(R Q) = \log(R) + \log(Q)", Outcome.UNCHECKED),
    ],
)
def test_logarithm_of_a_product(latex: str, outcome: Outcome) -> None:
    assert check(latex, SYMBOLS).outcome is outcome


@pytest.mark.parametrize(
    "latex",
    [
        r"\log R = \frac{\theta}{2 \sin \theta} (R - R^T)",
        r"\operatorname{vect}(\log R) = x",
        r"-2 \log R = \operatorname{skew} x",
    ],
)
def test_logarithm_that_says_what_a_free_symbol_is(latex: str) -> None:
    assert check(latex, SYMBOLS).verdict.code is VerdictCode.STATES_A_LAW


@pytest.mark.parametrize(
    ("latex", "why"),
    [
        (r"\log R = x", "as a matrix, or as the column"),
        (r"\operatorname{Log}(R) = x", "two logarithms"),
    ],
)
def test_logarithm_that_is_asked_about(latex: str, why: str) -> None:
    with pytest.raises(ReadError, match=why):
        check(latex, SYMBOLS)


def test_notation_makes_the_logarithm_a_column(tmp_path: Path) -> None:
    notation = r"""[notation]
'\log(A)' = { where = { A = "rotation" }, means = '\operatorname{vect}(\ln A)' }
"""
    path = tmp_path / "signs.toml"
    path.write_text(notation)
    found = check(r"\log(Q R Q^T) = Q \log(R)", SYMBOLS, notation=path)
    assert isinstance(found, Checked) and found.outcome is Outcome.PROVED


def test_laws_of_logarithms_hold_in_numbers() -> None:
    """The laws of the module, by SciPy's logarithm of matrices."""
    R, Q = (Rotation.random(random_state=seed).as_matrix() for seed in (1, 2))
    assert np.allclose(logm(R.T), -logm(R)) and np.allclose(logm(Q @ R @ Q.T), Q @ logm(R) @ Q.T)
    assert not np.allclose(logm(R @ Q), logm(R) + logm(Q))
