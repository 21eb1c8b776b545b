"""Sections 3 and 4: the arguments for all n, what they notice, and their counterexamples by other means."""

from __future__ import annotations

import numpy as np
import pytest

from proofs.theorems import polynomials
from workbench.algebra.dual_tensors import skew
from workbench.judge.theorems.formula_steps import Letters
from workbench.judge.verdict import Outcome
from workbench.kinematics.fields import acceleration_tensors, homogeneous_tensors, invariant_vectors
from workbench.kinematics.operators import P

THEOREMS = {name: theorem for name, theorem in polynomials.THEOREMS.items() if callable(theorem)}


@pytest.mark.parametrize("name", THEOREMS)
def test_outcomes(name):
    verdict = THEOREMS[name]()
    assert verdict.outcome == Outcome.PROVED
    assert verdict.evidence


def _count_steps(theorem, monkeypatch) -> int:
    made = []
    step = Letters.step
    monkeypatch.setattr(Letters, "step", lambda self, *a, **k: made.append(a[0]) or step(self, *a, **k))
    theorem()
    monkeypatch.undo()
    return len(made)


@pytest.mark.parametrize("name", THEOREMS)
def test_a_false_formula_in_any_step_leaves_the_theorem_open(name, monkeypatch):
    """The control of each step in turn is put among the formulas that the step says."""
    step = Letters.step
    for wrong in range(_count_steps(THEOREMS[name], monkeypatch)):
        made = []

        def damaged(self, shown, *formulas, but_not, orders=None, wrong=wrong, made=made):
            made.append(shown)
            said = (*formulas, but_not) if len(made) == wrong + 1 else formulas
            return step(self, shown, *said, but_not=but_not, orders=orders)

        monkeypatch.setattr(Letters, "step", damaged)
        verdict = THEOREMS[name]()
        assert verdict.outcome == Outcome.UNCHECKED, made[wrong]
        assert made[wrong] in verdict.reason


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
