"""Laws of the ring of dual numbers, Eq. (71), over every kind of scalar."""

import pickle
from fractions import Fraction
from random import Random

import flint
import numpy as np
import pytest
from flint.utils.flint_exceptions import DomainError

from tests.dual_scalars import EXPRESSION, FIELDS, FLOAT, POLYNOMIAL_RING, RINGS, over, quiet_expressions
from workbench.algebra.dual import EPSILON, Du, Dual, Re, ZeroDivisor, as_array

pytestmark = quiet_expressions


@over(RINGS, cases=8)
def test_addition_is_an_abelian_group(scalars, rng):
    a, b, c = (scalars.dual(rng) for _ in range(3))
    assert scalars.vanishes((a + b) + c - (a + (b + c)))
    assert scalars.vanishes(a + b - (b + a))
    assert scalars.vanishes(a + (-a))
    assert scalars.vanishes((a + 0) - a)
    assert scalars.vanishes((a - b) + (b - a))


@over(RINGS, cases=8)
def test_multiplication_is_a_commutative_monoid(scalars, rng):
    a, b, c = (scalars.dual(rng) for _ in range(3))
    assert scalars.vanishes((a * b) * c - a * (b * c))
    assert scalars.vanishes(a * b - b * a)
    assert scalars.vanishes(1 * a - a)


@over(RINGS, cases=8)
def test_multiplication_distributes_over_addition(scalars, rng):
    a, b, c = (scalars.dual(rng) for _ in range(3))
    assert scalars.vanishes(a * (b + c) - (a * b + a * c))
    assert scalars.vanishes((a - b) * c - (a * c - b * c))


@over(RINGS, cases=8)
def test_product_is_that_of_polynomials_truncated_in_epsilon(scalars, rng):
    p, q, r, s = (scalars.number(rng) for _ in range(4))
    product = (p + EPSILON * q) * (r + s * EPSILON)
    assert scalars.vanishes(Re(product) - p * r)
    assert scalars.vanishes(Du(product) - (p * s + q * r))


@over(RINGS, cases=8)
def test_dual_parts_are_zero_divisors_without_an_inverse(scalars, rng):
    a, b = (EPSILON * scalars.dual(rng) for _ in range(2))
    assert a * b == 0
    assert a**2 == 0
    with pytest.raises(ZeroDivisor, match="real part is zero"):
        scalars.dual(rng) / a
    with pytest.raises(ZeroDivisor):
        1 / a
    with pytest.raises(ZeroDivisionError):
        a**-1


@over(FIELDS, cases=8)
def test_division_undoes_multiplication(scalars, rng):
    a, b = scalars.dual(rng), scalars.dual(rng) + 25
    assert scalars.vanishes(a / b * b - a)
    assert scalars.vanishes(b * (1 / b) - 1)
    assert scalars.vanishes(a / 5 * 5 - a)


def test_polynomial_division_is_exact_if_the_quotient_exists():
    x, y, *_ = POLYNOMIAL_RING.gens()
    a, b = Dual(x + y, x * y), Dual(x - y, y * y)
    assert a * b / b == a
    with pytest.raises(DomainError, match="not exact"):
        a / b


@over(RINGS, cases=4)
@pytest.mark.parametrize("n", range(5))
def test_powers_are_repeated_products(scalars, rng, n):
    a = scalars.dual(rng)
    product = a**0
    for _ in range(n):
        product = product * a
    assert scalars.vanishes(a**n - product)
    assert scalars.vanishes(a**n * a**2 - a ** (n + 2))


@over(FIELDS, cases=4)
def test_negative_powers_are_inverses(scalars, rng):
    a = scalars.dual(rng) + 25
    assert scalars.vanishes(a**-3 * a**3 - 1)


@over(RINGS, cases=4)
def test_a_plain_scalar_is_a_dual_number_without_dual_part(scalars, rng):
    a, c = scalars.dual(rng), scalars.number(rng)
    for scalar in (c, 3, Fraction(1, 3)):
        lifted = Dual(scalar)
        for mixed, pure in (
            (a + scalar, a + lifted),
            (scalar + a, lifted + a),
            (a - scalar, a - lifted),
            (scalar - a, lifted - a),
            (a * scalar, a * lifted),
            (scalar * a, lifted * a),
        ):
            assert scalars.vanishes(mixed - pure)


