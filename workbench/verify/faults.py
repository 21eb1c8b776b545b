"""What kind of fault a claim shows: what its `fault` says, or what can be derived from its verdicts."""

from __future__ import annotations

from workbench.judge.verdict import Outcome
from workbench.papers.mends import mended, same_formula
from workbench.typeset.differences import difference
from workbench.verify.claims import HOLDS, ClaimResult


def fault_of(result: ClaimResult) -> str | None:
    """The fault of the claim, or None where it is right as printed or nothing is known.

    Derived: what needs a condition lacks a hypothesis; what is false as it was meant is an error; what is
    right as it was meant is a loss of the transcription if only marks differ, else a misprint."""
    claim, outcome = result.claim, result.verdict.outcome
    if claim.fault is not None or outcome in HOLDS or outcome in (Outcome.UNCHECKED, Outcome.PROBABLE):
        return claim.fault
    if outcome is Outcome.CONDITIONAL or (outcome is Outcome.ARGUED and claim.hypothesis is not None):
        return "hypothesis"
    if outcome is Outcome.ARGUED:
        return "error" if claim.corrected is not None else None
    if outcome is Outcome.REFUTED or (result.reading and result.reading.outcome is Outcome.REFUTED):
        return "error"
    return "transcription" if _only_marks_differ(claim.printed.latex, claim.reading) else "misprint"


def mend_dict(result: ClaimResult) -> dict | None:
    """The edits that mend the claim; `is_proved`: whether what they make of the print is the proved form."""
    claim, mend = result.claim, result.claim.mend
    if claim.fault is None:
        return None
    right = claim.corrected or claim.reading
    printed = claim.printed.latex
    return {
        "edits": [{"for": e.old, "read": e.new, "is_math": e.is_math} for e in mend.edits],
        "place": mend.place,
        "beside": mend.beside,
        "cause": mend.cause,
        "add": mend.add,
        "example": mend.example,
        "mended_by": mend.by,
        "is_proved": bool(
            mend.edits and printed and right and same_formula(mended(printed, mend.edits), right.latex)
        ),
    }


def _only_marks_differ(printed: str, reading) -> bool:
    found = difference(printed, reading.latex) if reading is not None and printed else None
    return bool(found and found.changes and all(change.kind == "mark" for change in found.changes))
