"""Laws of the sets of points with a prescribed n-th order acceleration, and textbook centres."""

from fractions import Fraction

import numpy as np
import pytest
from flint import fmpq
from pydrake.symbolic import Expression, Variable

from workbench.algebra.dual_tensors import apply, cross, dot, outer
from workbench.kinematics import fields, frames
from workbench.kinematics.centres import (
    acceleration_centre,
    field_scales,
    points_with_acceleration,
    regular_point,
)

TYPES = {
    "float": float,
    "Fraction": Fraction,
    "fmpq": lambda x: fmpq(x.numerator, x.denominator),
}


def rationals(seed: int, *shape: int) -> np.ndarray:
    rng = np.random.default_rng(seed)
    numbers = rng.integers(-9, 10, size=shape), rng.integers(1, 6, size=shape)
    return np.vectorize(lambda p, q: Fraction(int(p), int(q)), otypes=[object])(*numbers)


def tensor_of_rank(rank: int, seed: int) -> np.ndarray:
    x, y = rationals(seed, 2, 3, 3)
    return sum((outer(x[k], y[k]) for k in range(rank)), start=0 * outer(x[0], y[0]))


@pytest.fixture(params=TYPES)
def scalar(request):
    convert = np.vectorize(TYPES[request.param], otypes=[object])
    if request.param == "float":
        return lambda x: convert(x).astype(float)
    return convert


def is_zero(x) -> bool:
    x = np.asarray(x)
    return bool(np.all(abs(x) < 1e-9)) if x.dtype == float else bool(np.all(x == 0))


@pytest.mark.parametrize("rank", [0, 1, 2, 3])
@pytest.mark.parametrize("seed", range(6))
def test_solvable_cases_by_rank(scalar, rank, seed):
    """Every point of the set, and no point off it, has the prescribed acceleration."""
    T, inside = tensor_of_rank(rank, seed), rationals(seed + 100, 3)
    a, wanted = rationals(seed + 200, 2, 3)
    a = wanted - apply(T, inside)
    T, a, wanted, inside = map(scalar, (T, a, wanted, inside))
    locus = points_with_acceleration(T, a, wanted)
    assert locus.kind == {0: "space", 1: "plane", 2: "line", 3: "point"}[rank]
    assert locus.rank == rank and locus.dimension == 3 - rank
    assert is_zero(locus.residual) and is_zero(fields.acceleration(T, a, locus.point) - wanted)
    spans = locus.directions[: locus.dimension]
    assert is_zero(apply(T, spans)) and is_zero(locus.directions[locus.dimension :])
    assert np.linalg.matrix_rank(locus.directions.astype(float)) == locus.dimension
    gram = spans @ spans.T
    assert is_zero(gram - np.diag(np.diag(gram)))
    assert is_zero(spans @ locus.point)
    # the known solution lies in the set
    offset = inside - locus.point
    along = sum((dot(s, offset) * s / dot(s, s) for s in spans), start=0 * offset)
    assert is_zero(along - offset)


@pytest.mark.parametrize("rank", [0, 1, 2])
@pytest.mark.parametrize("seed", range(6))
def test_no_centre(scalar, rank, seed):
    """aₙ outside the range of Φₙ: no centre, and the nearest miss is orthogonal to the range."""
    T = tensor_of_rank(rank, seed)
    outside = cross(*tensor_of_rank(2, seed).T[:2]) if rank == 2 else rationals(seed + 5, 3)
    T, a = scalar(T), scalar(outside + apply(T, rationals(seed, 3)))
    locus = acceleration_centre(T, a)
    assert locus.kind == "none" and locus.rank == rank and str(locus) == "no point"
    assert is_zero(apply(T.T, locus.residual)) and not is_zero(locus.residual)
    assert is_zero(fields.acceleration(T, a, locus.point) - locus.residual)
    assert is_zero(locus.directions)