def test_dual_part_at_a_plus_epsilon_is_the_derivative():
    rng = Random(1)
    x = POLYNOMIAL_RING.gens()[0]
    for _ in range(20):
        coefficients = [Fraction(rng.randint(-9, 9), rng.randint(1, 9)) for _ in range(6)]
        value = sum((c * Dual(x, 1) ** k for k, c in enumerate(coefficients)), Dual(0 * x))
        exact = [flint.fmpq(c.numerator, c.denominator) for c in coefficients]
        polynomial = sum((c * x**k for k, c in enumerate(exact)), 0 * x)
        assert value == Dual(polynomial, polynomial.derivative(0))


def test_integers_divide_exactly():
    assert Dual(1, 2) / 3 == Dual(Fraction(1, 3), Fraction(2, 3))
    assert isinstance((Dual(1, 2) / 3).re, Fraction)
    assert Dual(np.array([2**62]), np.array([1])) * 4 == Dual(np.array([2**64], dtype=object), 4)


def test_equality_compares_both_parts_and_every_entry():
    assert Dual(2, 0) == 2 and hash(Dual(2, 0)) == hash(2)
    assert Dual(2, 1) != 2 and Dual(2, 1) != Dual(1, 1) and Dual(2, 1) != Dual(2, 2)
    assert Dual(np.array([1.0, 2.0]), 3.0) != Dual(np.array([1.0, 2.0]), np.array([3.0, 4.0]))
    assert Dual(1) != "1" and Dual(1) != None  # noqa: E711 (the operator is what is tested)
    x = EXPRESSION.number(Random(0))
    assert Dual((x + 1) * (x - 1), x) == Dual(x * x - 1, x)
    assert Dual((x + 1) * (x - 1), x) != Dual(x * x, x)


def test_arrays_act_entry_by_entry_and_from_either_side():
    rng = np.random.default_rng(0)
    a, b = (Dual(rng.normal(size=(4, 3)), rng.normal(size=(4, 3))) for _ in range(2))
    array = rng.normal(size=(4, 3))
    assert (a * b)[2, 1] == a[2, 1] * b[2, 1]
    assert FLOAT.vanishes((a / b)[0, 0] - a[0, 0] / b[0, 0])
    assert array * a == a * array == a * Dual(array)
    assert array + a == a + array
    assert (array - a) == -(a - array)
    with pytest.raises(ZeroDivisor):
        a / (b * np.where(np.arange(3) == 1, 0.0, 1.0))


@over(RINGS, cases=3)
def test_matrix_product_is_rows_times_columns(scalars, rng):
    a, b = scalars.tensor(rng), scalars.tensor(rng)
    product = a @ b
    for i in range(3):
        for j in range(3):
            entry = sum((a[i, k] * b[k, j] for k in range(3)), Dual(0))
            assert scalars.vanishes(product[i, j] - entry)
    assert scalars.vanishes(a.re @ b - Dual(a.re, 0 * a.re) @ b)
    assert scalars.vanishes(a @ b.re - a @ Dual(b.re, 0 * b.re))


def test_a_polynomial_is_one_entry_of_an_array():
    x, y, *_ = POLYNOMIAL_RING.gens()
    assert as_array([[x, y], [x + y, 1]]).shape == (2, 2)
    assert as_array(x).shape == ()
    with pytest.raises(ValueError, match="equal lengths"):
        as_array([[x, y], [x]])


def test_fractions_join_the_flint_ring_of_the_other_part():
    third, x = Fraction(1, 3), POLYNOMIAL_RING.gens()[0]
    for du in (flint.fmpq(1, 2), x):
        a = Dual(third, du)
        assert isinstance(a.re, flint.fmpq) and a * a == Dual(third * third, 2 * du / 3)
        b = Dual(np.array([third, 1]), as_array([du, 2]))
        assert (b * b).re[0] == flint.fmpq(1, 9) and (b @ b).re == flint.fmpq(10, 9)
        assert isinstance(Dual(np.array(third), as_array(du)).re, flint.fmpq)


def test_a_dual_number_is_immutable_and_can_be_pickled():
    with pytest.raises(AttributeError, match="immutable"):
        Dual(1, 2).re = 3
    assert pickle.loads(pickle.dumps(Dual(Fraction(1, 2), 3))) == Dual(Fraction(1, 2), 3)


def test_bad_input_gets_one_clear_error():
    with pytest.raises(TypeError, match="expected an integer exponent"):
        Dual(1.0, 2.0) ** 0.5
    with pytest.raises(TypeError, match="dual number over dual numbers"):
        Dual(Dual(1, 2), 3)
    with pytest.raises(TypeError, match="unsupported operand"):
        Dual(1, 2) + "x"
