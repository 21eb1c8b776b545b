"""The motion of a robot at one state or at many: of its frames, of their points, to the order N.

Orders count as in Eq. (13): 1 velocity, 2 acceleration, 3 jerk, 4 snap. Everything is measured in the world W
and expressed in its axes, unless a frame is asked for its motion relative to another. Nothing is computed
before it is asked for, and everything once. All arrays are read-only.
"""

from __future__ import annotations

from functools import cached_property
from math import prod
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from workbench.algebra.dual_tensors import transpose
from workbench.drake.joint_paths import Path
from workbench.kinematics.robot.common_base import without_common_base
from workbench.kinematics.robot.leibniz import (
    about_moving_point,
    carried_vector,
    inverse_pose,
    origin_derivatives,
    relative_twist,
    rotation_derivatives,
    turned,
)
from workbench.kinematics.robot.partials import twist_partial
from workbench.kinematics.robot.robot_frames import FrameMotion, chain_scales
from workbench.kinematics.robot.structure import LARGE, Body, Structure, whole
from workbench.kinematics.spare_memory import spare_memory
from workbench.kinematics.trees.tree_engine import compute, states_side_by_side
from workbench.kinematics.trees.tree_steps import WORLD

ORIGIN = (0, 0, 0)
EXPRESSED = ("world", "mixed", "body")


S = TypeVar("S", bound="States")


