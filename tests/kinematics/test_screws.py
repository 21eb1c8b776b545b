"""Laws of displacements and their screws, Eqs. (78)–(85), with Drake as the reference."""

from fractions import Fraction
from random import Random

import numpy as np
import pytest
from pydrake.autodiffutils import AutoDiffXd
from pydrake.common.eigen_geometry import AngleAxis
from pydrake.math import RigidTransform, RigidTransform_, RotationMatrix, RotationMatrix_
from pydrake.symbolic import Expression, Variable

from tests.dual_scalars import EXPRESSION, FIELDS, FLOAT, FRACTION, over, quiet_expressions
from workbench.algebra.dual import EPSILON, Dual, ZeroDivisor
from workbench.algebra.dual_tensors import (
    apply,
    cross,
    determinant,
    dot,
    identity,
    norm,
    scale,
    skew,
    tensor,
    transpose,
    unit,
    vector,
)
from workbench.kinematics import screws
from workbench.kinematics.rotations import rotation

pytestmark = quiet_expressions
NUMBER_OF_POSES = 100_000
SMALL_ANGLES = [0.0, 5e-324, 1e-300, 1e-200, 1e-151, *10.0 ** np.arange(-149, -1, 12)]
EDGE_ANGLES = np.array(
    [*SMALL_ANGLES, *10.0 ** np.arange(-18, 0), np.pi / 2, 2 * np.pi / 3, np.pi]
    + [np.pi - 10.0**-k for k in range(1, 17)]
)


def random_displacement(scalars, rng: Random) -> Dual:
    return screws.from_rodrigues_vector(scalars.vector(rng))


