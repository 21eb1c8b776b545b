"""The largest size of a derivative of a recording, with an error that covers it, or "not determined".

The largest |estimate| is told if nowhere |estimate| + error exceeds it by more than two fifths. Stretches at
the ends of the recording, where derivatives are known less well, are left out where that halves the error.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from math import factorial

import numpy as np

from workbench.kinematics.robot.derivative_names import order_name
from workbench.kinematics.robot.recording.recordings import Break, Recording

MOST = 0.4  # of the peak, by which |estimate| + error may exceed it anywhere
ENDS = (0.0, 0.005, 0.01, 0.02, 0.04, 0.07, 0.1, 0.15)  # shares of the samples left out at both ends together
WELL = 0.1  # of a peak: a range so small is good enough with the ends
RELATIVE = 1e-6  # of a peak: the least error that is stated


class Undetermined(StrEnum):
    """Why a peak has no value, other than a jump."""

    SOMEWHERE = "not known everywhere"
    BELOW_NOISE = "below its noise"


@dataclass(frozen=True)
class RecordedPeak:
    """A peak: value ± error, at the time in s, on the times span; error: infinite where it is not determined.

    at_least: what the size reaches in any case; 0 where nothing is known. at_most: what it exceeds nowhere,
    the ends that span leaves out with them; infinite where that is not known. reason: why the value is not.
    """

    value: float
    error: float
    time: float
    span: tuple[float, float]
    at_least: float
    at_most: float = np.inf
    reason: str = ""


def recorded_peak(recording: Recording, order: int) -> RecordedPeak:
    """Returns the largest |q⁽ᵏ⁾|, k = order >= 1."""
    recording.estimate(order)  # raises ValueError beyond 4
    size, error = np.abs(recording.estimates[order]), recording.errors[order]
    jumps = [one for one in recording.breaks if one.order < order]
    more, moves = _between_samples(recording, order)
    widened = error + more * np.minimum(0.2, 0.5 * _steepness(recording, order, size) * np.abs(moves))
    found = peak_of(recording.times, size + more, widened, jumps, _corners(recording, order), moves)
    return found if order == 1 else below_noise(found, lambda: recorded_peak(recording, order - 1))


def recorded_deceleration(recording: Recording) -> RecordedPeak:
    """Returns the largest |q̈| while q̈ and q̇ have opposite signs, also between the samples: where q̇ = 0 it
    ends."""
    size, error = decelerations(recording)
    v, a, jerk = recording.estimates[1:4]
    more, moves = _between_samples(recording, 2)
    v_there = v + a * moves + jerk * moves**2 / 2
    slows = (moves != 0) & (v_there * a < 0) & (np.abs(v_there) > recording.errors[1])
    widened = recording.errors[2] + more * np.minimum(
        0.2, 0.5 * _steepness(recording, 2, np.abs(a)) * np.abs(moves)
    )
    size, error = np.where(slows, np.abs(a) + more, size), np.where(slows, widened, error)
    jumps = [one for one in recording.breaks if one.order < 2]
    corners = [one for one in _corners(recording, 2) if size[one[0] - 1 : one[0] + 1].any()]
    moves = np.where(slows, moves, 0.0)
    return peak_of(recording.times, size, error, jumps, [*corners, *_stops(recording)], moves)


def decelerations(recording: Recording) -> tuple[np.ndarray, np.ndarray]:
    """Returns |q̈| where q̈ and q̇ have opposite signs, else 0, and its errors, each (samples,); where the
    signs are not known it may count or not."""
    (v, ev), (a, ea) = recording.estimate(1), recording.estimate(2)
    size = np.abs(a)
    is_sure = (np.abs(v) > ev) & (size > ea)
    slows = v * a < 0
    half = (size + ea) / 2
    sizes = np.where(is_sure, np.where(slows, size, 0.0), half)
    return sizes, np.where(is_sure, np.where(slows, ea, 0.0), half)


def _stops(recording: Recording) -> list[tuple[int, float, float]]:
    """Returns (first sample after it, |q̈|, error) of each time between two samples at which q̇ = 0."""
    v, a, jerk = recording.estimates[1:4]
    before = np.flatnonzero(v[:-1] * v[1:] < 0)
    before = before[~np.isin(before + 1, recording.gaps)]
    near = np.where(np.abs(v[before]) <= np.abs(v[before + 1]), before, before + 1)
    with np.errstate(all="ignore"):
        move = -v[near] / a[near]
        move -= (v[near] + a[near] * move + jerk[near] * move**2 / 2) / (a[near] + jerk[near] * move)
    ends = recording.times[before], recording.times[before + 1]
    times = np.clip(recording.times[near] + np.nan_to_num(move), *ends)
    values, errors = recording.taylor(near, times, 2, 5)
    with np.errstate(all="ignore"):
        late = np.minimum(recording.errors[1, near] / np.abs(values[2]), ends[1] - ends[0])
    wide = errors[2] + np.abs(jerk[near]) * np.nan_to_num(late, nan=np.inf)
    breaks = [one.sample for one in recording.breaks]
    wide += np.where(np.isin(before + 1, breaks), np.abs(a[before + 1] - a[before]), 0.0)
    return list(zip((before + 1).tolist(), np.abs(values[2]).tolist(), wide.tolist(), strict=True))


def below_noise(found: RecordedPeak, lower: Callable[[], RecordedPeak]) -> RecordedPeak:
    """Returns the peak; of one below its noise at_most is known only if the derivative before it is known
    well, or is below its noise with a bound of its own: else it may jump."""
    if found.reason is not Undetermined.BELOW_NOISE:
        return found
    before = lower()
    is_sure = (
        before.error <= WELL * before.value
        if np.isfinite(before.error)
        else before.reason is Undetermined.BELOW_NOISE
    )
    return found if is_sure and np.isfinite(before.at_most) else replace(found, at_most=np.inf)


def recorded_bound(recording: Recording, sign: int) -> RecordedPeak:
    """Returns the largest sign · q, sign = 1 or −1, also between the samples; the coordinate there is sign ·
    value."""
    whole = float(recording.times[0]), float(recording.times[-1])
    parts = [_at_samples(recording, sign), _tops(recording, sign), _kinks(recording, sign)]
    times, value, error = map(np.concatenate, zip(*parts, strict=True))
    at = int(np.argmax(value))
    best, time = float(value[at]), float(times[at])
    low, high = float((value - error).max()), float((value + error).max())
    jumps = [one for one in recording.breaks if one.order == 0]
    if jumps or not np.isfinite(high):
        reason = jump_reason(jumps) if jumps else Undetermined.SOMEWHERE
        return RecordedPeak(best, np.inf, time, whole, low, reason=reason)
    stated = max(high - best, best - low, 1e-12 * float(np.abs(value).max()))
    return RecordedPeak(best, stated, time, whole, low, best + stated)


def _at_samples(recording: Recording, sign: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns (times, sign · q, errors) of the samples; where the slope is not known the error covers the
    neighbours."""
    value, error = sign * recording.estimates[0], recording.errors[0]
    steps = np.abs(np.diff(value))
    apart = np.maximum(np.append(steps, 0.0), np.append(0.0, steps))
    is_known = np.isfinite(recording.errors[1])
    return recording.times, value, np.where(is_known, error, error + apart)


