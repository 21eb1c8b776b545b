"""Proofs under a premise that is false, by itself or because of the model's definitions."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from workbench.context.claims import Claim, Formula
from workbench.context.formula_acts import act_of, constrains, says_of_defined
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.hypotheses import Hypothesis, Phrase
from workbench.core.terms import Implication, Statement
from workbench.core.verdict import Outcome, Verdict
from workbench.language.printing.printer import to_latex
from workbench.prover.explain.decide_under_facts import JudgeOf, conditional, judged_alone


def under_premises(
    claim: Claim, proved: Verdict, judge_of: JudgeOf, explained: Callable[[Claim, Verdict], Verdict]
) -> Verdict:
    """Returns the verdict; `conditional` on a premise that contradicts the definitions of its symbols, or on
    a given formula that is reported as false. explained: the verdict on a refuted claim."""
    for premise, is_given in _premises(claim):
        contradicts = says_of_defined(premise, claim.notation.definitions)
        if not contradicts and (not is_given or constrains(premise, claim.notation.definitions)):
            continue
        formula = Formula(to_latex(premise), premise)
        correction = replace(claim.correction, hypothesis=None)
        bare = replace(claim, printed=formula, assume=(), orders=None, correction=correction)
        alone = bare.with_context(given=(), facts=(), act=act_of(formula, claim.notation))
        judged = judged_alone(alone, judge_of)
        if judged.outcome is Outcome.REFUTED and not contradicts:
            judged = explained(alone, judged)
        if judged.outcome is Outcome.REFUTED:
            hypothesis = Hypothesis.together([proved.hypothesis], Phrase(formula.latex))
            given = VerdictCode.GIVEN_IS_FALSE(formula=formula.latex)
            why = VerdictCode.CONTRADICTS_DEFINITIONS() if contradicts else given
            return conditional(proved, hypothesis, why, judged)
    return proved


def _premises(claim: Claim) -> Iterator[tuple[Statement, bool]]:
    """Yields the hypotheses of the claim, with True for those that are given formulas."""
    said = claim.printed.statement
    if isinstance(said, Implication):
        yield said.left, False
    for formula in claim.context.given:
        if formula.statement is not None:
            yield formula.statement, True
