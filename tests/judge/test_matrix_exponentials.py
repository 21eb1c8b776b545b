"""Exponentials of matrices without a value: refuted by a law, and parts of a chain that are not decided."""

from __future__ import annotations

from typing import Any

import pytest

from workbench import check
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.terms import Block, Zero
from workbench.core.verdict import Outcome
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read_term
from workbench.repair.terms.variants import variants

SYMBOLS: dict[str, Any] = {"A": "tensor", "B": "tensor", "x": "vector", "v": "vector", "a": "scalar"}
TWIST = r"\begin{bmatrix} \operatorname{skew} x & v \\ 0 & %s \end{bmatrix}"
MOVED = r"\begin{bmatrix} \exp(\operatorname{skew} x) & v \\ 0 & 1 \end{bmatrix}"


@pytest.mark.parametrize(
    ("latex", "outcome"),
    [
        (rf"\exp({TWIST % 1}) = {MOVED}", Outcome.REFUTED),
        (r"\exp(A) = \mathbf{I} + B", Outcome.REFUTED),
        (r"\exp(A) = \mathbf{I} + A", Outcome.UNCHECKED),
        (r"\exp(A) = B", Outcome.UNCHECKED),
    ],
)
def test_exponential_commutes_with_its_exponent(latex: str, outcome: Outcome) -> None:
    verdict = check(latex, SYMBOLS).verdict
    assert verdict.outcome is outcome
    assert (verdict.code is VerdictCode.DOES_NOT_COMMUTE) is (outcome is Outcome.REFUTED)


def test_chain_is_refuted_by_one_step_beside_an_undecided_one() -> None:
    assert check(r"\exp(A) = \exp(B) = \mathbf{I} + x \otimes x", SYMBOLS).outcome is Outcome.REFUTED
    assert check(r"\exp(A) = \exp(B) = \exp(A) A", SYMBOLS).outcome is Outcome.UNCHECKED


def test_entries_zero_and_one_are_exchanged() -> None:
    specs = {name: {"kind": kind} for name, kind in SYMBOLS.items()}
    matrix = read_term(r"\begin{bmatrix} a & 0 \\ 1 & 2 \end{bmatrix}", SymbolTable.build(specs))
    made = [make() for _, said, make in variants(matrix, False) if "entry" in said[0]]
    found = [[each for row in new.entries for each in row] for new in made if isinstance(new, Block)]
    assert sorted(sum(isinstance(each, Zero) for each in row) for row in found) == [0, 2]
