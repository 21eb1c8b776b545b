"""Claims with long residuals under equations: nothing is divided that takes longer than the claim is worth."""

from __future__ import annotations

import pytest

from workbench.core.verdict import Outcome
from workbench.language import reader
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.prover.decide.decide import Judge
from workbench.prover.decide.ideals import Ideal

TABLE = SymbolTable.build({name: {"kind": "vector"} for name in "abcde"})


def test_squares_of_long_components_are_not_divided(monkeypatch: pytest.MonkeyPatch) -> None:
    divided: list[int] = []
    holds = Ideal.holds

    def counted(self: Ideal, p: object) -> bool:
        divided.append(len(p))  # type: ignore[arg-type]
        return holds(self, p)  # type: ignore[arg-type]

    monkeypatch.setattr(Ideal, "holds", counted)
    long = r"((a + b) \cdot (c + d)) ((a + c) \cdot (b + d)) e"
    (claim,), (premise,) = (
        reader.read(latex, TABLE) for latex in (f"{long} = 2 {long}", r"a \cdot b = e \cdot e")
    )
    verdict = Judge(Definitions([])).judge(claim, (premise,))
    assert verdict.outcome is Outcome.REFUTED
    assert divided and max(divided) < 10_000
