"""The results of a paper as plain data: what every report is made from (same input, same bytes)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from importlib.metadata import version
from typing import Any

from workbench.judge.verdict import Outcome, Verdict
from workbench.papers.model import Claim, Formula, Paper
from workbench.verify.claims import ClaimResult
from workbench.verify.faults import fault_of, mend_dict
from workbench.verify.on_motions import on_motions, witness_counts

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
    claims = [claim_dict(result) for result in results]
    return {
        "paper": {"title": paper.title, "doi": paper.doi, **paper.citation},
        "versions": {name: version(package) for name, package in _PACKAGES.items()},
        "claims": claims,
        "summary": {str(outcome): counts[outcome] for outcome in Outcome if counts[outcome]},
        "witnesses": witness_counts(claims),
    }


def claim_dict(result: ClaimResult) -> dict[str, Any]:
    """One claim with its verdicts. `evidence` is that on the printed form; a reading and a correction bring
    their own."""
    told = _told(result)
    return {**told, "motion": on_motions(told)}


def _told(result: ClaimResult) -> dict[str, Any]:
    claim, verdict = result.claim, result.verdict
    refuted = verdict if verdict.counterexample or result.reading is None else result.reading
    return {
        "id": claim.id,
        "equation": claim.equation,
        "section": claim.section,
        "printed": None if claim.ours else claim.printed.latex or claim.quote,
        "formula": claim.printed.latex if claim.ours else None,
        "goal": claim.goal.latex if claim.goal else None,
        "statement": claim.statement,
        "fault": fault_of(result),
        "mend": mend_dict(result),
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
        "no_motion": verdict.no_motion or None,
        "inherits": list(claim.inherits),
        "note": claim.note,
        "expected": str(result.expected),
        "passed": result.passed,
        "why_not": result.why_not,
        **_place(claim),
    }


def _place(claim: Claim) -> dict[str, Any]:
    """Of a claim in a text: its file, where it stands, and the steps before it in its chain."""
    if claim.span is None:
        return {}
    span = claim.span
    where = {
        "file": str(span.file),
        "line": span.line,
        "column": span.column,
        "end_line": span.end_line,
        "end_column": span.end_column,
    }
    return {"place": where, "chain": list(claim.chain)}


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
        "no_motion": verdict.no_motion or None,
    }
