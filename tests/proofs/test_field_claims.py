"""Sections 3 and 4: counterexamples and polynomials by other means than the proofs."""

from __future__ import annotations

import numpy as np
import pytest

from workbench.algebra.dual_tensors import skew
from workbench.kinematics.fields import acceleration_tensors, homogeneous_tensors, invariant_vectors
from workbench.kinematics.operators import P


def test_the_second_polynomial_of_theorem_2():
    omega, v = np.array([[0.0, 0.0, 1.0]]), np.array([[1.0, 0.0, 0.0]])
    twist = homogeneous_tensors(acceleration_tensors(omega), invariant_vectors(omega, v))[1]
    first = np.diag([1.0, 1.0, 1.0, 0.0])
    second = first + np.outer(np.eye(4)[0], np.eye(4)[3])
    for unit in (first, second):
        np.testing.assert_array_equal(unit @ twist, twist)


def test_the_second_polynomial_of_theorem_3():
    """I and I + (ω̇·v̇) c ⊗ ω − (ω·v) (c ⊗ ω̇) D make the same of one motion."""
    omega = v = np.eye(3)[:2]
    A = np.eye(3) + (omega[1] @ v[1]) * np.outer(np.eye(3)[0], omega[0])
    B = -(omega[0] @ v[0]) * np.outer(np.eye(3)[0], omega[1])
    assert not np.array_equal(A, np.eye(3)) and B.any()
    np.testing.assert_array_equal(A @ v[0] + B @ v[1], v[0])
    np.testing.assert_array_equal(A @ skew(omega[0]) + B @ skew(omega[1]), skew(omega[0]))


def test_the_index_of_37_in_the_library():
    """P₁ = D + Ψ₁, which P₀ = I would make, gives the acceleration of a steady rotation for its velocity."""
    omega = np.zeros((2, 3))
    omega[0] = (0.0, 0.0, 1.0)
    psi = homogeneous_tensors(acceleration_tensors(omega), invariant_vectors(omega, 0 * omega))
    np.testing.assert_array_equal(psi[1] @ psi[1], psi[2])
    assert not np.array_equal(psi[1], psi[2])


@pytest.mark.parametrize("n", range(1, 8))
def test_the_polynomials_of_39_give_the_field_of_random_twists(n):
    omega, v = np.random.default_rng(n).normal(size=(2, 8, 3))
    np.testing.assert_allclose(P(n).apply(omega, v), invariant_vectors(omega, v)[n], rtol=1e-9)
    np.testing.assert_allclose(P(n).apply(omega, skew(omega)), acceleration_tensors(omega)[n], rtol=1e-9)
