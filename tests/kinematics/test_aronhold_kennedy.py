"""Three screw axes: laws over exact and float twists, every configuration, textbook cases, theorems."""

from fractions import Fraction

import numpy as np
import pytest

from tests.kinematics.three_bodies import (
    JOINTS,
    JOINTS_FIRST_TRANSLATES,
    drake_checks,
    rational_checks,
)
from workbench.algebra.dual import Dual
from workbench.algebra.dual_tensors import apply, cross, dot, is_orthogonal, vector
from workbench.drake.plants import CylindricalAxis, cylindrical_chain, set_state
from workbench.kinematics.aronhold_kennedy import Configuration, relative_twists, three_axes
from workbench.kinematics.screws import from_rodrigues_vector

EXAMPLES = [
    (configuration, joints)
    for table in (JOINTS, JOINTS_FIRST_TRANSLATES)
    for configuration, examples in table.items()
    for joints in examples
]
every_configuration = pytest.mark.parametrize(
    ("configuration", "joints"), EXAMPLES, ids=[f"{c.name}-{i}" for i, (c, _) in enumerate(EXAMPLES)]
)


def rational(rng):
    numerators, denominators = rng.integers(-9, 10, (2, 3)), rng.integers(1, 8, (2, 3))
    return vector(
        *[
            [Fraction(int(n), int(d)) for n, d in zip(*pair, strict=True)]
            for pair in zip(numerators, denominators, strict=True)
        ]
    )


def in_floats(a):
    return Dual(a.re.astype(float), a.du.astype(float))


def same_line(a, b):
    """Equal up to a factor that is not zero."""
    return not np.any(cross(a.re, b.re)) and all(
        a.re[i] * b.du[j] == a.du[j] * b.re[i] for i in range(3) for j in range(3)
    )


def feet(perpendicular, axes):
    """The points of each axis on the perpendicular: where the two lines' points agree."""
    found = []
    for i in range(3):
        u, m = axes.re[i], axes.du[i]
        d, n = perpendicular.re, perpendicular.du
        base = cross(d, n) / dot(d, d)
        offset = cross(u, m) / dot(u, u) - base
        found.append(base + dot(offset, d) / dot(d, d) * d)
        assert not np.any(cross(found[-1], u) - m)
        assert not np.any(cross(found[-1], d) - n)
    return found


@pytest.mark.parametrize("seed", range(30))
def test_oblique_axes_meet_the_product_line_at_right_angles(seed):
    rng = np.random.default_rng(seed)
    a, b = rational(rng), rational(rng)
    found = three_axes(a, b)
    assert found.configuration is Configuration.SKEW
    assert not np.any(dot(found.perpendicular.re, found.axes.re))
    assert dot(found.perpendicular.re, found.perpendicular.du) == 0
    assert not np.any(found.perpendicular.re - cross(a, b).re)
    points = feet(found.perpendicular, found.axes)
    for i, twist in enumerate((a, b, a + b)):
        velocity = twist.du + cross(twist.re, points[i])
        assert not np.any(velocity - found.pitches[i] * twist.re)


@pytest.mark.parametrize("seed", range(10))
def test_the_three_motions_play_the_same_part(seed):
    rng = np.random.default_rng(seed)
    a, b = rational(rng), rational(rng)
    line = three_axes(a, b).perpendicular
    for pair in ((b, a), (b, -(a + b)), (a, -(a + b)), (-a, -b)):
        assert same_line(line, three_axes(*pair).perpendicular)


@every_configuration
def test_equivariance_under_rational_displacements(configuration, joints):
    rng = np.random.default_rng(5)
    R = from_rodrigues_vector(rational(rng))
    assert is_orthogonal(R)
    a, b = (joint.twist() for joint in joints)
    found, moved = three_axes(a, b), three_axes(apply(R, a), apply(R, b))
    assert moved.configuration is configuration
    for i in range(3):
        assert moved.axes[i] == apply(R, found.axes[i])
    assert list(moved.pitches) == list(found.pitches)
    if configuration.remark_7_holds:
        assert moved.perpendicular == apply(R, found.perpendicular)


