"""Recordings of motions whose derivatives are known: sums of exponentials and piecewise polynomials, sampled."""

from dataclasses import dataclass
from math import factorial

import numpy as np


@dataclass(frozen=True)
class Exponentials:
    """q(t) = Re Σ A exp(λ t): sines, decays, growing oscillations."""

    amplitudes: np.ndarray
    rates: np.ndarray

    def at(self, t, k):
        t = np.asarray(t, float)
        terms = self.amplitudes * self.rates**k * np.exp(self.rates * t[..., None])
        return terms.sum(axis=-1).real

    def peak(self, k, a, b):
        """The largest |q⁽ᵏ⁾| on a … b."""
        t = np.linspace(a, b, 100_001)
        sizes = np.abs(self.at(t, k))
        best = float(sizes.max())
        for x in t[np.argsort(sizes)[-20:]]:
            start = x
            for _ in range(5):
                bend = self.at(x, k + 2)
                x = x - self.at(x, k + 1) / bend if bend else x
            if a <= x <= b and abs(x - start) < 3 * (t[1] - t[0]):
                best = max(best, abs(float(self.at(x, k))))
        return best


@dataclass(frozen=True)
class Pieces:
    """q(t) = Σⱼ coefficients[i, j] (t − breaks[i])ʲ on the piece i."""

    breaks: np.ndarray
    coefficients: np.ndarray

    def at(self, t, k, side="right"):
        t = np.asarray(t, float)
        i = np.clip(np.searchsorted(self.breaks, t, side=side) - 1, 0, len(self.coefficients) - 1)
        u, total = t - self.breaks[i], np.zeros_like(t)
        for j in range(self.coefficients.shape[1] - 1, k - 1, -1):
            total = total * u + factorial(j) // factorial(j - k) * self.coefficients[i, j]
        return total

    def peak(self, k, a, b):
        """The supremum of |q⁽ᵏ⁾| on a … b, infinite where a lower derivative jumps there."""
        inner = self.breaks[(self.breaks > a) & (self.breaks < b)]
        for j in range(k):
            jump = np.abs(self.at(inner, j) - self.at(inner, j, "left"))
            if len(inner) and jump.max() > 1e-7 * (np.abs(self.coefficients[:, j:]).max() + 1e-12):
                return np.inf
        candidates = [np.array([a, b]), inner]
        for i, row in enumerate(self.coefficients):
            slope = np.polynomial.polynomial.polyder(row, k + 1)
            roots = (
                np.polynomial.polynomial.polyroots(np.trim_zeros(slope, "b"))
                if np.trim_zeros(slope, "b").size > 1
                else np.zeros(0)
            )
            real = roots.real[np.abs(roots.imag) < 1e-7] + self.breaks[i]
            end = self.breaks[i + 1] if i + 1 < len(self.breaks) else b
            candidates.append(real[(real > max(a, self.breaks[i])) & (real < min(b, end))])
        t = np.concatenate(candidates)
        return float(max(np.abs(self.at(t, k)).max(), np.abs(self.at(t[t > a], k, "left")).max()))


def sines(rng, count, lowest, highest):
    frequencies = 2 * np.pi * rng.uniform(lowest, highest, count)
    amplitudes = rng.uniform(0.05, 0.8, count) * np.exp(2j * np.pi * rng.uniform(size=count))
    return Exponentials(amplitudes, 1j * frequencies)


def decays(rng):
    """A damped oscillation beside a slow drift."""
    ring = -rng.uniform(0.05, 0.5) + 2j * np.pi * rng.uniform(0.3, 2)
    return Exponentials(
        np.array([rng.uniform(0.2, 1) * np.exp(1j * rng.uniform(0, 6)), 0.5]), np.array([ring, -0.1])
    )


REST_TO_REST = {5: (0, 0, 0, 10, -15, 6), 7: (0, 0, 0, 0, 35, -84, 70, -20)}


def moves(rng, count, degree, rest):
    """Moves from rest to rest and back by polynomials of degree 5 (the jerk jumps) or 7 (the snap jumps)."""
    breaks, rows, q = [0.0], [], 0.0
    for i in range(count):
        if rest:
            rows.append([q] + [0.0] * degree)
            breaks.append(breaks[-1] + rest * rng.uniform(0.7, 1.3))
        span, height = rng.uniform(0.5, 2.0), rng.uniform(0.2, 1.0) * (-1) ** i
        rows.append([height * c / span**j for j, c in enumerate(REST_TO_REST[degree])])
        rows[-1][0] += q
        breaks.append(breaks[-1] + span)
        q += height
    return Pieces(np.array(breaks), np.array(rows))


