"""Matrices over the ring of the polynomial engine: constants, and the adjunction of reciprocals and roots."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import nullcontext
from fractions import Fraction
from math import isqrt

from workbench.algebra.differential_ring import DifferentialRing, Polynomial
from workbench.algebra.dual import Dual
from workbench.algebra.matrices import (
    Entry,
    Matrix,
    add,
    adjugate,
    det,
    dual_part,
    product,
    real_part,
    scale,
    trace,
    transpose,
)
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.inventory import Inventory


class ExactAlgebra:
    """The ring of some parameters, with one generator reserved for each norm and each reciprocal."""

    def __init__(self, inventory: Inventory, parameters: Iterable[str]) -> None:
        self._norm_names = [f"norm{i}" for i in reversed(range(inventory.norms))]
        self._reciprocal_names = [f"reciprocal{i}" for i in range(inventory.reciprocals)]
        self.ring = DifferentialRing([*self._norm_names, *parameters, *self._reciprocal_names])
        self._norms: list[tuple[str, Polynomial]] = []
        self._are_of_turns = not inventory.has_roots

    @property
    def norms(self) -> frozenset[str]:
        """The generators that stand for norms; norms are never negative."""
        return frozenset(self._norm_names)

    @property
    def radicands(self) -> list[Polynomial]:
        """The squares of the norms so far."""
        return [square for _, square in self._norms]

    def at(self, p: Polynomial, values: dict[str, Fraction]) -> Fraction:
        """Returns the value of a polynomial at values of its generators, including those of norms and
        reciprocals."""
        places = {name: place for place, name in enumerate(self.ring.names)}
        adjoined = {}
        for name, square in self._norms:
            if p.degrees()[places[name]] > 0:
                adjoined[name] = _rational_root(self.at(square, values))
        for name, denominator in self.ring.reciprocals:  # within a norm
            if p.degrees()[places[name]] > 0:
                below = self.at(denominator, values)
                if below == 0:
                    raise NotExact("a denominator that vanishes at a point")
                adjoined[name] = 1 / below
        return self.ring.at(p, {**values, **adjoined})

    def diagonal(self, value: int, rows: int = 3, columns: int | None = None) -> Matrix:
        """Returns the matrix with the value on its diagonal and 0 elsewhere."""
        return tuple(
            tuple(self.ring.constant(value if i == j else 0) for j in range(columns or rows))
            for i in range(rows)
        )

    def polynomial(self, entry: Polynomial | int) -> Polynomial:
        return self.ring.constant(entry) if isinstance(entry, int) else entry

    def map(self, function: Callable[[Polynomial], Polynomial], matrix: Matrix) -> Matrix:
        """Returns a linear function applied to each polynomial, real parts and dual parts alike."""
        return tuple(
            tuple(
                Dual(function(self.polynomial(e.re)), function(self.polynomial(e.du)))
                if isinstance(e, Dual)
                else function(self.polynomial(e))
                for e in row
            )
            for row in matrix
        )

    def reciprocal(self, entry: Entry) -> Entry:
        """Returns 1/p, or 1/(p + ε p₀) = 1/p − ε p₀/p². Raises ZeroDivisionError if p is identically zero."""
        if isinstance(entry, Dual):
            z = self.reciprocal(entry.re)
            return Dual(z, -entry.du * z**2)
        z, factor = self.ring.reciprocal(self.ring.reduce(entry), self._reciprocal_names)
        return self.ring.constant(factor) * z

    def inverse(self, matrix: Matrix) -> Matrix:
        """Returns A⁻¹ = adj A / det A.

        For block matrices both come from Faddeev and LeVerrier's recurrence; a block triangular matrix is
        inverted by blocks: [A 0; C D]⁻¹ = [A⁻¹ 0; −D⁻¹ C A⁻¹ D⁻¹].
        """
        if len(matrix) == 1:
            return ((self.reciprocal(matrix[0][0]),),)
        if len(matrix) == 3:
            cofactors, determinant = adjugate(matrix), det(matrix)
        elif (place := self._zeros_above(matrix)) is not None:
            return self._triangular_inverse(matrix, place)
        elif (place := self._zeros_above(transpose(matrix))) is not None:
            return transpose(self._triangular_inverse(transpose(matrix), place))
        else:
            cofactors, determinant = self._faddeev_leverrier(matrix)
        return scale(self.reciprocal(determinant), cofactors)

    def determinant(self, matrix: Matrix) -> Entry:
        return det(matrix) if len(matrix) == 3 else self._faddeev_leverrier(matrix)[1]

    def _zeros_above(self, matrix: Matrix) -> int | None:
        """Returns the size of A, as near to one half as possible, if the matrix is [A 0; C D]; else None."""
        size = len(matrix)
        for place in sorted(range(1, size), key=lambda p: abs(2 * p - size)):
            corner = self.map(self.ring.reduce, tuple(row[place:] for row in matrix[:place]))
            if all(real_part(e) == 0 and dual_part(e) == 0 for row in corner for e in row):
                return place
        return None

    def _triangular_inverse(self, matrix: Matrix, place: int) -> Matrix:
        first = self.inverse(tuple(row[:place] for row in matrix[:place]))
        last = self.inverse(tuple(row[place:] for row in matrix[place:]))
        below = tuple(row[:place] for row in matrix[place:])
        corner = scale(
            self.ring.constant(-1), product(last, self.map(self.ring.reduce, product(below, first)))
        )
        none = self.diagonal(0, place, len(matrix) - place)
        above = [(*a, *b) for a, b in zip(first, none, strict=True)]
        return (*above, *((*c, *d) for c, d in zip(corner, last, strict=True)))

    def _faddeev_leverrier(self, matrix: Matrix) -> tuple[Matrix, Entry]:
        size = len(matrix)
        adjugate = self.diagonal(1, size)
        for k in range(1, size + 1):
            step = self.map(self.ring.reduce, product(matrix, adjugate))
            coefficient = self.ring.constant(Fraction(-1, k)) * trace(step)
            if k < size:
                adjugate = add(step, scale(coefficient, self.diagonal(1, size)))
        sign = self.ring.constant((-1) ** (size - 1))
        return scale(sign, adjugate), self.ring.constant((-1) ** size) * coefficient

    def norm(self, matrix: Matrix) -> Entry:
        """Returns N with N² = x·x; for a dual vector N + ε x·x₀/N, Eq. (74), if Re x ≠ 0."""
        entries = [entry for row in matrix for entry in row]
        norm = self._root(self.ring.reduce(sum((real_part(e) ** 2 for e in entries), self.ring.zero)))
        if not any(isinstance(entry, Dual) for entry in entries):
            return norm
        mixed = sum((e.re * e.du for e in entries if isinstance(e, Dual)), self.ring.zero)
        return Dual(norm, mixed * self.reciprocal(norm))

    def root(self, matrix: Matrix, is_nonnegative: bool) -> Matrix:
        """Returns √p, or √p + ε q/(2 √p) for p + ε q. p must be non-negative, such as a sum of squares."""
        ((entry,),) = matrix
        square = self.ring.reduce(real_part(entry))
        if not (is_nonnegative or self._is_sum_of_squares(square)):
            raise NotExact("the root of what is not seen to be a sum of squares")
        root = self._root(square)
        if not isinstance(entry, Dual):
            return ((root,),)
        return ((Dual(root, entry.du * self.reciprocal(root + root)),),)

    def _is_sum_of_squares(self, p: Polynomial) -> bool:
        places = [i for i, name in enumerate(self.ring.names) if name not in self.norms]
        return all(c > 0 and not any(e[i] % 2 for i in places) for e, c in p.terms())

    def _root(self, square: Polynomial) -> Polynomial:
        """Returns the indeterminate N with N² = square; squares of numbers are extracted: |−2x| is 2|x|."""
        if not square:
            raise NotExact("the norm of zero")
        factor = square.leading_coefficient()
        p, q = isqrt(abs(int(factor.p))), isqrt(int(factor.q))
        if Fraction(p * p, q * q) != Fraction(int(factor.p), int(factor.q)):
            p = q = 1
        outside = self.ring.constant(Fraction(p, q))
        square = square / (outside * outside).leading_coefficient()
        if square == self.ring.one:
            return outside
        for base, power in self._factors(square):
            outside = outside * self._root_generator(base) ** power
        return outside

    def _factors(self, square: Polynomial) -> list[tuple[Polynomial, int]]:
        """Returns sums of squares and their powers whose product is the square, so that ‖p q‖ is ‖p‖ ‖q‖.

        Returns the square alone if it is no such product, or if too few generators for roots remain.
        """
        if square.leading_coefficient() != 1 or not self._is_sum_of_squares(square):
            return [(square, 1)]
        found = []
        for factor, power in square.factor()[1]:
            monic = factor / factor.leading_coefficient()
            if self._is_sum_of_squares(monic):
                found.append((monic, power))
            elif power % 2:
                return [(square, 1)]
            else:
                found.append((monic * monic, power // 2))
        known = [root for _, root in self._norms]
        spare = len(self._norm_names) - len(known)
        return found if sum(base not in known for base, _ in found) <= spare else [(square, 1)]

    def _root_generator(self, square: Polynomial) -> Polynomial:
        for name, known in self._norms:
            if known == square:
                return self.ring.generators[name]
        if len(self._norms) == len(self._norm_names):
            raise NotExact("more roots than generators were set aside for")
        name = self._norm_names[len(self._norm_names) - 1 - len(self._norms)]
        self._norms.append((name, square))
        self.ring.square_as(name, square)
        norm = self.ring.generators[name]
        half = self.ring.constant(Fraction(1, 2))
        self.ring.derive_by(name, lambda derivation: half * derivation(square) * self._over(norm))
        return norm

    def _over(self, norm: Polynomial) -> Entry:
        """Returns 1/‖x‖ for a derivative; for exp x̃ the quotients are limits at x = 0."""
        with self.ring.removable() if self._are_of_turns else nullcontext():
            return self.reciprocal(norm)


def _rational_root(square: Fraction) -> Fraction:
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    if root * root != square:
        raise NotExact(f"{square} has no rational root")
    return root
