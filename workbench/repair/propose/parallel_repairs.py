"""Parallel repair of several claims."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress

from workbench.context.claims import Claim
from workbench.prover.preload import load_engines
from workbench.repair.propose.chain_neighbours import ALONE, Neighbours, neighbours_of
from workbench.repair.propose.proposal import Proposal, Repair
from workbench.repair.propose.repair import repair
from workbench.repair.propose.search_limits import STANDARD, Limits
from workbench.runtime import Workers


def repair_claims(
    claims: Sequence[Claim],
    limits: Limits = STANDARD,
    progress: Callable[[Repair], None] = lambda found: None,
    beside: Mapping[str, Neighbours] | None = None,
) -> list[Repair]:
    """Returns the repairs of the claims, in their order.

    Ctrl-C keeps the finished repairs, and for a single claim the proposals so far.

    progress: called with each repair as soon as it is finished.
    beside: claim id → the neighbouring steps; if None, they are found among the claims.
    """
    known = neighbours_of(claims) if beside is None else beside
    found: dict[str, Repair] = {}
    workers = min(os.cpu_count() or 1, len(claims))
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
        """Returns the repair without the claim, which need not be sent back."""
        done = repair(claims[place], limits, beside=beside.get(claims[place].id, ALONE))
        return done.proposals, done.candidates, done.seconds, done.complete, done.interrupted

    with Workers(repaired, None, workers, prepare=load_engines) as there, suppress(KeyboardInterrupt):
        for claim, done in zip(claims, there.map(range(len(claims))), strict=True):
            found[claim.id] = Repair(claim, *done)
            progress(found[claim.id])
