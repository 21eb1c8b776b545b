"""Indices without a stated range, of families of which the definitions hold some members."""

from __future__ import annotations

from dataclasses import replace

from workbench.context.claims import Claim
from workbench.context.free_symbols import terms_of
from workbench.context.index_values import Orders
from workbench.core.codes.context_codes import ContextCode
from workbench.core.hypotheses import Hypothesis, Phrase
from workbench.core.integer_expressions import Linear
from workbench.core.terms import Symbol, sides_of
from workbench.core.verdict import Outcome, Strength, Verdict
from workbench.prover.explain.decide_under_facts import JudgeOf, conditional, judged_alone


def for_known_members(claim: Claim, refuted: Verdict, judge_of: JudgeOf) -> Verdict | None:
    """Returns the verdict on a refuted claim that holds for the members that the definitions hold, else None.

    The model of a robot with two joints says so that k in q_k is 1 or 2.
    """
    known = _known_orders(claim)
    if known is None or known.ranges == (claim.orders or known).ranges:
        return None
    found = judged_alone(replace(claim, orders=known), judge_of)
    if found.outcome not in (Outcome.PROVED, Outcome.CONDITIONAL):
        return None
    held = conditional(
        found,
        Hypothesis.together([found.hypothesis], Phrase(str(known))),
        ContextCode.FOR_KNOWN_MEMBERS(orders=known),
        refuted,
    )
    return replace(held, basis=Strength.HINTED)


def _known_orders(claim: Claim) -> Orders | None:
    """Returns the orders with the indices of known members as ranges; None if no family has such members."""
    orders = claim.orders
    if orders is None or not orders.generic:
        return None
    ranges = {**orders.ranges}
    for name in orders.generic:
        if not (numbers := _numbers_of_members(claim, name)):
            return None
        ranges[name] = range(min(numbers), max(numbers) + 1)
        if len(ranges[name]) != len(numbers):
            return None
    stated = tuple(each for each in orders.stated if not each.generic)
    return Orders(ranges, stated, orders.endless)


def _numbers_of_members(claim: Claim, name: str) -> set[int]:
    """Returns the numbers that definitions write for the index of the undefined families that have it; none
    if the formula itself writes one."""
    definitions, own = claim.notation.definitions, (Linear.variable(name),)
    written = {part for part in terms_of(claim.printed.parsed) if isinstance(part, Symbol)}
    families = {part.declaration for part in written if part.index == own and not definitions.about(part)}
    if any(part.declaration in families and part.index != own for part in written):
        return set()
    reached = definitions.symbols_in(*sides_of(claim.printed.parsed))
    members = {each for each in reached if each.declaration in families}
    return {int(part.index[0]) for part in members if part.index[0].is_number}
