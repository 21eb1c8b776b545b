"""Robots of every joint: laws that tie orders, frames and ways together, and Drake's own numbers."""

import gc
import weakref
from math import comb

import numpy as np
import pytest

from workbench.kinematics.robot import Mimic, Robot, SingularJacobian, TreeJoint
from workbench.kinematics.robot.joints import COORDINATES
from workbench.kinematics.robot.leibniz import composed_twist

KINDS = tuple(COORDINATES)
NEAR = {"rtol": 0, "atol": 1e-10}


def pose(rng):
    Q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = Q * np.linalg.det(Q), rng.uniform(-1, 1, 3)
    return X


def joint(rng, number, kind, parent):
    return TreeJoint(f"j{number}", kind, parent, f"b{number}", pose(rng), pose(rng), rng.normal(size=3), 0.3)


def tree(seed, kinds=None):
    """A tree of joints of all kinds; every third one branches off."""
    rng = np.random.default_rng(seed)
    kinds = rng.permutation(KINDS) if kinds is None else kinds
    parents = ["world" if i == 0 else f"b{i - 1 - (i > 1 and i % 3 == 0)}" for i in range(len(kinds))]
    return Robot("tree", [joint(rng, *entry) for entry in zip(range(99), kinds, parents, strict=False)])


def motion(robot, order, states=(), seed=0):
    rng = np.random.default_rng(seed)
    q = rng.normal(size=(order + 1, *states, len(robot.positions)))
    return robot.motion(q)


def series_pose(robot, q_derivatives, body, t):
    """X_WB at the time t on the path with these derivatives at 0."""
    factor = np.cumprod([1, *(t / k for k in range(1, len(q_derivatives)))])
    at = np.tensordot(factor, q_derivatives, axes=1)
    return robot.motion(np.stack([at, at])).frame(body).pose


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


@pytest.mark.parametrize("kind", KINDS)
def test_each_joint_alone_against_differences(kind):
    robot = tree(5, ["revolute", kind, "prismatic"])
    q = np.random.default_rng(5).normal(size=(3, len(robot.positions)))
    h = 1e-4
    before, now, after = (series_pose(robot, q, "b2", t) for t in (-h, 0, h))
    frame = robot.motion(q).frame("b2")
    np.testing.assert_allclose(frame.point().velocity, (after - before)[:3, 3] / (2 * h), atol=1e-6)
    second = (after - 2 * now + before)[:3, 3] / (h * h)
    np.testing.assert_allclose(frame.point().acceleration, second, atol=1e-5)


def test_the_engine_of_chains_and_the_recursion_over_the_tree_agree():
    robot = tree(0, ["revolute", "helical", "universal", "cylindrical", "planar", "prismatic"])
    alone, together = motion(robot, 7, (5,)), motion(robot, 7, (5,))
    assert together.frames
    for body in robot.bodies:
        ours, theirs = alone.frame(body).twists, together.frame(body).twists
        np.testing.assert_allclose(ours, theirs, rtol=0, atol=1e-13 * np.abs(theirs).max())


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


def test_what_the_jacobian_multiplies_is_the_velocity_of_the_point_itself():
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


@pytest.mark.parametrize("seed", range(3))
def test_base_and_relative_motion_compose(seed):
    found = motion(tree(seed), 6, (2,), seed)
    for base in ("world", "b1", "b4"):
        A = found.frame(base)
        for name in ("world", "b2", "b5"):
            B = found.frame(name)
            relative = B.relative_to(A)
            np.testing.assert_allclose(A.pose @ relative.pose, B.pose, **NEAR)
            twist = composed_twist(A.origin_twist, A.pose, relative.origin_twist)
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


