"""Joint velocities and their derivatives from a prescribed twist with its derivatives."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.robot.states import States
from workbench.kinematics.robot.structure import Structure, is_whole, reals


class SingularJacobian(ValueError):
    """No or not one answer: the rows of the Jacobian are dependent. `singular_values` (..., rows)."""

    def __init__(self, message: str, singular_values: np.ndarray):
        super().__init__(message)
        self.singular_values = singular_values


def inverse_kinematics(
    robot: Structure,
    body: str,
    q: ArrayLike,
    twist_derivatives: ArrayLike,
    *,
    weight: ArrayLike | None,
    null_space: ArrayLike | None,
    expressed: str,
    point: ArrayLike,
    rows: tuple[int, ...],
    rtol: float,
) -> np.ndarray:
    """See `Robot.inverse`. Order by order V⁽ᵏ⁾ = J v⁽ᵏ⁾ + Σᵢ≥₁ C(k,i) J⁽ⁱ⁾ v⁽ᵏ⁻ⁱ⁾ is solved for v⁽ᵏ⁾:
    the sum is what the motion with v⁽ᵏ⁾ = 0 has for V⁽ᵏ⁾."""
    q, wanted = reals(q, "q"), reals(twist_derivatives, "twist_derivatives")
    if not 0 <= rtol < 1:
        raise ValueError(f"rtol: expected 0 <= rtol < 1, got {rtol}")
    if len(set(rows)) != len(rows) or not rows or not all(is_whole(i) and 0 <= i < 6 for i in rows):
        raise ValueError(f"rows: expected different numbers from 0 to 5 (ω then v), got {rows}")
    if wanted.shape[1:] != (*q.shape[:-1], len(rows)) or len(wanted) < 1:
        expected = ", ".join(map(str, ("N", *q.shape[:-1], len(rows))))
        raise ValueError(
            f"twist_derivatives: expected shape ({expected}), the order first, got {wanted.shape}"
        )
    count = len(robot.velocities)
    scale = np.ones(count) if weight is None else reals(weight, "weight")
    if scale.shape != (count,) or not (scale > 0).all():
        raise ValueError(f"weight: expected {count} numbers > 0, one a velocity, got {weight}")
    shape = (len(wanted), *q.shape[:-1], count)
    preferred = np.zeros(shape) if null_space is None else reals(null_space, "null_space")
    if preferred.shape != shape:
        raise ValueError(f"null_space: expected shape {shape}, got {preferred.shape}")
    frame = {"expressed": expressed, "point": point}
    rates = np.zeros(shape)
    at_rest = States(robot, *robot.state(q, rates[:1])).frame(body)
    solve = _Solver(at_rest.jacobian(0, **frame)[..., list(rows), :], 1 / np.sqrt(scale), rtol)
    for k in range(len(wanted)):
        bias = (
            States(robot, *robot.state(q, rates[: k + 1])).frame(body).velocity(k, **frame)[..., list(rows)]
        )
        rates[k] = solve(wanted[k] - bias, preferred[k])
    return rates


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
