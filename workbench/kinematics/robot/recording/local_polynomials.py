"""Compiled least-squares polynomials in windows of samples (t, q): derivatives with stated errors.

In a window of L samples the polynomials P₀, P₁, … are orthonormal on the samples, in u = (t − centre)/half:

    β₍ⱼ₊₁₎ P₍ⱼ₊₁₎(u) = (u − αⱼ) Pⱼ(u) − βⱼ P₍ⱼ₋₁₎(u),      cⱼ = Σᵢ qᵢ Pⱼ(uᵢ),

so times need not be uniform. The estimate of degree p of the k-th derivative at u and its stated error are

    Σ₍ⱼ≤p₎ cⱼ Pⱼ⁽ᵏ⁾(u),    z σ (Σ₍ⱼ≤p₎ Pⱼ⁽ᵏ⁾(u)²)^½ + κ Σ₍p−2<j≤p+4₎ (|cⱼ| + σ) |Pⱼ⁽ᵏ⁾(u)|:

the noise, and the bias that the next coefficients tell; both are divided by halfᵏ. σ is the deviation of what
no polynomial explains. All functions work on arrays of doubles that the caller allocates.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numba import njit

ORDERS = 7
"""Derivatives 0, …, 4, and two more that place a peak between samples."""

HIGHEST_DEGREE = 17
TAIL = 4  # coefficients after the last one used that count for the bias
KEPT = 2  # coefficients before the end of the sum that count for the bias
KAPPA = 2.0
LEAST = 12  # samples of a window


def compiled(function: Callable[..., Any], **options: Any) -> Callable[..., Any]:
    """Returns the function compiled by Numba, kept on disk where there is a place for it.

    Numba would not notice that a function of this module, which it calls, has changed since: what was kept
    before is removed.
    """
    try:
        made = njit(cache=True, **options)(function)
        changed = Path(__file__).stat().st_mtime
        for index in Path(made.stats.cache_path).glob(f"*.{function.__name__}-*.nbi"):
            if index.stat().st_mtime < changed:
                index.unlink(missing_ok=True)
        return made
    except (RuntimeError, OSError):
        return njit(**options)(function)


@compiled
def basis(
    t: np.ndarray, first: int, count: int, degree: int, alpha: np.ndarray, beta: np.ndarray
) -> tuple[float, float]:
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


def _project(
    t: np.ndarray,
    q: np.ndarray,
    first: int,
    count: int,
    degree: int,
    alpha: np.ndarray,
    beta: np.ndarray,
    centre: float,
    half: float,
    c: np.ndarray,
    work: np.ndarray,
) -> tuple[float, float]:
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
def basis_derivatives(
    u: float, count: int, degree: int, alpha: np.ndarray, beta: np.ndarray, P: np.ndarray
) -> None:
    """Fills P[j, k] = dᵏPⱼ/duᵏ at u, by k derivatives of the recurrence."""
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
def least_error(
    c: np.ndarray,
    degree: int,
    offset: float,
    half: float,
    sigma: float,
    P: np.ndarray,
    z: float,
    estimate: np.ndarray,
    error: np.ndarray,
) -> None:
    """Fills the estimate of the degree with the least stated error for each order, at the point with basis
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
def degree_of(count: int) -> int:
    """Returns the degree of the basis in a window of so many samples."""
    return min(HIGHEST_DEGREE, count - 1 if count <= 16 else count - 5)


@compiled
def mean_squares(t: np.ndarray, q: np.ndarray, count: int, degree: int, found: np.ndarray) -> None:
    """Fills the mean squares that polynomials leave in windows of `count` samples, one each half window."""
    alpha, beta, c = np.zeros(degree + 2), np.zeros(degree + 2), np.zeros(degree + 1)
    work = np.zeros((3, count))
    for w in range(len(found)):
        first = min(w * (count // 2), len(t) - count)
        centre, half = basis(t, first, count, degree, alpha, beta)
        _, square = project(t, q, first, count, degree, alpha, beta, centre, half, c, work)
        found[w] = square / (count - degree - 1)


@compiled
def window_sigma(degree: int, square: float, first: int, count: int, sums: np.ndarray, floor: float) -> float:
    """Returns the deviation of the noise in a window; infinite where the polynomial leaves more than the
    noise.

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
def keep_better(
    at: int,
    e: np.ndarray,
    s: np.ndarray,
    count: int,
    estimates: np.ndarray,
    errors: np.ndarray,
    counts: np.ndarray,
) -> int:
    """Takes the estimates with smaller errors for the sample `at`; returns how many improved by a tenth."""
    improved = 0
    for k in range(ORDERS):
        if s[k] < errors[k, at]:
            if s[k] < 0.9 * errors[k, at] and k < 5:
                improved += 1
            errors[k, at], estimates[k, at], counts[k, at] = s[k], e[k], count
    return improved


@compiled
def windows_of_size(
    t: np.ndarray,
    q: np.ndarray,
    first: int,
    last: int,
    count: int,
    is_uniform: bool,
    floor: float,
    sums: np.ndarray,
    z: float,
    estimates: np.ndarray,
    errors: np.ndarray,
    counts: np.ndarray,
) -> int:
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
def fit_windows(
    t: np.ndarray,
    q: np.ndarray,
    first: int,
    last: int,
    is_uniform: bool,
    floor: float,
    sums: np.ndarray,
    z: float,
    estimates: np.ndarray,
    errors: np.ndarray,
    counts: np.ndarray,
) -> None:
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
