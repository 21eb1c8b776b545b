"""Derivatives up to the snap of a recorded coordinate, with stated errors, by local least-squares
polynomials.

A recording is cut at gaps and at jumps of a derivative of order at most 4 (`recorded_breaks`). Between the
cuts, windows of many sizes are fitted (`local_polynomials`); for each sample and order the window and the
degree with the least stated error are used. Units: s, and rad or m per sᵏ.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, replace
from math import factorial

import numpy as np

HIGHEST_RECORDED_ORDER = 4
LEAST_SAMPLES = 10
CONFIDENCE = 0.05  # that any of the windows misses by more than the noise's part of the stated error
GAP = 4.0  # median distances of samples
UNLIKELY = 1e-3  # that the spectrum of noise is so uneven
NOISE_WINDOWS = ((24, 12), (12, 6), (12, 9), (16, 12))  # samples and degree


@dataclass(frozen=True)
class Break:
    """A time at which the derivative `order` of a recording jumps, between the samples `sample` − 1 and
    `sample`; time in s."""

    time: float
    order: int
    sample: int


@dataclass(frozen=True)
class Recording:
    """A recorded coordinate with its derivatives.

    times (n,) in s; estimates, errors (7, n): the derivatives 0, …, 6 at the samples and their stated errors,
    infinite where nothing is known; breaks; gaps: samples behind a gap; noise: the standard deviation of the
    samples; step: that of an encoder, or 0. is_undersampled: what counts as noise has not the spectrum of
    noise, so it may be motion faster than the samples show; the errors cover that.
    """

    times: np.ndarray
    estimates: np.ndarray
    errors: np.ndarray
    breaks: tuple[Break, ...]
    gaps: tuple[int, ...]
    noise: float
    step: float
    is_undersampled: bool = False

    def estimate(self, order: int) -> tuple[np.ndarray, np.ndarray]:
        """Returns (value, error), each (n,): the derivative of that order at the samples. Raises
        ValueError beyond 4."""
        require_order(order)
        return self.estimates[order], self.errors[order]

    def within(self, start: float, end: float) -> Recording:
        """Returns the part from start to end in s, both within the recording, with a sample outside on each
        side."""
        n = len(self.times)
        first = max(0, int(np.searchsorted(self.times, start, side="right")) - 1)
        last = min(n, int(np.searchsorted(self.times, end)) + 1)
        if (first, last) == (0, n):
            return self
        here = slice(first, last)
        breaks = (replace(one, sample=one.sample - first) for one in self.breaks if first < one.sample < last)
        gaps = tuple(gap - first for gap in self.gaps if first < gap < last)
        return replace(
            self,
            times=self.times[here],
            estimates=self.estimates[:, here],
            errors=self.errors[:, here],
            breaks=tuple(breaks),
            gaps=gaps,
        )

    def between(self, times: np.ndarray, order: int) -> tuple[np.ndarray, np.ndarray]:
        """Returns the derivatives 0, …, order at any times (...) of the recording, and their errors, each
        (order + 1, ...).

        Between two samples the Taylor polynomials of both, of two more orders, are blended linearly; the
        error is the larger one of the two, plus their difference. At a break it is the polynomial of the
        sample on the same side; in a gap a quintic, with an infinite error.
        """
        require_order(order)
        behind = np.clip(np.searchsorted(self.times, times, side="right"), 1, len(self.times) - 1)
        before = behind - 1
        share = (times - self.times[before]) / (self.times[behind] - self.times[before])
        for one in self.breaks:
            here = behind == one.sample
            share = np.where(here, np.where(times < one.time, 0.0, 1.0), share)
        (left, left_error), (right, right_error) = (self.taylor(i, times, order) for i in (before, behind))
        values = np.where(share == 0, left, np.where(share == 1, right, left + share * (right - left)))
        errors = np.maximum(left_error, right_error) + np.abs(left - right)
        errors = np.where(share == 0, left_error, np.where(share == 1, right_error, errors))
        for gap in self.gaps:
            here = (behind == gap) & (share > 0) & (share < 1)
            if here.any():
                values[:, here] = self._across(gap, times[here], order)
                errors[:, here] = np.inf
        return values, errors

    def taylor(
        self, at: np.ndarray, times: np.ndarray, order: int, terms: int = 3
    ) -> tuple[np.ndarray, np.ndarray]:
        """Returns the derivatives 0, …, order at the times (...) by Taylor polynomials of the samples `at`
        (...), of `terms` terms, as far as known, and their errors, each (order + 1, ...)."""
        h = times - self.times[at]
        values, errors = np.zeros((order + 1, *h.shape)), np.zeros((order + 1, *h.shape))
        for k in range(order + 1):
            for j in range(terms):
                there = np.isfinite(self.errors[k + j, at])
                values[k] += np.where(there | (j == 0), self.estimates[k + j, at] * h**j / factorial(j), 0.0)
                known = np.where(there, self.errors[k + j, at], 0.0)
                errors[k] += known * np.abs(h) ** j / factorial(j)
            errors[k] = np.where(np.isfinite(self.errors[k, at]), errors[k], np.inf)
        return values, errors

    def _across(self, gap: int, times: np.ndarray, order: int) -> np.ndarray:
        """Returns the quintic between the samples on both sides of a gap."""
        from scipy.interpolate import BPoly

        ends = [self.estimates[:3, i] for i in (gap - 1, gap)]
        quintic = BPoly.from_derivatives(self.times[gap - 1 : gap + 1], ends)
        return np.stack([quintic.derivative(k)(times) if k else quintic(times) for k in range(order + 1)])


def require_order(order: int) -> None:
    """Raises ValueError for an order that no recording tells."""
    if not 0 <= order <= HIGHEST_RECORDED_ORDER:
        raise ValueError(
            f"order: expected at most {HIGHEST_RECORDED_ORDER} (snap), all that samples tell, got {order}"
        )


def record(t: np.ndarray, q: np.ndarray) -> Recording:
    """Returns the recording of the samples q (n,) at increasing times t (n,) in s; n is at least 10."""
    from scipy.special import ndtri

    from workbench.kinematics.robot.recording.local_polynomials import ORDERS, fit_windows  # loads Numba
    from workbench.kinematics.robot.recording.recorded_breaks import find_breaks

    n, clock = len(t), t - t[0]
    distances = np.diff(clock)
    typical = np.median(distances)
    gaps = np.flatnonzero(distances > GAP * typical) + 1
    is_uniform = not len(gaps) and bool(np.abs(distances - typical).max() < 1e-6 * typical)
    steepest = np.abs(np.diff(q) / distances).max()
    rounding = 5e-16 * np.abs(q).max() + 1.5e-16 * np.abs(t).max() * steepest + 1e-150
    step = encoder_step(q)
    least = max(rounding, step / np.sqrt(12))
    noise, sums = _local_noise(clock, q, least)
    z = -float(ndtri(CONFIDENCE / 2 / max(1.0, n / 16)))
    estimates, errors = np.zeros((ORDERS, n)), np.full((ORDERS, n), np.inf)
    counts, breaks = np.zeros((ORDERS, n), np.int32), []
    edges = [0, *gaps.tolist(), n]
    for a, b in itertools.pairwise(edges):
        if b - a < 6:
            _fill_short(clock, q, a, b, estimates)
            continue
        found = find_breaks(clock, q, a, b, max(noise, rounding), sums, z)
        breaks += [Break(float(t[0] + one.time), one.order, one.sample) for one in found]
        inner = [a, *(one.sample for one in found), b]
        for c, d in itertools.pairwise(inner):
            fit_windows(clock, q, c, d, is_uniform, least, sums, z, estimates, errors, counts)
    is_undersampled = noise > 3 * least and not _is_noise(q - estimates[0], noise)
    if is_undersampled:
        fastest = np.pi / typical  # half of the sampling rate
        errors[1:] += 2 * noise * (fastest ** np.arange(1, ORDERS))[:, None]
    for array in (estimates, errors):
        array.flags.writeable = False
    return Recording(t, estimates, errors, tuple(breaks), tuple(gaps.tolist()), noise, step, is_undersampled)


def _is_noise(left: np.ndarray, noise: float) -> bool:
    """Returns False if what the polynomials leave (n,) is of the noise's size and its spectrum is not flat
    from a quarter of the sampling rate to a half: Fisher's test of the largest ordinate of the periodogram,
    and Bartlett's of its sums.

    Motion at these frequencies, fewer than four samples a period, is left as noise by small windows.
    """
    if np.sqrt(np.mean(left**2)) > 3 * noise:  # a break that was not found, say
        return True
    power = np.abs(np.fft.rfft(left)) ** 2
    power = power[len(power) // 2 : -1]
    count = len(power)
    share = np.cumsum(power) / power.sum()
    apart = np.abs(share - np.arange(1, count + 1) / count).max()
    line = count * (1 - power.max() / power.sum()) ** (count - 1)
    return bool(min(line, 2 * np.exp(-2 * count * apart**2)) > UNLIKELY)


def _fill_short(t: np.ndarray, q: np.ndarray, first: int, last: int, estimates: np.ndarray) -> None:
    """Fills the estimates of a stretch too short for errors: the polynomial through it, of degree 3 at
    most."""
    here = slice(first, last)
    at = t[here] - t[first]
    fit = np.polynomial.Polynomial.fit(at, q[here], min(3, last - first - 1), domain=[0, max(at[-1], 1e-300)])
    for k in range(4):
        estimates[k, here] = fit.deriv(k)(at) if k else fit(at)


def _local_noise(t: np.ndarray, q: np.ndarray, floor: float) -> tuple[float, np.ndarray]:
    """Returns (σ, sums): the deviation of the noise, and the sums (n + 1,) of its local variances.

    Of several kinds of small windows those count that leave least: what they leave is noise and not motion.
    """
    from scipy.special import chdtri

    from workbench.kinematics.robot.recording.local_polynomials import mean_squares

    n, best = len(t), None
    for count, degree in NOISE_WINDOWS:
        if n < 2 * count:
            continue
        found = np.zeros((n - count) // (count // 2) + 1)
        mean_squares(t, q, count, degree, found)
        freedom = count - degree - 1
        level = np.median(found) / (chdtri(freedom, 0.5) / freedom)
        if best is None or level < 0.6 * best[0]:
            best = level, found, count
    if best is None:
        return floor, np.arange(n + 1) * floor**2
    level, found, count = best
    above = found[found > 10 * floor**2]
    typical = np.median(above) if len(above) else 0.0
    found = np.minimum(found, 9 * max(typical, level)) + floor**2  # a window on a jump is not noise
    at = np.minimum(np.arange(len(found)) * (count // 2) + count // 2, n - 1)
    local = np.interp(np.arange(n), at, found)
    return float(np.sqrt(max(level, floor**2))), np.concatenate([[0.0], np.cumsum(local)])


def encoder_step(q: np.ndarray) -> float:
    """Returns the step of an encoder, of which all differences of the samples are multiples, or 0."""
    differences = np.abs(np.diff(q[:20000]))
    differences = differences[differences > 0]
    if len(differences) < 20:
        return 0.0
    least = differences.min()
    ratio = differences / least
    near = np.round(ratio)
    are_steps = least > 1e-9 and np.abs(ratio - near).max() < 1e-3 and ratio.max() < 1e6
    return float(least) if are_steps and (near == 1).mean() > 0.01 else 0.0
