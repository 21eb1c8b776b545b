"""Points with real sines and cosines of their angles, and real functions of scalars, in balls by Arb.

A rational point of the circle belongs to no rational angle except 0. If an angle also occurs outside its
sine, or is a product such as ω t, a claim is refuted at rational values by a ball that excludes 0. So is a
claim about e^x, which is no rational number.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from math import factorial
from random import Random
from typing import Any, cast

from flint import arb, arb_series, ctx, fmpq

from workbench.core.construct import apply
from workbench.core.terms import Head, Relation, Symbol, Term
from workbench.core.types import PI
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.elementary_functions import Value
from workbench.engines.inventory.inventory import Inventory
from workbench.engines.inventory.parameters import Parameter
from workbench.engines.inventory.partial_derivatives import indices
from workbench.engines.jet.jets import JetEngine
from workbench.engines.jet.rings import PointSource, RationalRing, sample
from workbench.prover.counterexamples.matrix_exponential_balls import exponential_at
from workbench.prover.counterexamples.rational_points import Trial

PRECISION = 200
#: The evidence of a difference at such a point, where π is the number.
AT_REAL_POINT = "real balls (Arb)"
NONE: Mapping[Symbol, Value] = {}
_STAGES: tuple[tuple[tuple[Fraction | int, ...], int], ...] = (
    ((-1, 0, 1), 20),
    ((-2, -1, 1, 2, 3), 20),
    (tuple(Fraction(n, 4) for n in (-3, -2, -1, 1, 2, 3)), 20),
)


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
    inventory: Inventory, definitions: Lookup, functions: Mapping[Symbol, Value] = NONE
) -> Iterator[Trial]:
    """Yields small rational points with the real sines and cosines of their angles.

    functions: the function of scalars that a symbol stands for.
    """
    random = Random(0)
    for entries, count in _STAGES:
        for _ in range(count):
            point = sample(inventory, RationalRing(entries), random, lambda _: random.random() < 0.8)
            with ctx.workprec(PRECISION):
                try:
                    yield _trial(point, inventory, definitions, functions)
                except (NotExact, ZeroDivisionError):
                    continue


def _trial(
    point: dict[Parameter, Fraction],
    inventory: Inventory,
    definitions: Lookup,
    functions: Mapping[Symbol, Value],
) -> Trial:
    balls = {p: arb(fmpq(v.numerator, v.denominator)) for p, v in point.items()}
    known = {p: v for p, v in balls.items() if p.part != "circle" and p.symbol not in functions}
    known |= {p: pi for p in known if not p.order and (pi := _part_of_pi(p.symbol)) is not None}
    waiting: list[tuple[Term, bool]] = [
        (angle, False) for angle in (*inventory.angles, *inventory.circles.values())
    ]
    waiting += [(own, True) for own in functions]

    def jets(term: Term, order: int) -> Sequence[Any]:
        return JetEngine(PointSource(BallRing(), known), definitions).value(term, order).re

    def values(term: Term, order: int) -> list[Any]:
        return [arb(array.item()) for array in jets(term, order)]

    while waiting:
        later = []
        for term, is_function in waiting:
            try:
                if is_function:
                    own = cast("Symbol", term)
                    value, order = functions[own], inventory.orders.get(own, 0)
                    if own.type.kind == "scalar":
                        known |= _of_function(own, value, order, known, values)
                    else:
                        known |= exponential_at(own, jets(value.arguments[0], order))
                else:
                    (x,) = values(term, 0)
                    known[Parameter(term, "circle", 0, 0)] = x.cos()
                    known[Parameter(term, "circle", 0, 1)] = x.sin()
            except (KeyError, NotExact):
                later.append((term, is_function))
        if len(later) == len(waiting):
            raise NotExact("angles of angles")
        waiting = later
    engine = JetEngine(PointSource(BallRing(), known), definitions)
    return Trial(cast("dict[Parameter, Fraction]", known), engine, real=True)


def _of_function(
    own: Symbol,
    value: Value,
    order: int,
    known: dict[Parameter, Any],
    values: Callable[[Term, int], list[Any]],
) -> dict[Parameter, Any]:
    """Returns the value of f(u, …) with its rates, or as a function of coordinates with its slopes."""
    if not own.declaration.of:
        rates = _series(value.head, [values(u, order) for u in value.arguments])
        return {Parameter(own, "value", k, 0): rate for k, rate in enumerate(rates)}
    of = own.declaration.of
    if any(each.type.kind != "scalar" for each in of):
        raise NotExact("a function of columns")
    (now,) = _series(value.head, [values(u, 0) for u in value.arguments])
    known[Parameter(own, "value", 0, 0)] = now
    for degree in range(1, order + 1):
        for place, coordinates in enumerate(indices(len(of), degree)):
            first, *more = (of[i] for i in coordinates)
            slope = value.slope(lambda u, by=first: apply("partial", u, by))  # type: ignore[misc]
            for by in more:
                slope = apply("partial", slope, by)
            (known[Parameter(own, f"slope{degree}", 0, place)],) = values(slope, 0)
    return {}


def _series(head: Head, arguments: Sequence[Sequence[Any]]) -> list[Any]:
    """Returns the value of the function and its rates, from those of its arguments."""
    size = len(arguments[0])
    series = [arb_series([x / factorial(k) for k, x in enumerate(jet)], prec=size) for jet in arguments]
    found = list(SERIES[head](*series).coeffs())
    found += [arb(0)] * (size - len(found))
    return [arb(x) * factorial(k) for k, x in enumerate(found[:size])]


def _atan2(y: arb_series, x: arb_series) -> arb_series:
    rate = (x * y.derivative() - y * x.derivative()) / (x * x + y * y)
    return arb_series([arb.atan2(y[0], x[0])], prec=y.prec) + rate.integral()


#: The series of each function from those of its arguments.
SERIES: Mapping[Head, Callable[..., arb_series]] = {
    "exp": arb_series.exp,
    "log": arb_series.log,
    "arcsin": arb_series.asin,
    "arccos": arb_series.acos,
    "arctan": arb_series.atan,
    "atan2": _atan2,
}


def is_pi(term: Term) -> bool:
    return isinstance(term, Symbol) and term.declaration.name == PI.name


def _part_of_pi(own: Term) -> arb | None:
    """Returns the value of π, or of the part π/3 of which the angles of a claim are multiples; else None."""
    whole = own.declaration.name.of if isinstance(own, Symbol) else ()
    if is_pi(own):
        return arb.pi()
    return arb.pi() / whole[1] if whole and is_pi(whole[0]) else None


def surely_positive(trial: Trial, term: Term) -> bool:
    """True if the scalar is certainly > 0."""
    with ctx.workprec(PRECISION):
        values = trial.components(term)
    return values is not None and all(arb(cast(arb, value)) > 0 for value in values)


def surely_differ(trial: Trial, relation: Relation) -> bool:
    """True if some component of left − right is certainly not 0."""
    with ctx.workprec(PRECISION):
        differences = trial.differences(relation)
    return differences is not None and any(not arb(cast(arb, d)).contains(0) for d in differences)


def surely_no_right_angle(trial: Trial, relation: Relation) -> bool:
    """True if left − right of two scalars is certainly no multiple of π/2."""
    with ctx.workprec(PRECISION):
        differences = trial.differences(relation)
        quarters = [arb(cast(arb, d)) * 2 / arb.pi() for d in differences or ()]
        return any(each.is_finite() and not each.contains_integer() for each in quarters)
