"""Plants, and Drake's own velocities and accelerations on them."""

from importlib import metadata
from pathlib import Path

import numpy as np
import pytest
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.tree import JacobianWrtVariable

from workbench.drake.plants import (
    CylindricalAxis,
    PlantError,
    body_motion,
    body_named,
    cylindrical_chain,
    free_body,
    load_urdf,
    robot_urdf,
)

HERE = Path(__file__).parent
TWO_ARMS, CRANE = HERE / "two_arms.urdf", HERE / "crane.urdf"
AXES = (
    CylindricalAxis((1 / 3, 2 / 3, -2 / 3), (0.5, 0.25, -0.5)),
    CylindricalAxis((6 / 7, -2 / 7, 3 / 7), (-0.25, 1.0, 0.5)),
)
PLANTS = {
    "chain": (cylindrical_chain(AXES, ("A", "B")), ("A", "B")),
    "two arms": (load_urdf(TWO_ARMS), ("column", "left", "right", "slide", "hand")),
}


def states(plant, count=5, seed=0):
    rng = np.random.default_rng(seed)
    for _ in range(count):
        yield rng.uniform(-2, 2, (3, plant.num_positions())), rng.uniform(-1, 1, 3)


@pytest.mark.parametrize("name", PLANTS)
def test_velocity_and_acceleration_by_jacobian_and_bias(name):
    """V = J v and A = J v̇ + J̇ v, each by another part of Drake."""
    plant, bodies = PLANTS[name]
    context = plant.CreateDefaultContext()
    world = plant.world_frame()
    for body in bodies:
        frame = plant.GetFrameByName(body)
        for (q, v, vdot), p in states(plant):
            motion = body_motion(plant, body, q, v, vdot, p)
            plant.SetPositions(context, q)
            plant.SetVelocities(context, v)
            arguments = (context, JacobianWrtVariable.kV, frame, p, world, world)
            J = plant.CalcJacobianSpatialVelocity(*arguments)
            bias = plant.CalcBiasSpatialAcceleration(*arguments).get_coeffs()
            np.testing.assert_allclose(motion.V_WBp, J @ v, atol=1e-12)
            np.testing.assert_allclose(motion.A_WBp, J @ vdot + bias, atol=1e-11)
            there = plant.CalcPointsPositions(context, frame, p, world).ravel()
            np.testing.assert_allclose(motion.p_WBp, there, atol=1e-13)


@pytest.mark.parametrize("name", PLANTS)
def test_acceleration_is_the_rate_of_velocity(name):
    plant, bodies = PLANTS[name]
    h = 1e-5
    for body in bodies:
        for (q, v, vdot), p in states(plant, seed=1):
            before, after = (
                body_motion(plant, body, q + s * v + s * s / 2 * vdot, v + s * vdot, vdot, p) for s in (-h, h)
            )
            now = body_motion(plant, body, q, v, vdot, p)
            np.testing.assert_allclose((after.V_WBp - before.V_WBp) / (2 * h), now.A_WBp, atol=2e-7)
            rate = (after.p_WBp - before.p_WBp) / (2 * h)
            np.testing.assert_allclose(rate, now.V_WBp[3:], atol=2e-7)


def test_cylindrical_joints_are_screw_displacements():
    """The points of each axis only slide along it; at θ = d = 0 all frames coincide."""
    plant = cylindrical_chain(AXES, ("A", "B"))
    context = plant.CreateDefaultContext()
    X_WB = plant.GetFrameByName("B").CalcPoseInWorld(context)
    assert X_WB.IsNearlyEqualTo(RigidTransform(), 1e-14)
    assert plant.GetPositionNames(False) == ["A_d_x", "A_theta_q", "B_d_x", "B_theta_q"]
    for (q, *_), _p in states(plant):
        plant.SetPositions(context, q)
        for body, parent, axis, d in (("A", "world", AXES[0], q[0]), ("B", "A", AXES[1], q[2])):
            X = plant.GetFrameByName(body).CalcPose(context, plant.GetFrameByName(parent))
            u, c = np.array(axis.direction), np.array(axis.point)
            for along in (0.0, 1.7):
                slid = c + (along + d) * u
                np.testing.assert_allclose(X @ (c + along * u), slid, atol=1e-14)


def test_a_crane_from_the_textbook():
    """Beer and Johnston, Vector Mechanics for Engineers: Dynamics, chapter 15, the raised boom.

    The cab turns at 0.30 rad/s about y while the boom, 12 m long and at 30°, is raised at
    0.50 rad/s relative to it. The book gives three digits, and adds up terms so rounded.
    """
    plant = load_urdf(CRANE)
    q, v = (0.0, np.deg2rad(30.0)), (0.30, 0.50)
    tip = body_motion(plant, "boom", q, v, (0.0, 0.0), p_BoBp_B=(12.0, 0.0, 0.0))
    printed = {
        "ω": (tip.V_WBp[:3], (0, 0.30, 0.50)),
        "v": (tip.V_WBp[3:], (-3.00, 5.20, -3.12)),
        "α": (tip.A_WBp[:3], (0.15, 0, 0)),
        "a": (tip.A_WBp[3:], (-3.54, -1.50, 1.80)),
    }
    for name, (ours, book) in printed.items():
        np.testing.assert_allclose(ours, book, atol=0.0075, err_msg=name)