def by_constant_derivative(order, spans, values):
    """q whose derivative `order` is constant by pieces and whose lower derivatives are continuous."""
    state, rows, breaks = np.zeros(order), [], [0.0]
    for span, value in zip(spans, values, strict=True):
        row = np.array([*(state / [float(factorial(j)) for j in range(order)]), value / factorial(order)])
        rows.append(row)
        state = [
            np.polynomial.polynomial.polyval(span, np.polynomial.polynomial.polyder(row, j))
            for j in range(order)
        ]
        state = np.array(state)
        breaks.append(breaks[-1] + span)
    return Pieces(np.array(breaks), np.array(rows))


def bang_bang(rng, count, rest):
    """Moves of constant jerk by pieces, from rest to rest, as time-optimal planners give them."""
    spans, values = [], []
    for i in range(count):
        sign, jerk = (-1) ** i, rng.uniform(5, 20)
        rise, hold, cruise = rng.uniform(0.15, 0.4), rng.uniform(0.05, 0.4), rng.uniform(0.05, 0.5)
        spans += ([rest * rng.uniform(0.7, 1.3)] if rest else []) + [
            rise,
            hold,
            rise,
            cruise,
            rise,
            hold,
            rise,
        ]
        values += ([0.0] if rest else []) + [sign * jerk * s for s in (1, 0, -1, 0, -1, 0, 1)]
    return by_constant_derivative(3, spans, values)


def random_pieces(rng, count, order, size):
    """The derivative `order` constant by random pieces."""
    return by_constant_derivative(order, rng.uniform(0.1, 0.5, count), rng.uniform(-size, size, count))


def motions(rng, rates, few=False):
    """(kind, motion, duration in s, samples a second)"""
    for rate in (50, *rates):
        for frequency in (0.1, 0.5, 1.5, 5.0):
            for duration in (10, 60) if few else (10, 60, 300):
                if duration * rate <= 60_000:
                    yield "sine", sines(rng, 1, 0.9 * frequency, 1.1 * frequency), duration, rate
    for rate in rates:
        for _ in range(3):
            yield "sum of sines", sines(rng, 5, 0.1, 2.0), 20, rate
            yield "decay", decays(rng), 10, rate
        for count in (1, 16) if few else (1, 5, 16, 30, 60):
            for rest in (0.0, 0.5):
                for degree in (5, 7):
                    motion = moves(rng, count, degree, rest)
                    yield f"moves of degree {degree}", motion, motion.breaks[-1], rate
                if count <= 20:
                    motion = bang_bang(rng, count, rest)
                    yield "bang-bang jerk", motion, motion.breaks[-1], rate
        for count in (4, 20) if few else (4, 20, 60):
            for kind, order, size in (("kinks", 3, 20), ("jumps of acceleration", 2, 3)):
                motion = random_pieces(rng, count, order, size)
                yield kind, motion, motion.breaks[-1], rate


@dataclass(frozen=True)
class Sampled:
    """A recording (t, q) of a motion, whose clock is `offset` ahead; wraps: angles in (−π, π]."""

    kind: str
    motion: object
    t: np.ndarray
    q: np.ndarray
    offset: float = 0.0
    wraps: bool = False


def recordings(seed, rates=(100, 1000), few=False):
    """Recordings of all kinds, each motion with noise 0, 1e-6 and 1e-4; of some as recorders spoil them."""
    rng = np.random.default_rng(seed)
    for number, (kind, motion, duration, rate) in enumerate(motions(rng, rates, few)):
        t = np.arange(int(duration * rate) + 1) / rate
        t = t[t <= duration]
        for noise in (0.0, 1e-6, 1e-4):
            yield Sampled(kind, motion, t, motion.at(t, 0) + noise * rng.normal(size=len(t)))
        if number % 5 == 1:
            yield from spoiled(rng, motion, t, rate)


def spoiled(rng, motion, t, rate):
    noise = float(rng.choice([0.0, 1e-6, 1e-4]))

    def noisy(times):
        return motion.at(times, 0) + noise * rng.normal(size=len(times))

    jittered = np.unique((t + rng.uniform(-0.3, 0.3, len(t)) / rate).clip(t[0], t[-1]))
    yield Sampled("jittered times", motion, jittered, noisy(jittered))
    keep, hole = np.ones(len(t), bool), int(len(t) * rng.uniform(0.2, 0.8))
    keep[hole : hole + int(0.2 * rate)] = False
    yield Sampled("gap", motion, t[keep], noisy(t[keep]))
    yield Sampled("wrapped", motion, t, (noisy(t) + 3 + np.pi) % (2 * np.pi) - np.pi, wraps=True)
    for bits in (14, 17, 20):
        step = 2 * np.pi / 2**bits
        yield Sampled(f"encoder of {bits} bits", motion, t, np.round(motion.at(t, 0) / step) * step)
    yield Sampled("epoch seconds", motion, t + 1.7e9, noisy(t), 1.7e9)
