"""Time scaling: the least uniform slowdown of a path for given limits, and a time law within the limits.

Uniform: q(t/λ) has the k-th derivative q⁽ᵏ⁾/λᵏ, and so have the points and the rotations of its bodies. The
least λ is the largest of (size/limit)^(1/k) over all limits of all orders k (Hollerbach 1984, for velocity
and acceleration). Otherwise a time law s(t) slows down only where it must: its slowness λ(s) = dt/ds is a
spline of degree 5, so that the derivatives of q(s(t)) are continuous to the order 5 where those of q(s) are.
"""

from __future__ import annotations

from collections.abc import Callable
from math import factorial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from scipy.interpolate import BSpline

from workbench.drake.joint_paths import Path
from workbench.kinematics.robot.derivative_names import order_name
from workbench.kinematics.robot.joint_limits import known_limits
from workbench.kinematics.robot.peaks import Asked, Peak
from workbench.kinematics.robot.states import states_on_path
from workbench.kinematics.robot.trajectories.exact_peaks import sizes_on
from workbench.kinematics.robot.trajectories.path_peaks import asked_of, peaks
from workbench.kinematics.robot.trajectories.paths import RecordedPath
from workbench.kinematics.robot.trajectories.sampled_path import SampledPath

if TYPE_CHECKING:
    from workbench.kinematics.robot.joint_limits import LimitTables
    from workbench.kinematics.robot.states import States

DEGREE = 5  # of the slowness
PIECES = (6, 12, 24, 48)  # of the slowness, tried in turn: the shortest path counts
ROUNDS = 12  # of adjusting the slowness
SAMPLES = 24  # a piece, at which the limits are looked at meanwhile
LEAST = 0.02  # of the largest slowness
MARGIN = 1e-9  # relative, of the limits


NeedOn = Callable[[Path, np.ndarray], np.ndarray]
"""The factor that each time on a path asks for."""


class Slowdown(NamedTuple):
    """factor: the least one by which to stretch the times (below 1 the path can be faster); peak: the
    quantity that asks for it."""

    factor: float
    peak: Peak


def slowdown(
    motion: States,
    body: str | None,
    point: ArrayLike,
    limits: LimitTables | None,
    relative_to: str | None,
) -> Slowdown:
    """See `Motion.slowdown`."""
    _require_orders(motion, limits)
    found = [peak for peak in peaks(motion, body, point, limits, relative_to) if peak.limit is not None]
    for peak in found:
        if peak.order == 0 and peak.within is not True:
            raise ValueError(f"no slowdown keeps this limit: {peak}")
        if not np.isfinite(peak.at_most) or (peak.limit == 0 and peak.at_most > 0):
            raise ValueError(f"no slowdown is sure to keep this limit: {peak}")
    found = [peak for peak in found if peak.order > 0 and peak.at_most > 0]
    if not found:
        raise ValueError("limits: expected at least one of a derivative that is not 0, got none")
    need, worst = max(((_need(peak), peak) for peak in found), key=lambda pair: pair[0])
    return Slowdown(need, worst)


def _require_orders(motion: States, limits: LimitTables | None) -> None:
    orders = {order_name(n): n for n in range(1, 5)} | {"deceleration": 2}
    for name, kinds in known_limits(motion.robot, limits).items():
        for kind in kinds:
            if orders.get(kind, 0) > motion.order:
                raise ValueError(
                    f"limits: expected a motion of order {orders[kind]} or more for the {kind} of {name!r}, "
                    f"got order {motion.order}"
                )


def _need(peak: Peak) -> float:
    assert peak.limit is not None
    return float((peak.at_most / peak.limit) ** (1 / peak.order))


def slowed(path: Path, factor: float) -> Path:
    """Returns the path in times that are `factor` as long, from the same start: q(t₀ + (t − t₀)/factor); of a
    recording the recording with those times. Raises ValueError for a factor that is not positive.

    >>> from workbench.kinematics import waypoints
    >>> slowed(waypoints([0.0, 1.0], [[0.0], [1.0]]), 2).end
    2.0
    """
    if not (np.isreal(factor) and 0 < factor < np.inf):
        raise ValueError(f"factor: expected a positive number, got {factor!r}")
    start = path.start if np.isfinite(path.start) else 0.0
    if isinstance(path, RecordedPath):
        return RecordedPath(start + factor * (path.times - start), path.samples, path.names)
    return SlowedPath(path, float(factor), start)


