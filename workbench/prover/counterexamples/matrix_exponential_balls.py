"""Exponentials of matrices and their rates in balls: by Arb, and by a Taylor sum with a bound of the rest.

With A(t) = Σ Aₖ tᵏ, the coefficients of exp A(t) stand in the first block row of the exponential of the block
matrix with A₀ on the diagonal, A₁ above it, and so on.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import factorial
from typing import Any

from flint import arb, arb_mat

from workbench.core.terms import Symbol
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.parameters import Parameter

#: Addends of the Taylor sum; the bound of the rest is below 1e-20 for norms up to 8.
_ADDENDS = 60


def exponential_at(own: Symbol, jets: Sequence[Any]) -> dict[Parameter, Any]:
    """Returns the values of the symbol and of its rates from the exponent and its rates.

    Raises NotExact if the two ways to compute the exponential are not both finite and in agreement.
    """
    rows, orders = own.type.rows, len(jets)
    size = rows * orders
    entries = [[arb(0)] * size for _ in range(size)]
    for k, jet in enumerate(jets):
        for place in range(orders - k):
            for i in range(rows):
                for j in range(rows):
                    entries[place * rows + i][(place + k) * rows + j] = arb(jet[i, j]) / factorial(k)
    matrix = arb_mat(entries)
    found, again = matrix.exp(), taylor_sum(matrix)
    if not found.overlaps(again) or not all(entry.is_finite() for entry in found.entries()):
        raise NotExact("the exponential of a matrix that is too large")
    return {
        Parameter(own, "value", k, i * rows + j): arb.union(found[i, k * rows + j], again[i, k * rows + j])
        * factorial(k)
        for k in range(orders)
        for i in range(rows)
        for j in range(rows)
    }


def taylor_sum(matrix: arb_mat) -> arb_mat:
    """Returns Σ Aᵏ/k! with ‖A‖ᴺ/N! e^‖A‖ as the radius of each entry, for the largest sum of a row ‖A‖."""
    size = matrix.nrows()
    total = term = arb_mat([[arb(int(i == j)) for j in range(size)] for i in range(size)])
    for k in range(1, _ADDENDS):
        term = term * matrix * (arb(1) / k)
        total = total + term
    norm = max((sum((abs(matrix[i, j]) for j in range(size)), arb(0)) for i in range(size)), key=float)
    bound = (norm**_ADDENDS / factorial(_ADDENDS) * norm.exp()).upper()
    rest = arb(0, bound)
    return arb_mat([[total[i, j] + rest for j in range(size)] for i in range(size)])