class States:
    """A robot at one state or at many, in motion. The states' axes, `shape`, come after the order's.

    q (..., positions): the coordinates. rates (N, ..., velocities): the velocities and their derivatives.
    times (...) in s and path, where it is a motion along one.
    """

    times: Any = None
    path: Any = None
    _q: Any = None
    _q_derivatives: Any = None
    _rates: Any = None
    _channels: Any = None

    def __init__(self, robot: Structure, q: np.ndarray, rates: np.ndarray | None = None):
        self.robot = robot
        if rates is None:
            self._q_derivatives, self.order = q, len(q) - 1
        else:
            self._q, self._rates, self.order = q, rates, len(rates)
        self._records: dict[str, np.ndarray] = {}  # no frames: these would keep the motion alive, and it them
        self._jacobians: dict[str, np.ndarray] = {}

    @property
    def q(self) -> np.ndarray:
        q = self._q_derivatives[0] if self._q is None else self._q
        q.setflags(write=False)
        return q

    @property
    def rates(self) -> np.ndarray:
        if self._rates is None:
            self._rates = self.robot.velocity_derivatives(self._q_derivatives)
        self._rates.setflags(write=False)
        return self._rates

    @property
    def shape(self) -> tuple[int, ...]:
        return self.q.shape[:-1]

    def frame(self, name: str) -> RobotFrame:
        """Returns the motion of a body's frame; ValueError lists the bodies."""
        return RobotFrame(self, self.robot.body(name))

    def at(self, times: np.ndarray) -> States:
        """Returns the same robot on the same path, at other times (...) in s."""
        return states_on_path(type(self), self.robot, self.path, times, self.order)

    @property
    def frames(self) -> tuple[RobotFrame, ...]:
        """Of all bodies, computed together."""
        if not all(name in self._records for name in self.robot.bodies):
            records = self.records()
            self._records = dict(zip(self.robot.bodies, records, strict=True))
        return tuple(map(self.frame, self.robot.bodies))

    def records(self, out: np.ndarray | None = None) -> np.ndarray:
        """Returns the poses and twists of all bodies, (bodies, ..., 16 + 6 N), computed together: of each, in
        the order of `robot.bodies`, the 16 numbers of X_WF, then V_WF and its derivatives, six each.

        out: if given, the result is written there, which spares large batches the fresh memory. An array such
        as this returns, whose states' numbers are side by side in memory, suits the compiled kernel best.
        Raises ValueError for an `out` of another shape.
        """
        robot, states = self.robot, prod(self.shape)
        plan = robot.engine.plan(robot.bodies, self.order)
        shape = len(robot.bodies), *self.shape, plan.rows
        if out is None and not self.shape:
            records = np.empty(shape)
            compute(self._input(), plan, records[:, None, None])
            records.setflags(write=False)
            return records
        if out is None:
            records = states_side_by_side(len(robot.bodies), states, plan.rows)
            compute(self._input(), plan, records[:, :, None])
            records = np.moveaxis(
                np.moveaxis(records, 1, 2).reshape(*shape[:1], plan.rows, *self.shape), 1, -1
            )
            records.flags.writeable = False
            return records
        if out.shape != shape or out.dtype != np.float64 or not out.flags.writeable:
            raise ValueError(
                f"out: expected a writable array of doubles of shape {shape}, "
                f"got {out.dtype} of shape {out.shape}"
            )
        rows = out.reshape(len(robot.bodies), states, plan.rows)
        compute(self._input(), plan, rows[:, :, None])
        if not np.may_share_memory(rows, out):
            out[...] = rows.reshape(shape)
        return out

    def _input(self) -> np.ndarray:
        """Returns (N + 1, states, channels)"""
        channels = self._channels
        if channels is None:
            channels = self._q_derivatives  # of a robot without balls: see `Structure.state`
            if not self.robot._plain:
                channels = self._channels = self.robot.channels(self.q, self.rates)
        if channels.ndim == 2:
            return channels[:, None]
        return channels.reshape(len(channels), prod(self.shape), channels.shape[-1])

    def _record(self, name: str) -> np.ndarray:
        """Returns (..., 16 + 6 N): the pose and the twists of a body."""
        record = self._records.get(name)
        if record is None:
            record = self._records[name] = self._new_record(name)
        return record

    def _jacobian_record(self, name: str, orders: int) -> np.ndarray:
        """Returns (..., orders or more, 6, velocities)"""
        J = self._jacobians.get(name)
        if J is None or J.shape[-3] < orders:
            record = self._new_record(name, orders)
            J = record[..., 16 + 6 * self.order :]
            J = J.reshape(*record.shape[:-1], orders, 6, len(self.robot.velocities))
            self._jacobians[name] = J
        return J

    @cached_property
    def _turning(self) -> dict[str, np.ndarray]:
        return {}

    def _turning_record(self, name: str) -> np.ndarray:
        """Returns the turning parts of the Jacobian (N, ..., 3, velocities), computed with all of its
        derivatives."""
        if name not in self._turning:
            N, count = self.order, len(self.robot.velocities)
            record = self._new_record(name, N + 1, N)
            J, D = np.split(record[..., 16 + 6 * N :], [6 * (N + 1) * count], axis=-1)
            self._jacobians[name] = J.reshape(*self.shape, N + 1, 6, count)
            self._turning[name] = np.moveaxis(D.reshape(*self.shape, N, 3, count), -3, 0)
        return self._turning[name]

    def _new_record(self, name: str, jacobians: int = 0, turning: int = 0) -> np.ndarray:
        one = self._q_derivatives
        if one is not None and one.ndim == 2 and turning == 0 and self.robot._plain:
            return self.robot.engine.of_one_state(one, name, self.order, jacobians)
        plan, q = self.robot.engine.plan(name, self.order, jacobians, turning), self._input()
        if jacobians == 0 and q.shape[1] * plan.rows >= LARGE:
            (record,) = states_side_by_side(1, q.shape[1], plan.rows)
        else:
            record = spare_memory(q.shape[1] * plan.rows).reshape(q.shape[1], plan.rows)
        compute(q, plan, record[None, :, None])
        record.setflags(write=False)
        return record.reshape(*self.shape, plan.rows)

    def _sizes(self, body: Body) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Returns the sizes and terms (N, ...) of the rates of a body's joints, and its reach, for
        `chain_scales`."""
        rates = np.stack([np.abs(self.rates), self.magnitudes])
        total, reach = np.zeros(rates.shape[:-1]), 1 + np.linalg.norm(body.X_MB[:3, 3])
        at = body.after
        while at != WORLD:
            step = self.robot.steps[at]
            drive = step.turn or step.slide
            assert drive is not None, "a step turns or slides"
            count = 3 if step.joint is None else 1
            own = rates[..., drive.velocity : drive.velocity + count].sum(axis=-1)
            total += abs(drive.factor) * own
            reach = reach + np.linalg.norm(step.before[:3, 3])
            if step.slide is not None:
                value = self._input()[0][:, step.slide.channel].reshape(self.shape)
                reach = reach + np.abs(step.slide.factor * value + step.slide.offset)
            at = step.parent
        return *total, np.broadcast_to(reach, self.shape)

    @cached_property
    def magnitudes(self) -> np.ndarray:
        """The sizes (N, ..., velocities) of what the rates were summed from: their rounding is relative to
        it."""
        of_path = self.path is not None and self.robot._plain
        return self.path.magnitudes(self.times, self.order)[1:] if of_path else np.abs(self.rates)

    def __repr__(self) -> str:
        states = f"{self.shape} states" if self.shape else "one state"
        return f"{type(self).__name__}({self.robot.name!r}, order {self.order}, {states})"

    def __dir__(self) -> list[str]:
        return [name for name in super().__dir__() if not name.startswith("_")]


class RobotFrame(FrameMotion):
    """The motion of a body's frame F of a robot, with its Jacobian; see `FrameMotion` for all else."""

    def __init__(self, motion: States, body: Body):
        self.motion, self._body = motion, body
        self.name, self.order = body.name, motion.order

    @property
    def pose(self) -> np.ndarray:  # type: ignore[override]  # made on first use
        record = self.motion._record(self.name)
        if record.ndim == 1:
            return record[:16].reshape(4, 4)
        return record[..., :16].reshape(*record.shape[:-1], 4, 4)

    @property
    def twists(self) -> np.ndarray:  # type: ignore[override]
        record = self.motion._record(self.name)
        if record.ndim == 1:
            return record[16:].reshape(self.order, 6)
        return np.moveaxis(record[..., 16:].reshape(*record.shape[:-1], self.order, 6), -2, 0)

    def _twist(self, k: int) -> np.ndarray:
        record, at = self.motion._record(self.name), 16 + 6 * k
        return record[at : at + 6] if record.ndim == 1 else record[..., at : at + 6]

    def jacobian(self, order: int = 0, *, point: ArrayLike = ORIGIN, expressed: str = "mixed") -> np.ndarray:
        """Returns dᵏJ/dtᵏ, k = order, (..., 6, velocities): the derivative of ∂(ω; v)/∂(velocities) along the
        motion.

        point (3,): p_FoP_F in m, whose velocity v is. expressed: "mixed": v of the point, all in W's axes
        (Drake's J; Pinocchio's LOCAL_WORLD_ALIGNED); "body": v of the point, all in F's axes (LOCAL);
        "world": v of the body point at W's origin (WORLD), whatever the point. The derivative is that of the
        components, so that V⁽ᵏ⁾ = Σ C(k,i) J⁽ⁱ⁾ v⁽ᵏ⁻ⁱ⁾ with `velocity(k)` of the same two arguments.
        Raises ValueError for an order beyond the motion's.
        """
        if expressed == "mixed" and point is ORIGIN:
            self._require(order, self.order)
            return self.motion._jacobian_record(self.name, order + 1)[..., order, :, :]
        return self.jacobian_derivatives(order, point=point, expressed=expressed)[order]

    def jacobian_derivatives(
        self, order: int, *, point: ArrayLike = ORIGIN, expressed: str = "mixed"
    ) -> np.ndarray:
        """Returns J, dJ/dt, …, dᵏJ/dtᵏ, k = order, (k + 1, ..., 6, velocities); see `jacobian`."""
        self._require(order, self.order)
        self._check(expressed)
        J = self.motion._jacobian_record(self.name, order + 1)
        J = (J if J.ndim == 3 else np.moveaxis(J, -3, 0))[: order + 1]
        if expressed == "mixed" and point is ORIGIN:
            return J
        return self._expressed(J.swapaxes(-1, -2), point, expressed).swapaxes(-1, -2)

    def twist_partial(self, k: int, j: int, *, point: ArrayLike = ORIGIN) -> np.ndarray:
        """Returns ∂V⁽ᵏ⁾/∂q⁽ʲ⁾, (..., 6, positions): how the k-th derivative of the twist V = (ω; velocity of
        the point) depends on the j-th derivatives of the coordinates, the other derivatives being held.

        In W's axes, rad and m, per s¹⁺ᵏ⁻ʲ; k < N; 0 for j > k + 1. point (3,): p_FoP_F in m. For k = 0, j =
        1 it is the Jacobian. Closed form, see `partials`. Raises ValueError for an order beyond the
        motion's, and for a robot with ball or floating joints, whose velocities are not the rates of its
        coordinates."""
        self._require(k, self.order - 1)
        whole(j, "j", 0)
        self.motion.robot.require_rates("partial derivatives")
        D = self.motion._turning_record(self.name)
        return twist_partial(self.jacobian_derivatives(k + 1, point=point), D, k, j)

    def twist_partials(self, k: int, *, point: ArrayLike = ORIGIN) -> np.ndarray:
        """Returns ∂V⁽ᵏ⁾/∂q⁽ʲ⁾ of all j, (k + 2, ..., 6, positions), j = 0, …, k + 1 first; see
        `twist_partial`."""
        return np.stack([self.twist_partial(k, j, point=point) for j in range(k + 2)])

    def relative_to(self, other: FrameMotion) -> FrameMotion:
        """Returns the motion of this frame B relative to the frame A of `other`, expressed in A.

        If `other` is a frame of the same motion, the result has a `jacobian`, and the motion of a common base
        of both has no influence.
        """
        if not (isinstance(other, RobotFrame) and other.motion is self.motion):
            return super().relative_to(other)
        motion, robot = self.motion, self.motion.robot
        q, rates = without_common_base(robot, self.name, other.name, motion.q, motion.rates)
        if robot.world not in (self.name, other.name):
            robot = robot.near_origin
        alone = States(robot, *robot.state(q, rates))
        return RelativeFrame(alone.frame(self.name), alone.frame(other.name))

    def velocity(self, order: int = 0, *, point: ArrayLike = ORIGIN, expressed: str = "mixed") -> np.ndarray:
        """Returns the k-th derivative, k = order, of (ω; v), (..., 6), as `jacobian` has it: point and
        expressed."""
        self._require(order, self.order - 1)
        self._check(expressed)
        if expressed == "world":
            return self.origin_twist[order]
        return self._expressed(self.twists[: order + 1, ..., None, :], point, expressed)[order][..., 0, :]

    @cached_property
    def _scales(self) -> tuple[np.ndarray, np.ndarray]:
        return chain_scales(*self.motion._sizes(self._body))

    def _expressed(self, columns: np.ndarray, point: ArrayLike, expressed: str) -> np.ndarray:
        """Returns twists (k + 1, ..., c, 6) about Fo, in W's axes, as those about the point P, in W's axes
        or F's, or about W's origin."""
        arm = self.point(point)._arm
        twists = self.twists[: len(columns) - 1]
        if expressed == "world":
            p = -origin_derivatives(twists, self.pose[..., :3, 3])
        else:
            p = carried_vector(twists[..., :3], arm)
        columns = about_moving_point(columns, p[..., None, :])
        if expressed != "body":
            return columns
        R = self.pose[..., :3, :3]
        R = rotation_derivatives(twists[..., :3], R) if len(twists) else R[None]
        return turned(R.swapaxes(-1, -2)[..., None, :, :], columns)

    @staticmethod
    def _check(expressed: str) -> None:
        if expressed not in EXPRESSED:
            raise ValueError(f"expressed: expected one of {', '.join(EXPRESSED)}, got {expressed!r}")


