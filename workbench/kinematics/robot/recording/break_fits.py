"""Compiled fits on both sides of a break of samples (t, q), with the polynomials of `local_polynomials`.

They tell how far one polynomial reaches, where it breaks, and the derivatives of both sides there.
"""

from __future__ import annotations

import numpy as np

from workbench.kinematics.robot.recording.local_polynomials import (
    HIGHEST_DEGREE,
    LEAST,
    ORDERS,
    TAIL,
    basis,
    basis_derivatives,
    compiled,
    degree_of,
    least_error,
    project,
    window_sigma,
)

SIDE_DEGREE = 7  # of the polynomials on both sides of a break
EXCESS = 1.1  # of what a polynomial leaves over the noise, beside its scatter
BREAK_SAMPLES = 160  # on each side of a break, at most


@compiled
def misfit(t: np.ndarray, q: np.ndarray, first: int, count: int, floor: float) -> float:
    """Returns by which ratio the coefficients beyond degree 7 (up to 11) and the residuals exceed the
    noise."""
    degree = min(SIDE_DEGREE + TAIL, count - 3)
    alpha, beta, c = np.zeros(degree + 2), np.zeros(degree + 2), np.zeros(degree + 1)
    centre, half = basis(t, first, count, degree, alpha, beta)
    _, square = project(t, q, first, count, degree, alpha, beta, centre, half, c, np.zeros((3, count)))
    p = max(0, degree - TAIL)
    tail = 0.0
    for j in range(p + 1, degree + 1):
        tail += c[j] ** 2
    return np.sqrt((tail + square) / max(1, count - p - 1)) / floor


