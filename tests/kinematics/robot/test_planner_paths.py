"""Trajectories of toppra and Ruckig, against what these libraries say of them."""

import numpy as np
import pytest

from workbench.kinematics.robot import Robot, TreeJoint

NAMES = ("p", "v", "a")


def arm():
    return Robot("arm", [TreeJoint("j", "revolute", "world", "a"), TreeJoint("k", "prismatic", "a", "b")])


def peaks_of(motion, **limits):
    return {(peak.of, peak.name): peak for peak in motion.peaks(limits=limits)}


def ruckig_trajectory(targets=(1.0, 0.5), points=()):
    ruckig = pytest.importorskip("ruckig")
    given = ruckig.InputParameter(2)
    given.current_position, given.current_velocity, given.current_acceleration = (
        [0.1, 0],
        [0.3, -2.0],
        [0.5, 0.1],
    )
    given.target_position, given.target_velocity = list(targets), [0.1, 0.0]
    given.max_velocity, given.max_acceleration, given.max_jerk = [1.0, 1.0], [2.0, 2.5], [10.0, 12.0]
    trajectory = ruckig.Trajectory(2)
    assert ruckig.Ruckig(2).calculate(given, trajectory) in (ruckig.Result.Working, ruckig.Result.Finished)
    return trajectory


def test_a_ruckig_trajectory_is_the_path_that_ruckig_says():
    """With a brake phase at the start: the second joint is faster than its limit."""
    trajectory = ruckig_trajectory()
    assert trajectory.profiles[0][1].brake.duration > 0
    motion = arm().along(trajectory, order=4, samples=401)
    assert motion.times[-1] == trajectory.duration
    right = np.array([trajectory.at_time(t)[:3] for t in motion.times])
    found = np.concatenate([motion.q[None], motion.rates[:2]])
    np.testing.assert_allclose(found, right.swapaxes(0, 1), atol=1e-12)


def test_a_ruckig_trajectory_has_its_constant_jerk():
    trajectory = ruckig_trajectory()
    motion = arm().along(trajectory, order=4)
    found = peaks_of(
        motion, j={"acceleration": 2.0, "jerk": 10.0 + 1e-9}, k={"jerk": 12.0 + 1e-9, "snap": 1e6}
    )
    assert found["j", "jerk"].value == pytest.approx(10, rel=1e-11) and found["j", "jerk"].verdict == "within"
    assert found["k", "jerk"].verdict == "within"
    assert found["k", "snap"].value == np.inf and found["k", "snap"].verdict == "BEYOND"


def toppra_trajectory(parametrizer):
    toppra = pytest.importorskip("toppra")
    from toppra import algorithm, constraint

    toppra.setup_logging("ERROR")
    q = np.array([[0, 0], [1, 0.5], [0.3, 1.0], [0.5, 0.0]])
    path = toppra.SplineInterpolator([0, 0.5, 1.1, 2.0], q)
    bounds = np.array([[-1.0, 1.0], [-1.5, 1.5]])
    limits = constraint.JointVelocityConstraint(bounds), constraint.JointAccelerationConstraint(2 * bounds)
    grid = np.linspace(0, 2, 83)  # the waypoints lie between
    planned = algorithm.TOPPRA(list(limits), path, gridpoints=grid, parametrizer=parametrizer)
    return planned.compute_trajectory(0, 0), path


@pytest.mark.parametrize("parametrizer", ["ParametrizeConstAccel", "ParametrizeSpline"])
def test_a_toppra_trajectory_is_the_path_that_toppra_says(parametrizer):
    trajectory, _ = toppra_trajectory(parametrizer)
    motion = arm().along(trajectory, order=3, samples=997)
    np.testing.assert_allclose(motion.times[[0, -1]], trajectory.path_interval, atol=1e-12)
    inside = motion.times[1:-1]
    np.testing.assert_allclose(motion.q[1:-1], trajectory(inside), atol=1e-12)
    for k in (1, 2):
        right = trajectory(inside, k)
        far = np.abs(motion.rates[k - 1][1:-1] - right) > 1e-8  # at a jump either side is right
        assert far.mean() < 0.005


def test_a_toppra_trajectory_s_jerk_is_its_acceleration_s_slope():
    trajectory, _ = toppra_trajectory("ParametrizeConstAccel")
    motion, h = arm().along(trajectory, order=3, samples=301), 1e-6
    breaks = motion.path.breaks
    inside = np.array([t for t in motion.times if np.abs(breaks - t).min() > 1e-4][1:-1])
    slope = (trajectory(inside + h, 2) - trajectory(inside - h, 2)) / (2 * h)
    np.testing.assert_allclose(motion.at(inside).rates[2], slope, atol=1e-6 * np.abs(slope).max())
    found = peaks_of(motion, j={"acceleration": 2.0 + 1e-3, "jerk": 1e4})
    assert found["j", "acceleration"].value < 2.01, "toppra keeps the limit at the points of its grid"
    assert found["j", "jerk"].value == np.inf, "the acceleration jumps at every point of the grid"


def test_a_toppra_path_is_taken_as_it_is():
    _, path = toppra_trajectory("ParametrizeSpline")
    motion = arm().along(path, order=3)
    np.testing.assert_allclose(motion.rates[1], path(motion.times, 2), atol=1e-12)


def test_a_planner_s_path_of_other_pieces_is_refused():
    class Parametrized:
        path_interval = (0.0, 1.0)

        def __call__(self, t, order=0):
            return np.zeros(2)

    with pytest.raises(ValueError, match=r"expected toppra's SplineInterpolator.*got Parametrized"):
        arm().along(Parametrized())
    with pytest.raises(ValueError, match="a trajectory of toppra or Ruckig"):
        arm().along(object())