@every_configuration
def test_floats_are_read_as_their_exact_twists_are(configuration, joints):
    a, b = (joint.twist() for joint in joints)
    for stretch in (1.0, 1e-8, 1e8):  # another unit of length
        first, second = (Dual(t.re, t.du * stretch) for t in map(in_floats, (a, b)))
        found = three_axes(first, second)
        assert found.configuration is configuration
        exact = three_axes(a, b)
        assert np.array_equal(found.has_axis, exact.has_axis)
        np.testing.assert_allclose(found.axes.du, in_floats(exact.axes).du * stretch, atol=1e-13 * stretch)


def test_rounded_twists_of_moved_bodies_keep_their_configuration():
    """Rounding of a displacement does not tear parallel or coincident axes apart."""
    rng = np.random.default_rng(6)
    for _ in range(60):
        R = from_rodrigues_vector(Dual(rng.normal(size=3), rng.normal(size=3)))
        for configuration, joints in EXAMPLES:
            a, b = (in_floats(joint.twist()) for joint in joints)
            assert three_axes(apply(R, a), apply(R, b)).configuration is configuration


def test_a_batch_is_its_states():
    pairs = [[in_floats(joint.twist()) for joint in joints] for _, joints in EXAMPLES]
    first, second = (
        Dual(np.stack([p[i].re for p in pairs]), np.stack([p[i].du for p in pairs])) for i in (0, 1)
    )
    batch = three_axes(first, second)
    for k, (a, b) in enumerate(pairs):
        single = three_axes(a, b)
        assert batch.configuration[k] is single.configuration
        assert batch.axes[k] == single.axes
        assert batch.perpendicular[k] == single.perpendicular
        assert np.array_equal(batch.pitches[k], single.pitches)


def test_a_twist_is_broadcast_over_a_batch():
    rng = np.random.default_rng(1)
    batch = Dual(rng.normal(size=(4, 5, 3)), rng.normal(size=(4, 5, 3)))
    found = three_axes(batch[0, 0], batch)
    assert found.configuration.shape == (4, 5)
    assert found.axes.re.shape == (4, 5, 3, 3)
    assert found.configuration[0, 0] is Configuration.COINCIDENT
    assert found.configuration[1, 2] is Configuration.SKEW


@every_configuration
def test_every_member_of_the_family_crosses_every_axis(configuration, joints):
    found = three_axes(*(joint.twist() for joint in joints))
    if configuration.freedom not in (1, 2):
        with pytest.raises(ValueError, match="no family of common perpendiculars"):
            found.perpendicular_at(Fraction(1))
        return
    for slide in (Fraction(0), Fraction(7, 3)):
        line = found.perpendicular_at(slide)
        assert any(line.re)
        for i in np.flatnonzero(found.has_axis):
            assert dot(line, found.axes[i]) == 0


# -- textbook cases --------------------------------------------------------------------------------


def screw(omega, point, pitch=0.0):
    omega = np.asarray(omega, dtype=float)
    return Dual(omega, pitch * omega + np.cross(point, omega))


def test_equal_rotations_about_crossed_axes_fit_the_cylindroid():
    """Axes along x and y at z = ∓1/2: the sum's axis bisects them half-way, with pitch −1/2."""
    found = three_axes(screw([1, 0, 0], [0, 0, -0.5]), screw([0, 1, 0], [0, 0, 0.5]))
    assert found.configuration is Configuration.SKEW
    np.testing.assert_allclose(found.axes.du[2], 0, atol=1e-15)
    np.testing.assert_allclose(found.pitches, [0, 0, -0.5])
    assert found.perpendicular == Dual(np.array([0.0, 0, 1]), np.zeros(3))


