"""Peaks of exact paths against the roots of their derivatives."""

import numpy as np
import pytest
from scipy import interpolate

from workbench.kinematics.robot import Robot, TreeJoint
from workbench.kinematics.robot.trajectories.paths import JointPath

QUINTIC = np.array([0.0, 0.0, 0.0, 10.0, -15.0, 6.0])


def test_peaks_of_random_splines_are_roots_of_derivatives():
    """Of quintics through random points, by SciPy's roots; the times have neighbours that only rounding tells
    apart."""
    robot = Robot("r", [TreeJoint(n, "revolute", p, n) for n, p in (("j", "world"), ("k", "j"))])
    limits = {"*": {"lower": -9, "upper": 9}}
    for seed in range(30):
        rng = np.random.default_rng(seed)
        t = np.cumsum(rng.uniform(0.05, 1.5, rng.integers(6, 12)))
        spline = interpolate.make_interp_spline(t, rng.uniform(-2, 2, (len(t), 2)), k=5)
        times = np.linspace(t[0], t[-1], 401)
        times = np.clip(
            np.sort(np.concatenate([times, times * (1 + 1e-16), times * (1 - 2e-16)])), t[0], t[-1]
        )
        for peak in robot.along(spline, times, order=2).peaks(limits=limits):
            curve = interpolate.PPoly.from_spline(
                (spline.t, spline.c[:, robot.positions.index(peak.of)], 5)
            ).derivative(peak.order)
            values = curve(np.append(curve.derivative().roots(extrapolate=False), t[[0, -1]]))
            true = {"lower": -values, "upper": values}[peak.bound] if peak.order == 0 else np.abs(values)
            value = -peak.value if peak.order == 0 and peak.bound == "lower" else peak.value
            assert abs(value - true.max()) < 1e-8 * max(1, np.abs(values).max()), (seed, str(peak))


def test_a_deceleration_is_largest_up_to_the_stop():
    """Of random quintics, by SciPy's roots of q̇ and q⃛; at a stop it drops to 0."""
    robot = Robot("r", [TreeJoint("j", "revolute", "world", "j")])
    for seed in range(20):
        rng = np.random.default_rng(seed)
        t = np.cumsum(rng.uniform(0.05, 1.5, rng.integers(6, 12)))
        spline = interpolate.make_interp_spline(t, rng.uniform(-2, 2, (len(t), 1)), k=5)
        limits = {"j": {"deceleration": 5}}
        (found,) = (p for p in robot.along(spline, order=2).peaks(limits=limits) if p.name == "deceleration")
        v, a, jerk = (
            interpolate.PPoly.from_spline((spline.t, spline.c[:, 0], 5)).derivative(k) for k in (1, 2, 3)
        )
        at = np.concatenate([v.roots(extrapolate=False), jerk.roots(extrapolate=False), t])
        at = np.clip(np.concatenate([at - 1e-10, at, at + 1e-10]), t[0], t[-1])
        true = np.abs(a(at))[v(at) * a(at) < 0].max()
        assert found.value == pytest.approx(true, rel=1e-7), seed


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e5])
def test_a_path_at_its_limits_is_within_them(scale):
    """A quintic has the peaks 15/8, 10/√3 and 60; a size beyond a limit by its rounding is at the limit."""
    robot = Robot("slide", [TreeJoint("j", "prismatic", "world", "a")])
    motion = robot.along(JointPath(scale * QUINTIC[:, None]), np.linspace(0, 1, 33), order=3)
    limits = {"velocity": 15 / 8, "acceleration": 10 / 3**0.5, "jerk": 60, "lower": 0, "upper": 1}
    for part, within in ((1e-13, True), (1e-9, False)):
        near = {
            name: scale * (limit - part * max(limit, 1.0) * (-1) ** (name == "lower"))
            for name, limit in limits.items()
        }
        found = [peak for peak in motion.peaks(limits={"j": near}) if peak.limit is not None]
        assert [peak.within for peak in found] == [within] * 5, list(map(str, found))
        violated = {one.name for one in motion.violations(limits={"j": near})}
        assert violated == (set() if within else set(limits))
