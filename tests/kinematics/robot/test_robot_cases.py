"""Cases of wrong answers and wrong refusals with what is right; their files and values are in `robot_cases.json`."""

import json
from pathlib import Path

import numpy as np
import pytest
from pydrake.polynomial import Polynomial
from pydrake.trajectories import PiecewisePolynomial

from workbench.kinematics import lines, screws
from workbench.kinematics.robot import Robot, TreeJoint, UrdfError
from workbench.kinematics.robot.trajectories.paths import JointPath

CASES = json.loads((Path(__file__).parent / "robot_cases.json").read_text(encoding="utf-8"))


@pytest.fixture
def robot_of(tmp_path):
    def made(name, **options):
        path = tmp_path / f"{name}.urdf"
        path.write_text(CASES[name]["urdf"])
        return Robot.from_urdf(path, **options)

    return made


def peaks_of(motion, **options):
    return {peak.name: peak for peak in motion.peaks(**options) if peak.of == "j"}


def moves(count):
    """Moves of 1 s and ½ rad to and fro by 10 u³ − 15 u⁴ + 6 u⁵, 100 samples a second."""
    t = np.arange(100 * count + 1) / 100
    k = np.minimum(t.astype(int), count - 1)
    s = np.polynomial.polynomial.polyval(t - k, [0, 0, 0, 10, -15, 6])
    return t, np.where(k % 2 == 0, 0.5 * s, 0.5 * (1 - s))[:, None]


def test_a_motion_keeps_a_copy_of_its_input(robot_of):
    robot, x = robot_of("array_changed_by_caller"), np.array([[0.3], [0.5], [0.1]])
    motion = robot.motion(x)
    x += 1
    assert motion.frame("a").pose[0, 0] == pytest.approx(CASES["array_changed_by_caller"]["right"], abs=1e-15)


@pytest.mark.parametrize("name", ["default_namespace", "unbound_prefix", "world_without_link"])
def test_files_that_drake_reads_are_read(robot_of, name):
    assert list(robot_of(name).positions) == CASES[name]["right"]


def test_a_moving_link_named_world_gets_its_own_message(robot_of):
    with pytest.raises(UrdfError, match="joint 'j' moves the link 'world': that name is the world's own"):
        robot_of("link_named_world")


@pytest.mark.parametrize("seed", range(5))
def test_peaks_of_a_septic_path_are_exact(robot_of, seed):
    """The case peak_digits: the peak to 1e-10 and its time to 1e-6 s, here against the roots of the polynomial."""
    robot, path = robot_of("jump_of_acceleration"), np.random.default_rng(seed).normal(size=8)
    motion = robot.along(
        PiecewisePolynomial([np.array([[Polynomial(path)]], dtype=object)], [0.0, 1.0]), order=3
    )
    jerk = np.polynomial.Polynomial(path).deriv(3)
    roots = jerk.deriv().roots()
    times = np.array([0, 1, *roots[(abs(roots.imag) < 1e-12) & (roots.real > 0) & (roots.real < 1)].real])
    highest = times[np.argmax(abs(jerk(times)))]
    found = peaks_of(motion)["jerk"]
    assert found.value == pytest.approx(abs(jerk(highest)), rel=1e-10)
    assert found.time == pytest.approx(highest, abs=1e-6)


def test_a_jump_of_acceleration_has_no_bounded_jerk(robot_of):
    path = PiecewisePolynomial.CubicShapePreserving([0.0, 1, 2, 3], [[0.0, 1, 0, 0.5]])
    motion = robot_of("jump_of_acceleration").along(path, order=3)
    jerk = peaks_of(motion, limits={"j": {"jerk": 50}})["jerk"]
    assert jerk.within is False and jerk.value == np.inf
    assert "acceleration jumps at 2 times (1, 2 s)" in str(jerk)


@pytest.mark.parametrize("name", ["long_sine", "sixteen_moves", "thirty_moves"])
def test_peaks_of_a_recording_are_covered_by_their_errors(robot_of, name):
    if name == "long_sine":
        t = np.arange(6001) * 0.01
        samples = t, 0.3 * np.sin(2 * np.pi * 1.5 * t)[:, None]
    else:
        samples = moves(16 if name == "sixteen_moves" else 30)
    found = peaks_of(robot_of(name).along(samples, order=3), limits={"j": {"jerk": 1000}})
    for order, right in CASES[name]["right"].items():
        peak = found[order]
        assert abs(peak.value - right) <= peak.error <= 0.1 * right, str(peak)
    assert found["jerk"].verdict == "within"


