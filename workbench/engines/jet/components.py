"""Quantities as lists of time derivatives in index notation: the values of the jet engine."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import permutations, product
from math import comb
from typing import Any

import numpy as np

from workbench.core.types import Type

Jet = list[np.ndarray]  # [x, ẋ, ẍ, …], each an object array of the type's shape

#: (i, j, k, sign) of every non-zero component of the Levi-Civita symbol.
LEVI_CIVITA = tuple((*p, (p[1] - p[0]) * (p[2] - p[0]) * (p[2] - p[1]) // 2) for p in permutations(range(3)))


@dataclass(frozen=True)
class Value:
    """The derivatives of a quantity up to some order: the real part and, if it is dual, the dual part."""

    re: Jet
    du: Jet | None = None

    def __post_init__(self) -> None:
        # NumPy turns a 0-dimensional object array into its element at the first operation
        object.__setattr__(self, "re", [np.asarray(x, dtype=object) for x in self.re])
        if self.du is not None:
            object.__setattr__(self, "du", [np.asarray(x, dtype=object) for x in self.du])

    @property
    def depth(self) -> int:
        return len(self.re) - 1

    def cut(self, first: int, last: int) -> Value:
        if first == 0 and last == self.depth:
            return self
        du = None if self.du is None else self.du[first : last + 1]
        return Value(self.re[first : last + 1], du)

    def map(self, function: Callable[[np.ndarray], np.ndarray]) -> Value:
        """Returns the value of a linear function of the components."""
        du = None if self.du is None else [function(x) for x in self.du]
        return Value([function(x) for x in self.re], du)


OperatorValue = tuple[Value, ...]


def flat_components(values: OperatorValue) -> list[Any]:
    real = [x for v in values for x in v.re[0].ravel()]
    return real + [x for v in values if v.du is not None for x in v.du[0].ravel()]


def scalar_array(value: Any) -> np.ndarray:
    array = np.empty((), dtype=object)
    array[()] = value
    return array


def array_shape(type_: Type) -> tuple[int, ...]:
    """Returns the numbers of rows and columns, without those that are 1."""
    return tuple(size for size in matrix_shape(type_) if size > 1)


def matrix_shape(type_: Type) -> tuple[int, int]:
    return type_.rows, type_.columns


def leibniz(f: Callable[[Any, Any], Any], a: Jet, b: Jet) -> Jet:
    """Returns (f(a, b))⁽ᵏ⁾ = Σⱼ C(k, j) f(a⁽ʲ⁾, b⁽ᵏ⁻ʲ⁾) for a bilinear f, up to the shorter list."""
    result: Jet = []
    for k in range(min(len(a), len(b))):
        total: np.ndarray | None = None
        for j in range(k + 1):
            addend = f(a[j], b[k - j])
            addend = np.asarray(addend if comb(k, j) == 1 else addend * comb(k, j), dtype=object)
            total = addend if total is None else np.asarray(total + addend, dtype=object)
        assert total is not None
        result.append(total)
    return result


def product_of(f: Callable[[Any, Any], Any], a: Value, b: Value) -> Value:
    re = leibniz(f, a.re, b.re)
    parts = []
    if b.du is not None:
        parts.append(leibniz(f, a.re, b.du))
    if a.du is not None:
        parts.append(leibniz(f, a.du, b.re))
    if not parts:
        return Value(re)
    du = parts[0] if len(parts) == 1 else [x + y for x, y in zip(*parts, strict=True)]
    return Value(re, du)


def add(a: Value, b: Value) -> Value:
    re = [x + y for x, y in zip(a.re, b.re, strict=True)]
    if a.du is None or b.du is None:
        return Value(re, a.du if b.du is None else b.du)
    return Value(re, [x + y for x, y in zip(a.du, b.du, strict=True)])


def add_operators(a: OperatorValue, b: OperatorValue) -> OperatorValue:
    return (*map(add, a, b), *a[len(b) :], *b[len(a) :])


def turned(a: tuple[Value, Value], b: tuple[Value, Value]) -> tuple[Value, Value]:
    (c1, s1), (c2, s2) = a, b
    both_sines = product_of(np.multiply, s1, s2).map(lambda x: -x)
    cosine = add(product_of(np.multiply, c1, c2), both_sines)
    return cosine, add(product_of(np.multiply, s1, c2), product_of(np.multiply, c1, s2))


def entry(a: Value, place: int | tuple[int, int]) -> Value:
    return a.map(lambda x: scalar_array(x[place]))


def stack(values: list[Value]) -> Value:
    dual = any(v.du is not None for v in values)
    re = [np.stack([v.re[k] for v in values]) for k in range(values[0].depth + 1)]
    if not dual:
        return Value(re)
    full = [Value([0 * x for x in v.re] if v.du is None else v.du).re for v in values]
    return Value(re, [np.stack([jet[k] for jet in full]) for k in range(len(re))])


def beside(values: list[Value]) -> Value:
    """Returns scalars as a row, columns as a matrix."""

    def row(jets: list[Jet]) -> Jet:
        return [np.stack([jet[k] for jet in jets], axis=-1) for k in range(values[0].depth + 1)]

    duals = [value.du for value in values if value.du is not None]
    return Value(row([value.re for value in values]), row(duals) if duals else None)


def is_zero(value: Value) -> bool:
    """True if all derivatives are 0, including the dual part."""
    return not any(bool(x != 0) for jet in (*value.re, *(value.du or ())) for x in jet.ravel())


def vanishes(value: Value) -> bool:
    """True if the real part is 0 at the instant, so that division by the value is impossible."""
    return all(not bool(x != 0) for x in value.re[0].ravel())


def dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return scalar_array(sum((x * y for x, y in zip(a[1:], b[1:], strict=True)), start=a[0] * b[0]))


def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Returns cᵢ = εᵢⱼₖ aⱼ bₖ."""
    result = [None, None, None]
    for i, j, k, sign in LEVI_CIVITA:
        addend = a[j] * b[k] if sign > 0 else -(a[j] * b[k])
        result[i] = addend if result[i] is None else result[i] + addend
    return np.array(result, dtype=object)


