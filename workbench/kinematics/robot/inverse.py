"""Joint velocities and their derivatives from a prescribed twist with its derivatives."""

from __future__ import annotations

from collections.abc import Callable
from numbers import Real
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.robot.states import States
from workbench.kinematics.robot.structure import Structure, is_whole, reals


class SingularJacobian(ValueError):
    """No or not one answer: the rows of the Jacobian are dependent. `singular_values` (..., rows)."""

    def __init__(self, message: str, singular_values: np.ndarray):
        super().__init__(message)
        self.singular_values = singular_values


class Task(NamedTuple):
    """Which twist is prescribed: of a body, `expressed` and at the point as `RobotFrame.jacobian` has it, or
    relative to another body and in its axes; rows: which of the six numbers (ω; v)."""

    body: str
    expressed: str
    point: ArrayLike
    rows: tuple[int, ...]
    relative_to: str | None

    def check(self) -> None:
        rows = self.rows
        if len(set(rows)) != len(rows) or not rows or not all(is_whole(i) and 0 <= i < 6 for i in rows):
            raise ValueError(f"rows: expected different numbers from 0 to 5 (ω then v), got {rows}")
        if self.relative_to is not None and (self.expressed != "mixed" or np.any(self.point)):
            raise ValueError(
                "relative_to: expected no `expressed` and no `point` beside it: the twist is that of the "
                "body's origin in the other body's axes"
            )

    def jacobian(self, states: States) -> np.ndarray:
        """Returns (..., rows, velocities)"""
        frame = states.frame(self.body)
        if self.relative_to is not None:
            relative: Any = frame.relative_to(states.frame(self.relative_to))
            J = relative.jacobian()
        else:
            J = frame.jacobian(0, expressed=self.expressed, point=self.point)
        return J[..., list(self.rows), :]

    def velocity(self, states: States, k: int) -> np.ndarray:
        """Returns the k-th derivative of the twist, (..., rows)."""
        frame = states.frame(self.body)
        if self.relative_to is not None:
            V = frame.relative_to(states.frame(self.relative_to)).twists[k]
        else:
            V = frame.velocity(k, expressed=self.expressed, point=self.point)
        return V[..., list(self.rows)]


class DampedInverse(NamedTuple):
    """rates (N, ..., velocities); residual (N, ..., rows): the prescribed twist less the one reached."""

    rates: np.ndarray
    residual: np.ndarray


Solve = Callable[[np.ndarray, np.ndarray], np.ndarray]


def inverse_kinematics(
    robot: Structure,
    task: Task,
    q: ArrayLike,
    twist_derivatives: ArrayLike,
    *,
    weight: ArrayLike | None,
    null_space: ArrayLike | None,
    rtol: float,
) -> np.ndarray:
    """See `Robot.inverse`."""
    if not 0 <= rtol < 1:
        raise ValueError(f"rtol: expected 0 <= rtol < 1, got {rtol}")

    def solver(J: np.ndarray, scale: np.ndarray) -> Solve:
        return _Solver(J, scale, rtol)

    return _order_by_order(robot, task, q, twist_derivatives, weight, null_space, solver).rates


def damped_inverse(
    robot: Structure,
    task: Task,
    q: ArrayLike,
    twist_derivatives: ArrayLike,
    *,
    damping: float,
    weight: ArrayLike | None,
    null_space: ArrayLike | None,
) -> DampedInverse:
    """See `Robot.inverse_damped`."""
    if not (isinstance(damping, Real) and 0 < damping < np.inf):
        raise ValueError(f"damping: expected a number > 0, got {damping!r}")

    def solver(J: np.ndarray, scale: np.ndarray) -> Solve:
        U, s, Vt = np.linalg.svd(J * scale, full_matrices=False)
        inverse = Vt.swapaxes(-1, -2) * (s / (s * s + damping**2))[..., None, :] @ U.swapaxes(-1, -2)

        def solve(b: np.ndarray, preferred: np.ndarray) -> np.ndarray:
            missing = b - (J @ preferred[..., None])[..., 0]
            return preferred + scale * (inverse @ missing[..., None])[..., 0]

        return solve

    return _order_by_order(robot, task, q, twist_derivatives, weight, null_space, solver)


def _order_by_order(
    robot: Structure,
    task: Task,
    q: ArrayLike,
    twist_derivatives: ArrayLike,
    weight: ArrayLike | None,
    null_space: ArrayLike | None,
    solver: Callable[[np.ndarray, np.ndarray], Solve],
) -> DampedInverse:
    """Returns the velocities, by solving V⁽ᵏ⁾ = J v⁽ᵏ⁾ + Σᵢ≥₁ C(k,i) J⁽ⁱ⁾ v⁽ᵏ⁻ⁱ⁾ for v⁽ᵏ⁾, order by order.

    The sum is V⁽ᵏ⁾ of the motion with v⁽ᵏ⁾ = 0.
    """
    q, wanted = reals(q, "q"), reals(twist_derivatives, "twist_derivatives")
    task.check()
    rows = len(task.rows)
    if wanted.shape[1:] != (*q.shape[:-1], rows) or len(wanted) < 1:
        expected = ", ".join(map(str, ("N", *q.shape[:-1], rows)))
        raise ValueError(
            f"twist_derivatives: expected shape ({expected}), the order first, got {wanted.shape}"
        )
    count = len(robot.velocities)
    scale = np.ones(count) if weight is None else reals(weight, "weight")
    if scale.shape != (count,) or not (scale > 0).all():
        raise ValueError(f"weight: expected {count} numbers > 0, one a velocity, got {weight!s}")
    shape = (len(wanted), *q.shape[:-1], count)
    preferred = np.zeros(shape) if null_space is None else reals(null_space, "null_space")
    if preferred.shape != shape:
        raise ValueError(f"null_space: expected shape {shape}, got {preferred.shape}")
    rates, residual = np.zeros(shape), np.zeros(wanted.shape)
    J = task.jacobian(States(robot, *robot.state(q, rates[:1])))
    solve = solver(J, 1 / np.sqrt(scale))
    for k in range(len(wanted)):
        bias = task.velocity(States(robot, *robot.state(q, rates[: k + 1])), k)
        rates[k] = solve(wanted[k] - bias, preferred[k])
        residual[k] = wanted[k] - bias - (J @ rates[k][..., None])[..., 0]
    return DampedInverse(rates, residual)


class _Solver:
    """J v = b for v nearest to a preferred one in the norm Σ (vᵢ / sᵢ)²."""

    def __init__(self, J: np.ndarray, scale: np.ndarray, rtol: float):
        self.J, self.scale = J, scale
        U, s, Vt = np.linalg.svd(J * scale, full_matrices=False)
        rows, columns = J.shape[-2:]
        if rows > columns or (s[..., -1] <= rtol * s[..., 0]).any():
            where = np.unravel_index(np.argmin(s[..., -1] / np.maximum(s[..., 0], 1e-300)), s.shape[:-1])
            values = ", ".join(f"{x:.3g}" for x in s[where])
            state = f" at state {tuple(map(int, where))}" if where else ""
            raise SingularJacobian(
                f"singular Jacobian{state}: expected {rows} independent rows of {columns} velocities "
                f"(smallest singular value > {rtol:g} of the largest), got the singular values {values}",
                s,
            )
        self.inverse = Vt.swapaxes(-1, -2) / s[..., None, :] @ U.swapaxes(-1, -2)

    def __call__(self, b: np.ndarray, preferred: np.ndarray) -> np.ndarray:
        missing = b - (self.J @ preferred[..., None])[..., 0]
        return preferred + self.scale * (self.inverse @ missing[..., None])[..., 0]
