"""The motion of a robot at one state or at many: of its frames, of their points, to the order N.

Orders count as in Eq. (13): 1 velocity, 2 acceleration, 3 jerk, 4 snap. Everything is measured in the world W
and expressed in its axes, unless a frame is asked for its motion relative to another. Nothing is computed
before it is asked for, and everything once.
"""

from __future__ import annotations

from functools import cached_property
from math import prod

import numpy as np
from numpy.typing import ArrayLike

from workbench.drake.joint_paths import Path
from workbench.kinematics.robot.common_base import without_common_base
from workbench.kinematics.robot.frames import FrameMotion, chain_scales
from workbench.kinematics.robot.leibniz import (
    about_moving_point,
    position_derivatives,
    rotation_derivatives,
    turned,
)
from workbench.kinematics.robot.structure import Body, Structure
from workbench.kinematics.robot.tree import WORLD, TreeMotion, step_motion, tree_motion

EXPRESSED = ("world", "mixed", "body")


class States:
    """A robot at one state or at many, in motion. The states' axes, `shape`, come after the order's.

    q (..., positions): the coordinates. rates (N, ..., velocities): the velocities and their derivatives.
    times (...) in s and path, where it is a motion along one.
    """

    def __init__(self, robot: Structure, q: np.ndarray, rates: np.ndarray | None = None):
        self.robot = robot
        self.times = self.path = None
        self._q_derivatives = q if rates is None else None
        self._q, self._rates = (q[0], None) if rates is None else (q, rates)
        self.order = len(q) - 1 if rates is None else len(rates)
        self._twists: dict[str, np.ndarray] = {}  # no frames: these would keep the motion alive, and it them
        self._poses: dict[int, np.ndarray] = {}

    @property
    def q(self) -> np.ndarray:
        return self._q

    @property
    def rates(self) -> np.ndarray:
        if self._rates is None:
            self._rates = self.robot.velocity_derivatives(self._q_derivatives)
        return self._rates

    @property
    def shape(self) -> tuple[int, ...]:
        return self._q.shape[:-1]

    def frame(self, name: str) -> RobotFrame:
        """The motion of a body's frame; ValueError lists the bodies."""
        return RobotFrame(self, self.robot.body(name))

    def at(self, times: np.ndarray) -> States:
        """The same robot on the same path, at other times (...) in s."""
        return states_on_path(type(self), self.robot, self.path, times, self.order)

    @property
    def frames(self) -> tuple[RobotFrame, ...]:
        """Of all bodies, computed together."""
        self._tree  # noqa: B018
        return tuple(map(self.frame, self.robot.bodies))

    @cached_property
    def _all(self) -> tuple[np.ndarray, np.ndarray]:
        """Coordinates (S, all positions) and rates (N, S, all velocities), with the joints that mimic."""
        q, rates = self.robot._of_all_joints(self.q, self.rates)
        states = prod(self.shape)  # known where there are none, or no coordinates
        return q.reshape(states, q.shape[-1]), rates.reshape(len(rates), states, rates.shape[-1])

    @cached_property
    def _tree(self) -> TreeMotion:
        return tree_motion(self.robot.steps, *self._all)

    def _pose_after(self, at: int) -> np.ndarray:
        """The pose (S, 4, 4) that a step reaches, by the steps on the way to it."""
        if "_tree" in vars(self):
            return self._tree.poses[at]
        way = [at]
        while way[-1] not in self._poses and (parent := self.robot.steps[way[-1]].parent) != WORLD:
            way.append(parent)
        for one in reversed(way):
            if one not in self._poses:
                step = self.robot.steps[one]
                before = step.before if step.parent == WORLD else self._poses[step.parent] @ step.before
                self._poses[one] = before @ step_motion(step, self._all[0])
        return self._poses[at]

    def _sizes(self, body: Body) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """What moves a body, for `chain_scales`: sizes and terms (N, ...) of its joints' rates, and its
        reach."""
        follow = np.abs(self.robot._of_velocities.T)
        rates = np.stack([np.abs(self.rates), self.magnitudes]) @ follow
        total, reach, at = np.zeros(rates.shape[:-1]), 1 + np.linalg.norm(body.X_MB[:3, 3]), body.after
        q = np.abs(self._all[0]).reshape(*self.shape, self._all[0].shape[-1])
        while at != WORLD:
            step = self.robot.steps[at]
            total += rates[..., step.velocities].sum(axis=-1)
            reach = reach + np.linalg.norm(step.before[:3, 3])
            if not isinstance(step.joint, str) and step.joint.kind in ("prismatic", "helical"):
                reach = reach + q[..., step.positions.start] * abs(step.joint.pitch or 1.0)
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

    @cached_property
    def pose(self) -> np.ndarray:
        motion, body = self.motion, self._body
        if body.after == WORLD:
            return np.broadcast_to(body.X_MB, (*motion.shape, 4, 4))
        return (motion._pose_after(body.after) @ body.X_MB).reshape(*motion.shape, 4, 4)

    @property
    def origin_twist(self) -> np.ndarray:
        twist = self.motion._twists.get(self.name)
        if twist is None:
            twist = self.motion._twists[self.name] = self._new_origin_twist()
        return twist

    def _new_origin_twist(self) -> np.ndarray:
        motion, body = self.motion, self._body
        if motion._q_derivatives is not None and "_tree" not in motion.__dict__:
            robot = motion.robot
            found = robot._chains.get(body.name) or robot._chain(body)
            if found is not None:  # the compiled engine, for one body
                chain, own = found
                q = motion._q_derivatives
                return chain.twist_derivatives_of_finite(q if own is ... else q[..., own])
        if body.after == WORLD:
            return np.zeros((motion.order, *motion.shape, 6))
        return motion._tree.twists[:, body.after].reshape(motion.order, *motion.shape, 6)

    def jacobian(
        self, order: int = 0, *, point: ArrayLike = (0, 0, 0), expressed: str = "mixed"
    ) -> np.ndarray:
        """dᵏJ/dtᵏ, k = order, (..., 6, velocities): the derivative of ∂(ω; v)/∂(velocities) along the motion.

        point (3,): p_FoP_F in m, whose velocity v is. expressed: "mixed": v of the point, all in W's axes
        (Drake's J; Pinocchio's LOCAL_WORLD_ALIGNED); "body": v of the point, all in F's axes (LOCAL);
        "world": v of the body point at W's origin (WORLD), whatever the point. The derivative is that of the
        components, so that V⁽ᵏ⁾ = Σ C(k,i) J⁽ⁱ⁾ v⁽ᵏ⁻ⁱ⁾ with `velocity(k)` of the same two arguments.
        Raises ValueError for an order beyond the motion's.
        """
        return self._jacobians(order, point, expressed)[order]

    def velocity(
        self, order: int = 0, *, point: ArrayLike = (0, 0, 0), expressed: str = "mixed"
    ) -> np.ndarray:
        """The k-th derivative, k = order, of (ω; v), (..., 6), as `jacobian` has it: point and expressed."""
        self._require(order, self.order - 1)
        twist = self.origin_twist[: order + 1]
        self._check(expressed)
        if expressed != "world":
            twist = self._expressed(twist[..., None, :], point, expressed)[..., 0, :]
        return twist[order]

    def _jacobians(self, order: int, point: ArrayLike, expressed: str) -> np.ndarray:
        """(order + 1, ..., 6, velocities)"""
        self._require(order, self.order)
        self._check(expressed)
        motion = self.motion
        columns = motion._tree.columns[: order + 1]
        J = motion.robot._of_free_joints(columns, self._moving)
        J = np.moveaxis(J.reshape(*J.shape[:2], *motion.shape, 6), 1, -2)
        if expressed != "world":
            J = self._expressed(J, point, expressed)
        return J.swapaxes(-1, -2)

    @cached_property
    def _moving(self) -> list[int]:
        """The velocities, of all joints, that move the body."""
        steps, at = self.motion.robot.steps, self._body.after
        moving: list[int] = []
        while at != WORLD:
            moving += range(steps[at].velocities.start, steps[at].velocities.stop)
            at = steps[at].parent
        return sorted(moving)

    def relative_to(self, other: FrameMotion) -> FrameMotion:
        """As `FrameMotion.relative_to`; how a common base of both frames moves does not enter."""
        if not (isinstance(other, RobotFrame) and other.motion is self.motion):
            return super().relative_to(other)
        motion = self.motion
        q, rates = without_common_base(motion.robot, self.name, other.name, motion.q, motion.rates)
        alone = motion.robot.motion(q, rates)
        return FrameMotion.relative_to(alone.frame(self.name), alone.frame(other.name))

    @cached_property
    def _scales(self) -> tuple[np.ndarray, np.ndarray]:
        return chain_scales(*self.motion._sizes(self._body))

    def _expressed(self, columns: np.ndarray, point: ArrayLike, expressed: str) -> np.ndarray:
        """Twists (k + 1, ..., c, 6) about W's origin as those about the point P, in W's axes or F's."""
        p_WP = self.point(point).position
        orders = len(columns) - 1
        twist = self.origin_twist[:orders]
        p = position_derivatives(twist, p_WP) if orders else p_WP[None]
        columns = about_moving_point(columns, p[..., None, :])
        if expressed == "mixed":
            return columns
        R = self.pose[..., :3, :3]
        R = rotation_derivatives(twist[..., :3], R) if orders else R[None]
        return turned(R.swapaxes(-1, -2)[..., None, :, :], columns)

    @staticmethod
    def _check(expressed: str) -> None:
        if expressed not in EXPRESSED:
            raise ValueError(f"expressed: expected one of {', '.join(EXPRESSED)}, got {expressed!r}")


def states_on_path(kind: type[States], robot: Structure, path: Path, times: np.ndarray, order: int) -> States:
    """The states, of the class `kind`, of a robot on a path at the times (...) in s."""
    motion = kind(robot, robot.derivatives(path.derivatives(times, order)))
    motion.times, motion.path = times, path
    return motion
