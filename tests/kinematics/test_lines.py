"""Laws of lines as unit dual vectors: Plücker condition, equivariance, distance and angle."""

from fractions import Fraction
from random import Random

import numpy as np
import pytest

from tests.dual_scalars import FIELDS, FLOAT, FRACTION, over, quiet_expressions
from workbench.algebra.dual import Dual, ZeroDivisor
from workbench.algebra.dual_functions import cos
from workbench.algebra.dual_tensors import apply, cross, dot, norm
from workbench.kinematics import lines, screws

pytestmark = quiet_expressions
EXACT_DIRECTIONS = [[0, 0, 1], [2, -1, 2], [3, 4, 0], [2, 3, 6], [-4, 4, 7]]  # of integer length


def exact_line(rng: Random) -> tuple[Dual, np.ndarray, np.ndarray]:
    direction = [Fraction(c) for c in rng.choice(EXACT_DIRECTIONS)]
    point = FRACTION.real_vector(rng)
    line = lines.line_through(point, direction)
    return line, point, line.re


def float_lines(count: int = 500) -> tuple[np.ndarray, np.ndarray, Dual]:
    rng = np.random.default_rng(5)
    points, directions = rng.normal(size=(2, count, 3))
    return points, directions, lines.line_through(points, directions)


@over([s for s in FIELDS if s.name != "fmpq"], cases=4)
def test_every_line_satisfies_the_plucker_condition(scalars, rng):
    p = scalars.real_vector(rng)
    line, *_ = exact_line(rng)
    moved = Dual(line.re, line.du + cross(p, line.re))
    square = dot(moved, moved)
    assert scalars.vanishes(square - 1)
    foot = lines.nearest_point_to_origin(moved)
    assert scalars.vanishes(cross(foot, moved.re) - moved.du)
    assert scalars.vanishes(dot(foot, moved.re))


@over([FRACTION], cases=10)
def test_a_line_does_not_depend_on_the_point_chosen_on_it(scalars, rng):
    line, point, direction = exact_line(rng)
    other = point + scalars.number(rng) * direction
    assert lines.is_line(line)
    assert lines.line_through(other, 5 * direction) == line
    assert lines.line_joining(other, other + 2 * direction) == line
    assert lines.distance_to_point(line, other) == 0


@over([FRACTION, FLOAT], cases=10)
def test_displacement_carries_lines_as_it_carries_points(scalars, rng):
    line, point, direction = exact_line(rng)
    if scalars is FLOAT:
        line, point, direction = (
            Dual(line.re.astype(float), line.du.astype(float)),
            point.astype(float),
            direction.astype(float),
        )
    displacement = screws.from_rodrigues_vector(scalars.vector(rng))
    R, rho = screws.structural_invariants(displacement)
    moved = lines.line_through(apply(R, point) + rho, apply(R, direction))
    assert scalars.vanishes(apply(displacement, line) - moved)


def test_distance_and_angle_are_invariant_under_displacements():
    _, _, first = float_lines()
    second = Dual(first.re[::-1], first.du[::-1])
    rng = np.random.default_rng(6)
    R = screws.exp(Dual(rng.normal(size=(500, 3)), rng.normal(size=(500, 3))))
    before = lines.dual_angle(first, second)
    after = lines.dual_angle(apply(R, first), apply(R, second))
    assert np.abs(before.re - after.re).max() < 1e-12
    assert np.all(np.abs(before.du - after.du) * np.sin(before.re) < 1e-12)
    swapped = lines.dual_angle(second, first)
    assert np.abs(before.re - swapped.re).max() < 1e-14
    assert np.all(np.abs(before.du - swapped.du) * np.sin(before.re) < 1e-13)


def test_cosine_of_the_dual_angle_is_the_scalar_product():
    _, _, first = float_lines()
    second = Dual(np.roll(first.re, 1, axis=0), np.roll(first.du, 1, axis=0))
    residual = cos(lines.dual_angle(first, second)) - dot(first, second)
    assert np.abs(residual.re).max() < 1e-13
    assert np.abs(residual.du).max() < 1e-12


def test_distance_is_the_least_distance_of_their_points():
    points, directions, first = float_lines(100)
    for i in range(99):
        gap, basis = points[i + 1] - points[i], np.stack([directions[i], -directions[i + 1]], axis=1)
        steps = np.linalg.lstsq(basis, gap, rcond=None)[0]
        least = np.linalg.norm(gap - basis @ steps)
        assert lines.distance(first[i], first[i + 1]) == pytest.approx(least, abs=1e-11)


