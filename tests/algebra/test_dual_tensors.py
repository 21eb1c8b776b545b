"""Laws of dual vectors and tensors, Eqs. (73)–(78), over every kind of scalar."""

from fractions import Fraction

import numpy as np
import pytest

from tests.dual_scalars import FIELDS, FLOAT, RINGS, over, quiet_expressions
from workbench.algebra.dual import EPSILON, Du, Dual, Re, ZeroDivisor
from workbench.algebra.dual_tensors import (
    adjugate,
    apply,
    cross,
    determinant,
    dot,
    identity,
    inverse,
    is_orthogonal,
    norm,
    outer,
    scale,
    skew,
    tensor,
    trace,
    transpose,
    triple,
    unit,
    vect,
    vector,
)

pytestmark = quiet_expressions


@over(RINGS, cases=5)
def test_scalar_product_is_symmetric_and_bilinear(scalars, rng):
    a, b, c = (scalars.vector(rng) for _ in range(3))
    k = scalars.dual(rng)
    assert scalars.vanishes(dot(a, b) - dot(b, a))
    assert scalars.vanishes(dot(scale(k, a) + c, b) - (k * dot(a, b) + dot(c, b)))


@over(RINGS, cases=5)
def test_cross_product_is_a_lie_bracket(scalars, rng):
    a, b, c = (scalars.vector(rng) for _ in range(3))
    jacobi = cross(a, cross(b, c)) + cross(b, cross(c, a)) + cross(c, cross(a, b))
    assert scalars.vanishes(cross(a, b) + cross(b, a))
    assert scalars.vanishes(jacobi)
    assert scalars.vanishes(cross(scale(scalars.dual(rng), a), a))


@over(RINGS, cases=5)
def test_skew_tensor_is_the_adjoint_representation(scalars, rng):
    a, b = scalars.vector(rng), scalars.vector(rng)
    A, B = skew(a), skew(b)
    assert scalars.vanishes(apply(A, b) - cross(a, b))
    assert scalars.vanishes(A + transpose(A))
    assert scalars.vanishes(vect(A) - a)
    assert scalars.vanishes(A @ B - B @ A - skew(cross(a, b)))
    assert scalars.vanishes(A @ B - (outer(b, a) - scale(dot(a, b), identity(), rank=2)))


@over(RINGS, cases=5)
def test_double_cross_and_triple_product_identities(scalars, rng):
    a, b, c = (scalars.vector(rng) for _ in range(3))
    lagrange = cross(a, cross(b, c)) - (scale(dot(a, c), b) - scale(dot(a, b), c))
    assert scalars.vanishes(lagrange)
    assert scalars.vanishes(triple(a, b, c) - triple(b, c, a))
    assert scalars.vanishes(triple(a, b, c) + triple(b, a, c))


@over(RINGS, cases=5)
def test_transpose_moves_a_tensor_across_the_scalar_product(scalars, rng):
    T, S, a, b = scalars.tensor(rng), scalars.tensor(rng), scalars.vector(rng), scalars.vector(rng)
    assert scalars.vanishes(dot(a, apply(T, b)) - dot(b, apply(transpose(T), a)))
    assert scalars.vanishes(transpose(T @ S) - transpose(S) @ transpose(T))
    assert scalars.vanishes(trace(T @ S) - trace(S @ T))
    assert scalars.vanishes(trace(outer(a, b)) - dot(a, b))


@over(RINGS, cases=3)
def test_determinant_is_multiplicative_and_a_ratio_of_products(scalars, rng):
    T, S = scalars.tensor(rng), scalars.tensor(rng)
    a, b, c = (scalars.vector(rng) for _ in range(3))
    image = triple(apply(T, a), apply(T, b), apply(T, c))
    assert scalars.vanishes(image - determinant(T) * triple(a, b, c))
    assert scalars.vanishes(determinant(T @ S) - determinant(T) * determinant(S))
    assert scalars.vanishes(determinant(transpose(T)) - determinant(T))


@over(RINGS, cases=5)
def test_adjugate_times_tensor_is_the_determinant(scalars, rng):
    T = scalars.tensor(rng)
    a, b = scalars.vector(rng), scalars.vector(rng)
    det_I = scale(determinant(T), identity(), rank=2)
    assert scalars.vanishes(adjugate(T) @ T - det_I)
    assert scalars.vanishes(T @ adjugate(T) - det_I)
    cofactors = transpose(adjugate(T))
    assert scalars.vanishes(cross(apply(T, a), apply(T, b)) - apply(cofactors, cross(a, b)))


@over(RINGS, cases=5)
def test_dual_part_of_the_determinant_is_jacobis_formula(scalars, rng):
    T = scalars.tensor(rng)
    assert scalars.vanishes(Du(determinant(T)) - trace(adjugate(T.re) @ T.du))


