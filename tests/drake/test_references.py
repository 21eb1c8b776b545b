"""Derivatives by Drake to any order: closed forms, one method against another, honest errors."""

from math import factorial
from pathlib import Path

import mpmath
import numpy as np
import pytest

from workbench.drake import chebyshev
from workbench.drake.joint_paths import JointPath
from workbench.drake.magnitudes import reach
from workbench.drake.plants import (
    CylindricalAxis,
    PlantError,
    cylindrical_chain,
    free_body,
    load_urdf,
    robot_urdf,
)
from workbench.drake.references import Reference, point_derivatives, twist_derivatives

HERE = Path(__file__).parent
AXES = (
    CylindricalAxis((1 / 3, 2 / 3, -2 / 3), (0.5, 0.25, -0.5)),
    CylindricalAxis((6 / 7, -2 / 7, 3 / 7), (-0.25, 1.0, 0.5)),
)
CHAIN = cylindrical_chain(AXES, ("A", "B"))
TWO_ARMS = load_urdf(HERE / "two_arms.urdf")
CRANE = load_urdf(HERE / "crane.urdf")
SMALL = {"chain": (CHAIN, "B"), "arm": (TWO_ARMS, "hand"), "crane": (CRANE, "boom")}
POINT = (0.5, -0.25, 1.0)


def random_path(plant, seed: int, degree: int, size: float = 1.0) -> JointPath:
    """Joint derivatives of the size of 1/s^k."""
    rng = np.random.default_rng(seed)
    scale = np.array([[size**k / factorial(k)] for k in range(degree + 1)])
    return JointPath(rng.uniform(-1, 1, (degree + 1, plant.num_positions())) * scale)


def assert_agree(ours: Reference, theirs: Reference, note=""):
    difference = np.max(np.abs(ours.value - theirs.value))
    assert difference <= ours.error + theirs.error, note


# --- closed forms ----------------------------------------------------------------------------


def planar_tip(path: JointPath, t: float, order: int) -> np.ndarray:
    """The boom's tip of the crane at slew 0 all along: 12 (cos θ, sin θ), to fifty digits."""
    with mpmath.workdps(50):
        coefficients = [mpmath.mpf(c) for c in path.coefficients[::-1, 1]]

        def theta(s):
            return mpmath.polyval(coefficients, s)

        x = mpmath.taylor(lambda s: 12 * mpmath.cos(theta(s)), t, order)
        y = mpmath.taylor(lambda s: 12 * mpmath.sin(theta(s)), t, order)
        return np.array(
            [
                [float(a * factorial(n)), float(b * factorial(n)), 0]
                for n, (a, b) in enumerate(zip(x, y, strict=True))
            ]
        )


@pytest.mark.parametrize("method", ["expression", "chebyshev"])
@pytest.mark.parametrize("seed", range(4))
def test_boom_in_its_plane(method, seed):
    path = JointPath(random_path(CRANE, seed, 4, size=1.5).coefficients * [0.0, 1.0])
    exact = planar_tip(path, 0.7, 8)
    ours = point_derivatives(CRANE, "boom", (12.0, 0, 0), path, 0.7, 8, method)
    assert len(ours) == 9
    for n, reference in enumerate(ours):
        actual = np.max(np.abs(reference.value - exact[n]))
        assert actual <= reference.error, (n, actual, reference)
        assert reference.error <= 1e-6 * np.max(np.abs(exact[n])), n


@pytest.mark.parametrize("method", ["expression", "chebyshev"])
def test_steady_precession(method):
    """Constant slew Ω and luff rates: ω = Ω + l(t) with l of constant size turning at Ω."""
    slew, luff, t = 0.30, 0.50, 1.1
    path = JointPath([[0.2, 0.5], [slew, luff]])
    phase = 0.2 + slew * t
    for k, reference in enumerate(twist_derivatives(CRANE, "boom", path, t, 7, method=method)):
        angle = phase + k * np.pi / 2
        exact = luff * slew**k * np.array([np.sin(angle), 0.0, np.cos(angle)])
        if k == 0:
            exact[1] = slew
        assert np.max(np.abs(reference.value[:3] - exact)) <= reference.error


