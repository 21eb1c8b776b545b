"""The results of a paper as plain data: what every report is made from (same input, same bytes)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from importlib.metadata import version
from typing import Any

from workbench.judge.verdict import Outcome, Verdict
from workbench.papers.model import Formula, Paper
from workbench.verify import ClaimResult

_PACKAGES = {
    "workbench": "kinematics-workbench",
    "drake": "drake",
    "python-flint": "python-flint",
    "sympy": "sympy",
    "numpy": "numpy",
}


def report_dict(paper: Paper, results: Sequence[ClaimResult]) -> dict[str, Any]:
    """The canonical report: paper, versions, claims in reading order, and the count of each verdict."""
    counts = Counter(result.verdict.outcome for result in results)
    return {
        "paper": {"title": paper.title, "doi": paper.doi},
        "versions": {name: version(package) for name, package in _PACKAGES.items()},
        "claims": [claim_dict(result) for result in results],
        "summary": {str(outcome): counts[outcome] for outcome in Outcome if counts[outcome]},
    }


def claim_dict(result: ClaimResult) -> dict[str, Any]:
    """One claim with its verdicts. `evidence` is that on the printed form; a reading and a correction bring
    their own."""
    claim, verdict = result.claim, result.verdict
    refuted = verdict if verdict.counterexample or result.reading is None else result.reading
    return {
        "id": claim.id,
        "equation": claim.equation,
        "section": claim.section,
        "printed": claim.printed.latex or claim.statement,
        "statement": claim.statement,
        "read_back": verdict.read_back,
        "verdict": str(verdict.outcome),
        "scope": verdict.scope,
        "reason": verdict.reason,
        "reading": _form_dict(claim.reading, result.reading),
        "corrected": _form_dict(claim.corrected, result.corrected),
        "hypothesis": claim.hypothesis.latex if claim.hypothesis else verdict.hypothesis,
        "assume": [formula.latex for formula in claim.assume],
        "orders": str(claim.orders) if claim.orders else None,
        "counterexample": refuted.counterexample.to_dict() if refuted.counterexample else None,
        "evidence": [evidence.to_dict() for evidence in verdict.evidence],
        "inherits": list(claim.inherits),
        "note": claim.note,
        "expected": str(result.expected),
        "passed": result.passed,
        "why_not": result.why_not,
    }


def _form_dict(formula: Formula | None, verdict: Verdict | None) -> dict[str, Any] | None:
    if formula is None or verdict is None:
        return None
    return {
        "latex": formula.latex,
        "verdict": str(verdict.outcome),
        "read_back": verdict.read_back,
        "scope": verdict.scope,
        "reason": verdict.reason,
        "evidence": [evidence.to_dict() for evidence in verdict.evidence],
    }
