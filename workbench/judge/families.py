"""Statements about integers n: for every n at once where the recurrences allow it, else for a range.

With Φₙ, aₙ, … left as free functions and Φₙ₊₁, aₙ₊₁, … replaced by their recurrences, an identity between
them holds whatever the n-th members are; so it holds for every n from which the recurrences are in force.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from workbench.judge.inventory import NotExact
from workbench.judge.verdict import EngineDisagreement, Evidence, Outcome, Verdict
from workbench.language.instances import instantiate
from workbench.language.integers import Linear
from workbench.language.terms import (
    Conjunction,
    Equivalence,
    IllFormed,
    Implication,
    Relation,
    Statement,
    Symbol,
    Term,
)

if TYPE_CHECKING:
    from workbench.judge.judge import Judge, OrderRanges

SAME_TERM = "both sides are the same term, so nothing is tested"


def judge_family(
    judge: Judge,
    statement: Statement,
    assume: tuple[Statement, ...],
    hypothesis: Statement | None,
    orders: OrderRanges | None,
) -> Verdict:
    """The verdict on a statement whose integer variables are those of `orders`."""
    if orders is None:
        return _instance(judge, statement, assume, hypothesis)
    general = _for_all(judge, statement, assume, hypothesis)
    if general is None or general.outcome != Outcome.PROVED:
        return _instances(judge, statement, assume, hypothesis, orders)
    # the range is then a check of the argument for all n, and one engine is enough for it
    instances = _instances(replace(judge, second_engine=False), statement, assume, hypothesis, orders)
    if instances.outcome not in (Outcome.PROVED, Outcome.PROBABLE, Outcome.DEFINITION):
        raise EngineDisagreement(f"proved for all n, but {instances.outcome} {instances.reason}")
    checked = Evidence("each instance, exact ring", "residual is 0", {"orders": str(orders)})
    scope = f"all {', '.join(sorted(_variables(statement)))}"
    outcome = Outcome.DEFINITION if instances.outcome == Outcome.DEFINITION else general.outcome
    return replace(general, outcome=outcome, scope=scope, evidence=(*general.evidence, checked))


def _for_all(
    judge: Judge, statement: Statement, assume: tuple[Statement, ...], hypothesis: Statement | None
) -> Verdict | None:
    """With the lowest member of each family free; None where the statement is not of that form."""
    lowest: dict[str, int] = {}
    for term in _terms(statement):
        for part in term.walk():
            if isinstance(part, Symbol):
                for index in part.index:
                    for name in index.variables:
                        if index.coefficients != ((name, 1),):
                            return None
                        lowest[name] = min(lowest.get(name, 0), index.constant)
    shift = {name: Linear.variable(name) - low for name, low in lowest.items()}
    try:
        shifted = instantiate(statement, shift)
        supposed = tuple(instantiate(a, shift) for a in assume)
        given = None if hypothesis is None else instantiate(hypothesis, shift)
        verdict = judge.judge_instance(shifted, supposed, given)
    except (NotExact, IllFormed):
        return None
    free = Evidence("all n at once", "the n-th members are free functions, the next ones by recurrence")
    return replace(verdict, evidence=(*verdict.evidence, free))


def _instances(
    judge: Judge,
    statement: Statement,
    assume: tuple[Statement, ...],
    hypothesis: Statement | None,
    orders: OrderRanges,
) -> Verdict:
    """The worst verdict over the range: the first that fails, else one that is not a mere definition."""
    verdict, count = None, 0
    for values in orders.assignments():
        given = None if hypothesis is None else instantiate(hypothesis, values)
        supposed = tuple(instantiate(a, values) for a in assume)
        current = _instance(judge, instantiate(statement, values), supposed, given)
        if current.reason == SAME_TERM:
            continue
        if current.outcome in (Outcome.REFUTED, Outcome.UNCHECKED):
            place = ", ".join(f"{name} = {value}" for name, value in values.items())
            reason = f"for {place}" + (f": {current.reason}" if current.reason else "")
            before = Evidence("each instance", f"fails for {place}", {"held before": count})
            return replace(current, reason=reason, evidence=(*current.evidence, before))
        count += 1
        if verdict is None or verdict.outcome == Outcome.DEFINITION:
            verdict = current
    if verdict is None:
        return Verdict(Outcome.UNCHECKED, reason=SAME_TERM)
    evidence = (*verdict.evidence, Evidence("each instance", "residual is 0", {"instances": count}))
    return replace(verdict, scope=str(orders), evidence=evidence)


def _instance(
    judge: Judge, statement: Statement, assume: tuple[Statement, ...], hypothesis: Statement | None
) -> Verdict:
    try:
        return judge.judge_instance(statement, assume, hypothesis)
    except (NotExact, IllFormed) as outside:
        return Verdict(Outcome.UNCHECKED, reason=str(outside))


def _variables(statement: Statement) -> set[str]:
    names: set[str] = set()
    for term in _terms(statement):
        for part in term.walk():
            if isinstance(part, Symbol):
                names |= {name for index in part.index for name in index.variables}
    return names


def _terms(statement: Statement) -> Iterator[Term]:
    match statement:
        case Relation():
            yield from (statement.left, statement.right)
        case Equivalence() | Implication():
            yield from _terms(statement.left)
            yield from _terms(statement.right)
        case Conjunction():
            for part in statement.parts:
                yield from _terms(part)
