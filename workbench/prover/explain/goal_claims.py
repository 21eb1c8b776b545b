"""Verdicts on claims with a goal, by its proof, and on formulas for every n."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from workbench.context.claims import Claim, Formula, Notation
from workbench.context.index_values import Orders
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.terms import Statement
from workbench.core.verdict import Outcome, Verdict
from workbench.language.goals.goals import AllFrom, Atom, Goal, GoalError, Implies, Scope, equations
from workbench.language.goals.proofs import False_, Kernel, Proven
from workbench.prover.decide.decide import Judge
from workbench.prover.goals.definedness import is_defined_everywhere
from workbench.prover.goals.prove_goal import Lemmas, prove


class TheoremJudge:
    """judge_of: the judge of formulas in a notation."""

    def __init__(self, theorems: Mapping[str, Proven], judge_of: Callable[[Notation], Judge]) -> None:
        self._theorems, self._judge_of = theorems, judge_of
        self._lemmas: dict[int, Lemmas] = {}  # by definitions

    def verdict(self, claim: Claim) -> Verdict:
        """Returns the verdict by the goal's proof; without one, by the judge of formulas alone.

        An argued claim is joined to its goal by prose only.
        """
        assert claim.proof.goal is not None, f"{claim.id} has no goal"
        proven = Proven(None, False_()) if claim.corrected is not None else Proven(Kernel())
        if claim.proof.theorem is not None:
            proven = self._theorems[claim.proof.theorem]
        bare = claim.proof.goal.bare if claim.correction.hypothesis is not None else None
        verdict = self._shown(claim, claim.proof.goal.goal, proven, bare)
        if claim.proof.argued is None or verdict.outcome is not Outcome.PROVED:
            return verdict
        return replace(
            verdict, outcome=Outcome.ARGUED, scope=None, reason=VerdictCode.ARGUED(how=claim.proof.argued)
        )

    def _shown(self, claim: Claim, goal: Goal, proven: Proven, bare: Goal | None = None) -> Verdict:
        notation = claim.notation
        return prove(
            goal,
            Scope(notation.symbols, notation.definitions, {}),
            self._judge_of(notation),
            proven,
            assume=claim.supposed if claim.proof.goal is not None else (),
            bare=bare,
            lemmas=self._lemmas.setdefault(id(notation.definitions), {}),
        )

    def for_every_n(self, claim: Claim, form: Formula, seen: Verdict) -> Verdict:
        """Returns the verdict on a formula that holds for some n, with the scope "all n" if a proof shows
        that.

        The proof is the one that the claim names, or the judge of formulas alone.
        """
        least = None if claim.orders is None else _least(claim.orders)
        if least is None or not _is_equations(form.parsed):
            return seen
        goal: Goal = Atom(form.parsed)
        for name, value in reversed(least.items()):
            goal = AllFrom(name, value, goal)
        for supposed in reversed(claim.supposed):
            goal = Implies(Atom(supposed), goal)
        named = claim.proof.every_n if form is claim.right else None
        if named is None and not _is_total(form.parsed, claim.notation):
            return seen  # each member of a formula with divisions would be judged again
        proven = Proven(Kernel()) if named is None else self._theorems[named]
        shown = self._shown(claim, goal, proven)
        if shown.outcome is not Outcome.PROVED:
            return seen if named is None else shown
        return replace(shown, read_back=seen.read_back, evidence=(*seen.evidence, *shown.evidence))


def _least(orders: Orders) -> dict[str, int] | None:
    """Returns the least value of each integer; None if one has a last value or depends on another."""
    stated = {each.variable: each for each in orders.stated}
    if any(each.generic or each.upper is not None or not each.lower.is_number for each in stated.values()):
        return None
    return {n: int(stated[n].lower) if n in stated else of_n[0] for n, of_n in orders.ranges.items()}


def _is_equations(statement: Statement) -> bool:
    try:
        return all(one.operator == "=" for one in equations(statement))
    except GoalError:
        return False


def _is_total(statement: Statement, notation: Notation) -> bool:
    sides = (side for one in equations(statement) for side in (one.left, one.right))
    return all(is_defined_everywhere(side, notation.definitions) for side in sides)