@pytest.mark.parametrize("method", ["expression", "chebyshev"])
def test_steady_screw_motion_has_a_constant_twist_about_the_axis(method):
    """A point of the axis moves at ḋ u for ever, and a point at radius r on a helix."""
    axis = CylindricalAxis((0.0, 0.0, 1.0), (0.0, 0.0, 0.0))
    plant = cylindrical_chain([axis], ["B"])
    pitch, turn, t = 0.25, 2.0, 0.4
    path = JointPath([[0.1, 0.3], [pitch, turn]])
    twists = twist_derivatives(plant, "B", path, t, 6, method=method)
    assert np.max(np.abs(twists[0].value - [0, 0, turn, 0, 0, pitch])) <= twists[0].error
    for reference in twists[1:]:
        assert np.max(np.abs(reference.value)) <= reference.error
    helix = point_derivatives(plant, "B", (3.0, 0, 0), path, t, 6, method)
    for n, reference in enumerate(helix):
        angle = 0.3 + turn * t + n * np.pi / 2
        along = (0.1 + pitch * t, pitch)[n] if n < 2 else 0.0
        exact = [3 * turn**n * np.cos(angle), 3 * turn**n * np.sin(angle), along]
        assert np.max(np.abs(reference.value - exact)) <= reference.error


@pytest.mark.parametrize("method", ["expression", "chebyshev"])
def test_rest_has_no_derivatives_at_all(method):
    path = JointPath([[0.3, -0.7, 0.2, 0.9]])
    for reference in twist_derivatives(CHAIN, "B", path, 2.0, 6, method=method):
        assert not np.any(reference.value)
        assert reference.error == 0.0


@pytest.mark.parametrize("method", ["expression", "chebyshev"])
def test_translation_follows_the_displacement(method):
    path = JointPath([[0.0, 0.4], [1.0, 0.0], [0.5, 0.0], [-0.25, 0.0], [0.125, 0.0]])
    plant = cylindrical_chain(AXES[:1], ["B"])
    for n, reference in enumerate(point_derivatives(plant, "B", POINT, path, 0.5, 6, method)):
        if n > 0:
            exact = path(0.5, n)[0] * np.array(AXES[0].direction)
            assert np.max(np.abs(reference.value - exact)) <= reference.error


# --- one method against another --------------------------------------------------------------


@pytest.mark.parametrize("name", SMALL)
@pytest.mark.parametrize("seed", range(3))
def test_autodiff_jerk_is_the_expression_jerk(name, seed):
    from pydrake.symbolic import Variable

    from workbench.drake.symbolic_motions import SymbolicMotion, evaluated

    plant, body = SMALL[name]
    path, t = random_path(plant, seed, 3), Variable("t")
    motion = SymbolicMotion(plant, path, t)
    derivative = motion.twist(body, np.array(POINT))
    for reference in twist_derivatives(plant, body, path, 0.3, 3, POINT):
        value = evaluated(derivative, t, 0.3)
        assert np.max(np.abs(value - reference.value)) <= 2 * reference.error, reference.method
        derivative = motion.rate(derivative)
    assert reference.method == "AutoDiffXd"


@pytest.mark.parametrize("name", SMALL)
@pytest.mark.parametrize(
    "size, seed",
    [
        (0.01, 0),
        (1.0, 1),
        (5.0, 2),
        *(
            pytest.param(size, seed, marks=pytest.mark.slow)
            for size in (0.01, 0.1, 1.0, 5.0, 20.0)
            for seed in range(3, 13)
        ),
    ],
)
def test_chebyshev_error_covers_the_difference_from_expression(name, size, seed):
    plant, body = SMALL[name]
    path = random_path(plant, seed, 3, size)
    by = {
        method: twist_derivatives(plant, body, path, -0.2, 6, POINT, method)
        for method in ("expression", "chebyshev")
    }
    for k in range(3, 6):
        exact, estimated = by["expression"][k], by["chebyshev"][k]
        assert (exact.method, estimated.method) == ("Expression", "Chebyshev")
        assert exact.error < estimated.error
        assert_agree(exact, estimated, (k, estimated.error))
        assert estimated.error <= 1e-5 * np.max(np.abs(exact.value))


@pytest.mark.parametrize("tiny", [1e-9, 1e-200])
def test_joints_that_hardly_turn(tiny):
    """The body all but translates; the estimate must not be lost in endless windows."""
    path = JointPath([[0, 0, 0, 0], [0.5, tiny, 0.25, tiny], [0, 0, 0.5, 0], [0.25, 0, 0, 0]])
    exact, estimated = (
        twist_derivatives(CHAIN, "B", path, 0.3, 5, POINT, method) for method in ("expression", "chebyshev")
    )
    for one, other in zip(exact, estimated, strict=True):
        assert_agree(one, other)
        assert other.error < 1e-4


