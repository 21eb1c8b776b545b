"""Trajectories in (Drake's, samples, formulas) and answers out (peaks, tables, plots, MeshCat)."""

import shutil
import subprocess

import numpy as np
import pytest
from pydrake.trajectories import BsplineTrajectory, CompositeTrajectory, PiecewisePolynomial
from scipy import interpolate

from workbench.kinematics.robot import Robot, TreeJoint
from workbench.kinematics.robot.answers import write_csv
from workbench.kinematics.robot.joint_limits import read_limits
from workbench.kinematics.robot.trajectories.paths import (
    DrakePath,
    JointPath,
    RecordedPath,
    SinePath,
    read_samples,
)
from workbench.kinematics.robot.trajectories.spline_paths import waypoints

QUINTIC = np.array([0.0, 0.0, 0.0, 10.0, -15.0, 6.0])


def arm():
    axes = ([0, 0, 1], [0, 1, 0], [0, 1, 0])
    X = np.eye(4)
    X[2, 3] = 0.5
    parents = ("world", "b0", "b1")
    return Robot(
        "arm", [TreeJoint(f"j{i}", "revolute", p, f"b{i}", X, axis=axes[i]) for i, p in enumerate(parents)]
    )


def quintic(joints=3):
    return JointPath(np.outer(QUINTIC, np.arange(1, joints + 1)))


def trajectories():
    times = [0.0, 0.7, 1.5, 2.0]
    samples = np.random.default_rng(0).uniform(-1, 1, size=(3, 4))
    spline = PiecewisePolynomial.CubicWithContinuousSecondDerivatives(
        times, samples, np.zeros(3), np.zeros(3)
    )
    later = PiecewisePolynomial.FirstOrderHold([2.0, 3.0], samples[:, [3, 0]])
    return {
        "polynomial": spline,
        "B-spline": BsplineTrajectory(*_bspline(samples)),
        "composite": CompositeTrajectory([spline, later]),
    }


def _bspline(samples):
    from pydrake.math import BsplineBasis

    basis = BsplineBasis(4, 7)
    points = np.random.default_rng(1).uniform(-1, 1, size=(7, 3))
    return basis, [point[:, None] for point in points]


@pytest.mark.parametrize("name", ["polynomial", "B-spline", "composite"])
def test_drake_s_trajectories_move_a_robot(name):
    trajectory, robot = trajectories()[name], arm()
    motion = robot.along(trajectory, order=3, samples=7)
    assert motion.times[0] == trajectory.start_time() and motion.times[-1] == trajectory.end_time()
    for i, t in enumerate(motion.times):
        np.testing.assert_allclose(motion.q[i], trajectory.value(t).ravel(), atol=1e-14)
        for k in range(1, 4):
            np.testing.assert_allclose(
                motion.rates[k - 1][i], trajectory.EvalDerivative(t, k).ravel(), atol=1e-12
            )
    middle = 0.4 * trajectory.end_time() + 0.013
    h = 1e-5
    before, now, after = (
        robot.along(trajectory, t, 2).frame("b2").point((0, 0, 0.3)) for t in (middle - h, middle, middle + h)
    )
    np.testing.assert_allclose(now.velocity, (after.position - before.position) / (2 * h), atol=1e-7)


def test_samples_from_csv(tmp_path):
    file = tmp_path / "samples.csv"
    file.write_text("t, j1\n" + "".join(f"{i / 10},{i}\n" for i in range(12)))
    t, q = read_samples(file, ("j0", "j1"))
    assert t[3] == 0.3 and q.shape == (12, 2) and not q[:, 0].any() and q[5, 1] == 5
    file.write_text("".join(f"{i},{i},{2 * i}\n" for i in range(12)))
    assert read_samples(file, ("j0", "j1"))[1][4].tolist() == [4, 8]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "with rows, got none"),
        ("x,j0\n1,2\n", "first column to be t, got 'x'"),
        ("t,elbow\n1,2\n", "unknown joint 'elbow': expected one of j0, j1"),
        ("t,j0,j0\n1,2,3\n", "'j0' is there twice"),
        ("t,j0\n1,2\n3\n", "line 3: expected 2 numbers, got '3'"),
        ("t,j0\n1,nan\n", "line 2: expected 2 numbers"),
    ],
)
def test_bad_csv(tmp_path, text, message):
    (tmp_path / "bad.csv").write_text(text)
    with pytest.raises(ValueError, match=message):
        read_samples(tmp_path / "bad.csv", ("j0", "j1"))


