"""Time scaling: the least slowdown in closed form, and retimed paths within their limits, beside toppra and Ruckig."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.kinematics.robot import Robot, TreeJoint
from workbench.kinematics.robot.joints import Limits
from workbench.kinematics.robot.trajectories.paths import JointPath
from workbench.kinematics.robot.trajectories.spline_paths import waypoints
from workbench.kinematics.robot.trajectories.time_scaling import RetimedPath, slowed

ARM = Robot("arm", [TreeJoint("j", "revolute", "world", "a"), TreeJoint("k", "prismatic", "a", "b")])
SEPTIC = np.array([0, 0, 0, 0, 35, -84, 70, -20])
LIMITS = {"*": {"velocity": 1, "acceleration": 2, "jerk": 10}, "point": {"acceleration": 1.5}}
ON_B = {"body": "b", "point": (0.1, 0, 0)}


def quintic(size=1.0):
    """0 to `size` in 1 s; the peaks are 15/8, 10/√3 and 60 times the size."""
    return ARM.along(JointPath(size * np.outer([0, 0, 0, 10, -15, 6], [1, 0])), np.linspace(0, 1, 51), 4)


def tour(seed=0):
    """Through random waypoints at random times, at rest in each."""
    rng = np.random.default_rng(seed)
    t, q = np.cumsum(rng.uniform(0.1, 1.0, 5)), rng.uniform(-1, 1, (5, 2))
    return ARM.along(waypoints(t, q, 0 * q, 0 * q), order=4)


@pytest.mark.parametrize(
    ("limits", "right"),
    [
        ({"velocity": 0.5}, 15 / 8 / 0.5),
        ({"acceleration": 0.4}, (10 / 3**0.5 / 0.4) ** (1 / 2)),
        ({"jerk": 7.0}, (60 / 7) ** (1 / 3)),
        ({"jerk": 6000.0}, 0.01 ** (1 / 3)),
        ({"velocity": 0.5, "jerk": 7.0}, 15 / 8 / 0.5),
    ],
)
def test_the_least_slowdown_of_a_quintic_is_known(limits, right):
    found = quintic().slowdown(limits={"j": limits})
    assert found.factor == pytest.approx(right, rel=1e-10)
    assert found.peak.of == "j" and found.peak.name in limits


@settings(max_examples=2)
@given(st.integers(0, 2**32 - 1))
def test_a_slowed_path_just_keeps_its_limits(seed):
    motion = tour(seed)
    found = motion.slowdown(**ON_B, limits=LIMITS)
    for factor, within in ((found.factor, True), (found.factor * (1 - 1e-6), False)):
        path = slowed(motion.path, factor)
        peaks = ARM.along(path, order=4).peaks(**ON_B, limits=LIMITS)
        assert all(peak.within for peak in peaks if peak.limit is not None) is within
        assert path.end - path.start == pytest.approx(factor * np.ptp(motion.times), rel=1e-13)


def test_a_slowed_recording_is_that_of_the_slowed_motion():
    t = np.arange(401) / 100
    q = np.stack([np.sin(3 * t), 0.2 * np.cos(2 * t)], axis=1)
    found = ARM.along((t, q), order=3).slowdown(limits={"j": {"jerk": 9.0}})
    assert 3 ** (1 / 3) <= found.factor < 1.02 * 3 ** (1 / 3)
    path = slowed(ARM.path((t, q)), found.factor * 1.02)
    peaks = ARM.along(path, order=3).peaks(limits={"j": {"jerk": 9.0}})
    assert {peak.within for peak in peaks if peak.limit} == {True}
    with pytest.raises(ValueError, match="retimed: expected a path with exact derivatives, got a recording"):
        ARM.along((t, q), order=3).retimed(limits={"j": {"jerk": 9.0}})


@pytest.mark.parametrize("seed", range(1))
def test_a_retimed_path_is_within_all_limits(seed):
    """Of joints and of a point; it is no longer than the uniform slowdown, and ends where the path does."""
    motion = tour(seed)
    uniform = motion.slowdown(**ON_B, limits=LIMITS).factor * np.ptp(motion.times)
    path = motion.retimed(**ON_B, limits=LIMITS)
    moving = ARM.along(path, order=4)
    verdicts = {peak.verdict for peak in moving.peaks(**ON_B, limits=LIMITS) if peak.limit is not None}
    assert verdicts == {"within"} and not moving.violations(**ON_B, limits=LIMITS)
    assert path.end < 0.9 * uniform
    np.testing.assert_allclose(moving.q[[0, -1]], motion.q[[0, -1]], atol=1e-12)


def test_derivatives_of_a_retimed_path_are_those_of_its_values():
    """To the order 5, by a fit of Chebyshev polynomials between two breaks; and q is that of the path at s(t)."""
    path = tour(4).retimed(limits=LIMITS)
    edges = np.concatenate([[0], path.breaks, [path.end]])
    widest = int(np.argmax(np.diff(edges)))
    low, high = edges[widest : widest + 2] + np.diff(edges)[widest] * np.array([0.01, -0.01])
    t = (low + high) / 2 + (high - low) / 2 * np.cos(np.pi * (np.arange(60) + 0.5) / 60)
    fit = np.polynomial.chebyshev.Chebyshev.fit(t, path.derivatives(t, 0)[0][:, 0], 30, domain=[low, high])
    at = np.linspace(low, high, 9)[2:-2]
    found = path.derivatives(at, 5)
    np.testing.assert_allclose(found[0], path.path.derivatives(path.parameter(at), 0)[0], atol=1e-14)
    for k in range(1, 6):
        scale = np.abs(found[k]).max() + (10 / (high - low)) ** k * 1e-5
        np.testing.assert_allclose(found[k][:, 0], fit.deriv(k)(at), atol=10.0 ** (k - 11) * scale)


def test_a_retimed_path_is_near_toppra_s_optimum():
    """Without limits of the jerk, toppra's path with the same speeds at its ends is the fastest there is."""
    toppra = pytest.importorskip("toppra")
    from toppra import algorithm, constraint

    toppra.setup_logging("ERROR")
    q = np.array([[0, 0], [1, 0.5], [0.3, 1.0], [0.5, 0.0]])
    path, bounds = toppra.SplineInterpolator([0, 0.5, 1.1, 2.0], q), np.array([[-1.0, 1.0], [-1.5, 1.5]])
    limits = constraint.JointVelocityConstraint(bounds), constraint.JointAccelerationConstraint(2 * bounds)
    tables = {"j": {"velocity": 1.0, "acceleration": 2.0}, "k": {"velocity": 1.5, "acceleration": 3.0}}
    motion = ARM.along(path, order=2)
    ours = motion.retimed(limits=tables)
    planned = algorithm.TOPPRA(
        list(limits), path, gridpoints=np.linspace(0, 2, 401), parametrizer="ParametrizeSpline"
    )
    speeds = 1 / ours.slowness([0.0, 2.0])
    optimum = planned.compute_trajectory(*map(float, speeds)).duration
    assert (
        0.999 * optimum < ours.end < 1.1 * optimum and ours.end < motion.slowdown(limits=tables).factor * 2.0
    )