# -- inverse ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("expressed", ["world", "mixed", "body"])
@pytest.mark.parametrize(
    "kinds", [["floating"], ["revolute"] * 6, ["ball", "prismatic", "planar", "helical"]]
)
def test_inverse_gives_back_the_twist_to_every_order(kinds, expressed):
    robot = tree(6, kinds)
    robot = Robot(
        "chain",
        [
            TreeJoint(**{**vars(j), "parent": f"b{i - 1}" if i else "world"})
            for i, j in enumerate(robot.joints)
        ],
    )
    tip = robot.bodies[-1]
    given = motion(robot, 5, (2,), 6)
    options = {"expressed": expressed, "point": (0.1, 0.2, -0.1)}
    V = np.stack([given.frame(tip).velocity(k, **options) for k in range(5)])
    v = robot.inverse(tip, given.q, V, **options)
    again = robot.motion(given.q, v).frame(tip)
    for k in range(5):
        size = np.abs(given.rates).max() ** (k + 1) * 1e-8
        np.testing.assert_allclose(again.velocity(k, **options), V[k], rtol=0, atol=max(1e-8, size))
    if len(robot.velocities) == 6:
        np.testing.assert_allclose(v[:3], given.rates[:3], rtol=1e-6, atol=1e-6)


def test_a_redundant_inverse_has_least_norm_in_the_weight_stated():
    robot = tree(7, ["floating", "revolute", "prismatic"])
    tip, rng = "b2", np.random.default_rng(7)
    given = motion(robot, 3)
    V = np.stack([given.frame(tip).velocity(k) for k in range(3)])
    weight = rng.uniform(0.5, 4, len(robot.velocities))
    v = robot.inverse(tip, given.q, V, weight=weight)
    J = given.frame(tip).jacobian()
    null = np.linalg.svd(J)[2][6:]
    np.testing.assert_allclose(null @ (weight * v[0]), 0, atol=1e-10)  # stationary along each null direction
    preferred = rng.normal(size=v.shape)
    near = robot.inverse(tip, given.q, V, weight=weight, null_space=preferred)
    np.testing.assert_allclose(J @ near[0], V[0], atol=1e-10)
    np.testing.assert_allclose(null @ (weight * (near[0] - preferred[0])), 0, atol=1e-10)


def test_a_singular_jacobian_is_refused_with_its_singular_values():
    robot = tree(8, ["revolute"] * 3)
    with pytest.raises(SingularJacobian, match=r"6 independent rows of 3 .* singular values") as caught:
        robot.inverse("b2", np.zeros(3), np.zeros((2, 6)))
    assert caught.value.singular_values.shape == (3,)
    straight = Robot(
        "arm",
        [
            TreeJoint(f"j{i}", "revolute", f"b{i - 1}" if i else "world", f"b{i}", axis=[0, 0, 1])
            for i in range(2)
        ],
    )
    with pytest.raises(SingularJacobian, match="singular values"):
        straight.inverse("b1", np.zeros(2), np.zeros((1, 2)), rows=(2, 3))


# -- mimic joints ----------------------------------------------------------------------------------


def test_a_mimic_joint_follows_to_every_order_and_in_the_jacobian():
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


# -- what does not move, and what users see ---------------------------------------------------------


def test_what_does_not_move_is_zero_and_no_error():
    robot = tree(0, ["fixed", "revolute"])
    found = motion(robot, 4, (2,))
    for body in ("world", "b0"):
        frame = found.frame(body)
        assert not frame.twists.any() and not frame.point((1, 2, 3)).derivatives[1:].any()
        assert not frame.jacobian(2).any()
        assert (frame.centre(3).kind == "space").all()
    still = Robot("statue", [TreeJoint("glue", "fixed", "world", "stone")])
    assert not still.motion(np.zeros((4, 0))).frame("stone").twists.any()


def test_reprs_are_short_and_tab_lists_what_is_meant_for_users():
    robot = tree(0)
    found = motion(robot, 3)
    frame = found.frame("b1")
    for thing in (robot, found, frame, frame.twist(1), frame.point((0, 0, 1))):
        assert len(repr(thing)) < 160 and "\n" not in repr(thing)
        assert "0x" not in repr(thing)
    for thing in (robot, found, frame):
        assert not any(name.startswith("_") for name in dir(thing))
        assert all(hasattr(thing, name) for name in dir(thing) if name != "times")
    assert {"twist", "point", "acceleration", "centre", "jacobian", "relative_to"} <= set(dir(frame))