@pytest.mark.parametrize("rank", [0, 1, 2, 3])
def test_two_methods_agree(rank):
    """Cofactors on rationals and the singular values of floats find the same set."""
    for seed in range(20):
        T, a = tensor_of_rank(rank, seed), rationals(seed + 300, 3)
        a = a if seed % 2 else apply(T, a)
        exact, rounded = (
            acceleration_centre(T, a),
            acceleration_centre(T.astype(float), a.astype(float)),
        )
        assert exact.kind == rounded.kind and exact.rank == rounded.rank == rank
        np.testing.assert_allclose(rounded.point, exact.point.astype(float), rtol=1e-6, atol=1e-6)


def test_batch_is_a_loop(scalar):
    T = np.array([tensor_of_rank(rank, 7) for rank in (3, 2, 1, 0, 2, 0)])
    a = apply(T, rationals(8, 6, 3))
    a[4:] += np.array([[Fraction(1), Fraction(2), Fraction(-3)]])
    T, a = scalar(T), scalar(a)
    locus = acceleration_centre(T, a)
    assert list(locus.kind) == ["point", "line", "plane", "space", "none", "none"]
    for i in range(6):
        one = acceleration_centre(T[i], a[i])
        assert one.kind == locus.kind[i]
        assert is_zero(one.point - locus.point[i]) and is_zero(one.residual - locus.residual[i])


def test_centre_moves_with_the_origin():
    for seed in range(5):
        omega, v, p_WO = (*rationals(seed, 2, 4, 3), rationals(seed + 9, 3))
        Phi, a = fields.acceleration_tensors(omega), fields.invariant_vectors(omega, v)
        moved = frames.about_origin(Phi, a, p_WO)
        here, there = (
            acceleration_centre(Phi[3], a[3]),
            acceleration_centre(moved[0][3], moved[1][3]),
        )
        assert here.kind == there.kind == "point"
        assert (here.point == there.point + p_WO).all()


def test_velocity_is_a_line_or_nowhere():
    """Chasles: points at rest only if ω · v = 0, and then along the axis ω × v / ω²."""
    w, u = rationals(3, 2, 3)
    tilted = acceleration_centre(*_first_order(w, u))
    assert tilted.kind == "none" and tilted.rank == 2
    assert np.all(cross(tilted.residual, w) == 0)  # the least velocity is the slide along the axis
    v = cross(w, u)
    axis = acceleration_centre(*_first_order(w, v))
    assert axis.kind == "line"
    assert (axis.point == cross(w, v) / dot(w, w)).all()
    assert (cross(axis.directions[0], w) == 0).all()


def _first_order(w, v):
    return fields.acceleration_tensors([w])[1], fields.invariant_vectors([w], [v])[1]


def test_uniform_screw_motion():
    """No point is ever at rest, but every point of the axis is free of acceleration of any order."""
    omega, v = np.zeros((2, 5, 3))
    omega[0] = (0, 0, 2)
    v[0] = np.cross((1, -3, 0), omega[0])
    v[0, 2] = 0.5
    Phi, a = fields.acceleration_tensors(omega), fields.invariant_vectors(omega, v)
    assert acceleration_centre(Phi[1], a[1]).kind == "none"
    for n in range(2, 6):
        axis = acceleration_centre(Phi[n], a[n])
        assert axis.kind == "line"
        np.testing.assert_allclose(axis.point, (1, -3, 0), atol=1e-12)
        np.testing.assert_allclose(abs(axis.directions[0]), (0, 0, 1), atol=1e-12)


def test_rolling_wheel():
    """A wheel rolling at constant speed: velocity pole at the contact, acceleration pole at the hub."""
    radius, speed = 0.5, 3.0
    w_WB, v_WBo = np.zeros((2, 3, 3))
    w_WB[0], v_WBo[0] = (0, speed / radius, 0), (speed, 0, 0)
    hub = np.array([2.0, 0.0, radius])
    omega, v = frames.chapter_twist(w_WB, v_WBo, hub)
    Phi, a = fields.acceleration_tensors(omega), fields.invariant_vectors(omega, v)
    poles = acceleration_centre(Phi, a)
    assert list(poles.kind[1:]) == ["line"] * 3
    np.testing.assert_allclose(poles.point[1], (2, 0, 0), atol=1e-12)
    np.testing.assert_allclose(poles.point[2], hub, atol=1e-12)
    np.testing.assert_allclose(poles.point[3], hub, atol=1e-12)


