"""Closed loops: four-bar and Stewart platform against closed forms, a closed 3C chain against the chapter's."""

from math import factorial

import mpmath
import numpy as np
import pytest
from kinematics.random_robots import random_pose

from workbench.algebra.dual import Dual
from workbench.kinematics.cylindrical_chains import twist_derivatives_3c
from workbench.kinematics.robot import (
    BallConstraint,
    ClosedLoops,
    Robot,
    SingularJacobian,
    TreeJoint,
    WeldConstraint,
)

Z = (0, 0, 1)


def shifted(x=0.0, y=0.0, z=0.0):
    X = np.eye(4)
    X[:3, 3] = x, y, z
    return X


# -- four-bar ------------------------------------------------------------------------------------------

CRANK, COUPLER, ROCKER, GROUND = 0.3, 0.9, 0.7, 0.8


def four_bar(closing="ball", crank=CRANK, coupler=COUPLER, rocker=ROCKER, ground=GROUND):
    """Crank and rocker on the world, the coupler on the crank; it is closed at the rocker's tip."""
    joints = [
        TreeJoint("crank", "revolute", "world", "a", axis=Z),
        TreeJoint("coupler", "revolute", "a", "b", shifted(crank), axis=Z),
        TreeJoint("rocker", "revolute", "world", "c", shifted(ground), axis=Z),
    ]
    if closing == "ball":
        close = BallConstraint("b", "c", (coupler, 0, 0), (rocker, 0, 0))
    else:
        joints.append(TreeJoint("tip", "revolute", "b", "d", shifted(coupler), axis=Z))
        close = WeldConstraint("d", "c", X_BQ=shifted(rocker))
    return ClosedLoops(Robot("four-bar", joints), [close])


def rocker_angle(theta):
    """The rocker's angle of the crank's, by the cosine law, with mpmath's numbers."""
    a, b, c, d = map(mpmath.mpf, map(str, (CRANK, COUPLER, ROCKER, GROUND)))
    x, y = a * mpmath.cos(theta) - d, a * mpmath.sin(theta)
    reach = mpmath.sqrt(x * x + y * y)
    inner = mpmath.acos((c * c + reach * reach - b * b) / (2 * c * reach))
    return mpmath.atan2(y, x) - inner


@pytest.mark.parametrize("closing", ["ball", "weld"])
def test_a_four_bar_moves_as_its_closed_form(closing):
    """The rocker's derivatives to the order 5 by mpmath's derivatives of the cosine law at 40 digits."""
    loops, crank = four_bar(closing), [0.7, 1.3, -2.0, 3.0, 5.0, -4.0]
    with mpmath.workdps(40):
        path = [mpmath.mpf(c) / factorial(k) for k, c in enumerate(crank)]
        right = mpmath.taylor(lambda t: rocker_angle(mpmath.polyval(path[::-1], t)), 0, 5)
        right = np.array([float(c * factorial(k)) for k, c in enumerate(right)])
    start = np.zeros(len(loops.robot.positions))
    start[:3] = crank[0], 0.5, right[0] + 0.2
    q = loops.close(start, ["crank"])
    assert loops.mobility(q) == 1
    np.testing.assert_allclose(np.sin(q[2] - right[0]), 0, atol=1e-13)
    rates = loops.rates(q, {"crank": crank[1:]})
    np.testing.assert_allclose(rates[:, 0], crank[1:], rtol=1e-13)
    np.testing.assert_allclose(rates[:, 2], right[1:], rtol=1e-10)


def test_frames_of_a_closed_motion_stay_together():
    """Law: P and Q have one position and one velocity, acceleration, jerk, snap at every order."""
    loops = four_bar("weld")
    theta = np.linspace(0, 2 * np.pi, 7)
    start = np.zeros((7, 4))
    start[:, 0], start[:, 1], start[:, 2] = theta, 0.6, 1.2
    q = loops.close(start, ["crank"])
    assert np.abs(loops.gap(q)[:, 3:]).max() < 1e-13
    motion = loops.motion(q, {"crank": [1.0, 0.5, -0.3, 2.0]})
    P, Q = (motion.frame(f"{name} of constraint 0") for name in "PQ")
    np.testing.assert_allclose(P.pose, Q.pose, atol=1e-12)
    np.testing.assert_allclose(P.twists, Q.twists, atol=1e-9)