def _tops(recording: Recording, sign: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns (times, sign · q, errors) where it is largest between two samples, by the Taylor polynomial of
    the nearest one."""
    slope, bend, jerk = sign * recording.estimates[1:4]
    steps = np.diff(recording.times)
    before, after = np.append(steps[0], steps), np.append(steps, steps[-1])
    with np.errstate(all="ignore"):
        move = -slope / bend
        move = move - (slope + bend * move + jerk * move**2 / 2) / (bend + jerk * move)
    known = np.isfinite(recording.errors[1:3]).all(axis=0)
    at = np.flatnonzero(known & (bend < 0) & (move > -0.6 * before) & (move < 0.6 * after))
    times = recording.times[at] + move[at]
    inside = (times > recording.times[0]) & (times < recording.times[-1])
    at, times = at[inside], times[inside]
    values, errors = recording.taylor(at, times, 0, len(recording.estimates))
    return times, sign * values[0], errors[0]


def _kinks(recording: Recording, sign: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns (times, sign · q, errors) at the breaks."""
    breaks = [one for one in recording.breaks if one.order > 0]
    found = [_corner(recording, 0, one, lambda q: sign * q)[1:] for one in breaks]
    rows = np.array([(one.time, *row) for one, row in zip(breaks, found, strict=True)]).reshape(-1, 3)
    return rows[:, 0], rows[:, 1], rows[:, 2]


def peak_of(
    times: np.ndarray,
    size: np.ndarray,
    error: np.ndarray,
    jumps: Sequence[Break],
    corners: Sequence[tuple[int, float, float]] = (),
    moves: np.ndarray | None = None,
) -> RecordedPeak:
    """Returns the largest size (n,) at times (n,), whose errors (n,) are stated.

    jumps: breaks of lower derivatives, where the size has no bound. corners: (first sample behind, value,
    error) of sizes at a break between two samples. moves: by how much in s the maxima are off the samples.
    """
    whole = float(times[0]), float(times[-1])
    sure = np.where(np.isfinite(error), size - error, -1.0)
    at = int(np.argmax(sure))
    best = int(np.argmax(np.where(np.isfinite(error), size, -1.0)))
    time = float(times[best] + (0.0 if moves is None else moves[best]))
    at_least = max(float(sure[at]), 0.0)
    if jumps:
        reason = f"{jump_reason(jumps)}: no bound there"
        return RecordedPeak(np.nan, np.inf, jumps[0].time, whole, at_least, reason=reason)
    if not sure[at] > 0:
        most = float((size + error).max())
        return RecordedPeak(float(size[best]), np.inf, time, whole, 0.0, most, Undetermined.BELOW_NOISE)
    n, found = len(times), []
    for share in ENDS:
        first, last = round(n * share / 2), n - round(n * share / 2)
        span = float(times[first]), float(times[last - 1])
        found.append((*_bounds(size, error, corners, first, last), span))
    least = min(high - low for _, low, high, _ in found)
    chosen = next(one for one in found if one[2] - one[1] <= max(2 * least, WELL * one[0]))
    if chosen[2] < at_least and found[0][2] <= (1 + MOST) * found[0][0]:
        chosen = found[0]  # the peak lies at an end
    value, low, high, span = chosen
    inside = (times >= span[0]) & (times <= span[1])
    best = int(np.argmax(np.where(np.isfinite(error) & inside, size, -1.0)))
    time = float(times[best] + (0.0 if moves is None else moves[best]))
    if not low > 0 or high > (1 + MOST) * value:
        return RecordedPeak(value, np.inf, time, whole, at_least, reason=Undetermined.SOMEWHERE)
    stated = max(high - value, value - low, RELATIVE * value)
    return RecordedPeak(value, stated, time, span, at_least, max(found[0][2], value + stated))


def jump_reason(jumps: Sequence[Break]) -> str:
    """Returns which derivative jumps, and where: "acceleration jumps at 3 times (1, 2, 3 s)"."""
    lowest = min(one.order for one in jumps)
    at = sorted(one.time for one in jumps if one.order == lowest)
    times = ", ".join(f"{time:.6g}" for time in at[:3]) + (", …" if len(at) > 3 else "")
    count = "1 time" if len(at) == 1 else f"{len(at)} times"
    return f"{order_name(lowest)} jumps at {count} ({times} s)"


def _bounds(
    size: np.ndarray, error: np.ndarray, corners: Sequence[tuple[int, float, float]], first: int, last: int
) -> tuple[float, float, float]:
    """Returns (value, low, high) of the peak on the samples first, …, last − 1 and the corners between
    them."""
    here = slice(first, last)
    value, low = float(size[here].max()), float((size - error)[here].max())
    high = float((size + error)[here].max())
    for cut, corner, wide in corners:
        if first < cut < last:
            value, low, high = max(value, corner), max(low, corner - wide), max(high, corner + wide)
    return value, low, high


def _between_samples(recording: Recording, order: int) -> tuple[np.ndarray, np.ndarray]:
    """Returns (more, moves): by how much the size exceeds that at each sample near it, where the
    derivative f has f′ = 0 near the sample, at the distance −f′/f″ in s, and there is a maximum of |f|."""
    f, slope, bend = recording.estimates[order : order + 3]
    steps = np.diff(recording.times)
    near = np.minimum(np.append(steps, steps[-1]), np.append(steps[0], steps))
    with np.errstate(all="ignore"):
        moves = np.where(bend != 0, -slope / bend, 0.0)
    moves = np.where((np.abs(moves) < 0.75 * near) & (f * bend < 0), moves, 0.0)
    return np.abs(0.5 * slope * moves), moves


def _steepness(recording: Recording, order: int, size: np.ndarray) -> np.ndarray:
    """Returns |f″/f|^½: the rate per s at which f oscillates at most."""
    bend = np.abs(recording.estimates[order + 2])
    return np.sqrt(np.divide(bend, size, out=np.zeros_like(size), where=size > 1e-290 * bend))


def _corners(recording: Recording, order: int) -> list[tuple[int, float, float]]:
    """Returns, for each break, (first sample after it, value, error) of |f| between the neighbouring samples,
    f being the derivative `order`."""
    found = []
    for one in recording.breaks:
        if one.order >= order:
            found.append(_corner(recording, order, one))
    return found


def _corner(
    recording: Recording, order: int, one: Break, size: Callable[[float], float] = abs
) -> tuple[int, float, float]:
    """Returns the corner where the two sides' lines f + s x and g − r (step − x) meet, or the larger end of a
    jump; `size` is compared."""
    i, j = one.sample - 1, one.sample
    step = recording.times[j] - recording.times[i]
    (f, s), (g, r) = recording.estimates[order : order + 2, i], recording.estimates[order : order + 2, j]
    (ef, es), (eg, er) = recording.errors[order : order + 2, i], recording.errors[order : order + 2, j]
    wide = max(ef + step * es, eg + step * er)
    if one.order == order:
        high = max(size(f + s * step), size(g - r * step)) + wide
        value = max(size(f), size(g))
        return j, value, max(high - value, wide)
    if s == r:
        return j, max(size(f), size(g)), wide
    apart = abs(recording.estimates[one.order, i] - recording.estimates[one.order, j])
    hidden = (recording.noise * factorial(one.order) / apart) ** (1 / one.order) if apart > 0 else 0.0
    wide += abs(s - r) * (0.5 * step + hidden)  # the time of the break is not better known
    x = min(max((g - r * step - f) / (s - r), 0.0), step)
    left, right = f + s * x, g - r * (step - x)
    return j, size(0.5 * (left + right)), wide + abs(left - right)
