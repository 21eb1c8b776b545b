"""Peaks of a robot's motion along a recording, with errors propagated from those of the coordinates.

The error of a quantity F of many coordinates is, to first order, the sum of the effects of each derivative's
error:

    error(F) = Σ₍ⱼ,ₖ₎ |F(…, qⱼ⁽ᵏ⁾ + eⱼ⁽ᵏ⁾, …) − F|.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.robot.common_base import coordinates_that_move
from workbench.kinematics.robot.peaks import (
    Asked,
    Peak,
    Violation,
    body_curves,
    peak_at,
    stretches,
    violation,
)
from workbench.kinematics.robot.recording.recorded_peaks import (
    RecordedPeak,
    below_noise,
    decelerations,
    peak_of,
    recorded_bound,
    recorded_deceleration,
    recorded_peak,
)
from workbench.kinematics.robot.recording.recordings import Break, Recording
from workbench.kinematics.robot.states import States

BLOCK = 4096  # samples at a time


@dataclass(frozen=True)
class Samples:
    """Estimates and errors (N + 1, samples, positions) at the times (samples,) in s; jumps: of each
    position the breaks."""

    times: np.ndarray
    estimates: np.ndarray
    errors: np.ndarray
    breaks: tuple[tuple[Break, ...], ...]


def recorded_peaks(
    motion: States, body: str | None, point: ArrayLike, relative_to: str | None, asked: list[Asked]
) -> list[Peak]:
    """Returns the peaks on the times from the motion's first to its last."""
    parts, samples = _samples(motion)
    carried = _carried(motion, body, point, relative_to, asked, samples)
    whole = samples.times[0], samples.times[-1]
    return [
        _as_peak(one, whole, _direct(parts[one.position], one) if one.position is not None else carried[i])
        for i, one in enumerate(asked)
    ]


def _samples(motion: States) -> tuple[list[Recording], Samples]:
    """Returns the recordings on the times from the motion's first to its last, and their estimates
    together."""
    start, end = float(motion.times.min()), float(motion.times.max())
    parts = [recording.within(start, end) for recording in motion.path.recordings]
    pairs = [[part.estimate(k) for part in parts] for k in range(motion.order + 1)]
    estimates, errors = (
        np.array([[pair[i] for pair in row] for row in pairs]).swapaxes(1, 2) for i in (0, 1)
    )
    return parts, Samples(parts[0].times, estimates, errors, tuple(part.breaks for part in parts))


def recorded_violations(
    motion: States, body: str | None, point: ArrayLike, relative_to: str | None, asked: list[Asked]
) -> list[Violation]:
    """Returns the stretches of samples that are beyond a limit by more than their stated errors."""
    parts, samples = _samples(motion)
    carried = _carried_values(motion, body, point, relative_to, asked, samples)
    found = []
    for i, one in enumerate(asked):
        if one.position is None:
            values, errors, _ = carried[i]
            sizes = np.linalg.norm(values, axis=-1)
        else:
            sizes, errors = _own_sizes(parts[one.position], one)
        for first, last in stretches(sizes - errors > one.threshold):
            top = first + int(np.argmax(sizes[first : last + 1]))
            start, end, time = (float(samples.times[at]) for at in (first, last, top))
            found.append(violation(one, start, end, float(sizes[top]), time))
    return found


def _own_sizes(recording: Recording, one: Asked) -> tuple[np.ndarray, np.ndarray]:
    """Returns the sizes that a coordinate's limit is compared with, and their errors, each (samples,)."""
    values, errors = recording.estimate(one.order)
    if one.order == 0:
        q = one.factor * values + one.offset
        return (-q if one.bound == "lower" else q), abs(one.factor) * errors
    if one.bound == "deceleration":
        sizes, errors = decelerations(recording)
        return abs(one.factor) * sizes, abs(one.factor) * errors
    return np.abs(one.factor * values), abs(one.factor) * errors


def _as_peak(one: Asked, whole: tuple[float, float], found: RecordedPeak) -> Peak:
    """Returns the peak of what was asked, of the coordinate's own."""
    scale, shift = (abs(one.factor), 0.0)
    if one.order == 0:
        shift = -one.offset if one.bound == "lower" else one.offset
    least, most, value = (scale * x + shift for x in (found.at_least, found.at_most, found.value))
    bounds = {"error": scale * found.error, "at_least": least, "at_most": most}
    return peak_at(
        one,
        value,
        found.time,
        **bounds,
        reason=found.reason,
        span=None if found.span == whole else found.span,
        rounding=one.rounding(),
    )


def _direct(recording: Recording, one: Asked) -> RecordedPeak:
    """Returns the peak of a coordinate's derivative from its own recording, the factor of a joint that
    follows aside."""
    if one.order == 0:
        sign = -1 if (one.bound == "lower") != (one.factor < 0) else 1
        return recorded_bound(recording, sign)
    if one.bound == "deceleration":
        return recorded_deceleration(recording)
    return recorded_peak(recording, one.order)


