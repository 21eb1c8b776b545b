"""Trajectories in (Drake's, samples, formulas) and answers out (peaks, tables, plots, MeshCat)."""

import shutil
import subprocess

import numpy as np
import pytest
from pydrake.trajectories import BsplineTrajectory, CompositeTrajectory, PiecewisePolynomial

from workbench.kinematics.robot import Robot, TreeJoint
from workbench.kinematics.robot.answers import write_csv
from workbench.kinematics.robot.joint_limits import read_limits
from workbench.kinematics.robot.paths import DrakePath, JointPath, RecordedPath, SinePath, read_samples

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


def test_the_peaks_of_a_point_to_point_motion_are_those_of_the_textbook():
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


def test_a_coordinate_is_held_against_its_limits_between_samples_too():
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
    found = motion.peaks("b2", (0, 0, 0.4), relative_to="b0")[-2:]
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
        ({"elbow": {"jerk": 1.0}}, "unknown joint 'elbow': expected one of \\*, point, j0"),
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
    assert names == list(columns)
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


def test_meshcat_holds_the_skeleton_the_path_and_what_moves_with_them(scene):
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


def test_what_needs_a_path_says_so():
    motion = arm().motion(np.zeros((3, 3)))
    for ask in (motion.peaks, motion.plot, motion.table, lambda: motion.show(None, "b2")):
        with pytest.raises(ValueError, match="expected a motion"):
            ask()