def test_singular_positions_of_a_four_bar_are_reported():
    """Crank and coupler in a line stop the rocker: driven at the rocker, the crank is free."""
    loops = four_bar()
    line = CRANK + COUPLER
    at_crank = np.arccos((line**2 + GROUND**2 - ROCKER**2) / (2 * line * GROUND))
    q = loops.close([at_crank, 0.0, 2.0], ["crank"])
    np.testing.assert_allclose(loops.rates(q, {"crank": [1.0]})[0, 2], 0, atol=1e-9)
    assert loops.singular_values(q, ["crank"])[-1] > 0.1 > 1e-7 > loops.singular_values(q, ["rocker"])[-1]
    with pytest.raises(SingularJacobian, match=r"singular position.*such as crank, coupler") as told:
        loops.rates(q, {"rocker": [1.0]})
    assert told.value.singular_values.shape == (3,)


def test_mobility_grows_where_a_parallelogram_is_flat():
    loops = four_bar("weld", 0.3, 0.8, 0.3, 0.8)
    flat, upright = np.zeros(4), loops.close([0.6, -0.6, 0.6, 0.6], ["crank"])
    assert loops.mobility(upright) == 1 and loops.mobility(flat) == 2
    assert loops.mobility(np.stack([flat, upright])).tolist() == [2, 1]
    with pytest.raises(SingularJacobian, match="singular position at state"):
        loops.rates(np.stack([upright, flat]), {"crank": [1.0]})


def test_loops_that_do_not_close_are_refused():
    loops = four_bar()
    with pytest.raises(
        ValueError, match="expected a closed position near q, found none: the frames are apart"
    ):
        four_bar(coupler=0.1, rocker=0.1).close([3.0, 0, 0], ["crank"])
    with pytest.raises(ValueError, match="q: expected a closed position"):
        loops.rates([0.7, 0, 0], {"crank": [1.0]})
    q = loops.close([0.7, 0.5, 1.0], ["crank"])
    with pytest.raises(ValueError, match="no velocity 'crack'"):
        loops.rates(q, {"crack": [1.0]})
    with pytest.raises(ValueError, match="no motion of the mechanism has these rates of order 1"):
        loops.rates(q, {"crank": [1.0], "rocker": [7.0]})
    with pytest.raises(ValueError, match="constraints: expected at least one"):
        ClosedLoops(loops.robot, [])
    with pytest.raises(ValueError, match="no body 'z'"):
        ClosedLoops(Robot("r", [TreeJoint("j", "revolute", "world", "a")]), [BallConstraint("z", "a")])


@pytest.mark.parametrize("kind", ["floating", "floating_rpy"])
def test_a_welded_body_is_put_where_the_weld_says(kind):
    joints = [
        TreeJoint("free", kind, "world", "platform"),
        TreeJoint("hinge", "revolute", "world", "a", axis=Z),
    ]
    loops = ClosedLoops(Robot("welded", joints), [WeldConstraint("platform", "a", X_BQ=shifted(0.1, 0.2))])
    start = np.zeros(len(loops.robot.positions))
    start[:3], start[-1] = (0.3, -0.4, 0.5), 0.7
    q = loops.close(start, ["hinge"])
    assert q[-1] == 0.7 and np.abs(loops.gap(q)).max() < 1e-13
    frames = loops.motion(q, {"hinge": [1.0]})
    right = frames.frame("a").pose @ shifted(0.1, 0.2)
    np.testing.assert_allclose(frames.frame("platform").pose, right, atol=1e-13)


# -- other sizes ----------------------------------------------------------------------------------------


def turned_about_x(angle, x=0.0):
    X, c, s = shifted(x), np.cos(angle), np.sin(angle)
    X[1:3, 1:3] = [[c, -s], [s, c]]
    return X