@pytest.fixture(scope="module")
def poses() -> tuple[np.ndarray, Dual]:
    """Angles in [0, π] and screws: half random, half edge cases, lengths from 1e-3 to 10."""
    rng = np.random.default_rng(2024)
    n = NUMBER_OF_POSES
    u = rng.normal(size=(n, 3))
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    u[::7] = np.eye(3)[rng.integers(0, 3, len(u[::7]))] * rng.choice([-1.0, 1.0], (len(u[::7]), 1))
    angles = np.where(np.arange(n) % 2, rng.uniform(0, np.pi, n), rng.choice(EDGE_ANGLES, n))
    moments = rng.normal(size=(n, 3)) * 10 ** rng.uniform(-3, 1, (n, 1))
    moments[rng.integers(0, n, n // 50)] = 0
    moments[::11] = moments[::11, :1] * u[::11]
    return angles, Dual(angles[:, None] * u, moments)


def largest_difference(a: Dual, b: Dual) -> float:
    """Of the real parts absolutely, of the dual parts relative to max(1, the largest entry)."""
    axes = tuple(range(1, a.re.ndim))
    length = np.maximum(1, np.abs(b.du).max(axis=axes))
    du = np.abs(a.du - b.du).max(axis=axes) / length
    return float(max(np.abs(a.re - b.re).max(), du.max()))


@over(FIELDS, cases=3)
def test_displacements_are_a_group(scalars, rng):
    R, S, T = (random_displacement(scalars, rng) for _ in range(3))
    assert scalars.vanishes(R @ transpose(R) - identity())
    assert scalars.vanishes(transpose(R) @ R - identity())
    assert scalars.vanishes(determinant(R) - 1)
    assert scalars.vanishes((R @ S) @ T - R @ (S @ T))
    assert scalars.vanishes((R @ S) @ transpose(R @ S) - identity())


@over(FIELDS, cases=3)
def test_structural_invariants_compose_as_rigid_transforms(scalars, rng):
    R1, R2 = (random_displacement(scalars, rng) for _ in range(2))
    (A, a), (B, b) = screws.structural_invariants(R1), screws.structural_invariants(R2)
    assert scalars.vanishes(screws.displacement(A, a) - R1)
    composed = screws.displacement(A @ B, apply(A, b) + a)
    assert scalars.vanishes(R1 @ R2 - composed)


@over(FIELDS, cases=3)
def test_displacement_preserves_scalar_and_cross_products(scalars, rng):
    R, a, b = random_displacement(scalars, rng), scalars.vector(rng), scalars.vector(rng)
    assert scalars.vanishes(dot(apply(R, a), apply(R, b)) - dot(a, b))
    assert scalars.vanishes(apply(R, cross(a, b)) - cross(apply(R, a), apply(R, b)))
    assert scalars.vanishes(R @ skew(a) @ transpose(R) - skew(apply(R, a)))


@over([r for r in FIELDS if r.name != "Expression"], cases=10)
def test_rodrigues_vector_is_a_rational_chart(scalars, rng):
    b = scalars.vector(rng)
    R = screws.from_rodrigues_vector(b)
    assert scalars.vanishes(screws.rodrigues_vector(R) - b)
    assert scalars.vanishes(apply(R, b) - b)


def test_euler_rodrigues_formula_holds_over_the_rationals():
    u = unit(vector([Fraction(1), 2, 2], [Fraction(4), -3, 1]))
    sine, cosine = Dual(Fraction(3, 5), Fraction(8)), Dual(Fraction(4, 5), Fraction(-6))
    R = screws.from_sine_and_cosine(sine, cosine, u)
    assert sine * sine + cosine * cosine == 1
    assert R @ transpose(R) == tensor(identity()) and determinant(R) == 1
    assert apply(R, u) == u
    half_tangent = sine / (1 + cosine)
    assert screws.from_rodrigues_vector(scale(half_tangent, u)) == R


@over([FLOAT, EXPRESSION], cases=3)
def test_exponential_is_equivariant_and_fixes_its_axis(scalars, rng):
    psi, R = scalars.vector(rng), random_displacement(scalars, rng)
    exp_psi = screws.exp(psi)
    assert scalars.vanishes(exp_psi @ transpose(exp_psi) - identity())
    assert scalars.vanishes(apply(exp_psi, psi) - psi)
    assert scalars.vanishes(screws.exp(-psi) - transpose(exp_psi))
    assert scalars.vanishes(screws.exp(2 * psi) - exp_psi @ exp_psi)
    assert scalars.vanishes(R @ exp_psi @ transpose(R) - screws.exp(apply(R, psi)))


@over([FLOAT], cases=20)
def test_exponential_is_its_power_series(scalars, rng):
    psi = scalars.vector(rng)
    term, total = Dual(np.eye(3), 0.0), Dual(np.eye(3), 0.0)
    for k in range(1, 45):
        term = term @ skew(psi) / k
        total = total + term
    assert scalars.vanishes(screws.exp(psi) - total)


@over([FRACTION, EXPRESSION], cases=5)
def test_exponential_of_a_translation_is_exact(scalars, rng):
    psi = EPSILON * scalars.vector(rng)
    R = screws.exp(psi)
    assert scalars.vanishes(R - (identity() + skew(psi)))
    assert scalars.vanishes(screws.log(R) - psi)
    assert screws.kind(R) == "translation"


@over([EXPRESSION], cases=2)
def test_symbolic_logarithm_restores_the_displacement(scalars, rng):
    R = random_displacement(scalars, rng)
    assert scalars.vanishes(screws.from_natural_invariants(*screws.natural_invariants(R)) - R)
    assert scalars.vanishes(screws.exp(screws.log(R)) - R)


def test_exponential_after_logarithm_is_the_identity(poses):
    R = screws.exp(poses[1])
    assert largest_difference(screws.exp(screws.log(R)), R) < 1e-12


def test_logarithm_inverts_the_exponential_below_a_half_turn(poses):
    angles, psi = poses
    chosen = angles < np.pi - 1e-12
    assert chosen.sum() > NUMBER_OF_POSES / 2
    assert largest_difference(screws.log(screws.exp(psi))[chosen], psi[chosen]) < 1e-12


def test_natural_invariants_give_back_the_displacement(poses):
    R = screws.exp(poses[1])
    alpha, u = screws.natural_invariants(R)
    assert largest_difference(screws.from_natural_invariants(alpha, u), R) < 1e-12
    assert np.all((alpha.re >= 0) & (alpha.re <= np.pi))
    assert np.abs(dot(u, u).re - 1).max() < 1e-14
    assert np.all(np.abs(dot(u, u).du) <= 1e-14 * np.maximum(1, norm(u.du)))


def test_natural_and_structural_invariants_are_related(poses):
    R = screws.exp(poses[1])
    alpha, u = screws.natural_invariants(R)
    a, d, u0 = alpha.re[:, None], alpha.du[:, None], u.du
    versine = 2 * np.sin(a / 2) ** 2
    rho = d * u.re + np.sin(a) * u0 + versine * np.cross(u.re, u0)
    expected = screws.structural_invariants(R)[1]
    assert np.all(np.abs(rho - expected) <= 1e-13 * np.maximum(1, norm(expected)[:, None]))


def test_rotations_and_angles_agree_with_drake(poses):
    angles, psi = poses
    R = screws.exp(psi)
    alpha, u = screws.natural_invariants(R)
    directions = psi.re / np.where(angles == 0, 1, norm(psi.re))[:, None]
    for i in range(0, NUMBER_OF_POSES, 5):
        if angles[i] < 1e-150:
            continue
        reference = RotationMatrix(AngleAxis(angles[i], directions[i] / norm(directions[i])))
        assert np.abs(R.re[i] - reference.matrix()).max() < 1e-14
        theirs = reference.ToAngleAxis()
        assert abs(alpha.re[i] - theirs.angle()) < 1e-14
        sign = np.sign(u.re[i] @ theirs.axis()) if np.pi - angles[i] < 1e-12 else 1
        if angles[i] > 1e-3:
            assert np.abs(u.re[i] - sign * theirs.axis()).max() < 1e-12


def test_composition_and_inverse_agree_with_drake(poses):
    R = screws.exp(poses[1])
    product, back = R[:-1] @ R[1:], transpose(R)
    for i in range(0, NUMBER_OF_POSES - 1, 50):
        X, Y = (screws.to_rigid_transform(R[j]) for j in (i, i + 1))
        assert screws.to_rigid_transform(product[i]).IsNearlyEqualTo(X @ Y, 1e-13)
        assert screws.to_rigid_transform(back[i]).IsNearlyEqualTo(X.inverse(), 1e-13)


def test_full_turns_end_where_they_began(poses):
    _, psi = poses
    u = psi.re[1::2] / norm(psi.re[1::2])[:, None]
    shift = dot(u, psi.du[1::2])[:, None] * u
    for turns in (1, -1, 2):
        R = screws.exp(Dual(2 * np.pi * turns * u, psi.du[1::2]))
        assert largest_difference(R, screws.displacement(np.eye(3) + 0 * R.re, shift)) < 1e-12


@pytest.mark.parametrize("turns", [-2, -1, 1, 3])
def test_every_branch_of_the_logarithm_is_a_logarithm(poses, turns):
    angles, psi = poses
    R = screws.exp(psi[(angles > 0.1) | (angles == 0)])
    branch = screws.log(R, turns)
    assert largest_difference(screws.exp(branch), R) < 1e-12
    assert np.abs(norm(branch.re) - np.abs(norm(screws.log(R).re) + 2 * np.pi * turns)).max() < 1e-12


@pytest.mark.parametrize("axis", [*np.eye(3), *-np.eye(3), [0.6, -0.8, 0], [-2 / 3, 1 / 3, 2 / 3]])
def test_half_turn_axis_has_a_positive_first_component(axis):
    u = np.array(axis)
    R = screws.displacement(2 * np.outer(u, u) - np.eye(3), 3 * u + np.cross(u, [1.0, 2.0, 5.0]))
    alpha, found = screws.natural_invariants(R)
    sign = np.sign(u[np.flatnonzero(u)[0]])
    assert alpha.re == pytest.approx(np.pi, abs=1e-15)
    assert np.abs(found.re - sign * u).max() < 1e-15
    assert alpha.du == pytest.approx(3 * sign, abs=1e-14)
    assert largest_difference(screws.exp(screws.log(R))[None], R[None]) < 1e-14


def test_translation_and_identity_are_exact():
    alpha, u = screws.natural_invariants(screws.displacement(np.eye(3), np.array([2.0, -3.0, 6.0])))
    assert alpha == Dual(0.0, 7.0)
    assert u == Dual(np.array([2.0, -3.0, 6.0]) / 7, 0.0)
    alpha, u = screws.natural_invariants(screws.displacement(np.eye(3), np.zeros(3)))
    assert alpha == 0 and u == Dual(np.array([0.0, 0.0, 1.0]), 0.0)
    with pytest.raises(ValueError, match="identity has no axis"):
        screws.mozzi_chasles_axis(Dual(np.eye(3), 0.0))


def test_kinds_of_displacement():
    turn = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]], dtype=object)
    examples = {
        "identity": screws.displacement(identity(), np.array([0, 0, 0])),
        "translation": screws.displacement(identity(), np.array([0, 0, 1])),
        "rotation": screws.displacement(turn, np.array([4, 5, 0])),
        "roto-translation": screws.displacement(turn, np.array([4, 5, 1])),
    }
    for expected, R in examples.items():
        assert screws.kind(R) == expected
        noisy = Dual(R.re.astype(float) + 1e-14, R.du.astype(float) - 1e-14)
        assert screws.kind(noisy, tolerance=1e-12) == expected
    full_turn = screws.exp(Dual(np.array([0, 0, 2 * np.pi]), np.array([0.0, 0, 1])))
    assert screws.kind(full_turn, tolerance=1e-14) == "translation"


