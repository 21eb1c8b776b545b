"""Repair of several claims, side by side on the cores, and what it comes to in the report."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace

from workbench.budget import Workers
from workbench.judge.verdict import Outcome
from workbench.papers.model import Claim
from workbench.repair.propose.limits import STANDARD, Limits
from workbench.repair.propose.repair import Repair, repair
from workbench.verify.claims import load_engines
from workbench.verify.results import ClaimResult

#: Verdicts on a printed form that ask for another form.
TO_REPAIR = frozenset({Outcome.REFUTED, Outcome.ILL_FORMED})


def repair_claims(
    claims: Sequence[Claim],
    limits: Limits = STANDARD,
    progress: Callable[[Repair], None] = lambda found: None,
    workers: int | None = None,
) -> list[Repair]:
    """The repairs of the claims, in their order; `progress` sees each as soon as it is there. Ctrl-C keeps
    those that are finished, and of a single claim what was found until then."""
    found: dict[str, Repair] = {}
    workers = min(workers or os.cpu_count() or 1, len(claims))
    if workers <= 1:
        for claim in claims:
            found[claim.id] = repair(claim, limits)
            progress(found[claim.id])
    else:
        _side_by_side(claims, limits, progress, workers, found)
    return [found[claim.id] for claim in claims if claim.id in found]


def _side_by_side(
    claims: Sequence[Claim],
    limits: Limits,
    progress: Callable[[Repair], None],
    workers: int,
    found: dict[str, Repair],
) -> None:
    def repaired(place: int) -> Repair:
        return replace(repair(claims[place], limits), claim=None)

    with Workers(repaired, None, workers, prepare=load_engines) as there, suppress(KeyboardInterrupt):
        for claim, done in zip(claims, there.map(range(len(claims))), strict=True):
            found[claim.id] = replace(done, claim=claim)
            progress(found[claim.id])


def with_proposals(
    results: Sequence[ClaimResult],
    limits: Limits | None = STANDARD,
    progress: Callable[[Repair], None] = lambda found: None,
) -> list[ClaimResult]:
    """The results, each with what the machine proposes if its printed form is refuted or ill-formed, few
    changes first; with nothing if there are no limits."""
    claims = [r.claim for r in results if r.verdict.outcome in TO_REPAIR and r.claim.theorem is None]
    repairs = repair_claims(claims, limits, progress) if claims and limits else []
    proposed = {found.claim.id: found.proposed() for found in repairs}
    return [replace(result, proposed=proposed.get(result.claim.id, ())) for result in results]
