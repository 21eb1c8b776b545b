"""Robots of every joint: laws that tie orders, frames and ways together."""

from math import comb

import numpy as np
import pytest
from kinematics.random_robots import NEAR, motion, series_pose, tree

from workbench.kinematics.robot import Mimic, Robot, TreeJoint
from workbench.kinematics.robot.leibniz import (
    about_moving_point,
    origin_derivatives,
    rotation_derivatives,
    turned,
)


@pytest.mark.parametrize("seed", range(3))
def test_twists_are_the_derivatives_of_the_poses(seed):
    """By differences of the poses alone, to the third order."""
    robot = tree(seed)
    q = np.random.default_rng(seed).normal(size=(4, len(robot.positions)))
    found = robot.motion(q)
    h = 1e-3
    weights = {
        1: np.array([1, -8, 0, 8, -1]) / (12 * h),
        2: np.array([-1, 16, -30, 16, -1]) / (12 * h * h),
        3: np.array([-1, 2, 0, -2, 1]) / (2 * h**3),
    }
    for body in robot.bodies:
        X = np.array([series_pose(robot, q, body, i * h) for i in (-2, -1, 0, 1, 2)])
        frame = found.frame(body)
        np.testing.assert_allclose(frame.pose, X[2], **NEAR)
        for n, weight in weights.items():
            rate = np.tensordot(weight, X, axes=1)
            size = 1 + np.abs(rate).max()
            tolerance = {1: 1e-7, 2: 1e-5, 3: 1e-2}[n] * size
            np.testing.assert_allclose(frame.acceleration(n), rate[:3, 3], atol=tolerance)
            np.testing.assert_allclose(frame.Phi[n] @ X[2, :3, :3], rate[:3, :3], atol=tolerance)


@pytest.mark.parametrize("expressed", ["world", "mixed", "body"])
@pytest.mark.parametrize("seed", range(3))
def test_twists_are_sums_of_jacobian_derivatives_and_velocities(seed, expressed):
    """V⁽ᵏ⁾ = Σ C(k,i) J⁽ⁱ⁾ v⁽ᵏ⁻ⁱ⁾ of every body and a point of it, at a batch of states."""
    robot = tree(seed)
    found, order = motion(robot, 5, (2, 3), seed), 5
    options = {"point": (0.1, -0.2, 0.3), "expressed": expressed}
    for frame in found.frames:
        J = [frame.jacobian(k, **options) for k in range(order + 1)]
        for k in range(order):
            terms = [comb(k, i) * (J[i] @ found.rates[k - i][..., None])[..., 0] for i in range(k + 1)]
            V = frame.velocity(k, **options)
            np.testing.assert_allclose(sum(terms), V, rtol=0, atol=1e-12 * max(1, np.abs(V).max()))


def test_the_jacobian_gives_the_velocity_of_the_point():
    found, point = motion(tree(2), 5, (2,)), (0.1, -0.2, 0.3)
    for frame in found.frames:
        R = frame.pose[..., :3, :3].swapaxes(-1, -2)
        for k in range(5):
            V = frame.velocity(k, point=point)
            np.testing.assert_allclose(V[..., :3], frame.twist(k).angular, **NEAR)
            size = max(1, np.abs(V).max())
            np.testing.assert_allclose(
                V[..., 3:], frame.point(point).derivative(k + 1), rtol=0, atol=1e-11 * size
            )
            np.testing.assert_array_equal(frame.velocity(k, expressed="world"), frame.origin_twist[k])
        in_body = frame.velocity(0, point=point, expressed="body")
        np.testing.assert_allclose(
            in_body[..., 3:], (R @ frame.point(point).velocity[..., None])[..., 0], **NEAR
        )


@pytest.mark.parametrize("expressed", ["world", "mixed", "body"])
def test_jacobian_derivatives_are_rates(expressed):
    """dᵏJ/dtᵏ by differences of the (k-1)-st, along a path; no identity is assumed."""
    robot = tree(1, ["floating_rpy", "revolute", "universal", "helical", "prismatic"])
    q = np.random.default_rng(1).normal(size=(6, len(robot.positions)))
    h, options = 1e-4, {"point": (0.3, 0.1, -0.2), "expressed": expressed}

    def at(t):
        rows = []
        for k in range(len(q)):
            factor = np.cumprod([1, *(t / i for i in range(1, len(q) - k))])
            rows.append(np.tensordot(factor, q[k:], axes=1))
        return robot.motion(np.array(rows)).frame("b4")

    before, now, after = at(-h), at(0.0), at(h)
    for k in range(1, 5):
        rate = (after.jacobian(k - 1, **options) - before.jacobian(k - 1, **options)) / (2 * h)
        close = 1e-6 * max(1, np.abs(rate).max())
        np.testing.assert_allclose(now.jacobian(k, **options), rate, atol=close)


