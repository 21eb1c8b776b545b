"""Results as JSON, for `--json` and report.json; equal results give equal bytes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from workbench.context.claims import CITATION_KEYS, Claim, Formula, Paper
from workbench.core.verdict import Counterexample, Verdict
from workbench.papers.corrections import mended, same_formula
from workbench.prover.results.claim_results import Certification, ClaimResult
from workbench.prover.results.proposed_form import Proposed
from workbench.report.counts import summary, versions, witness_counts
from workbench.report.erratum.equation_groups import equation_counts


def report_json(paper: Paper, results: Sequence[ClaimResult]) -> dict[str, Any]:
    """Returns the paper, the versions, the claims in reading order, and the counts.

    `summary` counts claims by verdict; `equations` counts equations by state.
    """
    return {
        "paper": {
            "title": paper.title,
            "doi": paper.doi,
            **{key: paper.citation[key] for key in CITATION_KEYS if key in paper.citation},
        },
        "versions": versions(),
        "claims": [claim_json(result) for result in results],
        "summary": summary(results),
        "equations": equation_counts(paper, results),
        "witnesses": witness_counts(results),
    }


def claim_json(result: ClaimResult) -> dict[str, Any]:
    """Returns one claim with its verdicts; `evidence` is that on the printed form.

    A reading and a correction have evidence of their own.
    """
    claim, verdict, against = result.claim, result.verdict, result.counterexample
    return {
        "id": claim.id,
        "equation": claim.equation,
        "section": claim.section,
        "printed": claim.shown,
        "formula": claim.our_formula,
        "goal": claim.proof.goal.latex if claim.proof.goal else None,
        "statement": claim.source.statement,
        "read_back": verdict.read_back,
        "verdict": verdict.outcome,
        "grade": verdict.grade,
        "basis": str(verdict.basis),
        "unless": list(verdict.unless),
        "scope": verdict.scope,
        "reason": verdict.reason,
        "reason_code": verdict.code.slug if verdict.code else None,
        "fault": result.fault,
        "mend": _mend(claim),
        "reading": _form(claim.reading, result.reading),
        "corrected": _form(claim.corrected, result.corrected),
        "hypothesis": None if result.hypothesis is None else str(result.hypothesis),
        "assume": [formula.latex for formula in (*claim.assume, *claim.context.given)],
        "orders": str(claim.orders) if claim.orders else None,
        "counterexample": _values(against) if against else None,
        "evidence": [evidence.to_dict() for evidence in verdict.evidence],
        "motion": asdict(result.on_motions),
        "no_motion": verdict.no_motion,
        "inherits": list(claim.inherits),
        "note": claim.source.note,
        "expected": result.expected,
        "passed": result.passed,
        "why_not": result.why_not,
        **_asked("proposed", result.proposed),
        **({"edits": [edit.to_dict() for edit in result.edits]} if result.edits else {}),
        **_place(claim),
        **_asked("certificates", result.certificates),
    }


def _asked(key: str, told: Sequence[Proposed | Certification] | None) -> dict[str, Any]:
    return {} if told is None else {key: [asdict(each) for each in told]}


def _form(formula: Formula | None, verdict: Verdict | None) -> dict[str, Any] | None:
    if formula is None or verdict is None:
        return None
    return {
        "latex": formula.latex,
        "verdict": verdict.outcome,
        "read_back": verdict.read_back,
        "scope": verdict.scope,
        "reason": verdict.reason,
        "reason_code": verdict.code.slug if verdict.code else None,
        "evidence": [evidence.to_dict() for evidence in verdict.evidence],
        "no_motion": verdict.no_motion,
    }


def _values(example: Counterexample) -> dict[str, Any]:
    """Returns the values without their kinds, which the symbols of the paper determine."""
    return {name: value for name, value in example.to_dict().items() if name not in ("kinds", "kind")}


def _mend(claim: Claim) -> dict[str, Any] | None:
    """Returns the edits that correct the claim. `is_proved`: whether they turn the print into the proved
    form."""
    if claim.mend.fault is None:
        return None
    mend, right, printed = claim.mend, claim.corrected or claim.reading, claim.printed.latex
    makes_right = mend.edits and printed and right and same_formula(mended(printed, mend.edits), right.latex)
    return {
        "edits": [{"for": e.old, "read": e.new, "is_math": e.is_math} for e in mend.edits],
        **{key: getattr(mend, key) for key in ("place", "beside", "cause", "add", "example")},
        "mended_by": mend.by,
        "is_proved": bool(makes_right),
    }


def _place(claim: Claim) -> dict[str, Any]:
    """Returns the position of a claim in a text: its file, its span, and the earlier steps of its chain."""
    if claim.context.span is None:
        return {}
    return {
        "place": {**vars(claim.context.span), "file": str(claim.context.span.file)},
        "chain": list(claim.chain),
    }
