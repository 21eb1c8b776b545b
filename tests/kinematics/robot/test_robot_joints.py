"""Each kind of joint, from a URDF and from a Drake plant, beside Taylor forward kinematics of fifty digits."""

from functools import cache

import numpy as np
import pytest
from kinematics.taylor_kinematics import derivatives, exact, joint, pose, product, rpy, taylor
from mpmath import mpf

from workbench.kinematics.robot import Mimic, Robot, TreeJoint

ORDER = 8
POINT = (0.3, -0.2, 0.5)
AXIS, PITCH = (1.0, -2.0, 0.5), 0.7
PLACE, ANGLES = (0.4, -0.1, 0.2), (0.3, -0.8, 1.1)


@cache
def origin():
    """The pose of an <origin>."""
    return product(pose(place=exact(PLACE), terms=1), rpy(*exact(ANGLES)[:, None]))[0]


def coordinates(count):
    return np.random.default_rng(count).uniform(-1, 1, size=(ORDER + 1, count))


def assert_moves_so(robot, q, body, X):
    """A point's position with its derivatives, and Φₙ R, by coordinates and by velocities, to 1e-12."""
    X = derivatives(X)
    scale = np.abs(X).max(axis=(1, 2), initial=1)
    assert len(robot.positions) == q.shape[1]
    by_coordinates = robot.motion(q)
    for motion in (by_coordinates, robot.motion(q[0], by_coordinates.rates)):
        found = motion.frame(body)
        off = found.point(POINT).derivatives - (X[:, :3, :3] @ POINT + X[:, :3, 3])
        assert (np.abs(off).max(axis=1) < 1e-12 * scale).all()
        off = found.Phi @ found.pose[:3, :3] - X[:, :3, :3]
        assert (np.abs(off).max(axis=(1, 2)) < 1e-12 * scale).all()


URDF = """<robot name="r" xmlns:drake="http://drake.mit.edu"><link name="a"/><link name="b"/><link name="c"/>
<joint name="first" type="revolute"><parent link="a"/><child link="b"/><limit effort="1" velocity="1" lower="-9" upper="9"/>
<origin xyz="0.4 -0.1 0.2" rpy="0.3 -0.8 1.1"/><axis xyz="1 -2 0.5"/></joint>
<{prefix}joint name="second" type="{type}"><parent link="b"/><child link="c"/>
<origin xyz="0.4 -0.1 0.2" rpy="0.3 -0.8 1.1"/>{more}</{prefix}joint></robot>"""
LIMIT = '<limit effort="1" velocity="1" lower="-9" upper="9"/>'
SLANTED = '<axis xyz="1 -2 0.5"/>'
OF_URDF = {  # type: (what stands in the joint, kind, its coordinates)
    "revolute": (SLANTED + LIMIT, "revolute", 1),
    "continuous": (SLANTED, "revolute", 1),
    "prismatic": (SLANTED + LIMIT, "prismatic", 1),
    "planar": ('<axis xyz="0 0 1"/>', "planar", 3),
    "floating": ("", "floating", 7),
    "drake:ball": ("", "ball_rpy", 3),
    "drake:screw": (f'{SLANTED}<drake:screw_thread_pitch value="{2 * np.pi * PITCH!r}"/>', "helical", 1),
    "drake:universal": ("", "universal", 2),
}


@pytest.mark.parametrize("type_", OF_URDF)
def test_a_joint_of_a_urdf(type_, tmp_path):
    more, kind, count = OF_URDF[type_]
    prefix, colon, name = type_.rpartition(":")
    path = tmp_path / "robot.urdf"
    path.write_text(URDF.format(prefix=prefix + colon, type=name, more=more))
    for rotations in ("quaternion", "rpy") if kind == "floating" else ("quaternion",):
        if rotations == "rpy":
            kind, count = "floating_rpy", 6
        robot, q = Robot.from_urdf(path, rotations=rotations), coordinates(1 + count)
        first, second = taylor(q[:, :1]), taylor(q[:, 1:])
        X = product(origin() @ joint("revolute", first, AXIS), origin() @ joint(kind, second, AXIS, PITCH))
        assert_moves_so(robot, q, "c", X)


def test_joints_that_no_file_has_and_one_that_mimics():
    arm = TreeJoint("arm", "cylindrical", "world", "b", axis=AXIS)
    lid = TreeJoint("lid", "revolute", "b", "c", axis=AXIS, mimic=Mimic("key", -2.0, 0.3))
    key = TreeJoint("key", "helical", "c", "d", axis=(0, 1, 0), pitch=PITCH)
    head = TreeJoint("head", "ball", "d", "e")
    q = coordinates(7)
    series = taylor(q)
    follows = -2 * series[:, 2:3]
    follows[0] += mpf(0.3)
    X = product(joint("cylindrical", series[:, :2], AXIS), joint("revolute", follows, AXIS))
    X = product(product(X, joint("helical", series[:, 2:3], (0, 1, 0), PITCH)), joint("ball", series[:, 3:]))
    assert_moves_so(Robot("r", [arm, lid, key, head]), q, "e", X)


OF_PLANT = {  # kind: Drake's class and what it wants after the frames
    "revolute": ("RevoluteJoint", [AXIS]),
    "prismatic": ("PrismaticJoint", [AXIS]),
    "helical": ("ScrewJoint", [AXIS, 2 * np.pi * PITCH, 0.0]),
    "universal": ("UniversalJoint", []),
    "planar": ("PlanarJoint", []),
    "ball_rpy": ("BallRpyJoint", []),
    "floating": ("QuaternionFloatingJoint", []),
    "floating_rpy": ("RpyFloatingJoint", []),
}


@pytest.mark.parametrize("kind", OF_PLANT)
def test_a_joint_of_a_plant(kind):
    """Behind a revolute joint, between frames fixed in both bodies."""
    from pydrake.math import RigidTransform, RollPitchYaw
    from pydrake.multibody import tree
    from pydrake.multibody.plant import MultibodyPlant

    plant = MultibodyPlant(0.0)
    inertia = tree.SpatialInertia.SolidSphereWithDensity(1000, 0.1)
    b, c = (plant.AddRigidBody(name, inertia) for name in "bc")
    X_BF = RigidTransform(RollPitchYaw(*ANGLES), PLACE)
    F, M = (
        plant.AddFrame(tree.FixedOffsetFrame(body.name() + "_", body, X))
        for body, X in ((b, X_BF), (c, X_BF.inverse()))
    )
    plant.AddJoint(tree.RevoluteJoint("first", plant.world_frame(), b.body_frame(), AXIS))
    name, more = OF_PLANT[kind]
    plant.AddJoint(getattr(tree, name)("second", F, M, *more))
    plant.Finalize()
    q = coordinates(plant.num_positions())
    first, second = taylor(q[:, :1]), taylor(q[:, 1:])
    X = product(joint("revolute", first, AXIS) @ origin(), joint(kind, second, AXIS, PITCH) @ origin())
    assert_moves_so(Robot.from_plant(plant), q, "c", X)
