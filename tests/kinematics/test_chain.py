"""Serial chains: laws over many random chains, and bad input."""

from math import comb, factorial

import numpy as np
import pytest
from kinematics.random_chains import MOVING, close, random_joint, random_joints
from kinematics.random_robots import random_pose

from workbench.kinematics.chain import Joint, SerialChain


def adjoint(X):
    """Ad(X) on (ω; v)."""
    Ad = np.zeros((6, 6))
    Ad[:3, :3] = Ad[3:, 3:] = X[:3, :3]
    Ad[3:, :3] = np.cross(np.eye(3), X[:3, 3]) @ X[:3, :3]
    return Ad


def bracket(A, B):
    """The Lie product of twists: (ω × ω', ω × v' + v × ω')."""
    return np.concatenate([np.cross(A[:3], B[:3]), np.cross(A[:3], B[3:]) + np.cross(A[3:], B[:3])])


# -- laws ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", MOVING)
def test_one_joint_turns_about_its_constant_screw(kind):
    rng = np.random.default_rng(1)
    joint = random_joint(rng, kind)
    chain = SerialChain([joint])
    q = rng.normal(size=(7, chain.dof))
    rotation = np.concatenate([joint.axis, np.cross(joint.point, joint.axis)])
    translation = np.concatenate([np.zeros(3), joint.axis])
    screws = {
        "revolute": [rotation],
        "prismatic": [translation],
        "cylindrical": [rotation, translation],
        "helical": [rotation + joint.pitch * translation],
    }[kind]
    close(chain.twist_derivatives(q), q[1:] @ np.array(screws), 14)


@pytest.mark.parametrize("first", MOVING)
@pytest.mark.parametrize("second", MOVING)
def test_two_joints_obey_the_leibniz_rule_with_the_bracket(first, second):
    """V₁₂ = V₁ + W with W = Ad(X₁) V₂, hence W' = [V₁, W] + Ad(X₁) V₂' and so on, Eq. (123)."""
    rng = np.random.default_rng(2)
    joints = [random_joint(rng, first), random_joint(rng, second)]
    inner, outer, both = SerialChain(joints[:1]), SerialChain(joints[1:]), SerialChain(joints)
    q = rng.normal(size=(9, both.dof))
    V1 = inner.twist_derivatives(q[:, : inner.dof])
    relative = outer.twist_derivatives(q[:, inner.dof :]) @ adjoint(inner.pose(q[0, : inner.dof])).T
    carried = {(0, k): relative[k] for k in range(8)}  # (j, k): j-th derivative of Ad(X₁) V₂^(k)
    for j in range(1, 8):
        for k in range(8 - j):
            carried[j, k] = carried[j - 1, k + 1]
            for i in range(j):
                carried[j, k] = carried[j, k] + comb(j - 1, i) * bracket(V1[i], carried[j - 1 - i, k])
    close(both.twist_derivatives(q), [V1[n] + carried[n, 0] for n in range(8)])


@pytest.mark.parametrize("seed", range(10))
def test_the_twist_is_the_velocity_of_the_pose(seed):
    rng = np.random.default_rng(seed)
    chain = SerialChain(random_joints(rng, 6))
    q = rng.normal(size=(2, chain.dof))
    h = 1e-5
    X_dot = (chain.pose(q[0] + h * q[1]) - chain.pose(q[0] - h * q[1])) / (2 * h)
    W = X_dot @ np.linalg.inv(chain.pose(q[0]))
    close(chain.twist_derivatives(q)[0], [W[2, 1], W[0, 2], W[1, 0], *W[:3, 3]], 8)


@pytest.mark.parametrize("seed", range(10))
def test_equivariance_under_change_of_base_frame(seed):
    rng = np.random.default_rng(seed)
    joints, X = random_joints(rng, 6), random_pose(rng)
    chain, moved = SerialChain(joints), SerialChain([Joint.fixed(X), *joints])
    q = rng.normal(size=(7, 3, chain.dof))
    close(moved.twist_derivatives(q), chain.twist_derivatives(q) @ adjoint(X).T)
    close(moved.pose(q[0]), X @ chain.pose(q[0]))


