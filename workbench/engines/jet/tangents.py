"""Dual numbers over any ring of the jet engine: a + b ε, where b is the change of a along one coordinate.

They nest: dual numbers over dual numbers carry mixed partial derivatives. Functions `of` a coordinate are
composed as Taylor series, so that a change of the coordinate changes them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product
from math import comb, factorial, prod
from typing import Any

import numpy as np

from workbench.engines.inventory.parameters import Parameter
from workbench.engines.inventory.partial_derivatives import Seed, indices
from workbench.engines.jet.components import Jet, Value


class Tangent:
    """The number value + slope ε."""

    __slots__ = ("ring", "slope", "value")

    def __init__(self, ring: TangentRing, value: Any, slope: Any) -> None:
        self.ring, self.value, self.slope = ring, value, slope

    def __add__(self, other: Any) -> Tangent:
        other = self.ring.lift(other)
        return Tangent(self.ring, self.value + other.value, self.slope + other.slope)

    __radd__ = __add__

    def __neg__(self) -> Tangent:
        return Tangent(self.ring, -self.value, -self.slope)

    def __sub__(self, other: Any) -> Tangent:
        return self.__add__(-self.ring.lift(other))

    def __rsub__(self, other: Any) -> Tangent:
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> Tangent:
        other = self.ring.lift(other)
        change = self.value * other.slope + self.slope * other.value
        return Tangent(self.ring, self.value * other.value, change)

    __rmul__ = __mul__

    def __eq__(self, other: object) -> bool:
        other = self.ring.lift(other)
        return bool(self.value == other.value) and bool(self.slope == other.slope)

    __hash__ = None  # type: ignore[assignment]  # equal objects may have different types

    def __bool__(self) -> bool:
        return bool(self.value) or bool(self.slope)


class TangentRing:
    """The ring of the numbers a + b ε with a and b in `base`."""

    def __init__(self, base: Any) -> None:
        self.base = base

    @property
    def depth(self) -> int:
        """The number of nested ε."""
        return 1 + getattr(self.base, "depth", 0)

    def lift(self, value: Any) -> Tangent:
        if isinstance(value, Tangent) and value.ring is self:
            return value
        nothing = self.base.constant(0, 1)
        return Tangent(self, nothing + value, nothing)

    def constant(self, numerator: int, denominator: int) -> Tangent:
        return self.lift(self.base.constant(numerator, denominator))

    def divide(self, a: Any, b: Any) -> Tangent:
        a, b = self.lift(a), self.lift(b)
        quotient = self.base.divide(a.value, b.value)
        return Tangent(self, quotient, self.base.divide(a.slope - quotient * b.slope, b.value))

    def root(self, square: Any) -> Tangent:
        square = self.lift(square)
        root = self.base.root(square.value)
        return Tangent(self, root, self.base.divide(square.slope, root + root))


class MovedPoint(Mapping[Parameter, Any]):
    """The parameters of a point, with one of them moved by ε."""

    def __init__(self, point: Mapping[Parameter, Any], ring: TangentRing, seed: Seed) -> None:
        self._point, self._ring, self._seed = point, ring, seed

    def __getitem__(self, parameter: Parameter) -> Tangent:
        seed, value = self._seed, self._point[parameter]
        step = self._ring.base.constant(seed.factor.denominator, seed.factor.numerator)
        moved = self._ring.lift(value)
        if parameter == Parameter(seed.symbol, "value", seed.order, seed.component):
            moved.slope = step
        return moved

    def __iter__(self) -> Iterator[Parameter]:
        return iter(self._point)

    def __len__(self) -> int:
        return len(self._point)


def changes(value: Value) -> Value:
    """Returns the coefficient of ε."""

    def jet(arrays: Jet) -> Jet:
        return [_changed(array) for array in arrays]

    return Value(jet(value.re), None if value.du is None else jet(value.du))


def pushed(circle: tuple[Any, Any], step: Any, ring: Any) -> tuple[Any, Any]:
    """Returns cos and sin of an angle moved by a step whose powers beyond the number of ε are 0."""
    c, s = circle
    cosine, sine = ring.constant(1, 1), ring.constant(0, 1)
    power = ring.constant(1, 1)
    for degree in range(1, getattr(ring, "depth", 0) + 1):
        power = power * step
        addend = power * ring.constant((-1) ** (degree // 2), factorial(degree))
        cosine, sine = (cosine, sine + addend) if degree % 2 else (cosine + addend, sine)
    return c * cosine - s * sine, s * cosine + c * sine


def commuted(lowered: list[Jet]) -> Jet:
    """Returns Dʲ ∂ₖ f for each j, from the lists of the ∂ₖ₋ᵢ Dʲ f."""
    jet = []
    for j in range(len(lowered[0])):
        total = lowered[0][j]
        for i in range(1, min(j, len(lowered) - 1) + 1):
            total = total + lowered[i][j - i] * ((-1) ** i * comb(j, i))
        jet.append(total)
    return jet


def _changed(array: np.ndarray) -> np.ndarray:
    result = np.empty(array.shape, dtype=object)
    for place in np.ndindex(array.shape):
        entry: Any = array[place]
        result[place] = entry.slope if isinstance(entry, Tangent) else 0 * entry
    return result


def composed(
    slopes: list[list[Any]], coordinates: list[list[Any]], start: list[Any], ring: Any, shape: tuple[int, ...]
) -> Jet:
    """Returns f(q(t)) order by order, as Σ f_α/α! (q(t) − q₀)^α, a series in t.

    slopes: the partial derivatives of f at `start`, by degree. coordinates: the derivatives of each
    coordinate. Powers beyond the orders of t and of ε are 0.
    """
    length = len(coordinates[0])
    zero = ring.constant(0, 1)
    steps = [
        [ring.constant(1, factorial(k)) * (x - (q0 if k == 0 else zero)) for k, x in enumerate(q)]
        for q, q0 in zip(coordinates, start, strict=True)
    ]
    size = prod(shape)
    total = [[zero for _ in range(length)] for _ in range(size)]
    powers: dict[tuple[int, ...], list[Any]] = {(): [ring.constant(1, 1)] + [zero] * (length - 1)}
    for degree, values in enumerate(slopes):
        places = indices(len(coordinates), degree)
        for place in places:
            if place:
                powers[place] = _multiplied(powers[place[:-1]], steps[place[-1]], zero)
        for (number, place), component in product(enumerate(places), range(size)):
            weight = ring.constant(1, prod(factorial(place.count(i)) for i in set(place)))
            value = values[number * size + component] * weight
            for k, power in enumerate(powers[place]):
                total[component][k] = total[component][k] + power * value
    jet = []
    for k in range(length):
        array = np.empty(size, dtype=object)
        array[:] = [ring.constant(factorial(k), 1) * component[k] for component in total]
        jet.append(array.reshape(shape))
    return jet


def _multiplied(a: list[Any], b: list[Any], zero: Any) -> list[Any]:
    return [sum((a[j] * b[k - j] for j in range(k + 1)), start=zero) for k in range(len(a))]
