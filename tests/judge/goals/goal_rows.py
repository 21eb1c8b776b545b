"""Rows of goals and their verdicts, in the form of `tests.verdict_rows`.

A row is `goal  ‖ by: proof  ‖ against: refutation  ⟶  outcome for scope: reason`; proofs are written in Python.
`python -m tests.judge.goals.goal_rows FOLDER` writes the verdicts of today.
"""

from __future__ import annotations

import sys
from typing import Any

from tests.verdict_rows import OPTION, Given, main
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.verdict import Outcome
from workbench.language.definition_entries import read_definitions
from workbench.language.goals import proofs
from workbench.language.goals.goal_reader import read_goal
from workbench.language.goals.goals import GoalError, Scope
from workbench.language.goals.proofs import Proven
from workbench.language.naming.symbols import SymbolTable
from workbench.prover.decide.decide import Judge
from workbench.prover.goals.prove_goal import prove


def scope_of(given: Given) -> Scope:
    specs = {name: {"kind": kind} if isinstance(kind, str) else kind for name, kind in given.symbols.items()}
    entries = dict(entry.split(" = ", 1) for entry in given.definitions)
    definitions, table = read_definitions(entries, SymbolTable.build(specs))
    return Scope(table, definitions, {})


def proof_of(text: str) -> Any:
    """Returns the proof or refutation that Python's text constructs."""
    return eval(text, dict(vars(proofs)))  # of our own rows


def said_of_goal(row: str, given: Given) -> str:
    """Returns the verdict on the row's goal with its reason, or why the goal or its proof is refused."""
    goal, *options = row.split(OPTION)
    parts = dict(option.split(": ", 1) for option in options)
    scope = scope_of(given)
    try:
        proven = Proven(*(proof_of(parts[key]) if key in parts else None for key in ("by", "against")))
        verdict = prove(read_goal(goal, scope), scope, Judge(scope.definitions), proven)
    except (GoalError, ReadError, IllFormedAt) as error:
        return f"refused: {error}"
    reason = f": {verdict.reason}" if verdict.outcome is Outcome.UNCHECKED else ""
    return f"{verdict.outcome}{f' for {verdict.scope}' if verdict.scope else ''}{reason}"


if __name__ == "__main__":
    main(sys.argv[1], said_of_goal)
