"""What the second engine sees of a relation: that its sides are the same, perhaps where others hold."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from functools import cached_property
from math import prod
from typing import TypeAlias

from workbench.judge.second.jets import JetEngine
from workbench.judge.second.rings import PointSource
from workbench.judge.second.sympy_gate import PolyElement, grevlex, groebner, require_python_integers
from workbench.judge.second.sympy_ring import SympyRing, rewritten
from workbench.judge.subject.assumptions import Assumptions
from workbench.judge.subject.inventory import Inventory, Lookup
from workbench.language.typed.terms import Relation

#: A polynomial, and the places of the indeterminates in it: most are put into polynomials without them.
Spread: TypeAlias = "tuple[PolyElement, set[int]]"

#: How often something is squared to see whether a power of it vanishes, and how many terms it may have.
_SQUARINGS, _LONGEST = 4, 40


def recheck(relation: Relation, inventory: Inventory, definitions: Lookup, assumptions: Assumptions) -> bool:
    """Whether left − right is 0 here too, where the assumptions hold."""
    ring = SympyRing(inventory)
    engine = JetEngine(PointSource(ring, ring.point), definitions)
    tops = ring.tops(engine.differences(relation.left, relation.right))
    if not assumptions.equations:
        return not any(tops)
    supposed, apart = (
        [ring.over_rationals(ring.tops(engine.differences(r.left, r.right))) for r in relations]
        for relations in (assumptions.equations, assumptions.nonzero)
    )
    zeros = [p for tops in supposed for p in tops if p]
    elsewhere = [_square(ring, tops) for tops in apart]
    return _Supposed(ring, zeros, elsewhere).imply(ring.over_rationals(tops))


def recheck_distance(relation: Relation, inventory: Inventory, definitions: Lookup) -> bool:
    """Whether some component of left − right is a number that is not 0, over what was divided by."""
    ring = SympyRing(inventory)
    engine = JetEngine(PointSource(ring, ring.point), definitions)
    tops = ring.tops(engine.differences(relation.left, relation.right))
    return any(top and top.is_ground for top in tops)


class _Supposed:
    """Polynomials that vanish, where others do not. One that is linear in an indeterminate, with a number as
    coefficient, is solved for it and put in; of the others there is a Gröbner basis."""

    def __init__(self, ring: SympyRing, zeros: list[PolyElement], elsewhere: list[PolyElement]) -> None:
        self._ring, self._elsewhere = ring, elsewhere
        self._values: list[tuple[int, PolyElement]] = []
        bound = {place for r in ring.relations for powers in r for place, power in enumerate(powers) if power}
        pending, divisors = _spread(zeros), []
        while pending:
            p, holds = pending.pop()
            place = _solvable(p, bound)
            if place is None:
                divisors.append((p, holds))
                continue
            x = ring.rationals.gens[place]
            self._values.append((place, x - p.quo_ground(p.coeff(x))))
            pending, divisors = (
                [pair for pair in _with_value(group, *self._values[-1]) if pair[0]]
                for group in (pending, divisors)
            )
        self._divisors = [p for p, _ in divisors]

    def imply(self, tops: Sequence[PolyElement]) -> bool:
        """Whether all vanish, or the sum of the squares of those that are not seen to."""
        left = [p for p in tops if not self._vanishes(p)]
        return not left or (len(left) > 1 and self._vanishes(_square(self._ring, left)))

    def _vanishes(self, p: PolyElement) -> bool:
        """Whether a power is in the ideal: of p, of p times what is not 0, or, where p = x − y and no term of
        x and y is ever negative, of p (x + y). What the divisors show as they are is seen sooner."""
        factors = [p.ring.one, *([prod(self._elsewhere)] if self._elsewhere else [])]
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

    def _remainder(self, p: PolyElement, by: Sequence[PolyElement]) -> PolyElement:
        group = _spread([p])
        for place, value in self._values:
            group = _with_value(group, place, value)
        p = self._ring.normal(group[0][0])
        return p.set_ring(by[0].ring).rem(by).set_ring(p.ring) if by else p

    @cached_property
    def _basis(self) -> list[PolyElement]:
        ring = self._ring.rationals.clone(order=grevlex)
        relations = self._ring.over_rationals(self._ring.relations)
        generators = [p.set_ring(ring) for p in (*self._divisors, *relations)]
        basis = groebner(generators, ring) if self._divisors else []
        require_python_integers(*basis)
        return basis


def _square(ring: SympyRing, tops: Sequence[PolyElement]) -> PolyElement:
    return ring.normal(sum((t * t for t in tops[1:]), tops[0] * tops[0]))


def _spread(polynomials: Iterable[PolyElement]) -> list[Spread]:
    """Each with the places of the indeterminates in it: most are put into polynomials without them."""
    return [
        (p, {place for place, powers in enumerate(zip(*p, strict=True)) if any(powers)}) for p in polynomials
    ]


def _with_value(group: Iterable[Spread], place: int, value: PolyElement) -> list[Spread]:
    found: list[Spread] = []
    for p, places in group:
        found += _spread([rewritten(p, place, 1, value)]) if place in places else [(p, places)]
    return found


def _solvable(p: PolyElement, bound: Collection[int]) -> int | None:
    """The place of the first indeterminate, not a bound one, that p holds in no other term than c · x."""
    alone = (powers.index(1) for powers in p if sum(powers) == 1)
    free = (place for place in alone if place not in bound)
    return min((place for place in free if sum(powers[place] > 0 for powers in p) == 1), default=None)
