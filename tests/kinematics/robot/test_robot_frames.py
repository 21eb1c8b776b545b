"""Relative Jacobians, rotations of a pose, tool frames, and the inverse near singular positions."""

from math import comb

import numpy as np
import pytest
from drake_arms import arm_plant
from kinematics.random_chains import close
from kinematics.random_robots import NEAR, joint, motion, random_pose, tree

from workbench.kinematics.robot import Robot, SingularJacobian, TreeJoint
from workbench.kinematics.robot.balls import quaternion_of_rpy, rotation_of_rpy
from workbench.kinematics.robot.robot_frames import FrameMotion


def serial_arm():
    """Seven turning joints in a row."""
    rng = np.random.default_rng(6)
    return Robot("arm", [joint(rng, i, "revolute", f"b{i - 1}" if i else "world") for i in range(7)])


# -- relative Jacobians ------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(3))
def test_relative_twists_are_sums_of_relative_jacobians(seed):
    """V_AB⁽ᵏ⁾ = Σ C(k,i) J_AB⁽ⁱ⁾ v⁽ᵏ⁻ⁱ⁾ between any two frames, at one state and at a batch."""
    robot, order = tree(seed), 4
    for states in ((), (2, 3)):
        found = motion(robot, order, states, seed)
        for A, B in (("b1", "b5"), ("b4", "b2"), ("world", "b3"), ("b6", "world")):
            relative = found.frame(B).relative_to(found.frame(A))
            J = [relative.jacobian(k) for k in range(order + 1)]
            for k in range(order):
                terms = [comb(k, i) * (J[i] @ found.rates[k - i][..., None])[..., 0] for i in range(k + 1)]
                close(sum(terms), relative.twists[k], 11)


def test_the_relative_jacobian_to_the_world_is_the_jacobian():
    found = motion(tree(1), 3, (4,))
    frame = found.frame("b7")
    for k in range(4):
        close(frame.relative_to(found.frame("world")).jacobian(k), frame.jacobian(k), 13)
    with pytest.raises(ValueError, match="order: expected one from 0 to 3"):
        frame.relative_to(found.frame("world")).jacobian(4)


def test_relative_jacobians_are_drake_s():
    from pydrake.multibody.tree import JacobianWrtVariable

    plant = arm_plant()
    robot = Robot.from_plant(plant)
    q, v = np.random.default_rng(1).normal(size=(2, plant.num_positions()))
    context = plant.CreateDefaultContext()
    plant.SetPositions(context, q)
    A, B = (plant.GetBodyByName(name).body_frame() for name in ("l1", "l5"))
    J = plant.CalcJacobianSpatialVelocity(context, JacobianWrtVariable.kV, B, [0, 0, 0], A, A)
    found = robot.motion(np.stack([q, v]))
    np.testing.assert_allclose(found.frame("l5").relative_to(found.frame("l1")).jacobian(), J, **NEAR)


# -- rotations -----------------------------------------------------------------------------------------------


def test_quaternions_and_angles_give_the_rotation_back():
    """At random, and next to all angles at which a formula may fail."""
    rng = np.random.default_rng(0)
    special = np.array([0, np.pi / 2, -np.pi / 2, np.pi, 1e-9, np.pi / 2 - 1e-9, np.pi / 2 - 1e-14])
    grid = np.stack(np.meshgrid(special, special, special), axis=-1).reshape(-1, 3)
    for rpy in (rng.uniform(-4, 4, (500, 3)), grid):
        R = rotation_of_rpy(rpy)
        X = np.broadcast_to(np.eye(4), (len(R), 4, 4)).copy()
        X[:, :3, :3] = R
        frame = FrameMotion("F", 1, X, np.zeros((1, len(R), 6)))
        np.testing.assert_allclose(rotation_of_rpy(frame.rpy), R, rtol=0, atol=2e-12)
        q = frame.quaternion
        assert (q[:, 0] >= 0).all()
        np.testing.assert_allclose(np.linalg.norm(q, axis=-1), 1, atol=1e-15)
        same = np.abs((q * quaternion_of_rpy(rpy)).sum(axis=-1))  # the other sign is the same rotation
        np.testing.assert_allclose(same, 1, atol=1e-14)


def test_rotations_of_a_pose_are_drake_s():
    from pydrake.math import RigidTransform, RollPitchYaw

    frame = motion(tree(2), 1).frame("b4")
    X = RigidTransform(frame.pose)
    np.testing.assert_allclose(frame.rpy, RollPitchYaw(X.rotation()).vector(), **NEAR)
    wxyz = X.rotation().ToQuaternion().wxyz()
    np.testing.assert_allclose(frame.quaternion, wxyz * np.sign(wxyz[0]), **NEAR)


