"""Poles of a claim that the conditions beside it exclude: a/f of “provided that f ≠ 0”."""

from __future__ import annotations

from collections.abc import Sequence

from workbench.context.claims import Claim
from workbench.context.facts import Fact, Provider
from workbench.core.codes.context_codes import ContextCode
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.hypotheses import Hypothesis
from workbench.core.verdict import Outcome, Verdict
from workbench.prover.explain.decide_under_facts import Decider, conditional, minimise

POLES = frozenset({VerdictCode.DENOMINATOR_CAN_VANISH, VerdictCode.DENOMINATOR_NOT_EXCLUDED})


def without_poles(claim: Claim, base: Verdict, decider: Decider) -> Verdict:
    """Returns the verdict under the conditions that the text states, if they exclude the poles of the claim.

    base: the verdict without them. Raises OutOfDecisions.
    """

    def is_proved(facts: Sequence[Fact]) -> bool:
        return decider.decide(facts).outcome is Outcome.PROVED

    facts = claim.context.facts
    said = [f for f in facts if f.origin.provider is Provider.CONDITION and f.content is not None]
    if not said or not is_proved(said):
        return base
    core = minimise(said, is_proved)
    words = "; ".join(dict.fromkeys(map(str, core)))
    hypothesis = Hypothesis.together((), *(fact.origin.phrase for fact in core))
    return conditional(decider.decide(core), hypothesis, ContextCode.HOLDS_BY(facts=words), base)