@over([r for r in FIELDS if r.name != "Expression"], cases=5)
def test_inverse_is_two_sided(scalars, rng):
    T = scalars.tensor(rng) + 20 * identity()
    assert scalars.vanishes(inverse(T) @ T - identity())
    assert scalars.vanishes(T @ inverse(T) - identity())
    with pytest.raises(ZeroDivisor):
        inverse(EPSILON * T)


def test_norm_has_both_cases_in_one_batch():
    a = Dual(
        np.array([[3.0, 4.0, 0.0], [0.0, 0.0, 0.0], [1e-200, 0.0, 0.0]]),
        np.array([[1.0, 2.0, 9.0], [2.0, -3.0, 6.0], [5.0, 1.0, 1.0]]),
    )
    expected = Dual(np.array([5.0, 0.0, 1e-200]), np.array([11 / 5, 7.0, 5.0]))
    assert FLOAT.vanishes(norm(a) - expected)
    exact = norm(vector([Fraction(3), 4, 0], [1, 2, 9]))
    assert exact == Dual(5, Fraction(11, 5))
    assert norm(vector([0, 0, 0], [2, -3, 6])) == Dual(0, 7)
    with pytest.raises(TypeError, match="no exact value"):
        norm(vector([1, 1, 0]))


@over([FLOAT], cases=20)
def test_norm_is_homogeneous_and_squares_to_the_scalar_square(scalars, rng):
    a, k = scalars.vector(rng), scalars.number(rng)
    assert scalars.vanishes(norm(a) * norm(a) - dot(a, a))
    assert scalars.vanishes(norm(k * a) - abs(k) * norm(a))
    pure = Dual(0 * a.re, a.du)
    assert scalars.vanishes(norm(k * pure) - abs(k) * norm(pure))
    assert scalars.vanishes(norm(EPSILON * a) - EPSILON * norm(a))


@over([FLOAT], cases=20)
def test_unit_vector_has_norm_one_and_gives_back_the_vector(scalars, rng):
    a = scalars.vector(rng)
    assert scalars.vanishes(norm(unit(a)) - 1)
    assert scalars.vanishes(scale(norm(a), unit(a)) - a)
    with pytest.raises(ZeroDivisor, match="no unit vector"):
        unit(EPSILON * a)


def test_orthogonality_needs_both_parts_and_positive_determinant():
    turn = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    shifted = tensor(turn, skew(np.array([1, 2, 3], dtype=object)) @ np.array(turn, dtype=object))
    assert is_orthogonal(shifted)
    assert not is_orthogonal(tensor(turn, turn))
    assert not is_orthogonal(tensor([[1, 0, 0], [0, 1, 0], [0, 0, -1]]))
    floats = Dual(shifted.re.astype(float), shifted.du.astype(float))
    assert is_orthogonal(floats, 1e-14)
    assert not is_orthogonal(floats * (1 + 1e-9), 1e-10)
    assert not is_orthogonal(Dual(-floats.re, -floats.du), 1e-10)
    batch = Dual(np.stack([floats.re, 2 * floats.re]), np.stack([floats.du, floats.du]))
    assert not is_orthogonal(batch, 1e-10)


def test_a_batch_is_its_members():
    rng = np.random.default_rng(3)
    a, b = (Dual(rng.normal(size=(4, 3)), rng.normal(size=(4, 3))) for _ in range(2))
    T = Dual(rng.normal(size=(4, 3, 3)), rng.normal(size=(4, 3, 3)))
    for i in range(4):
        assert FLOAT.vanishes(cross(a, b)[i] - cross(a[i], b[i]))
        assert FLOAT.vanishes(cross(a[0], b)[i] - cross(a[0], b[i]))
        assert FLOAT.vanishes(apply(T, a)[i] - apply(T[i], a[i]))
        assert FLOAT.vanishes(inverse(T)[i] - inverse(T[i]))
        assert FLOAT.vanishes(skew(a)[i] - skew(a[i]))
        assert FLOAT.vanishes(scale(dot(a, b), T, rank=2)[i] - dot(a[i], b[i]) * T[i])


def test_real_arrays_give_the_real_part():
    rng = np.random.default_rng(4)
    a, b = rng.normal(size=(2, 3))
    T = rng.normal(size=(3, 3))
    assert np.array_equal(cross(a, b), Re(cross(Dual(a, b), Dual(b, a))))
    assert np.allclose(cross(a, b), np.cross(a, b), atol=1e-15)
    assert np.allclose(determinant(T), np.linalg.det(T), atol=1e-14)
    assert np.allclose(inverse(T), np.linalg.inv(T), atol=1e-12)
    assert norm(np.array([3.0, 4.0, 12.0])) == 13


def test_bad_shapes_are_named():
    with pytest.raises(ValueError, match=r"real part: expected shape \(..., 3\), got \(2,\)"):
        vector([1, 2])
    with pytest.raises(ValueError, match=r"dual part: expected shape \(..., 3, 3\), got \(3,\)"):
        tensor(np.eye(3), [1.0, 2.0, 3.0])
