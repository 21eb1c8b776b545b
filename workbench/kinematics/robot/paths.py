"""Trajectories in: what a robot can be moved along.

`workbench.drake.joint_paths` has the paths by formula: `JointPath` (coefficients), `SinePath`. Here are those
by samples (`SplinePath`, from arrays or a CSV file) and by Drake's Trajectory objects (`DrakePath`). Times
in s, coordinates in rad and m; derivatives have the order first, (order + 1, ..., joints).
"""

from __future__ import annotations

import csv
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path as FilePath
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from workbench.drake.joint_paths import JointPath, LinearPath, Path, SinePath
from workbench.kinematics.robot.structure import reals

__all__ = [
    "DrakePath",
    "JointPath",
    "LinearPath",
    "Path",
    "SinePath",
    "SplinePath",
    "as_path",
    "read_samples",
]

SPLINE_DEGREE = 7  # four continuous derivatives beyond the acceleration's two: snap is smooth
MOST_COEFFICIENTS = 160
SCALE_SAMPLES = 257  # at which a path is looked at for the size of its derivatives


class SampledPath(Path):
    """A path whose terms are not known: the size of a derivative's terms is its largest value on the path."""

    def magnitudes(self, t, order: int) -> np.ndarray:
        sizes = self._sizes(order).reshape(order + 1, *[1] * np.ndim(t), self.joints)
        return np.broadcast_to(sizes, (order + 1, *np.shape(t), self.joints))

    def _sizes(self, order: int) -> np.ndarray:
        if order not in self._size_of_order:
            times = np.linspace(self.start, self.end, SCALE_SAMPLES)
            self._size_of_order[order] = np.abs(self.derivatives(times, order)).max(axis=1)
        return self._size_of_order[order]

    @cached_property
    def _size_of_order(self) -> dict[int, np.ndarray]:
        return {}

    def _inside(self, t) -> np.ndarray:
        t = np.asarray(t, dtype=float)
        slack = 1e-9 * max(1.0, abs(self.start), abs(self.end))
        if not np.all((t >= self.start - slack) & (t <= self.end + slack)):
            raise ValueError(
                f"times: expected times from {self.start:g} to {self.end:g} s, got {t.min()} to {t.max()}"
            )
        return np.clip(t, self.start, self.end)


class DrakePath(SampledPath):
    """A path of a `pydrake.trajectories.Trajectory` whose value is the vector of the robot's positions."""

    def __init__(self, trajectory: Any):
        try:
            columns = trajectory.cols()
        except RuntimeError as error:
            raise ValueError(f"trajectory: {error}") from None
        if columns != 1:
            raise ValueError(f"trajectory: expected a vector of positions, got {columns} columns")
        if not trajectory.has_derivative():
            raise ValueError("trajectory: expected one that has derivatives")
        self.trajectory, self.joints = trajectory, trajectory.rows()
        self.start, self.end = trajectory.start_time(), trajectory.end_time()

    def derivatives(self, t, order: int) -> np.ndarray:
        t = self._inside(t)
        trajectory = self.trajectory
        values = [trajectory.vector_values(t.ravel()).T.reshape(*t.shape, self.joints)]
        for k in range(1, order + 1):
            rows = [trajectory.EvalDerivative(float(s), k).ravel() for s in t.ravel()]
            values.append(np.reshape(rows, (*t.shape, self.joints)))
        return np.stack(values)

    @property
    def breaks(self) -> np.ndarray:
        """Where derivatives may jump."""
        inner = getattr(self.trajectory, "get_segment_times", lambda: [])()
        return np.asarray([t for t in inner if self.start < t < self.end], dtype=float)


