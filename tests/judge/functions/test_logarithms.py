"""Logarithms of rotations and unit quaternions: true and false equations, the branch, and what is asked."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from scipy.linalg import logm
from scipy.spatial.transform import Rotation

from workbench import Checked, check
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


def test_factors_that_cancel_leave_the_logarithm() -> None:
    for product in (
        r"R Q Q^T R^T \exp(\tilde{x})",
        r"\exp(\tilde{x}) Q^{-1} Q",
        r"R^T R \exp(\tilde{x}) Q Q^T",
    ):
        assert check(rf"\tilde{{x}} = 2 \ln({product})", SYMBOLS).outcome is Outcome.REFUTED
        assert check(rf"\tilde{{x}} = \ln({product})", SYMBOLS).outcome is not Outcome.REFUTED
    product = r"\exp(\operatorname{quat}(0, x)) q q^*"
    assert check(rf"x = 2 \operatorname{{Vec}}(\ln({product}))", SYMBOLS).outcome is Outcome.REFUTED
    assert check(rf"x = \operatorname{{Vec}}(\ln({product}))", SYMBOLS).outcome is not Outcome.REFUTED
