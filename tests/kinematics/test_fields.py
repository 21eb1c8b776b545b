"""Laws of the rigid-body fields, over floats, Fractions, flint rationals and Drake Expressions."""

from fractions import Fraction
from math import factorial

import numpy as np
import pytest
from flint import fmpq
from pydrake.symbolic import Expression, Variable

from workbench.algebra.dual_tensors import adjugate, apply, cross, determinant, outer, skew, transpose, vect
from workbench.kinematics import fields, frames, points
from workbench.kinematics.tensors import identity_like, sym

ORDER = 7

# Drake keeps Expressions as NaNs with a payload, which NumPy takes for invalid operations.
pytestmark = pytest.mark.filterwarnings("ignore:invalid value:RuntimeWarning")


def rationals(seed: int, *shape: int) -> np.ndarray:
    rng = np.random.default_rng(seed)
    numbers = rng.integers(-9, 10, size=shape), rng.integers(1, 6, size=shape)
    return np.vectorize(lambda p, q: Fraction(int(p), int(q)), otypes=[object])(*numbers)


def rational_rotation(c: np.ndarray) -> np.ndarray:
    """Cayley's rotation I + 2 (c̃ + c̃²) / (1 + c·c)."""
    return identity_like(skew(c)) + (skew(c) + skew(c) @ skew(c)) * 2 / (1 + c @ c)


class Scalars:
    """Fractions turned into one scalar type (`of`) and what was computed turned back (`values`)."""

    def __init__(self, name: str):
        self.name = name
        self.environment = {}

    def of(self, numbers: np.ndarray) -> np.ndarray:
        if self.name == "float":
            return numbers.astype(float)
        convert = {"Fraction": Fraction, "fmpq": self._fmpq, "Expression": self._variable}[self.name]
        return np.vectorize(convert, otypes=[object])(numbers)

    def _fmpq(self, x: Fraction) -> fmpq:
        return fmpq(x.numerator, x.denominator)

    def _variable(self, x: Fraction) -> Expression:
        variable = Variable(f"x{len(self.environment)}")
        self.environment[variable] = float(x)
        return Expression(variable)

    def assert_equal(self, computed, expected: np.ndarray) -> None:
        computed, expected = np.asarray(computed), np.asarray(expected)
        assert computed.shape == expected.shape and computed.size
        if self.name in ("Fraction", "fmpq"):
            assert all(type(x).__name__ == self.name for x in computed.flat)
            assert (computed == self.of(expected)).all()
            return
        if self.name == "Expression":
            assert all(isinstance(x, Expression) for x in computed.flat)
            evaluate = np.vectorize(lambda x: x.Evaluate(self.environment), otypes=[float])
            computed = evaluate(computed)
        else:
            assert computed.dtype == float
        expected = expected.astype(float)
        np.testing.assert_allclose(computed, expected, rtol=1e-11, atol=1e-11 * abs(expected).max())


@pytest.fixture(params=["float", "Fraction", "fmpq", "Expression"])
def scalars(request):
    return Scalars(request.param)


class RationalMotion:
    """x ↦ R(t) x + p(t) with R Cayley's rotation of a polynomial c(t): exact derivatives at t = 0."""

    def __init__(self, seed: int, order: int):
        terms = order + 1
        c = np.concatenate([rationals(seed, 3, 3), np.full((terms, 3), Fraction(0))])[:terms]
        self.p = rationals(seed + 1000, terms, 3)
        c_tilde = skew(c)
        square = self._product(c_tilde, c_tilde, np.matmul)
        norm = self._product(c, c, lambda x, y: x @ y)
        norm = [Fraction(1) + norm[0], *norm[1:]]
        inverse = [1 / norm[0]]
        for n in range(1, terms):
            inverse.append(-sum(norm[k] * inverse[n - k] for k in range(1, n + 1)) / norm[0])
        turn = self._product(inverse, c_tilde + square, lambda x, y: 2 * x * y)
        self.R = turn + np.stack([identity_like(c_tilde[0]), *np.zeros_like(c_tilde[1:])])
        rates = np.array([n * self.R[n] for n in range(1, terms)])
        omega = vect(self._product(rates, transpose(self.R), np.matmul))
        moved = np.array([n * self.p[n] for n in range(1, terms)])
        v = moved - self._product(omega, self.p, cross)
        self.omega, self.v = self._derivatives(omega), self._derivatives(v)
        self.R, self.p = self._derivatives(self.R), self._derivatives(self.p)

    @staticmethod
    def _product(x, y, multiply):
        terms = min(len(x), len(y))
        return np.array([sum(multiply(x[k], y[n - k]) for k in range(n + 1)) for n in range(terms)])

    @staticmethod
    def _derivatives(taylor):
        return np.array([factorial(n) * x for n, x in enumerate(taylor)])


