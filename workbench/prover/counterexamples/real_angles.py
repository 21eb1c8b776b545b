"""Points with real sines and cosines of their angles, and real exponentials, evaluated in balls by Arb.

A rational point of the circle belongs to no rational angle except 0. If an angle also occurs outside its
sine, or is a product such as ω t, a claim is refuted at rational values by a ball that excludes 0. So is a
claim about e^x, which is no rational number.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import comb
from random import Random
from typing import Any, cast

from flint import arb, ctx, fmpq

from workbench.core.terms import Relation, Symbol, Term
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.inventory import Inventory
from workbench.engines.inventory.parameters import Parameter
from workbench.engines.jet.jets import JetEngine
from workbench.engines.jet.rings import PointSource, RationalRing, sample
from workbench.prover.counterexamples.rational_points import Trial

PRECISION = 200
NONE: Mapping[Symbol, Term] = {}
_STAGES = (((-1, 0, 1), 20), ((-2, -1, 1, 2, 3), 20))


class BallRing:
    """Real numbers as balls that are certain to contain them."""

    def constant(self, numerator: int, denominator: int) -> arb:
        return arb(fmpq(numerator, denominator))

    def divide(self, a: Any, b: Any) -> arb:
        if arb(b).contains(0):
            raise ZeroDivisionError("division by what may be zero")
        return arb(a) / arb(b)

    def root(self, square: Any) -> arb:
        if not arb(square) >= 0:
            raise NotExact("the root of what may be negative")
        return arb(square).sqrt()


def real_trials(
    inventory: Inventory, definitions: Lookup, exponents: Mapping[Symbol, Term] = NONE
) -> Iterator[Trial]:
    """Yields small rational points with the real sines and cosines of their angles.

    exponents: the exponent of each symbol that stands for an exponential.
    """
    random = Random(0)
    for entries, count in _STAGES:
        for _ in range(count):
            point = sample(inventory, RationalRing(entries), random, lambda _: random.random() < 0.8)
            with ctx.workprec(PRECISION):
                try:
                    yield _trial(point, inventory, definitions, exponents)
                except (NotExact, ZeroDivisionError):
                    continue


def _trial(
    point: dict[Parameter, Fraction],
    inventory: Inventory,
    definitions: Lookup,
    exponents: Mapping[Symbol, Term],
) -> Trial:
    balls = {p: arb(fmpq(v.numerator, v.denominator)) for p, v in point.items()}
    engine = JetEngine(PointSource(BallRing(), balls), definitions)
    waiting: list[Term] = [*inventory.angles, *inventory.circles.values()]
    known = {p: v for p, v in balls.items() if p.part != "circle" and p.symbol not in exponents}
    waiting += exponents
    while waiting:
        later = []
        for term in waiting:
            order = inventory.orders.get(cast("Symbol", term), 0) if term in exponents else 0
            of = exponents.get(cast("Symbol", term), term)
            try:
                value = JetEngine(PointSource(BallRing(), known), definitions).value(of, order)
            except (KeyError, NotExact):
                later.append(term)
                continue
            x = [arb(array.item()) for array in value.re]
            if term in exponents:
                rates = enumerate(_exponential(x))
                known |= {Parameter(term, "value", k, 0): rate for k, rate in rates}
            else:
                known[Parameter(term, "circle", 0, 0)] = x[0].cos()
                known[Parameter(term, "circle", 0, 1)] = x[0].sin()
        if len(later) == len(waiting):
            raise NotExact("angles of angles")
        waiting = later
    engine = JetEngine(PointSource(BallRing(), known), definitions)
    return Trial(cast("dict[Parameter, Fraction]", known), engine, real=True)


def _exponential(x: Sequence[Any]) -> list[Any]:
    """Returns e^x and its rates from those of x: E⁽ⁿ⁺¹⁾ = Σⱼ C(n, j) x⁽ʲ⁺¹⁾ E⁽ⁿ⁻ʲ⁾."""
    found = [x[0].exp()]
    for n in range(len(x) - 1):
        found.append(sum(comb(n, j) * x[j + 1] * found[n - j] for j in range(n + 1)))
    return found


def surely_differ(trial: Trial, relation: Relation) -> bool:
    """True if some component of left − right is certainly not 0."""
    with ctx.workprec(PRECISION):
        differences = trial.differences(relation)
    return differences is not None and any(not arb(cast(arb, d)).contains(0) for d in differences)
