"""Joint paths q(t) with their derivatives to any order: the input of every reference motion."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from math import comb, factorial

import numpy as np

TAYLOR_DEGREE = 16  # of the polynomial that approximates other paths over short times


class Path(ABC):
    """A path q(t) of `joints` coordinates, in radians and metres, from `start` to `end` in seconds.

    Derivatives at times of any shape (...) have shape (order + 1, ..., joints), the order first.
    """

    joints: int
    start: float = -np.inf
    end: float = np.inf

    @abstractmethod
    def derivatives(self, t, order: int) -> np.ndarray:
        """Returns q, q', ..., q^(order) at the times t (...): (order + 1, ..., joints)."""

    @abstractmethod
    def magnitudes(self, t, order: int) -> np.ndarray:
        """Returns the sizes of the terms that the derivatives are summed from, same shape.

        Rounding errors are relative to these sizes, not to the sum, which may be smaller by cancellation.
        """

    def jet(self, t: float, order: int) -> np.ndarray:
        """Returns q, q', ..., q^(order) at time ``t``, shape (order + 1, joints)."""
        return self.derivatives(float(t), order)

    def taylor(self, t: float, degree: int | None = None) -> JointPath:
        """Returns the Taylor polynomial at ``t``, with time starting there: s ↦ q(t + s) for small s."""
        return JointPath.from_derivatives(self.jet(t, TAYLOR_DEGREE if degree is None else degree))

    def shifted(self, t: float) -> Path:
        """Returns the same path with time starting at ``t``: s ↦ q(t + s)."""
        return ShiftedPath(self, t)


class JointPath(Path):
    """A joint path q(t) = Σ_k c_k t^k, polynomial in time, with exact derivatives.

    ``coefficients`` has shape (degree + 1, number of joints): row k holds c_k, so that c_k = q^(k)(0) / k!
    are the Taylor coefficients of the path at t = 0. Units: radians or metres per second^k.

    Raises ValueError if the coefficients are not a finite table of at least one row.
    """

    def __init__(self, coefficients: Sequence[Sequence[float]] | np.ndarray):
        table = np.array(coefficients, dtype=float)
        if table.ndim != 2 or table.shape[0] == 0:
            raise ValueError(
                f"a joint path needs coefficients of shape (degree + 1, joints), got shape {table.shape}"
            )
        if not np.all(np.isfinite(table)):
            raise ValueError("a joint path needs finite coefficients, got nan or infinity")
        table.setflags(write=False)
        self.coefficients = table
        self.joints = table.shape[1]

    @classmethod
    def from_derivatives(cls, derivatives: Sequence[Sequence[float]] | np.ndarray) -> JointPath:
        """Returns the path whose k-th derivative at t = 0 is ``derivatives[k]``, shape (joints,)."""
        rows = np.array(derivatives, dtype=float)
        if rows.ndim != 2:
            raise ValueError(f"derivatives need shape (orders, joints), got shape {rows.shape}")
        return cls(rows / np.array([[factorial(k)] for k in range(len(rows))], dtype=float))

    @property
    def degree(self) -> int:
        return self.coefficients.shape[0] - 1

    def __call__(self, t, order: int = 0):
        """Returns the derivative of the given order at time ``t``, shape (joints,).

        ``t`` may be a float or any scalar with + and * (such as a Drake Expression).
        """
        if order < 0:
            raise ValueError(f"the order of a derivative is 0, 1, 2 ..., got {order}")
        return self._summed(self.coefficients, t, np.zeros(self.joints) * t, order)

    def derivatives(self, t, order: int) -> np.ndarray:
        return self._all(self.coefficients, np.asarray(t, dtype=float), order)

    def magnitudes(self, t, order: int) -> np.ndarray:
        return self._all(np.abs(self.coefficients), np.abs(np.asarray(t, dtype=float)), order)

    def _all(self, coefficients: np.ndarray, t: np.ndarray, order: int) -> np.ndarray:
        zero = np.zeros((*t.shape, self.joints))
        return np.array([self._summed(coefficients, t[..., None], zero, k) for k in range(order + 1)])

    def _summed(self, coefficients: np.ndarray, t, zero, order: int):
        value = zero
        for k in range(self.degree, order - 1, -1):
            falling = factorial(k) // factorial(k - order)
            value = value * t + falling * coefficients[k]
        return value

    def taylor(self, t: float, degree: int | None = None) -> JointPath:
        """Returns the same polynomial, up to the given degree, with time starting at ``t``."""
        powers = range(self.degree + 1)
        shift = np.array([[comb(k, j) * t ** (k - j) if k >= j else 0.0 for k in powers] for j in powers])
        return JointPath((shift @ self.coefficients)[: None if degree is None else degree + 1])

    def shifted(self, t: float) -> JointPath:
        return self.taylor(t)


class ShiftedPath(Path):
    """The path s ↦ q(t + s) of another path, computed from that path's own terms."""

    def __init__(self, path: Path, t: float):
        self.path, self.t = path, t
        self.joints, self.start, self.end = path.joints, path.start - t, path.end - t

    def derivatives(self, t, order: int) -> np.ndarray:
        return self.path.derivatives(self.t + np.asarray(t, dtype=float), order)

    def magnitudes(self, t, order: int) -> np.ndarray:
        return self.path.magnitudes(self.t + np.asarray(t, dtype=float), order)

    def taylor(self, t: float, degree: int | None = None) -> JointPath:
        return self.path.taylor(self.t + t, degree)


class SinePath(Path):
    """The path qᵢ(t) = sin(t + i) / 2 for i = 1, 2, …: all derivatives of every joint are nonzero."""

    def __init__(self, joints: int):
        self.joints = joints

    def derivatives(self, t, order: int) -> np.ndarray:
        k = np.arange(order + 1).reshape(-1, *[1] * (np.ndim(t) + 1))
        return np.sin(np.asarray(t)[..., None] + np.arange(1, self.joints + 1) + k * np.pi / 2) / 2

    def magnitudes(self, t, order: int) -> np.ndarray:
        shape = (order + 1, *np.shape(t), self.joints)
        return np.broadcast_to((1 + np.abs(np.asarray(t)))[..., None], shape[1:]) + np.zeros(shape)


class LinearPath(Path):
    """The path M q(t) + c of another path, for dependent joints and other orders of joints."""

    def __init__(self, path: Path, matrix: np.ndarray, offset: np.ndarray):
        """matrix (joints, path.joints), offset (joints,)"""
        self.path, self.matrix, self.offset = path, np.asarray(matrix, float), np.asarray(offset, float)
        self.joints, self.start, self.end = len(self.matrix), path.start, path.end

    def derivatives(self, t, order: int) -> np.ndarray:
        values = self.path.derivatives(t, order) @ self.matrix.T
        values[0] += self.offset
        return values

    def magnitudes(self, t, order: int) -> np.ndarray:
        values = self.path.magnitudes(t, order) @ np.abs(self.matrix).T
        values[0] += np.abs(self.offset)
        return values

    def taylor(self, t: float, degree: int | None = None) -> JointPath:
        table = self.path.taylor(t, degree).coefficients @ self.matrix.T
        table[0] += self.offset
        return JointPath(table)