def test_a_retimed_move_is_near_ruckig_s_optimum():
    """From rest to rest with limits of the jerk: Ruckig's is the fastest there is."""
    ruckig = pytest.importorskip("ruckig")
    given = ruckig.InputParameter(1)
    given.current_position, given.target_position = [0.0], [1.0]
    given.max_velocity, given.max_acceleration, given.max_jerk = [1.0], [2.0], [10.0]
    trajectory = ruckig.Trajectory(1)
    ruckig.Ruckig(1).calculate(given, trajectory)
    path = JointPath(np.outer(SEPTIC, [1.0, 0.0]))
    limits = {"j": {"velocity": 1, "acceleration": 2, "jerk": 10}}
    ours = ARM.along(path, np.linspace(0, 1, 51), 4).retimed(limits=limits).end
    assert trajectory.duration < ours < 1.15 * trajectory.duration


def test_limits_that_no_slowdown_satisfies_are_rejected():
    with pytest.raises(ValueError, match=r"no slowdown keeps this limit: position of j: 1 rad"):
        quintic().slowdown(limits={"j": {"upper": 0.5}})
    with pytest.raises(ValueError, match=r"no slowdown is sure to keep this limit: snap of j: unbounded"):
        tour().slowdown(limits={"j": {"snap": 1e9}})
    with pytest.raises(ValueError, match="expected at least one of a derivative"):
        quintic().slowdown()
    with pytest.raises(
        ValueError, match="expected a motion of order 3 or more for the jerk of 'k', got order 2"
    ):
        ARM.along(JointPath(np.eye(2)), [0.0, 1.0], 2).slowdown(limits={"k": {"jerk": 1}})
    with pytest.raises(ValueError, match="no slowdown is sure to keep this limit: velocity of j"):
        quintic().slowdown(limits={"j": {"velocity": 0}})
    with pytest.raises(ValueError, match="factor: expected a positive number, got 0"):
        slowed(quintic().path, 0)


def test_a_robot_s_own_limits_count():
    joint = TreeJoint("j", "revolute", "world", "a", limits=Limits(velocity=0.5, jerk=7.0))
    path = JointPath(np.outer([0, 0, 0, 10, -15, 6], [1.0]))
    found = Robot("r", [joint]).along(path, [0.0, 1.0], 3).slowdown()
    assert found.factor == pytest.approx(3.75) and found.peak.name == "velocity"


def test_a_retimed_path_at_one_time_is_one_state():
    path = tour().retimed(limits=LIMITS)
    assert isinstance(path, RetimedPath) and path.derivatives(0.3, 3).shape == (4, 2)
    with pytest.raises(ValueError, match="times: expected times from 0"):
        path.derivatives(path.end + 1, 1)
