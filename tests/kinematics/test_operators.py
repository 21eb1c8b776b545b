"""The ring of operator polynomials, the laws of Pₙ, and its printed forms."""

import re
from fractions import Fraction
from math import comb

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench.algebra.dual_tensors import skew
from workbench.kinematics.fields import acceleration_tensors, invariant_vectors
from workbench.kinematics.operators import D, I, OperatorPolynomial, P, TensorPolynomial

OMEGA = TensorPolynomial.letter()
words = st.lists(st.integers(0, 3), max_size=3).map(tuple)
tensor_polynomials = st.dictionaries(words, st.integers(-5, 5), max_size=4).map(TensorPolynomial)
operators = st.lists(tensor_polynomials, max_size=3).map(tuple).map(OperatorPolynomial)


def rationals(seed: int, *shape: int) -> np.ndarray:
    rng = np.random.default_rng(seed)
    numbers = rng.integers(-9, 10, size=shape), rng.integers(1, 6, size=shape)
    return np.vectorize(lambda p, q: Fraction(int(p), int(q)), otypes=[object])(*numbers)


@settings(max_examples=60)
@given(tensor_polynomials, tensor_polynomials, tensor_polynomials)
def test_tensor_polynomials_are_a_ring_with_a_derivation(x, y, z):
    assert x + y == y + x and (x + y) + z == x + (y + z)
    assert (x * y) * z == x * (y * z)
    assert x * (y + z) == x * y + x * z and (x + y) * z == x * z + y * z
    assert x - x == TensorPolynomial() and x * TensorPolynomial.integer(1) == x
    assert (x * y).derivative() == x.derivative() * y + x * y.derivative()
    assert x.derivative(3) == x.derivative().derivative().derivative()
    assert 2 * x == x + x and hash(x + y) == hash(y + x)


def test_letters_do_not_commute():
    assert OMEGA * OMEGA.derivative() != OMEGA.derivative() * OMEGA


@settings(max_examples=60)
@given(operators, operators, operators, tensor_polynomials)
def test_operators_are_a_ring_and_act(p, q, r, x):
    assert (p * q) * r == p * (q * r)
    assert p * (q + r) == p * q + p * r and (p + q) * r == p * r + q * r
    assert p * I == p == I * p and p - p == OperatorPolynomial(())
    assert (p * q).of(x) == p.of(q.of(x)) and (p + q).of(x) == p.of(x) + q.of(x)


def test_D_passes_a_tensor():
    """D A = Ȧ + A D."""
    A = OperatorPolynomial((OMEGA,))
    assert (D * A).coefficients == (OMEGA.derivative(), OMEGA)
    assert (A * D).coefficients == (TensorPolynomial(), OMEGA)


@pytest.mark.parametrize("n", range(1, 10))
def test_leibniz_form(n):
    """Pₙ₊₁ = Dⁿ + Σₖ C(n,k) ω̃⁽ⁿ⁻ᵏ⁾ Pₖ, k = 1..n: the same Pₙ without Eq. (39)."""
    power = I
    for _ in range(n):
        power = D * power
    expected = power
    for k in range(1, n + 1):
        expected = expected + comb(n, k) * OperatorPolynomial((OMEGA.derivative(n - k),)) * P(k)
    assert P(n + 1) == expected
    assert P(n + 1).degree == n and P(n + 1).coefficients[n] == TensorPolynomial.integer(1)


@pytest.mark.parametrize("n", range(1, 9))
def test_field_of_the_operator(n):
    """Φₙ = Pₙ ω̃ fulfils Eq. (20) as words: Φₙ₊₁ = Φ̇ₙ + Φₙ ω̃."""
    Phi, following = P(n).of(OMEGA), P(n + 1).of(OMEGA)
    assert following == Phi.derivative() + Phi * OMEGA


@pytest.mark.parametrize("n", range(1, 8))
def test_numbers_agree_with_the_field_library(n):
    """aₙ = Pₙ v and Φₙ = Pₙ ω̃, Eq. (38), exactly, for a batch of motions."""
    omega, v = rationals(n, 2, n, 4, 3)
    assert (P(n).apply(omega, v) == invariant_vectors(omega, v)[n]).all()
    assert (P(n).apply(omega, skew(omega)) == acceleration_tensors(omega)[n]).all()
    rounded = P(n).apply(omega.astype(float), v.astype(float))
    np.testing.assert_allclose(rounded, invariant_vectors(omega, v)[n].astype(float), rtol=1e-9)


def test_printed_as_in_the_literature():
    """The three lines of Eq. (40)."""
    w = r"\tilde{\omega}"
    printed = {
        1: r"\mathbf{I}",
        2: r"\mathbf{D} + \tilde{\omega}",
        3: r"\mathbf{D}^2 + \tilde{\omega}\mathbf{D} + 2\dot{\tilde{\omega}} + \tilde{\omega}^2",
        4: r"\mathbf{D}^3 + \tilde{\omega}\mathbf{D}^2 + (3\dot{\tilde{\omega}} + \tilde{\omega}^2)"
        r"\mathbf{D} + 3\ddot{\tilde{\omega}} + 3\dot{\tilde{\omega}}\tilde{\omega} + "
        r"2\tilde{\omega}\dot{\tilde{\omega}} + \tilde{\omega}^3",
    }
    assert {n: P(n).to_latex(symbol=w) for n in printed} == printed


def test_printing_signs_and_powers():
    assert (3 * D * D - I).to_latex() == r"3\mathbf{D}^2 - \mathbf{I}"
    assert (-D).to_latex() == r"-\mathbf{D}"
    assert OperatorPolynomial(()).to_latex() == "0"
    fifth = TensorPolynomial.letter(5) * TensorPolynomial.letter(5)
    assert fifth.to_latex(symbol="w") == r"\left(w^{(5)}\right)^2"
    assert (D * P(11)).to_latex().startswith(r"\mathbf{D}^{11}")
    assert P(2)._repr_latex_() == f"${P(2)}$"
    assert not re.search(r"\b1\\", P(6).to_latex())


@pytest.mark.parametrize("n", [0, -1, 1.5, "2"])
def test_order_must_be_positive(n):
    with pytest.raises(ValueError, match="integer >= 1"):
        P(n)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: P(4).apply(np.ones((2, 3)), np.ones((4, 3))), "omega: expected at least 3"),
        (lambda: P(4).apply(np.ones((3, 3)), np.ones((3, 3))), "x: expected at least 4"),
        (lambda: P(2).apply(np.ones((3, 4)), np.ones((3, 3))), "omega: expected shape"),
        (lambda: TensorPolynomial.letter(-1), ">= 0"),
    ],
)
def test_bad_input(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_operators_do_not_mix_with_other_types():
    with pytest.raises(TypeError):
        P(2) + 1
    with pytest.raises(TypeError):
        OMEGA * 0.5
