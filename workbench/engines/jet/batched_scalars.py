"""Batches of numbers that go through the same computation as one scalar."""

from __future__ import annotations

from random import Random
from typing import Any

import numpy as np


class Lanes:
    """Doubles, one per lane; a constant is the same in all lanes.

    An object is true, or unequal to another, if it is so in any lane: code that omits zeros needs zero in
    all.
    """

    __slots__ = ("values",)
    __hash__ = None  # type: ignore[assignment]  # equal objects may have different types

    def __init__(self, values: Any) -> None:
        self.values = values

    def __add__(self, other: Lanes | float) -> Lanes:
        if isinstance(other, np.ndarray):  # an array of Lanes: entry by entry
            return NotImplemented
        return Lanes(self.values + _values(other))

    __radd__ = __add__

    def __sub__(self, other: Lanes | float) -> Lanes:
        if isinstance(other, np.ndarray):
            return NotImplemented
        return Lanes(self.values - _values(other))

    def __rsub__(self, other: Lanes | float) -> Lanes:
        return Lanes(_values(other) - self.values)

    def __mul__(self, other: Lanes | float) -> Lanes:
        if isinstance(other, np.ndarray):
            return NotImplemented
        return Lanes(self.values * _values(other))

    __rmul__ = __mul__

    def __neg__(self) -> Lanes:
        return Lanes(-self.values)

    def __bool__(self) -> bool:
        return bool(np.any(self.values != 0))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, (Lanes, int, float)) and not bool(self - other)


def _values(other: Lanes | float) -> Any:
    return other.values if isinstance(other, Lanes) else other


class LaneRing:
    """Lanes in double precision. A lane that divides by 0 becomes nan and does not affect the others.

    draws: the number of independent random numbers of a random scalar; each fills `repeated` consecutive
    lanes.
    """

    def __init__(self, draws: int, repeated: int) -> None:
        self._draws, self._repeated = draws, repeated

    def constant(self, numerator: int, denominator: int) -> Lanes:
        return Lanes(numerator / denominator)

    def divide(self, a: Lanes, b: Lanes) -> Lanes:
        divisor = np.asarray(_values(b), dtype=float)
        return Lanes(_values(a) / np.where(divisor == 0, np.nan, divisor))

    def root(self, square: Lanes) -> Lanes:
        return Lanes(np.sqrt(np.where(_values(square) < 0, np.nan, _values(square))))

    def random(self, random: Random) -> Lanes:
        return Lanes(np.repeat([random.uniform(-1, 1) for _ in range(self._draws)], self._repeated))
