"""Paths of SciPy's splines and through waypoints, with exact derivatives between the knots."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.robot.structure import reals
from workbench.kinematics.robot.trajectories.sampled_path import SampledPath


class SplinePath(SampledPath):
    """A path of a SciPy spline (`PPoly`, `CubicSpline`, `BPoly`, `BSpline`, `UnivariateSpline`, ...) of the
    vector of positions.

    breaks: the inner knots in s, at which derivatives may jump. Derivatives beyond the degree are 0.
    """

    def __init__(self, spline: Any) -> None:
        """spline: of one variable, t in s, and a vector of positions, in rad or m, or one position as a
        number. Raises ValueError."""
        self.spline = spline
        if hasattr(spline, "x"):
            knots, self._degree = np.asarray(spline.x, dtype=float), len(spline.c) - 1
        elif hasattr(spline, "t") and hasattr(spline, "k"):
            self._degree = int(spline.k)
            knots = np.unique(spline.t[self._degree : len(spline.t) - self._degree])
        elif hasattr(spline, "get_knots"):  # a UnivariateSpline has no attribute for its degree
            knots, self._degree = np.asarray(spline.get_knots(), dtype=float), _degree(spline)
        else:
            raise ValueError(
                f"trajectory: expected a spline with knots, such as CubicSpline, got {type(spline).__name__}"
            )
        self.start, self.end, self.breaks = float(knots[0]), float(knots[-1]), knots[1:-1]
        shape = np.shape(spline(self.start))
        if len(shape) > 1:
            raise ValueError(f"trajectory: expected a spline of a vector of positions, got the shape {shape}")
        self.joints = shape[0] if shape else 1
        self._derivatives = {0: spline}

    def derivatives(self, t: ArrayLike, order: int) -> np.ndarray:
        t = self._inside(t)
        values = np.zeros((order + 1, *t.shape, self.joints))
        for k in range(min(order, self._degree) + 1):
            if k not in self._derivatives:
                self._derivatives[k] = self.spline.derivative(k)
            values[k] = np.reshape(self._derivatives[k](t), values[k].shape)
        return values


def _degree(spline: Any) -> int:
    """Returns how often a spline has a derivative."""
    degree = 0
    while True:
        try:
            spline.derivative(degree + 1)
        except ValueError:
            return degree
        degree += 1


def waypoints(
    t: ArrayLike, q: ArrayLike, v: ArrayLike | None = None, a: ArrayLike | None = None
) -> SplinePath:
    """Returns the path through positions q (points, joints) at increasing times t (points,) in s, of least
    degree.

    v, a (points, joints): velocities and accelerations there: with both the pieces are quintic, with v alone
    cubic. Without v it is the cubic spline that starts and ends at rest; its acceleration is continuous.
    Raises ValueError for other shapes, or for a without v.

    >>> path = waypoints([0.0, 1.0], [[0.0], [1.0]])
    >>> path.derivatives(0.5, 1).tolist()  # halfway: position and rate
    [[0.5], [1.5]]
    """
    from scipy.interpolate import BPoly, CubicSpline

    t, q = reals(t, "t"), reals(q, "q")
    if t.ndim != 1 or q.ndim != 2 or len(t) != len(q) or len(t) < 2:
        raise ValueError(
            "t and q: expected shapes (points,) and (points, joints) of two points at least, "
            f"got {t.shape} and {q.shape}"
        )
    if not (np.diff(t) > 0).all():
        raise ValueError("t: expected increasing times")
    if v is None:
        if a is not None:
            raise ValueError("a: expected v with it, got accelerations alone")
        return SplinePath(CubicSpline(t, q, bc_type="clamped"))
    given = [q, reals(v, "v")] + ([] if a is None else [reals(a, "a")])
    for name, values in zip("va", given[1:], strict=False):
        if values.shape != q.shape:
            raise ValueError(f"{name}: expected the shape {q.shape} of q, got {values.shape}")
    return SplinePath(BPoly.from_derivatives(t, np.stack(given, axis=1)))