def test_one_twist_for_arrays_duals_and_drake():
    frame = motion(tree(0), 3).frame("b2")
    twist = frame.twist(0)
    V = twist.drake()
    np.testing.assert_array_equal(np.asarray(twist), [*twist.angular, *twist.linear])
    np.testing.assert_array_equal(V.get_coeffs(), twist.array)
    shifted = V.Shift(-frame.pose[:3, 3])
    np.testing.assert_allclose(shifted.translational(), twist.dual.du, **NEAR)
    assert "Acceleration" in type(frame.twist(1).drake()).__name__
    with pytest.raises(ValueError, match="k = 2"):
        frame.twist(2).drake()


def test_the_screw_axis_is_where_points_move_along_it():
    frame = motion(tree(0), 2).frame("b4")
    axis = frame.screw_axis()
    omega, v = frame.origin_twist[0, :3], frame.origin_twist[0, 3:]
    for s in (0.0, 1.3):
        velocity = v + np.cross(omega, axis.point + s * axis.direction)
        np.testing.assert_allclose(velocity, axis.pitch * axis.rate * axis.direction, **NEAR)
    sliding = tree(1, ["prismatic"]).motion(np.array([[0.1], [2.0]])).frame("b0").screw_axis()
    assert sliding.pitch == np.inf and np.isclose(sliding.rate, 2.0)


def test_a_large_batch_streams_in_blocks():
    robot = tree(0, ["revolute"] * 4)
    q = np.random.default_rng(0).normal(size=(4, 1000, 4))
    blocks, motions = [], []
    gc.disable()  # nothing must wait for it
    for m in robot.blocks(q, size=300):
        m.frame("b3").point().jerk.max()
        blocks.append(m.frame("b3").twists)
        motions.append(weakref.ref(m))
    del m
    gc.enable()
    assert [m() for m in motions] == [None] * 4
    assert [b.shape[1] for b in blocks] == [300, 300, 300, 100]
    np.testing.assert_allclose(np.concatenate(blocks, axis=1), robot.motion(q).frame("b3").twists, **NEAR)


# -- bad input -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"rtol": np.nan}, "rtol: expected 0 <= rtol < 1"),
        ({"weight": [1, -1]}, "weight: expected 2 numbers > 0"),
        ({"null_space": np.full((1, 2), np.inf)}, "null_space: expected finite"),
        ({"rows": [0, 1.0]}, "rows: expected different numbers from 0 to 5"),
        ({"rows": 6}, "rows: expected different numbers from 0 to 5"),
        ({"expressed": "tool"}, "expressed: expected one of"),
        ({"twist_derivatives": np.ones((1, 1)) * 1j}, "twist_derivatives: expected real numbers"),
    ],
)
def test_bad_prescriptions(options, message):
    robot = tree(0, ["revolute", "prismatic"])
    asked = {"twist_derivatives": np.ones((1, 1)), "rows": [0]} | options
    with pytest.raises(ValueError, match=message):
        robot.inverse("b1", np.zeros(2), **asked)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((np.zeros((2, 5)),), r"shape \(N \+ 1, \.\.\., 2\).*order first.*got \(2, 5\)"),
        ((np.zeros((1, 2)),), "N >= 1"),
        ((np.zeros(2),), "shape"),
        ((np.full((3, 2), np.nan),), "finite"),
        ((np.array([[0, 1], [np.inf, 0]]),), "finite"),
        ((np.zeros((3, 2), dtype=complex),), "real"),
        ((np.zeros((4, 2)), np.zeros((4, 3))), r"v_derivatives: expected shape \(N, 4, 2\)"),
        ((np.zeros(3), np.zeros((4, 2))), r"q: expected shape \(\.\.\., 2\)"),
        ((np.zeros((200, 2)),), "at most 170"),
        (([[1, 2], [1]],), "q_derivatives: .*inhomogeneous"),
        ((np.ma.masked_greater(np.ones((3, 2)), 0),), "q_derivatives: expected no masked numbers"),
    ],
)
def test_bad_states(arguments, message):
    with pytest.raises(ValueError, match=message):
        tree(0, ["revolute", "prismatic"]).motion(*arguments)


