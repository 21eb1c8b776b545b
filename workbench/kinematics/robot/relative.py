"""The motion of one frame of a robot as an observer in another sees it, with its Jacobian."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from workbench.algebra.dual_tensors import transpose
from workbench.kinematics.robot.frames import FrameMotion
from workbench.kinematics.robot.leibniz import (
    about_moving_point,
    inverse_pose,
    relative_twist,
    rotation_derivatives,
    turned,
)

if TYPE_CHECKING:
    from workbench.kinematics.robot.states import RobotFrame


class RelativeFrame(FrameMotion):
    """The motion of a frame B in a frame A, expressed in A, of the same motion of a robot."""

    def __init__(self, moving: RobotFrame, observer: RobotFrame):
        pose = inverse_pose(observer.pose) @ moving.pose
        twists = relative_twist(observer.twists, observer.pose, moving.twists, moving.pose)
        super().__init__(f"{moving.name} relative to {observer.name}", moving.order, pose, twists)
        self._moving, self._observer = moving, observer

    def jacobian(self, order: int = 0) -> np.ndarray:
        """dᵏJ/dtᵏ, k = order <= N, (..., 6, velocities): the derivative of ∂V_AB/∂(velocities) in A's axes.

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
