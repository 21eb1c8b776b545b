"""Codes of paper files and models that lack a key."""

from __future__ import annotations

from enum import unique

from workbench.core.reasons import Code


@unique
class ModelCode(Code):
    """Missing keys of a table. Every argument is the name of a key."""

    MISSING_KEY = "missing key '{key}'"
    MISSING_PLACE = "missing key '{key}': a label, an equation number, an id or \"line N\", or a list of such"
    MISSING_START = "missing key '{key}': a label, an equation number, a section or \"line N\""
    MOTION_INCOMPLETE = "motion: expected {holds}, or {none} and why no motion shows it"
    NO_CLAIMS = "no claims; expected at least one [[{claim}]]"
    ROBOT_INCOMPLETE = "motion.robot: expected both {urdf} and {body}"
