"""The times at which derivatives of a Drake trajectory may jump."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

INTERVALS = 400
BISECTIONS = 48
FOUND_ORDERS = 5  # derivatives 0, …, 4 are searched for breaks if the trajectory does not list them


def trajectory_breaks(trajectory: Any, derivatives: Callable[[np.ndarray, int], np.ndarray]) -> np.ndarray:
    """Returns the times in s, increasing, inside the trajectory, at which a derivative may jump.

    derivatives(t (samples,), order) → (order + 1, samples, positions) is asked where Drake does not tell the
    breaks of that kind of trajectory: there the jumps are found by bisection.
    """
    start, end = trajectory.start_time(), trajectory.end_time()
    told = _told(trajectory)
    times = _bisected(derivatives, start, end) if told is None else np.asarray(sorted(set(told)), dtype=float)
    return times[(times > start) & (times < end)]


def _told(trajectory: Any) -> list[float] | None:
    if hasattr(trajectory, "get_segment_times"):
        times = list(trajectory.get_segment_times())
        if not hasattr(trajectory, "segment"):
            return times
        parts = [_told(trajectory.segment(i)) for i in range(trajectory.get_number_of_segments())]
        known = [part for part in parts if part is not None]
        return None if len(known) < len(parts) else times + [t for part in known for t in part]
    if hasattr(trajectory, "basis"):  # a B-spline; a Bézier curve has a basis of polynomials
        basis = trajectory.basis
        return list(basis().knots()) if callable(basis) and hasattr(trajectory, "InsertKnots") else None
    return [] if type(trajectory).__name__.startswith("BezierCurve") else None


def _bisected(derivatives: Callable[[np.ndarray, int], np.ndarray], start: float, end: float) -> np.ndarray:
    """Returns the times of jumps: where a derivative changes over any short interval by more than its own
    derivative allows."""
    grid = np.linspace(start, end, INTERVALS + 1)
    values = derivatives(grid, FOUND_ORDERS)
    changes = np.diff(values[:-1], axis=1)
    expected = np.diff(grid)[:, None] * (values[1:, :-1] + values[1:, 1:]) / 2
    size = np.abs(values).max(axis=1, keepdims=True) + 1e-300
    odd = np.abs(changes - expected) > 0.3 * np.abs(changes) + 1e-9 * size[:-1]
    found = []
    for k, i, joint in zip(*np.nonzero(odd), strict=True):
        low, high = grid[i], grid[i + 1]
        for _ in range(BISECTIONS):
            middle = (low + high) / 2
            at = derivatives(np.array([low, middle, high]), k)[k, :, joint]
            low, high = (low, middle) if abs(at[1] - at[0]) > abs(at[2] - at[1]) else (middle, high)
        at = derivatives(np.array([low, high]), k)[k, :, joint]
        if abs(at[1] - at[0]) > 0.1 * abs(changes[k, i, joint]):
            found.append(high)
    return np.array(sorted(found)) if found else np.zeros(0)
