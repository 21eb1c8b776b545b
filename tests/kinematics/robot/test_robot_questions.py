"""What users see of a robot, and what bad input gets."""

import gc
import weakref

import numpy as np
import pytest
from kinematics.random_robots import NEAR, motion, tree

from workbench.kinematics.robot import Mimic, Robot, TreeJoint
from workbench.kinematics.robot.joints import Limits
from workbench.kinematics.robot.trajectories.paths import JointPath


def test_bodies_at_rest_have_zero_twists():
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
        ((np.zeros((200, 2)),), "at most 21 rows.*table of states"),
        ((np.zeros((200, 1, 2)),), "at most 170"),
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
        (
            [TreeJoint("a", "planar", "world", "x"), TreeJoint("a_x", "revolute", "x", "y")],
            "'a_x' is there twice",
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


# -- names and units -----------------------------------------------------------------------------------


def test_a_joint_named_point_keeps_its_limits():
    """Law: what joints are called does not change a verdict."""
    kinds = {"velocity": 0.5, "jerk": 3.0}
    verdicts = []
    for names in (("point", "rotation"), ("j", "k")):
        joints = [
            TreeJoint(names[0], "revolute", "world", "a", limits=Limits(velocity=0.5, jerk=9.0)),
            TreeJoint(names[1], "prismatic", "a", "b", limits=Limits(acceleration=0.1)),
        ]
        robot = Robot("r", joints)
        motion = robot.along(
            JointPath(np.array([[0, 0], [0, 1], [1, 1], [0.5, 0.2]])), np.linspace(0, 1, 5), 3
        )
        own = "body " if names[0] == "point" else ""
        found = motion.peaks("b", (0.1, 0, 0), {names[0]: kinds, f"{own}point": {"jerk": 1.0}})
        verdicts.append([(p.name, p.value, p.limit, p.verdict) for p in found])
        assert {p.of for p in found} == {*names, f"{own}point", f"{own}rotation"}
        assert motion.plot("b", (0.1, 0, 0)) is not None
    assert verdicts[0] == verdicts[1] and ("velocity", 3.5, 0.5, "BEYOND") in verdicts[0]


def test_degrees_become_radians_and_metres_stay():
    robot = Robot("r", [TreeJoint("j", "revolute", "world", "a"), TreeJoint("k", "prismatic", "a", "b")])
    np.testing.assert_allclose(robot.from_degrees([[180, 2], [90, 1]]), [[np.pi, 2], [np.pi / 2, 1]])
    floating = Robot("f", [TreeJoint("base", "floating", "world", "b")])
    values = np.arange(7.0)
    np.testing.assert_array_equal(floating.from_degrees(values), values)
    rates = floating.from_degrees(np.full(6, 180.0), floating.velocities)
    np.testing.assert_allclose(rates, [np.pi] * 3 + [180] * 3)
    t = np.linspace(0, 1, 101)
    degrees = np.stack([30 * np.sin(t), 0.1 * t], axis=1)
    ours = robot.along((t, robot.from_degrees(degrees)), order=2).rates[0][50]
    np.testing.assert_allclose(ours, [np.deg2rad(30 * np.cos(0.25)), 0.1], rtol=1e-6)
    with pytest.raises(ValueError, match=r"values: expected shape \(\.\.\., 2\), got \(3,\)"):
        robot.from_degrees([1, 2, 3])
    with pytest.raises(ValueError, match="no coordinate or velocity 'x'"):
        robot.from_degrees([1, 2], ["j", "x"])
