"""Codes of claims that no motion tests."""

from __future__ import annotations

from enum import unique

from workbench.core.reasons import Code


@unique
class MotionCode(Code):
    """Reasons why the evidence contains no motion."""

    ALGEBRA = "no motion: algebra"
    AS_STATED = "{why}"
    EXISTENCE = "what it says of a motion is that something exists, or is the only one"
    NOT_JUDGED = "not judged"
    NO_MOTION_HAS = "no motion has {quantities}"
    NO_QUANTITY = "a definition of what Drake has no quantity for"
    PREMISES_NOT_MET = "nowhere on the motions is met what it supposes, so they test nothing of it"
    TOO_HIGH_AN_ORDER = "derivatives of too high an order"
    WORDS = "a sentence, with no formula to evaluate"
