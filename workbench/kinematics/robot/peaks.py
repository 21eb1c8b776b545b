"""Peaks of a motion along a path, compared with limits: the maximum of each derivative, if it is determined.

Along a formula or a Drake trajectory a peak is exact, unless a lower derivative jumps: then it has no bound.
Along a recording it has a stated error, or is not determined (`recorded_motion`).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import floor, log10
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.robot.derivative_names import order_name
from workbench.kinematics.robot.joint_limits import of_body

if TYPE_CHECKING:
    from workbench.kinematics.robot.robot_frames import PointMotion
    from workbench.kinematics.robot.states import States

WITHIN, BEYOND, NOT_DETERMINED = "within", "BEYOND", "not determined"
#: The part of a limit and of the largest size on the path by which a size may exceed a limit and be at it.
ROUNDING = 1e-10


@dataclass(frozen=True)
class Peak:
    """Where a quantity is largest on a path. `of`: a coordinate, "point" or "rotation" (see `of_body`);
    order: which derivative, 1 of a rotation being the angular velocity.

    value ± error: the largest |derivative|, at the time in s; infinite where a lower derivative jumps;
    error: infinite where the value is not determined. The size is at_least and at_most so large. limit:
    None where there is none. bound: "upper"; of order 0 "lower" or "upper", value being the coordinate at
    its least or greatest; "deceleration": of |q̈| where q̈ and q̇ have opposite signs. reason: why there is
    no value. span: the times in s that the value is of, where ends of a recording that are known less well
    are left out; at_least and at_most, and with them the verdict, are of all times. rounding: a size that
    exceeds the limit by less is at the limit, and within it.
    """

    of: str
    order: int
    value: float
    time: float
    limit: float | None
    unit: str
    bound: str = "upper"
    error: float = 0.0
    at_least: float = np.nan
    at_most: float = np.nan
    reason: str = ""
    span: tuple[float, float] | None = None
    rounding: float = 0.0

    @property
    def verdict(self) -> str | None:
        """Whether the peak keeps the limit: "within" if the largest possible value does, "BEYOND" if the
        least possible value does not, "not determined" otherwise; None without a limit."""
        if self.limit is None:
            return None
        sign = -1 if self.bound == "lower" else 1
        limit = sign * self.limit + self.rounding
        if self.at_most <= limit:
            return WITHIN
        return BEYOND if self.at_least > limit else NOT_DETERMINED

    @property
    def within(self) -> bool | None:
        """True for "within", False for "BEYOND", None for "not determined" and without a limit."""
        return None if self.verdict is None else {WITHIN: True, BEYOND: False}.get(self.verdict)

    @property
    def name(self) -> str:
        """Such as "jerk", "deceleration"."""
        return self.bound if self.bound == "deceleration" else order_name(self.order)

    def __str__(self) -> str:
        bound = self.bound if self.order == 0 else "upper"
        against = "" if self.limit is None else f", {bound} limit {self.limit:g}: {self.verdict}"
        return f"{self.name} of {self.of}: {self._size()}{against}"

    def _size(self) -> str:
        if self.value == np.inf:
            return f"unbounded: {self.reason}"
        if not np.isfinite(self.error):
            return f"not determined{self._bounds()}: {self.reason}"
        span = "" if self.span is None else f" (from {self.span[0]:.6g} to {self.span[1]:.6g} s)"
        return f"{with_error(self.value, self.error)} {self.unit} at {self.time:.6g} s{span}"

    def _bounds(self) -> str:
        """Returns the bounds of a size that is not determined, such as ", at least 10 rad/s^3"."""
        sign, words = (-1, ("at most", "at least")) if self.bound == "lower" else (1, ("at least", "at most"))
        bounds = list(zip(words, (self.at_least, self.at_most), strict=True))
        if self.order and self.at_least == 0:
            bounds = bounds[1:]
        told = [(word, value) for word, value in bounds if np.isfinite(value)]
        return "".join(f", {word} {sign * value:.4g} {self.unit}" for word, value in told)


def with_error(value: float, error: float) -> str:
    """Returns "30.0 ± 2.5": the value to the second digit of its error."""
    if error == 0 or value == 0:
        return f"{value:.6g}" if error == 0 else f"{value:g} ± {error:.2g}"
    digits = floor(log10(abs(value))) - floor(log10(error)) + 2
    return f"{value:#.{min(max(digits, 1), 16)}g}".rstrip(".") + f" ± {error:.2g}"


@dataclass(frozen=True)
class Asked:
    """A quantity whose peak is asked for.

    `of`, order, bound, unit, limit: as in `Peak`. position, velocity: the index of the coordinate and the
    velocity that it is a multiple of, None for what is of a body; the coordinate is factor · q + offset.
    """

    of: str
    order: int
    bound: str
    unit: str
    limit: float | None
    position: int | None = None
    velocity: int | None = None
    factor: float = 1.0
    offset: float = 0.0

    @property
    def threshold(self) -> float:
        """The bound for sizes: the limit; for a lower bound, whose size is −q, minus the limit."""
        if self.limit is None:
            return np.inf
        return -self.limit if self.bound == "lower" else self.limit

    def rounding(self, largest: float = 0.0) -> float:
        """See `Peak`; largest: of the sizes on the path."""
        return ROUNDING * max(abs(self.limit or 0.0), largest)


@dataclass(frozen=True)
class Violation:
    """An interval of time, from `start` to `end` in s, in which a quantity exceeds its limit.

    `of`, order, bound, limit, unit: as in `Peak`. value: the largest |derivative| in the interval, or the
    least coordinate for a lower bound, at the time in s; infinite where a lower derivative jumps. For a
    recording, the interval contains the samples that exceed the limit by more than their stated errors.
    """

    of: str
    order: int
    bound: str
    limit: float
    unit: str
    start: float
    end: float
    value: float
    time: float

    @property
    def name(self) -> str:
        """Such as "jerk", "deceleration", "lower"."""
        by_bound = self.order == 0 or self.bound == "deceleration"
        return self.bound if by_bound else order_name(self.order)

    def __str__(self) -> str:
        span = f"from {self.start:.6g} to {self.end:.6g} s"
        most = f"{self.value:.6g} at {self.time:.6g} s"
        return f"{self.name} of {self.of}: beyond {self.limit:g} {self.unit} {span}, {most}"


def violation(asked: Asked, start: float, end: float, value: float, time: float) -> Violation:
    """Returns the violation of what was asked, its size being −q of a lower bound."""
    assert asked.limit is not None
    signed = -value if asked.bound == "lower" else value
    return Violation(asked.of, asked.order, asked.bound, asked.limit, asked.unit, start, end, signed, time)


def stretches(flags: np.ndarray) -> list[tuple[int, int]]:
    """Returns the first and the last index of each run of true flags (n,)."""
    edges = np.diff(np.concatenate([[False], flags, [False]]).astype(int))
    firsts, ends = np.flatnonzero(edges == 1), np.flatnonzero(edges == -1)
    return list(zip(firsts.tolist(), (ends - 1).tolist(), strict=True))


def point_of(motion: States, body: str, point: ArrayLike, relative_to: str | None) -> PointMotion:
    """Returns the motion of a body's point, as another body sees it if `relative_to` names one."""
    frame = motion.frame(body)
    return (frame if relative_to is None else frame.relative_to(motion.frame(relative_to))).point(point)


def body_curves(
    motion: States, body: str | None, point: ArrayLike, relative_to: str | None
) -> dict[str, np.ndarray]:
    """Returns the curves of a body by the names of `of_body`: the derivatives (N + 1, ..., 3) of a point, and
    its angular velocity.

    The angular velocity and its derivatives start in row 1; row 0 is 0. The result is empty without a body.
    """
    if body is None:
        return {}
    moving = point_of(motion, body, point, relative_to)
    omega = moving.frame.twists[..., :3]
    curves = moving.derivatives, np.concatenate([np.zeros_like(omega[:1]), omega])
    return dict(zip(of_body(motion.robot), curves, strict=True))


def peak_at(asked: Asked, value: float, time: float, **options: Any) -> Peak:
    """Returns the peak of what was asked; the value of a lower bound is that of −q. Options: see `Peak`."""
    signed = -value if asked.bound == "lower" else value
    found = Peak(asked.of, asked.order, signed + 0.0, time, asked.limit, asked.unit, asked.bound)
    return replace(found, **({"at_least": value, "at_most": value} | options))
