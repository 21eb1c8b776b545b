"""Summary of the motion evidence on the forms of a claim: one line and figures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from workbench.core.codes.motion_codes import MotionCode
from workbench.core.verdict import Evidence, Verdict

METHOD = "Drake reference motions"
ALGEBRA = MotionCode.ALGEBRA.template

#: Verdicts by the names of a claim's forms.
Verdicts: TypeAlias = Mapping[str, Verdict]


@dataclass(frozen=True)
class Cost:
    """The relative residuals on one motion at one time (s), where the false form is worst. right: a bound, a
    power of ten."""

    motion: str
    time: float
    false: float
    right: float


@dataclass(frozen=True)
class Course:
    """The relative residuals over time of one form on one motion; None at times without a value."""

    motion: str
    times: Sequence[float]
    residuals: Sequence[float | None]


@dataclass(frozen=True)
class Witnessed:
    """The motion summary of a claim.

    witness: "Drake" if a form of the claim was evaluated, else "no motion: algebra" or "none".
    because: why it was not evaluated.
    error: the residuals of the false and the right form; None if they share no motion or no motion separates
    them.
    line: the summary in words.
    """

    witness: str
    because: str | None
    error: Cost | None
    line: str


def witnessed(verdicts: Verdicts) -> Witnessed:
    found = list(_evidence(verdicts))
    error = _cost(verdicts)
    if found:
        return Witnessed("Drake", None, error, _line(found, error))
    reasons = [verdict.no_motion for verdict in verdicts.values() if verdict.no_motion]
    reason = reasons[-1] if reasons else MotionCode.NOT_JUDGED()
    return Witnessed(ALGEBRA if reason.code is MotionCode.ALGEBRA else "none", reason, error, reason)


def _cost(verdicts: Verdicts) -> Cost | None:
    if (courses := courses_of(verdicts)) is None:
        return None
    false, right = courses
    told = [
        (wrong, time, good)
        for time, wrong, good in zip(false.times, false.residuals, right.residuals, strict=True)
        if wrong is not None and good is not None
    ]
    if not told:
        return None
    wrong, time, good = max(told, key=lambda each: each[0])
    return Cost(false.motion, time, wrong, good)


def courses_of(verdicts: Verdicts) -> tuple[Course, Course] | None:
    """Returns the courses of the false form and of the right one, on one motion at the same times; else
    None."""
    false, right = (
        next((Course(**e.figures["course"]) for e in _evidence(verdicts) if _tells(e, outcome)), None)
        for outcome in ("the sides part", "residual within the error")
    )
    if false is None or right is None or false.motion != right.motion:
        return None
    return false, right


def percent(share: float) -> str:
    """Returns 24 %, 2.4 %, 0.024 %; small shares have at most two digits."""
    return f"{100 * share:.0f} %" if share >= 0.1 else f"{100 * share:.2g} %"


def _tells(evidence: Evidence, outcome: str) -> bool:
    return evidence.outcome == outcome and bool(evidence.figures.get("course"))


def _evidence(verdicts: Verdicts) -> Iterator[Evidence]:
    return (e for verdict in verdicts.values() for e in verdict.evidence if e.method == METHOD)


def _line(found: Sequence[Evidence], error: Cost | None) -> str:
    if error is not None:
        off = percent(error.false)
        place = f"on {error.motion} at t = {error.time:g} s"
        return f"{place}: as printed off by {off} of its sides, corrected by less than {error.right:.0e}"
    holding = [e.figures for e in found if "residuals_below" in e.figures]
    if not holding:
        worst = found[0].figures
        return f"off by {percent(worst['residual'])} on {worst['motion']} at t = {worst['time']:g} s"
    best = holding[-1]
    smallest, largest = min(best["residuals_below"]), max(best["residuals_below"])
    residuals = f"{smallest:.0e}" if smallest == largest else f"{smallest:.0e} to {largest:.0e}"
    motions = best["motions"]
    where = motions[0] if len(motions) == 1 else f"{len(motions)} motions"
    return f"holds at {best['samples']} instants of {where}; residuals below {residuals}"
