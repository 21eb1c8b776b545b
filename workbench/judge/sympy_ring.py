"""SymPy's sparse polynomials on Python integers as a ring of the second engine; denominators kept apart."""

from __future__ import annotations

import os
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

os.environ.setdefault("SYMPY_GROUND_TYPES", "python")

from sympy import integer_nthroot
from sympy.polys.domains import QQ
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyElement
from sympy.polys.rings import ring as polynomial_ring

from workbench.judge.inventory import Inventory, Lookup, NotExact
from workbench.judge.jets import JetEngine
from workbench.judge.parameters import SPHERES, Parameter, parameters
from workbench.judge.rings import PointSource
from workbench.language.terms import Relation


class Ratio:
    """numerator / Π denominatorᵢ^eᵢ. Denominators are monic polynomials, known by their place in the ring's
    list, and never cancelled: equality needs no greatest common divisor."""

    __slots__ = ("below", "ring", "top")

    def __init__(self, ring: SympyRing, top: PolyElement, below: dict[int, int]) -> None:
        self.ring, self.top, self.below = ring, top, below

    def __add__(self, other: Any) -> Ratio:
        other = self.ring.lift(other)
        if self.below == other.below:
            return Ratio(self.ring, self.top + other.top, self.below)
        common = {k: max(self.below.get(k, 0), other.below.get(k, 0)) for k in {*self.below, *other.below}}
        return Ratio(self.ring, self._raised(common) + other._raised(common), common)

    __radd__ = __add__

    def _raised(self, common: dict[int, int]) -> PolyElement:
        top = self.top
        for place, exponent in common.items():
            top = top * self.ring.denominators[place] ** (exponent - self.below.get(place, 0))
        return self.ring.normal(top)

    def __neg__(self) -> Ratio:
        return Ratio(self.ring, -self.top, self.below)

    def __sub__(self, other: Any) -> Ratio:
        return self + -self.ring.lift(other)

    def __rsub__(self, other: Any) -> Ratio:
        return -self + other

    def __mul__(self, other: Any) -> Ratio:
        if isinstance(other, int):
            return Ratio(self.ring, self.top * other, self.below)
        other = self.ring.lift(other)
        below = dict(self.below)
        for place, exponent in other.below.items():
            below[place] = below.get(place, 0) + exponent
        return Ratio(self.ring, self.ring.normal(self.top * other.top), below)

    __rmul__ = __mul__

    def __eq__(self, other: object) -> bool:
        return not (self - other).top

    __hash__ = None

    def __bool__(self) -> bool:
        return bool(self.top)


class SympyRing:
    """Indeterminates for all parameters of an inventory, ranked so that the relations rewrite squares."""

    def __init__(self, inventory: Inventory) -> None:
        names = list(parameters(inventory))
        self._roots = inventory.norms
        first = {"circle": 1, "unit": 0, "quaternion": 0}
        names.sort(key=lambda p: first.get(p.part) != p.component)
        symbols = [f"n{i}" for i in reversed(range(self._roots))] + [f"y{i}" for i in range(len(names))]
        self.polynomials, *generators = (
            polynomial_ring(symbols, QQ, lex) if symbols else polynomial_ring("y", QQ, lex)
        )
        self._root_generators = generators[: self._roots][::-1]
        self._root_squares: list[PolyElement] = []
        bases = dict(zip(names, generators[self._roots :], strict=False))
        self.denominators: list[PolyElement] = []
        self.relations: list[PolyElement] = []
        self.point = {p: Ratio(self, g, {}) for p, g in bases.items()}
        for parameter in names:
            if first.get(parameter.part) == parameter.component:
                self._relate(parameter, bases)

    def _relate(self, squared: Parameter, bases: dict[Parameter, PolyElement]) -> None:
        sphere = [
            bases[Parameter(squared.symbol, squared.part, 0, i)] ** 2 for i in range(SPHERES[squared.part])
        ]
        self.relations.append(sum(sphere[1:], sphere[0]) - 1)

    def lift(self, value: Any) -> Ratio:
        if isinstance(value, Ratio):
            return value
        value = Fraction(value)
        return self.constant(value.numerator, value.denominator)

    def constant(self, numerator: int, denominator: int) -> Ratio:
        return Ratio(self, self.polynomials.ground_new(QQ(numerator, denominator)), {})

    def normal(self, p: PolyElement) -> PolyElement:
        """The remainder by the relations, which are a Gröbner basis (see `differential_ring.py`)."""
        return p.rem(self.relations) if self.relations else p

    def divide(self, a: Any, b: Any) -> Ratio:
        a, b = self.lift(a), self.lift(b)
        if not b:
            raise ZeroDivisionError("division by an expression that is identically zero")
        upside_down = self.constant(1, 1)
        for place, exponent in b.below.items():
            upside_down = upside_down * Ratio(self, self.denominators[place] ** exponent, {})
        leading = b.top.LC
        monic = b.top.quo_ground(leading)
        if monic == 1:
            inverse = Ratio(self, self.polynomials.ground_new(1 / leading), {})
        else:
            if monic not in self.denominators:
                self.denominators.append(monic)
            place = self.denominators.index(monic)
            inverse = Ratio(self, self.polynomials.ground_new(1 / leading), {place: 1})
        return a * upside_down * inverse

    def root(self, square: Any) -> Ratio:
        square = self.lift(square)
        if square.below:
            raise NotExact("the norm of a quotient")
        if not square:
            raise NotExact("the norm of zero")
        leading = square.top.LC
        outside = leading**0
        if leading > 0 and (exact := integer_nthroot(leading.numerator * leading.denominator, 2))[1]:
            outside = QQ(exact[0], leading.denominator)
        top = square.top.quo_ground(outside**2)
        if top == 1:
            return Ratio(self, self.polynomials.ground_new(outside), {})
        if top not in self._root_squares:
            generator = self._root_generators[len(self._root_squares)]
            self._root_squares.append(top)
            self.relations.insert(0, generator**2 - top)
        generator = self._root_generators[self._root_squares.index(top)]
        return Ratio(self, generator.mul_ground(outside), {})


