"""The theorems of Sections 5 and 6: their counterexamples computed again by the library, which shares nothing with
the proofs."""

from fractions import Fraction

import numpy as np
import pytest

from workbench.algebra.dual import Du, Dual, ZeroDivisor
from workbench.algebra.dual_tensors import cross, is_orthogonal, norm, skew, transpose, vector
from workbench.kinematics.reduced import (
    locus_of_minimum,
    minimum_of_reduced_acceleration,
    reduced_acceleration,
)
from workbench.kinematics.screws import displacement, exp, kind, log

E1, E2, E3 = np.eye(3)


def exact(*entries):
    return np.array([Fraction(entry) for entry in entries], dtype=object)


def test_the_printed_structure_theorem_allows_every_translation():
    third = Fraction(1, 3)
    R = np.array([[-1, 2, 2], [2, -1, 2], [2, 2, -1]], dtype=object) * third
    R_dual = displacement(R, exact(1, 2, 3))
    for r in (exact(0, 0, 0), exact(1, 0, -2), exact("1/2", 5, 7)):
        factor = Dual(np.eye(3, dtype=int).astype(object), -skew(r)) @ R_dual
        assert is_orthogonal(factor)
        assert Dual(np.eye(3, dtype=int).astype(object), skew(r)) @ factor == R_dual


def test_the_commutator_of_skew_tensors_is_skew():
    b, c = vector(exact(1, 2, 3), exact(0, 1, 4)), vector(exact(-2, 0, 5), exact(1, 1, 1))
    product = skew(b) @ skew(c)
    assert transpose(product) != -product
    assert product - skew(c) @ skew(b) == skew(cross(b, c))


def test_several_screws_have_one_displacement():
    line = Dual(E3, cross(np.array([1.0, 2.0, 0.0]), E3))
    half_turn = exp(line * np.pi)
    back = exp(line * -np.pi)
    assert np.allclose(half_turn.re, back.re, atol=1e-14) and np.allclose(half_turn.du, back.du, atol=1e-13)
    full_turn = exp(line * (2 * np.pi))
    assert np.allclose(full_turn.re, np.eye(3), atol=1e-14) and np.allclose(full_turn.du, 0, atol=1e-13)
    principal = log(full_turn)
    assert np.abs(principal.re).max() < 1e-13 and np.abs(principal.du).max() < 1e-12


@pytest.mark.parametrize(
    ("angle", "shift", "expected"),
    [
        (1.0, 0.5, "roto-translation"),
        (1.0, 0.0, "rotation"),
        (2 * np.pi, 0.5, "translation"),
        (2 * np.pi, 0.0, "identity"),
    ],
)
def test_a_full_turn_changes_the_kind_of_a_screw(angle, shift, expected):
    line = Dual(E3, cross(np.array([1.0, 2.0, 0.0]), E3))
    psi = Dual(angle * line.re, angle * line.du + shift * line.re)
    assert (psi.re @ psi.du != 0) == (shift != 0)
    assert kind(exp(psi), tolerance=1e-12) == expected


def test_magnitudes_of_the_three_kinds():
    roto, rotation, translation, identity = (
        norm(Dual(np.asarray(a, dtype=float), np.asarray(b, dtype=float)))
        for a, b in ((E1, E1 + E2), (E1, E2), (0 * E1, E2), (0 * E1, 0 * E1))
    )
    assert roto.re != 0 and roto.du != 0  # neither real nor in ε ℝ, against the first item
    assert rotation.re != 0 and rotation.du == 0
    assert translation.re == 0 and translation.du != 0
    assert identity.re == 0 and identity.du == 0  # real and in ε ℝ


def test_a_rolling_wheel_has_a_reduced_acceleration_everywhere():
    omega, centre_velocity = E3, E1
    for place in (np.zeros(3), np.array([0.0, -1.0, 0.0]), np.array([3.0, 2.0, 0.0])):
        velocity = centre_velocity + np.cross(omega, place)
        acceleration = np.cross(omega, np.cross(omega, place))
        A = reduced_acceleration([velocity, acceleration], [omega])
        assert np.allclose(A, -np.cross(omega, centre_velocity))
    assert minimum_of_reduced_acceleration(Dual(0 * E3, A)) == 1.0
    with pytest.raises(ZeroDivisor):
        locus_of_minimum(Dual(0 * E3, A))


def test_the_least_jounce_is_that_of_the_third_derivative():
    third, second = Dual(E3, E3), Dual(0 * E3, 0 * E3)
    assert minimum_of_reduced_acceleration(third) == 1.0 != minimum_of_reduced_acceleration(second)
    assert abs(Du(norm(third))) == 1.0


@pytest.mark.parametrize("right", [True, False])
def test_the_readings_of_108_on_a_motion_of_drake(right):
    """A^[2] = ρ⃛ − ω × ρ̈ − 2 ω̇ × ρ̇ of Drake's derivatives; with the factors exchanged it is no v̈ + ω̈ × ρ."""
    from workbench.drake.motions import reference_motions

    motion = next(iter(reference_motions()))
    time = motion.samples[0]
    rho, omega = motion.jet("p_WP", 3, time), motion.jet("w_WB", 2, time)
    v = motion.jet("v_WB0", 2, time)
    factors = (1, 2) if right else (2, 1)
    A = rho[3] - factors[0] * np.cross(omega[0], rho[2]) - factors[1] * np.cross(omega[1], rho[1])
    assert np.allclose(A, v[2] + np.cross(omega[2], rho[0]), rtol=1e-9) == right
