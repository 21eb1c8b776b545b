"""What Drake's motions say of a claim, in one line and in figures: made from the claim's own dictionary."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

METHOD = "Drake reference motions"
ALGEBRA = "no motion: algebra"

Claim = Mapping[str, Any]


def on_motions(claim: Claim) -> dict[str, Any]:
    """witness: "Drake" where a form of the claim was evaluated, else "no motion: algebra" or "none".
    because: why it was not.   error: what the false form costs beside the right one, None for a claim that
    has not both on one motion.   line: all of it in words."""
    found = list(_evidence(claim))
    error = cost_of_error(claim)
    reason = _reason(claim) if not found else None
    witness = "Drake" if found else ALGEBRA if reason == ALGEBRA else "none"
    return {"witness": witness, "because": reason, "error": error, "line": _line(found, error, reason)}


def cost_of_error(claim: Claim) -> dict[str, Any] | None:
    """The residuals over the size of the sides, on one motion at one time: where the false form is worst.

    motion, time (s), false, right (figures); right is a bound, a power of ten. None where there is no false
    form, or none that a motion tells from the right one.
    """
    courses = courses_of(claim)
    if courses is None:
        return None
    false, right = courses
    told = [
        (wrong, time, good)
        for time, wrong, good in zip(false["times"], false["residuals"], right["residuals"], strict=True)
        if wrong is not None and good is not None
    ]
    if not told:
        return None
    wrong, time, good = max(told, key=lambda each: each[0])
    return {"motion": false["motion"], "time": time, "false": wrong, "right": good}


def courses_of(claim: Claim) -> tuple[Claim, Claim] | None:
    """The residuals over time of the false form and of the right one, on one motion at the same times."""
    false, right = (
        next((c for form in _forms(claim) if (c := _course(form, outcome)) is not None), None)
        for outcome in ("the sides part", "residual within the error")
    )
    if false is None or right is None or false["motion"] != right["motion"]:
        return None
    return false, right


def percent(share: float) -> str:
    """24 %, 2.4 %, 0.024 %; no more than two digits are told of a small share."""
    return f"{100 * share:.0f} %" if share >= 0.1 else f"{100 * share:.2g} %"


def witness_counts(claims: Iterable[Claim]) -> dict[str, int]:
    """How many claims have Drake for a witness, have no motion, or have none for another reason."""
    counts = Counter(claim["motion"]["witness"] for claim in claims)
    return {name: counts[name] for name in ("Drake", ALGEBRA, "none")}


def _course(form: Claim, outcome: str) -> Claim | None:
    for evidence in form.get("evidence", ()):
        if evidence["method"] == METHOD and evidence["outcome"] == outcome and evidence.get("course"):
            return evidence["course"]
    return None


def _evidence(claim: Claim) -> Iterator[Claim]:
    for form in _forms(claim):
        yield from (e for e in form["evidence"] if e["method"] == METHOD)


def _forms(claim: Claim) -> list[Claim]:
    return [form for form in (claim, claim.get("reading"), claim.get("corrected")) if form]


def _reason(claim: Claim) -> str:
    forms = [form for form in (claim.get("corrected"), claim.get("reading"), claim) if form]
    return next((form["no_motion"] for form in forms if form.get("no_motion")), "not judged")


def _line(found: list[Claim], error: Mapping[str, Any] | None, reason: str | None) -> str:
    if reason is not None:
        return reason
    if error is not None:
        off = percent(error["false"])
        place = f"on {error['motion']} at t = {error['time']:g} s"
        return f"{place}: as printed off by {off} of its sides, corrected by less than {error['right']:.0e}"
    holding = [e for e in found if "residuals_below" in e]
    if not holding:
        worst = found[0]
        return f"off by {percent(worst['residual'])} on {worst['motion']} at t = {worst['time']:g} s"
    best = holding[-1]
    smallest, largest = min(best["residuals_below"]), max(best["residuals_below"])
    residuals = f"{smallest:.0e}" if smallest == largest else f"{smallest:.0e} to {largest:.0e}"
    motions = best["motions"]
    where = motions[0] if len(motions) == 1 else f"{len(motions)} motions"
    return f"holds at {best['samples']} instants of {where}; residuals below {residuals}"