def test_bevel_gears_roll_about_a_line_through_the_apex():
    found = three_axes(screw([2, 0, 0], [1, 1, 1]), screw([0, 3, 0], [1, 1, 1]))
    assert found.configuration is Configuration.CONCURRENT
    np.testing.assert_allclose(found.axes.du[2], np.cross([1, 1, 1], [2, 3, 0]))


def test_instantaneous_centres_of_plane_motions_are_collinear():
    """Kennedy's theorem in the plane; the third centre divides the distance as ω₂ : ω₁."""
    found = three_axes(screw([0, 0, 1], [0, 0, 0]), screw([0, 0, 2], [3, 0, 0]))
    assert found.configuration is Configuration.PARALLEL
    np.testing.assert_allclose(found.axes.du[2], np.cross([2, 0, 0], [0, 0, 3]))


def test_equal_and_opposite_rotations_compose_to_a_translation():
    """A couple of rotations, ω at a distance l: the translation by ω l (Poinsot)."""
    found = three_axes(screw([0, 0, 2], [0, 0, 0]), screw([0, 0, -2], [3, 0, 0]))
    assert found.configuration is Configuration.PARALLEL_TRANSLATION
    assert list(found.has_axis) == [True, True, False]


@pytest.mark.parametrize("seed", range(5))
def test_three_bodies_of_a_plant_at_any_state(seed):
    rng = np.random.default_rng(seed)
    axes = [CylindricalAxis(tuple(rng.normal(size=3)), tuple(rng.normal(size=3))) for _ in "AB"]
    plant = cylindrical_chain(axes, ("A", "B"))
    context = plant.CreateDefaultContext()
    set_state(plant, context, rng.normal(size=4), rng.normal(size=4))
    first, second, third = relative_twists(plant, context, ("world", "A", "B"))
    np.testing.assert_allclose((first + second - third).re, 0, atol=1e-13)
    np.testing.assert_allclose((first + second - third).du, 0, atol=1e-13)
    found = three_axes(first, second)
    line_of_joint = plant.GetFrameByName("A_axis_on_parent").CalcPoseInWorld(context)
    p, u = line_of_joint.translation(), np.array(axes[0].direction)
    np.testing.assert_allclose(np.cross(found.axes.re[0], u), 0, atol=1e-12)
    np.testing.assert_allclose(found.axes.du[0], np.cross(p, found.axes.re[0]), atol=1e-12)
    for i in range(3):
        product = dot(found.perpendicular, found.axes[i])
        assert abs(product.re) < 1e-12
        assert abs(product.du) < 1e-12


# -- bad input ------------------------------------------------------------------------------------


def test_bad_twists_are_named():
    good = Dual(np.ones(3), np.ones(3))
    with pytest.raises(TypeError, match="second twist: expected a dual vector"):
        three_axes(good, np.ones(6))
    with pytest.raises(ValueError, match=r"expected shape \(..., 3\)"):
        three_axes(Dual(np.ones(6), np.ones(6)), good)
    with pytest.raises(ValueError, match="first twist: expected finite numbers"):
        three_axes(Dual(np.array([np.nan, 0, 0]), np.ones(3)), good)
    with pytest.raises(ValueError, match="expected two batches of twists that fit"):
        three_axes(Dual(np.ones((2, 3)), np.ones((2, 3))), Dual(np.ones((3, 3)), np.ones((3, 3))))


# -- every configuration constructed --------------------------------------------------------------


@pytest.mark.parametrize("checks", [rational_checks, drake_checks])
@pytest.mark.parametrize(
    ("configuration", "first_translates"),
    [
        *((configuration, False) for configuration in Configuration),
        (Configuration.PARALLEL_TRANSLATION, True),
        (Configuration.COINCIDENT_TRANSLATION, True),
    ],
)
def test_three_axes_of_bodies_that_are_constructed(checks, configuration, first_translates):
    assert all(checks(configuration, first_translates, spoilt=False))
    assert not all(checks(configuration, first_translates, spoilt=True))