class SlowedPath(Path):
    """q(t₀ + (t − t₀)/factor) of another path; breaks in s as that path's."""

    def __init__(self, path: Path, factor: float, origin: float):
        self.path, self.factor, self.origin, self.joints = path, factor, origin, path.joints
        self.start, self.end = (origin + factor * (end - origin) for end in (path.start, path.end))
        self.breaks = origin + factor * (np.asarray(getattr(path, "breaks", ()), dtype=float) - origin)

    def derivatives(self, t: ArrayLike, order: int) -> np.ndarray:
        return self._scaled(self.path.derivatives(self._earlier(t), order))

    def magnitudes(self, t: ArrayLike, order: int) -> np.ndarray:
        return self._scaled(self.path.magnitudes(self._earlier(t), order))

    def _earlier(self, t: ArrayLike) -> np.ndarray:
        earlier = self.origin + (np.asarray(t, dtype=float) - self.origin) / self.factor
        return np.clip(earlier, *self._rounded_ends(t, earlier))

    def _rounded_ends(self, t: ArrayLike, earlier: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Returns the bounds that clip times which only rounding has moved out of the path."""
        inside = (np.asarray(t) >= self.start) & (np.asarray(t) <= self.end)
        return np.where(inside, self.path.start, earlier), np.where(inside, self.path.end, earlier)

    def _scaled(self, values: np.ndarray) -> np.ndarray:
        powers = self.factor ** -np.arange(float(len(values)))
        return values * powers.reshape(-1, *[1] * (values.ndim - 1))


class RetimedPath(SampledPath):
    """q(s(t)), t from 0 to the end in s, of a path q(s) (Drake's PathParameterizedTrajectory).

    slowness: the spline λ(s) = dt/ds > 0. breaks: the times of the path's breaks and of the spline's
    knots."""

    def __init__(self, path: Path, slowness: BSpline):
        self.path, self.slowness, self.joints = path, slowness, path.joints
        self._times = slowness.antiderivative()
        degree = slowness.k
        knots = np.unique(slowness.t[degree : len(slowness.t) - degree])
        self._first, self._last = float(knots[0]), float(knots[-1])
        self._table = np.unique(np.linspace(knots[:-1], knots[1:], 9))
        self._at_table = self._time(self._table)
        self.start, self.end = 0.0, float(self._at_table[-1])
        breaks = np.asarray(getattr(path, "breaks", ()), dtype=float)
        inner = np.concatenate([breaks[(breaks > knots[0]) & (breaks < knots[-1])], knots[1:-1]])
        self.breaks = self._time(np.unique(inner))

    def _time(self, s: np.ndarray) -> np.ndarray:
        return self._times(s) - self._times(self._first)

    def parameter(self, t: ArrayLike) -> np.ndarray:
        """Returns s(t), the time on the path itself, by Newton's method in the bracket of a table."""
        t = self._inside(t)
        i = np.clip(np.searchsorted(self._at_table, t, side="right") - 1, 0, len(self._table) - 2)
        low, high = self._table[i], self._table[i + 1]
        s = np.interp(t, self._at_table, self._table)
        for _ in range(60):
            late = self._time(s) - t
            low, high = np.where(late < 0, s, low), np.where(late >= 0, s, high)
            step = s - late / self.slowness(s)
            following = np.where((step >= low) & (step <= high), step, (low + high) / 2)
            if (np.abs(following - s) <= 4 * np.spacing(max(abs(self._first), abs(self._last)))).all():
                return np.clip(following, self._first, self._last)
            s = following
        return np.clip(s, self._first, self._last)

    def derivatives(self, t: ArrayLike, order: int) -> np.ndarray:
        s = self.parameter(t)
        factorials = np.array([float(factorial(k)) for k in range(order + 1)])
        path = self.path.derivatives(s, order)
        if order == 0:
            return path
        degree = min(order, self.slowness.k + 1)
        slowness = [self.slowness(s, nu=k) / factorials[k] for k in range(degree)]
        series = _moved_series(slowness, order)
        scale = factorials.reshape(-1, *[1] * (path.ndim - 1))
        return _composed(path / scale, series[..., None]) * scale


def _moved_series(slowness: list[np.ndarray], order: int) -> np.ndarray:
    """Returns the Taylor coefficients (order + 1, ...) of s(t) − s₀ of λ(s) ds/dt = 1, λ's coefficients
    given."""
    moved = np.zeros((order + 1, *slowness[0].shape))
    moved[1] = 1 / slowness[0]
    coefficients = np.stack([*slowness, *[np.zeros_like(slowness[0])] * (order - len(slowness))])
    for k in range(1, order):  # (λ(s(t)) ṡ)₍ₖ₎ = 0
        along = _composed(coefficients[: k + 1], moved[: k + 1])
        known = sum(along[j] * (k - j + 1) * moved[k - j + 1] for j in range(1, k + 1))
        moved[k + 1] = -known / (slowness[0] * (k + 1))
    return moved


def _composed(outer: np.ndarray, inner: np.ndarray) -> np.ndarray:
    """Returns the coefficients of f(s₀ + g(t)), of those of f about s₀ and of g, g₀ = 0, by Horner's
    scheme."""
    count = len(outer)
    total = np.zeros_like(outer)
    total[0] = outer[-1]
    for k in range(count - 2, -1, -1):
        product = np.zeros_like(total)
        for j in range(1, count):
            product[j:] += inner[j] * total[: count - j]
        total = product
        total[0] = total[0] + outer[k]
    return total


def retimed(
    motion: States,
    body: str | None,
    point: ArrayLike,
    limits: LimitTables | None,
    relative_to: str | None,
) -> RetimedPath:
    """See `Motion.retimed`."""
    if isinstance(motion.path, RecordedPath):
        raise ValueError(
            "retimed: expected a path with exact derivatives, got a recording; see `slowdown` for its factor"
        )
    uniform = slowdown(motion, body, point, limits, relative_to).factor
    asked = [one for one in asked_of(motion, body, limits) if one.limit is not None and one.order > 0]
    start, end = float(motion.times.min()), float(motion.times.max())

    def need_on(path: Path, times: np.ndarray) -> np.ndarray:
        there = states_on_path(type(motion), motion.robot, path, times, motion.order)
        return _needs(sizes_on(there, body, point, relative_to, asked), asked)

    best = _finished(motion, _uniform(motion.path, start, end, uniform), (body, point, limits, relative_to))
    for pieces in PIECES:
        slowness = _adjusted(motion.path, np.linspace(start, end, pieces + 1), uniform, need_on)
        path = _finished(motion, RetimedPath(motion.path, slowness), (body, point, limits, relative_to))
        best = min(best, path, key=lambda one: one.end)
    return best


def _needs(sizes: np.ndarray, asked: list[Asked]) -> np.ndarray:
    """Returns the factor that each time asks for: the largest (size/limit)^(1/order) of sizes (asked,
    times)."""
    needs = [
        (size / one.limit) ** (1 / one.order) for size, one in zip(sizes, asked, strict=True) if one.limit
    ]
    return np.max(needs, axis=0)


def _spline(edges: np.ndarray, coefficients: np.ndarray) -> BSpline:
    knots = np.concatenate([[edges[0]] * DEGREE, edges, [edges[-1]] * DEGREE])
    return BSpline(knots, coefficients, DEGREE)


def _uniform(path: Path, start: float, end: float, factor: float) -> RetimedPath:
    return RetimedPath(path, _spline(np.array([start, end]), np.full(DEGREE + 1, factor)))


def _adjusted(path: Path, edges: np.ndarray, uniform: float, need_on: NeedOn) -> BSpline:
    """Returns a slowness that is near the least one: each coefficient grows or shrinks as what is needed
    near it says; the shortest one of the rounds, at the common factor that it needs besides."""
    count = len(edges) - 1 + DEGREE
    s = np.linspace(edges[0], edges[-1], SAMPLES * (len(edges) - 1) + 1)
    near = BSpline.design_matrix(s, _spline(edges, np.zeros(count)).t, DEGREE).toarray()
    near = near / near.max(axis=0)
    coefficients, best, least = np.full(count, uniform), np.full(count, uniform), np.inf
    for _ in range(ROUNDS):
        law = RetimedPath(path, _spline(edges, coefficients))
        needed = need_on(law, law._time(s).clip(0, law.end))
        factor = float(needed.max())
        if factor * law.end < least:
            best, least = factor * coefficients, factor * law.end
        shares = (needed[:, None] * (near > 0.4)).max(axis=0)
        coefficients = coefficients * np.clip(shares, 0.6, 1.6) ** 0.7
        coefficients = np.maximum(coefficients, LEAST * coefficients.max())
    return _spline(edges, best)


def _finished(motion: States, path: RetimedPath, question: tuple[Any, ...]) -> RetimedPath:
    """Returns the path with the common factor that its peaks, found to the last digits, still need."""
    moving = states_on_path(
        type(motion), motion.robot, path, np.linspace(path.start, path.end, 201), motion.order
    )
    factor = slowdown(moving, *question).factor * (1 + MARGIN)
    return RetimedPath(path.path, BSpline(path.slowness.t, path.slowness.c * factor, DEGREE))
