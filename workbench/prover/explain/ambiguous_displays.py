"""Verdicts on displays with two readings: how rows are joined, and whether equations next to a formula are
its conditions."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from math import isqrt
from typing import TypeAlias

from workbench.context.claims import Claim, Formula
from workbench.context.facts import Act
from workbench.context.formula_acts import act_of
from workbench.context.read_formulas import read_statement
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.hypotheses import Hypothesis
from workbench.core.terms import Conjunction, Statement
from workbench.core.verdict import Evidence, Outcome, Verdict
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.assumptions import lasting
from workbench.prover.explain.decide_under_facts import conditional

#: Function that returns the verdict on a claim under its hypotheses.
Judged: TypeAlias = Callable[[Claim], Verdict]

_TRUE = frozenset({Outcome.PROVED, Outcome.DEFINITION})
_FALSE = frozenset({Outcome.REFUTED, Outcome.ILL_FORMED})
_METHOD = "two readings"


def in_both_readings(claim: Claim, printed: Verdict, judged: Judged) -> Verdict:
    """Returns the verdict that holds for both readings of the display's rows, or else its question.

    printed: the verdict on the first reading.   judged: gives the verdict on a claim. The formulas of
    `otherwise` form one reading: all of them must hold, and one false formula makes it false.
    """
    if claim.ambiguity.question is None:
        return printed
    asked = Verdict(
        Outcome.UNCHECKED,
        reason=VerdictCode.TWO_READINGS(question=claim.ambiguity.question),
        read_back=printed.read_back,
    )
    if not claim.ambiguity.otherwise or printed.outcome not in _TRUE | _FALSE:
        return asked
    others = ((formula, judged(_as_printed(claim, formula))) for formula in claim.ambiguity.otherwise)
    shown = ", ".join(map(str, claim.ambiguity.otherwise))
    if printed.outcome in _FALSE:
        false = next((formula for formula, verdict in others if verdict.outcome in _FALSE), None)
        evidence = Evidence(_METHOD, "false in both", {"formula": str(false)})
        return asked if false is None else replace(printed, evidence=(*printed.evidence, evidence))
    if all(verdict.outcome in _TRUE for _, verdict in others):
        evidence = Evidence(_METHOD, "true in both", {"formula": shown})
        return replace(printed, evidence=(*printed.evidence, evidence))
    return asked


def _as_printed(claim: Claim, formula: Formula) -> Claim:
    """Returns the claim with this formula as its printed formula."""
    said = formula.statement
    act = (Act.ASSERT, None) if said is None or claim.context.alone else act_of(formula, claim.notation)
    ambiguity = replace(claim.ambiguity, otherwise=(), question=None)
    return replace(claim, printed=formula, ambiguity=ambiguity).with_context(act=act)


def served_by(claim: Claim, bare: Verdict, judged: Judged) -> Formula | None:
    """Returns a refuted formula that a refuted claim may be a condition of, else None.

    If all formulas before the claim hold without it, it is not a condition of them, and stays refuted.
    """
    if bare.outcome is not Outcome.REFUTED or claim.context.alone or claim.corrected is not None:
        return None
    readable = [formula for formula in claim.ambiguity.serves if formula.statement is not None]
    plain = replace(claim, ambiguity=replace(claim.ambiguity, perhaps=(), serves=()))
    verdicts = ((each, judged(replace(plain, printed=each))) for each in readable)
    return next((each for each, verdict in verdicts if verdict.outcome is Outcome.REFUTED), None)


def with_what_stands_beside(claim: Claim, bare: Verdict, judged: Judged) -> tuple[Claim, Verdict]:
    """Returns the claim and its verdict if the equations next to it may be its conditions.

    They matter only if it is refuted without them. The returned claim contains the conditions that the
    verdict depends on.
    """
    if (
        bare.outcome is not Outcome.REFUTED
        or not claim.ambiguity.perhaps
        or claim.context.alone
        or claim.corrected is not None
    ):
        return claim, bare
    readable = [formula for formula in claim.ambiguity.perhaps if formula.statement is not None]
    for supposing, conditions in _suppositions(claim, readable):
        verdict = judged(supposing)
        if verdict.outcome is Outcome.PROVED:
            return claim, _conditional(verdict, conditions, bare)
    whole = replace(claim, assume=(*claim.assume, *readable))
    verdict = judged(whole) if len(readable) == len(claim.ambiguity.perhaps) else Verdict(Outcome.UNCHECKED)
    if verdict.outcome is Outcome.REFUTED:
        return whole, verdict
    if len(readable) == len(claim.ambiguity.perhaps) and _meets(bare, readable, claim, judged):
        return claim, bare
    named = ", ".join(map(str, claim.ambiguity.perhaps))
    reason = VerdictCode.FALSE_WITHOUT_NEIGHBOUR(formulas=named)
    return claim, Verdict(Outcome.UNCHECKED, reason=reason, read_back=bare.read_back)


def _suppositions(claim: Claim, beside: Sequence[Formula]) -> Iterator[tuple[Claim, Sequence[Formula]]]:
    """Yields the claim under each equation alone and under all, at the instant and then at all times."""
    groups = [[each] for each in beside] + [list(beside)] * (len(beside) > 1)
    for group in groups:
        yield replace(claim, assume=(*claim.assume, *group)), group
    for group in groups:
        yield claim.with_context(given=(*claim.context.given, *group)), group


def _conditional(verdict: Verdict, conditions: Sequence[Formula], bare: Verdict) -> Verdict:
    latex = [formula.latex for formula in conditions]
    reason = VerdictCode.HOLDS_WITH_NEIGHBOUR(formulas=", ".join(latex))
    witness = Evidence("witness against the bare statement", "a point where it fails")
    found = conditional(verdict, Hypothesis.of(*latex), reason, bare)
    return replace(found, evidence=(*found.evidence, witness))


def _meets(refuted: Verdict, conditions: Sequence[Formula], claim: Claim, judged: Judged) -> bool:
    """True if the conditions, and those of their rates that the claim contains, hold at the
    counterexample."""
    if refuted.counterexample is None:
        return False
    said = [formula.parsed for formula in conditions]
    definitions = claim.notation.definitions
    with suppress(ReadError, IllFormedAt, NotExact, ValueError):
        point = tuple(_point(refuted.counterexample.values, claim))
        together = Conjunction(tuple(lasting(said, claim.printed.parsed, definitions)))
        asked = replace(claim, printed=Formula("", together), assume=point, orders=None)
        there = asked.with_context(given=())
        return judged(there).outcome is Outcome.PROVED
    return False


def _point(values: Mapping[str, tuple[str, ...]], claim: Claim) -> Iterator[Formula]:
    """Yields the equations that give the symbols their values. Raises ValueError if one cannot be written."""
    for name, entries in values.items():
        latex = f"{name} = {_written(entries)}"
        yield Formula(latex, _equation(latex, claim))


def _equation(latex: str, claim: Claim) -> Statement:
    statement, _ = read_statement(latex, claim.notation, None, as_condition=True)
    return statement


def _written(entries: tuple[str, ...]) -> str:
    """Returns a number, a column or a square matrix as LaTeX."""
    if len(entries) == 1:
        return entries[0]
    size = isqrt(len(entries))
    width = size if size * size == len(entries) and size > 2 else 1
    rows = (" & ".join(entries[at : at + width]) for at in range(0, len(entries), width))
    return r"\begin{bmatrix}" + r" \\ ".join(rows) + r"\end{bmatrix}"