def test_a_body_that_no_joint_moves():
    path = random_path(TWO_ARMS, 0, 3)
    for method in ("expression", "chebyshev"):
        for reference in twist_derivatives(TWO_ARMS, "base", path, 0.3, 5, POINT, method):
            assert not np.any(reference.value) and reference.error == 0.0


def test_methods_and_their_orders():
    path = random_path(CHAIN, 0, 2)
    methods = [r.method for r in twist_derivatives(CHAIN, "B", path, 0.0, 5)]
    assert methods == ["double", "double", "AutoDiffXd", "Chebyshev", "Chebyshev"]
    methods = [r.method for r in twist_derivatives(CHAIN, "A", path, 0.0, 5)]
    assert methods == ["double", "double", "AutoDiffXd", "Expression", "Expression"]
    assert [r.method for r in twist_derivatives(CHAIN, "A", path, 0.0, 1)] == ["double"]


@pytest.mark.parametrize("method", ["expression", "chebyshev"])
def test_point_derivatives_are_those_of_the_twist_at_that_point(method):
    path = random_path(TWO_ARMS, 2, 3)
    twists = twist_derivatives(TWO_ARMS, "left", path, 0.1, 5, POINT, method)
    points = point_derivatives(TWO_ARMS, "left", POINT, path, 0.1, 5, method)
    assert points[0].method == "double" and len(points) == 6
    for twist, point in zip(twists, points[1:], strict=True):
        np.testing.assert_array_equal(twist.value[3:], point.value)


def test_the_clock_may_be_shifted():
    path = random_path(CHAIN, 4, 4)
    at_once = twist_derivatives(CHAIN, "B", path, 0.6, 5)
    later = twist_derivatives(CHAIN, "B", path.shifted(0.6), 0.0, 5)
    for one, other in zip(at_once, later, strict=True):
        assert_agree(one, other)


ROBOTS = {"panda": "panda_hand", "ur5_robot": "tool0"}


@pytest.mark.parametrize("name", ROBOTS)
@pytest.mark.parametrize("seed", range(2))
def test_real_robots_have_small_errors_that_cover_a_step_in_time(name, seed):
    """Order n + 1 foretells how order n changes: derivatives of the references themselves."""
    pytest.importorskip("cmeel_pth", reason="the extra 'robots' is not installed")
    plant, body = load_urdf(robot_urdf(name)), ROBOTS[name]
    path, h = random_path(plant, seed, 6), 1e-3
    now, before, after = (twist_derivatives(plant, body, path, s, 7) for s in (0.2, 0.2 - h, 0.2 + h))
    for k in range(6):
        rate = (after[k].value - before[k].value) / (2 * h)
        scale = np.max(np.abs(now[k + 1].value))
        assert np.max(np.abs(rate - now[k + 1].value)) <= 1e-3 * scale + 1e-4
        assert now[k].error <= 1e-6 * np.max(np.abs(now[k].value))


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(20))
def test_six_joints_by_expression_and_by_chebyshev(seed):
    """UR5 on linear joint paths is still small enough for Expression: all twelve trigonometric
    functions of it, to the sixth derivative."""
    pytest.importorskip("cmeel_pth", reason="the extra 'robots' is not installed")
    plant = load_urdf(robot_urdf("ur5_robot"))
    path = random_path(plant, seed, 1 + seed % 2, size=1 + seed % 3)
    exact, estimated = (
        twist_derivatives(plant, "tool0", path, 0.3, 7, POINT, method)
        for method in ("expression", "chebyshev")
    )
    for one, other in zip(exact, estimated, strict=True):
        assert_agree(one, other)


# --- the parts -------------------------------------------------------------------------------


@pytest.mark.parametrize("rate", [0.1, 1.0, 30.0])
@pytest.mark.parametrize("highest", [1, 4, 7])
def test_chebyshev_derivatives_of_a_known_function(rate, highest):
    found = chebyshev.derivatives(
        lambda s: np.array([np.sin(rate * s), np.exp(-rate * s)]),
        [turn / rate for turn in (1.0, 3.0, 6.0, 12.0)],
        highest,
    )
    for order, derivative in enumerate(found, start=1):
        exact = rate**order * np.array([np.sin(order * np.pi / 2), (-1.0) ** order])
        assert np.max(np.abs(derivative.value - exact)) <= derivative.error
        assert derivative.error <= 1e-6 * rate**order