def _carried(
    motion: States,
    body: str | None,
    point: ArrayLike,
    relative_to: str | None,
    asked: list[Asked],
    samples: Samples,
) -> dict[int, RecordedPeak]:
    """Returns the peaks of the body and of balls' velocities, by their places in `asked`."""
    found: dict[int, RecordedPeak] = {}
    places: dict[tuple[str, int], int] = {}
    for i, (values, errors, own) in _carried_values(motion, body, point, relative_to, asked, samples).items():
        one = asked[i]
        found[i] = _peak(samples, values, errors, own, one.order)
        if (one.of, one.order - 1) in places:
            found[i] = below_noise(found[i], partial(found.__getitem__, places[one.of, one.order - 1]))
        places[one.of, one.order] = i
    return found


def _carried_values(
    motion: States,
    body: str | None,
    point: ArrayLike,
    relative_to: str | None,
    asked: list[Asked],
    samples: Samples,
) -> dict[int, tuple[np.ndarray, np.ndarray, list[int]]]:
    """Returns the values of the body and of balls' velocities, by their indices in `asked`.

    Each is values (samples, components), errors (samples,) of their sizes, and the coordinates that they
    depend on.
    """
    robot: Any = motion.robot
    wanted = {i: one for i, one in enumerate(asked) if one.position is None}
    if not wanted:
        return {}

    def values_at(q: np.ndarray) -> dict[int, np.ndarray]:
        there = robot.motion(q)
        of_body = body_curves(there, body, point, relative_to)
        return {
            i: of_body[one.of][one.order]
            if one.velocity is None
            else there.rates[one.order - 1][:, [one.velocity]]
            for i, one in wanted.items()
        }

    movers = [] if body is None else coordinates_that_move(robot, body, relative_to)
    own = {i: movers if one.velocity is None else _of_ball(motion, one) for i, one in wanted.items()}
    with_errors = _with_errors(values_at, samples, wanted, own)
    return {i: (values, errors, own[i]) for i, (values, errors) in with_errors.items()}


def _of_ball(motion: States, one: Asked) -> list[int]:
    """Returns the coordinates of the ball joint whose velocity is asked for."""
    joint = next(joint for joint in motion.robot.joints if one.of in joint.velocities)
    return [motion.robot.positions.index(name) for name in joint.coordinates]


def _with_errors(
    values_at: Callable[[np.ndarray], dict[int, np.ndarray]],
    samples: Samples,
    wanted: dict[int, Asked],
    own: dict[int, list[int]],
) -> dict[int, tuple[np.ndarray, np.ndarray]]:
    """Returns, for each quantity, its values (samples, components), and the errors (samples,) of their sizes.

    own: the coordinates that it depends on.
    """
    blocks = []
    for first in range(0, len(samples.times), BLOCK):
        here = slice(first, first + BLOCK)
        blocks.append(_block(values_at, samples.estimates[:, here], samples.errors[:, here], wanted, own))
    return {
        i: (
            np.concatenate([block[i][0] for block in blocks]),
            np.concatenate([block[i][1] for block in blocks]),
        )
        for i in wanted
    }


def _block(
    values_at: Callable[[np.ndarray], dict[int, np.ndarray]],
    q: np.ndarray,
    errors: np.ndarray,
    wanted: dict[int, Asked],
    own: dict[int, list[int]],
) -> dict[int, tuple[np.ndarray, np.ndarray]]:
    now = values_at(q)
    totals = {i: np.zeros(q.shape[1]) for i in wanted}
    for j in sorted({j for coordinates in own.values() for j in coordinates}):
        for k in range(len(q)):
            error = errors[k, :, j]
            is_known = np.isfinite(error)
            moved = q.copy()
            moved[k, :, j] += np.where(is_known, error, 0.0)
            changed = values_at(moved)
            for i, one in wanted.items():
                if k <= one.order and j in own[i]:
                    totals[i] += np.linalg.norm(changed[i] - now[i], axis=-1)
                    totals[i][~is_known] = np.inf
    return {i: (now[i], totals[i]) for i in wanted}


def _peak(
    samples: Samples, values: np.ndarray, errors: np.ndarray, coordinates: list[int], order: int
) -> RecordedPeak:
    """Returns the peak of a quantity's size; next to a break, and between samples, it may differ by as much
    as it changes."""
    size, errors = np.linalg.norm(values, axis=-1), errors.copy()
    breaks = [one for j in coordinates for one in samples.breaks[j]]
    for one in breaks:
        if 0 < one.sample < len(size):
            both = slice(one.sample - 1, one.sample + 1)
            errors[both] += np.linalg.norm(values[one.sample] - values[one.sample - 1])
    bend = np.zeros_like(size)
    bend[1:-1] = np.abs(size[2:] - 2 * size[1:-1] + size[:-2]) / 8  # of a parabola through three samples
    is_top = np.zeros(len(size), bool)
    is_top[1:-1] = (size[1:-1] >= size[2:]) & (size[1:-1] >= size[:-2])
    errors = errors + np.where(is_top, bend, 0.0)
    jumps = [one for one in breaks if one.order < order]
    return peak_of(samples.times, size, errors, jumps)
