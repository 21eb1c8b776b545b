"""Quaternions of the polynomial engine: Hamilton's columns (q₀, q₁, q₂, q₃), multiplied as matrices.

p q = L(p) q,   L(p) = [p₀ −pᵀ; p p₀ I + p̃]
"""

from __future__ import annotations

from workbench.algebra.matrices import Matrix, flat, matrix, product


def left_matrix(q: Matrix) -> Matrix:
    w, x, y, z = flat(q)
    return ((w, -x, -y, -z), (x, w, -z, y), (y, z, w, -x), (z, -y, x, w))


def hamilton(p: Matrix, q: Matrix) -> Matrix:
    return product(left_matrix(p), q)


def conjugate(q: Matrix) -> Matrix:
    w, x, y, z = flat(q)
    return matrix((w, -x, -y, -z), 1)
