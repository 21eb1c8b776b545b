"""Repair of several claims, side by side on the cores."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress

from workbench.context.claims import Claim
from workbench.prover.preload import load_engines
from workbench.repair.propose.chain_neighbours import ALONE, Neighbours, neighbours_of
from workbench.repair.propose.repair import Proposal, Repair, repair
from workbench.repair.propose.search_limits import STANDARD, Limits
from workbench.runtime import Workers


def repair_claims(
    claims: Sequence[Claim],
    limits: Limits = STANDARD,
    progress: Callable[[Repair], None] = lambda found: None,
    workers: int | None = None,
    beside: Mapping[str, Neighbours] | None = None,
) -> list[Repair]:
    """The repairs of the claims, in their order; `progress` sees each as soon as it is there. Ctrl-C keeps
    those that are finished, and of a single claim what was found until then. beside: of each claim the steps
    next to it, by its id; found among the claims if None."""
    known = neighbours_of(claims) if beside is None else beside
    found: dict[str, Repair] = {}
    workers = min(workers or os.cpu_count() or 1, len(claims))
    if workers <= 1:
        for claim in claims:
            found[claim.id] = repair(claim, limits, beside=known.get(claim.id, ALONE))
            progress(found[claim.id])
    else:
        _side_by_side(claims, limits, progress, workers, found, known)
    return [found[claim.id] for claim in claims if claim.id in found]


def _side_by_side(
    claims: Sequence[Claim],
    limits: Limits,
    progress: Callable[[Repair], None],
    workers: int,
    found: dict[str, Repair],
    beside: Mapping[str, Neighbours],
) -> None:
    def repaired(place: int) -> tuple[list[Proposal], int, float, bool, bool]:
        """All of the repair but the claim, which is here already."""
        done = repair(claims[place], limits, beside=beside.get(claims[place].id, ALONE))
        return done.proposals, done.candidates, done.seconds, done.complete, done.interrupted

    with Workers(repaired, None, workers, prepare=load_engines) as there, suppress(KeyboardInterrupt):
        for claim, done in zip(claims, there.map(range(len(claims))), strict=True):
            found[claim.id] = Repair(claim, *done)
            progress(found[claim.id])
