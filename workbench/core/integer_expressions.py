"""Integer expressions such as n, n+1 or n-k-1: indices, derivative orders, exponents, sum bounds, weights."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Linear:
    """constant + Σ coefficient·variable, all integers; variables sorted, no coefficient 0."""

    constant: int = 0
    coefficients: tuple[tuple[str, int], ...] = ()

    @staticmethod
    def variable(name: str) -> Linear:
        return Linear(0, ((name, 1),))

    @property
    def is_number(self) -> bool:
        return not self.coefficients

    @property
    def variables(self) -> frozenset[str]:
        return frozenset(name for name, _ in self.coefficients)

    def coefficient(self, name: str) -> int:
        return dict(self.coefficients).get(name, 0)

    def __add__(self, other: Linear | int) -> Linear:
        other = as_linear(other)
        merged = dict(self.coefficients)
        for name, coefficient in other.coefficients:
            merged[name] = merged.get(name, 0) + coefficient
        kept = tuple(sorted((n, c) for n, c in merged.items() if c))
        return Linear(self.constant + other.constant, kept)

    def __mul__(self, factor: int) -> Linear:
        if factor == 0:
            return Linear(0)
        return Linear(self.constant * factor, tuple((n, c * factor) for n, c in self.coefficients))

    __rmul__ = __mul__

    def __neg__(self) -> Linear:
        return self * -1

    def __sub__(self, other: Linear | int) -> Linear:
        return self + -as_linear(other)

    def substitute(self, values: Mapping[str, Linear | int]) -> Linear:
        result = Linear(self.constant)
        for name, coefficient in self.coefficients:
            value = values.get(name)
            replacement = Linear.variable(name) if value is None else as_linear(value)
            result = result + replacement * coefficient
        return result

    def __int__(self) -> int:
        if self.coefficients:
            raise ValueError(f"{self} is not a number: {', '.join(sorted(self.variables))} unbound")
        return self.constant

    def __str__(self) -> str:
        text = ""
        for name, coefficient in self.coefficients:
            sign = "-" if coefficient < 0 else "+" if text else ""
            size = "" if abs(coefficient) == 1 else str(abs(coefficient))
            text += f"{sign}{size}{name}"
        if self.constant or not text:
            text += f"{self.constant:+d}" if text else str(self.constant)
        return text


def as_linear(value: Linear | int) -> Linear:
    return value if isinstance(value, Linear) else Linear(value)
