"""Peaks along a path with exact derivatives: searched on a grid, then refined to the last digits.

A peak is refined in brackets of the grid, and finally by the maximum of a polynomial through the last
bracket. If a derivative jumps at a break of the path, the next ones have no bound.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.robot.peaks import (
    Asked,
    Peak,
    Violation,
    body_curves,
    peak_at,
    stretches,
    violation,
)
from workbench.kinematics.robot.recording.recorded_peaks import jump_reason
from workbench.kinematics.robot.recording.recordings import Break

if TYPE_CHECKING:
    from workbench.kinematics.robot.states import States

SAMPLES = 401  # at least, over all of the time
PER_PIECE = 17  # between two breaks
MOST_PIECES = 4000  # that are looked at so closely
REFINED = 33  # points in a bracket
CANDIDATES = 4  # brackets a quantity
CLOSING_DEGREE = 6
STOPS = 16  # starts and ends of decelerations that are looked at
JUMP = 1e-8  # of a derivative's largest size: a change at a break that counts


class Curves(NamedTuple):
    """The curves whose peaks are sought, at given times: q, rates (N, ..., velocities), and `body_curves`."""

    q: np.ndarray
    rates: np.ndarray
    of_body: dict[str, np.ndarray]


def exact_peaks(
    motion: States, body: str | None, point: ArrayLike, relative_to: str | None, asked: list[Asked]
) -> list[Peak]:
    """Returns the peaks on the times from the motion's first to its last."""
    search = _search(motion, body, point, relative_to, asked)
    found = []
    for one, value, time, rounding, at in zip(
        asked, search.best.tolist(), search.best_time.tolist(), search.rounding, search.jumps, strict=True
    ):
        if at:
            unbounded = peak_at(one, np.inf, at[0].time)
            found.append(replace(unbounded, at_least=np.inf, at_most=np.inf, reason=jump_reason(at)))
        else:
            found.append(peak_at(one, value, time, rounding=rounding))
    return found


def exact_violations(
    motion: States, body: str | None, point: ArrayLike, relative_to: str | None, asked: list[Asked]
) -> list[Violation]:
    """Returns the stretches beyond the limits, of the times from the motion's first to its last, and the
    jumps."""
    search = _search(motion, body, point, relative_to, asked)
    times = np.unique(np.concatenate([search.times, search.best_time]))
    sizes = _sizes(search.curves_at(times), asked)
    found = []
    for one, size, rounding, jumps in zip(asked, sizes, search.rounding, search.jumps, strict=True):
        found += [violation(one, jump.time, jump.time, np.inf, jump.time) for jump in jumps]

        def size_at(inside: np.ndarray, one: Asked = one) -> np.ndarray:
            return _size(search.curves_at(inside), one)

        for first, last in stretches(size > one.threshold + rounding):
            top = first + int(np.argmax(size[first : last + 1]))
            before, after = max(first - 1, 0), min(last + 1, len(times) - 1)
            start = _crossing(size_at, times[before], times[first], one.threshold)
            end = _crossing(size_at, times[after], times[last], one.threshold)
            bracket = times[max(top - 1, 0)], times[min(top + 1, len(times) - 1)]
            found.append(violation(one, start, end, *_top(size_at, *bracket)))
    return found


def _crossing(
    size_at: Callable[[np.ndarray], np.ndarray], outside: float, inside: float, limit: float
) -> float:
    """Returns the time nearest to `inside`, between both, from which on the size is beyond the limit."""
    while abs(inside - outside) > 4 * np.spacing(max(abs(inside), abs(outside))):
        times = np.linspace(inside, outside, REFINED)
        at = int(np.argmin(np.append(size_at(times)[1:] > limit, False)))  # the last one before it is not
        next_inside, next_outside = times[at], times[min(at + 1, REFINED - 1)]
        if (next_inside, next_outside) == (inside, outside):
            break
        inside, outside = next_inside, next_outside
    return float(inside)


def _top(size_at: Callable[[np.ndarray], np.ndarray], low: float, high: float) -> tuple[float, float]:
    """Returns the largest size in a bracket and its time."""
    for _ in range(6):
        times = np.linspace(low, high, REFINED)
        sizes = size_at(times)
        top = int(np.argmax(sizes))
        low, high = times[max(top - 1, 0)], times[min(top + 1, REFINED - 1)]
    return float(sizes[top]), float(times[top])


class Search(NamedTuple):
    """A search for peaks: the grid, the curves at any times, the peak of each quantity with its time, its
    rounding (see `Peak`), and the breaks at which it has no bound."""

    times: np.ndarray
    curves_at: Callable[[np.ndarray], Curves]
    best: np.ndarray
    best_time: np.ndarray
    rounding: list[float]
    jumps: list[list[Break]]


