"""Free symbols of the polynomial engine: generators of the ring, their derivatives and their relations."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import partial
from itertools import product as product_of
from typing import Any

from workbench.algebra.differential_ring import Derivation, DifferentialRing, Polynomial
from workbench.algebra.dual import Dual
from workbench.algebra.matrices import Matrix, cross, flat, matrix, product, skew
from workbench.core.codes.engine_codes import EngineCode
from workbench.core.terms import Symbol, Term
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.parameters import Parameter, components
from workbench.engines.inventory.partial_derivatives import coordinate_count, indices
from workbench.engines.polynomial.polynomial_quaternions import hamilton


class FreeSymbols:
    """Sets up a ring with the parameters of the free symbols, which `parameters.py` defines."""

    def __init__(self, ring: DifferentialRing, named: dict[Parameter, str]) -> None:
        self.ring = ring
        self._named = named

    def _generator(self, symbol: Symbol | Term, part: str, order: int, component: int) -> Polynomial | None:
        name = self._named.get(Parameter(symbol, part, order, component))
        return None if name is None else self.ring.generators[name]

    def column(self, symbol: Symbol | Term, part: str, order: int, count: int) -> list[Polynomial]:
        """Returns the parameters of one part and order, or [] if the inventory does not contain them."""
        found = [self._generator(symbol, part, order, i) for i in range(count)]
        known = [each for each in found if each is not None]
        return known if len(known) == count else []

    def place(self, symbol: Symbol, order: int, component: int) -> str:
        """Returns the generator that stands for a component of a derivative."""
        return self._named[Parameter(symbol, "value", order, component)]

    def _shift(self, symbol: Symbol, part: str, count: int) -> list[Polynomial]:
        """Sets each order of the part as the derivative of the previous one; returns order 0."""
        order, first = 0, self.column(symbol, part, 0, count)
        current = first
        while current:
            following = self.column(symbol, part, order + 1, count)
            if symbol.declaration.constant:
                following = [self.ring.zero] * count
            if symbol.declaration.clock:
                following = [self.ring.one]
            for generator, rate in zip(current, following, strict=False):
                self.ring.derive_as(str(generator), rate)
            if symbol.declaration.constant or symbol.declaration.clock:
                break
            current, order = following, order + 1
        return first

    def furnish(self, symbol: Symbol) -> Matrix:
        declaration = symbol.declaration
        if declaration.unit and symbol.type.kind == "quaternion":
            return self._furnish_quaternion(symbol)
        if declaration.unit:
            return self._furnish_unit(symbol)
        if declaration.transform:
            return self._furnish_transform(symbol)
        if declaration.rotation:
            return self._furnish_rotation(symbol)
        entries: list[Any] = self._entries(symbol, "value")
        if symbol.type.dual:
            dual = self._entries(symbol, "dual")
            entries = [Dual(re, du) for re, du in zip(entries, dual, strict=True)]
        return matrix(entries, symbol.type.columns)

    def _entries(self, symbol: Symbol, part: str) -> list[Polynomial]:
        free = self._shift(symbol, part, components(symbol))
        size = symbol.type.rows
        if symbol.declaration.diagonal:
            return [free[i] if i == j else self.ring.zero for i in range(size) for j in range(size)]
        if symbol.declaration.symmetric:
            upper = [(i, j) for i in range(size) for j in range(i, size)]
            return [free[upper.index((min(i, j), max(i, j)))] for i in range(size) for j in range(size)]
        return free

    def _furnish_unit(self, symbol: Symbol) -> Matrix:
        u = self.column(symbol, "unit", 0, 3)
        self.ring.square_as(str(u[0]), self.ring.one - u[1] ** 2 - u[2] ** 2)
        spin = self._shift(symbol, "spin", 3)
        if symbol.declaration.constant:
            spin = [self.ring.zero] * 3
        for generator, rate in zip(u, cross(spin, u) if spin else (), strict=False):
            self.ring.derive_as(str(generator), self.ring.reduce(rate))
        if symbol.type.dual:
            moment = self._shift(symbol, "moment", 3)
            return matrix([Dual(re, du) for re, du in zip(u, cross(moment, u), strict=True)], 1)
        return matrix(u, 1)

    def _furnish_quaternion(self, symbol: Symbol) -> Matrix:
        q = matrix(self._unit_quaternion(symbol), 1)
        if not symbol.type.dual:
            return q
        half = self.ring.constant(Fraction(1, 2))
        shift = matrix([self.ring.zero, *(half * p for p in self._shift(symbol, "translation", 3))], 1)
        pairs = zip(flat(q), flat(hamilton(shift, q)), strict=True)
        return matrix([Dual(re, du) for re, du in pairs], 1)

    def _furnish_transform(self, symbol: Symbol) -> Matrix:
        rotation, place = self._furnish_rotation(symbol), self._shift(symbol, "translation", 3)
        zero, one = self.ring.zero, self.ring.one
        return (*((*row, p) for row, p in zip(rotation, place, strict=True)), (zero, zero, zero, one))

    def _unit_quaternion(self, symbol: Symbol) -> list[Polynomial]:
        q0, *q = (w, x, y, z) = self.column(symbol, "quaternion", 0, 4)
        self.ring.square_as(str(q0), self.ring.one - x**2 - y**2 - z**2)
        spin = self._shift(symbol, "spin", 3)
        if symbol.declaration.constant:
            spin = [self.ring.zero] * 3
        if spin:
            half = self.ring.constant(Fraction(1, 2))
            self.ring.derive_as(
                str(q0), -half * sum((s * c for s, c in zip(spin, q, strict=True)), self.ring.zero)
            )
            for generator, s, turned in zip(q, spin, cross(spin, q), strict=True):
                self.ring.derive_as(str(generator), half * (s * q0 + turned))
        return [w, x, y, z]

    def _furnish_rotation(self, symbol: Symbol) -> Matrix:
        w, x, y, z = self._unit_quaternion(symbol)
        rotation: Matrix = (
            (1 - 2 * (y**2 + z**2), 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), 1 - 2 * (x**2 + z**2), 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x**2 + y**2)),
        )
        if symbol.type.dual:
            moved = product(skew(self._shift(symbol, "translation", 3)), rotation)
            rotation = tuple(
                tuple(Dual(re, du) for re, du in zip(*rows, strict=True))
                for rows in zip(rotation, moved, strict=True)
            )
        return rotation

    def furnish_angle(self, angle: Symbol) -> None:
        value = self._generator(angle, "value", 0, 0)
        self.furnish_circle(angle, lambda: self.ring.zero if value is None else value)

    def furnish_circle(self, angle: Term, value: Callable[[], Polynomial]) -> None:
        """Sets up the cosine and sine of the term with this value."""
        cosine, sine = self.column(angle, "circle", 0, 2)
        self.ring.square_as(str(sine), self.ring.one - cosine**2)
        self.ring.derive_by(str(sine), lambda derivation: cosine * derivation(value()))
        self.ring.derive_by(str(cosine), lambda derivation: -sine * derivation(value()))

    def furnish_function(self, symbol: Symbol, coordinates: Callable[[], list[Polynomial]]) -> Matrix:
        """Sets up f(q) and its partial derivatives, d f_α = Σᵢ f_{α+eᵢ} d qᵢ, and returns f. The q are
        evaluated when d is taken."""
        count, among, degree = components(symbol), coordinate_count(symbol), 0
        values = current = self._slopes(symbol, 0, among, count)
        while current:
            following = self._slopes(symbol, degree + 1, among, count)
            for (place, component), generator in current.items() if following else ():
                more = [following[tuple(sorted((*place, i))), component] for i in range(among)]
                self.ring.derive_by(str(generator), partial(_by_chain, more, coordinates))
            current, degree = following, degree + 1
        return matrix(list(values.values()), symbol.type.columns)

    def _slopes(
        self, symbol: Symbol, degree: int, among: int, count: int
    ) -> dict[tuple[tuple[int, ...], int], Polynomial]:
        """Returns the partial derivatives of a degree by (coordinates, component); {} if the inventory lacks
        them."""
        keys = list(product_of(indices(among, degree), range(count)))
        part = f"slope{degree}" if degree else "value"
        return dict(zip(keys, self.column(symbol, part, 0, len(keys)), strict=False))

    def multiples(self, angle: Polynomial, circles: Mapping[Term, Polynomial]) -> Iterator[tuple[Term, int]]:
        """Yields the angles that the angle is a combination of, with their multiples.

        circles: the terms with their own sine and cosine, and their values.
        """
        for circle, part in circles.items():
            place, size = next(iter(part.terms()), ((), 1))
            count: Any = dict(angle.terms()).get(place, 0) / size
            if count != 0 and count.q == 1:
                yield circle, int(count)
                angle = angle - part * self.ring.constant(int(count))
        for exponents, coefficient in angle.terms():
            yield self._linear_angle(exponents, coefficient).symbol, int(coefficient)

    def _linear_angle(self, exponents: tuple[int, ...], coefficient: Any) -> Parameter:
        places = [i for i, e in enumerate(exponents) if e]
        if len(places) == 1 and exponents[places[0]] == 1 and coefficient.q == 1:
            name = self.ring.names[places[0]]
            for parameter, known in self._named.items():
                is_angle = Parameter(parameter.symbol, "circle", 0, 0) in self._named
                if known == name and is_angle and parameter.part == "value" and parameter.order == 0:
                    return parameter
        raise NotExact(EngineCode.NO_ANGLE())

    def circle(self, angle: Term, count: int) -> tuple[Polynomial, Polynomial]:
        """Returns (cos, sin) of `count` times the angle, by the addition theorems."""
        c, s = self.column(angle, "circle", 0, 2)
        s = s if count >= 0 else -s
        cosine, sine = self.ring.one, self.ring.zero
        for _ in range(abs(count)):
            cosine, sine = cosine * c - sine * s, sine * c + cosine * s
        return self.ring.reduce(cosine), self.ring.reduce(sine)


def _by_chain(
    slopes: list[Polynomial], coordinates: Callable[[], list[Polynomial]], derivation: Derivation
) -> Polynomial:
    addends = [slope * derivation(q) for slope, q in zip(slopes, coordinates(), strict=True)]
    return sum(addends[1:], addends[0])


def rank(parameter: Parameter) -> bool:
    """True unless the parameter is the squared component of a circle, unit vector or quaternion, which ranks
    highest."""
    squared = {"circle": 1, "unit": 0, "quaternion": 0}
    return parameter.component != squared.get(parameter.part)
