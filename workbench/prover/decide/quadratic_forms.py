"""Quadratic forms: their coefficients as terms, and their stationary points.

With the unknown components y the form is c + 2 b·y + y·A y. The sums cₖ of the principal minors of A are the
elementary symmetric functions of its eigenvalues. If A has the rank r, and c_r is not 0, then by Cayley and
Hamilton, for each b in the range of A,

    y* = −(1/c_r) Σ_{k<r} (−1)^{r−1−k} cₖ A^{r−1−k} b    has    A y* = −b
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, reduce
from itertools import combinations

from workbench.core.construct import apply, block, number, power, relation, zero
from workbench.core.terms import Relation, Term
from workbench.prover.decide.objective import Objective


@dataclass
class Quadratic:
    """The form: f, or f² for a norm; −f for a greatest value."""

    varied: Objective
    least_asked: bool

    @cached_property
    def coefficients(self) -> tuple[list[list[Term]], list[Term], Term]:
        """The coefficients A, b and c."""
        count = range(self.varied.count)
        if self.varied.inside is not None:
            rest, columns = self.columns
            matrix = [[_product(columns[i], columns[j]) for j in count] for i in count]
            return matrix, [_product(column, rest) for column in columns], power(rest, 2)

        def at(values: dict[int, int]) -> Term:
            value = self.varied.at(values)
            return value if self.least_asked else apply("neg", value)

        rest, half, quarter = at({}), number(Fraction(1, 2)), number(Fraction(1, 4))
        plus, less = [at({i: 1}) for i in count], [at({i: -1}) for i in count]
        slopes = [times(quarter, minus(plus[i], less[i])) for i in count]
        diagonal = [minus(times(half, total([plus[i], less[i]])), rest) for i in count]
        matrix = [[diagonal[i] for j in count] for i in count]
        for i, j in combinations(count, 2):
            mixed = minus(total([at({i: 1, j: 1}), rest]), total([plus[i], plus[j]]))
            matrix[i][j] = matrix[j][i] = times(half, mixed)
        return matrix, slopes, rest

    @cached_property
    def columns(self) -> tuple[Term, list[Term]]:
        """For a norm, p and the columns of L."""
        at = self.varied.inside_at
        return at({}), [minus(at({i: 1}), at({})) for i in range(self.varied.count)]

    def written_out(self) -> Term:
        matrix, slopes, rest = self.coefficients
        y = self.varied.unknowns
        linear = [times(number(2), times(b, x)) for b, x in zip(slopes, y, strict=True)]
        square = [times(a, times(y[i], y[j])) for i, row in enumerate(matrix) for j, a in enumerate(row)]
        return total([rest, *linear, *square])

    @cached_property
    def invariants(self) -> list[Term]:
        """The sums of the principal minors: c₀ = 1, c₁ = tr A, …."""
        matrix = self.coefficients[0]
        found: list[Term] = [number(1)]
        for size in range(1, self.varied.count + 1):
            minors = [
                matrix[rows[0]][rows[0]]
                if size == 1
                else apply("det", block([[matrix[i][j] for j in rows] for i in rows]))
                for rows in combinations(range(self.varied.count), size)
            ]
            found.append(total(minors))
        return found

    @cached_property
    def vanishing(self) -> tuple[Relation, ...]:
        """The equations A = 0; for a norm, its columns are 0."""
        if self.varied.inside is not None:
            return tuple(relation("=", column, zero(column.type)) for column in self.columns[1])
        return tuple(relation("=", a, zero()) for row in self.coefficients[0] for a in row)

    def value_at_rank(self, rank: int) -> Term:
        """Returns the value c + b·y*."""
        _, slopes, rest = self.coefficients
        if not rank:
            return rest
        change = total(list(map(times, slopes, self.stationary(rank))))
        return total([rest, apply("div", change, self.invariants[rank])])

    def stationary(self, rank: int) -> list[Term]:
        """Returns c_r y*, for a rank r of 1 or more."""
        matrix, slopes, _ = self.coefficients
        powers = [slopes]
        for _ in range(rank - 1):
            powers.append([total(list(map(times, row, powers[-1]))) for row in matrix])
        found = []
        for i in range(self.varied.count):
            terms = []
            for k in range(rank):
                term = times(self.invariants[k], powers[rank - 1 - k][i])
                terms.append(apply("neg", term) if (rank - k) % 2 else term)
            found.append(total(terms))
        return found


def total(terms: Sequence[Term]) -> Term:
    return reduce(lambda one, other: apply("add", one, other), terms)


def minus(one: Term, other: Term) -> Term:
    return apply("add", one, apply("neg", other))


def times(one: Term, other: Term) -> Term:
    return apply("mul", one, other)


def _product(one: Term, other: Term) -> Term:
    return times(one, other) if one.type.kind == "scalar" else apply("dot", one, other)


def solved(rows: list[list[Fraction]]) -> list[Fraction] | None:
    """Returns x with A x = b for the rows (A | b), free unknowns set to 0; None if there is none."""
    rows, pivots = [list(row) for row in rows], list[int]()
    for column in range(len(rows)):
        place = next((i for i in range(len(pivots), len(rows)) if rows[i][column]), None)
        if place is None:
            continue
        top = len(pivots)
        rows[top], rows[place] = rows[place], rows[top]
        rows[top] = [entry / rows[top][column] for entry in rows[top]]
        for i, row in enumerate(rows):
            if i != top and row[column]:
                rows[i] = [a - row[column] * b for a, b in zip(row, rows[top], strict=True)]
        pivots.append(column)
    if any(row[-1] for row in rows[len(pivots) :]):
        return None
    solution = [Fraction(0)] * len(rows)
    for row, column in zip(rows, pivots, strict=False):
        solution[column] = row[-1]
    return solution
