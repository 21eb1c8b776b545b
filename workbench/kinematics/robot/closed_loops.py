"""Closed loops: a robot with constraints between its bodies, and its rates of every order.

The tree of the robot is opened where a loop closes. A constraint states that a frame P of a body A and a
frame Q of a body B coincide, or that their origins do. Their velocities then agree at all times, V_WP = V_WQ,
and so do all derivatives. With J = J_Q − J_P, Eq. (119) of *Higher-Order Kinematics in Dual Lie Algebra* on
both paths from the world, and v the velocities,

    Σᵢ C(k,i) J⁽ⁱ⁾ v⁽ᵏ⁻ⁱ⁾ = 0,     k = 0, 1, …,

which is solved order by order for v⁽ᵏ⁾, always with the same matrix J, together with the driven rates. If a
loop closes by a joint other than a ball, add the joint to the tree, and weld its child.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.chain_joints import rigid_matrix
from workbench.kinematics.robot.balls import rotation_of_rpy, rpy_of_rotation
from workbench.kinematics.robot.inverse import SingularJacobian
from workbench.kinematics.robot.structure import reals
from workbench.kinematics.rotations import angle_and_axis, length_and_direction, rotation

if TYPE_CHECKING:
    from workbench.kinematics.robot.motion import Motion
    from workbench.kinematics.robot.robot import Robot
    from workbench.kinematics.robot.states import States

STEPS = 200  # of Newton's method
LARGEST_STEP = 0.4  # rad, or lengths of the mechanism
CLOSED = 1e-6  # of the mechanism's length: the largest gap of a position that counts as closed
CONSISTENT = 1e-7  # of the terms of an equation: the largest residual that counts as rounding


@dataclass(frozen=True, eq=False)
class WeldConstraint:
    """The frame P of a body A and the frame Q of a body B coincide (Drake's AddWeldConstraint, Pinocchio's
    CONTACT_6D). X_AP, X_BQ (4, 4): where they are in the bodies' frames, m. The world is a body, too."""

    body_A: str
    body_B: str
    X_AP: ArrayLike = field(default_factory=lambda: np.eye(4))
    X_BQ: ArrayLike = field(default_factory=lambda: np.eye(4))

    rows = slice(0, 6)


@dataclass(frozen=True, eq=False)
class BallConstraint:
    """The point P of a body A and the point Q of a body B coincide (Drake's AddBallConstraint, Pinocchio's
    CONTACT_3D). p_AP, p_BQ (3,): where they are in the bodies' frames, m. The world is a body, too."""

    body_A: str
    body_B: str
    p_AP: ArrayLike = (0.0, 0.0, 0.0)
    p_BQ: ArrayLike = (0.0, 0.0, 0.0)

    rows = slice(3, 6)

    @property
    def X_AP(self) -> np.ndarray:
        return _shift(self.p_AP)

    @property
    def X_BQ(self) -> np.ndarray:
        return _shift(self.p_BQ)


Constraint = WeldConstraint | BallConstraint


