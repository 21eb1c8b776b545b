"""Laws of functions of dual numbers, Eq. (72), and Drake's own derivatives as the reference."""

import math
from fractions import Fraction

import flint
import numpy as np
import pytest
from pydrake.autodiffutils import AutoDiffXd
from pydrake.symbolic import Expression, Variable

from tests.dual_scalars import EXPRESSION, FLOAT, POLYNOMIAL_RING, over, quiet_expressions
from workbench.algebra import dual_functions as f
from workbench.algebra.dual import Dual, ZeroDivisor

pytestmark = quiet_expressions
SMOOTH = [FLOAT, EXPRESSION]
POSITIVE_DUALS = [Dual(a, a0) for a, a0 in ((0.1, 2.0), (0.7, -3.0), (1.0, 0.0), (5.5, 0.25))]


@over(SMOOTH, cases=6)
def test_sine_and_cosine_satisfy_the_addition_theorems(scalars, rng):
    a, b = scalars.dual(rng), scalars.dual(rng)
    assert scalars.vanishes(f.sin(a) * f.sin(a) + f.cos(a) * f.cos(a) - 1)
    assert scalars.vanishes(f.sin(a + b) - (f.sin(a) * f.cos(b) + f.cos(a) * f.sin(b)))
    assert scalars.vanishes(f.cos(a + b) - (f.cos(a) * f.cos(b) - f.sin(a) * f.sin(b)))


@over(SMOOTH, cases=6)
def test_exponential_turns_sums_into_products(scalars, rng):
    a, b = scalars.dual(rng) / 8, scalars.dual(rng) / 8
    assert scalars.vanishes(f.exp(a + b) - f.exp(a) * f.exp(b))


@over(SMOOTH, cases=6)
def test_root_logarithm_and_arctangent_are_inverse_functions(scalars, rng):
    a = scalars.dual(rng)
    a = a * a + 1
    assert scalars.vanishes(f.sqrt(a) * f.sqrt(a) - a)
    assert scalars.vanishes(f.exp(f.log(a)) - a)
    angle = f.atan2(a - 1.5, a)
    radius = f.sqrt(a * a + (a - 1.5) * (a - 1.5))
    assert scalars.vanishes(radius * f.cos(angle) - a)
    assert scalars.vanishes(radius * f.sin(angle) - (a - 1.5))


@pytest.mark.parametrize("name", ["sin", "cos", "exp", "log", "sqrt"])
@pytest.mark.parametrize("a", POSITIVE_DUALS, ids=str)
def test_dual_part_is_the_derivative_that_drake_finds(name, a):
    ours = getattr(f, name)(a)
    forward = getattr(np, name)(AutoDiffXd(a.re, [a.du]))
    assert ours.re == pytest.approx(forward.value(), rel=1e-15)
    assert ours.du == pytest.approx(forward.derivatives()[0], rel=1e-15)
    x = Variable("x")
    symbolic = getattr(np, name)(Expression(x)).Differentiate(x)
    assert ours.du == pytest.approx(a.du * symbolic.Evaluate({x: a.re}), rel=1e-14)


@pytest.mark.parametrize("x", [0.3, -0.7])
@pytest.mark.parametrize("y", [1.1, -2.0, 0.0])
def test_arctangent_of_two_arguments_agrees_with_drake(y, x):
    ours = f.atan2(Dual(y, 0.4), Dual(x, -1.7))
    theirs = np.arctan2(AutoDiffXd(y, [0.4]), AutoDiffXd(x, [-1.7]))
    assert ours.re == theirs.value()
    assert ours.du == pytest.approx(theirs.derivatives()[0], rel=1e-14)


def test_extension_of_any_function_obeys_the_chain_rule():
    tan = f.extend(math.tan, lambda a: 1 / math.cos(a) ** 2)
    square = f.extend(lambda a: a * a, lambda a: 2 * a)
    for a in POSITIVE_DUALS:
        assert FLOAT.vanishes(tan(a) - f.sin(a) / f.cos(a))
        assert FLOAT.vanishes(square(f.sin(a)) - f.sin(a) ** 2)
        assert FLOAT.vanishes(tan(square(a)) - f.sin(a * a) / f.cos(a * a))
    assert square(3) == 9


def test_functions_act_entry_by_entry():
    rng = np.random.default_rng(0)
    a = Dual(rng.uniform(0.1, 2, size=(5,)), rng.normal(size=5))
    for name in ("sin", "cos", "exp", "log", "sqrt"):
        whole = getattr(f, name)(a)
        for i in range(5):
            assert FLOAT.vanishes(whole[i] - getattr(f, name)(a[i]))


def test_exact_scalars_stay_exact_or_are_refused():
    x, y, *_ = POLYNOMIAL_RING.gens()
    assert f.sqrt(Dual(Fraction(4, 9), 1)) == Dual(Fraction(2, 3), Fraction(3, 4))
    assert f.sqrt(flint.fmpq(4, 9)) == flint.fmpq(2, 3)
    root = f.sqrt(Dual((x + y) ** 2, x * x + x * y))
    assert root * root == Dual((x + y) ** 2, x * x + x * y)
    assert f.cos(Dual(0, 3)) == 1 and f.sin(Dual(0, 3)) == Dual(0, 3)
    assert f.exp(Dual(Fraction(0), 3)) == Dual(1, 3)
    refusals = [(f.sin, 1), (f.sqrt, 2), (f.sqrt, x * y), (f.exp, x), (f.log, Fraction(2))]
    for function, argument in [*refusals, (f.sqrt, -1), (f.cos, flint.fmpq(1, 3))]:
        with pytest.raises(TypeError, match="no exact value"):
            function(argument)
    with pytest.raises(TypeError, match="no exact value"):
        f.atan2(Fraction(1), Fraction(1))


def test_points_without_a_derivative_are_refused():
    for function in (f.sqrt, f.log):
        with pytest.raises(ZeroDivisor, match="real part that is not zero"):
            function(Dual(0.0, 1.0))
        with pytest.raises(ValueError, match="real part > 0"):
            function(Dual(np.array([1.0, -1.0]), 0.0))
    with pytest.raises(ZeroDivisor, match="both real parts are zero"):
        f.atan2(Dual(0.0, 1.0), Dual(0.0, 2.0))