class SplinePath(SampledPath):
    """A smoothing spline of degree 7 through samples, with the error of each of its derivatives.

    Among all functions it weighs the squared misfit against ∫ (q'''')² dt; how much the one counts beside the
    other is chosen for each coordinate by generalized cross-validation. `residual` (joints,) is the standard
    deviation of the samples from it, `error` that of each derivative.
    """

    def __init__(self, t: ArrayLike, q: ArrayLike, smoothing: float | None = None):
        """t (samples,) increasing, in s; q (samples, joints). smoothing: 0 interpolates as far as the knots
        allow; chosen by cross-validation unless given. Raises ValueError for bad samples."""
        from scipy.interpolate import BSpline

        t, q = _samples(t, q)
        if smoothing is not None and not 0 <= smoothing < np.inf:
            raise ValueError(f"smoothing: expected a finite number >= 0, got {smoothing}")
        self.start, self.end, self.joints = t[0], t[-1], q.shape[1]
        coefficients = min(len(t), len(t) // 3 + SPLINE_DEGREE + 1, MOST_COEFFICIENTS)
        self._unit = (self.end - self.start) / (coefficients - SPLINE_DEGREE)
        inner = np.quantile(t, np.linspace(0, 1, coefficients - SPLINE_DEGREE + 1))[1:-1]
        ends = np.repeat([[self.start], [self.end]], SPLINE_DEGREE + 1, axis=1)
        self._knots = np.concatenate([ends[0], inner, ends[1]])
        self._basis = BSpline(self._knots, np.eye(coefficients), SPLINE_DEGREE)
        fits = [_Fit(self._basis(t), self._roughness(), column, smoothing) for column in q.T]
        self._spline = BSpline(
            self._knots, np.stack([fit.coefficients for fit in fits], axis=1), SPLINE_DEGREE
        )
        self._covariances = [fit.covariance for fit in fits]
        self.residual = np.array([fit.residual for fit in fits])
        self.breaks = np.array([])

    def _roughness(self) -> np.ndarray:
        """The matrix of ∫ (q'''')² dt, in the unit of the knots' distance, by Gauss's rule (exact)."""
        nodes, weights = np.polynomial.legendre.leggauss(SPLINE_DEGREE - 3)
        edges = np.unique(self._knots)
        half = np.diff(edges)[:, None] / 2
        at = (edges[:-1, None] + half * (1 + nodes)).ravel()
        rows = self._basis.derivative(4)(at) * self._unit**4
        return rows.T @ (rows * (half * weights / self._unit).ravel()[:, None])

    def derivatives(self, t, order: int) -> np.ndarray:
        t = self._inside(t)
        return np.stack([self._of(self._spline, k)(t) for k in range(order + 1)])

    @staticmethod
    def _of(spline, k: int):
        """Its k-th derivative; one beyond the degree is zero."""
        return (
            spline.derivative(k)
            if k <= SPLINE_DEGREE
            else lambda t: np.zeros((*t.shape, *spline.c.shape[1:]))
        )

    def error(self, t, order: int) -> np.ndarray:
        """The standard error of each derivative, (order + 1, ..., joints): of the noise that the samples
        have, and of what smoothing takes away (the posterior deviation of the smoothing spline)."""
        t = self._inside(t)
        found = []
        for k in range(order + 1):
            rows = self._of(self._basis, k)(t)
            variances = [np.einsum("...i,ij,...j->...", rows, C, rows) for C in self._covariances]
            found.append(np.sqrt(np.maximum(np.stack(variances, axis=-1), 0)))
        return np.stack(found)

    def taylor(self, t: float, degree: int | None = None) -> JointPath:
        """The polynomial piece at ``t``, its clock restarted there."""
        return super().taylor(t, SPLINE_DEGREE if degree is None else min(degree, SPLINE_DEGREE))


class _Fit:
    """One coordinate's penalized least squares, (BᵀB + λ P) c = Bᵀ q."""

    def __init__(self, B: np.ndarray, P: np.ndarray, q: np.ndarray, smoothing: float | None):
        from scipy.linalg import eigh

        N = B.T @ B
        P = P * (np.trace(N) / np.trace(P))
        data, V = eigh(N, N + P)  # Vᵀ (N + P) V = I, Vᵀ N V = diag(data)
        data = np.clip(data, 1e-15, 1)
        projected = V.T @ (B.T @ q)

        def misfit(weight: float) -> tuple[float, float]:
            gain = 1 / (data + weight * (1 - data))
            residual = q - B @ (V @ (gain * projected))
            return float(residual @ residual), float((gain * data).sum())

        def score(weight: float) -> float:
            square, freedom = misfit(weight)
            left = len(q) - freedom
            return square * len(q) / left**2 if left > 0.5 else np.inf

        weights = np.logspace(-20, 12, 129)
        weight = min(weights, key=score) if smoothing is None else float(smoothing)
        if smoothing is None and not np.isfinite(score(weight)):
            weight = weights[0]
        square, freedom = misfit(weight)
        gain = 1 / (data + weight * (1 - data))
        variance = square / max(len(q) - freedom, 1.0)
        self.coefficients = V @ (gain * projected)
        self.covariance = variance * (V * gain) @ V.T
        self.residual = float(np.sqrt(variance))


def _samples(t: ArrayLike, q: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    t, q = reals(t, "t"), reals(q, "q")
    if t.ndim != 1 or q.ndim != 2 or len(q) != len(t):
        raise ValueError(
            f"t and q: expected shapes (samples,) and (samples, joints), got {t.shape} and {q.shape}"
        )
    least = SPLINE_DEGREE + 3
    if len(t) < least:
        raise ValueError(f"t: expected at least {least} samples, got {len(t)}")
    if not (np.diff(t) > 0).all():
        first = int(np.flatnonzero(np.diff(t) <= 0)[0])
        raise ValueError(f"t: expected increasing times, got {t[first]:g} s before {t[first + 1]:g} s")
    return t, q


def read_samples(file: str | FilePath, positions: Sequence[str]) -> tuple[np.ndarray, np.ndarray]:
    """(t, q) of a CSV file: a header `t` and names of coordinates, then a row a time; others stay at 0.

    Without a header the columns are t and then all the positions. Raises ValueError with the line.
    """
    try:
        with open(file, newline="", encoding="utf-8-sig") as text:
            rows = [
                (number, row)
                for number, row in enumerate(csv.reader(text), start=1)
                if any(map(str.strip, row))
            ]
    except (OSError, UnicodeDecodeError) as error:
        raise ValueError(f"{file}: cannot be read: {error}") from None
    if not rows:
        raise ValueError(f"{file}: expected a CSV file with rows, got none")
    names = [name.strip() for name in rows[0][1]]
    if _is_number(names[0]):
        names = ["t", *positions]
    else:
        rows = rows[1:]
    if names[0] not in ("t", "time"):
        raise ValueError(f"{file}: expected the first column to be t, got {names[0]!r}")
    for name in names[1:]:
        if name not in positions:
            raise ValueError(f"{file}: unknown joint {name!r}: expected one of {', '.join(positions)}")
        if names.count(name) > 1:
            raise ValueError(f"{file}: joint {name!r} is there twice: expected one column of each")
    for number, row in rows:
        if len(row) != len(names) or not all(map(_is_number, row)):
            raise ValueError(f"{file}, line {number}: expected {len(names)} numbers, got {','.join(row)!r}")
    table = np.array([[float(x) for x in row] for _, row in rows]).reshape(len(rows), len(names))
    q = np.zeros((len(rows), len(positions)))
    for column, name in zip(table.T[1:], names[1:], strict=True):
        q[:, list(positions).index(name)] = column
    return table[:, 0], q


def _is_number(text: str) -> bool:
    try:
        return bool(np.isfinite(float(text)))
    except ValueError:
        return False


def as_path(trajectory: Any, joints: int) -> Path:
    """A `Path`, a Drake Trajectory, or samples (t, q), as a path of so many coordinates. Raises
    ValueError."""
    if isinstance(trajectory, Path):
        path = trajectory
    elif hasattr(trajectory, "EvalDerivative"):
        path = DrakePath(trajectory)
    elif isinstance(trajectory, tuple) and len(trajectory) == 2:
        path = SplinePath(*trajectory)
    else:
        raise ValueError(
            f"trajectory: expected a Path, a Drake Trajectory or (t, q), got {type(trajectory).__name__}"
        )
    if path.joints != joints:
        raise ValueError(f"trajectory: expected {joints} coordinates, got {path.joints}")
    return path
