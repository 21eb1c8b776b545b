"""What the second engine sees of a relation: that its sides are the same, perhaps where others hold."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from functools import cached_property, reduce
from typing import TypeAlias

from workbench.judge.second.sympy_engine import SympyEngine
from workbench.judge.second.sympy_gate import PolyElement, grevlex, groebner, require_python_integers
from workbench.judge.second.sympy_ring import SympyRing
from workbench.judge.subject.assumptions import Assumptions
from workbench.language.typed.terms import Relation

#: A polynomial, and the places of the indeterminates in it: most are put into polynomials without them.
Placed: TypeAlias = "tuple[PolyElement, set[int]]"

#: How often something is squared to see whether a power of it vanishes, and how many terms it may have.
_SQUARINGS, _LONGEST = 4, 40


def recheck(relation: Relation, engine: SympyEngine, assumptions: Assumptions) -> bool:
    """Whether left − right is 0 here too, where the assumptions hold."""
    ring, tops = engine.ring, engine.residuals(relation)
    if not assumptions.equations:
        return not any(tops)
    supposed, apart = (
        [ring.over_rationals(engine.residuals(r)) for r in relations]
        for relations in (assumptions.equations, assumptions.nonzero)
    )
    zeros = [p for tops in supposed for p in tops if p]
    elsewhere = [_square(ring, tops) for tops in apart]
    elsewhere += ring.over_rationals(_divided_by(engine, assumptions.equations))
    return _Supposed(ring, zeros, elsewhere).imply(ring.over_rationals(tops))


def _divided_by(engine: SympyEngine, premises: Iterable[Relation]) -> list[PolyElement]:
    """What is not 0 since the premises divide by it, as often as they do."""
    ring = engine.ring
    powers: dict[int, int] = {}
    for premise in premises:
        for value in engine.differences(premise.left, premise.right):
            for place, exponent in ring.lift(value).below.items():
                powers[place] = max(exponent, powers.get(place, 0))
    return [
        reduce(lambda p, q: ring.normal(p * q), [ring.denominators[place]] * exponent)
        for place, exponent in powers.items()
    ]


def recheck_distance(relation: Relation, engine: SympyEngine) -> bool:
    """Whether some component of left − right is a number that is not 0, over what was divided by."""
    return any(top and top.is_ground for top in engine.residuals(relation))


class _Supposed:
    """Polynomials that vanish, where others do not. One that is linear in an indeterminate, with a number as
    coefficient, is solved for it and put in; of the others there is a Gröbner basis."""

    def __init__(self, ring: SympyRing, zeros: list[PolyElement], elsewhere: list[PolyElement]) -> None:
        self._ring, self._elsewhere, self._polynomials = ring, elsewhere, ring.polynomials
        self._values: list[tuple[int, PolyElement]] = []
        bound = {place for relation in ring.relations for place in self._polynomials.places(relation)}
        pending, divisors = self._placed(zeros), []
        while pending:
            p, holds = pending.pop()
            place = self._solvable(p, holds - bound)
            if place is None:
                divisors.append((p, holds))
                continue
            (x,) = ring.over_rationals([self._polynomials.generators[place]])
            self._values.append((place, x - p.quo_ground(p.coeff(x))))
            pending, divisors = (
                [pair for pair in self._with_value(group, *self._values[-1]) if pair[0]]
                for group in (pending, divisors)
            )
        self._divisors = [self._polynomials.spread(p, self._polynomials.many) for p, _ in divisors]

    def imply(self, tops: Sequence[PolyElement]) -> bool:
        """Whether all vanish, or the sum of the squares of those that are not seen to."""
        left = [p for p in tops if not self._vanishes(p)]
        return not left or (len(left) > 1 and self._vanishes(_square(self._ring, left)))

    def _vanishes(self, p: PolyElement) -> bool:
        """Whether a power is in the ideal: of p, of p times what is not 0, or, where p = x − y and no term of
        x and y is ever negative, of p (x + y). What the divisors show as they are is seen sooner."""
        factors = [p.ring.one, *([reduce(self._product, self._elsewhere)] if self._elsewhere else [])]
        if self._ring.is_made_of_sizes(p):
            factors.append(p.new({powers: abs(c) for powers, c in p.items()}))
        return self._power_vanishes(p, self._divisors) or any(
            self._power_vanishes(p * factor, self._basis) for factor in factors
        )

    def _power_vanishes(self, p: PolyElement, by: Sequence[PolyElement]) -> bool:
        for _ in range(_SQUARINGS):
            p = self._remainder(self._ring.normal(p), by)
            if not p:
                return True
            if len(p) > _LONGEST:
                return False
            p = p * p
        return False

    def _product(self, p: PolyElement, q: PolyElement) -> PolyElement:
        return self._polynomials.checked(p * q)

    def _remainder(self, p: PolyElement, by: Sequence[PolyElement]) -> PolyElement:
        group = self._placed([p])
        for place, value in self._values:
            group = self._with_value(group, place, value)
        p = self._ring.normal(group[0][0])
        return self._polynomials.packed(self._polynomials.spread(p, by[0].ring).rem(by)) if by else p

    @cached_property
    def _basis(self) -> list[PolyElement]:
        ring = self._polynomials.many.clone(order=grevlex)
        relations = [self._polynomials.spread(relation, ring) for relation in self._ring.relations]
        generators = [*(p.set_ring(ring) for p in self._divisors), *relations]
        basis = groebner(generators, ring) if self._divisors else []
        require_python_integers(*basis)
        return basis

    def _placed(self, polynomials: Iterable[PolyElement]) -> list[Placed]:
        """Each with the places of the indeterminates in it: most are put into polynomials without them."""
        return [(p, self._polynomials.places(p)) for p in polynomials]

    def _with_value(self, group: Iterable[Placed], place: int, value: PolyElement) -> list[Placed]:
        found: list[Placed] = []
        for p, places in group:
            if place in places:
                found += self._placed([self._polynomials.rewritten(p, place, 1, value)])
            else:
                found.append((p, places))
        return found

    def _solvable(self, p: PolyElement, places: Collection[int]) -> int | None:
        """The first of these places whose indeterminate p holds in no other term than c · x."""
        return next((place for place in sorted(places) if self._polynomials.is_alone(place, p)), None)


def _square(ring: SympyRing, tops: Sequence[PolyElement]) -> PolyElement:
    return ring.normal(sum((t * t for t in tops[1:]), tops[0] * tops[0]))
