"""What the judge returns: an outcome that is never merged with another, and the evidence behind it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any


class Outcome(StrEnum):
    """The seven verdicts of the report."""

    PROVED = "proved"
    CONDITIONAL = "conditional"
    REFUTED = "refuted"
    ILL_FORMED = "ill-formed"
    DEFINITION = "definition"
    PROBABLE = "probable"
    UNCHECKED = "unchecked"


class EngineDisagreement(RuntimeError):
    """Two engines that must agree do not: a defect of the workbench, never a verdict."""


@dataclass(frozen=True)
class Evidence:
    """One method, what came out of it, and its figures (JSON values: numbers, strings, lists)."""

    method: str
    outcome: str
    figures: Mapping[str, Any] = field(default_factory=dict)

    def to_dict(self) -> dict[str, Any]:
        return {"method": self.method, "outcome": self.outcome, **self.figures}


@dataclass(frozen=True)
class Counterexample:
    """Values of the symbols (LaTeX → rationals as strings, components in reading order; a derivative is a
    symbol of its own, `\\dot{\\omega}`), and what the two sides then are."""

    values: Mapping[str, tuple[str, ...]]
    left: tuple[str, ...]
    right: tuple[str, ...]

    def to_dict(self) -> dict[str, Any]:
        values = {name: list(entries) for name, entries in self.values.items()}
        return {"values": values, "lhs": list(self.left), "rhs": list(self.right)}


@dataclass(frozen=True)
class Verdict:
    """The verdict on one statement.

    scope: for which n it is proved ("all n", "n = 1..8"); None where there is no n.
    read_back: canonical LaTeX of the term that was judged.
    reason: why, for ill-formed (with line and column), unchecked and conditional.
    hypothesis: canonical LaTeX of the condition that the text does not state, for conditional.
    """

    outcome: Outcome
    read_back: str | None = None
    scope: str | None = None
    reason: str | None = None
    hypothesis: str | None = None
    counterexample: Counterexample | None = None
    evidence: tuple[Evidence, ...] = ()