def test_bad_questions():
    robot = tree(0, ["revolute", "ball"])
    q = np.zeros((3, 5))
    q[0, 1] = 1
    found = robot.motion(q)
    with pytest.raises(ValueError, match="no body 'hand': expected one of world, b0, b1"):
        found.frame("hand")
    for ask in (
        lambda f: f.twist(2),
        lambda f: f.twist(0.0),
        lambda f: f.twist(True),
        lambda f: f.acceleration("jerk"),
        lambda f: f.jacobian(None),
        lambda f: f.point().jerk,
        lambda f: f.centre(0),
        lambda f: f.jacobian(3),
    ):
        with pytest.raises(ValueError, match=r"order: expected one from \d to \d of a motion of order 2"):
            ask(found.frame("b1"))
    for ask in (found.frame("b1").jacobian, found.frame("b1").velocity):
        with pytest.raises(ValueError, match="expected one of world, mixed, body, got 'World'"):
            ask(expressed="World")
    with pytest.raises(ValueError, match="expected the motion of a frame, got str"):
        found.frame("b1").relative_to("b0")
    with pytest.raises(ValueError, match=r"expected as many states, \(\), got \(2,\)"):
        found.frame("b1").relative_to(robot.motion(np.stack([q, q], axis=1)).frame("b0"))
    for batch, size, message in (
        (q, 4, "batch of states, got the shape"),
        (q[:, None], 0, "size: expected an integer >= 1"),
    ):
        with pytest.raises(ValueError, match=message):
            next(robot.blocks(batch, size=size))
    with pytest.raises(ValueError, match="expected a finalized plant"):
        Robot.from_plant(None)
    with pytest.raises(ValueError, match="three coordinates"):
        found.frame("b1").point(np.zeros((2, 3)))
    with pytest.raises(ValueError, match="got one of length 0"):
        robot.motion(np.zeros((3, 5))).frame("b1").twists  # noqa: B018


def test_no_states_and_no_coordinates_are_a_motion_too():
    none = tree(0, ["revolute", "prismatic"]).motion(np.zeros((4, 0, 2)))
    frame = none.frame("b1")
    assert frame.centre(3).point.shape == frame.point().jerk.shape == (0, 3)
    assert frame.jacobian(2).shape == (0, 6, 2)
    still = Robot("still", [TreeJoint("base", "fixed", "world", "x")]).motion(np.zeros((3, 4, 0))).frames[0]
    assert not still.point().acceleration.any() and still.jacobian(1).shape == (4, 6, 0)


@pytest.mark.parametrize(
    ("joints", "message"),
    [
        (
            [TreeJoint("a", "revolute", "world", "x"), TreeJoint("a", "revolute", "x", "y")],
            "'a' is there twice",
        ),
        ([TreeJoint("a", "revolute", "nowhere", "x")], "'x': no joint connects it with 'world'"),
        (
            [TreeJoint("a", "revolute", "world", "x"), TreeJoint("b", "fixed", "world", "x")],
            "more than one joint",
        ),
        ([TreeJoint("a", "revolute", "world", "x", mimic=Mimic("b"))], "mimics 'b', which does not exist"),
        (
            [
                TreeJoint("a", "revolute", "world", "x", mimic=Mimic("b")),
                TreeJoint("b", "revolute", "x", "y", mimic=Mimic("a")),
            ],
            "circle",
        ),
    ],
)
def test_bad_robots(joints, message):
    with pytest.raises(ValueError, match=message):
        Robot("bad", joints)


def test_bad_joints():
    with pytest.raises(ValueError, match=r"joint 'a': expected one of fixed, .* got 'spin'"):
        TreeJoint("a", "spin", "x", "y")
    with pytest.raises(ValueError, match=r"joint 'a': .*non-zero length"):
        TreeJoint("a", "revolute", "x", "y", axis=[0, 0, 0])
    with pytest.raises(ValueError, match="X_PF: expected a rigid transform"):
        TreeJoint("a", "revolute", "x", "y", X_PF=2 * np.eye(4))
    with pytest.raises(ValueError, match="not one coordinate to mimic"):
        TreeJoint("a", "ball", "x", "y", mimic=Mimic("b"))
