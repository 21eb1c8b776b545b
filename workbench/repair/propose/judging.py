"""The judge as the search for right forms asks it."""

from __future__ import annotations

from workbench.judge.kernel.judge import Judge
from workbench.judge.subject.assumptions import Unsatisfiable
from workbench.judge.subject.inventory import NotExact
from workbench.judge.verdict import Verdict
from workbench.language.terms import IllFormed, Statement
from workbench.papers.model import Claim


def verdict_or_none(claim: Claim, judge: Judge, statement: Statement) -> Verdict | None:
    """The verdict on a statement in the place of the claim's; None where it cannot be judged."""
    try:
        return judge.judge(statement, assume=claim.supposed, orders=claim.orders)
    except (Unsatisfiable, IllFormed, NotExact):
        return None
