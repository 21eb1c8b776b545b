"""Claims that are false only where their premises do not last, as ḟ = 0 where f = 1 at one instant."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.terms import IllFormed, Statement, sides_of
from workbench.core.verdict import Outcome, Verdict
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.assumptions import Unsatisfiable
from workbench.engines.inventory.inventory import has_gradient
from workbench.engines.inventory.prolonged_premises import prolonged
from workbench.prover.decide.premise_consequences import is_constant


def unless_lasting(
    refuted: Verdict,
    claim: Statement,
    premises: Sequence[Statement],
    definitions: Lookup,
    judge: Callable[[Statement, tuple[Statement, ...]], Verdict],
) -> Verdict:
    """Returns the verdict on a claim that is refuted under premises at the instant.

    It stays refuted only if it is refuted under their derivatives, too: else its author has to state which is
    meant. judge: of the claim, under the premises with more of them.
    """
    moving = [p for p in premises if not all(is_constant(side, definitions) for side in sides_of(p))]
    try:
        if not (further := prolonged(moving, claim, definitions)):
            return refuted
        again = judge(claim, (*premises, *further))
        if again.outcome is Outcome.REFUTED:
            return again
    except Unsatisfiable:
        return refuted  # t = 0 holds at one instant
    except (NotExact, IllFormed):
        pass
    code = VerdictCode.AT_ONE_PLACE if has_gradient(sides_of(claim)) else VerdictCode.AT_ONE_INSTANT
    return Verdict(Outcome.UNCHECKED, reason=code())
