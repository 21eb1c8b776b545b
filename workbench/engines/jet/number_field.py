"""Real algebraic numbers in one field ℚ(θ), for points without rational coordinates.

θ is a real zero of an irreducible polynomial over ℚ. An element is a polynomial in θ of lower degree, and is
0 only as the zero polynomial. The arithmetic is that of Python's fractions.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import zip_longest
from typing import Any

from workbench.engines.inventory import NotExact
from workbench.engines.jet.rings import RationalRing

_HALVINGS = 60
Coefficients = tuple[Fraction, ...]  # by rising power, the last one not 0


class NumberField:
    """ℚ(θ), given by a multiple of θ's minimal polynomial and an interval that contains no other zero of
    it."""

    def __init__(self, minimal: Sequence[Fraction], between: tuple[Fraction, Fraction]) -> None:
        minimal = _trimmed(minimal)
        self.minimal = tuple(Fraction(c) / minimal[-1] for c in minimal)
        low, high = between
        if len(minimal) < 3 or _at(self.minimal, low) * _at(self.minimal, high) >= 0:
            raise ValueError("expected a polynomial of degree ≥ 2 that changes its sign in the interval")
        self._between = low, high

    @property
    def generator(self) -> Algebraic:
        return Algebraic(self, (Fraction(0), Fraction(1)))

    @cached_property
    def near(self) -> float:
        """θ as a float."""
        low, high = self._between
        rising = _at(self.minimal, high) > 0
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            low, high = (low, middle) if (_at(self.minimal, middle) > 0) == rising else (middle, high)
        return float(low)

    def reduced(self, coefficients: Sequence[Fraction]) -> Algebraic:
        return Algebraic(self, _remainder(coefficients, self.minimal))


class Algebraic:
    """An element of a number field."""

    __slots__ = ("coefficients", "field")
    __hash__ = None  # type: ignore[assignment]  # equal objects may have different types

    def __init__(self, field: NumberField, coefficients: Sequence[Fraction]) -> None:
        self.field, self.coefficients = field, _trimmed(coefficients)

    def _lifted(self, other: Any) -> Coefficients:
        return other.coefficients if isinstance(other, Algebraic) else _trimmed((Fraction(other),))

    def __add__(self, other: Any) -> Algebraic:
        return Algebraic(self.field, _sum(self.coefficients, self._lifted(other)))

    __radd__ = __add__

    def __neg__(self) -> Algebraic:
        return Algebraic(self.field, [-c for c in self.coefficients])

    def __sub__(self, other: Any) -> Algebraic:
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> Algebraic:
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> Algebraic:
        return self.field.reduced(_product(self.coefficients, self._lifted(other)))

    __rmul__ = __mul__

    def __eq__(self, other: object) -> bool:
        return not (self - other)

    def __bool__(self) -> bool:
        return bool(self.coefficients)

    def __ge__(self, other: Any) -> bool:
        return bool(self == other) or float(self) > float(other)

    def __float__(self) -> float:
        return float(sum(float(c) * self.field.near**k for k, c in enumerate(self.coefficients)))

    def rational(self) -> Fraction | None:
        """Returns the element as a fraction if it is rational, else None."""
        return None if len(self.coefficients) > 1 else Fraction(sum(self.coefficients))

    def inverse(self) -> Algebraic:
        """Returns the inverse by Euclid's algorithm for the element and the minimal polynomial, which are
        coprime."""
        if not self:
            raise ZeroDivisionError("division by zero in a number field")
        above, below = self.field.minimal, self.coefficients
        left: Coefficients = ()
        right: Coefficients = (Fraction(1),)
        while len(below) > 1:
            quotient = _quotient(above, below)
            above, below = below, _sum(above, _negative(_product(quotient, below)))
            left, right = right, _sum(left, _negative(_product(quotient, right)))
        return self.field.reduced([c / below[0] for c in right])

    def __str__(self) -> str:
        """Returns text such as 1/2 + √3, or 2 θ with the definition of θ."""
        minimal, root, shown = self.field.minimal, "θ", self.coefficients
        if len(minimal) == 3 and not minimal[1]:
            root = f"√{-minimal[0]}" if minimal[0].denominator == 1 else f"√({-minimal[0]})"
            shown = shown if self.field.near > 0 else (*shown[:1], *_negative(shown[1:]))
        text = _written(shown, root)
        if root == "θ" and len(self.coefficients) > 1:
            text += f" where {_written(minimal, root)} = 0, θ ≈ {self.field.near:.6g}"
        return text


class NumberFieldRing(RationalRing):
    """A number field as a ring of the jet engine."""

    def divide(self, a: Any, b: Any) -> Any:
        return a * b.inverse() if isinstance(b, Algebraic) else a * (1 / Fraction(b))

    def root(self, square: Any) -> Any:
        rational = square.rational() if isinstance(square, Algebraic) else square
        if rational is None:
            raise NotExact(f"the root of {square}")
        return super().root(rational)


def _trimmed(coefficients: Iterable[Fraction]) -> Coefficients:
    coefficients = tuple(coefficients)
    while coefficients and not coefficients[-1]:
        coefficients = coefficients[:-1]
    return coefficients


def _sum(a: Coefficients, b: Coefficients) -> Coefficients:
    return _trimmed(x + y for x, y in zip_longest(a, b, fillvalue=Fraction(0)))


def _negative(a: Coefficients) -> Coefficients:
    return tuple(-c for c in a)


def _product(a: Coefficients, b: Coefficients) -> Coefficients:
    if not a or not b:
        return ()
    product = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            product[i + j] += x * y
    return _trimmed(product)


def _quotient(a: Sequence[Fraction], b: Coefficients) -> Coefficients:
    rest, quotient = list(a), [Fraction(0)] * max(0, len(a) - len(b) + 1)
    for place in reversed(range(len(quotient))):
        quotient[place] = rest[place + len(b) - 1] / b[-1]
        for k, c in enumerate(b):
            rest[place + k] -= quotient[place] * c
    return tuple(quotient)


def _remainder(a: Sequence[Fraction], b: Coefficients) -> Coefficients:
    return _sum(_trimmed(a), _negative(_product(_quotient(a, b), b)))


def _at(coefficients: Coefficients, x: Fraction) -> Fraction:
    value = Fraction(0)
    for c in reversed(coefficients):
        value = value * x + c
    return value


def _written(coefficients: Coefficients, root: str) -> str:
    addends = []
    for power, c in enumerate(coefficients):
        if c:
            x = "" if power == 0 else root if power == 1 else f"{root}^{power}"
            addends.append(str(c) if not x else x if c == 1 else f"-{x}" if c == -1 else f"{c} {x}")
    return " + ".join(addends).replace("+ -", "- ") or "0"
