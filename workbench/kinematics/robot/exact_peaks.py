"""Peaks along a path whose derivatives are exact: looked for on a grid, then refined to the last digits.

A peak is refined in brackets of the grid and closed by the maximum of a polynomial through the last one.
Where a derivative jumps at a break of the path, the next ones have no bound.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.robot.peaks import Asked, Peak, peak_at, point_of
from workbench.kinematics.robot.recorded_peaks import jump_reason
from workbench.kinematics.robot.recordings import Break

if TYPE_CHECKING:
    from workbench.kinematics.robot.states import States

SAMPLES = 401  # at least, over all of the time
PER_PIECE = 17  # between two breaks
MOST_PIECES = 4000  # that are looked at so closely
REFINED = 33  # points in a bracket
CANDIDATES = 4  # brackets a quantity
CLOSING_DEGREE = 6
JUMP = 1e-8  # of a derivative's largest size: a change at a break that counts


class Curves(NamedTuple):
    """What peaks are sought of, at times: rates (N, ..., velocities), point (N + 1, ..., 3) or None, q."""

    q: np.ndarray
    rates: np.ndarray
    point: np.ndarray | None


def exact_peaks(
    motion: States, body: str | None, point: ArrayLike, relative_to: str | None, asked: list[Asked]
) -> list[Peak]:
    """The peaks on the times from the motion's first to its last."""

    def curves_at(times: np.ndarray) -> Curves:
        there = motion.at(times)
        of_point = None if body is None else point_of(there, body, point, relative_to).derivatives
        return Curves(there.q, there.rates, of_point)

    start, end = float(motion.times.min()), float(motion.times.max())
    breaks = np.asarray(getattr(motion.path, "breaks", ()), dtype=float)
    breaks = breaks[(breaks > start) & (breaks < end)]
    near = 1e-9 * (end - start) + 4 * np.spacing(max(abs(start), abs(end)))
    times = _grid(start, end, breaks, near, motion.times.ravel())
    curves = curves_at(times)
    values = _sizes(curves, asked)
    best, best_time = _refined(values, times, lambda inside: _sizes(curves_at(inside), asked))
    jumps = _jumps(curves, curves_at, breaks, near, asked) if len(breaks) else [[] for _ in asked]
    found = []
    for one, value, time, at in zip(asked, best.tolist(), best_time.tolist(), jumps, strict=True):
        if at:
            options = {"at_least": np.inf, "at_most": np.inf, "reason": jump_reason(at)}
            found.append(peak_at(one, np.inf, at[0].time, **options))
        else:
            found.append(peak_at(one, value, time))
    return found


def _grid(start: float, end: float, breaks: np.ndarray, near: float, asked: np.ndarray) -> np.ndarray:
    """Times that see every piece between two breaks, and both sides of each break."""
    edges = np.concatenate([[start], breaks, [end]])
    share = np.linspace(0, 1, PER_PIECE if len(edges) < MOST_PIECES else 3)
    inside = (edges[:-1, None] + np.diff(edges)[:, None] * share).ravel()
    sides = np.concatenate([breaks - near, breaks, breaks + near])
    times = np.concatenate([np.linspace(start, end, SAMPLES), inside, sides, asked])
    return np.unique(times[(times >= start) & (times <= end)])


def _sizes(curves: Curves, asked: list[Asked]) -> np.ndarray:
    """(asked, ...): what is largest where the peaks are."""
    return np.array([_size(curves, one) for one in asked])


def _size(curves: Curves, one: Asked) -> np.ndarray:
    if one.of == "point" and one.velocity is None:
        return np.linalg.norm(curves.point[one.order], axis=-1)
    if one.order == 0:
        q = one.factor * curves.q[..., one.position] + one.offset
        return -q if one.bound == "lower" else q
    rate = one.factor * curves.rates[one.order - 1][..., one.velocity]
    if one.bound == "deceleration":
        return np.where(rate * one.factor * curves.rates[0][..., one.velocity] < 0, np.abs(rate), 0.0)
    return np.abs(rate)


