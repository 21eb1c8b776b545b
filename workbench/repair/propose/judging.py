"""The judge as the search for right forms asks it."""

from __future__ import annotations

from functools import partial

from workbench.budget import Budget, Workers
from workbench.judge.kernel.judge import Judge
from workbench.judge.loading import load_engines
from workbench.judge.subject.assumptions import Unsatisfiable
from workbench.judge.subject.inventory import NotExact
from workbench.judge.verdict import Verdict
from workbench.language.typed.terms import IllFormed, Statement
from workbench.papers.model import Claim


def judging(claim: Claim, judge: Judge) -> Workers:
    """`verdict_or_none` of statements, in a process that ends with its budget."""
    return Workers(partial(verdict_or_none, claim, judge), Budget(), prepare=load_engines)


def verdict_or_none(claim: Claim, judge: Judge, statement: Statement) -> Verdict | None:
    """The verdict on a statement in the place of the claim's; None where it cannot be judged."""
    try:
        return judge.judge(statement, assume=claim.supposed, orders=claim.orders)
    except (Unsatisfiable, IllFormed, NotExact):
        return None