def test_a_batch_is_its_states():
    robot = tree(2)
    whole = motion(robot, 4, (3,))
    q = np.random.default_rng(0).normal(size=(5, 3, len(robot.positions)))
    for state in range(3):
        one = robot.motion(q[:, state])
        for body in ("world", *robot.bodies):
            np.testing.assert_allclose(whole.frame(body).twists[:, state], one.frame(body).twists, **NEAR)
            np.testing.assert_allclose(
                whole.frame(body).jacobian(3)[state], one.frame(body).jacobian(3), **NEAR
            )
            assert whole.frame(body).centre(2).kind[state] == one.frame(body).centre(2).kind


def test_velocities_and_coordinates_say_the_same():
    robot = tree(3)
    by_coordinates = motion(robot, 5)
    by_velocities = robot.motion(by_coordinates.q, by_coordinates.rates)
    for body in robot.bodies:
        np.testing.assert_allclose(
            by_coordinates.frame(body).twists, by_velocities.frame(body).twists, **NEAR
        )


# -- relative motion -------------------------------------------------------------------------------


def composed_twist(A, twist_AB):
    """V_WB = V_WA + Ad(X_WA) V_AB with its derivatives, about W's origin; twist_AB about A's origin, in A."""
    p = origin_derivatives(A.twists, A.pose[..., :3, 3])
    R = rotation_derivatives(A.twists[..., :3], A.pose[..., :3, :3])
    return A.origin_twist + about_moving_point(turned(R, twist_AB), -p)


@pytest.mark.parametrize("seed", range(3))
def test_base_and_relative_motion_compose(seed):
    found = motion(tree(seed), 6, (2,), seed)
    for base in ("world", "b1", "b4"):
        A = found.frame(base)
        for name in ("world", "b2", "b5"):
            B = found.frame(name)
            relative = B.relative_to(A)
            np.testing.assert_allclose(A.pose @ relative.pose, B.pose, **NEAR)
            twist = composed_twist(A, relative.origin_twist)
            scale = max(1, np.abs(A.origin_twist).max()) ** 2
            np.testing.assert_allclose(twist, B.origin_twist, rtol=0, atol=1e-10 * scale)


def test_a_neighbour_s_relative_motion_is_the_joint_s_alone():
    robot = tree(4, ["floating", "ball", "revolute", "helical"])
    q = np.random.default_rng(4).normal(size=(6, len(robot.positions)))
    found = robot.motion(q)
    alone = Robot("one", [TreeJoint(**{**vars(robot.joints[3]), "parent": "world"})])
    expected = alone.motion(q[:, -1:]).frame("b3")
    relative = found.frame("b3").relative_to(found.frame(robot.joints[3].parent))
    np.testing.assert_allclose(relative.twists, expected.twists, rtol=0, atol=1e-9)
    np.testing.assert_allclose(
        relative.point((0.1, 0.2, 0.3)).jerk, expected.point((0.1, 0.2, 0.3)).jerk, atol=1e-9
    )


# -- mimic joints ----------------------------------------------------------------------------------


def test_a_mimic_joint_follows_in_all_orders_and_the_jacobian():
    rng = np.random.default_rng(9)
    free = tree(9, ["revolute", "prismatic", "revolute", "revolute"])
    joints = [TreeJoint(**vars(j)) for j in free.joints]
    joints[1] = TreeJoint(**{**vars(joints[1]), "mimic": Mimic("j0", 0.4, 0.1)})
    joints[3] = TreeJoint(**{**vars(joints[3]), "mimic": Mimic("j1", -2.0, 0.3)})  # of one that mimics
    robot = Robot("gripper", joints)
    assert robot.positions == ("j0", "j2")
    q = rng.normal(size=(5, 2, 2))
    full = np.zeros((5, 2, 4))
    full[..., 0], full[..., 2] = q[..., 0], q[..., 1]
    full[..., 1], full[..., 3] = 0.4 * q[..., 0], -0.8 * q[..., 0]
    full[0, ..., 1] += 0.1
    full[0, ..., 3] += 0.3 - 2.0 * 0.1
    found, expected = robot.motion(q), free.motion(full)
    for body in robot.bodies:
        np.testing.assert_allclose(found.frame(body).pose, expected.frame(body).pose, **NEAR)
        np.testing.assert_allclose(found.frame(body).twists, expected.frame(body).twists, **NEAR)
        J = [found.frame(body).jacobian(k) for k in range(4)]
        V = sum(comb(3, i) * (J[i] @ found.rates[3 - i][..., None])[..., 0] for i in range(4))
        np.testing.assert_allclose(V, found.frame(body).velocity(3), rtol=0, atol=1e-10)
    assert not found.frame("b0").jacobian()[..., 1].any()
