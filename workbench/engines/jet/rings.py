"""Rings of the jet engine, and the points at which symbols are evaluated."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from math import comb, isqrt, sqrt
from random import Random
from typing import Any

import numpy as np

from workbench.core.terms import Symbol, Term
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.inventory import Inventory
from workbench.engines.inventory.parameters import SPHERES, Parameter, parameters
from workbench.engines.inventory.partial_derivatives import Seed
from workbench.engines.jet.components import Value, array_shape, leibniz
from workbench.engines.jet.jet_quaternions import joined, quaternion_product
from workbench.engines.jet.tangents import MovedPoint, TangentRing

#: A Mersenne prime of 61 bits. It is 3 modulo 4, so a square root is one power.
PRIME = 2**61 - 1


class Residue:
    """An integer modulo PRIME."""

    __slots__ = ("value",)

    def __init__(self, value: int) -> None:
        self.value = value % PRIME

    def __add__(self, other: Residue | int) -> Residue:
        return Residue(self.value + _residue(other))

    __radd__ = __add__

    def __sub__(self, other: Residue | int) -> Residue:
        return Residue(self.value - _residue(other))

    def __rsub__(self, other: Residue | int) -> Residue:
        return Residue(_residue(other) - self.value)

    def __mul__(self, other: Residue | int) -> Residue:
        return Residue(self.value * _residue(other))

    __rmul__ = __mul__

    def __neg__(self) -> Residue:
        return Residue(-self.value)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, (Residue, int)) and (self.value - _residue(other)) % PRIME == 0

    __hash__ = None  # type: ignore[assignment]  # equal objects may have different types

    def __bool__(self) -> bool:
        return self.value != 0


def _residue(value: Residue | int) -> int:
    return value.value if isinstance(value, Residue) else value


class ResidueRing:
    """The field of integers modulo PRIME. A zero in it may be accidental, a non-zero value cannot be."""

    def constant(self, numerator: int, denominator: int) -> Residue:
        return Residue(numerator * pow(denominator, -1, PRIME))

    def divide(self, a: Residue, b: Residue) -> Residue:
        if not b:
            raise ZeroDivisionError("division by zero modulo the prime")
        return Residue(a.value * pow(b.value, -1, PRIME))

    def root(self, square: Residue) -> Residue:
        raise NotExact("a root modulo a prime has no sign")

    def random(self, random: Random) -> Residue:
        return Residue(random.randrange(1, PRIME))


class RationalRing:
    """The rationals, for counterexamples that a person can check; integers are Python integers."""

    def __init__(self, entries: tuple[Fraction | int, ...] = (-1, 0, 1)) -> None:
        self._entries = entries

    def constant(self, numerator: int, denominator: int) -> Fraction | int:
        return numerator if denominator == 1 else _whole(Fraction(numerator, denominator))

    def divide(self, a: Fraction | int, b: Fraction | int) -> Fraction | int:
        return _whole(Fraction(a) / b)

    def root(self, square: Fraction | int) -> Fraction | int:
        square = Fraction(square)
        p, q = isqrt(max(square.numerator, 0)), isqrt(square.denominator)
        if Fraction(p * p, q * q) != square:
            raise NotExact(f"{square} has no rational root")
        return _whole(Fraction(p, q))

    def random(self, random: Random) -> Fraction | int:
        return random.choice(self._entries)


def _whole(value: Fraction) -> Fraction | int:
    return value.numerator if value.denominator == 1 else value


class FloatRing:
    """Double precision, for motions computed by Drake."""

    def constant(self, numerator: int, denominator: int) -> float:
        return numerator / denominator

    def divide(self, a: float, b: float) -> float:
        return a / b

    def root(self, square: float) -> float:
        if square < 0:
            raise NotExact("the root of a negative number")
        return sqrt(square)


class PointSource:
    """Derivatives of symbols from values of the parameters, by the formulas in `parameters.py`."""

    def __init__(self, ring: Any, point: Mapping[Parameter, Any], moved_along: int | None = None) -> None:
        self.ring = ring
        self._point = point
        self._moved_along = moved_along
        self._circles: list[Term] | None = None

    def moved(self, seed: Seed) -> PointSource:
        """Returns the same source with one component of a derivative moved by ε, over dual numbers."""
        ring = TangentRing(self.ring)
        return PointSource(ring, MovedPoint(self._point, ring, seed), self._moved_along)

    def slopes(self, function: Symbol, degree: int, count: int) -> list[Any]:
        """Returns all partial derivatives of a degree, those of one component in sequence."""
        part = f"slope{degree}" if degree else "value"
        return [self._point[Parameter(function, part, 0, i)] for i in range(count)]

    def along(self, component: int) -> PointSource:
        if self._moved_along is not None:
            raise NotExact("div or curl of a div or curl")
        return PointSource(self.ring, self._point, component)

    def circles(self) -> list[Term]:
        if self._circles is None:
            firsts = (p.symbol for p in self._point if p.part == "circle" and p.component == 0)
            self._circles = [term for term in firsts if not isinstance(term, Symbol)]
        return self._circles

    def circle(self, angle: Term, value: Any = None) -> tuple[Any, Any]:
        return tuple(self._point[Parameter(angle, "circle", 0, i)] for i in range(2))

    def jet(self, symbol: Symbol, depth: int) -> Value:
        declaration = symbol.declaration
        if declaration.unit and symbol.type.kind == "quaternion":
            return self._quaternion(symbol, depth)
        if declaration.unit:
            return self._unit(symbol, depth)
        if declaration.transform:
            return self._transform(symbol, depth)
        if declaration.rotation:
            return self._rotation(symbol, depth)
        if declaration.symmetric or declaration.diagonal:
            du = self._mirrored(symbol, "dual", depth) if symbol.type.dual else None
            return Value(self._mirrored(symbol, "value", depth), du)
        shape = array_shape(symbol.type)
        re = self._array(symbol, "value", depth, shape)
        if declaration.coordinate and self._moved_along is not None:
            step = [0 * x for x in re]
            step[0] = step[0] + np.eye(3, dtype=object)[self._moved_along] * self.ring.constant(1, 1)
            return Value(re, step)
        return Value(re, self._array(symbol, "dual", depth, shape) if symbol.type.dual else None)

    def _array(self, symbol: Symbol, part: str, depth: int, shape: tuple[int, ...]) -> list[np.ndarray]:
        arrays = []
        for order in range(depth + 1):
            array = np.empty(shape, dtype=object)
            for flat in range(array.size):
                array[np.unravel_index(flat, shape)] = self._parameter(symbol, part, order, flat)
            arrays.append(array)
        return arrays

    def _mirrored(self, symbol: Symbol, part: str, depth: int) -> list[np.ndarray]:
        """Returns matrices from their upper triangles, row by row, or from their diagonals."""
        size, matrices = symbol.type.rows, []
        for order in range(depth + 1):
            array = np.full((size, size), self.ring.constant(0, 1), dtype=object)
            places = [(i, j) for i in range(size) for j in range(i, size)]
            if symbol.declaration.diagonal:
                places = [(i, j) for i, j in places if i == j]
            for component, (i, j) in enumerate(places):
                array[i, j] = array[j, i] = self._parameter(symbol, part, order, component)
            matrices.append(array)
        return matrices

    def _parameter(self, symbol: Symbol, part: str, order: int, component: int) -> Any:
        if symbol.declaration.constant and (order or part == "spin"):
            return self.ring.constant(0, 1)
        if symbol.declaration.clock and order:
            return self.ring.constant(int(order == 1), 1)
        return self._point[Parameter(symbol, part, order, component)]

    def _spun(self, symbol: Symbol, start: np.ndarray, depth: int) -> list[np.ndarray]:
        """Returns X, Ẋ, … from Ẋ = s × X for each column of X: X⁽ᵏ⁺¹⁾ = Σ C(k, j) s⁽ʲ⁾ × X⁽ᵏ⁻ʲ⁾."""
        spins = [_crossing(s) for s in self._array(symbol, "spin", depth - 1, (3,))] if depth else []
        jets = [start]
        for k in range(depth):
            jets.append(sum((spins[j] @ jets[k - j]) * comb(k, j) for j in range(k + 1)))
        return jets

    def _unit(self, symbol: Symbol, depth: int) -> Value:
        u = self._spun(symbol, self._array(symbol, "unit", 0, (3,))[0], depth)
        if not symbol.type.dual:
            return Value(u)
        m = [_crossing(x) for x in self._array(symbol, "moment", depth, (3,))]
        return Value(u, _folded(m, u))

    def _quaternion(self, symbol: Symbol, depth: int) -> Value:
        """Returns q, q̇, … from 2 q̇ = s q; the dual part is ½ ρ q."""
        half = self.ring.constant(1, 2)
        start = self._array(symbol, "quaternion", 0, (4,))[0]
        spins = self._array(symbol, "spin", depth - 1, (3,)) if depth else []
        spins = [joined(s[0] * 0, s) * half for s in spins]
        q = [start]
        for k in range(depth):
            addends = (quaternion_product(spins[j], q[k - j]) * comb(k, j) for j in range(k + 1))
            q.append(np.asarray(sum(addends), dtype=object))
        if not symbol.type.dual:
            return Value(q)
        shifts = [joined(p[0] * 0, p) * half for p in self._array(symbol, "translation", depth, (3,))]
        return Value(q, leibniz(quaternion_product, shifts, q))

    def _transform(self, symbol: Symbol, depth: int) -> Value:
        places = self._array(symbol, "translation", depth, (3,))
        jets = []
        for order, (turn, place) in enumerate(zip(self._rotation(symbol, depth).re, places, strict=True)):
            array = np.full((4, 4), self.ring.constant(0, 1), dtype=object)
            array[:3, :3], array[:3, 3] = turn, place
            array[3, 3] = self.ring.constant(int(order == 0), 1)
            jets.append(array)
        return Value(jets)

    def _rotation(self, symbol: Symbol, depth: int) -> Value:
        """Returns R = (q₀² − q·q) I + 2 q ⊗ q + 2 q₀ q̃ at |q| = 1, with its derivatives."""
        q0, *rest = (self._parameter(symbol, "quaternion", 0, i) for i in range(4))
        q = np.array(rest, dtype=object)
        start = np.outer(q, q) * 2 + _crossing(q) * (q0 * 2)
        for i in range(3):
            start[i, i] = start[i, i] + q0 * q0 - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2])
        rotation = self._spun(symbol, start, depth)
        if not symbol.type.dual:
            return Value(rotation)
        shift = [_crossing(x) for x in self._array(symbol, "translation", depth, (3,))]
        return Value(rotation, _folded(shift, rotation))


def _crossing(x: np.ndarray) -> np.ndarray:
    zero = x[0] * 0
    return np.array([[zero, -x[2], x[1]], [x[2], zero, -x[0]], [-x[1], x[0], zero]], dtype=object)


def _folded(a: list[np.ndarray], b: list[np.ndarray]) -> list[np.ndarray]:
    return [sum((a[j] @ b[k - j]) * comb(k, j) for j in range(k + 1)) for k in range(len(b))]


class RandomPoint(dict[Parameter, Any]):
    """A random point; each parameter is drawn on first access.

    Parameters that `keep` accepts get a random value, others 0. Parts on a sphere get a point of the sphere
    with coordinates in the ring, by stereographic projection.
    """

    def __init__(self, ring: Any, random: Random, keep: Callable[[Parameter], bool] = lambda _: True) -> None:
        super().__init__()
        self._ring, self._random, self._keep = ring, random, keep

    def __missing__(self, parameter: Parameter) -> Any:
        if parameter.part in SPHERES:
            for i, x in enumerate(_on_sphere(self._ring, self._random, SPHERES[parameter.part])):
                self[parameter._replace(component=i)] = x
        else:
            kept = self._keep(parameter)
            self[parameter] = self._ring.random(self._random) if kept else self._ring.constant(0, 1)
        return self[parameter]


def sample(
    inventory: Inventory, ring: Any, random: Random, keep: Callable[[Parameter], bool] = lambda _: True
) -> dict[Parameter, Any]:
    """Returns a random point with exactly the parameters of the inventory."""
    point = RandomPoint(ring, random, keep)
    return {parameter: point[parameter] for parameter in parameters(inventory)}


def _on_sphere(ring: Any, random: Random, size: int) -> list[Any]:
    while True:
        slopes = [ring.random(random) for _ in range(size - 1)]
        square = sum((t * t for t in slopes), start=ring.constant(0, 1))
        one = ring.constant(1, 1)
        try:
            point = [ring.divide(one - square, one + square)]
            return point + [ring.divide(t + t, one + square) for t in slopes]
        except ZeroDivisionError:
            continue
