"""Laws of reduced accelerations, Eqs. (89)–(103), on motions made by Drake and by recurrences."""

import math
from random import Random

import numpy as np
import pytest
from pydrake.math import RigidTransform_, RollPitchYaw_, RotationMatrix_
from pydrake.symbolic import Expression, Variable, cos, sin

from tests.dual_scalars import FIELDS, RINGS, over, quiet_expressions
from workbench.algebra.dual import EPSILON, Du, Dual, ZeroDivisor
from workbench.algebra.dual_tensors import cross, dot, norm, vector
from workbench.kinematics import lines, reduced, screws

pytestmark = quiet_expressions
ORDERS = range(4)


def random_state(scalars, rng: Random, order: int) -> list[Dual]:
    """ω̲ and its derivatives up to an order at one instant: any values are possible."""
    return [scalars.vector(rng) for _ in range(order + 1)]


def point_derivatives(twists: list[Dual], rho: np.ndarray) -> list[np.ndarray]:
    """[ρ̇, …, ρ⁽ⁿ⁺¹⁾] of the body point at ρ: Leibniz' rule on ρ̇ = v + ω × ρ."""
    derivatives = [rho]
    for n, twist in enumerate(twists):
        value = twist.du
        for k in range(n + 1):
            value = value + math.comb(n, k) * cross(twists[k].re, derivatives[n - k])
        derivatives.append(value)
    return derivatives[1:]


@over(RINGS, cases=3)
@pytest.mark.parametrize("order", ORDERS)
def test_invariant_is_the_same_at_every_point(scalars, rng, order):
    twists = random_state(scalars, rng, order)
    omegas = [twist.re for twist in twists]
    for _ in range(2):
        rho = scalars.real_vector(rng)
        at_point = reduced.dual_reduced_acceleration(point_derivatives(twists, rho), omegas)
        assert scalars.vanishes(reduced.invariant(at_point, rho) - twists[order])
        assert scalars.vanishes(reduced.field(twists[order], rho) - at_point)


@over(RINGS, cases=3)
def test_general_order_contains_the_acceleration_jerk_and_jounce(scalars, rng):
    omega, d_omega, dd_omega = (scalars.real_vector(rng) for _ in range(3))
    v, a, j, h = (scalars.real_vector(rng) for _ in range(4))
    omegas = [omega, d_omega, dd_omega]
    printed = [
        v,
        a - cross(omega, v),
        j - cross(omega, a) - 2 * cross(d_omega, v),
        h - cross(omega, j) - 3 * cross(d_omega, a) - 3 * cross(dd_omega, v),
    ]
    for n, expected in enumerate(printed):
        ours = reduced.reduced_acceleration([v, a, j, h][: n + 1], omegas[:n])
        assert scalars.vanishes(ours - expected)


@over(RINGS, cases=3)
def test_transport_between_points_is_a_groupoid(scalars, rng):
    omega_n = scalars.vector(rng)
    P, Q, S = (scalars.real_vector(rng) for _ in range(3))
    at = {name: reduced.field(omega_n, point) for name, point in (("P", P), ("Q", Q), ("S", S))}
    assert scalars.vanishes(reduced.transport(at["Q"], Q - P) - at["P"])
    through_S = reduced.transport(reduced.transport(at["Q"], Q - S), S - P)
    assert scalars.vanishes(through_S - at["P"])


@over([s for s in FIELDS if s.name != "Expression"], cases=3)
def test_field_is_equivariant_under_displacements(scalars, rng):
    omega_n, rho = scalars.vector(rng), scalars.real_vector(rng)
    displacement = screws.from_rodrigues_vector(scalars.vector(rng))
    R, shift = screws.structural_invariants(displacement)
    moved_screw = Dual(R @ omega_n.re, R @ omega_n.du + cross(shift, R @ omega_n.re))
    moved = reduced.field(moved_screw, R @ rho + shift)
    still = reduced.field(omega_n, rho)
    assert scalars.vanishes(moved - Dual(R @ still.re, R @ still.du))


def drake_motion(t: Variable) -> tuple[np.ndarray, np.ndarray]:
    """R_WB(t) and p_WBo_W(t) of a motion with no special feature."""
    angles = [sin(t) + 0.3 * t, 0.5 * cos(2 * t), t * t / 3]
    R = RotationMatrix_[Expression](RollPitchYaw_[Expression](*angles)).matrix()
    return R, np.array([cos(t), t * t - 0.2 * t, sin(2 * t)])


