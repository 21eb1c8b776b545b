"""A motion along a path as an animation in Drake's MeshCat.

Below /motion: `bodies/NAME`, the skeleton (a rod from a body's origin to each joint on it, no meshes needed);
`path`, that of the point; `vectors/NAME`, its velocity, acceleration, jerk, ..., each in a scale of its own;
`screw_axis`, the instantaneous one of the body; `centres/NAME`, the acceleration centres, where they are
near.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.robot.derivative_names import order_name

if TYPE_CHECKING:
    from workbench.kinematics.robot.states import States

ROOT = "/motion"
FRAMES_PER_SECOND = 32.0
GREY, DARK, RED = (0.7, 0.7, 0.75, 1.0), (0.2, 0.2, 0.25, 1.0), (0.85, 0.1, 0.1, 1.0)
COLOURS = ((0.1, 0.6, 0.2, 1.0), (0.1, 0.3, 0.9, 1.0), (0.9, 0.5, 0.0, 1.0), (0.6, 0.1, 0.7, 1.0))
NEAR = 3.0  # robot's sizes within which a centre is shown


def show(motion: States, meshcat: Any, body: str, point: ArrayLike, orders: Sequence[int]) -> None:
    """See `Motion.show`. Raises ValueError unless the motion is along a path at a row of times."""
    if motion.times is None or len(motion.shape) != 1 or len(motion.times) < 2:
        raise ValueError("expected a motion along a path at a row of times (`Robot.along`)")
    from workbench.drake.gate import MeshcatAnimation

    if not hasattr(meshcat, "SetTransform"):
        raise ValueError(f"meshcat: expected a pydrake.geometry.Meshcat, got {type(meshcat).__name__}")
    meshcat.Delete(ROOT)
    animation = MeshcatAnimation(frames_per_second=FRAMES_PER_SECOND)
    scene = _Scene(motion, meshcat, animation)
    scene.skeleton()
    scene.point(body, point, orders)
    scene.screw_axis(body)
    scene.centres(body, orders)
    meshcat.SetAnimation(animation)


class _Scene:
    def __init__(self, motion: States, meshcat: Any, animation: Any):
        self.motion, self.meshcat, self.animation = motion, meshcat, animation
        times = motion.times
        self.frames = [animation.frame(float(t - times[0])) for t in times]
        origins = np.array([frame.pose[:, :3, 3] for frame in motion.frames])
        self.size = float(max(0.1, np.linalg.norm(origins - origins[:1], axis=-1).max()))

    def skeleton(self) -> None:
        from workbench.drake.gate import Rgba, Sphere

        robot, thickness = self.motion.robot, 0.012 * self.size
        for name in robot.bodies:
            place = f"{ROOT}/bodies/{name}"
            self.meshcat.SetObject(f"{place}/origin", Sphere(1.5 * thickness), Rgba(*DARK))
            self._move(place, self.motion.frame(name).pose)
        for joint in robot.joints:
            length = float(np.linalg.norm(joint.X_PF[:3, 3]))
            if length > thickness:
                place = f"{ROOT}/bodies/{joint.parent}/to {joint.name}"
                self._rod(place, thickness, length, GREY)
                self.meshcat.SetTransform(place, _along(np.zeros(3), joint.X_PF[:3, 3]))

    def point(self, body: str, point: ArrayLike, orders: Sequence[int]) -> None:
        from workbench.drake.gate import Rgba, Sphere

        moving = self.motion.frame(body).point(point)
        at = moving.position
        self.meshcat.SetLine(f"{ROOT}/path", np.ascontiguousarray(at.T), 2.0, Rgba(*DARK))
        self.meshcat.SetObject(f"{ROOT}/point", Sphere(0.02 * self.size), Rgba(*RED))
        identity = np.broadcast_to(np.eye(4), (len(at), 4, 4)).copy()
        identity[:, :3, 3] = at
        self._move(f"{ROOT}/point", identity)
        for n in orders:
            vectors = moving.derivative(n)
            lengths = np.linalg.norm(vectors, axis=-1)
            scale = 0.4 * self.size / max(lengths.max(), 1e-300)
            place = f"{ROOT}/vectors/{order_name(n)}"
            self._rod(place, 0.008 * self.size, 1.0, COLOURS[n % len(COLOURS)])
            for frame, start, vector, length in zip(self.frames, at, vectors, lengths, strict=True):
                self.animation.SetTransform(frame, place, _along(start, vector))
                self.animation.SetProperty(
                    frame, place, "scale", [1.0, 1.0, max(1e-6, float(scale * length))]
                )

    def screw_axis(self, body: str) -> None:
        frame = self.motion.frame(body)
        axis = frame.screw_axis()
        place = f"{ROOT}/screw_axis"
        self._rod(place, 0.004 * self.size, 4 * self.size, RED)
        to_body = frame.pose[:, :3, 3] - axis.point
        along = (to_body * axis.direction).sum(axis=-1, keepdims=True)
        starts = axis.point + (along - 2 * self.size) * axis.direction
        near = np.linalg.norm(starts - frame.pose[:, :3, 3], axis=-1) < 2 * NEAR * self.size
        for step, start, direction, shown in zip(self.frames, starts, axis.direction, near, strict=True):
            self.animation.SetTransform(step, place, _along(start, direction))
            self.animation.SetProperty(step, place, "visible", bool(shown and direction.any()))

    def centres(self, body: str, orders: Sequence[int]) -> None:
        from workbench.drake.gate import Rgba, RigidTransform, Sphere

        frame = self.motion.frame(body)
        for n in orders:
            if n < 2:  # of the velocity it is the screw axis or nowhere
                continue
            centre = frame.centre(n)
            place = f"{ROOT}/centres/{order_name(n)}"
            self.meshcat.SetObject(place, Sphere(0.03 * self.size), Rgba(*COLOURS[n % len(COLOURS)]))
            near = np.linalg.norm(centre.point - frame.pose[:, :3, 3], axis=-1) < NEAR * self.size
            for step, point, shown in zip(
                self.frames, centre.point, near & (centre.dimension == 0), strict=True
            ):
                self.animation.SetProperty(step, place, "visible", bool(shown))
                if shown:
                    self.animation.SetTransform(step, place, RigidTransform(point))

    def _rod(self, place: str, radius: float, length: float, colour: tuple[float, ...]) -> None:
        """Adds a cylinder from the origin of `place` along its z axis."""
        from workbench.drake.gate import Cylinder, Rgba, RigidTransform

        self.meshcat.SetObject(f"{place}/rod", Cylinder(radius, length), Rgba(*colour))
        self.meshcat.SetTransform(f"{place}/rod", RigidTransform([0, 0, length / 2]))

    def _move(self, place: str, poses: np.ndarray) -> None:
        from workbench.drake.gate import RigidTransform, RotationMatrix

        for frame, X in zip(self.frames, poses, strict=True):
            R = RotationMatrix.ProjectToRotationMatrix(X[:3, :3])
            self.animation.SetTransform(frame, place, RigidTransform(R, X[:3, 3]))


def _along(start: np.ndarray, direction: np.ndarray) -> Any:
    """Returns the pose at `start` with z along the direction (world's z if it is zero)."""
    from workbench.drake.gate import RigidTransform, RotationMatrix

    length = np.linalg.norm(direction)
    R = RotationMatrix() if length < 1e-300 else RotationMatrix.MakeFromOneVector(direction / length, 2)
    return RigidTransform(R, start)