@pytest.mark.parametrize("size", [1e-3, 1.0, 1e3])
def test_an_overconstrained_bennett_linkage_of_any_size_moves(size):
    """tan(θ/2) tan(φ/2) = sin((β + α)/2) / sin((β − α)/2); the crank stays where it is while the loop closes."""
    a, b, alpha = 0.5 * size, 0.8 * size, 0.6
    beta = np.arcsin(b * np.sin(alpha) / a)
    links = [shifted(), turned_about_x(alpha, a), turned_about_x(beta, b), turned_about_x(alpha, a)]
    joints = [
        TreeJoint(f"j{i}", "revolute", "world" if i == 0 else f"l{i - 1}", f"l{i}", X, axis=Z)
        for i, X in enumerate(links)
    ]
    loops = ClosedLoops(Robot("bennett", joints), [WeldConstraint("l3", "world", turned_about_x(beta, b))])
    ratio = np.sin((beta + alpha) / 2) / np.sin((beta - alpha) / 2)
    for theta in (0.7, 1.4, -2.0):
        phi = 2 * np.arctan(ratio / np.tan(theta / 2))
        q = loops.close([theta, phi + 0.3, -theta - 0.2, -phi], ["j0"])
        assert q[0] == theta and loops.mobility(q) == 1
        np.testing.assert_allclose(q[1], phi, atol=1e-11)
        rates = loops.rates(q, {"j0": [1.0, 0.0]})
        slope = -ratio / (np.sin(theta / 2) ** 2 + ratio**2 * np.cos(theta / 2) ** 2)
        np.testing.assert_allclose(rates[0], [1, slope, -1, -slope], atol=1e-10)


@pytest.mark.parametrize("size", [1e-3, 1.0, 1e3])
def test_a_slider_crank_of_any_size_stops_at_its_dead_centre(size):
    joints = [
        TreeJoint("crank", "revolute", "world", "a", axis=Z),
        TreeJoint("rod", "revolute", "a", "b", shifted(0.3 * size), axis=Z),
        TreeJoint("slide", "prismatic", "world", "s", axis=(1, 0, 0)),
    ]
    loops = ClosedLoops(Robot("slider", joints), [BallConstraint("b", "s", (size, 0, 0))])
    q = loops.close([0.7, -0.5, 1.2 * size], ["crank"])
    root = np.sqrt(1 - 0.09 * np.sin(0.7) ** 2)
    np.testing.assert_allclose(q[2], size * (0.3 * np.cos(0.7) + root), rtol=1e-13)
    speed = -0.3 * np.sin(0.7) - 0.09 * np.sin(0.7) * np.cos(0.7) / root
    np.testing.assert_allclose(loops.rates(q, {"crank": [1.0]})[0, 2], size * speed, rtol=1e-12)
    np.testing.assert_allclose(loops.rates(q, {"slide": [size * speed]})[0, 0], 1, rtol=1e-11)
    with pytest.raises(SingularJacobian, match="such as crank, rod"):
        loops.rates([0, 0, 1.3 * size], {"slide": [size]})


# -- 3C chain ------------------------------------------------------------------------------------------


def test_a_closed_3c_chain_obeys_the_chapter_s_formulas():
    """An RCCC loop: the twist of the three C joints by the formulas of the chapter's 3C chain is that of the
    R joint, whose line is fixed, so are the first three derivatives."""
    rng = np.random.default_rng(3)
    joints, parent = [], "world"
    for i in range(3):
        joints.append(TreeJoint(f"c{i}", "cylindrical", parent, f"b{i}", random_pose(rng), axis=Z))
        parent = f"b{i}"
    robot = Robot("chain", [*joints, TreeJoint("crank", "revolute", "world", "r", random_pose(rng), axis=Z)])
    q = rng.normal(size=7)
    tip = robot.motion(np.stack([q, q])).frame("b2").pose
    crank = robot.motion(np.stack([q, q])).frame("r").pose
    loops = ClosedLoops(robot, [WeldConstraint("b2", "r", X_BQ=np.linalg.inv(crank) @ tip)])
    driven = rng.normal(size=4)
    assert loops.mobility(q) == 1
    motion = loops.motion(q, {"crank": driven})

    def line(pose):
        return Dual(pose[:3, 2], np.cross(pose[:3, 3], pose[:3, 2]))

    lines = [line(motion.frame(f"b{i}").pose) for i in range(3)]
    columns = {name: motion.rates[:, robot.velocities.index(name)] for name in robot.velocities}
    rates = [
        [Dual(a, d) for a, d in zip(columns[f"c{i}_angle"], columns[f"c{i}_shift"], strict=True)]
        for i in range(3)
    ]
    of_crank = line(motion.frame("r").pose)
    for k, twist in enumerate(twist_derivatives_3c(lines, rates)):
        scale = np.abs(motion.rates[: k + 1]).max() ** (k + 1)
        np.testing.assert_allclose(twist.re, driven[k] * of_crank.re, atol=1e-11 * scale)
        np.testing.assert_allclose(twist.du, driven[k] * of_crank.du, atol=1e-11 * scale)