def test_a_quaternion_s_sign_does_not_matter(robot_of):
    t = np.linspace(0, 2, 201)
    q = np.zeros((201, 8))
    q[:, 0], q[:, 3] = np.cos(t / 2), np.sin(t / 2)
    q[100:, :4] *= -1
    motion = robot_of("quaternion_sign", base="floating").along((t, q), order=3)
    omega = motion.frame("base").twist(0).angular
    np.testing.assert_allclose(omega, [CASES["quaternion_sign"]["right"]["w"]] * 201, atol=1e-6)
    assert motion.path.notes == ("joint 'base': the quaternion changes its sign at 1 sample, first at 1 s",)


def test_a_continuous_joint_is_unwrapped(robot_of):
    t = np.linspace(0, 4, 401)
    motion = robot_of("wrapped").along((t, ((2 * t + np.pi) % (2 * np.pi) - np.pi)[:, None]), order=3)
    found, right = peaks_of(motion, limits={"j": {"jerk": 50}}), CASES["wrapped"]["right"]
    assert abs(found["velocity"].value - right["velocity"]) <= found["velocity"].error < 0.1
    assert found["jerk"].at_least == right["jerk"] and found["jerk"].verdict == "within"
    assert motion.path.notes == ("joint 'j': unwrapped, it jumps by 2 pi at 1 sample, first at 1.58 s",)


def test_distances_of_lines_of_integers_are_numbers():
    x, y = lines.line_through([0, 0, 0], [1, 0, 0]), lines.line_through([0, 0, 1], [0, 1, 0])
    assert lines.distance(x, y) == CASES["lines_distance_ints"]["right"]
    assert lines.distance(x, lines.line_through([0, 0, 1.5], [0, 1, 0])) == 1.5
    assert lines.distance_to_point(x, [0, 3, 4]) == 5
    assert lines.distance_to_point(x, [0, 1, 1]) == pytest.approx(2**0.5)


def test_a_rotation_is_made_of_lists_and_integers():
    right = CASES["screws_rotation_list"]["right"]
    np.testing.assert_allclose(screws.rotation(0.3, [0, 0, 1]), right, atol=1e-14)
    assert screws.rotation([0, 1], [[0, 0, 1], [1, 0, 0]]).shape == (2, 3, 3)
    with pytest.raises(ValueError, match=r"axis: expected shape \(\.\.\., 3\)"):
        screws.rotation(0.3, [0, 1])


def test_peaks_are_exact_to_their_last_digits():
    """The jerk of 35 s⁴ − 84 s⁵ + 70 s⁶ − 20 s⁷ is largest where its derivative, a cubic, is 0."""
    septic = np.polynomial.Polynomial([0, 0, 0, 0, 35, -84, 70, -20])
    robot = Robot("r", [TreeJoint("j", "revolute", "world", "a"), TreeJoint("k", "prismatic", "a", "b")])
    path = JointPath(np.outer(septic.coef, [1.0, -0.3]))
    found = {(p.of, p.order): p for p in robot.along(path, np.linspace(0, 1, 7), 4).peaks("b", (0.1, 0, 0.2))}
    for n in range(1, 5):
        roots = septic.deriv(n + 1).roots().real
        inside = np.append(roots[(roots > 0) & (roots < 1)], [0.0, 1.0])
        right = np.abs(septic.deriv(n)(inside)).max()
        assert found["j", n].value == pytest.approx(right, rel=1e-12)
        times = inside[np.abs(septic.deriv(n)(inside)) > right * (1 - 1e-9)]
        assert np.abs(times - found["j", n].time).min() < 1e-8

    def slope(t, n):
        """½ d|p⁽ⁿ⁾|²/dt."""
        p = robot.along(path, t, n + 1).frame("b").point((0.1, 0, 0.2)).derivatives
        return p[n] @ p[n + 1]

    for n in (2, 3):
        t = found["point", n].time
        assert slope(t - 1e-7, n) > 0 > slope(t + 1e-7, n)


def test_two_bodies_of_one_base_do_not_feel_its_motion():
    """Two fingers that slide on a hand, which an arm turns fast: no ω⁽ᵏ⁾ of the one in the other."""
    arm = [
        TreeJoint(f"j{i}", "revolute", f"b{i}", f"b{i + 1}", axis=axis) for i, axis in enumerate(np.eye(3))
    ]
    fingers = [TreeJoint(f"f{s}", "prismatic", "b3", f"finger{s}", axis=(0, s, 0)) for s in (1, -1)]
    robot = Robot("hand", [TreeJoint("base", "fixed", "world", "b0"), *arm, *fingers])
    q = np.random.default_rng(0).uniform(-9, 9, (10, 5))
    motion = robot.motion(q)
    twist = motion.frame("finger1").relative_to(motion.frame("finger-1")).origin_twist
    np.testing.assert_array_equal(twist[:, :3], CASES["two_fingers"]["right"])
    np.testing.assert_allclose(twist[:, 4], q[1:, 3] + q[1:, 4], rtol=1e-13)
