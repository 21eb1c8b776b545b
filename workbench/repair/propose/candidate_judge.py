"""Judge of candidates, in a process with limits."""

from __future__ import annotations

from functools import partial

from workbench.context.claims import Claim
from workbench.core.terms import IllFormed, Statement
from workbench.core.verdict import Verdict
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.assumptions import Unsatisfiable
from workbench.prover.decide.decide import Judge
from workbench.prover.preload import load_engines
from workbench.runtime import Budget, Workers


def judging(claim: Claim, judge: Judge) -> Workers:
    """Returns a worker pool of `verdict_or_none`, which is ended at its limits."""
    return Workers(partial(verdict_or_none, claim, judge), Budget(), prepare=load_engines)


def verdict_or_none(claim: Claim, judge: Judge, statement: Statement) -> Verdict | None:
    """Returns the verdict on a statement instead of the claim's; None if it cannot be judged."""
    try:
        return judge.judge(statement, assume=claim.supposed, orders=claim.orders)
    except (Unsatisfiable, IllFormed, NotExact):
        return None