# -- Stewart platform -----------------------------------------------------------------------------------


def stewart(rng):
    """A platform that floats, and six legs of universal, prismatic joint and ball; the anchors (6, 3)."""
    angle = np.deg2rad([0, 60, 120, 180, 240, 300])
    ground = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1) + rng.normal(scale=0.08, size=(6, 3))
    tops = 0.5 * np.stack([np.cos(angle + 0.5), np.sin(angle + 0.5), 0 * angle], axis=1)
    joints = [TreeJoint("free", "floating", "world", "platform")]
    for i in range(6):
        joints.append(TreeJoint(f"u{i}", "universal", "world", f"fork{i}", shifted(*ground[i])))
        joints.append(TreeJoint(f"leg{i}", "prismatic", f"fork{i}", f"rod{i}", axis=Z))
    balls = [BallConstraint(f"rod{i}", "platform", p_BQ=tops[i]) for i in range(6)]
    return ClosedLoops(Robot("stewart", joints), balls), ground, tops


def test_a_stewart_platform_moves_as_its_legs_say():
    """The lengths |p + R a − b| of a platform's motion are differentiated by series; driven, they give it back."""
    rng = np.random.default_rng(1)
    loops, ground, tops = stewart(rng)
    robot, order = loops.robot, 4
    q = np.zeros(len(robot.positions))
    q[:7] = 1, 0.05, -0.1, 0.08, 0.1, -0.05, 1.2
    q[7:].reshape(6, 3)[:, 2] = 1.2
    free = robot.positions[:4]
    assert [name[-2:] for name in free] == ["qw", "qx", "qy", "qz"]
    q = loops.close(q, [name for name in robot.velocities if name.startswith("free")])
    wanted = rng.normal(size=(order, 6))
    alone = Robot("platform", [TreeJoint("free", "floating", "world", "platform")])
    platform = alone.motion(q[:7], wanted).frame("platform")
    driven = {}
    for i in range(6):
        r = platform.point(tops[i]).derivatives.copy()
        r[0] -= ground[i]
        series = r / np.array([factorial(k) for k in range(order + 1)])[:, None]
        square = [sum(series[j] @ series[k - j] for j in range(k + 1)) for k in range(order + 1)]
        length = [np.sqrt(square[0])]
        for k in range(1, order + 1):
            inner = sum(length[j] * length[k - j] for j in range(1, k))
            length.append((square[k] - inner) / (2 * length[0]))
        driven[f"leg{i}"] = [length[k] * factorial(k) for k in range(1, order + 1)]
        np.testing.assert_allclose(q[7 + 3 * i + 2], length[0], rtol=1e-12)
    assert loops.mobility(q) == 6
    found = loops.motion(q, driven).frame("platform")
    for k in range(order):
        scale = np.abs(platform.twists[: k + 1]).max() * 10
        np.testing.assert_allclose(found.twists[k], platform.twists[k], atol=1e-10 * scale)


def test_too_few_driven_legs_are_reported():
    loops, _, _ = stewart(np.random.default_rng(1))
    q = np.zeros(len(loops.robot.positions))
    q[0], q[6] = 1, 1.2
    q[7:].reshape(6, 3)[:, 2] = 1.2
    q = loops.close(q)
    with pytest.raises(SingularJacobian, match="with 5 driven velocities 1 more can move freely"):
        loops.rates(q, {f"leg{i}": [0.1] for i in range(5)})
