"""Verdicts that a test plants: a `proved` one by a rule of inference, as there is no other way."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from workbench.core.verdict import Evidence, Outcome, Verdict
from workbench.prover.decide.inference import conclusion

PLANTED = Evidence("planted", "residual is 0")


def planted(outcome: Outcome, *, scope: str | None = None, **rest: Any) -> Verdict:
    """Returns the verdict with these fields."""
    if outcome != Outcome.PROVED:
        return Verdict(outcome, scope=scope, **rest)
    return replace(conclusion("planted", [], [PLANTED], scope), **{"evidence": (), **rest})