def time_derivatives(entries: np.ndarray, t: Variable, at: float, count: int) -> list[np.ndarray]:
    def differentiate(e):
        return (e + Expression(0)).Differentiate(t)

    def evaluate(e):
        return (e + Expression(0)).Evaluate({t: at})

    values = []
    for _ in range(count + 1):
        values.append(np.vectorize(evaluate, otypes=[float])(entries))
        entries = np.vectorize(differentiate, otypes=[object])(entries)
    return values


@pytest.mark.parametrize("order", [0, 1, 2])
def test_reduced_accelerations_of_points_of_a_drake_motion(order):
    t, at = Variable("t"), 0.4
    R, p = drake_motion(t)
    X = RigidTransform_[Expression](RotationMatrix_[Expression](R), p)
    dual_R = screws.from_rigid_transform(X)
    re, du = (time_derivatives(part, t, at, order + 1) for part in (dual_R.re, dual_R.du))
    duals = [Dual(*parts) for parts in zip(re, du, strict=True)]
    twists = []
    for n in range(order + 1):  # Ṙ̲ = ω̲̃ R̲, so ω̲⁽ⁿ⁾ = vect Σ C(n, k) R̲⁽ᵏ⁺¹⁾ (R̲ᵀ)⁽ⁿ⁻ᵏ⁾
        terms = [
            math.comb(n, k) * reduced.dual_angular_velocity(duals[n - k], duals[k + 1]) for k in range(n + 1)
        ]
        twists.append(sum(terms[1:], terms[0]))
    rng = np.random.default_rng(8)
    for body_point in rng.normal(size=(5, 3)):
        motion = time_derivatives(p + R @ body_point, t, at, order + 1)
        omegas = [twist.re for twist in twists]
        at_point = reduced.dual_reduced_acceleration(motion[1:], omegas)
        assert np.abs((reduced.invariant(at_point, motion[0]) - twists[order]).du).max() < 1e-9
        assert np.abs(reduced.twist(motion[0], motion[1], omegas[0]).du - twists[0].du).max() < 1e-10


@over([s for s in FIELDS if s.name in ("Fraction", "fmpq")], cases=10)
def test_minimum_is_attained_on_its_locus_and_nowhere_undercut(scalars, rng):
    omega, moment = vector([2, -3, 6]), scalars.real_vector(rng)
    omega_n = Dual(omega.re * scalars.number(rng), moment)
    if np.all(omega_n.re == 0):
        omega_n = Dual(omega.re, moment)
    locus, least = (
        reduced.locus_of_minimum(omega_n),
        reduced.minimum_of_reduced_acceleration(omega_n),
    )
    assert lines.is_line(locus)
    assert least >= 0 and least == reduced.minimum_of_reduced_acceleration(Dual(omega_n.re, -moment))
    on_locus = lines.nearest_point_to_origin(locus) + scalars.number(rng) * locus.re
    attained = reduced.field(omega_n, on_locus).du
    assert dot(attained, attained) == least * least
    off_locus = scalars.real_vector(rng)
    elsewhere = reduced.field(omega_n, off_locus).du
    excess = dot(elsewhere, elsewhere) - least * least
    distance_squared = dot(*(2 * [locus.du - cross(off_locus, locus.re)]))
    assert excess == dot(omega_n.re, omega_n.re) * distance_squared


def test_minimum_of_a_uniform_field_is_its_length_everywhere():
    omega_n = EPSILON * vector([2.0, -3.0, 6.0])
    assert reduced.minimum_of_reduced_acceleration(omega_n) == 7
    assert norm(reduced.field(omega_n, np.array([5.0, 1, 1])).du) == 7
    with pytest.raises(ZeroDivisor, match="no unit vector"):
        reduced.locus_of_minimum(omega_n)


def test_plane_motion_has_a_pole_unless_the_field_is_uniform():
    pole_order_1 = Dual(np.array([0.0, 0, 3]), np.array([6.0, 9.0, 0]))
    assert reduced.minimum_of_reduced_acceleration(pole_order_1) == 0
    pole = lines.nearest_point_to_origin(reduced.locus_of_minimum(pole_order_1))
    assert np.abs(Du(reduced.field(pole_order_1, pole))).max() < 1e-15
    uniform = Dual(np.zeros(3), np.array([6.0, 8.0, 0]))
    assert reduced.minimum_of_reduced_acceleration(uniform) == 10


def test_bad_input_gets_one_clear_error():
    v = np.zeros(3)
    with pytest.raises(ValueError, match="got 3 and 1"):
        reduced.reduced_acceleration([v, v, v], [v])
    with pytest.raises(ValueError, match="got 0 and 1"):
        reduced.reduced_acceleration([], [v])
    with pytest.raises(ValueError, match="up to order 1"):
        reduced.dual_reduced_acceleration([v, v], [v])