def test_a_csv_file_is_read_in_the_units_of_its_header(tmp_path):
    """Milliseconds, degrees and millimetres, as the same file in s, rad and m; and what `to_csv` writes."""
    lift = TreeJoint("j1", "prismatic", "b0", "b1")
    robot = Robot("r", [TreeJoint("j0", "revolute", "world", "b0"), lift])
    t = np.arange(40) / 20
    q = np.stack([np.sin(t), 0.1 * t * t], axis=-1)
    rows = [f"{1000 * s},{np.degrees(a)},{1000 * d}" for s, (a, d) in zip(t, q, strict=True)]
    (tmp_path / "q.csv").write_text("\n".join(["t (ms),j0 [deg],j1 (mm)", *rows]))
    path = robot.path(tmp_path / "q.csv")
    np.testing.assert_allclose(path.derivatives(t, 0)[0], q, rtol=0, atol=1e-14)
    robot.along((t, q)).to_csv(tmp_path / "own.csv", "b1")
    np.testing.assert_array_equal(robot.path(str(tmp_path / "own.csv")).times, robot.along((t, q)).times)
    for header in ("t (ms),j0 (m),j1", "t (s),j0 (turns),j1", "t (rad),j0,j1"):
        (tmp_path / "bad.csv").write_text("\n".join([header, *rows]))
        with pytest.raises(ValueError, match="expected one of the units"):
            robot.path(tmp_path / "bad.csv")


# -- splines ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("given", [2, 3])
def test_waypoints_with_their_rates_give_back_a_polynomial(given):
    """Of degree 3 with velocities, 5 with accelerations, to every derivative."""
    path = JointPath(np.random.default_rng(given).normal(size=(2 * given, 3)))
    t = np.array([-0.5, 0.2, 1.0, 1.3])
    found = waypoints(t, *path.derivatives(t, given - 1))
    times = np.linspace(-0.5, 1.3, 50)
    np.testing.assert_allclose(found.derivatives(times, 6), path.derivatives(times, 6), rtol=0, atol=1e-8)
    for peak, true in zip(*(arm().along(p, times, 3).peaks("b2") for p in (found, path)), strict=True):
        assert peak.value == pytest.approx(true.value, rel=1e-6), (str(peak), str(true))


def test_waypoints_alone_are_passed_from_rest_to_rest():
    t, q = np.array([0.0, 0.5, 2.0]), np.random.default_rng(0).normal(size=(3, 3))
    path = waypoints(t, q)
    np.testing.assert_allclose(path.derivatives(t, 0)[0], q, rtol=0, atol=1e-14)
    np.testing.assert_allclose(path.derivatives(t[[0, 2]], 1)[1], 0, rtol=0, atol=1e-14)
    found = {(p.of, p.order): p for p in arm().along(path, t, 4).peaks()}
    assert np.isfinite(found["j0", 3].value) and found["j0", 4].value == np.inf  # the jerk jumps at 0.5 s
    assert found["j0", 4].time == 0.5