def test_a_top_from_the_textbook():
    """Hibbeler, Engineering Mechanics: Dynamics (12th edition), Problem 20-2.

    A top turns at 0.6 rad/s about z and spins at 8 rad/s about its axis, 45° up in the yz plane.
    """
    vertical = CylindricalAxis((0.0, 0.0, 1.0), (0.0, 0.0, 0.0))
    tilted = CylindricalAxis((0.0, np.sqrt(0.5), np.sqrt(0.5)), (0.0, 0.0, 0.0))
    plant = cylindrical_chain([vertical, tilted], ["A", "B"])
    top = body_motion(plant, "B", np.zeros(4), (0.0, 0.6, 0.0, 8.0), np.zeros(4))
    np.testing.assert_allclose(top.V_WBp[:3], (0, 5.66, 6.26), atol=0.0051)
    np.testing.assert_allclose(top.A_WBp[:3], (-3.39, 0, 0), atol=0.0051)


def test_free_body_positions_are_roll_pitch_yaw_and_place():
    plant = free_body()
    context = plant.CreateDefaultContext()
    plant.SetPositions(context, [0.0, 0.0, np.pi / 2, 1.0, 2.0, 3.0])
    X_WB = plant.GetFrameByName("B").CalcPoseInWorld(context)
    expected = RigidTransform(RotationMatrix.MakeZRotation(np.pi / 2), [1.0, 2.0, 3.0])
    assert X_WB.IsNearlyEqualTo(expected, 1e-15)


def test_the_base_of_a_urdf_is_welded_to_the_world():
    plant = load_urdf(TWO_ARMS)
    assert plant.num_positions() == 5
    assert plant.IsAnchored(plant.GetBodyByName("base"))


@pytest.mark.parametrize("name, joints", [("panda", 9), ("ur5_robot", 6), ("xarm7", 7)])
def test_robots(name, joints):
    pytest.importorskip("cmeel_pth", reason="the extra 'robots' is not installed")
    assert load_urdf(robot_urdf(name)).num_positions() == joints


# --- bad input -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "content, complaint",
    [
        ("", "Drake cannot read"),
        ("<robot", "Drake cannot read"),
        ("not xml at all", "Drake cannot read"),
        ("<html></html>", "Drake cannot read"),
        ('<robot name="nothing"/>', "holds no body"),
        ('<robot name="r"><link name="a"/><link name="a"/></robot>', "Drake cannot read"),
        (
            '<robot name="r"><link name="a"/><joint name="j" type="spin">'
            '<parent link="a"/><child link="b"/></joint></robot>',
            "Drake cannot read",
        ),
    ],
)
def test_unreadable_urdf(tmp_path, content, complaint):
    path = tmp_path / "bad.urdf"
    path.write_text(content)
    with pytest.raises(PlantError, match=complaint) as caught:
        load_urdf(path)
    assert "\n" not in str(caught.value)


def test_a_missing_urdf_and_a_directory(tmp_path):
    for path in (tmp_path / "none.urdf", tmp_path):
        with pytest.raises(PlantError, match="no URDF file at"):
            load_urdf(path)


def test_robots_that_are_not_installed(monkeypatch):
    def absent(name):
        raise metadata.PackageNotFoundError(name)

    monkeypatch.setattr(metadata, "distribution", absent)
    with pytest.raises(PlantError, match="pip install example-robot-data"):
        load_urdf(robot_urdf("panda"))


def test_an_unknown_robot_lists_the_known_ones():
    pytest.importorskip("cmeel_pth", reason="the extra 'robots' is not installed")
    with pytest.raises(PlantError, match=r"no robot 'pandas'; .* panda, "):
        robot_urdf("pandas")


def test_an_unknown_body_lists_the_known_ones():
    with pytest.raises(PlantError, match=r"no body 'elbow' in the plant; it has .*left, right"):
        body_named(PLANTS["two arms"][0], "elbow")


@pytest.mark.parametrize(
    "state, complaint",
    [
        (([0.0] * 3, [0.0] * 4, [0.0] * 4), r"q needs shape \(4,\), got \(3,\)"),
        (([0.0] * 4, [0.0] * 5, [0.0] * 4), r"v needs shape"),
        (([0.0] * 4, [0.0] * 4, [[0.0] * 4]), r"vdot needs shape"),
    ],
)
def test_states_of_the_wrong_shape(state, complaint):
    with pytest.raises(PlantError, match=complaint):
        body_motion(PLANTS["chain"][0], "B", *state)


def test_axes_and_bodies_must_be_as_many():
    with pytest.raises(PlantError, match="2 axes do not fit 1 bodies"):
        cylindrical_chain(AXES, ("A",))
