"""Every rotation tensor is that of a unit quaternion, which is to say of an axis and an angle (Euler).

Of a tensor R put, for a unit quaternion q = (q₀, q₁, q₂, q₃) with R = R(q),

    4 q₀² = 1 + tr R,   4 q₀ qᵢ = 2 (vect R)ᵢ,   4 qᵢ qⱼ = Rᵢⱼ + Rⱼᵢ,   4 qᵢ² = 1 + 2 Rᵢᵢ − tr R

in a symmetric 4×4 matrix K(R). Its trace is 4. Where R Rᵀ = I and adj R = Rᵀ, its 2×2 minors vanish: they
are rational combinations of the entries of R Rᵀ − I, Rᵀ R − I and adj R − Rᵀ. So K = 4 q ⊗ q with q real
and |q| = 1.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any

from workbench.judge.theorems.arguments import Engine, Step, Way, vanishing

Row = list[Any]


def rotations_are_unit_quaternions() -> Step:
    return Step(
        "a rotation tensor R is (q₀² − q·q) I + 2 q ⊗ q + 2 q₀ q̃ of a unit quaternion: K(R) has rank 1"
        " and trace 4",
        Way(
            Engine.FLINT,
            lambda: _checks(_flint_ring(), _flint_rank),
            lambda: _checks(_flint_ring(), _flint_rank, proper=False),
        ),
        Way(
            Engine.SYMPY,
            lambda: _checks(_sympy_ring(), _sympy_rank),
            lambda: _checks(_sympy_ring(), _sympy_rank, proper=False),
        ),
    )


def _checks(entries: Sequence[Any], rank: Any, proper: bool = True) -> Iterator[bool]:
    """Without `proper`, adj R = Rᵀ is not supposed, so that reflections are admitted: these are no R(q)."""
    R = [list(entries[i : i + 3]) for i in (0, 3, 6)]
    K = _quaternion_products(R)
    yield from vanishing(lambda: [K[0][0] + K[1][1] + K[2][2] + K[3][3] - 4])()
    yield from vanishing(lambda: _given_back(R, K))()
    known = [*_products(R, _transposed(R)), *_products(_transposed(R), R)]
    if proper:
        known += [a - b for a, b in zip(_flat(_adjugate(R)), _flat(_transposed(R)), strict=True)]
    minors = [K[a][c] * K[b][d] - K[a][d] * K[b][c] for (a, b), (c, d) in _pairs()]
    yield rank([*known, *minors]) == rank(known)


def _pairs() -> list[tuple[tuple[int, int], tuple[int, int]]]:
    rows = list(combinations(range(4), 2))
    return [(p, q) for p in rows for q in rows if p <= q]


def _quaternion_products(R: list[Row]) -> list[Row]:
    trace = R[0][0] + R[1][1] + R[2][2]
    twice_vect = [R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]]
    K = [[1 + trace, *twice_vect]]
    for i in range(3):
        row = [R[i][j] + R[j][i] if i != j else 1 + 2 * R[i][i] - trace for j in range(3)]
        K.append([twice_vect[i], *row])
    return K


def _given_back(R: list[Row], K: list[Row]) -> Iterator[Any]:
    """4 R(q) − 4 R from the products of the quaternion's components."""
    cross = {
        (2, 1): (0, 1),
        (1, 2): (0, -1),
        (0, 2): (1, 1),
        (2, 0): (1, -1),
        (1, 0): (2, 1),
        (0, 1): (2, -1),
    }
    diagonal = K[0][0] - K[1][1] - K[2][2] - K[3][3]
    for i in range(3):
        for j in range(3):
            entry = 2 * K[i + 1][j + 1]
            if i == j:
                entry = entry + diagonal
            else:
                k, sign = cross[i, j]
                entry = entry + 2 * sign * K[0][k + 1]
            yield entry - 4 * R[i][j]


def _transposed(R: list[Row]) -> list[Row]:
    return [list(row) for row in zip(*R, strict=True)]


def _products(A: list[Row], B: list[Row]) -> list[Any]:
    """The entries of A B − I."""
    return [
        A[i][0] * B[0][j] + A[i][1] * B[1][j] + A[i][2] * B[2][j] - (1 if i == j else 0)
        for i in range(3)
        for j in range(3)
    ]


def _adjugate(R: list[Row]) -> list[Row]:
    def cofactor(i: int, j: int) -> Any:
        (a, b), (c, d) = ((k for k in range(3) if k != j), (k for k in range(3) if k != i))
        return (R[a][c] * R[b][d] - R[a][d] * R[b][c]) * (-1) ** (i + j)

    return [[cofactor(i, j) for j in range(3)] for i in range(3)]


def _flat(R: list[Row]) -> list[Any]:
    return [entry for row in R for entry in row]


def _flint_ring() -> Sequence[Any]:
    from flint import Ordering, fmpq_mpoly_ctx

    return fmpq_mpoly_ctx.get(tuple(f"r{i}" for i in range(9)), Ordering.lex).gens()


def _sympy_ring() -> Sequence[Any]:
    from workbench.judge.second.sympy_gate import QQ, lex, polynomial_ring

    return polynomial_ring([f"r{i}" for i in range(9)], QQ, lex)[1:]


def _coefficients(polynomials: Sequence[Any]) -> list[list[Any]]:
    rows = [dict(p.terms()) for p in polynomials]
    monomials = sorted({monomial for row in rows for monomial in row})
    return [[row.get(monomial, 0) for monomial in monomials] for row in rows]


def _flint_rank(polynomials: Sequence[Any]) -> int:
    from flint import fmpq_mat

    rows = _coefficients(polynomials)
    return fmpq_mat(len(rows), len(rows[0]), [x for row in rows for x in row]).rank()


def _sympy_rank(polynomials: Sequence[Any]) -> int:
    from workbench.judge.second.sympy_gate import QQ, DomainMatrix

    rows = [[QQ.convert(x) for x in row] for row in _coefficients(polynomials)]
    return DomainMatrix(rows, (len(rows), len(rows[0])), QQ).rank()
