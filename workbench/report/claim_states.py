"""The fault and the state of a claim, and the state of an equation: the same in every report."""

from __future__ import annotations

from collections.abc import Sequence

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.verdict import Grade, Outcome
from workbench.prover.results.claim_results import HOLDS, ClaimResult
from workbench.report.shown_kinds import STATES, Kind

_FALSE = (Outcome.REFUTED, Outcome.ILL_FORMED)
_OPEN = (Outcome.ARGUED, Outcome.PROBABLE)
_ORDER = list(STATES.values())


def fault_of(result: ClaimResult) -> str | None:
    """Returns the fault that the model names or that follows from the verdict.

    It is "warning" if an unconfirmed fact would make the formula true.
    """
    claim, verdict = result.claim, result.verdict
    if claim.mend.fault is not None or verdict.outcome not in _FALSE or result.right is not None:
        return result.fault
    return {Grade.ERROR: "error", Grade.WARNING: "warning"}.get(verdict.grade)


def state_of(result: ClaimResult, rests_on_others: bool) -> Kind:
    """Returns the state of one claim; that of an equation is the worst of its claims."""
    if (fault := fault_of(result)) is not None:
        return STATES[fault]
    outcome = result.verdict.outcome
    if outcome not in HOLDS | {Outcome.CONDITIONAL}:
        return STATES["open" if outcome in _OPEN else "unjudged"]
    if rests_on_others:
        return STATES["inherits"]
    is_own = outcome is Outcome.DEFINITION and result.claim.context.span is not None
    return STATES["defines" if is_own else "holds"]


def state_of_equation(results: Sequence[ClaimResult], states: Sequence[Kind]) -> Kind:
    """Returns the worst state of an equation's claims. states: of each claim.

    A step of the form x = x counts only if the equation has no other step.
    """
    told = [state for result, state in zip(results, states, strict=True) if not _is_idle(result)]
    return min(told or states, key=_ORDER.index)


def _is_idle(result: ClaimResult) -> bool:
    return result.passed and result.verdict.code is VerdictCode.SAME_TERM
