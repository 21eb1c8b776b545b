"""Values of terms without symbols other than π: as balls that contain them, and in a cyclotomic field.

The field ℚ(ζ) of a root of unity ζ of order N contains the sines and cosines of the multiples of 2π/N, and
the root of each rational number whose square-free part, times 4, divides N.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import comb, factorial, lcm, prod
from typing import Any, Protocol

import numpy as np
from flint import arb, ctx, fmpq, fmpq_poly, fmpz, fmpz_poly

from workbench.core.construct import apply
from workbench.core.terms import (
    Apply,
    Block,
    Counting,
    Head,
    Identity,
    Integer,
    Number,
    Power,
    Relation,
    Symbol,
    Term,
    Zero,
)
from workbench.engines.inventory import NotExact

_PRECISION = 400
_LARGEST_ORDER, _LARGEST_POWER, _LARGEST_COUNT = 2000, 64, 100
_FUNCTIONS = frozenset(("sin", "cos", "exp", "arccos", "arcsin", "arctan", "atan2", "root"))


class Field(Protocol):
    """A field of numbers, with the functions beyond the four operations."""

    def rational(self, value: Fraction) -> Any: ...

    def pi(self) -> Any: ...

    def reciprocal(self, value: Any) -> Any: ...

    def function(self, head: Head, arguments: Sequence[Term]) -> Any: ...


def entries(term: Term, field: Field) -> np.ndarray:
    """Returns the entries of a term without symbols other than π. Raises NotExact and ZeroDivisionError."""
    if term.type.dual or term.type.algebra:
        raise NotExact("a term that is no matrix of real numbers")
    match term:
        case Number() | Integer() | Counting():
            return _filled(1, 1, field.rational(_rational(term)))
        case Symbol():
            return _filled(1, 1, field.pi())
        case Zero() | Identity():
            zeros = _filled(term.type.rows, term.type.columns, field.rational(Fraction(0)))
            if isinstance(term, Identity):
                np.fill_diagonal(zeros, field.rational(Fraction(1)))
            return zeros
        case Power(base=base, exponent=exponent) if exponent.is_number:
            return _power(entries(base, field), int(exponent), field)
        case Block(entries=rows):
            return np.block([[entries(each, field) for each in row] for row in rows])
        case Apply(head=head, arguments=arguments) if head in _FUNCTIONS and term.type.kind == "scalar":
            return _filled(1, 1, field.function(head, arguments))
        case Apply(head="div" | "inverse", arguments=(top, *below)):
            value = entries(top, field)
            return (
                value * field.reciprocal(entries(below[0], field)[0, 0]) if below else _inverse(value, field)
            )
        case Apply(head="norm", arguments=(inner,)):
            return _filled(1, 1, field.function("root", (_square(inner),)))
        case Apply(head=head, arguments=arguments) if head in _HEADS:
            return _HEADS[head](*(entries(each, field) for each in arguments))
    raise NotExact("a term that is no number")


def _square(term: Term) -> Term:
    return apply("mul" if term.type.kind == "scalar" else "dot", term, term)


def _filled(rows: int, columns: int, value: Any) -> np.ndarray:
    return np.full((rows, columns), value, dtype=object)


def _rational(term: Term) -> Fraction:
    """Returns the value of a number, an integer or a counting function."""
    match term:
        case Number(value=value):
            return value
        case Integer(value=value) if value.is_number:
            return Fraction(int(value))
        case Counting(arguments=arguments) if all(each.is_number for each in arguments):
            first, *others = map(int, arguments)
            if 0 <= first <= _LARGEST_COUNT and min(others, default=0) >= 0:
                if term.name == "factorial":
                    return Fraction(factorial(first))
                if term.name == "binomial":
                    return Fraction(comb(first, others[0]))
    raise NotExact("a number that is not looked at here")


def _power(base: np.ndarray, exponent: int, field: Field) -> np.ndarray:
    if not 0 <= exponent <= _LARGEST_POWER:
        raise NotExact(f"the power {exponent}")
    if base.shape[0] != base.shape[1]:
        base, exponent = base.T @ base, exponent // 2
    result = _filled(base.shape[0], base.shape[1], field.rational(Fraction(0)))
    np.fill_diagonal(result, field.rational(Fraction(1)))
    for _ in range(exponent):
        result = result @ base
    return result


def _product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    product: np.ndarray = a * b if a.shape == (1, 1) or b.shape == (1, 1) else a @ b
    return product


def _skew(a: np.ndarray) -> np.ndarray:
    x, y, z = a[:, 0]
    return np.array([[0 * x, -z, y], [z, 0 * x, -x], [-y, x, 0 * x]], dtype=object)


def _determinant(a: np.ndarray) -> Any:
    if len(a) == 1:
        return a[0, 0]
    minors = (np.delete(a[1:], j, axis=1) for j in range(len(a)))
    signed = [a[0, j] * _determinant(minor) * (-1) ** j for j, minor in enumerate(minors)]
    return sum(signed[1:], signed[0])


def _inverse(a: np.ndarray, field: Field) -> np.ndarray:
    """Returns the inverse by cofactors."""
    if len(a) == 1:
        return _filled(1, 1, field.reciprocal(a[0, 0]))
    cofactors = _filled(a.shape[0], a.shape[1], None)
    for i, j in np.ndindex(*a.shape):
        cofactors[j, i] = _determinant(np.delete(np.delete(a, i, 0), j, 1)) * (-1) ** (i + j)
    inverse: np.ndarray = cofactors * field.reciprocal(_determinant(a))
    return inverse


def _scalar(value: Any) -> np.ndarray:
    return _filled(1, 1, value)


_HEADS: dict[str, Callable[..., np.ndarray]] = {
    "add": lambda *addends: sum(addends[1:], addends[0]),
    "neg": lambda a: -a,
    "mul": _product,
    "dot": lambda a, b: a.T @ b,
    "cross": lambda a, b: _skew(a) @ b,
    "outer": lambda a, b: a @ b.T,
    "triple": lambda a, b, c: a.T @ _skew(b) @ c,
    "skew": _skew,
    "transpose": lambda a: a.T,
    "trace": lambda a: _scalar(np.trace(a)),
    "det": lambda a: _scalar(_determinant(a)),
}


class Balls:
    """Real numbers as balls."""

    def rational(self, value: Fraction) -> arb:
        return arb(fmpq(value.numerator, value.denominator))

    def pi(self) -> arb:
        return arb.pi()

    def reciprocal(self, value: arb) -> arb:
        if value.contains(0):
            raise ZeroDivisionError("division by what may be zero")
        return 1 / value

    def function(self, head: Head, arguments: Sequence[Term]) -> arb:
        values = [entries(each, self)[0, 0] for each in arguments]
        if head == "root" and not values[0] >= 0:
            raise NotExact("the root of what may be negative")
        if head in ("arccos", "arcsin") and not (-1 < values[0] < 1):
            raise NotExact("the arc of what may be outside of its domain")
        functions: dict[str, Callable[..., arb]] = {
            "sin": arb.sin, "cos": arb.cos, "exp": arb.exp, "root": arb.sqrt, "arccos": arb.acos,
            "arcsin": arb.asin, "arctan": arb.atan, "atan2": arb.atan2,
        }  # fmt: skip
        return functions[head](*values)


class Cyclotomic:
    """ℚ(ζ): polynomials in ζ modulo the cyclotomic polynomial of the order."""

    def __init__(self, order: int) -> None:
        self.order = order
        self._modulus = fmpq_poly(fmpz_poly.cyclotomic(order))

    def rational(self, value: Fraction) -> _Element:
        return _Element(self, fmpq_poly([fmpq(value.numerator, value.denominator)]))

    def pi(self) -> Any:
        raise NotExact("π outside of sines and cosines")

    def zeta(self, power: int) -> _Element:
        return self.reduced(fmpq_poly([0] * (power % self.order) + [1]))

    def reduced(self, polynomial: fmpq_poly) -> _Element:
        return _Element(self, polynomial % self._modulus)

    def reciprocal(self, value: _Element) -> _Element:
        if not value.polynomial:
            raise ZeroDivisionError("division by zero")
        _, inverse, _ = value.polynomial.xgcd(self._modulus)
        return self.reduced(inverse)

    def function(self, head: Head, arguments: Sequence[Term]) -> _Element:
        (argument,) = arguments if len(arguments) == 1 else (None,)
        if head == "exp" and argument is not None and turns(argument) == 0:
            return self.rational(Fraction(1))
        if head == "root" and argument is not None:
            return self._root(rational_value(argument))
        turn = turns(argument) if argument is not None and head in ("sin", "cos") else None
        if turn is None:
            raise NotExact(f"{head} of a number")
        power = turn * self.order
        up, down = self.zeta(int(power)), self.zeta(-int(power))
        half = self.rational(Fraction(1, 2))
        return (up + down) * half if head == "cos" else (up - down) * half * self.zeta(-self.order // 4)

    def _root(self, square: Fraction) -> _Element:
        outside, inside = square_free(square)
        result = self.rational(outside)
        for p in inside:
            step = self.order // (8 if p == 2 else p)
            if p == 2:
                result = result * (self.zeta(step) + self.zeta(-step))
                continue
            powers = [self.zeta(step * n * n) for n in range(p)]
            gauss = sum(powers[1:], powers[0])
            result = result * (gauss if p % 4 == 1 else gauss * self.zeta(-self.order // 4))
        return result


class _Element:
    """A number of a cyclotomic field."""

    __slots__ = ("field", "polynomial")
    __hash__ = None  # type: ignore[assignment]  # equal objects may have different types

    def __init__(self, field: Cyclotomic, polynomial: fmpq_poly) -> None:
        self.field, self.polynomial = field, polynomial

    def __add__(self, other: _Element) -> _Element:
        return _Element(self.field, self.polynomial + other.polynomial)

    def __sub__(self, other: _Element) -> _Element:
        return _Element(self.field, self.polynomial - other.polynomial)

    def __neg__(self) -> _Element:
        return _Element(self.field, -self.polynomial)

    def __mul__(self, other: _Element | int) -> _Element:
        if isinstance(other, int):
            return _Element(self.field, self.polynomial * other)
        return self.field.reduced(self.polynomial * other.polynomial)

    __rmul__ = __mul__


def turns(term: Term) -> Fraction | None:
    """Returns the angle as a fraction of a whole turn if it is a rational multiple of π, else None."""
    match term:
        case Symbol():
            return Fraction(1, 2)
        case Zero():
            return Fraction(0)
        case Number(value=value):
            return Fraction(0) if value == 0 else None
        case Apply(head="neg", arguments=(inner,)):
            found = turns(inner)
            return None if found is None else -found
        case Apply(head="add", arguments=addends):
            known = [turn for each in addends if (turn := turns(each)) is not None]
            return sum(known, Fraction(0)) if len(known) == len(addends) else None
        case Apply(head="mul", arguments=(left, right)):
            for factor, angle in ((left, right), (right, left)):
                if (found := turns(angle)) is not None and not isinstance(angle, Number | Zero):
                    return found * rational_value(factor)
        case Apply(head="div", arguments=(top, below)):
            found = turns(top)
            return None if found is None else found / rational_value(below)
    return None


class _Rationals:
    """The field ℚ."""

    def rational(self, value: Fraction) -> Fraction:
        return value

    def pi(self) -> Any:
        raise NotExact("π is not rational")

    def reciprocal(self, value: Fraction) -> Fraction:
        return 1 / value

    def function(self, head: Head, arguments: Sequence[Term]) -> Any:
        raise NotExact("a function that is not rational")


def rational_value(term: Term) -> Fraction:
    """Returns the value of a rational number. Raises NotExact if it is not known to be rational."""
    value: Fraction = entries(term, _Rationals())[0, 0]
    return value


def square_free(square: Fraction) -> tuple[Fraction, list[int]]:
    """Returns the root as a rational number and the primes whose roots multiply it. Raises NotExact."""
    if square < 0:
        raise NotExact("the root of a negative number")
    whole = square.numerator * square.denominator
    outside, inside = Fraction(1, square.denominator), []
    for prime, exponent in fmpz(whole).factor() if whole else [(0, 2)]:
        outside *= int(prime) ** (exponent // 2)
        inside += [int(prime)] * (exponent % 2)
    return outside, inside


def order_for(sides: Sequence[Term]) -> int:
    """Returns the order of a root of unity whose field contains the terms. Raises NotExact."""
    found = [4]
    for part in (part for side in sides for part in side.walk()):
        if isinstance(part, Apply) and part.head in ("sin", "cos"):
            if (turn := turns(part.arguments[0])) is None:
                raise NotExact("an angle that is no rational part of a turn")
            found.append(turn.denominator)
        if isinstance(part, Apply) and part.head in ("root", "norm"):
            (inner,) = part.arguments
            square = inner if part.head == "root" else _square(inner)
            found.append(4 * prod(square_free(rational_value(square))[1]))
    if (order := lcm(*found)) > _LARGEST_ORDER:
        raise NotExact(f"a root of unity of order {order}")
    return order


def surely_apart(relation: Relation) -> tuple[tuple[str, ...], tuple[str, ...]] | None:
    """Returns the entries of both sides if some entry is certain to differ, else None.

    Rational sides are given exactly, others by 17 digits.
    """
    with ctx.workprec(_PRECISION):
        left, right = (entries(side, Balls()) for side in (relation.left, relation.right))
        if all(arb(a - b).contains(0) for a, b in zip(left.flat, right.flat, strict=True)):
            return None
    return _shown(relation.left, left), _shown(relation.right, right)


def _shown(side: Term, balls: np.ndarray) -> tuple[str, ...]:
    try:
        return tuple(str(value) for value in entries(side, _Rationals()).flat)
    except NotExact:
        return tuple(format(float(ball), ".17g") for ball in balls.flat)


def exactly_equal(relation: Relation) -> bool:
    """True if all entries of the sides are equal in a cyclotomic field. Raises NotExact."""
    field = Cyclotomic(order_for((relation.left, relation.right)))
    left, right = (entries(side, field) for side in (relation.left, relation.right))
    return all((a - b).polynomial == 0 for a, b in zip(left.flat, right.flat, strict=True))
