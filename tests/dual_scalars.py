"""The scalars that one body of a law test runs over: floats, exact numbers, Drake Expressions."""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from random import Random
from typing import Any

import flint
import numpy as np
import pytest
from pydrake.symbolic import Expression, Variable

from workbench.algebra.dual import Dual, as_array
from workbench.algebra.dual_tensors import tensor, vector

POLYNOMIAL_RING = flint.fmpq_mpoly_ctx.get(("x", 6), "lex")
VARIABLES = [Variable(f"x{i}") for i in range(6)]


@dataclass(frozen=True)
class Scalars:
    """Random scalars of one ring, duals over it, and the test for zero that the ring deserves."""

    name: str
    number: Callable[[Random], Any]
    is_zero: Callable[[Any], bool]
    is_field: bool = True

    def dual(self, rng: Random) -> Dual:
        return Dual(self.number(rng), self.number(rng))

    def real_vector(self, rng: Random) -> np.ndarray:
        return self.vector(rng).re

    def vector(self, rng: Random) -> Dual:
        return vector(*([self.number(rng) for _ in range(3)] for _ in range(2)))

    def tensor(self, rng: Random) -> Dual:
        return tensor(*([[self.number(rng) for _ in "123"] for _ in "123"] for _ in range(2)))

    def vanishes(self, residual: Any) -> bool:
        """Whether every entry of both parts is zero (a residual with no entry is no evidence)."""
        parts = (residual.re, residual.du) if isinstance(residual, Dual) else (residual,)
        entries = [entry for part in parts for entry in as_array(part).flat]
        return len(entries) > 0 and all(self.is_zero(entry) for entry in entries)


def _rational(rng: Random) -> Fraction:
    return Fraction(rng.randint(-9, 9), rng.randint(1, 7))


def _flint_rational(rng: Random) -> flint.fmpq:
    return flint.fmpq(rng.randint(-9, 9), rng.randint(1, 7))


def _linear_form(rng: Random, variables: list[Any]) -> Any:
    return sum((rng.randint(-3, 3) * x for x in variables), 0 * variables[0])


def _expression_is_zero(e: Any) -> bool:
    """Zero at three random points: no proof, and all that a float Expression allows."""
    rng = Random(20)
    points = [{x: rng.uniform(0.5, 2) for x in VARIABLES} for _ in range(3)]
    return all(abs((e + Expression(0)).Evaluate(point)) < 1e-9 for point in points)


FLOAT = Scalars("float", lambda rng: rng.uniform(-2, 2), lambda x: abs(x) < 1e-10)
FRACTION = Scalars("Fraction", _rational, lambda x: x == 0)
FLINT = Scalars("fmpq", _flint_rational, lambda x: x == 0)
POLYNOMIAL = Scalars(
    "fmpq_mpoly",
    lambda rng: _linear_form(rng, list(POLYNOMIAL_RING.gens())),
    lambda x: x == 0,
    is_field=False,
)
EXPRESSION = Scalars(
    "Expression",
    lambda rng: rng.uniform(-1, 1) + rng.choice(VARIABLES) * rng.choice([-1, 0.5, 1]),
    _expression_is_zero,
)

RINGS = [FLOAT, FRACTION, FLINT, POLYNOMIAL, EXPRESSION]
FIELDS = [ring for ring in RINGS if ring.is_field]


# Drake keeps Expressions in NaNs, and NumPy sees them pass.
quiet_expressions = pytest.mark.filterwarnings("ignore:invalid value encountered:RuntimeWarning")


def over(scalars: list[Scalars], cases: int) -> Any:
    """Run a test over each of the scalars and that many random cases of each."""
    return pytest.mark.parametrize(
        ("scalars", "rng"),
        [
            pytest.param(ring, Random(case), id=f"{ring.name}-{case}")
            for ring in scalars
            for case in range(cases)
        ],
    )
