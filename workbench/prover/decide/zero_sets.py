"""Zero sets of polynomials: factors that must not vanish, and consequences of equations."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from math import prod
from typing import NamedTuple

from workbench.algebra.differential_ring import Polynomial
from workbench.core.terms import Relation
from workbench.engines.polynomial.polynomial_engine import ExactEngine
from workbench.prover.decide.ideals import Ideal, has_even_powers, is_nowhere_zero


def factors_of(engine: ExactEngine, p: Polynomial) -> list[Polynomial]:
    """Returns irreducible polynomials without reciprocals, one of which vanishes where p does and p is
    defined.

    A norm vanishes where its square does.
    """
    factors = []
    for factor, _ in engine.ring.reduce(engine.ring.clear(p)).factor()[1]:
        square = engine.ring.square_of(factor)
        factors += [factor] if square == factor else factors_of(engine, square)
    return factors


def _places(p: Polynomial) -> set[int]:
    return {place for place, degree in enumerate(p.degrees()) if degree > 0}


class Pivot(NamedTuple):
    """A generator, its position in the ring, and its value where the equations hold."""

    place: int
    generator: Polynomial
    value: Polynomial


#: Number of squarings of a polynomial that may vanish, and the largest number of terms of the square.
_SQUARINGS, _LONGEST = 4, 400

#: Products of terms in the squares of the components of a vector, which are added; more take long to divide.
_LONGEST_SUM = 10_000


class Equations:
    """The zeros of some polynomials at which others, `nonzero`, do not vanish.

    A polynomial c·x + r with a number c and no x in r vanishes where x = −r/c, so x is replaced by that
    everywhere (`solved`). A polynomial vanishes with the others if it, or a power of it, is in their ideal,
    or its product with a non-vanishing polynomial is.
    """

    def __init__(
        self, engine: ExactEngine, solved: list[Pivot], rest: list[Polynomial], nonzero: list[Polynomial]
    ) -> None:
        self.solved = solved
        self._engine, self._ring = engine, engine.ring
        self.rest, self._nonzero = rest, nonzero

    def gaps(self) -> list[Polynomial]:
        """The irreducible factors of the denominators that may vanish."""
        return self._not_excluded(self._ring.denominators)

    def limits(self) -> list[Polynomial]:
        """The factors of denominators at whose zeros the quotients are limits, as sin x / x is at 0.

        Only denominators with generators that the equations constrain count: for these, values near such a
        point do not determine the value at it.
        """
        bound = self._bound()
        return self._not_excluded([p for p in self._ring.limits if not bound.isdisjoint(_places(p))])

    def _bound(self) -> set[int]:
        """Returns the generators that the equations constrain, and those that relations connect with them."""
        said = [{pivot.place, *_places(pivot.value)} for pivot in self.solved]
        bound = set().union(*said, *map(_places, self.rest))
        tied = [_places(relation) for relation in self._ring.relations]
        while more := [places for places in tied if not bound.isdisjoint(places) and not places <= bound]:
            bound = bound.union(*more)
        return bound

    def _not_excluded(self, denominators: Sequence[Polynomial]) -> list[Polynomial]:
        """Returns the factors of the denominators that may vanish.

        p ≠ 0 excludes the zeros of every factor of p. A factor that is a positive number plus a sum of
        squares of monomials has no real zero; the number may be replaced by the square of a non-vanishing
        generator.
        """
        engine = self._engine
        apart = {place for p in self._apart if len(p) == 1 for place in _places(p)}
        gaps = [
            factor
            for denominator in denominators
            for factor in factors_of(engine, denominator)
            if factor not in self._apart
            and not any(is_nowhere_zero(p, engine.norm_places, apart) for p in self._by_sines(factor))
        ]
        supposed = self.solved or self.rest
        return [factor for factor in gaps if not supposed or not self._excludes(factor)]

    def _by_sines(self, p: Polynomial) -> Iterator[Polynomial]:
        """Yields the polynomial, and its forms with x² for 1 − y² in one circle or in all: m + k − k c² is m
        + k s²."""
        yield p
        every = p
        for relation in self._ring.relations:
            places = _places(relation)
            generators = relation.context().gens()
            if len(places) == 2 and relation == sum(generators[place] ** 2 for place in places) - 1:
                (squared,) = (at for at in places if self._ring.names[at] in self._ring.square_names)
                (other,) = places - {squared}
                if p.degrees()[other] > 1:
                    yield _with_square(p, other, 1 - generators[squared] ** 2)
                    every = _with_square(every, other, 1 - generators[squared] ** 2)
        yield every

    @cached_property
    def _apart(self) -> list[Polynomial]:
        """The irreducible factors of the non-vanishing polynomials."""
        return [factor for p in self._nonzero for factor in factors_of(self._engine, p)]

    def imply(self, residuals: Sequence[Polynomial]) -> bool:
        """True if all residuals vanish where the equations hold; components of a vector vanish where its
        square does."""
        left = [p for p in residuals if not self._vanishes(p)]
        if len(left) < 2 or sum(len(p) ** 2 for p in left) > _LONGEST_SUM:
            return not left
        return self._vanishes(sum((p * p for p in left), self._ring.zero))

    def _excludes(self, p: Polynomial) -> bool:
        """True if p is nowhere 0 where the equations hold."""
        together = Ideal(self._ring.names, [*self.rest, *self._ring.relations, self._without_solved(p)])
        return any(together.holds(self._without_solved(q)) for q in (self._ring.one, *self._nonzero))

    def _vanishes(self, p: Polynomial) -> bool:
        p = self._without_solved(self._ring.reduce(p))
        if not p or self._power_vanishes(p):
            return True
        factors = [prod(self._nonzero)] if self._nonzero else []
        return any(self._power_vanishes(self._without_solved(p * f)) for f in (*factors, *self._sizes(p)))

    def _power_vanishes(self, p: Polynomial) -> bool:
        for _ in range(_SQUARINGS):
            p = self._ring.reduce(p)
            if self._ideal.holds(p):
                return True
            if len(p) ** 2 > _LONGEST:
                break
            p = p * p
        return False

    def _sizes(self, p: Polynomial) -> Iterator[Polynomial]:
        """Yields x + y for p = x − y if neither is negative: it is 0 only where p is."""
        if has_even_powers(p, self._engine.norm_places):
            yield p.context().from_dict({exponents: abs(c) for exponents, c in p.terms()})

    def _without_solved(self, p: Polynomial) -> Polynomial:
        spread = _Spread(p)
        for pivot in self.solved:
            spread = spread.replaced(pivot)
        return spread.polynomial

    @cached_property
    def _ideal(self) -> Ideal:
        return Ideal(self._ring.names, [*self.rest, *self._ring.relations])


def _with_square(p: Polynomial, place: int, square: Polynomial) -> Polynomial:
    """Returns p with the square of the generator at that position replaced."""
    context, found = p.context(), p.context().constant(0)
    for exponents, coefficient in p.terms():
        half, odd = divmod(exponents[place], 2)
        bare = (*exponents[:place], odd, *exponents[place + 1 :])
        found += context.from_dict({bare: coefficient}) * square**half
    return found


class _Spread:
    """A polynomial and the positions of its generators. Most are substituted into polynomials without
    them."""

    def __init__(self, polynomial: Polynomial) -> None:
        self.polynomial = polynomial
        self.places = _places(polynomial)

    def replaced(self, pivot: Pivot) -> _Spread:
        if pivot.place not in self.places:
            return self
        context = self.polynomial.context()
        images = list(context.gens())
        images[pivot.place] = pivot.value
        return _Spread(self.polynomial.compose(*images, ctx=context))


def solve(engine: ExactEngine, equations: Sequence[Relation], nonzero: list[Polynomial]) -> Equations:
    """Returns the equations' residuals, solved one after the other as far as possible."""
    pending = [_Spread(_square_free(p)) for e in equations for p in engine.residuals(e) if p]
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
            [q for q in (p.replaced(pivot) for p in group) if q.polynomial] for group in (pending, rest)
        )
    return Equations(engine, solved, [p.polynomial for p in rest], nonzero)


def _square_free(p: Polynomial) -> Polynomial:
    """Returns the product of the distinct factors, which vanishes where p does."""
    return prod((factor for factor, _ in p.factor_squarefree()[1]), start=p.context().constant(1))


def _pivot(engine: ExactEngine, p: Polynomial) -> Pivot | None:
    """Returns the first generator x of p = c x + …, c a number, that has no square relation and occurs in no
    other term; else None."""
    for place, name in enumerate(engine.ring.names):
        slope = p.derivative(place)
        if slope.is_constant() and slope and name not in engine.ring.squared:
            x = p.context().gens()[place]
            return Pivot(place, x, x - p / slope.leading_coefficient())
    return None