@compiled
def longest_fit(t: np.ndarray, q: np.ndarray, first: int, last: int, floor: float) -> int:
    """Returns the longest stretch from `first` on that a polynomial of degree 7 fits, in samples."""
    good, bad, count = min(LEAST, last - first), -1, min(LEAST, last - first)
    while count >= LEAST:
        if misfit(t, q, first, count, floor) < EXCESS + 4 / np.sqrt(count):
            good = count
            if first + count >= last:
                break
        else:
            bad = count
            if count == LEAST:
                break
        if bad > 0 and bad - good <= max(1, good // 16):
            break
        count = (good + bad) // 2 if bad > 0 else min(last - first, count + max(2, count // 2))
    return good


@compiled
def one_side(
    t: np.ndarray,
    q: np.ndarray,
    first: int,
    last: int,
    before: bool,
    at: float,
    floor: float,
    sums: np.ndarray,
    z: float,
    estimate: np.ndarray,
    error: np.ndarray,
) -> None:
    """Fills the best estimates at the time `at` from windows of first, …, last − 1 that end there (`before`)
    or start there."""
    degree = HIGHEST_DEGREE
    alpha, beta, c = np.zeros(degree + 2), np.zeros(degree + 2), np.zeros(degree + 1)
    P, e, s = np.zeros((degree + 1, ORDERS)), np.zeros(ORDERS), np.zeros(ORDERS)
    error[:] = np.inf
    count = min(LEAST, last - first)
    while count >= 6:
        degree = degree_of(count)
        a = last - count if before else first
        centre, half = basis(t, a, count, degree, alpha, beta)
        offset, square = project(t, q, a, count, degree, alpha, beta, centre, half, c, np.zeros((3, count)))
        basis_derivatives((at - centre) / half, count, degree, alpha, beta, P)
        sigma = window_sigma(degree, square, a, count, sums, floor)
        least_error(c, degree, offset, half, sigma, P, z, e, s)
        for k in range(ORDERS):
            if s[k] < error[k]:
                estimate[k], error[k] = e[k], s[k]
        if count == last - first:
            break
        count = min(last - first, count * 3 // 2)


@compiled
def best_cut(t: np.ndarray, q: np.ndarray, low: int, guess: int, high: int) -> int:
    """Returns the first sample after the cut, at or before the guess, that minimizes the residuals of
    polynomials on both sides per degree of freedom."""
    reach = max(12, min(60, (guess - low) // 3))
    lo, hi = max(low + 6, guess - reach), min(high - 6, guess + 3)
    best, where = np.inf, guess
    alpha, beta, c, work = np.zeros(9), np.zeros(9), np.zeros(8), np.zeros((3, 128))
    a, b = max(low, lo - 60), min(high, hi + 60)  # the same samples for every cut
    for cut in range(lo, hi + 1):
        total, freedom = 0.0, b - a
        for first, count in ((a, cut - a), (cut, b - cut)):
            degree = min(SIDE_DEGREE if count > 24 else 5, count - 2)
            if count > 126:
                first, count = (first + count - 126, 126) if first == a else (first, 126)
            centre, half = basis(t, first, count, degree, alpha, beta)
            total += project(t, q, first, count, degree, alpha, beta, centre, half, c, work)[1]
            freedom -= degree + 1
        total /= max(freedom, 1)
        if total < best:
            best, where = total, cut
    return where


def _remove(rest: np.ndarray, column: np.ndarray, columns: np.ndarray, used: int) -> bool:
    """Orthogonalizes the column against those before, twice, stores it, and takes it out of the rest. Returns
    whether it was independent of them."""
    length = len(rest)
    size = 0.0
    for i in range(length):
        size += column[i] * column[i]
    for _ in range(2):
        for j in range(used):
            s = 0.0
            for i in range(length):
                s += columns[j, i] * column[i]
            for i in range(length):
                column[i] -= s * columns[j, i]
    left = 0.0
    for i in range(length):
        left += column[i] * column[i]
    if left <= 1e-24 * size:
        return False
    s, inverse = 0.0, 1 / np.sqrt(left)
    for i in range(length):
        columns[used, i] = column[i] * inverse
        s += columns[used, i] * rest[i]
    for i in range(length):
        rest[i] -= s * columns[used, i]
    return True


remove = compiled(_remove, fastmath=True)


@compiled
def two_sided(
    t: np.ndarray,
    low: int,
    high: int,
    at: float,
    columns: np.ndarray,
    used: int,
    rest: np.ndarray,
    squares: np.ndarray,
) -> None:
    """Adds (t − at)₊ʲ, j = 7, …, 0, to the `used` columns; squares[r], r = 0, …, 7: the sum of the squared
    residuals with those of j >= r, where the derivatives r and higher may jump at the time `at`."""
    column, scale = np.zeros(high - low), max(t[high - 1] - at, 1e-300)
    for r in range(SIDE_DEGREE, -1, -1):
        for i in range(high - low):
            behind = (t[low + i] - at) / scale
            column[i] = behind**r if behind >= 0 else 0.0
        used += remove(rest, column, columns, used)
        squares[r] = (rest**2).sum()


@compiled
def scan_break(
    t: np.ndarray,
    q: np.ndarray,
    low: int,
    high: int,
    first: int,
    last: int,
    parts: int,
    squares: np.ndarray,
    places: np.ndarray,
) -> None:
    """Fits a polynomial of degree 7 plus Σ₍ⱼ≥r₎ aⱼ (t − τ)₊ʲ, j ≤ 7, to the samples low, …, high − 1, for τ
    at `parts` times in each interval before the samples first, …, last − 1.

    squares[r], r = 0, …, 8: the least sum of the squared residuals, places[r]: τ in s; 8: no break.
    """
    length = high - low
    centre, half = 0.5 * (t[low] + t[high - 1]), 0.5 * (t[high - 1] - t[low])
    columns, column, rest = np.zeros((2 * SIDE_DEGREE + 2, length)), np.zeros(length), np.zeros(length)
    for i in range(length):
        rest[i] = q[low + i] - q[low + length // 2]
    used = 0
    for j in range(SIDE_DEGREE + 1):
        for i in range(length):
            column[i] = ((t[low + i] - centre) / half) ** j
        used += remove(rest, column, columns, used)
    now = np.zeros(SIDE_DEGREE + 1)
    squares[:] = np.inf
    squares[SIDE_DEGREE + 1] = (rest**2).sum()
    for i in range(first, last):
        for part in range(1, parts + 1):
            at = t[i - 1] + (t[i] - t[i - 1]) * part / parts
            two_sided(t, low, high, at, columns, used, rest.copy(), now)
            for r in range(SIDE_DEGREE + 1):
                if now[r] < squares[r]:
                    squares[r], places[r] = now[r], at
