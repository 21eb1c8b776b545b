"""False equations of a draft that are usual misprints: one change makes them true, or another formula says
otherwise."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from workbench.context.claims import Claim
from workbench.context.free_symbols import free_in
from workbench.context.repeated_laws import definitions_in
from workbench.core.terms import Derivative, sides_of
from workbench.core.verdict import Outcome, Verdict
from workbench.language.definitions import Definitions
from workbench.papers.drafting.drafted_texts import Draft
from workbench.papers.drafting.meanings.contradictions import flagged
from workbench.prover.decide.decide import Judge
from workbench.prover.explain.decide_under_facts import judged_or_unchecked
from workbench.prover.explain.laws_of_motion import under_its_laws
from workbench.prover.results.claim_results import ClaimResult
from workbench.repair.propose.usual_changes import Nearness, nearness

#: The seconds for the search of such a change.
_SECONDS_OF_CHANGES = 1.0


def contradicted(draft: Draft, result: ClaimResult) -> Verdict:
    """Returns the verdict on a formula, which is refuted if another formula contradicts it."""
    own, verdict = result.claim.id, result.verdict
    if verdict.outcome in (Outcome.PROVED, Outcome.CONDITIONAL, Outcome.ILL_FORMED):
        return verdict
    for each in (each for each in draft.contradicted if each.claim == own):
        judge = Judge(each.known)
        found = judged_or_unchecked(partial(judge.judge, each.statement, each.assume))
        if found.outcome is Outcome.REFUTED:
            return replace(found, reason=each.reason, read_back=verdict.read_back)
    return verdict


def is_misprint(claim: Claim) -> bool:
    """True if a false equation holds after one usual change, under the definitions and laws of the text."""
    return distance(claim) is Nearness.NEAR


def distance(claim: Claim, every: bool = False) -> Nearness:
    """Returns how near a false equation is to one that holds, if symbols without a rate are constant.

    The definitions of the model alone are tried first. every: unusual changes count, too.
    """
    found = Nearness.OPEN
    for known in dict.fromkeys((claim.notation.definitions, definitions_of(claim))):
        found = _distance(claim, known, every)
        if found is Nearness.NEAR:
            break
    return found


def _distance(claim: Claim, known: Definitions, every: bool) -> Nearness:
    statement = claim.printed.statement
    if statement is None:
        return Nearness.OPEN
    rates = (part for each in known for part in each.body.walk() if isinstance(part, Derivative))
    moving = claim.context.moving | {part.declaration.name for rate in rates for part in rate.symbols()}
    supposed = under_its_laws(claim).supposed
    free = free_in((side for each in (statement, *supposed) for side in sides_of(each)), known)
    rests = {str(each.name) for each in free if each.name not in moving}

    def flag_of(name: str) -> str:
        return "constant" if name in rests else ""

    still, resting = flagged(statement, known, flag_of)
    premises = [flagged(each, Definitions(), flag_of)[0] for each in supposed]
    return nearness(still, resting, premises, claim.instances, _SECONDS_OF_CHANGES, True, every)


def definitions_of(claim: Claim) -> Definitions:
    """Returns the definitions of the model and those of the text."""
    said = definitions_in(claim.context.facts, claim.notation.definitions)
    return Definitions([*claim.notation.definitions, *said])
