"""The verdict on a claim with a goal or a theorem: by its proof, or by an argument with checked steps."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache

from workbench.judge.kernel.judge import Judge
from workbench.judge.theorems.goals import Scope
from workbench.judge.theorems.proofs import False_, Kernel, Proven
from workbench.judge.theorems.prove import Lemmas, prove
from workbench.judge.verdict import Outcome, Verdict
from workbench.papers.model import Claim, Notation, Theorem


class TheoremJudge:
    """judge_of: the judge of formulas in a notation."""

    def __init__(self, theorems: Mapping[str, Theorem], judge_of: Callable[[Notation], Judge]) -> None:
        self._theorems, self._judge_of = theorems, judge_of
        self._argued = cache(lambda name: theorems[name]())  # several claims can rest on one
        self._lemmas: dict[int, Lemmas] = {}  # by notation

    def verdict(self, claim: Claim) -> Verdict:
        return self._argument(claim) if claim.goal is None else self._proof(claim)

    def _proof(self, claim: Claim) -> Verdict:
        """On the goal, by its proof; without one, by the judge of formulas alone."""
        proven = Proven(None, False_()) if claim.corrected is not None else Proven(Kernel())
        if claim.theorem is not None:
            proven = self._theorems[claim.theorem]
            if not isinstance(proven, Proven):
                return Verdict(
                    Outcome.UNCHECKED, reason=f"{claim.theorem} is an argument, and no proof of a goal"
                )
        notation = claim.notation
        return prove(
            claim.goal.goal,
            Scope(notation.symbols, notation.definitions, {}),
            self._judge_of(notation),
            proven,
            assume=claim.supposed,
            bare=claim.goal.bare if claim.hypothesis is not None else None,
            lemmas=self._lemmas.setdefault(id(notation), {}),
        )

    def _argument(self, claim: Claim) -> Verdict:
        """What the steps of an argument support: they are checked, and what joins them is prose."""
        name = claim.theorem
        if isinstance(self._theorems[name], Proven):
            return Verdict(Outcome.UNCHECKED, reason=f"{name} proves a goal, and the claim has none")
        verdict = self._argued(name)
        if verdict.outcome == Outcome.UNCHECKED:
            return verdict
        return replace(verdict, outcome=Outcome.ARGUED, scope=None, reason=claim.argued)
