"""Compiled least-squares polynomials in windows of samples (t, q): derivatives with stated errors, and
breaks.

In a window of L samples the polynomials P₀, P₁, … are orthonormal on the samples, in u = (t − centre)/half:

    β₍ⱼ₊₁₎ P₍ⱼ₊₁₎(u) = (u − αⱼ) Pⱼ(u) − βⱼ P₍ⱼ₋₁₎(u),      cⱼ = Σᵢ qᵢ Pⱼ(uᵢ),

so times need not be uniform. The estimate of degree p of the k-th derivative at u and its stated error are

    Σ₍ⱼ≤p₎ cⱼ Pⱼ⁽ᵏ⁾(u),    z σ (Σ₍ⱼ≤p₎ Pⱼ⁽ᵏ⁾(u)²)^½ + κ Σ₍p−2<j≤p+4₎ (|cⱼ| + σ) |Pⱼ⁽ᵏ⁾(u)|:

the noise, and the bias that the next coefficients tell; both are divided by halfᵏ. σ is the deviation of what
no polynomial explains. All functions work on arrays of doubles that the caller allocates.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numba import njit

ORDERS = 7
"""Derivatives 0, …, 4, and two more that place a peak between samples."""

HIGHEST_DEGREE = 17
TAIL = 4  # coefficients after the last one used that count for the bias
KEPT = 2  # coefficients before the end of the sum that count for the bias
KAPPA = 2.0
LEAST = 12  # samples of a window
SIDE_DEGREE = 7  # of the polynomials on both sides of a break
EXCESS = 1.1  # of what a polynomial leaves over the noise, beside its scatter
BREAK_SAMPLES = 160  # on each side of a break, at most


def compiled(function: Callable, **options: bool) -> Callable:
    """The function compiled by Numba, kept on disk where there is a place for it."""
    try:
        return njit(cache=True, **options)(function)
    except RuntimeError:  # no directory that can be written
        return njit(**options)(function)


@compiled
def basis(t, first, count, degree, alpha, beta):
    """Fills α and β of the samples first, …, first + count − 1; returns (centre, half) of the window in s."""
    centre = 0.5 * (t[first] + t[first + count - 1])
    half = 0.5 * (t[first + count - 1] - t[first])
    before, now = np.zeros(count), np.full(count, 1 / np.sqrt(count))
    beta[0] = 0.0
    for j in range(degree + 1):
        mean = 0.0
        for i in range(count):
            mean += (t[first + i] - centre) / half * now[i] * now[i]
        alpha[j] = mean
        square = 0.0
        for i in range(count):
            x = ((t[first + i] - centre) / half - mean) * now[i] - beta[j] * before[i]
            before[i] = x
            square += x * x
        norm = np.sqrt(square)
        beta[j + 1] = norm
        for i in range(count):
            x = before[i] / norm
            before[i] = now[i]
            now[i] = x
    return centre, half


def _project(t, q, first, count, degree, alpha, beta, centre, half, c, work):
    """Fills the coefficients c[0..degree] of q − q(middle sample); returns (that q, Σ of the squared
    residuals)."""
    offset = q[first + count // 2]
    before, now, rest = work[0], work[1], work[2]
    start = 1 / np.sqrt(count)
    for i in range(count):
        before[i], now[i], rest[i] = 0.0, start, q[first + i] - offset
    inverse = 1 / half
    for j in range(degree + 1):
        s = 0.0
        for i in range(count):
            s += rest[i] * now[i]
        c[j] = s
        a, b, b_next = alpha[j], beta[j], 1 / beta[j + 1]
        for i in range(count):
            rest[i] -= s * now[i]
            x = (((t[first + i] - centre) * inverse - a) * now[i] - b * before[i]) * b_next
            before[i] = now[i]
            now[i] = x
    square = 0.0
    for i in range(count):
        square += rest[i] * rest[i]
    return offset, square


project = compiled(_project, fastmath=True)


@compiled
def basis_derivatives(u, count, degree, alpha, beta, P):
    """P[j, k] = dᵏPⱼ/duᵏ at u, by k derivatives of the recurrence."""
    P[0, :] = 0.0
    P[0, 0] = 1 / np.sqrt(count)
    for j in range(degree):
        for k in range(ORDERS):
            x = (u - alpha[j]) * P[j, k]
            if k > 0:
                x += k * P[j, k - 1]
            if j > 0:
                x -= beta[j] * P[j - 1, k]
            P[j + 1, k] = x / beta[j + 1]


@compiled
def least_error(c, degree, offset, half, sigma, P, z, estimate, error):
    """Of each order, the estimate of the degree whose stated error is least, at the point whose basis is
    P."""
    for k in range(ORDERS):
        unit = half**-k
        total, square = (offset if k == 0 else 0.0), 0.0
        estimate[k], error[k] = 0.0, np.inf
        for p in range(degree - 1):
            total += c[p] * P[p, k] * unit
            square += P[p, k] ** 2
            if p < k:
                continue
            bias = 0.0
            for j in range(max(k, p + 1 - KEPT), min(degree, p + TAIL) + 1):
                bias += (abs(c[j]) + sigma) * abs(P[j, k])
            e = (z * sigma * np.sqrt(square) + KAPPA * bias) * unit
            if e < error[k]:
                estimate[k], error[k] = total, e


@compiled
def degree_of(count):
    """The degree of the basis in a window of so many samples."""
    return min(HIGHEST_DEGREE, count - 1 if count <= 16 else count - 5)


@compiled
def mean_squares(t, q, count, degree, found):
    """Fills the mean squares that polynomials leave in windows of `count` samples, one each half window."""
    alpha, beta, c = np.zeros(degree + 2), np.zeros(degree + 2), np.zeros(degree + 1)
    work = np.zeros((3, count))
    for w in range(len(found)):
        first = min(w * (count // 2), len(t) - count)
        centre, half = basis(t, first, count, degree, alpha, beta)
        _, square = project(t, q, first, count, degree, alpha, beta, centre, half, c, work)
        found[w] = square / (count - degree - 1)


@compiled
def window_sigma(degree, square, first, count, sums, floor):
    """The deviation of the noise in a window; infinite where the polynomial leaves more than the noise.

    sums[i]: the sum of the local variances of the samples before i.
    """
    freedom = count - degree - 1
    expected = max(floor**2, (sums[first + count] - sums[first]) / count)
    if freedom < 4:
        return np.sqrt(expected)
    left = square / freedom
    if left > expected * (1 + 4 * np.sqrt(2 / freedom)):
        return np.inf
    return np.sqrt(max(left, expected))


@compiled
def keep_better(at, e, s, count, estimates, errors, counts):
    """Takes the estimates with smaller errors for the sample `at`; returns how many improved by a tenth."""
    improved = 0
    for k in range(ORDERS):
        if s[k] < errors[k, at]:
            if s[k] < 0.9 * errors[k, at] and k < 5:
                improved += 1
            errors[k, at], estimates[k, at], counts[k, at] = s[k], e[k], count
    return improved


@compiled
def windows_of_size(t, q, first, last, count, is_uniform, floor, sums, z, estimates, errors, counts):
    """Estimates from all windows of `count` samples at quarter strides; returns how many improved."""
    degree = degree_of(count)
    alpha, beta, c = np.zeros(degree + 2), np.zeros(degree + 2), np.zeros(degree + 1)
    work, e, s = np.zeros((3, count)), np.zeros(ORDERS), np.zeros(ORDERS)
    table = np.zeros((count if is_uniform else 1, HIGHEST_DEGREE + 1, ORDERS))
    improved, a = 0, first
    centre, half = basis(t, a, count, degree, alpha, beta)
    if is_uniform:
        for i in range(count):
            basis_derivatives((t[a + i] - centre) / half, count, degree, alpha, beta, table[i])
    while True:
        if is_uniform:
            centre = 0.5 * (t[a] + t[a + count - 1])
        elif a > first:
            centre, half = basis(t, a, count, degree, alpha, beta)
        offset, square = project(t, q, a, count, degree, alpha, beta, centre, half, c, work)
        sigma = window_sigma(degree, square, a, count, sums, floor)
        low = 0 if a == first else (3 * count) // 8 - 1
        high = count if a + count == last else count - (3 * count) // 8 + 1
        for i in range(low, high if sigma < np.inf else low):
            P = table[i if is_uniform else 0]
            if not is_uniform:
                basis_derivatives((t[a + i] - centre) / half, count, degree, alpha, beta, P)
            least_error(c, degree, offset, half, sigma, P, z, e, s)
            improved += keep_better(a + i, e, s, count, estimates, errors, counts)
        if a + count == last:
            return improved
        a = min(a + max(1, count // 4), last - count)


@compiled
def fit_windows(t, q, first, last, is_uniform, floor, sums, z, estimates, errors, counts):
    """Fills estimates, errors and window sizes (ORDERS, samples) of first, …, last − 1, a stretch without
    breaks, from windows of 12, 18, 27, 54, … samples, until two sizes in a row improve nothing."""
    n = last - first
    count, idle = min(LEAST, n), 0
    while True:
        improved = windows_of_size(
            t, q, first, last, count, is_uniform, floor, sums, z, estimates, errors, counts
        )
        idle = idle + 1 if improved < 1 + n // 1000 else 0
        if count == n or idle >= 2:
            return
        count = min(n, count * 2 if count > 24 else count * 3 // 2)


@compiled
def misfit(t, q, first, count, floor):
    """How far the coefficients beyond degree 7 (of up to 11) and the residuals exceed the noise, as a
    ratio."""
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
def longest_fit(t, q, first, last, floor):
    """The longest stretch from `first` on that a polynomial of degree 7 fits, in samples."""
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
def one_side(t, q, first, last, before, at, floor, sums, z, estimate, error):
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
def best_cut(t, q, low, guess, high):
    """The first sample behind the cut, at or before the guess, where polynomials on both sides leave least
    per degree of freedom."""
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


def _remove(rest, column, columns, used):
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
def two_sided(t, low, high, at, columns, used, rest, squares):
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
def scan_break(t, q, low, high, first, last, parts, squares, places):
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