def recheck(
    relation: Relation, inventory: Inventory, definitions: Lookup, equations: Sequence[Relation] = ()
) -> bool:
    """Whether left − right is 0 here too, where the equations hold."""
    ring = SympyRing(inventory)
    engine = JetEngine(PointSource(ring, ring.point), definitions)
    differences = engine.differences(relation.left, relation.right)
    tops = [ring.normal(ring.lift(d).top) for d in differences]
    if not equations:
        return not any(tops)
    supposed = [ring.lift(d).top for e in equations for d in engine.differences(e.left, e.right)]
    return not any(_eliminated(tops, [p for p in supposed if p], ring))


def _eliminated(tops: list[PolyElement], supposed: list[PolyElement], ring: SympyRing) -> list[PolyElement]:
    """The polynomials where the supposed ones vanish. A supposed one that is linear in an indeterminate, with
    a number as coefficient, is solved for it and put in; by the others the result is divided."""
    bound = {x for relation in ring.relations for x in ring.polynomials.gens if relation.degree(x) > 0}
    divisors = []
    while supposed:
        p = supposed.pop()
        solvable = (
            x for x in ring.polynomials.gens if x not in bound and p.degree(x) == 1 and p.diff(x).is_ground
        )
        x = next(solvable, None)
        if x is None:
            divisors.append(p)
            continue
        value = x - p.quo_ground(p.diff(x).LC)
        tops, supposed, divisors = (
            [q.compose(x, value) if q.degree(x) > 0 else q for q in group]
            for group in (tops, supposed, divisors)
        )
        supposed = [q for q in supposed if q]
    return [top.rem(divisors) if divisors else top for top in tops]


def recheck_division(
    left: Relation, right: Relation, both_ways: bool, inventory: Inventory, definitions: Lookup
) -> bool:
    """Whether each side divides a power of the other (one way only for ⇒), a vector x counting as x·x."""
    ring = SympyRing(inventory)
    engine = JetEngine(PointSource(ring, ring.point), definitions)
    p, q = (_norm_square(ring, engine.differences(r.left, r.right)) for r in (left, right))
    needed = [(p, q), (q, p)] if both_ways else [(q, p) if left.operator == "≠" else (p, q)]
    return all(not q or (p and any(not (q**k).rem([p]) for k in (1, 2, 3, 4))) for p, q in needed)


def recheck_distance(relation: Relation, inventory: Inventory, definitions: Lookup) -> bool:
    """Whether some component of left − right is a number that is not 0, over what was divided by."""
    ring = SympyRing(inventory)
    engine = JetEngine(PointSource(ring, ring.point), definitions)
    tops = [ring.normal(ring.lift(d).top) for d in engine.differences(relation.left, relation.right)]
    return any(top and top.is_ground for top in tops)


def _norm_square(ring: SympyRing, differences: Sequence[Any]) -> PolyElement:
    tops = [ring.normal(ring.lift(d).top) for d in differences]
    return tops[0] if len(tops) == 1 else ring.normal(sum((t * t for t in tops[1:]), tops[0] * tops[0]))
