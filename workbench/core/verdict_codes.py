"""The codes of verdicts: why a claim is not judged, fails, or holds under a condition only."""

from __future__ import annotations

from enum import unique

from workbench.core.reasons import Code


@unique
class VerdictCode(Code):
    """One row for each reason of a verdict."""

    SAME_TERM = "same-term", "both sides are the same term, so nothing is tested"
    AT_ONE_INSTANT = (
        "at-one-instant",
        "false if the condition holds at one instant only; if it lasts, state its derivatives too",
    )
    AT_ONE_PLACE = (
        "at-one-place",
        "false if the condition holds at one place only; if everywhere, state its derivatives too",
    )
    NEEDED_ONCE = (
        "needed-once",
        "{outcome} if {kinds}, which only this formula needs; if {name} is a {other}, this formula is wrong",
    )
    OF_FRAMES = (
        "of-frames",
        "{outcome} for free frames and points; `orientation` in [frames] and `fixed` in [points] say more",
    )
    NOT_AS_DRAFTED = "not-as-drafted", "does not fit the drafted kinds and notation: {reason}"

    FITS = "fits-by-types", "fits by its types; nothing here tells it from other forms that fit"


#: A claim is false under its premise now, and not seen to be false if the premise lasts.
UNLESS_IT_LASTS = frozenset({VerdictCode.AT_ONE_INSTANT, VerdictCode.AT_ONE_PLACE})