def test_any_spline_of_scipy_is_a_path():
    t, q = np.linspace(0, 2, 9), np.random.default_rng(0).normal(size=(9, 3))
    for degree in (3, 5, 7):
        spline = interpolate.make_interp_spline(t, q, degree)
        motion = arm().along(spline, np.linspace(0, 2, 31), degree + 1)
        np.testing.assert_allclose(motion.q, spline(motion.times), rtol=0, atol=1e-13)
        for k in range(1, degree + 1):
            np.testing.assert_array_equal(motion.rates[k - 1], spline.derivative(k)(motion.times))
        assert not motion.rates[degree].any() and list(motion.path.breaks) == list(np.unique(spline.t)[1:-1])
    polynomial = interpolate.PPoly.from_spline(interpolate.splrep(t, q[:, 0]))
    for bad, message in (
        (polynomial, "expected 3 coordinates, got 1"),
        (interpolate.KroghInterpolator(t, q), "a spline with knots"),
        (interpolate.CubicSpline(t, q.reshape(9, 3, 1)), "a vector of positions"),
        (interpolate.CubicSpline(t, q[:, :2]), "expected 3 coordinates, got 2"),
    ):
        with pytest.raises(ValueError, match=message):
            arm().along(bad)
    with pytest.raises(ValueError, match="expected times from 0 to 2 s"):
        arm().along(interpolate.CubicSpline(t, q), 2.1)
    for bad, message in (
        ({"a": q}, "a: expected v with it"),
        ({"v": q[:3]}, "v: expected the shape"),
        ({"t": -t}, "increasing times"),
        ({"q": q[:3]}, "expected shapes"),
    ):
        with pytest.raises(ValueError, match=message):
            waypoints(**{"t": t, "q": q} | bad)


@pytest.mark.parametrize("kind", ["CubicSpline", "BSpline", "PchipInterpolator", "UnivariateSpline"])
def test_a_spline_of_a_number_moves_a_robot_of_one_joint(kind):
    t = np.linspace(0, 2, 9)
    q, robot = np.sin(3 * t), Robot("r", [TreeJoint("j", "revolute", "world", "a")])
    made = {
        "BSpline": interpolate.make_interp_spline,
        "UnivariateSpline": lambda t, q: interpolate.UnivariateSpline(t, q, k=5, s=0),
    }.get(kind, getattr(interpolate, kind))
    number, vector = made(t, q), interpolate.make_interp_spline(t, q[:, None], 5)
    motion = robot.along(number, np.linspace(0, 2, 31), 3)
    np.testing.assert_array_equal(motion.q[:, 0], number(motion.times))
    np.testing.assert_array_equal(motion.rates[1, :, 0], number.derivative(2)(motion.times))
    assert robot.along(number, 0.3).q.shape == robot.along(vector, 0.3).q.shape == (1,)
    assert len(motion.path.breaks) and motion.peaks()[0].value > 0
    if kind == "UnivariateSpline":
        right = robot.along(vector, motion.times, 3)
        np.testing.assert_allclose(motion.rates, right.rates, atol=1e-9)


def test_bad_samples_and_trajectories():
    t, q = np.arange(12.0), np.zeros((12, 3))
    for bad, message in (
        ((t[:5], q[:5]), "at least 10 samples, got 5"),
        ((t[::-1], q), "increasing times"),
        ((t, q[:4]), r"shapes \(samples,\) and \(samples, joints\)"),
        ((t, q + np.nan), "finite"),
        ((t, q + 1j), "q: expected real numbers"),
    ):
        with pytest.raises(ValueError, match=message):
            RecordedPath(*bad)
    robot = arm()
    with pytest.raises(ValueError, match="expected 3 coordinates, got 2"):
        robot.along(SinePath(2), 0.0)
    with pytest.raises(ValueError, match="expected a Path, a Drake Trajectory"):
        robot.along(0.5, 0.0)
    with pytest.raises(ValueError, match="fast: cannot be read"):
        robot.along("fast", 0.0)
    for bad in ({"order": 0}, {"order": 1.5}, {"order": 10**6}, {"samples": 0}, {"samples": "many"}):
        with pytest.raises(ValueError, match=f"{next(iter(bad))}: expected an integer"):
            robot.along(trajectories()["polynomial"], **bad)
    with pytest.raises(ValueError, match=r"trajectory: .*no segments"):
        robot.along(PiecewisePolynomial())
    with pytest.raises(ValueError, match="finite times"):
        robot.along(SinePath(3))
    with pytest.raises(ValueError, match="expected times from 0 to 2 s"):
        robot.along(trajectories()["polynomial"], 2.5)
    with pytest.raises(ValueError, match="got 2 columns"):
        DrakePath(PiecewisePolynomial(np.zeros((3, 2))))