@pytest.mark.parametrize("seed", range(10))
def test_fixed_joints_merge(seed):
    rng = np.random.default_rng(seed)
    A, B = random_pose(rng), random_pose(rng)
    before, after = random_joints(rng, 3), random_joints(rng, 3)
    split = SerialChain([*before, Joint.fixed(A), Joint.fixed(B), *after, Joint.fixed(A)])
    merged = SerialChain([*before, Joint.fixed(A @ B), *after])
    q = rng.normal(size=(6, split.dof))
    close(split.twist_derivatives(q), merged.twist_derivatives(q))
    close(split.pose(q[0]), merged.pose(q[0]) @ A)


@pytest.mark.parametrize("seed", range(10))
def test_an_axis_is_independent_of_its_point_and_length(seed):
    rng = np.random.default_rng(seed)
    axis, point = rng.normal(size=3), rng.normal(size=3)
    tail = random_joints(rng, 3)
    one = SerialChain([*tail, Joint.revolute(axis, point), *tail])
    other = SerialChain([*tail, Joint.revolute(7 * axis, point + 3 * axis), *tail])
    q = rng.normal(size=(6, one.dof))
    close(one.twist_derivatives(q), other.twist_derivatives(q))


@pytest.mark.parametrize("seed", range(5))
def test_composite_joints_are_products_of_simple_ones(seed):
    rng = np.random.default_rng(seed)
    axis, point = rng.normal(size=3), rng.normal(size=3)
    head, tail = random_joints(rng, 2), random_joints(rng, 2)
    pair = SerialChain([*head, Joint.revolute(axis, point), Joint.prismatic(axis), *tail])
    cylindrical = SerialChain([*head, Joint.cylindrical(axis, point), *tail])
    q = rng.normal(size=(7, pair.dof))
    close(cylindrical.twist_derivatives(q), pair.twist_derivatives(q))
    helical = SerialChain([*head, Joint.helical(axis, point, pitch=0.3), *tail])
    angle = SerialChain(head).dof
    q[:, angle + 1] = 0.3 * q[:, angle]
    close(helical.twist_derivatives(np.delete(q, angle + 1, axis=1)), pair.twist_derivatives(q))


@pytest.mark.parametrize("tilt", [0, 1e-300, 1e-17, 1e-15, 1e-12, 1e-8, 1e-3, 0.09, 0.11])
@pytest.mark.parametrize("apart", [0, 1e-12, 1])
def test_neighbouring_axes_may_be_nearly_parallel_or_intersect(tilt, apart):
    """Against Eq. (119) for three joints, no derivative taken."""
    joints = [
        Joint.revolute([0, 0, 1], [0.1, 0.2, 0.3]),
        Joint.revolute([tilt, 0, 1], [0.1 + apart, 0.2 + 2 * apart, 5]),
        Joint.revolute([1, 2, 3], [0.5, -0.4, 0.3]),
    ]
    q = np.array([[0.7, 0.4, 0.2], [1.1, -0.6, 0.9]])
    expected, X = np.zeros(6), np.eye(4)
    for joint, (angle, rate) in zip(joints, q.T, strict=True):
        screw = np.concatenate([joint.axis, np.cross(joint.point, joint.axis)])
        expected += adjoint(X) @ screw * rate
        X = X @ SerialChain([joint]).pose([angle])
    close(SerialChain(joints).twist_derivatives(q)[0], expected, 14)


@pytest.mark.parametrize("states", [(1,), (5,), (8,), (19,), (2, 3), (0,)])
def test_a_batch_is_its_states(states):
    rng = np.random.default_rng(3)
    chain = SerialChain(random_joints(rng, 6))
    for n in (0, 1, 4, 7):
        q = rng.normal(size=(n + 2, *states, chain.dof))
        V = chain.twist_derivatives(q)
        assert V.shape == (n + 1, *states, 6)
        for state in np.ndindex(states):
            close(V[:, *state], chain.twist_derivatives(q[:, *state]), 13)


