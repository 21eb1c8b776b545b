"""What the rules ask the judge of formulas for is that of `obligations.txt`."""

from __future__ import annotations

from itertools import takewhile
from pathlib import Path

import pytest

from tests.judge.goals.goal_rows import proof_of
from tests.judge.goals.test_goals import scope
from tests.verdict_rows import OPTION
from workbench.language.goals.goal_reader import read_goal
from workbench.language.printing.printer import to_latex
from workbench.prover.goals.proof_rules import obligations
from workbench.prover.goals.sequents import Obligation, Sequent

LINES = Path(__file__).with_name("obligations.txt").read_text(encoding="utf-8").splitlines()
#: A goal with its proof, and what they ask.
ASKED = [
    (line, [each.strip() for each in takewhile(str.strip, LINES[at + 1 :])])
    for at, line in enumerate(LINES)
    if OPTION in line
]


def told(obligation: Obligation) -> str:
    parts = [
        f"{obligation.rule}: {to_latex(obligation.statement)}",
        ", ".join(map(to_latex, obligation.assume)),
        ", ".join(f"{name} ≥ {least}" for name, least in obligation.scope.integers.items()),
    ]
    return " | ".join(part for part in parts if part)


@pytest.mark.parametrize(("line", "asked"), ASKED)
def test_a_proof_leaves_the_expected_obligations(line: str, asked: list[str]) -> None:
    goal, proof = line.split(f"{OPTION}by: ")
    where = scope()
    found = obligations(Sequent(read_goal(goal, where), where), proof_of(proof))
    assert list(map(told, found)) == asked