def test_common_normal_meets_both_lines_at_right_angles():
    _, _, first = float_lines()
    second = Dual(np.roll(first.re, 1, axis=0), np.roll(first.du, 1, axis=0))
    normal = lines.common_normal(first, second)
    for line in (first, second):
        right = dot(normal, line)
        assert np.abs(right.re).max() < 1e-12
        assert np.all(np.abs(right.du) < 1e-12 * np.maximum(1, norm(normal.du)) * 100)


def test_parallel_lines_have_a_distance_and_no_single_normal():
    z = lines.line_through([0.0, 0, 5], [0.0, 0, 1])
    for direction, theta in (([0.0, 0, 2], 0.0), ([0.0, 0, -1], np.pi)):
        other = lines.line_through([3.0, 4, -7], direction)
        assert lines.dual_angle(z, other) == Dual(theta, 5.0)
        with pytest.raises(ZeroDivisor):
            lines.common_normal(z, other)
    assert lines.distance(z, z) == 0 and lines.angle(z, z) == 0


def test_distance_and_angle_of_lines_in_a_unit_cube():
    """The classical ones: a space diagonal and a skew edge, √2/2; two face diagonals, 60° and 1/√3."""
    diagonal = lines.line_joining([0.0, 0, 0], [1.0, 1, 1])
    edge = lines.line_joining([1.0, 0, 0], [1.0, 1, 0])
    assert lines.distance(diagonal, edge) == pytest.approx(np.sqrt(2) / 2, abs=1e-15)
    assert lines.angle(diagonal, edge) == pytest.approx(np.arccos(1 / np.sqrt(3)), abs=1e-15)
    bottom = lines.line_joining([0.0, 0, 0], [1.0, 1, 0])
    side = lines.line_joining([0.0, 1, 0], [0.0, 0, 1])
    assert np.cos(lines.angle(bottom, side)) == pytest.approx(-0.5, abs=1e-15)
    assert lines.distance(bottom, side) == pytest.approx(1 / np.sqrt(3), abs=1e-15)


@over([FRACTION], cases=10)
def test_nearest_point_is_on_the_line_and_across_it(scalars, rng):
    line, _, direction = exact_line(rng)
    point = scalars.real_vector(rng)
    foot = lines.nearest_point(line, point)
    assert scalars.vanishes(line.du - cross(foot, direction))
    assert scalars.vanishes(dot(point - foot, direction))


def test_bad_input_gets_one_clear_error():
    with pytest.raises(ZeroDivisor, match="no unit vector"):
        lines.line_through([1.0, 2, 3], [0.0, 0, 0])
    with pytest.raises(ZeroDivisor):
        lines.line_joining([1, 2, 3], [1, 2, 3])
    with pytest.raises(ValueError, match=r"expected shape \(..., 3\), got \(2,\)"):
        lines.line_through([1, 2], [0, 1])
    assert not lines.is_line(Dual(np.array([0.0, 0, 1]), np.array([0.0, 0, 1])), 1e-9)
    assert not lines.is_line(Dual(np.array([0.0, 0, 2]), np.zeros(3)))


def test_lists_and_integers_are_numbers_too():
    for kind in (list, np.array):
        line, other = (
            lines.line_joining(kind([1, 2, 3]), kind([0, 2, 0])),
            lines.line_through(kind([0, 0, 1]), kind([0, 1, 2])),
        )
        expected = lines.line_joining(np.array([1.0, 2, 3]), np.array([0.0, 2, 0]))
        np.testing.assert_allclose(np.asarray(line.re, float), expected.re, atol=1e-15)
        assert np.isclose(
            lines.distance(line, other),
            lines.distance(expected, lines.line_through(np.array([0.0, 0, 1]), np.array([0.0, 1, 2]))),
        )
        assert np.isclose(
            float(lines.distance_to_point(line, kind([4, 5, 6]))),
            lines.distance_to_point(expected, np.array([4.0, 5, 6])),
        )


def test_numbers_that_are_not_finite_are_rejected():
    with pytest.raises(ValueError, match="line_through: expected finite numbers"):
        lines.line_through([0, 0, np.nan], [0, 0, 1])