@pytest.mark.parametrize("seed", range(4))
def test_definition_on_exact_motions(scalars, seed):
    """Φₙ = R⁽ⁿ⁾ Rᵀ and aₙ = p⁽ⁿ⁾ - Φₙ p, Eqs. (15), (16), not only from the recurrence."""
    motion = RationalMotion(seed, ORDER if scalars.name != "Expression" else 4)
    assert (motion.R[0] @ motion.R[0].T == np.eye(3)).all()
    omega, v = scalars.of(motion.omega), scalars.of(motion.v)
    Phi, a = fields.acceleration_tensors(omega), fields.invariant_vectors(omega, v)
    expected = motion.R @ transpose(motion.R[0])
    scalars.assert_equal(Phi, expected)
    scalars.assert_equal(a[1:], motion.p[1:] - apply(expected[1:], motion.p[0]))
    scalars.assert_equal(fields.acceleration(Phi, a, scalars.of(motion.p[0])), motion.p)
    scalars.assert_equal(a[0], 0 * motion.p[0])


@pytest.mark.parametrize("seed", range(4))
def test_round_trip_of_drake_and_chapter_twists(scalars, seed):
    motion = RationalMotion(seed, 5)
    w_WB, v_WBo, p_WBo = motion.omega, motion.p[1:], motion.p[0]
    omega, v = frames.chapter_twist(*map(scalars.of, (w_WB, v_WBo, p_WBo)))
    scalars.assert_equal(v, motion.v)
    scalars.assert_equal(omega, motion.omega)
    back = frames.drake_twist(*map(scalars.of, (motion.omega, motion.v, p_WBo)))
    scalars.assert_equal(back[1], v_WBo)


@pytest.mark.parametrize("seed", range(3))
def test_twist_to_field_and_back(scalars, seed):
    order = {"Expression": 3, "float": 4}.get(scalars.name, ORDER)
    twist = rationals(seed, 2, order, 2, 3)
    omega, v = map(scalars.of, twist)
    Phi, a = fields.acceleration_tensors(omega), fields.invariant_vectors(omega, v)
    back = fields.twist_from_field(Phi, a)
    scalars.assert_equal(back[0], twist[0])
    scalars.assert_equal(back[1], twist[1])


def exact_field(seed: int, order: int = ORDER, batch: tuple[int, ...] = ()):
    omega, v = rationals(seed, 2, order, *batch, 3)
    return omega, v, fields.acceleration_tensors(omega), fields.invariant_vectors(omega, v)


@pytest.mark.parametrize("seed", range(5))
def test_equivariance_under_rotation(seed):
    omega, v, Phi, a = exact_field(seed)
    R = rational_rotation(rationals(seed + 50, 3))
    turned = frames.expressed_in(Phi, a, R)
    assert (fields.acceleration_tensors(apply(R, omega)) == turned[0]).all()
    assert (fields.invariant_vectors(apply(R, omega), apply(R, v)) == turned[1]).all()


@pytest.mark.parametrize("seed", range(5))
def test_equivariance_under_change_of_origin(seed):
    omega, v, Phi, a = exact_field(seed)
    p_WO = rationals(seed + 50, 3)
    moved = frames.about_origin(Phi, a, p_WO)
    assert (fields.invariant_vectors(omega, v + cross(omega, p_WO))[1:] == moved[1][1:]).all()
    rho = rationals(seed + 51, 3)
    assert (fields.acceleration(*moved, rho - p_WO)[1:] == fields.acceleration(Phi, a, rho)[1:]).all()


