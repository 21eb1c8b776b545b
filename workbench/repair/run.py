"""Repair of several claims, side by side on the cores, and what it comes to in the report."""

from __future__ import annotations

import multiprocessing
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

from workbench.judge.verdict import Outcome
from workbench.papers import load_paper
from workbench.papers.model import Claim
from workbench.repair.limits import STANDARD, Limits
from workbench.repair.repair import Repair, repair
from workbench.verify import ClaimResult

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
    if any(claim.file is None for claim in claims):
        workers = 1
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
    # forked workers would inherit the locks of other threads; in others the hashes that terms remember do not
    # hold, so claims are loaded there and not sent
    pool = ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"))
    try:
        pending = {pool.submit(_repair_there, claim.file, claim.id, limits): claim for claim in claims}
        for done in as_completed(pending):
            claim = pending[done]
            found[claim.id] = replace(done.result(), claim=claim)
            progress(found[claim.id])
    except KeyboardInterrupt:
        pass
    finally:
        pool.shutdown(wait=False, cancel_futures=True)


def _repair_there(file: Path, name: str, limits: Limits) -> Repair:
    claim = next(claim for claim in _claims_of(file) if claim.id == name)
    return replace(repair(claim, limits), claim=None)


@cache
def _claims_of(file: Path) -> tuple[Claim, ...]:
    return load_paper(file).claims


def proposals_for(
    results: Iterable[ClaimResult],
    limits: Limits = STANDARD,
    progress: Callable[[Repair], None] = lambda found: None,
) -> dict[str, list[dict[str, Any]]]:
    """By claim id, what the machine proposes where the printed form is refuted or ill-formed."""
    claims = [r.claim for r in results if r.verdict.outcome in TO_REPAIR and r.claim.theorem is None]
    repairs = repair_claims(claims, limits, progress) if claims else []
    return {found.claim.id: found.proposed() for found in repairs}


def with_proposals(claim: Mapping[str, Any], proposed: Mapping[str, list[dict[str, Any]]]) -> dict[str, Any]:
    """A claim of the report with the key "proposed": a list of {latex, edit, difference, verdict},
    few changes first."""
    return {**claim, "proposed": proposed.get(claim["id"], [])}