def test_planar_displacement_of_modern_robotics_example_3_26():
    """Lynch and Park, Modern Robotics (2017), Example 3.26: S = (0, 0, 1, 3.37, −3.37, 0), 30°."""

    def planar(degrees: float, x: float, y: float) -> Dual:
        angle = np.deg2rad(degrees)
        R = RotationMatrix.MakeZRotation(angle)
        return screws.from_rigid_transform(RigidTransform(R, [x, y, 0]))

    moved = planar(60, 2, 1) @ transpose(planar(30, 1, 2))
    alpha, u = screws.natural_invariants(moved)
    assert alpha.re == pytest.approx(np.pi / 6, abs=1e-14)
    assert alpha.du == pytest.approx(0, abs=1e-14)
    assert np.abs(u.re - [0, 0, 1]).max() < 1e-14
    assert np.abs(u.du - [3.37, -3.37, 0]).max() < 0.005


@pytest.mark.parametrize("scalar", [float, AutoDiffXd, Expression])
def test_rigid_transforms_of_all_drake_scalars_round_trip(scalar):
    angle = {float: 0.4, AutoDiffXd: AutoDiffXd(0.4, [1.0]), Expression: Variable("a")}[scalar]
    R = RotationMatrix_[scalar].MakeXRotation(angle)
    X = RigidTransform_[scalar](R, [angle, 2.0, 3.0])
    back = screws.to_rigid_transform(screws.from_rigid_transform(X))
    assert type(back) is type(X)
    difference = back.GetAsMatrix4() - X.GetAsMatrix4()
    if scalar is AutoDiffXd:
        assert all(abs(entry.value()) < 1e-15 for entry in difference.flat)
        assert all(np.abs(entry.derivatives()).sum() < 1e-15 for entry in difference.flat)
    elif scalar is Expression:
        values = [(e + Expression(0)).Evaluate({angle: 0.7}) for e in difference.flat]
        assert np.abs(values).max() < 1e-15
    else:
        assert np.abs(difference).max() < 1e-15


