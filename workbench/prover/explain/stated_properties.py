"""Definitions of a symbol against the properties that the text states of it."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace

from workbench.context.claims import Claim, Formula
from workbench.context.facts import Act
from workbench.context.free_symbols import free_in
from workbench.core.codes.context_codes import ContextCode
from workbench.core.construct import block
from workbench.core.properties import PROPERTIES
from workbench.core.terms import Block, IllFormed, Relation, Statement, Term
from workbench.core.types import SCALAR
from workbench.core.verdict import Outcome, Strength, Verdict
from workbench.language.printing.printer import to_latex
from workbench.prover.explain.decide_under_facts import JudgeOf, judged_alone

#: The most free numbers in a matrix that is the general form of its kind, and does not only name its entries.
_MOST_NUMBERS = 4


def with_stated_properties(
    claim: Claim, verdict: Verdict, judge_of: JudgeOf, explained: Callable[[Claim, Verdict], Verdict]
) -> Verdict:
    """Returns the verdict; `refuted` if a definition contradicts a property that the text states.

    explained: the verdict on a refuted claim. A property that holds under a convention, such as a unit
    quaternion, is not contradicted.
    """
    said = claim.printed.statement
    if verdict.outcome is not Outcome.DEFINITION or not isinstance(said, Relation):
        return verdict
    for name, words in claim.context.properties:
        against = _against(claim, name, said.right, judge_of, explained)
        if against is not None:
            sides = against.counterexample.left if against.counterexample else ()
            equation = "M^T M = I" if len(sides) > 1 else "\\det M = 1"
            reason = ContextCode.LACKS_PROPERTY(symbol=to_latex(said.left), words=words, equation=equation)
            return replace(against, reason=reason, basis=Strength.HINTED, read_back=verdict.read_back)
    return verdict


def _against(
    claim: Claim,
    name: str,
    value: Term,
    judge_of: JudgeOf,
    explained: Callable[[Claim, Verdict], Verdict],
) -> Verdict | None:
    """Returns the refutation of the property of a value; None if there is none without a doubt."""
    numbers = free_in([value], claim.notation.definitions)
    if sum(each.type.rows * each.type.columns for each in numbers) > _MOST_NUMBERS:
        return None
    with suppress(IllFormed):
        statement = stated_property(name, value)
        alone = _claim_of(claim, statement)
        base = judged_alone(alone, judge_of)
        found = explained(alone, base) if base.outcome is Outcome.REFUTED else base
        if found.outcome is Outcome.REFUTED and not found.unless:
            return found
    return None


def stated_property(name: str, value: Term) -> Statement:
    """Returns the statement that a value, or the rotation in it, has the property. Raises IllFormed."""
    return PROPERTIES[name].statement_of(turned(value))


def turned(value: Term) -> Term:
    """Returns the rotation in a matrix: the first three rows and columns of 4×4 numbers, else all of it."""
    if isinstance(value, Block) and (value.type.rows, value.type.columns) == (4, 4):
        cells = value.entries
        if len(cells) == 4 and all(cell.type == SCALAR for row in cells for cell in row):
            return block([row[:3] for row in cells[:3]])
    return value


def _claim_of(claim: Claim, statement: Statement) -> Claim:
    """Returns the claim that asserts a statement in the place of the printed one."""
    bare = replace(claim, printed=Formula(to_latex(statement), statement), assume=(), orders=None)
    return bare.with_context(given=(), act=(Act.ASSERT, None), properties=())
