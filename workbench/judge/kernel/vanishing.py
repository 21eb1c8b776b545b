"""Zeros of polynomials: factors that must not vanish, and what equations imply."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import prod
from typing import NamedTuple

from flint import fmpq

from workbench.algebra.differential_ring import Polynomial
from workbench.judge.first.exact import ExactEngine
from workbench.judge.subject.parameters import Parameter
from workbench.language.terms import Relation


def unimplied(engine: ExactEngine, nonzero: Sequence[Relation]) -> list[Polynomial]:
    """The irreducible factors of the denominators that the inequations do not keep from vanishing.

    A scalar p ≠ 0 excludes the zeros of every factor of p; a vector or tensor x ≠ 0 those of x·x. A factor
    that is a positive number plus a sum of squares of monomials has no real zero.
    """
    excluded: list[Polynomial] = []
    for relation in nonzero:
        residuals = engine.residuals(relation)
        if len(residuals) == 1:
            excluded += _factors(engine, residuals[0])
        else:
            square = engine.ring.reduce(sum((r * r for r in residuals), engine.ring.zero))
            excluded += [square, *_factors(engine, square)]
    return [
        factor
        for denominator in engine.ring.denominators
        for factor in _factors(engine, denominator)
        if not any(_proportional(factor, known) for known in excluded) and not _positive(factor)
    ]


def _factors(engine: ExactEngine, p: Polynomial) -> list[Polynomial]:
    """Irreducible polynomials, without reciprocals, one of which vanishes where p does and all that p is made
    of is defined: a norm vanishes where its square does."""
    factors = []
    for factor, _ in engine.ring.reduce(engine.ring.clear(p)).factor()[1]:
        square = engine.ring.square_of(factor)
        factors += [factor] if square == factor else _factors(engine, square)
    return factors


def _proportional(p: Polynomial, q: Polynomial) -> bool:
    return p * q.leading_coefficient() == q * p.leading_coefficient()


def _positive(p: Polynomial) -> bool:
    terms = list(p.terms())
    constant = any(not any(exponents) for exponents, _ in terms)
    even = all(all(e % 2 == 0 for e in exponents) and coefficient > 0 for exponents, coefficient in terms)
    return constant and even


class Pivot(NamedTuple):
    """A generator, its place in the ring, and what it is where the equations hold."""

    place: int
    generator: Polynomial
    value: Polynomial


@dataclass
class Equations:
    """The zeros of some polynomials: those that are solved for one of their generators, and the rest.

    A polynomial c·x + r with a number c and no x in r is zero exactly where x = −r/c, so x can be replaced by
    that everywhere. By a polynomial without such x is divided: that finds some consequences and invents none.
    """

    solved: list[Pivot]
    rest: list[Polynomial]

    def imply(self, p: Polynomial, normal: Callable[[Polynomial], Polynomial]) -> bool:
        """Whether p is seen to vanish where the equations hold: it, or its square, which has the same zeros.
        normal: the normal form modulo the ring's relations."""
        p = self._remainder(p)
        return p == 0 or self._remainder(normal(p * p)) == 0

    def _remainder(self, p: Polynomial) -> Polynomial:
        spread = _Spread(p)
        for pivot in self.solved:
            spread = spread.replaced(pivot)
        p = spread.polynomial
        for divisor in self.rest:
            p = divmod(p, divisor)[1]
        return p


class _Spread:
    """A polynomial and the places of the generators in it: most are put into polynomials without them."""

    def __init__(self, polynomial: Polynomial) -> None:
        self.polynomial = polynomial
        self.places = {place for place, degree in enumerate(polynomial.degrees()) if degree}

    def replaced(self, pivot: Pivot) -> _Spread:
        if pivot.place not in self.places:
            return self
        context = self.polynomial.context()
        images = list(context.gens())
        images[pivot.place] = pivot.value
        return _Spread(self.polynomial.compose(*images, ctx=context))


def solve(engine: ExactEngine, equations: Sequence[Relation]) -> Equations:
    """The equations' residuals, solved one after the other as far as possible."""
    pending = [_Spread(_square_free(p)) for e in equations for p in engine.residuals(e) if p != 0]
    solved: list[Pivot] = []
    rest: list[_Spread] = []
    while pending:
        first = pending.pop(0)
        pivot = _pivot(engine, first.polynomial)
        if pivot is None:
            rest.append(first)
            continue
        solved.append(pivot)
        pending, rest = (
            [q for q in (p.replaced(pivot) for p in group) if q.polynomial != 0] for group in (pending, rest)
        )
    return Equations(solved, [p.polynomial for p in rest])


def _square_free(p: Polynomial) -> Polynomial:
    """The product of its factors: it vanishes where p does."""
    return prod((factor for factor, _ in p.factor_squarefree()[1]), start=p.context().constant(1))


def _pivot(engine: ExactEngine, p: Polynomial) -> Pivot | None:
    squared = engine.ring.squared
    for exponents, coefficient in p.terms():
        places = [place for place, e in enumerate(exponents) if e]
        if len(places) != 1 or exponents[places[0]] != 1:
            continue
        if engine.ring.names[places[0]] in squared or p.degrees()[places[0]] != 1:
            continue
        if p.derivative(places[0]).is_constant():
            generator = p.context().gens()[places[0]]
            return Pivot(places[0], generator, generator - p / coefficient)
    return None


def points_on(
    engine: ExactEngine, p: Polynomial, point: dict[Parameter, Fraction]
) -> Iterator[dict[Parameter, Fraction]]:
    """Points where p vanishes and that differ from the given one in one parameter: its rational roots."""
    values = {engine.name_of(q): fmpq(v.numerator, v.denominator) for q, v in point.items()}
    used = {engine.ring.names[i] for i, degree in enumerate(p.degrees()) if degree > 0}
    for parameter in point:
        name = engine.name_of(parameter)
        if name not in used or name in engine.ring.squared:
            continue
        line = p.subs({other: value for other, value in values.items() if other != name})
        x = engine.ring.generators[name]
        for factor, _ in line.factor()[1]:
            slope = factor.derivative(engine.ring.names.index(name))
            if slope.is_constant() and slope != 0:
                yield {**point, parameter: engine.ring.number(x - factor / slope.leading_coefficient())}
