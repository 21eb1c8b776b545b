"""Polynomial joint paths: the one input of every reference motion."""

from __future__ import annotations

from collections.abc import Sequence
from math import comb, factorial

import numpy as np


class JointPath:
    """A joint path q(t) = Σ_k c_k t^k, polynomial in time, with exact derivatives.

    ``coefficients`` has shape (degree + 1, number of joints): row k holds c_k, so that
    c_k = q^(k)(0) / k! are the Taylor coefficients of the path at t = 0. Units: radians or
    metres per second^k.

    Raises ValueError when the coefficients are not a finite table of at least one row.
    """

    def __init__(self, coefficients: Sequence[Sequence[float]] | np.ndarray):
        table = np.array(coefficients, dtype=float)
        if table.ndim != 2 or table.shape[0] == 0:
            raise ValueError(
                "a joint path needs coefficients of shape (degree + 1, joints), "
                f"got shape {table.shape}"
            )
        if not np.all(np.isfinite(table)):
            raise ValueError("a joint path needs finite coefficients, got nan or infinity")
        table.setflags(write=False)
        self.coefficients = table

    @classmethod
    def from_derivatives(cls, derivatives: Sequence[Sequence[float]] | np.ndarray) -> JointPath:
        """The path whose k-th derivative at t = 0 is ``derivatives[k]``, shape (joints,)."""
        rows = np.array(derivatives, dtype=float)
        if rows.ndim != 2:
            raise ValueError(
                f"derivatives need shape (orders, joints), got shape {rows.shape}"
            )
        return cls(rows / np.array([[factorial(k)] for k in range(len(rows))], dtype=float))

    @property
    def joints(self) -> int:
        return self.coefficients.shape[1]

    @property
    def degree(self) -> int:
        return self.coefficients.shape[0] - 1

    def __call__(self, t, order: int = 0):
        """The derivative of the given order at time ``t``, shape (joints,).

        ``t`` may be a float or any scalar with + and * (a Drake Expression, say).
        """
        if order < 0:
            raise ValueError(f"the order of a derivative is 0, 1, 2 ..., got {order}")
        value = np.zeros(self.joints) * t
        for k in range(self.degree, order - 1, -1):
            falling = factorial(k) // factorial(k - order)
            value = value * t + falling * self.coefficients[k]
        return value

    def jet(self, t: float, order: int) -> np.ndarray:
        """q, q', ..., q^(order) at time ``t``, shape (order + 1, joints)."""
        return np.array([self(t, k) for k in range(order + 1)])

    def shifted(self, t: float) -> JointPath:
        """The same path with the clock restarted at ``t``: s ↦ q(t + s)."""
        powers = range(self.degree + 1)
        shift = np.array(
            [[comb(k, j) * t ** (k - j) if k >= j else 0.0 for k in powers] for j in powers]
        )
        return JointPath(shift @ self.coefficients)
