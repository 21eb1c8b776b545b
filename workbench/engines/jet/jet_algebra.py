"""Operations on jets that need the scalars of the ring: constants, quotients, determinants, inverses,
norms."""

from __future__ import annotations

import operator
from collections.abc import Sequence
from math import comb
from operator import itemgetter
from typing import Any, Protocol

import numpy as np

from workbench.engines.jet.components import (
    Jet,
    Value,
    add,
    dot,
    double_cofactors,
    entry,
    first_row_by_first_column,
    is_zero,
    leibniz,
    product_of,
    scalar_array,
    stack,
    vanishes,
)
from workbench.engines.jet.jet_quaternions import conjugated


class Ring(Protocol):
    """The ring of the scalars of a computation."""

    def constant(self, numerator: int, denominator: int) -> Any: ...

    def divide(self, a: Any, b: Any) -> Any: ...

    def root(self, square: Any) -> Any:
        """Returns the non-negative root; raises NotExact if the ring has none."""


class JetAlgebra:
    """Operations on values that divide, take roots or need a constant of the ring."""

    def __init__(self, ring: Ring) -> None:
        self.ring = ring

    def constant(self, numerator: int, denominator: int, depth: int) -> Value:
        zero = self.ring.constant(0, 1)
        value = self.ring.constant(numerator, denominator)
        return Value([scalar_array(value), *(scalar_array(zero) for _ in range(depth))])

    def filled(self, shape: tuple[int, ...]) -> np.ndarray:
        array = np.empty(shape, dtype=object)
        array[...] = self.ring.constant(0, 1)
        return array

    def diagonal(self, size: int, value: int, depth: int) -> Value:
        jets = [self.filled((size, size)) for _ in range(depth + 1)]
        for i in range(size):
            jets[0][i, i] = self.ring.constant(value, 1)
        return Value(jets)

    def adjugate(self, a: Value) -> Value:
        """Returns adj(A)ᵢⱼ = ½ εⱼₖₗ εᵢₘₙ Aₖₘ Aₗₙ."""
        return product_of(np.multiply, self.constant(1, 2, a.depth), product_of(double_cofactors, a, a))

    def det(self, a: Value) -> Value:
        """Returns det A = a₁ⱼ adj(A)ⱼ₁; for sizes other than 3 by minors, row by row."""
        if a.re[0].shape != (3, 3):
            return self._by_minors(a, len(a.re[0]))
        return product_of(first_row_by_first_column, a, self.adjugate(a))

    def _by_minors(self, a: Value, size: int) -> Value:
        """Returns the determinant by the minors of the first k rows and any k columns, for k = 1, 2, …."""
        minors: dict[tuple[int, ...], Value] = {(): self.constant(1, 1, a.depth)}
        for row in range(size):
            wider: dict[tuple[int, ...], Value] = {}
            for columns, minor in minors.items():
                for j in set(range(size)) - set(columns):
                    addend = product_of(np.multiply, minor, entry(a, (row, j)))
                    if sum(column > j for column in columns) % 2:
                        addend = addend.map(operator.neg)
                    key = tuple(sorted((*columns, j)))
                    wider[key] = add(wider[key], addend) if key in wider else addend
            minors = wider
        return minors[tuple(range(size))]

    def quaternion_inverse(self, q: Value) -> Value:
        """Returns the conjugate over q₀² + q₁² + q₂² + q₃²."""
        return self.divide(q.map(conjugated), product_of(dot, q, q))

    def inverse(self, a: Value) -> Value:
        shape = a.re[0].shape
        if shape == ():
            return self.divide(self.constant(1, 1, a.depth), a)
        if shape == (3, 3):
            return self.divide(self.adjugate(a), self.det(a))
        rows = len(a.re[0])
        for size in sorted(range(1, rows), key=lambda k: abs(2 * k - rows)):
            if is_zero(a.map(itemgetter((slice(size), slice(size, None))))):
                return self._lower_inverse(a, size)
            if is_zero(a.map(itemgetter((slice(size, None), slice(size))))):
                return self._lower_inverse(a.map(np.transpose), size).map(np.transpose)
        return self._gauss_jordan(a)

    def _lower_inverse(self, a: Value, size: int) -> Value:
        """Returns X with A X = I for A = [P 0; Q S], column block by column block: P X₁ = I, S X₂ = −Q X₁."""
        upper = self.inverse(a.map(lambda x: x[:size, :size]))
        lower = self.inverse(a.map(lambda x: x[size:, size:]))
        moved = product_of(np.matmul, a.map(lambda x: -x[size:, :size]), upper)
        corner = product_of(np.matmul, lower, moved)
        rest = self.filled((size, len(a.re[0]) - size))

        def joined(parts: Sequence[Jet]) -> Jet:
            return [np.block([[p, rest], [q, s]]) for p, q, s in zip(*parts, strict=True)]

        blocks = (upper, corner, lower)
        duals = [block.du for block in blocks if block.du is not None]
        return Value(joined([block.re for block in blocks]), joined(duals) if duals else None)

    def _gauss_jordan(self, a: Value) -> Value:
        """Returns the inverse of a square block matrix, pivot by pivot; no pivot may vanish identically."""
        size = len(a.re[0])
        rows = [[entry(a, (i, j)) for j in range(size)] for i in range(size)]
        unit = self.diagonal(size, 1, a.depth)
        for i in range(size):
            rows[i] += [entry(unit, (i, j)) for j in range(size)]
        for column in range(size):
            place = next((i for i in range(column, size) if not vanishes(rows[i][column])), None)
            if place is None:
                raise ZeroDivisionError("a singular matrix has no inverse")
            rows[column], rows[place] = rows[place], rows[column]
            pivot = rows[column][column]
            rows[column] = [self.divide(entry, pivot) for entry in rows[column]]
            for i in range(size):
                factor = rows[i][column]
                if i != column and not is_zero(factor):
                    minus = factor.map(lambda x: -x)
                    rows[i] = [
                        add(entry, product_of(np.multiply, minus, top))
                        for entry, top in zip(rows[i], rows[column], strict=True)
                    ]
        return stack([stack(row[size:]) for row in rows])

    def divide(self, a: Value, b: Value) -> Value:
        """Returns q with q b = a, order by order; for duals (a + ε a₀)/(b + ε b₀) = q + ε (a₀ − q b₀)/b."""
        re = self._divide_jets(a.re, b.re)
        if a.du is None and b.du is None:
            return Value(re)
        rest = [np.asarray(0 * x, dtype=object) for x in a.re] if a.du is None else a.du
        if b.du is not None:
            rest = [x - y for x, y in zip(rest, leibniz(np.multiply, re, b.du), strict=True)]
        return Value(re, self._divide_jets(rest, b.re))

    def _divide_jets(self, a: Jet, b: Jet) -> Jet:
        divide = np.frompyfunc(self.ring.divide, 2, 1)
        quotient: Jet = []
        for k, top in enumerate(a):
            for j, q in enumerate(quotient):
                top = top - q * (b[k - j] * self.ring.constant(comb(k, j), 1))
            quotient.append(divide(top, b[0]))
        return quotient

    def norm(self, x: Value) -> Value:
        """Returns N with N² = x·x, order by order; for a dual norm N + ε x·x₀/N, Eq. (74)."""
        squared = np.multiply if x.re[0].shape == () else dot
        norm = self._root_jets(leibniz(squared, x.re, x.re))
        if x.du is None:
            return Value(norm)
        return Value(norm, self._divide_jets(leibniz(squared, x.re, x.du), norm))

    def root(self, square: Value) -> Value:
        """Returns N with N² = square, order by order; the dual part is half that of the square over N."""
        root = self._root_jets(square.re)
        if square.du is None:
            return Value(root)
        return Value(root, self._divide_jets(square.du, [2 * x for x in root]))

    def _root_jets(self, square: Jet) -> Jet:
        norm: Jet = [self.ring.root(square[0][()])]
        for k in range(1, len(square)):
            rest = square[k]
            for j in range(1, k):
                rest = rest - norm[j] * norm[k - j] * self.ring.constant(comb(k, j), 1)
            norm += self._divide_jets([rest], [norm[0] * self.ring.constant(2, 1)])
        return norm
