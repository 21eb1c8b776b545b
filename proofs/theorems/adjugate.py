"""The sentence before (48): Φₙ* is `uniquely defined by` Φₙ Φₙ* = (det Φₙ) I."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from typing import Any

from workbench.algebra.differential_ring import DifferentialRing
from workbench.algebra.matrices import Matrix, add, adjugate, det, matrix, product, scale, skew
from workbench.judge.arguments import Engine, Step, Way, argue, vanishing
from workbench.judge.verdict import Counterexample, Verdict


def adjugate_is_unique() -> Verdict:
    """Unique where det Φₙ ≠ 0; for a singular Φₙ any tensor whose columns Φₙ sends to 0 can be added."""
    return argue(
        [
            Step(
                "Φ* (Φ X − (det Φ) I) = (det Φ)(X − Φ*): where det Φ ≠ 0, Φ X = (det Φ) I leaves only X = Φ*",
                Way(Engine.FLINT, vanishing(_cancelled_by_flint), vanishing(lambda: _cancelled_by_flint(2))),
                Way(Engine.SYMPY, vanishing(_cancelled_by_sympy), vanishing(lambda: _cancelled_by_sympy(2))),
            ),
            Step(
                "Φ₁ = ω̃ has Φ₁ (ω ⊗ ω + ω ⊗ c) = 0 = (det Φ₁) I for every c, and Φ₁* = ω ⊗ ω",
                Way(Engine.FRACTIONS, _second_solution, _no_solution),
                Way(Engine.SYMPY, vanishing(_second_solutions), vanishing(lambda: _second_solutions(1))),
                by_example=True,
            ),
        ],
        hypothesis=r"\det \Phi_n \neq 0",
        counterexample=Counterexample(
            values={
                r"\omega": ("1", "0", "0"),
                r"\Phi_1": ("0", "0", "0", "0", "0", "-1", "0", "1", "0"),
                r"\mathbf{X}": ("1", "1", "0", "0", "0", "0", "0", "0", "0"),
            },
            left=("1", "1", "0", "0", "0", "0", "0", "0", "0"),
            right=("1", "0", "0", "0", "0", "0", "0", "0", "0"),
        ),
        reason="a singular tensor has other solutions besides its adjugate",
        scope="all n",
    )


def _cancelled_by_flint(factor: int = 1) -> Iterator[Any]:
    ring = DifferentialRing([f"p{i}" for i in range(9)] + [f"x{i}" for i in range(9)])
    phi, x = (matrix([ring.generators[f"{name}{i}"] for i in range(9)], 3) for name in "px")
    unit = _unit(ring.one, ring.zero)
    determinant = scale(det(phi), unit)
    left = product(adjugate(phi), add(product(phi, x), scale(-ring.one, determinant)))
    right = scale(factor * det(phi), add(x, scale(-ring.one, adjugate(phi))))
    yield from _entries(add(left, scale(-ring.one, right)))


def _cancelled_by_sympy(factor: int = 1) -> Iterator[Any]:
    from sympy import symbols
    from sympy.polys.domains import QQ
    from sympy.polys.matrices import DomainMatrix

    ring = QQ[symbols("p:9 x:9")]
    phi, x = (
        DomainMatrix([list(ring.gens[k + i : k + i + 3]) for i in (0, 3, 6)], (3, 3), ring) for k in (0, 9)
    )
    cofactors, determinant = phi.adjugate(), phi.det()
    left = cofactors * (phi * x - determinant * DomainMatrix.eye(3, ring))
    residual = left - (ring(factor) * determinant) * (x - cofactors)
    yield from (residual[i, j].element for i in range(3) for j in range(3))


_E1 = (Fraction(1), Fraction(0), Fraction(0))
_E2 = (Fraction(0), Fraction(1), Fraction(0))


def _second_solution() -> Iterator[bool]:
    """ω = e₁, c = e₂: X = e₁ ⊗ (e₁ + e₂) is not Φ₁* = e₁ ⊗ e₁, and yet Φ₁ X = 0."""
    yield from _solves(add(_outer(_E1, _E1), _outer(_E1, _E2)))


def _no_solution() -> Iterator[bool]:
    yield from _solves(add(_outer(_E1, _E1), _outer(_E2, _E1)))


def _solves(x: Matrix) -> Iterator[bool]:
    phi = skew(_E1)
    yield det(phi) == 0
    yield x != adjugate(phi) and adjugate(phi) == _outer(_E1, _E1)
    yield all(entry == 0 for entry in _entries(product(phi, x)))


def _second_solutions(along: int = 0) -> Iterator[Any]:
    """Φ₁ (ω ⊗ ω + ω ⊗ c) for symbols ω, c; with `along` ω + e₁ stands left of c."""
    from sympy import Matrix as SympyMatrix
    from sympy import symbols

    omega, c = (SympyMatrix(symbols(f"{name}:3")) for name in "wc")
    left = omega + along * SympyMatrix([1, 0, 0])
    x = omega * omega.T + left * c.T
    columns = [omega.cross(x[:, j]) for j in range(3)]
    for column in columns:
        yield from (entry.expand() for entry in column)


def _outer(a: Iterable[Any], b: Iterable[Any]) -> Matrix:
    return tuple(tuple(x * y for y in b) for x in a)


def _unit(one: Any, zero: Any) -> Matrix:
    return tuple(tuple(one if i == j else zero for j in range(3)) for i in range(3))


def _entries(a: Matrix) -> list[Any]:
    return [entry for row in a for entry in row]
