"""SymPy's sparse polynomials on Python integers as a ring of the jet engine, with separate denominators."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import gcd, isqrt, lcm
from typing import Any

from workbench.engines.inventory import NotExact
from workbench.engines.inventory.inventory import Inventory
from workbench.engines.inventory.parameters import SPHERES, Parameter, parameters
from workbench.engines.jet.packed_polynomials import PackedPolynomials
from workbench.engines.jet.sympy_gate import QQ, ZZ, PolyElement, require_python_integers

#: The name of this engine in the evidence.
METHOD = "SymPy PolyRing on Python integers"


class Ratio:
    """The ratio top / (number · Π denominatorᵢ^eᵢ).

    The coefficients of top are integers, and number is a positive integer. Denominators are primitive
    polynomials with a positive leading coefficient, identified by their index in the ring's list, and never
    cancelled: equality needs no greatest common divisor of polynomials.
    """

    __slots__ = ("below", "number", "ring", "top")

    def __init__(self, ring: SympyRing, top: PolyElement, number: int, below: dict[int, int]) -> None:
        if number != 1:
            common = gcd(number, *top.values())
            if common != 1:
                top, number = top.quo_ground(common), number // common
        self.ring, self.top, self.number, self.below = ring, top, number, below

    def __add__(self, other: Any) -> Any:
        if not other:
            return self
        other = self.ring.lift(other)
        left, right, below = self.top, other.top, self.below
        if below != other.below:
            below = {k: max(below.get(k, 0), other.below.get(k, 0)) for k in {*below, *other.below}}
            left, right = self._raised(below), other._raised(below)
        number = lcm(self.number, other.number)
        if number != self.number:
            left = left * (number // self.number)
        if number != other.number:
            right = right * (number // other.number)
        total = left + right
        return Ratio(self.ring, total, number, below) if total else 0

    __radd__ = __add__

    def _raised(self, common: dict[int, int]) -> PolyElement:
        top = self.top
        for place, exponent in common.items():
            for _ in range(exponent - self.below.get(place, 0)):
                top = self.ring.normal(top * self.ring.denominators[place])
        return top

    def __neg__(self) -> Ratio:
        return Ratio(self.ring, -self.top, self.number, self.below)

    def __sub__(self, other: Any) -> Any:
        return self + -self.ring.lift(other)

    def __rsub__(self, other: Any) -> Any:
        return -self + other

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, int):
            if other in (0, 1):
                return self if other else 0
            return Ratio(self.ring, self.top * other, self.number, self.below)
        other = self.ring.lift(other)
        below = self.below or other.below
        if self.below and other.below:
            below = {k: self.below.get(k, 0) + other.below.get(k, 0) for k in {*self.below, *other.below}}
        top = self.ring.normal(self.top * other.top)
        return Ratio(self.ring, top, self.number * other.number, below) if top else 0

    __rmul__ = __mul__

    def __eq__(self, other: object) -> bool:
        return not self - other

    __hash__ = None  # type: ignore[assignment]  # equal objects may have different types

    def __bool__(self) -> bool:
        return bool(self.top)


class SympyRing:
    """The ring of the parameters' indeterminates and of roots; relations rewrite their squares.

    Indeterminates are created on first use, those of the inventory at once and in its order.
    """

    def __init__(self, inventory: Inventory | None = None) -> None:
        self.polynomials = PackedPolynomials()
        self.normal = self.polynomials.normal
        self._roots: dict[PolyElement, int] = {}  # squares over the rationals → positions of their roots
        self.denominators: list[PolyElement] = []
        self.point = _Indeterminates(self)
        for parameter in () if inventory is None else parameters(inventory):
            self.point[parameter]

    def at(self, place: int) -> Ratio:
        """Returns the indeterminate at a position."""
        return Ratio(self, self.polynomials.generators[place], 1, {})

    @property
    def relations(self) -> list[PolyElement]:
        return self.polynomials.relations

    def over_rationals(self, polynomials: Sequence[PolyElement]) -> list[PolyElement]:
        """Returns polynomials with integer coefficients as polynomials over ℚ, for algorithms that divide by
        numbers."""
        converted = [p.set_ring(self.polynomials.rationals) for p in polynomials]
        require_python_integers(*converted)
        return converted

    def lift(self, value: Any) -> Ratio:
        if isinstance(value, Ratio):
            return value
        value = Fraction(value)
        top = self.polynomials.integers.ground_new(ZZ(value.numerator))
        return Ratio(self, top, value.denominator, {})

    def constant(self, numerator: int, denominator: int) -> Any:
        if denominator == 1:
            return numerator
        value = Fraction(numerator, denominator)
        return value.numerator if value.denominator == 1 else self.lift(value)

    def tops(self, values: Sequence[Any]) -> list[PolyElement]:
        """Returns the numerators in normal form. Raises RuntimeError if a coefficient is not a Python
        number."""
        tops = [self.normal(self.lift(value).top) for value in values]
        require_python_integers(*tops, *self.relations, *self.denominators)
        return tops

    def divide(self, a: Any, b: Any) -> Any:
        a, b = self.lift(a), self.lift(b)
        if not b:
            raise ZeroDivisionError("division by an expression that is identically zero")
        content = gcd(*b.top.values()) if b.top.LC > 0 else -gcd(*b.top.values())
        quotient = a * self.constant(b.number, content)
        for place, exponent in b.below.items():
            for _ in range(exponent):
                quotient = quotient * Ratio(self, self.denominators[place], 1, {})
        primitive = b.top.quo_ground(content)
        if primitive == 1:
            return quotient
        if primitive not in self.denominators:
            self.denominators.append(primitive)
        one = self.polynomials.integers.one
        return quotient * Ratio(self, one, 1, {self.denominators.index(primitive): 1})

    def root(self, square: Any) -> Any:
        square = self.lift(square)
        if square.below:
            return self._root_of_quotient(square)
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

    def _root_of_quotient(self, square: Ratio) -> Any:
        """Returns √(p/d^{2k}) = √p/√(d²)^k; for an odd power of d, p d replaces p."""
        top, sizes = square.top, self.lift(1)
        for place, exponent in square.below.items():
            denominator = self.denominators[place]
            if exponent % 2:
                top = self.normal(top * denominator)
            size = self.root(Ratio(self, self.normal(denominator * denominator), 1, {}))
            for _ in range((exponent + 1) // 2):
                sizes = sizes * size
        return self.divide(self.root(Ratio(self, top, square.number, {})), sizes)

    def _root_of(self, square: PolyElement) -> Any:
        """Returns the root of d² · square, which is an indeterminate, over the common denominator d."""
        below = lcm(*(c.denominator for c in square.coeffs()))
        if square not in self._roots:
            whole = {powers: int(c * below**2) for powers, c in square.terms()}
            self._roots[square] = self.polynomials.make()
            self.polynomials.set_square(self._roots[square], self.polynomials.integers.from_dict(whole))
        return self.at(self._roots[square]) * self.constant(1, below)

    def is_made_of_sizes(self, p: PolyElement) -> bool:
        """True if each monomial is a product of squares and roots, so that p is nowhere negative."""
        return not self.polynomials.odd_places(p) - set(self._roots.values())

    def _split(self, square: PolyElement) -> list[tuple[PolyElement, int]]:
        """Returns the non-negative factors of a square with their powers; the square itself if a factor may
        be negative."""
        if square.LC != 1 or not self._is_nowhere_negative(square):
            return [(square, 1)]
        factors = self.polynomials.factors(square)
        monic = [(p.quo_ground(p.LC), power) for p, power in factors]
        if any(power % 2 and not self._is_nowhere_negative(p) for p, power in monic):
            return [(square, 1)]
        return [
            (p, k) if self._is_nowhere_negative(p) else (self.polynomials.checked(p * p), k // 2)
            for p, k in monic
        ]

    def _is_nowhere_negative(self, p: PolyElement) -> bool:
        """True if all powers are even and all coefficients positive, so that p is nowhere negative."""
        return all(c > 0 for c in p.coeffs()) and not self.polynomials.odd_places(p)


class _Indeterminates(dict[Parameter, Ratio]):
    """The indeterminate of each parameter; those of a sphere are created together."""

    def __init__(self, ring: SympyRing) -> None:
        super().__init__()
        self._ring = ring

    def __missing__(self, parameter: Parameter) -> Ratio:
        part, polynomials = parameter.part, self._ring.polynomials
        if part not in SPHERES:
            self[parameter] = self._ring.at(polynomials.make())
            return self[parameter]
        *others, squared = sorted(range(SPHERES[part]), key=lambda i: i == (part == "circle"))
        places = [polynomials.make() for _ in range(SPHERES[part])]
        for component, place in zip((*others, squared), places, strict=True):
            self[parameter._replace(component=component)] = self._ring.at(place)
        bases = (polynomials.generators[place] for place in places[:-1])
        polynomials.set_square(places[-1], 1 - sum(x * x for x in bases))
        return self[parameter]
