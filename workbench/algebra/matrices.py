"""Matrices of ring elements as tuples of rows: 3-vectors are columns, tensors are 3×3.

Entries need +, − and ×, and division by 2 for the symmetric part: polynomials, or dual numbers over them.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import reduce as fold
from typing import Any

from workbench.algebra.dual import Dual

Entry = Any
Matrix = tuple[tuple[Entry, ...], ...]


def matrix(entries: Iterable[Entry], columns: int) -> Matrix:
    entries = list(entries)
    return tuple(tuple(entries[i : i + columns]) for i in range(0, len(entries), columns))


def kronecker(a: Matrix, b: Matrix) -> Matrix:
    """Returns A ⊗ B, the blocks a_ij B."""
    return tuple(tuple(x * y for x in left for y in right) for left in a for right in b)


def add(a: Matrix, b: Matrix) -> Matrix:
    return tuple(tuple(x + y for x, y in zip(*rows, strict=True)) for rows in zip(a, b, strict=True))


def scale(factor: Entry, a: Matrix) -> Matrix:
    return tuple(tuple(factor * entry for entry in row) for row in a)


def product(a: Matrix, b: Matrix) -> Matrix:
    columns = list(zip(*b, strict=True))
    return tuple(tuple(sum_of_products(row, column) for column in columns) for row in a)


def sum_of_products(row: Iterable[Entry], column: Iterable[Entry]) -> Entry:
    return fold(lambda total, product: total + product, (x * y for x, y in zip(row, column, strict=True)))


def transpose(a: Matrix) -> Matrix:
    return tuple(zip(*a, strict=True))


def trace(a: Matrix) -> Entry:
    return fold(lambda total, entry: total + entry, (a[i][i] for i in range(len(a))))


def cross(a: Iterable[Entry], b: Iterable[Entry]) -> tuple[Entry, Entry, Entry]:
    (a1, a2, a3), (b1, b2, b3) = a, b
    return (a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1)


def skew(x: Iterable[Entry]) -> Matrix:
    x1, x2, x3 = x
    return ((0 * x1, -x3, x2), (x3, 0 * x1, -x1), (-x2, x1, 0 * x1))


def adjugate(a: Matrix) -> Matrix:
    """Returns the adjugate; its columns are cross products of the rows: a · (a₂×a₃, a₃×a₁, a₁×a₂) = det(a)
    I."""
    r1, r2, r3 = a
    return transpose((cross(r2, r3), cross(r3, r1), cross(r1, r2)))


def det(a: Matrix) -> Entry:
    r1, r2, r3 = a
    return sum_of_products(r1, cross(r2, r3))


def on_entries(a: Matrix, rows: int) -> Matrix:
    """Returns the Kronecker product of `a` and I, which combines blocks of `rows` rows as `a` combines
    numbers."""
    return tuple(
        tuple(entry if i == j else 0 * entry for entry in row for j in range(rows))
        for row in a
        for i in range(rows)
    )


def flat(a: Matrix) -> list[Entry]:
    return [entry for row in a for entry in row]


def symmetric(a: Matrix, sign: int) -> Matrix:
    turned = transpose(a)
    return tuple(
        tuple((x + sign * y) / 2 for x, y in zip(*rows, strict=True)) for rows in zip(a, turned, strict=True)
    )


def vect(a: Matrix) -> Matrix:
    return (((a[2][1] - a[1][2]) / 2,), ((a[0][2] - a[2][0]) / 2,), ((a[1][0] - a[0][1]) / 2,))


def real_part(entry: Entry) -> Entry:
    return entry.re if isinstance(entry, Dual) else entry


def dual_part(entry: Entry) -> Entry:
    return entry.du if isinstance(entry, Dual) else 0 * entry