@pytest.mark.parametrize("factor", [Fraction(-1), Fraction(2), Fraction(-3, 7)])
def test_change_of_time_unit_and_direction(factor):
    """ω⁽ᵏ⁾ → λᵏ⁺¹ ω⁽ᵏ⁾ under t → t/λ, and Φₙ → λⁿ Φₙ."""
    omega, v, Phi, a = exact_field(8)
    powers = np.array([factor**n for n in range(ORDER + 1)])
    faster = powers[1:, None] * omega, powers[1:, None] * v
    assert (fields.acceleration_tensors(faster[0]) == powers[:, None, None] * Phi).all()
    assert (fields.invariant_vectors(*faster) == powers[:, None] * a).all()


def test_recurrence_by_drakes_own_derivatives():
    """Φₙ₊₁ = Φ̇ₙ + Φₙ Φ₁ and aₙ₊₁ = ȧₙ + Φₙ a₁, Eq. (20), with d/dt taken by Drake."""
    time = Variable("t")
    order, coefficients = 4, rationals(3, 2, 6, 3).astype(float)

    def jet(polynomial):
        x = [sum(c * Expression(time) ** k for k, c in enumerate(polynomial))]
        for _ in range(order - 1):
            x.append(np.array([e.Differentiate(time) for e in x[-1]]))
        return np.array(x)

    omega, v = map(jet, coefficients)
    Psi = fields.homogeneous_tensors(fields.acceleration_tensors(omega), fields.invariant_vectors(omega, v))
    rate = np.vectorize(lambda e: e.Differentiate(time), otypes=[object])(Psi)
    for instant in (0.0, 0.3, -0.7):
        at = np.vectorize(lambda e: e.Evaluate({time: instant}), otypes=[float])  # noqa: B023
        values, rates = at(Psi), at(rate)
        for n in range(1, order):
            expected = rates[n] + values[n] @ values[1]
            np.testing.assert_allclose(values[n + 1], expected, rtol=1e-10, atol=1e-9)


def test_homogeneous_tensor_acts_on_points():
    _, _, Phi, a = exact_field(4)
    rho = rationals(5, 3)
    Psi = fields.homogeneous_tensors(Phi, a)
    assert Psi.shape == (ORDER + 1, 4, 4)
    moved = Psi @ np.append(rho, Fraction(1))
    assert (moved[:, :3] == fields.acceleration(Phi, a, rho)).all() and (moved[:, 3] == 0).all()


def test_batches_are_loops():
    omega, v, Phi, a = exact_field(6, 4, (2, 3))
    assert Phi.shape == (5, 2, 3, 3, 3) and a.shape == (5, 2, 3, 3)
    for i in np.ndindex(2, 3):
        one = (slice(None), *i)
        assert (fields.acceleration_tensors(omega[one]) == Phi[one]).all()
        assert (fields.invariant_vectors(omega[one], v[one]) == a[one]).all()


@pytest.mark.parametrize("seed", range(5))
def test_parts_and_recurrences_of_the_parts(seed):
    """Φ = t̃ + S; Eq. (54), (55) for t, S, with Φ̇ₙ from Eq. (20)."""
    omega, _, Phi, _ = exact_field(seed)
    assert (skew(fields.t(Phi)) + fields.S(Phi) == Phi).all()
    rate = Phi[2:] - Phi[1:-1] @ Phi[1]
    n = slice(1, -1)
    turn = fields.divergence(Phi[n])[:, None, None] * np.eye(3, dtype=int) - transpose(Phi[n])
    assert (fields.t(Phi)[2:] == vect(rate) + apply(turn, omega[0]) / 2).all()
    assert (fields.S(Phi)[2:] == sym(rate) + sym(Phi[n] @ skew(omega[0]))).all()


