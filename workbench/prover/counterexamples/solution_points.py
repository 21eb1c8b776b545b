"""Points where equations between the parameters hold: coordinates are chosen until one is determined.

If the determined coordinate has no rational value, it is a real algebraic number, and the remaining ones are
in its field. These points are only candidates: the jet engine checks whether the equations hold.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import isqrt
from random import Random
from typing import Any

from flint import fmpq, fmpq_poly, fmpz_poly

from workbench.algebra.differential_ring import Polynomial
from workbench.core.terms import Relation
from workbench.engines.inventory.inventory import Inventory
from workbench.engines.inventory.parameters import Parameter
from workbench.engines.jet.number_field import Algebraic, NumberField, NumberFieldRing
from workbench.engines.jet.rings import RationalRing, sample
from workbench.engines.polynomial.polynomial_engine import ExactEngine

#: Values of a chosen coordinate, simple ones more often. Fractions allow points inside a sphere.
CHOICES = tuple(
    map(Fraction, ("0", "0", "1", "1", "-1", "-1", "1/2", "-1/2", "2", "-2", "1/3", "3/5", "4/5"))
)

#: Number of attempts to find a point, with zeros and without.
ATTEMPTS = 80

Terms = dict[tuple[tuple[int, int], ...], Any]  # monomial ((position, exponent), …) → coefficient


def solved_points(
    engine: ExactEngine, equations: Sequence[Relation], inventory: Inventory
) -> Iterator[dict[Parameter, Any]]:
    """Yields points of the parameters at which the equations should hold; unconstrained parameters are
    random. The last ones have few zeros, and common factors are not 0, for assumptions that exclude these.
    """
    wanted = [p for e in equations for p in engine.residuals(e)]
    while more := [q for q in engine.ring.relations if q not in wanted and _meets(q, wanted)]:
        wanted += more
    systems = [_terms(p) for p in wanted]
    random = Random(1)
    yield from _solved(engine, inventory, systems, random, CHOICES, 0.5)
    cleared = [_without_common_factor(p) for p in systems]
    yield from _solved(engine, inventory, cleared, random, tuple(filter(None, CHOICES)), 1.0)


def _solved(
    engine: ExactEngine,
    inventory: Inventory,
    systems: Sequence[Terms],
    random: Random,
    choices: Sequence[Fraction],
    density: float,
) -> Iterator[dict[Parameter, Any]]:
    for _ in range(ATTEMPTS):
        values = _Search(random, choices).solved(systems)
        if values is not None:
            point = sample(inventory, RationalRing(), random, lambda _: random.random() < density)
            known = {engine.ring.names[place]: value for place, value in values.items()}
            yield {p: known.get(engine.name_of(p), value) for p, value in point.items()}


def _meets(relation: Polynomial, others: Sequence[Polynomial]) -> bool:
    """True if the relation shares an indeterminate with one of the others."""
    used = [place for place, degree in enumerate(relation.degrees()) if degree > 0]
    return any(p.degrees()[place] > 0 for p in others for place in used)


class _Search:
    def __init__(self, random: Random, choices: Sequence[Fraction]) -> None:
        self._random, self._choices = random, choices
        self._ring = NumberFieldRing()
        self._field: NumberField | None = None

    def solved(self, systems: Sequence[Terms]) -> dict[int, Any] | None:
        values: dict[int, Any] = {}
        rest = [(p, _places(p)) for p in systems if p]
        while rest:
            system, places = min(rest, key=lambda each: len(each[1]))
            if not places:
                return None
            if len(places) > 1:
                value = self._random.choice(self._choices)
                place = self._chosen(system, places)
            elif roots := self._roots(system):
                (place,), value = places, self._random.choice(roots)
            else:
                return None
            values[place] = value
            reduced = [(_reduced(p, place, value), at) if place in at else (p, at) for p, at in rest]
            rest = [(p, _places(p) if place in at else at) for p, at in reduced if p]
        return values

    def _chosen(self, system: Terms, places: list[int]) -> int:
        """Returns the position of a coordinate to choose, preferably one for which the equation cannot be
        solved."""
        height = {p: max(e for monomial in system for q, e in monomial if q == p) for p in places}
        steep = [p for p in places if height[p] > 1]
        return self._random.choice(steep if steep and len(steep) < len(places) else places)

    def _roots(self, p: Terms) -> list[Any]:
        coefficients: list[Any] = [Fraction(0)] * (1 + max(e for monomial in p for _, e in monomial))
        for monomial, c in p.items():
            coefficients[monomial[0][1] if monomial else 0] = c
        if len(coefficients) == 2:
            return [-self._ring.divide(coefficients[0], coefficients[1])]
        numbers = [c.rational() if isinstance(c, Algebraic) else c for c in coefficients]
        rationals = [number for number in numbers if number is not None]
        return self._real_roots(rationals) if len(rationals) == len(numbers) else []

    def _real_roots(self, coefficients: list[Fraction]) -> list[Any]:
        whole = fmpq_poly([fmpq(c.numerator, c.denominator) for c in coefficients])
        rational, algebraic = [], []
        for factor, _ in whole.numer().factor()[1]:
            parts = [Fraction(int(c)) for c in factor.coeffs()]
            if len(parts) == 2:
                rational.append(-parts[0] / parts[1])
            elif len(parts) == 3:
                algebraic += self._quadratic(*parts)
            elif self._field is None:
                algebraic += self._of_higher_degree(factor, parts)
        return rational or algebraic

    def _quadratic(self, c: Fraction, b: Fraction, a: Fraction) -> list[Any]:
        square = b * b - 4 * a * c
        if square < 0:
            return []
        outside, inside = _split_square(int(square))
        minimal = (Fraction(-inside), Fraction(0), Fraction(1))
        if self._field is None:
            self._field = NumberField(minimal, (Fraction(0), Fraction(inside)))
        if self._field.minimal != minimal:
            return []
        root = self._field.generator * outside
        return [(root - b) * (1 / (2 * a)), (-root - b) * (1 / (2 * a))]

    def _of_higher_degree(self, factor: fmpz_poly, parts: list[Fraction]) -> list[Any]:
        roots: Any = factor.complex_roots()
        for root, _ in roots:
            if root.imag == 0:
                middle, radius = _exact(root.real.mid()), _exact(root.real.rad())
                self._field = NumberField(parts, (middle - radius, middle + radius))
                return [self._field.generator]
        return []


def _exact(real: Any) -> Fraction:
    """Returns a dyadic number of an interval as a fraction."""
    mantissa, exponent = real.man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def _split_square(number: int) -> tuple[int, int]:
    """Returns (p, q) with p² q = number, where p contains all squares of small primes."""
    outside, divisor = 1, 2
    while divisor * divisor <= number and divisor < 1000:
        while number % (divisor * divisor) == 0:
            number //= divisor * divisor
            outside *= divisor
        divisor += 1
    whole = isqrt(number)
    return (outside * whole, 1) if whole * whole == number else (outside, number)


def _terms(p: Polynomial) -> Terms:
    return {
        tuple((place, e) for place, e in enumerate(exponents) if e): Fraction(int(c.p), int(c.q))
        for exponents, c in p.terms()
    }


def _without_common_factor(p: Terms) -> Terms:
    """Returns p / x for an x that is in each of its monomials."""
    common = set.intersection(*(set(dict(monomial)) for monomial in p)) if len(p) > 1 else set()
    least = {place: min(dict(monomial)[place] for monomial in p) for place in common}
    return {
        tuple((q, e - least.get(q, 0)) for q, e in monomial if e > least.get(q, 0)): c
        for monomial, c in p.items()
    }


def _places(p: Terms) -> list[int]:
    return sorted({place for monomial in p for place, _ in monomial})


def _reduced(p: Terms, known: int, value: Any) -> Terms:
    """Returns the polynomial with the value of one coordinate substituted."""
    result: Terms = {}
    powers = [1]
    for monomial, coefficient in p.items():
        exponent = dict(monomial).get(known, 0)
        while len(powers) <= exponent:
            powers.append(powers[-1] * value)
        key = tuple(each for each in monomial if each[0] != known) if exponent else monomial
        term = coefficient * powers[exponent] if exponent else coefficient
        result[key] = result[key] + term if key in result else term
    return {monomial: c for monomial, c in result.items() if c}
