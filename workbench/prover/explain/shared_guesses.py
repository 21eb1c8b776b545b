"""Guesses that several formulas of a text need. A text that writes under a guess means it: it is a hint then.

If three formulas hold only for a unit quaternion q, then q is unit, and what holds for it is no falsehood.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from workbench.context.claims import Claim
from workbench.context.conventions import guesses_of_texts
from workbench.context.facts import Fact, Strength
from workbench.context.formula_acts import subject_of
from workbench.context.free_symbols import terms_of
from workbench.core.codes.doubt_codes import DoubtCode, single_doubts
from workbench.core.terms import Apply, Symbol
from workbench.core.verdict import Outcome
from workbench.prover.results.claim_results import ClaimResult

#: Number of formulas from which on a guess is one of the whole text.
ENOUGH = 3


def on_shared_guesses(results: Sequence[ClaimResult]) -> list[Claim]:
    """Returns the refuted claims that a shared guess makes true, with that guess as a hint.

    They are to be judged again.
    """
    needing: dict[Fact, dict[str, Claim]] = {}
    for result in results:
        for guess in _needed(result):
            needing.setdefault(guess, {}).setdefault(result.claim.printed.latex, result.claim)
    shared = {guess for guess, claims in needing.items() if len(claims) >= ENOUGH}
    return [
        result.claim.with_context(facts=(*result.claim.context.facts, _hint(guess)))
        for result in results
        for guess in _needed(result)
        if guess in shared
    ]


def _needed(result: ClaimResult) -> Iterator[Fact]:
    """Yields the guess under which a refuted claim of a text holds.

    A formula that writes ‖n‖ does not mean a unit n.
    """
    statement = result.claim.printed.statement
    if result.verdict.outcome is not Outcome.REFUTED or statement is None or not result.claim.context.span:
        return
    norms = (part for part in terms_of(statement) if isinstance(part, Apply) and part.head == "norm")
    sized = {inner.declaration.name for part in norms for inner in part.children if isinstance(inner, Symbol)}
    doubts = {
        doubt.arguments["facts"]
        for reason in result.verdict.unless
        for doubt in single_doubts(reason)
        if doubt.code is DoubtCode.FACTS
    }
    if doubts:
        guesses = guesses_of_texts(subject_of(result.claim))
        yield from (each for each in guesses if str(each) in doubts and each.about.isdisjoint(sized))


def _hint(guess: Fact) -> Fact:
    words = f"{guess.origin.text}, as other formulas hold only then"
    return replace(guess, origin=replace(guess.origin, text=words), strength=Strength.HINTED)
