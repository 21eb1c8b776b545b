"""Inverses of exponentials and of products with them: without a condition, and as NumPy finds the matrices."""

from __future__ import annotations

from random import Random

import numpy as np
import pytest

from workbench import check
from workbench.core.verdict import EngineDisagreement, Outcome
from workbench.engines.inventory.inverses import inverted
from workbench.engines.polynomial import polynomial_engine

SYMBOLS = {
    "g": "rotation",
    "x": "vector",
    "y": "vector",
    "n": {"kind": "vector", "unit": True},
    r"\theta": "scalar",
}
VALUES = {
    r"\tilde{x}": np.array([[0, -0.3, 0.2], [0.3, 0, -0.7], [-0.2, 0.7, 0]]),
    r"\tilde{y}": np.array([[0, 0.5, 0.1], [-0.5, 0, 0.4], [-0.1, -0.4, 0]]),
    r"\theta \tilde{n}": 0.8 * np.array([[0, -0.6, 0], [0.6, 0, -0.8], [0, 0.8, 0]]),
}
G = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])


def exponential(a: np.ndarray) -> np.ndarray:
    total, power = np.eye(3), np.eye(3)
    for k in range(1, 30):
        power = power @ a / k
        total = total + power
    return total


def factor(random: Random, exponent: str | None, sign: int) -> tuple[str, np.ndarray]:
    """A factor and its value; with the sign -1 its inverse."""
    if exponent is None:
        return ("g", G) if sign > 0 else ("g^T", G.T)
    text = exponent if sign > 0 else f"-{exponent}"
    return f"e^{{{text}}}", exponential(sign * VALUES[exponent])


@pytest.mark.parametrize("seed", range(60))
def test_inverse_of_a_product_with_exponentials(seed: int) -> None:
    random = Random(seed)
    kinds = [random.choice([None, *VALUES]) for _ in range(random.randint(1, 2))] + [
        random.choice(list(VALUES))
    ]
    left = [factor(random, kind, 1) for kind in kinds]
    right = [factor(random, kind, -1) for kind in reversed(kinds)]
    if seed % 2:
        place = random.randrange(len(right))
        right[place] = factor(random, kinds[::-1][place], 1)
        right = random.sample(right, len(right))
    product = [
        np.linalg.multi_dot([value for _, value in side]) if len(side) > 1 else side[0][1]
        for side in (left, right)
    ]
    truth = np.allclose(np.linalg.inv(product[0]), product[1], atol=1e-9)
    formula = (
        f"\\left({' '.join(text for text, _ in left)}\\right)^{{-1}} = {' '.join(text for text, _ in right)}"
    )
    assert check(formula, SYMBOLS).outcome == (Outcome.PROVED if truth else Outcome.REFUTED), formula


def test_engines_that_invert_differently_stop(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        polynomial_engine, "inverted", lambda term, known, _: inverted(term, known, lambda x: x)
    )
    with pytest.raises((EngineDisagreement, AssertionError)):
        assert check(r"(e^{\tilde{x}})^{-1} = e^{-\tilde{x}}", SYMBOLS).holds
