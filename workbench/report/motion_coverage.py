"""Claims that were evaluated on Drake's motions, and the reasons for the others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from workbench.prover.results.claim_results import ClaimResult
from workbench.report.anchors import Place


@dataclass(frozen=True)
class Unseen:
    """Claims that were not evaluated for one reason. places: headings and anchors, each once."""

    reason: str
    count: int
    places: tuple[Place, ...]


@dataclass(frozen=True)
class Motions:
    """The number of claims evaluated on motions, and the other claims by reason."""

    seen: int
    claims: int
    unseen: tuple[Unseen, ...]


def motions_of(results: Sequence[ClaimResult], places: Mapping[str, Place]) -> Motions | None:
    """Returns the coverage; None if nothing was evaluated. places: id → (heading, anchor)."""
    reasons: dict[str, list[Place]] = {}
    for result in results:
        if result.on_motions.because is not None:
            reasons.setdefault(result.on_motions.because, []).append(places[result.claim.id])
    unseen = [
        Unseen(reason, len(found), tuple(reversed(dict(reversed(found)).items())))
        for reason, found in sorted(reasons.items())
    ]
    seen = len(results) - sum(each.count for each in unseen)
    return Motions(seen, len(results), tuple(unseen)) if seen else None