def test_planar_acceleration_pole():
    """Textbook pole of a plane motion: (ω² a + α k × a) / (ω⁴ + α²) from the origin."""
    rng = np.random.default_rng(4)
    for speed, alpha in rng.normal(size=(10, 2)):
        omega, v = np.zeros((2, 2, 3))
        omega[:, 2] = speed, alpha
        v[:, :2] = rng.normal(size=(2, 2))
        Phi, a = fields.acceleration_tensors(omega), fields.invariant_vectors(omega, v)
        pole = acceleration_centre(Phi[2], a[2])
        quarter_turn = np.array([-a[2][1], a[2][0], 0])
        expected = (speed**2 * a[2] + alpha * quarter_turn) / (speed**4 + alpha**2)
        assert pole.kind == "line"
        np.testing.assert_allclose(pole.point, expected, rtol=1e-9)


def test_translation_and_rest():
    omega, v = np.zeros((2, 3, 3))
    v[1] = (1, 0, 0)
    Phi, a = fields.acceleration_tensors(omega), fields.invariant_vectors(omega, v)
    assert list(acceleration_centre(Phi, a).kind) == ["point", "space", "none", "space"]


def test_scale_tells_rounding_from_motion():
    """A sum of large terms that cancel leaves rounding, which only the scale of the terms unmasks."""
    noise = 1e-16 * np.random.default_rng(0).normal(size=(3, 4))
    Phi, a = noise[:, :3], noise[:, 3]
    assert acceleration_centre(Phi, a).kind == "point"
    assert acceleration_centre(Phi, a, Phi_scale=1.0, a_scale=1.0).kind == "space"


def test_scales_bound_the_field():
    omega, v = np.random.default_rng(1).normal(size=(2, 6, 10, 3))
    Phi_scale, a_scale = field_scales(omega, v)
    Phi, a = fields.acceleration_tensors(omega), fields.invariant_vectors(omega, v)
    assert (np.linalg.norm(Phi, ord=2, axis=(-1, -2)) <= Phi_scale * (1 + 1e-12)).all()
    assert (np.linalg.norm(a, axis=-1) <= a_scale * (1 + 1e-12)).all()
    assert Phi_scale.shape == a_scale.shape == (7, 10)


@pytest.mark.filterwarnings("ignore:invalid value:RuntimeWarning")
def test_symbolic_centre_is_the_formula():
    T, a = tensor_of_rank(3, 1), rationals(2, 3)
    x = Variable("x")
    symbolic = regular_point(T.astype(float) * Expression(x), a.astype(float) * Expression(x) ** 2)
    at = np.array([e.Evaluate({x: 3.0}) for e in symbolic])
    np.testing.assert_allclose(at, (3 * regular_point(T, a)).astype(float), rtol=1e-9)
    with pytest.raises(TypeError, match="symbolic"):
        acceleration_centre(T * Expression(x), a * Expression(x))


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: acceleration_centre(np.eye(2), np.ones(3)), "Phi: expected shape"),
        (lambda: acceleration_centre(np.eye(3), np.ones(2)), "a: expected shape"),
        (lambda: acceleration_centre(np.eye(3), [1, 2, np.inf]), "finite"),
        (lambda: acceleration_centre(np.eye(3), np.ones(3), rtol=-1), "rtol"),
        (lambda: points_with_acceleration(np.eye(3), np.ones(3), np.ones(4)), "prescribed"),
        (lambda: regular_point(np.zeros((3, 3)), np.ones(3)), "det T = 0"),
    ],
)
def test_bad_input(call, message):
    with pytest.raises(ValueError, match=message):
        call()
