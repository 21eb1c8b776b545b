"""Equations of numbers: without symbols other than π."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from itertools import chain, islice

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import relation
from workbench.core.terms import IllFormed, Relation, Statement, Symbol, Term
from workbench.core.verdict import Counterexample, EngineDisagreement, Evidence, Outcome, Verdict
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.polynomial.closed_numbers import exactly_equal, surely_apart
from workbench.language.definitions import Definitions, expand
from workbench.language.printing.printer import to_latex
from workbench.prover.decide.inference import agreement

#: The method in the evidence of verdicts on numbers.
NUMBERS = "numbers in balls (Arb)"
_LARGEST = 2000


def judge_closed(
    said: Statement, assume: Sequence[Statement], definitions: Lookup, second_engine: bool = True
) -> Verdict | None:
    """Returns the verdict on an equation of numbers under true premises; None if it contains symbols or is
    undecided.

    Without the second engine nothing is proved.
    """
    if not isinstance(definitions, Definitions) or not all(_holds(each, definitions) for each in assume):
        return None
    verdict = _of_relation(said, definitions) if isinstance(said, Relation) and said.operator == "=" else None
    if verdict is not None and verdict.outcome is Outcome.PROVED and not second_engine:
        return Verdict(
            Outcome.PROBABLE, reason=VerdictCode.SECOND_ENGINE_LEFT_OUT(), evidence=verdict.evidence[:1]
        )
    return verdict


def _holds(premise: Statement, definitions: Definitions) -> bool:
    if not isinstance(premise, Relation) or premise.operator == "≈":
        return False
    verdict = _of_relation(premise, definitions)
    wanted = Outcome.PROVED if premise.operator == "=" else Outcome.REFUTED
    return verdict is not None and verdict.outcome is wanted


def _of_relation(said: Relation, definitions: Definitions) -> Verdict | None:
    """Returns the verdict on the equation of its sides."""
    sides = (said.left, said.right)
    if not all(_is_number(part, definitions) for side in sides for part in definitions.reached(side)):
        return None
    with suppress(NotExact, IllFormed, ZeroDivisionError):
        numbers = relation("=", *(expand(side, definitions) for side in sides))
        walk = chain(numbers.left.walk(), numbers.right.walk())
        return None if any(True for _ in islice(walk, _LARGEST, None)) else _judged(numbers)
    return None


def _is_number(part: Term, definitions: Definitions) -> bool:
    if not isinstance(part, Symbol) or definitions.about(part):
        return True
    return definitions.is_pi(part.declaration)


def _judged(numbers: Relation) -> Verdict | None:
    from workbench.engines.jet.closed_values import nearly_equal

    sides = surely_apart(numbers)
    if sides is None and not exactly_equal(numbers):
        return None
    if nearly_equal(numbers) != (sides is None):
        raise EngineDisagreement(f"a value of one engine only: {to_latex(numbers)}")
    if sides is None:
        evidence = (
            Evidence("cyclotomic field (FLINT)", "residual is 0"),
            Evidence("SymPy", "60 digits agree"),
        )
        return agreement(*evidence, evidence)
    evidence = (
        Evidence(NUMBERS, "the two sides differ"),
        Evidence("SymPy, 60 digits", "the two sides differ"),
    )
    return Verdict(Outcome.REFUTED, counterexample=Counterexample({}, *sides), evidence=evidence)


def is_of_numbers(verdict: Verdict) -> bool:
    """True for a verdict on an equation of numbers."""
    return any(evidence.method == NUMBERS for evidence in verdict.evidence)
