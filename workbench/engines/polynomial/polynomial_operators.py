"""Operators Σ Aₖ Dᵏ of the polynomial engine, as (A₀, A₁, …), and operations that also apply to matrices."""

from __future__ import annotations

from collections.abc import Callable

from workbench.algebra.differential_ring import Polynomial
from workbench.algebra.matrices import Entry, Matrix, add, product, scale
from workbench.engines.inventory import NotExact
from workbench.engines.polynomial.polynomial_matrices import ExactAlgebra

Operator = tuple[Matrix, ...]


def is_operator(value: Matrix | Operator) -> bool:
    return isinstance(value[0][0], tuple)


def as_operator(value: Matrix | Operator) -> Operator:
    return value if is_operator(value) else (value,)


def add_operators(a: Operator, b: Operator) -> Operator:
    return (*map(add, a, b), *a[len(b) :], *b[len(a) :])


def composed(algebra: ExactAlgebra, left: Operator, right: Operator) -> Operator:
    """Returns the product by D·A = Ȧ + A·D, applied once for each power of D on the left."""
    total: Operator = (algebra.diagonal(0),)
    shifted = right
    for power, coefficient in enumerate(left):
        if power:
            rates = tuple(algebra.map(algebra.ring.derive, a) for a in shifted)
            shifted = add_operators((algebra.diagonal(0), *shifted), rates)
        total = add_operators(total, tuple(product(coefficient, a) for a in shifted))
    return total


def acted(algebra: ExactAlgebra, operator: Operator, value: Matrix) -> Matrix:
    """Returns the operator applied to a matrix of three rows. Raises NotExact for another number of rows."""
    if len(value) != 3:
        raise NotExact("an operator with 3×3 coefficients on a block matrix of other rows")
    total = product(operator[0], value)
    for coefficient in operator[1:]:
        value = algebra.map(algebra.ring.derive, value)
        total = add(total, product(coefficient, value))
    return total


def scaled(factor: Entry, value: Matrix | Operator) -> Matrix | Operator:
    if is_operator(value):
        return tuple(scale(factor, matrix) for matrix in value)
    return scale(factor, value)


def mapped(
    algebra: ExactAlgebra, function: Callable[[Polynomial], Polynomial], value: Matrix | Operator
) -> Matrix | Operator:
    """Returns the function applied to each polynomial."""
    if is_operator(value):
        return tuple(algebra.map(function, matrix) for matrix in value)
    return algebra.map(function, value)