# -- answers ---------------------------------------------------------------------------------------


def test_peaks_of_a_point_to_point_motion_match_the_textbook():
    """10 s³ − 15 s⁴ + 6 s⁵ over 1 s: velocity 15/8 at 1/2, acceleration 10/√3 at (3 ∓ √3)/6, jerk 60 at the ends."""
    robot = arm()
    motion = robot.along(quintic(), np.linspace(0, 1, 23), 3)
    found = {(p.of, p.order): p for p in motion.peaks(limits={"*": {"velocity": 3.0}, "j0": {"jerk": 61.0}})}
    for joint, factor in (("j0", 1), ("j1", 2), ("j2", 3)):
        assert found[joint, 1].value == pytest.approx(factor * 15 / 8, rel=1e-9)
        assert found[joint, 1].time == pytest.approx(0.5, abs=1e-3)
        assert found[joint, 2].value == pytest.approx(factor * 10 / 3**0.5, rel=1e-7)
        assert min(abs(found[joint, 2].time - (3 + s * 3**0.5) / 6) for s in (-1, 1)) < 1e-3
        assert found[joint, 3].value == pytest.approx(factor * 60)
        assert found[joint, 3].time in (0.0, 1.0)
    assert [found[f"j{i}", 1].within for i in range(3)] == [True, False, False]
    assert found["j0", 3].within and found["j1", 3].within is None
    assert "BEYOND" in str(found["j2", 1]) and "rad/s" in str(found["j2", 1])


def test_the_peak_of_a_point_is_found_between_samples():
    robot = arm()
    motion = robot.along(quintic(), np.linspace(0, 1, 5), 4)
    peak = next(p for p in motion.peaks("b2", (0, 0, 0.4)) if p.of == "point" and p.order == 3)
    times = np.linspace(0, 1, 20001)
    sizes = np.linalg.norm(robot.along(quintic(), times, 4).frame("b2").point((0, 0, 0.4)).jerk, axis=1)
    assert peak.value >= sizes.max() * (1 - 1e-9)
    assert peak.value == pytest.approx(sizes.max(), rel=1e-6)


def test_the_peaks_of_a_body_s_rotation_are_those_of_its_rates():
    """Of one joint those of the joint; of three those of ω, ω̇, ω̈ on a fine grid; relative, too."""
    robot = arm()
    motion = robot.along(quintic(), np.linspace(0, 1, 5), 3)
    alone = {(p.of, p.order): p for p in motion.peaks("b0", limits={"rotation": {"jerk": 59.0}})}
    for n in (1, 2, 3):
        assert alone["rotation", n].value == pytest.approx(alone["j0", n].value, rel=1e-9)
    assert "jerk of rotation: 60 rad/s^3" in str(alone["rotation", 3])
    assert alone["rotation", 3].verdict == "BEYOND"
    fine = robot.along(quintic(), np.linspace(0, 1, 20001), 3)
    for seen_from in (None, "b0"):
        frame = fine.frame("b2")
        frame = frame if seen_from is None else frame.relative_to(fine.frame(seen_from))
        found = {p.order: p for p in motion.peaks("b2", relative_to=seen_from) if p.of == "rotation"}
        for n in (1, 2, 3):
            sizes = np.linalg.norm(frame.twist(n - 1).angular, axis=-1)
            assert found[n].value == pytest.approx(sizes.max(), rel=1e-6)


