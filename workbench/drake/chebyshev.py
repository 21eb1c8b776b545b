"""Spectral differentiation in time of a function known by values only, with its error.

The function is sampled at Chebyshev nodes of a window around the instant, expanded in Chebyshev
polynomials, and the expansion is differentiated. Two errors compete: a wide window leaves the
function unresolved, a narrow one divides the rounding of the samples by its width. Both show in
the tail of the coefficients, which has decayed to the level of the rounding in a good window.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.polynomial import chebyshev

NODES = 64
EPSILON = np.finfo(float).eps


@dataclass(frozen=True)
class Derivative:
    """A derivative, shape as the function's values, and the bound estimated on its entries."""

    value: np.ndarray
    error: float


@lru_cache(maxsize=1)
def _nodes_and_transform() -> tuple[np.ndarray, np.ndarray]:
    """Returns the nodes cos θⱼ, and the matrix from values at them to Chebyshev coefficients."""
    angles = np.pi * (np.arange(NODES) + 0.5) / NODES
    transform = 2 / NODES * np.cos(np.outer(np.arange(NODES), angles))
    transform[0] /= 2
    return np.cos(angles), transform


@lru_cache(maxsize=32)
def _derivatives_at_middle(order: int) -> np.ndarray:
    """Returns T_k^(order)(0) for k = 0 .. NODES - 1."""
    differentiated = chebyshev.chebder(np.eye(NODES), order)
    return np.asarray(chebyshev.chebval(0.0, differentiated))


def derivatives(
    function: Callable[[float], np.ndarray], half_widths: Sequence[float], highest: int
) -> list[Derivative]:
    """Returns the derivatives 1 .. ``highest`` at 0 of a smooth function with values of shape (n,).

    Every half-width is tried. For each order the one with the least estimated error is used; the stated error
    is that estimate plus the difference from the next best one. At least two different half-widths are
    needed.
    """
    if len(set(half_widths)) < 2:
        raise ValueError("two different half-widths are needed to estimate an error")
    windows = [_Window(function, half_width) for half_width in half_widths]
    found = []
    for order in range(1, highest + 1):
        best, second, *_ = sorted((w.derivative(order) for w in windows), key=lambda d: d.error)
        disagreement = float(np.max(np.abs(best.value - second.value)))
        found.append(Derivative(best.value, best.error + disagreement))
    return found


class _Window:
    def __init__(self, function: Callable[[float], np.ndarray], half_width: float):
        nodes, transform = _nodes_and_transform()
        values = np.array([function(half_width * node) for node in nodes])
        coefficients = transform @ values
        tail = np.max(np.abs(coefficients[-NODES // 4 :]))
        self._noise = 3 * max(tail, EPSILON * np.max(np.abs(values)))
        above_noise = np.flatnonzero(np.max(np.abs(coefficients), axis=1) > self._noise)
        self._kept = int(above_noise[-1]) + 1 if above_noise.size else 0
        self._coefficients = coefficients
        self._half_width = half_width

    def derivative(self, order: int) -> Derivative:
        weights = _derivatives_at_middle(order) / self._half_width**order
        kept = weights[: self._kept]
        dropped = np.abs(weights[self._kept : self._kept + 4])
        error = self._noise * float(np.sum(np.abs(kept)) + np.sum(dropped))
        return Derivative(kept @ self._coefficients[: self._kept], error)
