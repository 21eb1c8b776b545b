"""Random curves of what a symbol is declared to be: vectors, unit vectors, rotations, dual ones, matrices."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from evaluator.series import (
    Matrix,
    Series,
    added,
    added_up,
    constant,
    product,
    scaled,
    skew,
    turned,
    unit,
)
from mpmath import mpf

from workbench.core.terms import Symbol


def drawn(symbol: Symbol, curve: Callable[[], Series], fixed: Sequence[object] | None = None) -> Matrix:
    """A curve of what the symbol is declared to be, from curves of numbers. fixed: its components at t = 0."""
    declaration, type_ = symbol.declaration, symbol.type

    def curves(count: int) -> list[Series]:
        found = [curve() for _ in range(count)]
        if fixed is not None:
            found = [Series((mpf(v), *x.re[1:]), x.du) for v, x in zip(fixed, found, strict=True)]
        return [constant(x.re[0]) for x in found] if declaration.constant else found

    def column(entries: list[Series]) -> Matrix:
        return [[x] for x in entries]

    def normal(entries: list[Series]) -> list[Series]:
        length = added_up(x * x for x in entries).root().inverse()
        return [x * length for x in entries]

    dual_unit = [[constant(0, 1)]]
    if type_.kind == "quaternion" and declaration.unit:
        q = curves(4)
        if type_.dual:
            q = [Series(x.re, y.re) for x, y in zip(q, curves(4), strict=True)]
        return column(normal(q))
    if declaration.unit:
        u = column(normal(curves(3)))
        if type_.dual:
            u = added(u, product(dual_unit, product(skew(column(curves(3))), u)))
        return u
    if declaration.rotation or declaration.transform:
        w, *v = normal(curves(4))
        axis = skew(column(v))
        turn = scaled(added(product([[w]], axis), product(axis, axis)), 2)
        rotation = added(unit(3), turn)
        if type_.dual:
            moved = added(unit(3), product(dual_unit, skew(column(curves(3)))))
            rotation = product(moved, rotation)
        if declaration.transform:
            rows = [[*row, p] for row, p in zip(rotation, curves(3), strict=True)]
            return [*rows, [constant(0), constant(0), constant(0), constant(1)]]
        return rotation
    rows, columns = type_.rows, type_.columns
    flat = curves(rows * columns)
    found = [flat[i * columns : (i + 1) * columns] for i in range(rows)]
    if type_.dual:
        flat = curves(rows * columns)
        dual = [flat[i * columns : (i + 1) * columns] for i in range(rows)]
        found = added(found, product(dual_unit, dual))
    if declaration.symmetric:
        found = added(found, turned(found))
    if declaration.diagonal:
        found = [[x if i == j else constant(0) for j, x in enumerate(r)] for i, r in enumerate(found)]
    return found