def test_derivatives_are_taylor_coefficients_times_factorials():
    rng = np.random.default_rng(4)
    chain = SerialChain(random_joints(rng, 4))
    q = rng.normal(size=(8, chain.dof))
    factorials = np.array([factorial(k) for k in range(8)], dtype=float)
    V = chain.twist_taylor(q / factorials[:, None])
    close(V * factorials[:7, None], chain.twist_derivatives(q), 14)


def test_a_longer_series_begins_with_the_shorter_one():
    rng = np.random.default_rng(5)
    chain = SerialChain(random_joints(rng, 5))
    q = rng.normal(size=(12, chain.dof))
    for n in range(10):
        shorter, longer = chain.twist_derivatives(q[: n + 2]), chain.twist_derivatives(q)
        close(shorter, longer[: n + 1], 13)


# -- what bad input gets ---------------------------------------------------------------------------


def test_bad_joints_are_named():
    with pytest.raises(ValueError, match="revolute joint: axis: expected non-zero length"):
        Joint.revolute([0, 0, 0])
    for raw in (("spin", [0, 0, 1], 1.0), ("revolute", [0, 0], 1.0), ("helical", [0, 0, 1], np.nan)):
        with pytest.raises(ValueError, match="expected"):
            Joint(raw[0], raw[1], [0, 0, 0], raw[2], np.eye(4))
    with pytest.raises(ValueError, match="cylindrical joint: point: expected three finite"):
        Joint.cylindrical([0, 0, 1], [0, 1])
    with pytest.raises(ValueError, match="prismatic joint: axis: expected three finite"):
        Joint.prismatic([0, np.nan, 1])
    with pytest.raises(ValueError, match="expected a finite pitch, got inf"):
        Joint.helical([0, 0, 1], pitch=float("inf"))
    with pytest.raises(ValueError, match="expected a rigid transform"):
        Joint.fixed(np.diag([1, 1, -1, 1]))
    with pytest.raises(ValueError, match=r"expected a \(4, 4\) transform, got shape \(3, 3\)"):
        Joint.fixed(np.eye(3))


@pytest.mark.parametrize("size", [1e200, 1e-200, 5e-324, 1e308])
def test_an_axis_of_any_length_is_a_direction(size):
    np.testing.assert_allclose(Joint.revolute([size, size, 0]).axis, [0.5**0.5, 0.5**0.5, 0], atol=1e-15)


def test_bad_chains_are_named():
    with pytest.raises(ValueError, match="at least one moving joint"):
        SerialChain([Joint.fixed(np.eye(4))])
    with pytest.raises(TypeError, match="joint 1: expected a Joint, got str"):
        SerialChain([Joint.prismatic([1, 0, 0]), "revolute"])


def test_bad_derivatives_are_named():
    chain = SerialChain([Joint.revolute([0, 0, 1]), Joint.prismatic([1, 0, 0])])
    with pytest.raises(ValueError, match=r"shape \(n \+ 2, \.\.\., 2\).*order first.*got \(3, 4\)"):
        chain.twist_derivatives(np.zeros((3, 4)))
    with pytest.raises(ValueError, match=r"got \(1, 2\)"):
        chain.twist_derivatives(np.zeros((1, 2)))
    with pytest.raises(ValueError, match="expected real joint derivatives"):
        chain.twist_derivatives(np.zeros((4, 2), dtype=complex))
    with pytest.raises(ValueError, match=r"out: expected a writable .* shape \(3, 6\), got"):
        chain.twist_derivatives(np.zeros((4, 2)), np.zeros((2, 6)))
    with pytest.raises(ValueError, match="at most 170, got 171; use twist_taylor"):
        chain.twist_derivatives(np.zeros((173, 2)))
    with pytest.raises(ValueError, match=r"coordinates of shape \(\.\.\., 2\), got \(3,\)"):
        chain.pose(np.zeros(3))