def test_violations_are_the_times_beyond_a_limit():
    """Of sin(t + 1)/2 from 0 to 4: above 0.4 until asin 0.8, and below −0.3 from π + asin 0.6 on."""
    robot = Robot("r", [TreeJoint("tilt_x", "revolute", "world", "b")])
    motion = robot.along(SinePath(1), np.linspace(0, 4, 5), 2)
    high, low = motion.violations(limits={"tilt_x": {"lower": -0.3, "upper": 0.4}})
    assert (high.bound, high.start) == ("upper", 0.0)
    assert high.end == pytest.approx(np.pi - np.arcsin(0.8) - 1, abs=1e-12)
    assert (high.value, high.time) == (pytest.approx(0.5), pytest.approx(np.pi / 2 - 1, abs=1e-6))
    assert (low.start, low.end) == (pytest.approx(np.pi + np.arcsin(0.6) - 1, abs=1e-12), 4.0)
    assert low.value == pytest.approx(-0.5) and "beyond -0.3 rad from 2.78" in str(low)
    assert motion.violations(limits={"tilt_x": {"velocity": 0.6}}) == []


@pytest.mark.parametrize("seed", range(3))
def test_a_limit_is_violated_where_its_peak_is_beyond(seed):
    """On exact paths: by the peak's value, at its time; nowhere else on a fine grid."""
    rng = np.random.default_rng(seed)
    motion = arm().along(SinePath(3), np.linspace(0, 6, 9), 3)
    limits = {"*": {"velocity": 0.4, "jerk": 0.7}, "point": {"jerk": 1.5}, "rotation": {"jerk": 2.0}}
    limits = {
        name: {kind: size * rng.uniform(0.5, 1.5) for kind, size in own.items()}
        for name, own in limits.items()
    }
    peaks = {(p.of, p.order): p for p in motion.peaks("b2", (0, 0, 0.4), limits)}
    found = motion.violations("b2", (0, 0, 0.4), limits)
    assert {(v.of, v.order) for v in found} == {key for key, p in peaks.items() if p.verdict == "BEYOND"}
    assert found and [v.start for v in found] == sorted(v.start for v in found)
    times = np.linspace(0, 6, 5001)
    fine = arm().along(SinePath(3), times, 3)
    sizes = np.linalg.norm(fine.frame("b2").point((0, 0, 0.4)).jerk, axis=-1)
    for of, size in (("point", sizes), ("j1", np.abs(fine.rates[2][:, 1]))):
        own = [v for v in found if (v.of, v.order) == (of, 3)]
        inside = np.any([(times >= v.start) & (times <= v.end) for v in own], axis=0) & True
        np.testing.assert_array_equal(inside | np.zeros(5001, bool), size > peaks[of, 3].limit)
        if own:
            assert max(v.value for v in own) == pytest.approx(peaks[of, 3].value, rel=1e-9)


def test_a_jump_violates_every_limit_of_the_next_derivative():
    path = waypoints([0.0, 0.5, 2.0], np.random.default_rng(0).normal(size=(3, 3)))
    motion = arm().along(path, np.linspace(0, 2, 5), 4)
    (found,) = [v for v in motion.violations(limits={"j1": {"snap": 1e9}})]
    assert (found.start, found.end, found.value) == (0.5, 0.5, np.inf)


@pytest.mark.parametrize("noise", [1e-6, 3e-3])
def test_violations_of_a_recording_are_sure(noise):
    """The samples beyond the limit by more than the errors; with the true times within."""
    robot = Robot("r", [TreeJoint("tilt_x", "revolute", "world", "b")])
    t = np.linspace(0, 4, 801)
    q = 0.5 * np.sin(t + 1)[:, None] + noise * np.random.default_rng(0).normal(size=(801, 1))
    motion = robot.along((t, q), order=2)
    (found,) = motion.violations("b", (1, 0, 0), {"tilt_x": {"velocity": 0.4}, "rotation": {"velocity": 0.6}})
    rise = np.pi - np.arccos(0.8) - 1
    fall, width = rise + 2 * np.arccos(0.8), 0.01 if noise < 1e-3 else 0.2
    assert rise <= found.start <= rise + width and fall - width <= found.end <= fall
    (rotation,) = motion.violations("b", (1, 0, 0), {"rotation": {"velocity": 0.4}})
    assert (rotation.start, rotation.end) == (found.start, found.end)


