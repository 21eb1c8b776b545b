"""Paths of the trajectories that toppra and Ruckig compute, as splines whose derivatives are exact.

Neither library is imported: a trajectory is known by its attributes.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from workbench.kinematics.robot.trajectories.spline_paths import SplinePath

SHORTEST = 1e-12  # of the whole time: a phase that is left out


def planner_path(trajectory: Any) -> SplinePath | None:
    """Returns the path of a trajectory of toppra (`SplineInterpolator`, `ParametrizeConstAccel`,
    `ParametrizeSpline`) or Ruckig (`Trajectory`); None of any other object.

    Raises ValueError for an object of these libraries whose pieces are no polynomials of time.
    """
    if hasattr(trajectory, "at_time") and hasattr(trajectory, "profiles"):
        return _of_ruckig(trajectory)
    if hasattr(trajectory, "path_interval") and callable(trajectory):
        return _of_toppra(trajectory)
    return None


def _of_ruckig(trajectory: Any) -> SplinePath:
    """Returns the pieces of constant jerk: position, velocity and acceleration in the middle of each and the
    change of the acceleration over it."""
    from scipy.interpolate import PPoly

    edges = _ruckig_times(trajectory)
    middles, half = (edges[:-1] + edges[1:]) / 2, np.diff(edges) / 2
    p, v, a = (np.array(rows) for rows in zip(*map(_at_time(trajectory), middles), strict=True))
    before, after = (
        np.array([_at_time(trajectory)(t)[2] for t in middles + sign * half / 2]) for sign in (-1, 1)
    )
    j, h = (after - before) / half[:, None], half[:, None]
    at_start = [j / 6, (a - j * h) / 2, v - a * h + j * h**2 / 2, p - v * h + a * h**2 / 2 - j * h**3 / 6]
    return SplinePath(PPoly(np.stack(at_start), edges))


def _at_time(trajectory: Any) -> Any:
    """Returns position, velocity and acceleration at a time."""

    def evaluated(t: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        p, v, a = trajectory.at_time(float(t))[:3]
        return np.atleast_1d(p), np.atleast_1d(v), np.atleast_1d(a)

    return evaluated


def _ruckig_times(trajectory: Any) -> np.ndarray:
    """Returns the ends of all phases of all joints, increasing, from 0 to the end."""
    duration, times, start = float(trajectory.duration), [0.0], 0.0
    if not duration > 0:
        raise ValueError(f"trajectory: expected one of some duration, got {duration} s")
    ends = list(trajectory.intermediate_durations) or [duration]
    for section, end in zip(trajectory.profiles, ends, strict=True):
        for profile in section:
            brake = list(profile.brake.t) if profile.brake.duration else []
            times += (start + np.cumsum([*brake, *profile.t])).tolist()
        start = float(end)
        times.append(start)
    inside = np.unique(np.array([t for t in times if t < duration]))
    apart = np.append(True, np.diff(inside) > SHORTEST * duration)
    inside = inside[apart]
    return np.append(inside[inside < duration * (1 - SHORTEST)], duration)


def _of_toppra(trajectory: Any) -> SplinePath:
    if hasattr(trajectory, "cspl"):
        return SplinePath(trajectory.cspl)
    parts = [getattr(trajectory, f"_{name}", None) for name in ("ts", "ss", "velocities", "us", "path")]
    spline = getattr(parts[-1], "cspl", None)
    if any(part is None for part in parts) or not hasattr(spline, "c"):
        raise ValueError(
            "trajectory: expected toppra's SplineInterpolator, ParametrizeSpline, or ParametrizeConstAccel "
            f"of a SplineInterpolator, got {type(trajectory).__name__}"
        )
    return _composed(spline, *(np.asarray(part, dtype=float) for part in parts[:-1]))


def _composed(
    spline: Any, ts: np.ndarray, ss: np.ndarray, velocities: np.ndarray, us: np.ndarray
) -> SplinePath:
    """Returns q(s(t)) of a spline q(s) and s(t) = ss + velocities (t − ts) + us (t − ts)²/2 by pieces."""
    from scipy.interpolate import PPoly

    knots = spline.x[(spline.x > ss[0]) & (spline.x < ss[-1])]
    piece = np.clip(np.searchsorted(ss, knots, side="right") - 1, 0, len(us) - 1)
    ahead, v, u = knots - ss[piece], velocities[piece], us[piece]
    at_knots = ts[piece] + 2 * ahead / (v + np.sqrt(np.maximum(v * v + 2 * u * ahead, 0)))
    edges = np.unique(np.concatenate([ts, at_knots]))
    edges = edges[np.append(np.diff(edges) > SHORTEST * (ts[-1] - ts[0]), True)]
    piece = np.clip(np.searchsorted(ts, (edges[:-1] + edges[1:]) / 2) - 1, 0, len(us) - 1)
    late, u = edges[:-1] - ts[piece], us[piece]
    s, v = ss[piece] + velocities[piece] * late + u * late**2 / 2, velocities[piece] + u * late
    middle = (edges[1:] - edges[:-1]) / 2
    own = np.searchsorted(spline.x, s + v * middle + u * middle**2 / 2, side="right") - 1
    own = np.clip(own, 0, len(spline.x) - 2)
    shift, degree = s - spline.x[own], len(spline.c) - 1
    power, found = [np.ones((1, len(s)))], np.zeros((2 * degree + 1, len(s), *spline.c.shape[2:]))
    for _ in range(degree):  # of the s(t) − knot that the spline's piece is a polynomial of, ascending
        grown = np.zeros((len(power[-1]) + 2, len(s)))
        for k, factor in enumerate((shift, v, u / 2)):
            grown[k : k + len(power[-1])] += factor * power[-1]
        power.append(grown)
    for m, terms in enumerate(power):
        found[: len(terms)] += terms[..., None] * spline.c[degree - m, own]
    return SplinePath(PPoly(found[::-1], edges))