@pytest.mark.parametrize("expected", ["rotation", "roto-translation", "translation", "identity"])
def test_floats_are_of_the_kind_they_were_made_of(expected):
    """Axes up to a kilometre away, angles down to 1e-6 rad, shifts down to a micrometre."""
    rng = np.random.default_rng(0)
    for _ in range(300):
        axis = rng.normal(size=3)
        axis /= np.linalg.norm(axis)
        p = rng.normal(size=3) * 10 ** rng.uniform(-3, 3)
        R = (
            np.eye(3)
            if expected in ("translation", "identity")
            else rotation(10 ** rng.uniform(-6, 0.49), axis)
        )
        shift = {"rotation": 0.0, "identity": 0.0}.get(expected, 10 ** rng.uniform(-6, 1))
        assert screws.kind(screws.displacement(R, p - R @ p + shift * axis)) == expected


def test_lists_and_integers_are_numbers_too():
    R, rho = [[0, -1, 0], [1, 0, 0], [0, 0, 1]], [1, 2, 3]
    exact, floats = screws.displacement(R, rho), screws.displacement(np.array(R, float), np.array(rho, float))
    for function in (screws.log, screws.mozzi_chasles_axis, screws.rodrigues_vector):
        for given in (exact, Dual(np.array(R), exact.du), Dual(R, exact.du.tolist())):
            ours, expected = function(given), function(floats)
            for part in ("re", "du"):
                close = np.asarray(getattr(ours, part), float)
                np.testing.assert_allclose(close, getattr(expected, part), atol=1e-14)
    assert screws.kind(exact) == screws.kind(floats) == "roto-translation"
    np.testing.assert_allclose(screws.to_rigid_transform(exact).translation(), rho)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_numbers_that_are_not_finite_are_rejected(bad):
    psi = Dual(np.array([0.1, 0.2, bad]), np.zeros(3))
    with pytest.raises(ValueError, match="exp: expected finite numbers"):
        screws.exp(psi)
    with pytest.raises(ValueError, match="displacement: expected finite numbers"):
        screws.displacement(np.eye(3), [0, bad, 0])


def test_bad_input_gets_one_clear_error():
    off = Dual(np.eye(3) * 1.01, np.zeros((3, 3)))
    for function in (screws.log, screws.natural_invariants, screws.to_rigid_transform):
        with pytest.raises(ValueError, match=r"expected an orthogonal dual tensor.*off by 0\.02"):
            function(off)
    with pytest.raises(ValueError, match="expected an orthogonal dual tensor"):
        screws.structural_invariants(Dual(np.eye(3), np.eye(3)))
    with pytest.raises(ValueError, match=r"shape \(3, 3\), got \(2, 3, 3\)"):
        screws.to_rigid_transform(Dual(np.zeros((2, 3, 3)), 0.0))
    with pytest.raises(TypeError, match="float, AutoDiffXd or Expression, got Fraction"):
        screws.to_rigid_transform(tensor(identity() * Fraction(1)))
    with pytest.raises(TypeError, match="a Dual of arrays"):
        screws.exp(np.ones(3))
    with pytest.raises(ZeroDivisor):
        screws.rodrigues_vector(tensor(np.diag([1.0, -1.0, -1.0])))