def test_position_limits_are_checked_between_samples():
    """sin(t + 1)/2 is −1/2 at 3π/2 − 1, which is none of the times."""
    robot = Robot("r", [TreeJoint("tilt_x", "revolute", "world", "b")])
    limits = {"tilt_x": {"lower": -0.5 + 1e-9, "upper": 0.5}}
    found = robot.along(SinePath(1), np.linspace(0, 4, 5), 1).peaks(limits=limits)
    low, high = (peak for peak in found if peak.order == 0)
    assert (low.value, low.time) == (pytest.approx(-0.5, abs=1e-9), pytest.approx(1.5 * np.pi - 1, abs=1e-4))
    assert (low.within, high.within) == (False, True)
    assert {peak.unit for peak in found} == {
        "rad",
        "rad/s",
    }  # by the joint's kind, whatever its name ends with


def test_a_point_s_peaks_are_those_that_another_body_sees():
    motion = arm().along(quintic(), np.linspace(0, 1, 401), 2)
    seen = motion.frame("b2").relative_to(motion.frame("b0")).point((0, 0, 0.4))
    found = [p for p in motion.peaks("b2", (0, 0, 0.4), relative_to="b0") if p.of == "point"]
    sizes = np.linalg.norm(seen.derivatives[1:], axis=-1).max(axis=1)
    np.testing.assert_allclose([peak.value for peak in found], sizes, rtol=1e-4)
    table = motion.table("b2", (0, 0, 0.4), relative_to="b0")
    np.testing.assert_array_equal(table["b2 velocity x"], seen.velocity[:, 0])


def test_a_jump_at_a_break_is_seen_from_both_sides():
    path = PiecewisePolynomial.FirstOrderHold([0.0, 0.3003, 1.0], [[0.0, 1.0, 1.5]] * 3)
    found = arm().along(path, order=1, samples=3).peaks()
    assert found[0].value == pytest.approx(1 / 0.3003, rel=1e-9)


@pytest.mark.parametrize(
    ("limits", "message"),
    [
        ({"elbow": {"jerk": 1.0}}, "unknown joint 'elbow': expected one of \\*, point, rotation, j0"),
        ({"j0": {"jolt": 1.0}}, "limits of 'j0': expected one of velocity, .* got 'jolt'"),
        ({"j0": 3}, "limits of 'j0': expected a table"),
        ("fast", "limits: expected tables by joint"),
        ({"j0": {"jerk": "high"}}, "finite number for jerk, got 'high'"),
        ({"j0": {"jerk": -1.0}}, "finite number for jerk, got -1.0"),
        ({"point": {"upper": 1.0}}, "limits of 'point'"),
    ],
)
def test_bad_limits(limits, message):
    with pytest.raises(ValueError, match=message):
        arm().along(quintic(), np.linspace(0, 1, 5), 2).peaks(limits=limits)


def test_limits_from_a_file(tmp_path):
    (tmp_path / "limits.toml").write_text('["*"]\njerk = 5\n[point]\nsnap = 2.5\n')
    assert read_limits(tmp_path / "limits.toml") == {"*": {"jerk": 5}, "point": {"snap": 2.5}}
    (tmp_path / "bad.toml").write_text("jerk = 5\n")
    with pytest.raises(ValueError, match="expected tables like"):
        read_limits(tmp_path / "bad.toml")
    with pytest.raises(ValueError, match="cannot be read"):
        read_limits(tmp_path / "none.toml")