def outer(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.array([[x * y for y in b] for x in a], dtype=object)


def skew(x: np.ndarray) -> np.ndarray:
    """Returns x̃ᵢₖ = −εᵢₖⱼ xⱼ, so that x̃ y = x × y."""
    result = np.empty((3, 3), dtype=object)
    for i in range(3):
        result[i, i] = x[0] * 0
    for i, j, k, sign in LEVI_CIVITA:
        result[i, k] = x[j] if sign > 0 else -x[j]
    return result


def twice_vect(a: np.ndarray) -> np.ndarray:
    """Returns 2 vect(A)ᵢ = −εᵢⱼₖ Aⱼₖ."""
    result = [None, None, None]
    for i, j, k, sign in LEVI_CIVITA:
        addend = -a[j, k] if sign > 0 else a[j, k]
        result[i] = addend if result[i] is None else result[i] + addend
    return np.array(result, dtype=object)


def double_cofactors(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Returns εⱼₖₗ εᵢₘₙ aₖₘ bₗₙ."""
    result = np.empty((3, 3), dtype=object)
    for (j, k, m, sign), (i, p, q, other) in product(LEVI_CIVITA, LEVI_CIVITA):
        addend = a[k, p] * b[m, q]
        addend = addend if sign * other > 0 else -addend
        result[i, j] = addend if result[i, j] is None else result[i, j] + addend
    return result


def first_row_by_first_column(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return dot(a[0], b[:, 0])


BILINEAR: dict[str, Callable[[Any, Any], Any]] = {"dot": dot, "cross": cross, "outer": outer}
LINEAR: dict[str, Callable[[Any], Any]] = {
    "neg": lambda x: -x,
    "skew": skew,
    "transpose": lambda x: x.T,
    "vec": lambda x: x.T.ravel(),
    "trace": lambda a: scalar_array(sum((a[i, i] for i in range(1, len(a))), start=a[0, 0])),
}
DOUBLED: dict[str, Callable[[Any], Any]] = {
    "vect": twice_vect,
    "symmetric": lambda a: a + a.T,
    "antisymmetric": lambda a: a - a.T,
}