def _refined(
    values: np.ndarray, times: np.ndarray, sizes_at: Callable[[np.ndarray], np.ndarray]
) -> tuple[np.ndarray, np.ndarray]:
    """(value, time) of each quantity's maximum: from its highest local maxima on the grid into their
    brackets."""
    rows = np.arange(len(values))
    padded = np.pad(values, ((0, 0), (1, 1)), constant_values=-np.inf)
    is_top = (padded[:, 1:-1] >= padded[:, :-2]) & (padded[:, 1:-1] >= padded[:, 2:])
    order = np.argsort(np.where(is_top, values, -np.inf), axis=1)[:, ::-1][:, :CANDIDATES]
    best, best_time = values[rows, order[:, 0]], times[order[:, 0]]
    for at in order.T:
        lows, highs = times[np.maximum(at - 1, 0)], times[np.minimum(at + 1, len(times) - 1)]
        for closing in (False, True):
            inside = np.linspace(lows, highs, REFINED, axis=1)
            own = sizes_at(inside)[rows, rows]
            top = np.argmax(own, axis=1)
            best, best_time = _better(best, best_time, own[rows, top], inside[rows, top])
            if closing:
                near = np.stack([_closing_time(t, f) for t, f in zip(inside, own, strict=True)])[:, None]
                best, best_time = _better(best, best_time, sizes_at(near)[rows, rows, 0], near[:, 0], 4e-15)
            lows = inside[rows, np.maximum(top - 1, 0)]
            highs = inside[rows, np.minimum(top + 1, REFINED - 1)]
    return best, best_time


def _better(
    best: np.ndarray, best_time: np.ndarray, value: np.ndarray, time: np.ndarray, slack: float = 0.0
) -> tuple[np.ndarray, np.ndarray]:
    """The larger ones; within the slack, relative, which is the rounding, the time counts and the value
    stays."""
    moves = value > best - slack * np.abs(best) if slack else value > best
    return np.where(moves, np.maximum(value, best), best), np.where(moves, time, best_time)


def _closing_time(times: np.ndarray, sizes: np.ndarray) -> float:
    """Where the least-squares polynomial through a bracket is largest, in s."""
    centre, half = (times[0] + times[-1]) / 2, max((times[-1] - times[0]) / 2, 1e-300)
    u = (times - centre) / half
    fit = np.polynomial.chebyshev.Chebyshev.fit(u, sizes, CLOSING_DEGREE, domain=[-1, 1])
    roots = fit.deriv().roots()
    inside = roots.real[(np.abs(roots.imag) < 1e-6) & (np.abs(roots.real) <= 1)]
    candidates = np.concatenate([inside, u[[int(np.argmax(sizes))]]])
    return float(centre + half * candidates[int(np.argmax(fit(candidates)))])


def _jumps(
    curves: Curves,
    curves_at: Callable[[np.ndarray], Curves],
    breaks: np.ndarray,
    near: float,
    asked: list[Asked],
) -> list[list[Break]]:
    """Of each quantity the breaks at which a lower derivative jumps; curves: at all times of the grid."""
    sides = curves_at(np.stack([breaks - near, breaks + near]))
    found = []
    for one in asked:
        jumping = []
        for k in range(one.order):
            (f, slope), (all_f, _) = (_with_slope(which, one, k) for which in (sides, curves))
            change = np.linalg.norm(f[1] - f[0], axis=-1)
            expected = 4 * near * np.linalg.norm(slope, axis=-1).max(axis=0)
            jumps = change > expected + JUMP * np.linalg.norm(all_f, axis=-1).max()
            jumping += [Break(float(time), k, 0) for time in breaks[jumps]]
        found.append(jumping)
    return found


def _with_slope(curves: Curves, one: Asked, k: int) -> tuple[np.ndarray, np.ndarray]:
    """The k-th derivative of what was asked and its derivative, each (..., components)."""
    if one.of == "point" and one.velocity is None:
        return curves.point[k], curves.point[k + 1]
    own = one.velocity
    if k == 0:  # a ball's velocity is no rate of a coordinate: its quaternion is one that is continuous
        rate = curves.rates[0][..., own, None]
        return (rate * 0 if one.position is None else curves.q[..., one.position, None]), rate
    return curves.rates[k - 1][..., own, None], curves.rates[k][..., own, None]