class RelativeFrame(FrameMotion):
    """The motion of a frame B in a frame A, expressed in A, of the same motion of a robot."""

    def __init__(self, moving: RobotFrame, observer: RobotFrame):
        pose = inverse_pose(observer.pose) @ moving.pose
        twists = relative_twist(observer.twists, observer.pose, moving.twists, moving.pose)
        super().__init__(f"{moving.name} relative to {observer.name}", moving.order, pose, twists)
        self._moving, self._observer = moving, observer

    def jacobian(self, order: int = 0) -> np.ndarray:
        """Returns dᵏJ/dtᵏ, k = order <= N, (..., 6, velocities): the derivative of ∂V_AB/∂(velocities) in A's
        axes.

        V_AB = (ω; velocity of Bo) as A sees it, `twist(0)`; the derivative is that of the components in the
        moving A, so that V_AB⁽ᵏ⁾ = Σ C(k,i) J⁽ⁱ⁾ v⁽ᵏ⁻ⁱ⁾. Raises ValueError for an order beyond the motion's.
        """
        self._require(order, self.order)
        A, B = self._observer, self._moving
        of_A, of_B = (frame.jacobian_derivatives(order).swapaxes(-1, -2) for frame in (A, B))
        between = np.concatenate(
            [
                (B.pose[..., :3, 3] - A.pose[..., :3, 3])[None],
                B.twists[:order, ..., 3:] - A.twists[:order, ..., 3:],
            ]
        )
        R = A.pose[..., :3, :3]
        R = rotation_derivatives(A.twists[:order, ..., :3], R) if order else R[None]
        J = of_B - about_moving_point(of_A, between[..., None, :])
        return turned(transpose(R)[..., None, :, :], J)[order].swapaxes(-1, -2)


def states_on_path(kind: type[S], robot: Structure, path: Path, times: np.ndarray, order: int) -> S:
    """Returns the states, of the class `kind`, of a robot on a path at the times (...) in s."""
    motion = kind(robot, robot.derivatives(path.derivatives(times, order), order))
    motion.times, motion.path = times, path
    return motion
