"""Verification of a relation by the jet engine over SymPy: equality, perhaps under assumptions."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property, reduce
from typing import NamedTuple, TypeAlias

from workbench.core.terms import Relation
from workbench.engines.inventory.assumptions import Assumptions
from workbench.engines.jet.sympy_engine import SympyEngine
from workbench.engines.jet.sympy_gate import PolyElement, grevlex, groebner, require_python_integers
from workbench.engines.jet.sympy_ring import SympyRing

#: A polynomial and the positions of its indeterminates. Most are substituted into polynomials without them.
Placed: TypeAlias = "tuple[PolyElement, set[int]]"

#: Number of squarings to test whether a power vanishes, and the largest number of terms of a polynomial to
#: square.
_SQUARINGS, _LONGEST = 4, 40
#: Polynomials with more terms are not factored.
_SHORT = 8


def recheck(relation: Relation, engine: SympyEngine, assumptions: Assumptions) -> bool:
    """True if left − right is 0 under the assumptions in this engine, too."""
    ring, tops = engine.ring, engine.residuals(relation)
    if not assumptions.equations:
        return not any(tops)
    supposed, apart = (
        [ring.over_rationals(engine.residuals(r)) for r in relations]
        for relations in (assumptions.equations, assumptions.nonzero)
    )
    zeros = [p for tops in supposed for p in tops if p]
    divided_by = [
        (ring.over_rationals([ring.denominators[place]])[0], exponent)
        for place, exponent in _divided_by(engine, assumptions.equations).items()
    ]
    elsewhere = [*((_square(ring, tops), 1) for tops in apart), *divided_by]
    return _Supposed(ring, zeros, elsewhere).imply(ring.over_rationals(tops))


def _divided_by(engine: SympyEngine, premises: Iterable[Relation]) -> dict[int, int]:
    """Returns the positions of the denominators in the premises, which are therefore not 0, with their
    powers."""
    ring = engine.ring
    powers: dict[int, int] = {}
    for premise in premises:
        for value in engine.differences(premise.left, premise.right):
            for place, exponent in ring.lift(value).below.items():
                powers[place] = max(exponent, powers.get(place, 0))
    return powers


def recheck_distance(relation: Relation, engine: SympyEngine) -> bool:
    """True if some component of left − right is a non-zero number over the denominators."""
    return any(top and top.is_ground for top in engine.residuals(relation))


class _Solved(NamedTuple):
    """The solution value/over of an indeterminate, given by its position; over: None for 1."""

    place: int
    value: PolyElement
    over: PolyElement | None = None


class _Supposed:
    """Polynomials that vanish, and others that do not.

    A polynomial that is linear in an indeterminate is solved for it and substituted, if the coefficient is a
    number or a product of factors that do not vanish. The remaining ones get a Gröbner basis. elsewhere: the
    factors that do not vanish, with the powers in which they divide.
    """

    def __init__(
        self, ring: SympyRing, zeros: list[PolyElement], elsewhere: Sequence[tuple[PolyElement, int]]
    ) -> None:
        self._ring, self._polynomials = ring, ring.polynomials
        self._elsewhere = [p for p, exponent in elsewhere for _ in range(exponent)]
        self._apart = self._factors_of(p for p, _ in elsewhere)
        self._values: list[_Solved] = []
        bound = {place for relation in ring.relations for place in self._polynomials.places(relation)}
        rest = self._placed(zeros)
        for solve in (self._by_number, self._by_what_is_apart, self._by_number):
            pending, rest = rest, []
            while pending:
                p, holds = pending.pop()
                solved = solve(p, sorted(holds - bound))
                if solved is None:
                    rest.append((p, holds))
                    continue
                self._values.append(solved)
                pending, rest = (
                    [pair for pair in self._with_value(group, solved) if pair[0]] for group in (pending, rest)
                )
        self._divisors = [self._polynomials.spread(p, self._polynomials.many) for p, _ in rest]

    def _by_number(self, p: PolyElement, places: Sequence[int]) -> _Solved | None:
        """Returns the solution of p = 0 for the first indeterminate that occurs in p only in a term c · x,
        else None."""
        place = next((place for place in places if self._polynomials.is_alone(place, p)), None)
        if place is None:
            return None
        (x,) = self._ring.over_rationals([self._polynomials.generators[place]])
        return _Solved(place, x - p.quo_ground(p.coeff(x)))

    def _by_what_is_apart(self, p: PolyElement, places: Sequence[int]) -> _Solved | None:
        """Returns the solution for the first indeterminate whose coefficient is a product of non-vanishing
        factors."""
        for place in places:
            slope = self._polynomials.slope(p, place)
            if slope is not None and self._is_apart(slope):
                (x,) = self._ring.over_rationals([self._polynomials.generators[place]])
                return _Solved(place, self._polynomials.checked(slope * x) - p, slope)
        return None

    def _is_apart(self, p: PolyElement) -> bool:
        left = self._polynomials.spread(p, self._polynomials.many)
        for factor in self._apart:
            (quotient,), remainder = left.div([factor])
            while not remainder:
                left = quotient
                (quotient,), remainder = left.div([factor])
        return bool(left.is_ground)

    def _factors_of(self, polynomials: Iterable[PolyElement]) -> list[PolyElement]:
        """Returns the non-constant factors of short polynomials; longer polynomials unchanged."""
        found: list[PolyElement] = []
        for p in polynomials:
            known = self._polynomials.factors(p) if len(p) <= _SHORT else [(p, 1)]
            found += [self._polynomials.spread(q, self._polynomials.many) for q, _ in known]
        return [factor for factor in found if not factor.is_ground]

    def imply(self, tops: Sequence[PolyElement]) -> bool:
        """True if all polynomials vanish, or the sum of the squares of those not yet shown to vanish does."""
        left = [p for p in tops if not self._vanishes(p)]
        return not left or (len(left) > 1 and self._vanishes(_square(self._ring, left)))

    def _vanishes(self, p: PolyElement) -> bool:
        """True if a power of p, or of p times the non-vanishing factors, is in the ideal.

        If p = x − y and no term of x and y is ever negative, p (x + y) is tested, too. The unfactored
        divisors are tried first because they are cheaper.
        """
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
        for solved in self._values:
            group = self._with_value(group, solved)
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
        """Returns each polynomial with the positions of its indeterminates. Most indeterminates are
        substituted into polynomials without them."""
        return [(p, self._polynomials.places(p)) for p in polynomials]

    def _with_value(self, group: Iterable[Placed], solved: _Solved) -> list[Placed]:
        found: list[Placed] = []
        for p, places in group:
            if solved.place in places:
                found += self._placed(
                    [self._polynomials.rewritten(p, solved.place, 1, solved.value, solved.over)]
                )
            else:
                found.append((p, places))
        return found


def _square(ring: SympyRing, tops: Sequence[PolyElement]) -> PolyElement:
    return ring.normal(sum((t * t for t in tops[1:]), tops[0] * tops[0]))
