"""Right claims of the chapter damaged in one place, and in two: how many are repaired, and how fast."""

from __future__ import annotations

import multiprocessing
import os
from concurrent.futures import ProcessPoolExecutor
from random import Random
from statistics import median

import pytest
from repair.damage import Damaged, Result, damages, repaired, right_claims, twice

from workbench.papers import find_paper
from workbench.prover.results.claim_results import HOLDS

SEED = 6
#: Damaged claims, damages of one kind for one claim, the least share that is repaired as it was.
CAMPAIGNS = {1: (1000, 3, 0.95), 2: (200, 3, 0.70)}
LONGEST, TYPICAL = 30.0, 2.0

_pool: list[Damaged] = []  # what forked processes find in place


def damaged_claims(count: int, each: int, times: int) -> list[Damaged]:
    """So many claims with one damage, or with two."""
    random = Random(SEED)
    pool = [d for claim, formula in right_claims(find_paper()) for d in damages(claim, formula, random, each)]
    random.shuffle(pool)
    if times == 2:
        both = (twice(damaged, random) for damaged in pool)
        pool = [damaged for damaged, _ in zip((d for d in both if d is not None), range(count), strict=False)]
    return pool[:count]


def repair_all(pool: list[Damaged]) -> list[Result]:
    """On all cores."""
    _pool[:] = pool
    with ProcessPoolExecutor(os.cpu_count(), multiprocessing.get_context("fork")) as executor:
        return list(executor.map(_repaired, range(len(pool))))


def _repaired(place: int) -> Result:
    return repaired(_pool[place])


def table(results: list[Result]) -> str:
    lines = [f"{'damage':<28}{'claims':>8}{'proved':>8}{'same':>8}{'median s':>10}{'longest s':>11}"]
    for kind in [*sorted({r.kind for r in results}), None]:
        of = [r for r in results if kind in (r.kind, None)]
        seconds = [r.seconds for r in of]
        proved, same = sum(bool(r.verdicts) for r in of), sum(r.same for r in of)
        lines.append(
            f"{kind or 'all':<28}{len(of):>8}{proved:>8}{same:>8}{median(seconds):>10.2f}{max(seconds):>11.1f}"
        )
    return "\n".join(lines)


@pytest.mark.slow
@pytest.mark.parametrize("times", CAMPAIGNS)
def test_campaign(times, capsys):
    count, each, least = CAMPAIGNS[times]
    results = repair_all(damaged_claims(count, each, times))
    with capsys.disabled():
        print(f"\n{table(results)}")
        for r in results:
            if not r.same:
                print(f"not repaired as it was: {r.kind}, {r.id}: {r.latex}")
    assert len(results) == count
    assert {v for r in results for v in r.verdicts} <= set(map(str, HOLDS))
    assert max(r.seconds for r in results) < LONGEST
    assert median(r.seconds for r in results) < TYPICAL
    assert sum(r.same for r in results) >= least * count