@pytest.mark.parametrize("seed", range(5))
def test_adjugate_and_determinant(scalars, seed):
    numbers = rationals(seed, 4, 3, 3)
    numbers[3] = outer(numbers[3, 0], numbers[3, 1])
    T = scalars.of(numbers)
    expected = np.zeros((4, 3, 3), dtype=object) + np.eye(3, dtype=int)
    expected = expected * np.array([Fraction(determinant(x)) for x in numbers])[:, None, None]
    scalars.assert_equal(T @ adjugate(T), expected)
    scalars.assert_equal(adjugate(T) @ T, expected)
    assert determinant(numbers[3]) == 0


def test_determinant_agrees_with_lu():
    T = np.random.default_rng(0).normal(size=(50, 3, 3))
    np.testing.assert_allclose(determinant(T), np.linalg.det(T), rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("seed", range(5))
def test_invariants_do_not_depend_on_the_point(seed):
    _, _, Phi, a = exact_field(seed)
    rho = rationals(seed + 70, 6, 3)
    m, n = 5, 2
    a_m, a_n = (fields.acceleration(Phi[k], a[k], rho) for k in (m, n))
    assert (fields.invariant_I(Phi[m], a_m, rho) == a[m]).all()
    assert (fields.invariant_J(Phi[m], a_m, rho) == apply(adjugate(Phi[m]), a[m])).all()
    invariant = fields.invariant_K(Phi[m], a_m, Phi[n], a_n)
    centre = -fields.solve(Phi[n], a[n])
    assert (invariant == fields.acceleration(Phi[m], a[m], centre)).all()


def test_divergence_and_curl_are_the_fields_own():
    """div and curl of ρ ↦ a + Φ ρ by differences, exact because the field is affine; Eq. (52)."""
    _, _, Phi, a = exact_field(2)
    n, origin = 4, rationals(1, 3)
    at = fields.acceleration(Phi[n], a[n], origin)
    J = [fields.acceleration(Phi[n], a[n], origin + e) - at for e in np.eye(3, dtype=int)]
    assert fields.divergence(Phi[n]) == J[0][0] + J[1][1] + J[2][2]
    curl = [J[1][2] - J[2][1], J[2][0] - J[0][2], J[0][1] - J[1][0]]
    assert (fields.curl(Phi[n]) == curl).all()


@pytest.mark.parametrize("seed", range(4))
def test_field_from_four_points(scalars, seed):
    if scalars.name == "Expression":
        scalars = Scalars("float")
    T, a, p = rationals(seed, 3, 3), rationals(seed + 1, 3), rationals(seed + 2, 4, 3)
    if determinant(p[1:] - p[0]) == 0:
        p[0] = p[0] + Fraction(17)
    found = points.field_from_points(scalars.of(p), scalars.of(a + apply(T, p)))
    scalars.assert_equal(found[0], T)
    scalars.assert_equal(found[1], a)


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("count", [3, 5])
def test_twist_from_three_points(scalars, seed, count):
    """Three points that are not collinear are enough for every order of a rigid motion."""
    if scalars.name == "Expression":
        scalars = Scalars("float")
    order = 4
    omega, v, Phi, a = exact_field(seed, order)
    p = rationals(seed + 90, count, 3)
    measured = fields.acceleration(Phi[1:, None], a[1:, None], p)
    found = points.twist_from_points(scalars.of(p), scalars.of(measured))
    scalars.assert_equal(found[0], omega)
    scalars.assert_equal(found[1], v)


def test_points_in_batches_and_in_least_squares():
    rng = np.random.default_rng(1)
    omega, v = rng.normal(size=(2, 3, 4, 3))
    Phi, a = fields.acceleration_tensors(omega), fields.invariant_vectors(omega, v)
    p = rng.normal(size=(4, 20, 3))
    measured = fields.acceleration(Phi[1:, :, None], a[1:, :, None], p)
    noisy = measured + 1e-6 * rng.normal(size=measured.shape)
    found = points.twist_from_points(p, noisy)
    np.testing.assert_allclose(found[0], omega, atol=1e-4)
    np.testing.assert_allclose(found[1], v, atol=1e-4)
    affine = points.field_from_points(p, noisy[2])
    np.testing.assert_allclose(affine[0], Phi[3], atol=1e-5)


def test_rotation_at_constant_speed_about_an_axis():
    """Textbook case: |aₙ| of a point at distance r is ωⁿ r; the centripetal acceleration is -ω² r."""
    omega = np.zeros((6, 3))
    omega[0] = (0, 0, 2.0)
    Phi, a = fields.acceleration_tensors(omega), fields.invariant_vectors(omega, 0 * omega)
    rho = np.array([3.0, 0, 5.0])
    accelerations = fields.acceleration(Phi, a, rho)
    np.testing.assert_allclose(accelerations[1], (0, 6, 0))
    np.testing.assert_allclose(accelerations[2], (-12, 0, 0))
    np.testing.assert_allclose(np.linalg.norm(accelerations[1:], axis=1), 3 * 2.0 ** np.arange(1, 7))


def test_printed_values_of_the_second_order():
    """det Φ₂ = -(ω×ε)², Eq. (58); div and curl of orders 2 and 3, Eqs. (60), (62)."""
    omega, _, Phi, _ = exact_field(11)
    w, e, j = omega[:3]
    assert determinant(Phi[2]) == -(cross(w, e) @ cross(w, e))
    assert fields.divergence(Phi[2]) == -2 * w @ w
    assert (fields.curl(Phi[2]) == 2 * e).all()
    assert fields.divergence(Phi[3]) == -6 * w @ e
    assert (fields.curl(Phi[3]) == 2 * j + cross(e, w) - 2 * (w @ w) * w).all()


def test_taylor_coefficients_of_a_position():
    """The n-th order acceleration of a body point is the n-th derivative of its path, Eq. (13)."""
    motion = RationalMotion(5, 6)
    r = rationals(99, 3)
    path = motion.p + apply(motion.R, r)
    Phi = fields.acceleration_tensors(motion.omega)
    a = fields.invariant_vectors(motion.omega, motion.v)
    assert (fields.acceleration(Phi, a, path[0]) == path).all()


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: fields.acceleration_tensors(np.ones((2, 4))), "expected shape"),
        (lambda: fields.acceleration_tensors(np.ones(3)), "derivative first"),
        (lambda: fields.acceleration_tensors(np.ones((0, 3))), "N >= 1"),
        (lambda: fields.acceleration_tensors([[1.0, 2.0, np.nan]]), "finite"),
        (lambda: fields.acceleration_tensors([[1, 2, 3j]]), "real numbers"),
        (lambda: fields.acceleration_tensors([[1, 2], [1, 2, 3]]), "omega"),
        (lambda: fields.acceleration_tensors([["a", "b", "c"]]), "real numbers"),
        (lambda: fields.invariant_vectors(np.ones((2, 3)), np.ones((3, 3))), "2 and 3"),
        (lambda: fields.twist_from_field(np.ones((3, 3)), np.ones(3)), "order first"),
        (lambda: fields.solve(np.zeros((3, 3)), np.ones(3)), "det T = 0"),
        (lambda: fields.solve(np.zeros((3, 3), dtype=object), np.ones(3, dtype=object)), "det"),
        (lambda: points.field_from_points(np.eye(3), np.eye(3)), "at least 4"),
        (lambda: points.field_from_points(rationals(0, 4, 3), rationals(0, 5, 3)), "4 points"),
        (lambda: points.field_from_points([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], np.ones((4, 3))), "coplanar"),
        (lambda: points.twist_from_points(np.eye(3), np.eye(3)), "N, ..., P, 3"),
        (lambda: points.twist_from_points(np.eye(3)[:2], np.ones((1, 2, 3))), "at least 3"),
        (lambda: points.twist_from_points([[0, 0, 1], [0, 0, 2], [0, 0, 3]], np.ones((1, 3, 3))), "collinear"),
        (lambda: points.twist_from_points(np.array([[0, 0, 1], [0, 0, 2], [0, 0, 3]], dtype=object), np.ones((1, 3, 3), dtype=object)), "collinear"),
    ],
)  # fmt: skip
def test_bad_input(call, message):
    with pytest.raises(ValueError, match=message):
        call()
