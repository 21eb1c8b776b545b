"""The breaks of a recording: the times at which a derivative of order at most 4 jumps, and its order.

A stretch that one polynomial of degree 7 no longer fits is cut where two such polynomials leave least. It
is a break of order k if the fits of both sides differ in the k-th derivative by more than their stated
errors. Then a fit of both sides with the time of the break as an unknown decides whether the derivatives to
a higher order may be continuous:

    q(t) = Σ₍ⱼ≤7₎ bⱼ tʲ + Σ₍r≤j≤7₎ aⱼ (t − τ)₊ʲ:

the highest r that leaves no more than the noise explains, beside what r = 0 leaves, is the order.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from workbench.kinematics.robot.recording.break_fits import (
    BREAK_SAMPLES,
    SIDE_DEGREE,
    best_cut,
    longest_fit,
    one_side,
    scan_break,
)
from workbench.kinematics.robot.recording.local_polynomials import ORDERS

HIGHEST_BREAK = 4
APART = 1.2  # times the stated errors of both sides
LEAST_SIDE = 6  # samples beside a break
TOLERANCE = 1e-3  # the share of true breaks of order r that the noise makes look lower
REACH = 24  # samples to both sides, in which the time of a break is looked for


@dataclass(frozen=True)
class Found:
    """A break: its time in s, the first sample after it, and the order of the derivative that jumps."""

    time: float
    sample: int
    order: int


def find_breaks(
    t: np.ndarray, q: np.ndarray, first: int, last: int, floor: float, sums: np.ndarray, z: float
) -> list[Found]:
    """Returns the breaks of the samples first, …, last − 1; t in s, sums of local variances, floor of the
    noise."""
    found: list[Found] = []
    previous, a = first, first
    while True:
        b = a + longest_fit(t, q, a, last, floor)
        if b >= last - LEAST_SIDE:
            return found
        d = b + longest_fit(t, q, b, last, floor)
        cut = best_cut(t, q, a, b, d)
        order = None
        if cut - previous >= LEAST_SIDE and last - cut >= LEAST_SIDE:
            order = _jump(t, q, a, cut, d, floor, sums, z)
        if order is None:
            a = b - (b - a) // 2  # the stretch may end short of a break: the next one starts well before it
            continue
        one = _refined(t, q, max(a, previous), cut, d, floor, order)
        if not (one.sample - previous >= LEAST_SIDE and last - one.sample >= LEAST_SIDE):
            one = Found(0.5 * (t[cut - 1] + t[cut]), cut, order)
        if one.order <= HIGHEST_BREAK:
            found.append(one)
            previous = a = one.sample
        else:
            a = cut


def _jump(
    t: np.ndarray, q: np.ndarray, low: int, cut: int, high: int, floor: float, sums: np.ndarray, z: float
) -> int | None:
    """Returns the lowest order in which the fits of both sides differ by more than their errors, or None."""
    (left, le), (right, re) = np.zeros((2, 2, ORDERS))
    at, gap = 0.5 * (t[cut - 1] + t[cut]), t[cut] - t[cut - 1]
    one_side(t, q, low, cut, True, at, floor, sums, z, left, le)
    one_side(t, q, cut, high, False, at, floor, sums, z, right, re)
    apart = np.abs(left - right)
    for k in range(HIGHEST_BREAK + 1):
        if apart[k] > APART * (le[k] + re[k]):
            if k < HIGHEST_BREAK - 1 and apart[k] < gap * (apart[k + 1] + le[k + 1] + re[k + 1]):
                continue  # a jump of the next derivative, somewhere between the two samples
            return k
    return None


def _refined(t: np.ndarray, q: np.ndarray, low: int, cut: int, high: int, floor: float, order: int) -> Found:
    """Returns the break with the highest order that a fit of both sides with an unknown time allows."""
    from scipy.special import chdtri

    squares, places = np.zeros(SIDE_DEGREE + 2), np.zeros(SIDE_DEGREE + 2)
    low, high = max(low, cut - BREAK_SAMPLES), min(high, cut + BREAK_SAMPLES)
    first, last = max(low + LEAST_SIDE, cut - REACH), min(high - LEAST_SIDE, cut + REACH) + 1
    middle = Found(0.5 * (t[cut - 1] + t[cut]), cut, order)
    freedom = high - low - 2 * (SIDE_DEGREE + 1) - 1
    if freedom < 4 or last <= first:
        return middle
    scan_break(t, q, low, high, first, last, 2, squares, places)
    variance = max(squares[0] / freedom, floor**2)
    if squares[0] / freedom > floor**2 * 1.6 * (1 + 4 * np.sqrt(2 / freedom)):
        return middle  # both sides are no polynomials
    allowed = [
        r
        for r in range(order, SIDE_DEGREE + 2)
        if squares[r] - squares[0] <= variance * chdtri(r + 1, TOLERANCE)
    ]
    if not allowed or max(allowed) == order:
        return middle
    at = places[max(allowed)]
    return Found(at, int(np.searchsorted(t, at)), max(allowed))