def test_chebyshev_admits_what_it_cannot_resolve():
    """|s| has no derivative at 0, and a fast wave none that these windows show."""
    for function in (lambda s: np.array([abs(s)]), lambda s: np.array([np.sin(900 * s)])):
        (derivative,) = chebyshev.derivatives(function, [0.5, 1.0], 1)
        assert derivative.error > 0.1


def test_one_window_is_not_enough():
    with pytest.raises(ValueError, match="two different half-widths"):
        chebyshev.derivatives(lambda s: np.array([s]), [1.0, 1.0], 1)


def test_reach_is_what_carries_the_body():
    there = reach(TWO_ARMS, "hand", np.array([3.0, 0.0, 4.0]))
    names = TWO_ARMS.GetPositionNames(False, False)
    turn, swing, wrist = (names.index(n) for n in ("turn", "right_swing", "wrist"))
    assert set(there.rotations) == {turn, swing, wrist}
    assert there.translations == (names.index("extend"),)
    origins = [(0.1, -0.2, 0.5), (0, -0.3, 0.2), (0.4, 0, 0.1), (0.2, 0.1, 0)]
    assert there.length == pytest.approx(5.0 + sum(np.linalg.norm(p) for p in origins))


@pytest.mark.parametrize("name", SMALL)
def test_bounds_hold(name):
    """No derivative exceeds its bound, and the bound is reached when all axes agree."""
    plant, body = SMALL[name]
    extent = reach(plant, body, np.array(POINT))
    for seed in range(20):
        path = random_path(plant, seed, 3)
        for k, r in enumerate(twist_derivatives(plant, body, path, 0.3, 4, POINT)):
            sizes = (np.linalg.norm(r.value[:3]), np.linalg.norm(r.value[3:]))
            assert max(sizes) <= extent.bound(path, 0.3, k + 1)


def test_the_bound_is_sharp_for_uniform_rotation():
    path = JointPath([[0.0, 0.0], [0.0, 2.0]])
    extent = reach(CRANE, "boom", np.array([12.0, 0, 0]))
    for order in range(1, 6):
        assert extent.bound(path, 0.0, order) == pytest.approx(12 * 2.0**order)


@pytest.mark.parametrize("seed", range(5))
def test_joint_paths(seed):
    path = random_path(CHAIN, seed, 4)
    t = 0.7
    for order in range(6):
        exact = np.polynomial.Polynomial(path.coefficients[:, 1]).deriv(order)(t)
        assert path(t, order)[1] == pytest.approx(exact, abs=1e-14)
    shifted = path.shifted(t)
    np.testing.assert_allclose(shifted.jet(0.25, 5), path.jet(t + 0.25, 5), atol=1e-13)
    again = JointPath.from_derivatives(path.jet(0.0, path.degree))
    np.testing.assert_allclose(again.coefficients, path.coefficients, atol=1e-16)
    assert (path.joints, path.degree) == (4, 4)


# --- bad input -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "coefficients, complaint",
    [
        ([1.0, 2.0], r"shape \(degree \+ 1, joints\), got shape \(2,\)"),
        (np.zeros((0, 3)), r"got shape \(0, 3\)"),
        ([[1.0], [float("nan")]], "finite"),
        ([[float("inf")]], "finite"),
    ],
)
def test_unusable_paths(coefficients, complaint):
    with pytest.raises(ValueError, match=complaint):
        JointPath(coefficients)


def test_a_negative_order_of_a_path_is_refused():
    with pytest.raises(ValueError, match="order of a derivative"):
        JointPath([[1.0]])(0.0, -1)


def test_unusable_requests():
    path = JointPath([[0.0] * 4])
    with pytest.raises(ValueError, match="order: expected an integer >= 1, got 0"):
        twist_derivatives(CHAIN, "B", path, 0.0, 0)
    with pytest.raises(ValueError, match="method: expected one of auto, expression, chebyshev"):
        twist_derivatives(CHAIN, "B", path, 0.0, 1, method="guess")
    with pytest.raises(ValueError, match="finite time"):
        twist_derivatives(CHAIN, "B", path, float("nan"), 1)
    with pytest.raises(PlantError, match="no body 'C'"):
        twist_derivatives(CHAIN, "C", path, 0.0, 1)
    with pytest.raises(PlantError, match="the path has 4 joints, the plant 5 positions"):
        twist_derivatives(TWO_ARMS, "hand", path, 0.0, 1)
    with pytest.raises(PlantError, match="rates of their positions"):
        twist_derivatives(free_body(), "B", JointPath([[0.0] * 6]), 0.0, 1)
