"""Exponentials of matrices that no formula gives: proved by their laws, and refuted at real points."""

from __future__ import annotations

import random
from typing import Any

import pytest
from flint import arb, arb_mat

from workbench import check
from workbench.core.terms import Block, Zero
from workbench.core.verdict import Outcome
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read_term
from workbench.prover.counterexamples.matrix_exponential_balls import taylor_sum
from workbench.repair.terms.variants import variants

SYMBOLS: dict[str, Any] = {
    **dict.fromkeys("AB", "tensor"),
    **dict.fromkeys("xv", "vector"),
    **dict.fromkeys("abc", "scalar"),
    "C": {"kind": "tensor", "constant": True},
    "K": {"kind": "matrix 2×2", "constant": True},
    "R": "rotation",
}
TWIST = r"\begin{bmatrix} \operatorname{skew} x & v \\ 0 & %s \end{bmatrix}"
MOVED = r"\begin{bmatrix} \exp(\operatorname{skew} x) & v \\ 0 & 1 \end{bmatrix}"


#: Left side, true and false right sides.
LAWS = [
    (r"\exp(A) \exp(-A)", r"\mathbf{I}", "A"),
    (r"\exp(A) A", r"A \exp(A)", r"B \exp(A)"),
    (r"\exp(2 A)", r"\exp(A) \exp(A)", r"2 \exp(A)"),
    (r"\exp(A) \exp(\frac{A}{2}) x", r"\exp(\frac{3}{2} A) x", r"\exp(2 A) x"),
    (r"\exp(A^T)", r"\exp(A)^T", r"\exp(A)"),
    (r"\exp(A)^{-1}", r"\exp(-A)", r"-\exp(A)"),
    (r"\exp(R A R^T)", r"R \exp(A) R^T", r"R^T \exp(A) R"),
    (r"\exp(B A B^{-1})", r"B \exp(A) B^{-1}", r"B^{-1} \exp(A) B"),
    (r"\det \exp(A)", r"e^{\operatorname{tr} A}", r"e^{\det A}"),
    (r"\exp(a \mathbf{I} )", r"e^{a} \mathbf{I}", r"(1 + a) \mathbf{I}"),
    (r"\exp(A + B)", r"\exp(B + A)", r"\exp(A) \exp(B)"),
    (r"\frac{d}{dt} \exp(C t)", r"C \exp(C t)", r"-C \exp(C t)"),
    (r"\frac{d}{dt} \exp(K t)", r"\exp(K t) K", r"-\exp(K t) K"),
    (r"\frac{d^2}{dt^2} \exp(C t)", r"C^2 \exp(C t)", r"-C^2 \exp(C t)"),
    (
        r"\frac{d}{dt} (\exp(-C t) B \exp(C t))",
        r"\exp(-C t) (\dot{B} + B C - C B) \exp(C t)",
        r"\exp(-C t) (\dot{B} - B C + C B) \exp(C t)",
    ),
    (
        r"\exp(\begin{bmatrix} a & 0 \\ 0 & b \end{bmatrix})",
        r"\begin{bmatrix} e^a & 0 \\ 0 & e^b \end{bmatrix}",
        r"\begin{bmatrix} e^b & 0 \\ 0 & e^a \end{bmatrix}",
    ),
    (
        r"\exp(\begin{bmatrix} 0 & -a \\ a & 0 \end{bmatrix})",
        r"\begin{bmatrix} \cos a & -\sin a \\ \sin a & \cos a \end{bmatrix}",
        r"\begin{bmatrix} \cos a & \sin a \\ -\sin a & \cos a \end{bmatrix}",
    ),
    (
        r"\exp(\begin{bmatrix} 0 & -a & b \\ a & 0 & c \\ 0 & 0 & 0 \end{bmatrix})",
        r"\begin{bmatrix} \cos a & -\sin a & \frac{b \sin a - c (1 - \cos a)}{a} \\ \sin a & \cos a & \frac{c \sin a + b (1 - \cos a)}{a} \\ 0 & 0 & 1 \end{bmatrix}",
        r"\begin{bmatrix} \cos a & -\sin a & \frac{b \sin a + c (1 - \cos a)}{a} \\ \sin a & \cos a & \frac{c \sin a + b (1 - \cos a)}{a} \\ 0 & 0 & 1 \end{bmatrix}",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("left", "true", "false"), LAWS, ids=[law[0] for law in LAWS])
def test_law_of_an_exponential_of_a_matrix(left: str, true: str, false: str) -> None:
    assert check(f"{left} = {true}", SYMBOLS).verdict.outcome in (Outcome.PROVED, Outcome.CONDITIONAL)
    assert check(f"{left} = {false}", SYMBOLS).verdict.outcome is Outcome.REFUTED


@pytest.mark.parametrize(
    ("latex", "outcome"),
    [
        (rf"\exp({TWIST % 1}) = {MOVED}", Outcome.REFUTED),
        (r"\exp(A) = \mathbf{I} + B", Outcome.REFUTED),
        (r"\exp(A) = \mathbf{I} + A", Outcome.REFUTED),
        (r"\exp(A) = B", Outcome.UNCHECKED),
        (r"\frac{d}{dt} \exp(A) = \dot{A} \exp(A)", Outcome.REFUTED),
    ],
)
def test_exponential_of_a_free_matrix(latex: str, outcome: Outcome) -> None:
    assert check(latex, SYMBOLS).verdict.outcome is outcome


@pytest.mark.parametrize("seed", range(3))
def test_two_ways_to_the_exponential_of_balls_agree(seed: int) -> None:
    source = random.Random(seed)
    rows = [[arb(source.randint(-3, 3)) / 2 for _ in range(3)] for _ in range(3)]
    again = taylor_sum(arb_mat(rows))
    assert again.overlaps(arb_mat(rows).exp())
    assert all(float(entry.rad()) < 1e-6 for entry in again.entries())
    assert not taylor_sum(-arb_mat(rows)).overlaps(arb_mat(rows).exp())


def test_chain_is_refuted_by_one_step() -> None:
    assert check(r"\exp(A) = \exp(B) = \mathbf{I} + x \otimes x", SYMBOLS).outcome is Outcome.REFUTED


def test_entries_zero_and_one_are_exchanged() -> None:
    specs = {"a": {"kind": "scalar"}}
    matrix = read_term(r"\begin{bmatrix} a & 0 \\ 1 & 2 \end{bmatrix}", SymbolTable.build(specs))
    made = [make() for _, said, make in variants(matrix, False) if "entry" in said[0]]
    found = [[each for row in new.entries for each in row] for new in made if isinstance(new, Block)]
    assert sorted(sum(isinstance(each, Zero) for each in row) for row in found) == [0, 2]
