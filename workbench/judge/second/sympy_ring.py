"""SymPy's sparse polynomials on Python integers as a ring of the second engine; denominators kept apart."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from math import gcd, isqrt, lcm
from typing import Any

from workbench.judge.second.sympy_gate import (
    QQ,
    ZZ,
    PolyElement,
    PolyRing,
    lex,
    polynomial_ring,
    require_python_integers,
)
from workbench.judge.subject.inventory import Inventory, NotExact
from workbench.judge.subject.parameters import SPHERES, Parameter, parameters

#: What this engine is called in the evidence.
METHOD = "SymPy PolyRing on Python integers"


class Ratio:
    """top / (number · Π denominatorᵢ^eᵢ). The coefficients of top are integers, and number is a positive one.
    Denominators are primitive polynomials with a positive leading coefficient, known by their place in the
    ring's list, and never cancelled: equality needs no greatest common divisor of polynomials."""

    __slots__ = ("below", "number", "ring", "top")

    def __init__(self, ring: SympyRing, top: PolyElement, number: int, below: dict[int, int]) -> None:
        if number != 1:
            common = gcd(number, *top.values())
            if common != 1:
                top, number = top.quo_ground(common), number // common
        self.ring, self.top, self.number, self.below = ring, top, number, below

    def __add__(self, other: Any) -> Ratio:
        other = self.ring.lift(other)
        left, right, below = self.top, other.top, self.below
        if below == other.below and not (left and right):
            return self if left else other
        if below != other.below:
            below = {k: max(below.get(k, 0), other.below.get(k, 0)) for k in {*below, *other.below}}
            left, right = self._raised(below), other._raised(below)
        number = lcm(self.number, other.number)
        if number != self.number:
            left = left * (number // self.number)
        if number != other.number:
            right = right * (number // other.number)
        return Ratio(self.ring, left + right, number, below)

    __radd__ = __add__

    def _raised(self, common: dict[int, int]) -> PolyElement:
        top = self.top
        for place, exponent in common.items():
            top = top * self.ring.denominators[place] ** (exponent - self.below.get(place, 0))
        return self.ring.normal(top)

    def __neg__(self) -> Ratio:
        return Ratio(self.ring, -self.top, self.number, self.below)

    def __sub__(self, other: Any) -> Ratio:
        return self + -self.ring.lift(other)

    def __rsub__(self, other: Any) -> Ratio:
        return -self + other

    def __mul__(self, other: Any) -> Ratio:
        if isinstance(other, int):
            return Ratio(self.ring, self.top * other, self.number, self.below)
        other = self.ring.lift(other)
        below = {k: self.below.get(k, 0) + other.below.get(k, 0) for k in {*self.below, *other.below}}
        return Ratio(self.ring, self.ring.normal(self.top * other.top), self.number * other.number, below)

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
        self.polynomials, *generators = polynomial_ring(symbols or "y", ZZ, lex)
        self._root_generators = generators[: self._roots][::-1]
        self._root_squares: list[PolyElement] = []  # over the rationals
        bases = dict(zip(names, generators[self._roots :], strict=False))
        self.denominators: list[PolyElement] = []
        self._squares: dict[int, PolyElement] = {}  # what the square of a generator is, by its place
        self.point = {p: Ratio(self, g, 1, {}) for p, g in bases.items()}
        for parameter in names:
            if first.get(parameter.part) == parameter.component:
                self._relate(parameter, bases)

    def _relate(self, squared: Parameter, bases: dict[Parameter, PolyElement]) -> None:
        others = [i for i in range(SPHERES[squared.part]) if i != squared.component]
        rest = sum(bases[Parameter(squared.symbol, squared.part, 0, i)] ** 2 for i in others)
        self._square(bases[squared], 1 - rest)

    def _square(self, generator: PolyElement, square: PolyElement) -> None:
        """Has generator² rewritten as the square, where only generators ranked below it occur."""
        self._squares[self.polynomials.gens.index(generator)] = square

    @property
    def relations(self) -> list[PolyElement]:
        """What vanishes: generator² − square, by falling rank of the generators."""
        generators = self.polynomials.gens
        return [generators[place] ** 2 - self._squares[place] for place in sorted(self._squares)]

    @cached_property
    def rationals(self) -> PolyRing:
        """The polynomials in the same indeterminates over ℚ, for what divides."""
        return self.polynomials.clone(domain=QQ)

    def over_rationals(self, polynomials: Sequence[PolyElement]) -> list[PolyElement]:
        """Polynomials with integer coefficients as members of `rationals`."""
        converted = [p.set_ring(self.rationals) for p in polynomials]
        require_python_integers(*converted)
        return converted

    def lift(self, value: Any) -> Ratio:
        if isinstance(value, Ratio):
            return value
        value = Fraction(value)
        return self.constant(value.numerator, value.denominator)

    def constant(self, numerator: int, denominator: int) -> Ratio:
        value = Fraction(numerator, denominator)
        return Ratio(self, self.polynomials.ground_new(ZZ(value.numerator)), value.denominator, {})

    def normal(self, p: PolyElement) -> PolyElement:
        """The remainder by the relations, which are a Gröbner basis (see `differential_ring.py`): squares are
        rewritten from the highest rank down."""
        for place in sorted(self._squares):
            p = rewritten(p, place, 2, self._squares[place].set_ring(p.ring))
        return p

    def tops(self, values: Sequence[Any]) -> list[PolyElement]:
        """The numerators, in normal form. Raises RuntimeError if anything here is no number of Python's."""
        tops = [self.normal(self.lift(value).top) for value in values]
        require_python_integers(*tops, *self.relations, *self.denominators)
        return tops

    def divide(self, a: Any, b: Any) -> Ratio:
        a, b = self.lift(a), self.lift(b)
        if not b:
            raise ZeroDivisionError("division by an expression that is identically zero")
        content = gcd(*b.top.values()) if b.top.LC > 0 else -gcd(*b.top.values())
        quotient = a * self.constant(b.number, content)
        for place, exponent in b.below.items():
            quotient = quotient * Ratio(self, self.denominators[place] ** exponent, 1, {})
        primitive = b.top.quo_ground(content)
        if primitive == 1:
            return quotient
        if primitive not in self.denominators:
            self.denominators.append(primitive)
        return quotient * Ratio(self, self.polynomials.one, 1, {self.denominators.index(primitive): 1})

    def root(self, square: Any) -> Ratio:
        square = self.lift(square)
        if square.below:
            raise NotExact("the norm of a quotient")
        if not square:
            raise NotExact("the norm of zero")
        (top,) = self.over_rationals([square.top])
        top = top.quo_ground(QQ(square.number))
        leading = top.LC
        outside = QQ(isqrt(abs(leading.numerator * leading.denominator)), leading.denominator)
        outside = outside if outside**2 == leading else QQ(1)
        root = self.constant(outside.numerator, outside.denominator)
        top = top.quo_ground(outside**2)
        for base, power in self._split(top):
            for _ in range(power):
                root = root * self._root_of(base)
        return root

    def _root_of(self, square: PolyElement) -> Ratio:
        """With d for the common denominator: the root of d² · square, an indeterminate, over d."""
        below = lcm(*(c.denominator for c in square.coeffs()))
        if square not in self._root_squares:
            whole = {powers: int(c * below**2) for powers, c in square.terms()}
            self._square(self._root_generators[len(self._root_squares)], self.polynomials.from_dict(whole))
            self._root_squares.append(square)
        return Ratio(self, self._root_generators[self._root_squares.index(square)], below, {})

    def is_made_of_sizes(self, p: PolyElement) -> bool:
        """Whether each monomial is a product of squares and of roots, and so is nowhere negative."""
        return not any(power % 2 for powers in p for power in powers[self._roots :])

    def _split(self, square: PolyElement) -> list[tuple[PolyElement, int]]:
        """The factors of a square that are nowhere negative, with their powers; itself where one may be."""
        if square.LC != 1 or not _is_nowhere_negative(square):
            return [(square, 1)]
        monic = [(p.quo_ground(p.LC), power) for p, power in square.factor_list()[1]]
        if any(power % 2 and not _is_nowhere_negative(p) for p, power in monic):
            return [(square, 1)]
        bases = [(p, k) if _is_nowhere_negative(p) else (p * p, k // 2) for p, k in monic]
        more = sum(p not in self._root_squares for p, _ in bases)
        return bases if len(self._root_squares) + more <= self._roots else [(square, 1)]


def rewritten(p: PolyElement, place: int, power: int, value: PolyElement) -> PolyElement:
    """p with each x^power replaced by the value, x being the indeterminate at that place."""
    if not any(powers[place] >= power for powers in p):
        return p
    parts: dict[int, dict[tuple[int, ...], Any]] = {0: {}}
    for powers, coefficient in p.items():
        if powers[place] >= power:
            times, left = divmod(powers[place], power)
            powers = (*powers[:place], left, *powers[place + 1 :])
            parts.setdefault(times, {})[powers] = coefficient
        else:
            parts[0][powers] = coefficient
    total = p.ring.zero
    for times in range(max(parts), -1, -1):
        total = total * value + p.new(parts.get(times, ()))
    return total


def _is_nowhere_negative(p: PolyElement) -> bool:
    """Whether it is seen so: even powers with positive coefficients."""
    return all(c > 0 and not any(e % 2 for e in powers) for powers, c in p.terms())
