"""Exact values of deep copies on motions made of time, its cosine and its sine.

They only serve to find a motion; Coq checks it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from typing import Any


@dataclass(frozen=True)
class Wave:
    """A polynomial in cos t, sin t and t: exponents → coefficient, where sin² t is 1 − cos² t."""

    terms: Mapping[tuple[int, int, int], Fraction]

    def __add__(self, other: Wave) -> Wave:
        total = dict(self.terms)
        for place, value in other.terms.items():
            total[place] = total.get(place, Fraction(0)) + value
        return Wave({p: v for p, v in total.items() if v})

    def __mul__(self, other: Wave) -> Wave:
        total = Wave({})
        for (i, j, k), a in self.terms.items():
            for (x, y, z), b in other.terms.items():
                if j and y:
                    product = {(i + x, 0, k + z): a * b, (i + x + 2, 0, k + z): -a * b}
                else:
                    product = {(i + x, j + y, k + z): a * b}
                total += Wave(product)
        return total

    def __neg__(self) -> Wave:
        return Wave({p: -v for p, v in self.terms.items()})

    def rate(self) -> Wave:
        total = Wave({})
        for (i, j, k), a in self.terms.items():
            if i:
                total += Wave({(i - 1, 0, k): -a * i}) * SINE * Wave({(0, j, 0): Fraction(1)})
            if j:
                total += Wave({(i + 1, 0, k): a})
            if k:
                total += Wave({(i, j, k - 1): a * k})
        return total

    @property
    def at_zero(self) -> Fraction:
        return sum((a for (_, j, k), a in self.terms.items() if not j and not k), Fraction(0))

    @property
    def constant(self) -> Fraction | None:
        """The number that the polynomial is equal to; None if it varies."""
        return self.terms.get((0, 0, 0), Fraction(0)) if set(self.terms) <= {(0, 0, 0)} else None


@dataclass(frozen=True)
class Pair:
    """A dual number."""

    re: Wave
    du: Wave

    def __add__(self, other: Pair) -> Pair:
        return Pair(self.re + other.re, self.du + other.du)

    def __mul__(self, other: Pair) -> Pair:
        return Pair(self.re * other.re, self.re * other.du + self.du * other.re)

    def __neg__(self) -> Pair:
        return Pair(-self.re, -self.du)

    def rate(self) -> Pair:
        return Pair(self.re.rate(), self.du.rate())


def wave(value: Fraction | int) -> Wave:
    return Wave({(0, 0, 0): Fraction(value)} if value else {})


COSINE, SINE, TIME = (Wave({place: Fraction(1)}) for place in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))

#: (flag, kind, number) of a symbol → its value; vectors and tensors are lists.
Values = dict[tuple[str, str, str], Any]


def value(deep: str, values: Values) -> Any:
    """Returns the value of a deep copy. Raises KeyError for a symbol without a value."""
    return _value(parsed(deep), values)


def parsed(deep: str) -> Any:
    """Returns the deep copy as nested lists of words."""
    stack: list[list[Any]] = [[]]
    for token in re.findall(r"[()]|[^\s()]+", deep):
        if token == "(":
            stack.append([])
        elif token == ")":
            done = stack.pop()
            stack[-1].append(done)
        else:
            stack[-1].append(token)
    (made,) = stack[0]
    return made


def order(tree: Any, orders: Mapping[tuple[str, str, str], int]) -> int:
    """Returns the highest order of derivatives of moving symbols, whose own orders `orders` gives."""
    if isinstance(tree, str):
        return 0
    if tree[0] == "Var":
        return orders.get(tuple(tree[1:]), 0)
    return max((order(part, orders) for part in tree[1:]), default=0) + (tree[0] == "DD")


def flat(x: Any) -> list[Wave]:
    """Returns the components, real parts before dual parts."""
    parts = [y for row in x for y in flat_entries(row)] if isinstance(x, list) else [x]
    if parts and isinstance(parts[0], Pair):
        return [p.re for p in parts] + [p.du for p in parts]
    return parts


def flat_entries(x: Any) -> list[Any]:
    return [y for row in x for y in flat_entries(row)] if isinstance(x, list) else [x]


def _each(f: Callable[[Any], Any], x: Any) -> Any:
    return [_each(f, y) for y in x] if isinstance(x, list) else f(x)


def _both(f: Callable[[Any, Any], Any], x: Any, y: Any) -> Any:
    return [_both(f, a, b) for a, b in zip(x, y, strict=True)] if isinstance(x, list) else f(x, y)


def _plus(x: Any, y: Any) -> Any:
    return _both(lambda a, b: a + b, x, y)


def _minus(x: Any, y: Any) -> Any:
    return _both(lambda a, b: a + -b, x, y)


def _dot(x: list, y: list) -> Any:
    return reduce(lambda a, b: a + b, (a * b for a, b in zip(x, y, strict=True)))


def _cross(x: list, y: list) -> list:
    return [x[i] * y[j] + -(x[j] * y[i]) for i, j in ((1, 2), (2, 0), (0, 1))]


def _transpose(a: list) -> list:
    return [list(row) for row in zip(*a, strict=True)]


def product(a: list, b: list) -> list:
    return [[_dot(row, column) for column in _transpose(b)] for row in a]


def _adjugate(a: list) -> list:
    return _transpose([_cross(a[1], a[2]), _cross(a[2], a[0]), _cross(a[0], a[1])])


def skew(u: list) -> list:
    nothing = u[0] + -u[0]
    return [[nothing, -u[2], u[1]], [u[2], nothing, -u[0]], [-u[1], u[0], nothing]]


def _halved(x: Any) -> Any:
    half = wave(Fraction(1, 2))
    return _each(lambda a: Pair(a.re * half, a.du * half) if isinstance(a, Pair) else a * half, x)


def _vect(a: list) -> list:
    return _halved([a[2][1] + -a[1][2], a[0][2] + -a[2][0], a[1][0] + -a[0][1]])


_OPERATIONS: dict[str, Callable[..., Any]] = {
    "Plus": _plus,
    "Minus": _minus,
    "Neg": lambda a: _each(lambda x: -x, a),
    "Scale": lambda s, a: _each(lambda x: s * x, a),
    "Act": lambda a, u: [_dot(row, u) for row in a],
    "Prod": product,
    "Dot": _dot,
    "Cross": _cross,
    "Outer": lambda u, v: [[a * b for b in v] for a in u],
    "Skew": skew,
    "Vect": _vect,
    "Sym": lambda a: _halved(_plus(a, _transpose(a))),
    "Anti": lambda a: _halved(_minus(a, _transpose(a))),
    "Triad": lambda a, b, c: [a, b, c],
    "Transpose": _transpose,
    "Adj": _adjugate,
    "Det": lambda a: _dot(a[0], _cross(a[1], a[2])),
    "Trace": lambda a: a[0][0] + a[1][1] + a[2][2],
    "Triple": lambda u, v, w: _dot(u, _cross(v, w)),
    "DD": lambda a: _each(lambda x: x.rate(), a),
    "Re": lambda a: _each(lambda x: x.re, a),
    "Du": lambda a: _each(lambda x: x.du, a),
    "Emb": lambda a: _each(lambda x: Pair(x, wave(0)), a),
}


def _value(tree: Any, values: Values) -> Any:
    match tree:
        case "Eps":
            return Pair(wave(0), wave(1))
        case ["Var", *place]:
            return values[tuple(place)]
        case ["Num", dual, number]:
            fraction = (
                Fraction(number) if isinstance(number, str) else Fraction(int(number[0]), int(number[2]))
            )
            return _number(dual, fraction)
        case ["Zer", dual, kind]:
            return _filled(kind, _number(dual, Fraction(0)))
        case ["Idt", dual]:
            return [[_number(dual, Fraction(i == j)) for j in range(3)] for i in range(3)]
        case ["Axis", dual, place]:
            return [_number(dual, Fraction(i == int(place))) for i in range(3)]
        case ["Comp" | "Row", place, inner]:
            return _value(inner, values)[int(place)]
        case [name, *arguments]:
            return _OPERATIONS[name](*(_value(a, values) for a in arguments))
    raise KeyError(str(tree))


def _number(dual: str, number: Fraction) -> Wave | Pair:
    return Pair(wave(number), wave(0)) if dual == "true" else wave(number)


def _filled(kind: str, entry: Wave | Pair) -> Any:
    return {"Scalar": entry, "Vector": [entry] * 3, "Tensor": [[entry] * 3] * 3}[kind]