def test_a_table_as_csv_and_as_a_data_frame(tmp_path):
    motion = arm().along(quintic(), np.linspace(0, 1, 5), 3)
    columns = motion.table("b2", (0, 0, 0.4))
    np.testing.assert_allclose(
        columns["b2 jerk size"], np.linalg.norm(motion.frame("b2").point((0, 0, 0.4)).jerk, axis=1)
    )
    motion.to_csv(tmp_path / "out.csv", "b2", (0, 0, 0.4))
    with open(tmp_path / "out.csv") as file:
        names = file.readline().strip().split(",")
        rows = np.loadtxt(file, delimiter=",")
    assert [name.rsplit(" (")[0] for name in names] == list(columns)
    assert [names[0], names[1], names[4], names[-1]] == [
        "t (s)",
        "j0 (rad)",
        "velocity j0 (rad/s)",
        "b2 jerk size (m/s^3)",
    ]
    np.testing.assert_array_equal(rows, np.stack(list(columns.values()), axis=1))
    with pytest.raises(ValueError, match="cannot be written"):
        write_csv(columns, tmp_path / "none" / "out.csv")
    pandas = pytest.importorskip("pandas")
    frame = motion.to_dataframe("b2")
    assert isinstance(frame, pandas.DataFrame) and frame["t"].tolist() == motion.times.tolist()


def test_one_plot_call_shows_every_order(tmp_path):
    pytest.importorskip("matplotlib")
    motion = arm().along(quintic(), np.linspace(0, 1, 41), 3)
    figure = motion.plot("b2", limits={"*": {"jerk": 100.0}, "point": {"jerk": 50.0}})
    labels = [axis.get_ylabel() for axis in figure.axes]
    assert labels[:2] == ["velocity (rad or m)/s", "|velocity| m/s"] and len(labels) == 6
    curves = figure.axes[5].lines
    np.testing.assert_allclose(curves[0].get_ydata(), np.linalg.norm(motion.frame("b2").point().jerk, axis=1))
    assert any(line.get_linestyle() == "--" for line in curves)
    figure.savefig(tmp_path / "plot.png")


@pytest.fixture(scope="module")
def scene():
    from pydrake.geometry import Meshcat

    meshcat = Meshcat()
    arm().along(SinePath(3), np.linspace(0, 2, 65), 4).show(meshcat, "b2", (0, 0, 0.4), (1, 2, 3))
    return meshcat


def test_meshcat_shows_the_skeleton_the_path_and_the_vectors(scene):
    for place in (
        "bodies/b2",
        "bodies/b0/to j1",
        "path",
        "point",
        "vectors/jerk",
        "screw_axis",
        "centres/acceleration",
    ):
        assert scene.HasPath(f"/motion/{place}"), place


@pytest.mark.slow
def test_a_browser_shows_the_scene(scene, tmp_path):
    """Headless: the page runs without an error of its script and draws more than the empty scene."""
    from pydrake.geometry import Meshcat

    browser = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if browser is None:
        pytest.skip("no browser on this machine")
    image = pytest.importorskip("matplotlib.image")
    flags = "--headless --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader "
    flags += "--enable-logging=stderr --window-size=400,300 --virtual-time-budget=3000"
    pictures = []
    for name, meshcat in (("scene", scene), ("empty", Meshcat())):
        page, picture = tmp_path / f"{name}.html", tmp_path / f"{name}.png"
        page.write_text(meshcat.StaticHtml())
        command = [browser, *flags.split(), f"--screenshot={picture}", page.as_uri()]
        run = subprocess.run(command, capture_output=True, text=True, timeout=120)
        assert picture.exists(), run.stderr[-500:]
        assert "Uncaught" not in run.stderr, run.stderr[-500:]
        pictures.append(image.imread(picture)[..., :3])
    assert (np.abs(pictures[0] - pictures[1]).max(axis=-1) > 0.1).sum() > 50


def test_methods_that_need_a_path_raise_without_one():
    motion = arm().motion(np.zeros((3, 3)))
    for ask in (motion.peaks, motion.plot, motion.table, lambda: motion.show(None, "b2")):
        with pytest.raises(ValueError, match="expected a motion"):
            ask()
