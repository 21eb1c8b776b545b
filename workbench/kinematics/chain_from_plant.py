"""The serial chain that leads from the world of a Drake MultibodyPlant to one of its bodies."""

from collections import deque
from math import pi
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from workbench.kinematics.chain import Joint, SerialChain

if TYPE_CHECKING:
    from pydrake.multibody.plant import MultibodyPlant
    from pydrake.multibody.tree import Joint as PlantJoint
    from pydrake.multibody.tree import RigidBody


class PlantChain(NamedTuple):
    """A chain and, for each of its coordinates, the index of that coordinate in the plant's q."""

    chain: SerialChain
    position_indices: list[int]


def serial_chain_from_plant(plant: "MultibodyPlant", body: "RigidBody | str") -> PlantChain:
    """The chain of joints between the world and `body` (a body of the plant, or its name).

    The chain's `pose` is X_WB. Its twist is (w_WB; v), v being the velocity of the point of B that
    is at the world origin, so that Drake's velocity of Bo is v_WB = v + w_WB × p_WB.

    Welds, revolute, prismatic, screw, universal and planar joints are taken over, in whichever
    direction the path runs through them. Raises ValueError for a plant not yet finalized, for an
    unknown body, for a body that no moving joint connects to the world, and for a joint whose
    coordinates are not angles and lengths (a floating body's quaternion, a ball joint).
    """
    if not plant.is_finalized():
        raise ValueError("expected a finalized plant: call plant.Finalize() first")
    if isinstance(body, str):
        if not plant.HasBodyNamed(body):
            raise ValueError(f"the plant has no body named {body!r}")
        body = plant.GetBodyByName(body)
    joints, position_indices = [], []
    for joint, outward in _path_from_world(plant, body):
        X_PF = joint.frame_on_parent().GetFixedPoseInBodyFrame().GetAsMatrix4()
        X_CM = joint.frame_on_child().GetFixedPoseInBodyFrame().GetAsMatrix4()
        steps = _elementary_joints(joint)
        start = joint.position_start()
        coordinates = list(range(start, start + joint.num_positions()))
        before, after = X_PF, np.linalg.inv(X_CM)
        if not outward:
            steps = [_inverse(step) for step in steps]
            before, after = X_CM, np.linalg.inv(X_PF)
        joints += [Joint.fixed(before), *steps, Joint.fixed(after)]
        position_indices += coordinates
    if not position_indices:
        raise ValueError(f"no moving joint connects body {body.name()!r} to the world")
    return PlantChain(SerialChain(joints), position_indices)


def _path_from_world(plant: "MultibodyPlant", body: "RigidBody") -> list[tuple["PlantJoint", bool]]:
    """The joints from the world to the body; True where the path runs from parent to child."""
    neighbours: dict[int, list] = {}
    for index in plant.GetJointIndices():
        joint = plant.get_joint(index)
        parent, child = int(joint.parent_body().index()), int(joint.child_body().index())
        neighbours.setdefault(parent, []).append((child, joint, True))
        neighbours.setdefault(child, []).append((parent, joint, False))
    world = int(plant.world_body().index())
    paths: dict[int, list[tuple[PlantJoint, bool]]] = {world: []}
    waiting = deque([world])
    while waiting:
        here = waiting.popleft()
        for there, joint, outward in neighbours.get(here, []):
            if there not in paths:
                paths[there] = [*paths[here], (joint, outward)]
                waiting.append(there)
    return paths[int(body.index())]


def _elementary_joints(joint: "PlantJoint") -> list[Joint]:
    """X_FM(q) of one plant joint as a product of joints of one coordinate each."""
    kind = joint.type_name()
    if kind == "weld":
        return [Joint.fixed(joint.X_FM().GetAsMatrix4())]
    if kind == "revolute":
        return [Joint.revolute(joint.revolute_axis())]
    if kind == "prismatic":
        return [Joint.prismatic(joint.translation_axis())]
    if kind == "screw":
        metres_per_radian = joint.screw_pitch() / (2 * pi)
        return [Joint.helical(_screw_axis(joint), pitch=metres_per_radian)]
    if kind == "universal":
        return [Joint.revolute([1, 0, 0]), Joint.revolute([0, 1, 0])]
    if kind == "planar":
        return [
            Joint.prismatic([1, 0, 0]),
            Joint.prismatic([0, 1, 0]),
            Joint.revolute([0, 0, 1]),
        ]
    raise ValueError(
        f"joint {joint.name()!r}: expected a weld, revolute, prismatic, screw, universal or planar "
        f"joint on the path, got {kind}"
    )


def _screw_axis(joint: "PlantJoint") -> np.ndarray:
    """The axis of a screw joint, which Drake does not tell: that of its rotation by one radian."""
    plant = joint.GetParentPlant()
    context = plant.CreateDefaultContext()
    positions = plant.GetPositions(context)
    positions[joint.position_start()] = 1.0
    plant.SetPositions(context, positions)
    X_FM = joint.frame_on_child().CalcPose(context, joint.frame_on_parent())
    return X_FM.rotation().ToAngleAxis().axis()


def _inverse(joint: Joint) -> Joint:
    """The joint with the inverse motion, of the kinds that Drake lets point towards the world."""
    if joint.kind == "fixed":
        return Joint.fixed(np.linalg.inv(joint.transform))
    if joint.kind == "prismatic":
        return Joint.prismatic(-joint.axis)
    return Joint.revolute(-joint.axis, joint.point)