def _search(
    motion: States, body: str | None, point: ArrayLike, relative_to: str | None, asked: list[Asked]
) -> Search:
    def curves_at(times: np.ndarray) -> Curves:
        there = motion.at(times)
        return Curves(there.q, there.rates, body_curves(there, body, point, relative_to))

    start, end = float(motion.times.min()), float(motion.times.max())
    breaks = np.asarray(getattr(motion.path, "breaks", ()), dtype=float)
    breaks = breaks[(breaks > start) & (breaks < end)]
    near = 1e-9 * (end - start) + 4 * np.spacing(max(abs(start), abs(end)))
    times = _grid(start, end, breaks, near, motion.times.ravel())
    curves = curves_at(times)
    sizes = _sizes(curves, asked)
    rounding = [one.rounding(float(np.abs(size).max())) for one, size in zip(asked, sizes, strict=True)]
    best, best_time = _refined(sizes, times, lambda inside: _sizes(curves_at(inside), asked))
    for i, one in enumerate(asked):
        if one.bound == "deceleration":

            def size_at(inside: np.ndarray, one: Asked = one) -> np.ndarray:
                return _size(curves_at(inside), one)

            found = _at_stops(sizes[i], times, size_at)
            best[i], best_time[i] = max((best[i], best_time[i]), *found)
    jumps = _jumps(curves, curves_at, breaks, near, asked) if len(breaks) else [[] for _ in asked]
    return Search(times, curves_at, best, best_time, rounding, jumps)


def _at_stops(
    sizes: np.ndarray, times: np.ndarray, size_at: Callable[[np.ndarray], np.ndarray]
) -> list[tuple[float, float]]:
    """Returns (size, time) of a deceleration where it starts or ends, of the largest ones: it drops to 0
    where the velocity is 0."""
    edges = np.flatnonzero((sizes[:-1] > 0) != (sizes[1:] > 0))
    inside = edges + (sizes[edges] == 0)
    outside = 2 * edges + 1 - inside
    found = []
    for k in np.argsort(sizes[inside])[::-1][:STOPS]:
        time = _crossing(size_at, times[outside[k]], times[inside[k]], 0.0)
        found.append((float(size_at(np.array([time]))[0]), time))
    return found


def _grid(start: float, end: float, breaks: np.ndarray, near: float, asked: np.ndarray) -> np.ndarray:
    """Returns times that see every piece between two breaks, and both sides of each break; of times that only
    rounding tells apart one, so that the neighbours of each bracket a maximum."""
    edges = np.concatenate([[start], breaks, [end]])
    share = np.linspace(0, 1, PER_PIECE if len(edges) < MOST_PIECES else 3)
    inside = (edges[:-1, None] + np.diff(edges)[:, None] * share).ravel()
    sides = np.concatenate([breaks - near, breaks, breaks + near])
    times = np.concatenate([np.linspace(start, end, SAMPLES), inside, sides, asked])
    times = np.unique(times[(times >= start) & (times <= end)])
    return times[np.append(True, np.diff(times) > near / 2)]


def sizes_on(
    motion: States, body: str | None, point: ArrayLike, relative_to: str | None, asked: list[Asked]
) -> np.ndarray:
    """Returns the sizes (asked, ...) at the motion's own states of what peaks are asked of."""
    return _sizes(Curves(motion.q, motion.rates, body_curves(motion, body, point, relative_to)), asked)


def _sizes(curves: Curves, asked: list[Asked]) -> np.ndarray:
    """Returns (asked, ...): what is largest where the peaks are."""
    return np.array([_size(curves, one) for one in asked])


def _size(curves: Curves, one: Asked) -> np.ndarray:
    if one.velocity is None:
        return np.linalg.norm(curves.of_body[one.of][one.order], axis=-1)
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
    """Returns (value, time) of each quantity's maximum: from its highest local maxima on the grid into their
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
    """Returns the larger ones; within the slack, relative, which is the rounding, the time counts and the
    value stays."""
    moves = value > best - slack * np.abs(best) if slack else value > best
    return np.where(moves, np.maximum(value, best), best), np.where(moves, time, best_time)


def _closing_time(times: np.ndarray, sizes: np.ndarray) -> float:
    """Returns the time at which the least-squares polynomial through a bracket is largest, in s."""
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
    """Returns, for each quantity, the breaks at which a lower derivative jumps. curves: at all times of the
    grid."""
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
    """Returns the k-th derivative of what was asked and its derivative, each (..., components)."""
    if one.velocity is None:
        return curves.of_body[one.of][k], curves.of_body[one.of][k + 1]
    own = one.velocity
    if k == 0:  # a ball's velocity is no rate of a coordinate, but its quaternion is continuous
        rate = curves.rates[0][..., own, None]
        return (rate * 0 if one.position is None else curves.q[..., one.position, None]), rate
    return curves.rates[k - 1][..., own, None], curves.rates[k][..., own, None]
