"""The joints of a finalized Drake MultibodyPlant."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Mapping, Sequence
from math import isclose, pi
from typing import TYPE_CHECKING, Any

import numpy as np

from workbench.kinematics.robot.dynamics import Inertia
from workbench.kinematics.robot.joints import Limits, Mimic, TreeJoint
from workbench.kinematics.robot.leibniz import inverse_pose

if TYPE_CHECKING:
    from workbench.drake.gate import Joint as PlantJoint
    from workbench.drake.gate import JointIndex, MultibodyPlant
    from workbench.drake.mjcf import Mjcf

KINDS = {
    "weld": "fixed",
    "revolute": "revolute",
    "prismatic": "prismatic",
    "screw": "helical",
    "universal": "universal",
    "planar": "planar",
    "ball_rpy": "ball_rpy",
    "quaternion_floating": "floating",
    "rpy_floating": "floating_rpy",
}
REVERSIBLE = ("fixed", "revolute", "prismatic", "helical")


def require_finalized(plant: MultibodyPlant) -> None:
    if not getattr(plant, "is_finalized", bool)():
        raise ValueError("expected a finalized plant: call plant.Finalize() first")


def tree_joints(
    plant: MultibodyPlant, mimics: Mapping[str, Mimic], armatures: Mapping[JointIndex, float]
) -> list[TreeJoint]:
    """Returns the plant's joints as a tree from its world, in the order of its coordinates.

    armatures: see `plant_armatures`.
    A body is called model::body where another model has a body of that name, and a joint likewise. Raises
    ValueError for a plant not finalized, a joint of another kind, and one whose velocities do not follow its
    coordinates' order.
    """
    from workbench.drake.gate import BodyIndex

    require_finalized(plant)
    joints = [plant.get_joint(index) for index in plant.GetJointIndices()]
    bodies = [plant.get_body(BodyIndex(index)) for index in range(plant.num_bodies())]
    body_names = _names(plant, bodies)
    joint_names = _names(plant, joints)
    unknown = [name for name in mimics if name not in joint_names.values()]
    if unknown:
        raise ValueError(
            f"mimics: no joint {unknown[0]!r}: expected one of {', '.join(joint_names.values())}"
        )
    found = []
    for joint, outward in _outward(plant, joints):
        name = joint_names[joint.index()]
        ends = [body_names[b.index()] for b in (joint.parent_body(), joint.child_body())]
        X_PF, X_CM = (
            frame.GetFixedPoseInBodyFrame().GetAsMatrix4()
            for frame in (joint.frame_on_parent(), joint.frame_on_child())
        )
        kind = KINDS.get(joint.type_name())
        if kind is None or (not outward and kind not in REVERSIBLE):
            expected = ", ".join(KINDS) if kind is None else f"one from the world outwards or {REVERSIBLE}"
            raise ValueError(f"joint {name!r}: expected {expected}, got {joint.type_name()}")
        axis, pitch = _axis(joint, kind)
        if kind == "fixed":
            X_PF = X_PF @ joint.X_FM().GetAsMatrix4()
        X_MC = inverse_pose(X_CM)
        if not outward:
            ends.reverse()
            X_PF, X_MC, axis = X_CM, inverse_pose(X_PF), -axis
        found.append(
            (
                joint.position_start() if joint.num_positions() else -1,
                TreeJoint(
                    name,
                    kind,
                    ends[0],
                    ends[1],
                    X_PF,
                    X_MC,
                    axis,
                    pitch,
                    _limits(joint),
                    mimics.get(name),
                    armatures.get(joint.index(), 0.0),
                ),
            )
        )
    return [joint for _, joint in sorted(found, key=lambda entry: entry[0])]


def inertias(plant: MultibodyPlant) -> dict[str, Inertia]:
    """Returns the inertias of a finalized plant's rigid bodies but the world, by the names that
    `tree_joints` gives them."""
    from workbench.drake.gate import BodyIndex

    bodies = [plant.get_body(BodyIndex(index)) for index in range(1, plant.num_bodies())]
    names, found = _names(plant, [plant.world_body(), *bodies]), {}
    for body in bodies:
        M = body.default_spatial_inertia()
        mass, com = float(M.get_mass()), np.array(M.get_com())
        about_com = M.CalcRotationalInertia().ShiftToCenterOfMass(mass, com).CopyToFullMatrix3()
        found[names[body.index()]] = Inertia(mass, com, about_com)
    return found


def plant_armatures(plant: MultibodyPlant, mjcf: Mjcf | None = None) -> dict[JointIndex, float]:
    """Returns the inertia of the rotors of each joint that has some, (rotor inertia) · (gear ratio)², in kg
    m² or kg: of a plant's actuators, and of the joints of its MJCF file, also of those without an actuator,
    which Drake leaves out.

    Raises ValueError where actuators of one joint differ, or where the joints of both are not the same.
    """
    require_finalized(plant)
    found: dict[JointIndex, float] = {}
    for index in plant.GetJointActuatorIndices():
        actuator = plant.get_joint_actuator(index)
        joint = actuator.joint()
        inertia = actuator.default_rotor_inertia() * actuator.default_gear_ratio() ** 2
        if not isclose(found.setdefault(joint.index(), inertia), inertia):
            raise ValueError(
                f"joint {joint.name()!r}: expected actuators of one inertia, got {found[joint.index()]:g} "
                f"and {inertia:g} of rotor inertia times gear ratio squared"
            )
    if mjcf is None or not any(joint.armature for joint in mjcf.joints):
        return found
    joints = [plant.get_joint(index) for index in plant.GetJointIndices()]
    floating = {j.child_body().name(): j for j in joints if j.type_name().endswith("floating")}
    moving = [j for j in joints if j.type_name() != "weld" and not j.type_name().endswith("floating")]
    written = [joint for joint in mjcf.joints if joint.type != "free"]
    pairs = [(floating[j.body], j) for j in mjcf.joints if j.type == "free" and j.body in floating]
    same = len(moving) == len(written) and all(
        not w.name or w.name == j.name() for j, w in zip(moving, written, strict=True)
    )
    pairs += [*zip(moving, written, strict=False)]
    for joint, one in pairs:
        if not (same and isclose(found.setdefault(joint.index(), one.armature), one.armature)):
            raise ValueError(f"joint {joint.name()!r}: its armature is not understood")
    return found


def _names(plant: MultibodyPlant, elements: Sequence[Any]) -> dict[Any, str]:
    counts = Counter(element.name() for element in elements)
    return {
        element.index(): element.name()
        if counts[element.name()] == 1
        else f"{plant.GetModelInstanceName(element.model_instance())}::{element.name()}"
        for element in elements
    }


def _outward(plant: MultibodyPlant, joints: list[PlantJoint]) -> list[tuple[PlantJoint, bool]]:
    """Returns the joints from the world outwards; True where that is from parent to child."""
    neighbours: dict[Any, list[tuple[Any, PlantJoint, bool]]] = {}
    for joint in joints:
        parent, child = joint.parent_body().index(), joint.child_body().index()
        neighbours.setdefault(parent, []).append((child, joint, True))
        neighbours.setdefault(child, []).append((parent, joint, False))
    world = plant.world_body().index()
    reached, found, waiting = {world}, [], deque([world])
    while waiting:
        for there, joint, outward in neighbours.get(waiting.popleft(), []):
            if there not in reached:
                reached.add(there)
                waiting.append(there)
                found.append((joint, outward))
    return found


def _axis(joint: PlantJoint, kind: str) -> tuple[np.ndarray, float]:
    if kind == "revolute":
        return joint.revolute_axis(), 0.0
    if kind == "prismatic":
        return joint.translation_axis(), 0.0
    if kind == "helical":
        return _screw_axis(joint), joint.screw_pitch() / (2 * pi)
    return np.array([1.0, 0.0, 0.0]), 0.0


def _screw_axis(joint: PlantJoint) -> np.ndarray:
    """Returns the axis of a screw joint, which Drake does not tell: that of its rotation by one radian."""
    plant = joint.GetParentPlant()
    context = plant.CreateDefaultContext()
    positions = plant.GetPositions(context)
    positions[joint.position_start()] = 1.0
    plant.SetPositions(context, positions)
    X_FM = joint.frame_on_child().CalcPose(context, joint.frame_on_parent())
    return X_FM.rotation().ToAngleAxis().axis()


def _limits(joint: PlantJoint) -> Limits:
    if joint.num_positions() != 1:
        return Limits()
    bounds = (
        joint.position_lower_limits(),
        joint.position_upper_limits(),
        joint.velocity_upper_limits(),
        joint.acceleration_upper_limits(),
    )
    return Limits(*(float(b[0]) if np.isfinite(b[0]) else np.nan for b in bounds))
