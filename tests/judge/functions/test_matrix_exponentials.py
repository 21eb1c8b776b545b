"""Exponentials of matrices that no formula gives: proved by their laws, and refuted at real points."""

from __future__ import annotations

import random

import pytest
from flint import arb, arb_mat

from workbench.core.terms import Block, Zero
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read_term
from workbench.prover.counterexamples.matrix_exponential_balls import taylor_sum
from workbench.repair.terms.variants import variants


@pytest.mark.parametrize("seed", range(3))
def test_two_ways_to_the_exponential_of_balls_agree(seed: int) -> None:
    source = random.Random(seed)
    rows = [[arb(source.randint(-3, 3)) / 2 for _ in range(3)] for _ in range(3)]
    again = taylor_sum(arb_mat(rows))
    assert again.overlaps(arb_mat(rows).exp())
    assert all(float(entry.rad()) < 1e-6 for entry in again.entries())
    assert not taylor_sum(-arb_mat(rows)).overlaps(arb_mat(rows).exp())


def test_entries_zero_and_one_are_exchanged() -> None:
    specs = {"a": {"kind": "scalar"}}
    matrix = read_term(r"\begin{bmatrix} a & 0 \\ 1 & 2 \end{bmatrix}", SymbolTable.build(specs))
    made = [make() for _, said, make in variants(matrix, False) if "entry" in said[0]]
    found = [[each for row in new.entries for each in row] for new in made if isinstance(new, Block)]
    assert sorted(sum(isinstance(each, Zero) for each in row) for row in found) == [0, 2]