# -- tool frames -----------------------------------------------------------------------------------------------


def test_a_tool_frame_moves_as_a_point_of_its_body():
    robot, X = tree(3), random_pose(np.random.default_rng(3))
    with_tool = robot.with_frame("tool", "b5", X)
    assert with_tool.positions == robot.positions and set(with_tool.bodies) - set(robot.bodies) == {"tool"}
    found, plain = motion(with_tool, 4, (3,)), motion(robot, 4, (3,))
    tool, body = found.frame("tool"), plain.frame("b5")
    np.testing.assert_allclose(tool.pose, body.pose @ X, **NEAR)
    close(tool.point().derivatives, body.point(X[:3, 3]).derivatives, 12)
    np.testing.assert_allclose(tool.jacobian(2), body.jacobian(2, point=X[:3, 3]), **NEAR)
    with pytest.raises(ValueError, match="frame 'b1': the robot has a body of that name"):
        robot.with_frame("b1", "b5", X)
    with pytest.raises(ValueError, match="expected a rigid transform"):
        robot.with_frame("tool", "b5", 2 * X)
    with pytest.raises(ValueError, match="no body 'hand'"):
        robot.with_frame("tool", "hand", X)


# -- inverse -----------------------------------------------------------------------------------------------------


def test_the_inverse_of_a_relative_twist_gives_it_back():
    robot = serial_arm()
    q = np.random.default_rng(6).normal(size=(2, 7))
    wanted = np.random.default_rng(7).normal(size=(3, 2, 3))
    rates = robot.inverse("b6", q, wanted, rows=(3, 4, 5), relative_to="b1")
    found = robot.motion(q, rates)
    relative = found.frame("b6").relative_to(found.frame("b1"))
    np.testing.assert_allclose(relative.twists[..., 3:], wanted, atol=1e-9)
    np.testing.assert_allclose(rates[..., :2], 0, atol=1e-9)  # the base moves both
    with pytest.raises(ValueError, match="relative_to: expected no `expressed` and no `point`"):
        robot.inverse("b6", q, wanted, rows=(3, 4, 5), relative_to="b1", point=(1, 0, 0))


def test_little_damping_gives_the_inverse():
    robot = serial_arm()
    q, wanted = np.random.default_rng(6).normal(size=7), np.random.default_rng(7).normal(size=(3, 6))
    found = robot.inverse_damped("b6", q, wanted, 1e-7)
    np.testing.assert_allclose(found.rates, robot.inverse("b6", q, wanted), rtol=1e-6)
    assert np.abs(found.residual).max() < 1e-6


def test_the_damped_inverse_states_what_it_misses():
    """A stretched planar arm cannot move along itself: all of that is missed, the rest is reached."""
    robot = Robot("planar", stretched())
    q = np.zeros(3)
    wanted = np.array([[1.0, 0.0], [0.0, 1.0]])  # x, y velocity, then acceleration
    with pytest.raises(SingularJacobian):
        robot.inverse("c", q, wanted, rows=(3, 4))
    rates, residual = robot.inverse_damped("c", q, wanted, 1e-3, rows=(3, 4))
    np.testing.assert_allclose(residual[0], [1.0, 0.0], atol=1e-12)
    np.testing.assert_allclose(residual[1], [0.0, 0.0], atol=1e-6)
    twists = robot.motion(q, rates).frame("c").twists
    np.testing.assert_allclose(twists[:, 3:5] + residual, wanted, atol=1e-12)
    J = robot.motion(q, rates).frame("c").jacobian()[3:5]
    for k in range(2):  # the gradient of |J v − b|² + λ² |v|² vanishes
        np.testing.assert_allclose(J.T @ residual[k], 1e-6 * rates[k], atol=1e-12)
    with pytest.raises(ValueError, match="damping: expected a number > 0, got 0"):
        robot.inverse_damped("c", q, wanted, 0, rows=(3, 4))


def stretched():
    link, z = np.eye(4), np.array([0.0, 0.0, 1.0])
    link[0, 3] = 1.0
    names = ["world", "a", "b", "c"]
    return [
        TreeJoint(f"j{i}", "revolute", names[i], names[i + 1], X_MC=link, axis=z, X_PF=np.eye(4))
        for i in range(3)
    ]