class ClosedLoops:
    """A robot with constraints: its closed positions, its mobility, and its rates to any order.

    robot: with one frame more for each P and Q. A gap is six numbers, (rotation vector from P to Q;
    p_PQ), rad and m in W's axes, of a weld, and the last three of a ball. Units rad, m, s, as everywhere.
    """

    def __init__(self, robot: Robot, constraints: Iterable[Constraint], rtol: float = 1e-8):
        """rtol: the singular values below rtol · the largest count as 0. Raises ValueError for unknown
        bodies, transforms that are not rigid, and a robot without constraints."""
        self.constraints, self.rtol = tuple(constraints), rtol
        if not self.constraints:
            raise ValueError("constraints: expected at least one, got none")
        if not 0 <= rtol < 1:
            raise ValueError(f"rtol: expected 0 <= rtol < 1, got {rtol}")
        self._pairs: list[tuple[str, str, slice]] = []
        for number, one in enumerate(self.constraints):
            if not isinstance(one, WeldConstraint | BallConstraint):
                raise ValueError(
                    f"constraints: expected WeldConstraint or BallConstraint, got {type(one).__name__}"
                )
            names = f"P of constraint {number}", f"Q of constraint {number}"
            for name, body, X in zip(names, (one.body_A, one.body_B), (one.X_AP, one.X_BQ), strict=True):
                robot = robot.with_frame(name, body, rigid_matrix(X, name))
            self._pairs.append((*names, one.rows))
        self.robot = robot

    def gap(self, q: ArrayLike) -> np.ndarray:
        """Returns the gaps of the frames at the coordinates q (..., positions): (..., rows), rad and m."""
        return self._gap(self._at_rest(self._coordinates(q)))

    def jacobian(self, q: ArrayLike) -> np.ndarray:
        """Returns J = J_Q − J_P of all constraints, (..., rows, velocities): J v = 0 is the motion that they
        allow."""
        return self._jacobian(self._at_rest(self._coordinates(q)))

    def mobility(self, q: ArrayLike) -> np.ndarray:
        """Returns the number of independent velocities at q (..., positions), (...) of integers.

        It is larger in a singular position than near it.
        """
        values = np.linalg.svd(self._scaled(self.jacobian(q))[0], compute_uv=False)
        return len(self.robot.velocities) - (values > self.rtol * values[..., :1]).sum(axis=-1)

    def singular_values(self, q: ArrayLike, driven: Iterable[str] = ()) -> np.ndarray:
        """Returns the singular values (..., velocities), largest first, of the constraints with the driven
        velocities: the last one is 0 where these do not determine the motion. Lengths count in those of
        the mechanism."""
        A, _, _ = self._system(self.jacobian(q), self._indices(driven))
        values = np.linalg.svd(A, compute_uv=False)
        missing = len(self.robot.velocities) - values.shape[-1]
        return np.concatenate([values, np.zeros((*values.shape[:-1], max(missing, 0)))], axis=-1)

    def close(self, q: ArrayLike, driven: Iterable[str] = ()) -> np.ndarray:
        """Returns coordinates (..., positions) near q (..., positions) at which the frames coincide.

        Newton's method with least steps is used; velocities named in `driven` keep the coordinates of q.
        Raises ValueError if it fails, with the remaining gap.
        """
        q = self._coordinates(q).copy()
        held, shape = self._indices(driven), q.shape
        free = [i for i in range(len(self.robot.velocities)) if i not in held]
        q = q.reshape(-1, shape[-1])
        for _ in range(STEPS):
            states = self._at_rest(q)
            gap = self._gap(states)
            A, row_scale, column_scale = self._scaled(self._jacobian(states))
            step = np.zeros((len(q), len(column_scale)))
            step[..., free] = _least_squares(A[..., free], -gap * row_scale, self.rtol)
            largest = np.abs(step).max(axis=-1, initial=0.0, keepdims=True)
            if (largest < 1e-14).all():
                break
            q = self._moved(
                q, column_scale * step * np.minimum(1, LARGEST_STEP / np.maximum(largest, 1e-300))
            )
            if (largest < 1e-9).all():  # the next error is its square
                break
        self._require_closed(q, "close: expected a closed position near q, found none")
        return q.reshape(shape)

    def rates(self, q: ArrayLike, driven: Mapping[str, ArrayLike]) -> np.ndarray:
        """Returns the velocities and their derivatives (N, ..., velocities) of the motion with the driven
        rates.

        q (..., positions): a closed position. driven: by the name of a velocity its rate and the
        derivatives of that, (N, ...), in rad or m per s, s², ….

        Raises SingularJacobian, a ValueError with the singular values, where they do not determine the
        motion; ValueError where no motion has them, and for an open position."""
        q = self._coordinates(q)
        wanted = self._wanted(q, driven)
        self._require_closed(q, "q: expected a closed position (see `close`)")
        held, rates = (
            self._indices(driven),
            np.zeros((len(wanted), *q.shape[:-1], len(self.robot.velocities))),
        )
        J = self.jacobian(q)
        A, row_scale, column_scale = self._system(J, held)
        self._require_determined(A, held)
        for k in range(len(wanted)):
            bias = self._difference(self._states(q, rates[: k + 1]), k)
            b = np.concatenate([-bias * row_scale, wanted[k] / column_scale[held]], axis=-1)
            y = _least_squares(A, b, self.rtol)
            terms = np.abs(A) @ np.abs(y)[..., None] + np.abs(b).max(axis=-1)[..., None, None]
            missed = np.abs(A @ y[..., None] - b[..., None]).max(axis=(-2, -1))
            if (missed > CONSISTENT * terms.max(axis=(-2, -1)) + 1e-300).any():
                raise ValueError(
                    f"driven: no motion of the mechanism has these rates of order {k + 1}, the constraints "
                    f"are missed by {missed.max():.3g}: too much is driven, or the position is singular"
                )
            rates[k] = column_scale * y
        return rates

    def motion(self, q: ArrayLike, driven: Mapping[str, ArrayLike]) -> Motion:
        """Returns the motion of all bodies with the driven rates; see `rates` and `Robot.motion`."""
        return self.robot.motion(self._coordinates(q), self.rates(q, driven))

    # -- the equations --------------------------------------------------------------------------------

    def _coordinates(self, q: ArrayLike) -> np.ndarray:
        q = reals(q, "q")
        if q.ndim < 1 or q.shape[-1] != len(self.robot.positions):
            raise ValueError(f"q: expected shape (..., {len(self.robot.positions)}), got {q.shape}")
        return q

    def _wanted(self, q: np.ndarray, driven: Mapping[str, ArrayLike]) -> np.ndarray:
        """Returns the driven rates, (N, ..., driven)."""
        if not isinstance(driven, Mapping) or not driven:
            raise ValueError("driven: expected the rates of at least one velocity, by its name")
        columns = [reals(values, f"driven {name!r}") for name, values in driven.items()]
        for name, column in zip(driven, columns, strict=True):
            if column.ndim < 1 or len(column) < 1 or len(column) != len(columns[0]):
                raise ValueError(
                    f"driven {name!r}: expected shape (N, ...) with the same N >= 1 for all, "
                    f"got {column.shape}"
                )
        shape = (len(columns[0]), *q.shape[:-1])
        try:
            return np.stack([np.broadcast_to(_padded(c, len(shape)), shape) for c in columns], axis=-1)
        except ValueError:
            raise ValueError(f"driven: expected rates of the shape {shape}") from None

    def _indices(self, names: Iterable[str]) -> list[int]:
        names = list(names)
        for name in names:
            if name not in self.robot.velocities:
                raise ValueError(
                    f"driven: no velocity {name!r}, expected some of {', '.join(self.robot.velocities)}"
                )
        return [self.robot.velocities.index(name) for name in names]

    def _states(self, q: np.ndarray, rates: np.ndarray) -> States:
        return self.robot.motion(q, rates)

    def _at_rest(self, q: np.ndarray) -> States:
        return self._states(q, np.zeros((1, *q.shape[:-1], len(self.robot.velocities))))

    def _gap(self, states: States) -> np.ndarray:
        found = []
        for P, Q, rows in self._pairs:
            X, Y = states.frame(P).pose, states.frame(Q).pose
            angle, axis = angle_and_axis(Y[..., :3, :3] @ X[..., :3, :3].swapaxes(-1, -2))
            turned = angle[..., None] * axis
            found.append(np.concatenate([turned, Y[..., :3, 3] - X[..., :3, 3]], axis=-1)[..., rows])
        return np.concatenate(found, axis=-1)

    def _jacobian(self, states: States) -> np.ndarray:
        parts = [
            (states.frame(Q).jacobian() - states.frame(P).jacobian())[..., rows, :]
            for P, Q, rows in self._pairs
        ]
        return np.concatenate(parts, axis=-2)

    def _difference(self, states: States, k: int) -> np.ndarray:
        """Returns the k-th derivative of V_WQ − V_WP, (..., rows)."""
        parts = [
            (states.frame(Q).twists[k] - states.frame(P).twists[k])[..., rows] for P, Q, rows in self._pairs
        ]
        return np.concatenate(parts, axis=-1)

    def _scaled(self, J: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Returns J without units, and the factors of its rows and columns: lengths count in those of the
        mechanism."""
        rows = np.concatenate([np.arange(6)[rows] >= 3 for _, _, rows in self._pairs])
        slides = np.array([self.robot.units[name] == "m" for name in self.robot.velocities], dtype=bool)
        arms = np.abs(J[..., rows, :][..., ~slides])
        length = float(arms.max(initial=0.0)) or 1.0
        row_scale, column_scale = np.where(rows, 1 / length, 1.0), np.where(slides, length, 1.0)
        return row_scale[:, None] * J * column_scale, row_scale, column_scale

    def _system(self, J: np.ndarray, held: Sequence[int]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Returns the matrix of the constraints and the driven velocities, without units, and the factors
        of J's rows and columns."""
        scaled, row_scale, column_scale = self._scaled(J)
        driven = np.broadcast_to(np.eye(J.shape[-1])[held], (*J.shape[:-2], len(held), J.shape[-1]))
        return np.concatenate([scaled, driven], axis=-2), row_scale, column_scale

    def _require_determined(self, A: np.ndarray, held: Sequence[int]) -> None:
        _, values, Vt = np.linalg.svd(A, full_matrices=True)
        count = A.shape[-1]
        values = np.concatenate([values, np.zeros((*values.shape[:-1], count - values.shape[-1]))], axis=-1)
        loose = (values <= self.rtol * values[..., :1]).sum(axis=-1)
        if not loose.any():
            return
        where = np.unravel_index(int(np.argmax(loose)), loose.shape)
        state = f" at state {tuple(map(int, where))}" if where else ""
        free = np.abs(Vt[where][-1])
        names = [self.robot.velocities[i] for i in np.flatnonzero(free > 0.3 * free.max())]
        raise SingularJacobian(
            f"singular position{state}, or too little is driven: with {len(held)} driven velocities "
            f"{int(loose[where])} more can move freely (such as {', '.join(names)}), got the singular values "
            + ", ".join(f"{abs(x):.3g}" for x in values[where]),
            values,
        )

    def _require_closed(self, q: np.ndarray, expected: str) -> None:
        states = self._at_rest(q)
        _, row_scale, _ = self._scaled(self._jacobian(states))
        gap = np.abs(self._gap(states) * row_scale).max(axis=-1)
        if (gap > CLOSED).any():
            worst = np.unravel_index(int(np.argmax(gap)), gap.shape)
            raise ValueError(f"{expected}: the frames are apart by {self._gap(states)[worst]} rad and m")

    def _moved(self, q: np.ndarray, step: np.ndarray) -> np.ndarray:
        """Returns q (states, positions) after a step along the velocities."""
        q = q.copy()
        for own in self.robot._free_moves():
            positions, velocities = own.move.sizes
            there = slice(own.position, own.position + positions)
            by = step[..., own.velocity : own.velocity + velocities]
            if own.move.joint == "quaternion":
                q[..., there] = _turned_quaternion(by, q[..., there])
            elif own.move.joint == "rpy":
                turn = rotation(*length_and_direction(by))
                q[..., there] = rpy_of_rotation(turn @ rotation_of_rpy(q[..., there]))
            else:
                q[..., there] += by
        return q


def _shift(p: ArrayLike) -> np.ndarray:
    p = reals(p, "point")
    if p.shape != (3,):
        raise ValueError(f"point: expected three coordinates in m, got shape {p.shape}")
    X = np.eye(4)
    X[:3, 3] = p
    return X


def _padded(column: np.ndarray, axes: int) -> np.ndarray:
    """Returns (N,) as (N, 1, …) of so many axes; others as they are."""
    return column.reshape(-1, *[1] * (axes - 1)) if column.ndim == 1 else column


def _least_squares(A: np.ndarray, b: np.ndarray, rtol: float) -> np.ndarray:
    """Returns the least y with A y = b as nearly as possible, (..., columns)."""
    return (np.linalg.pinv(A, rcond=rtol) @ b[..., None])[..., 0]


def _turned_quaternion(by: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Returns the unit quaternion (..., 4) of the rotation vector `by` (..., 3) after q (..., 4)."""
    angle = np.linalg.norm(by, axis=-1, keepdims=True)
    w, u = np.cos(angle / 2), 0.5 * np.sinc(angle / (2 * np.pi)) * by
    q = q / np.linalg.norm(q, axis=-1, keepdims=True)
    W, U = q[..., :1], q[..., 1:]
    return np.concatenate(
        [w * W - (u * U).sum(axis=-1, keepdims=True), w * U + W * u + np.cross(u, U)], axis=-1
    )
