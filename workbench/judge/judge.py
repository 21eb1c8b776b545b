"""From a statement to its verdict.

One relation goes through: inventory → a random point modulo a prime → the exact ring → the second engine
→ Drake's motions; or, where a residual is not zero, to a small rational counterexample. Numbers can veto a
proof and never make one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from random import Random
from typing import Protocol

from workbench.algebra.differential_ring import Polynomial
from workbench.judge.assumptions import Assumptions, Unsatisfiable
from workbench.judge.exact import ExactEngine
from workbench.judge.families import SAME_TERM, judge_family
from workbench.judge.inventory import Inventory, Lookup, NotExact, take_inventory
from workbench.judge.jets import JetEngine
from workbench.judge.parameters import Parameter
from workbench.judge.points import Trial, counterexample, first_trial
from workbench.judge.rings import PRIME, PointSource, ResidueRing, sample
from workbench.judge.vanishing import Equations, same_zeros, solve, unimplied
from workbench.judge.verdict import Counterexample, EngineDisagreement, Evidence, Outcome, Verdict
from workbench.language.printer import to_latex
from workbench.language.terms import (
    Conjunction,
    Equivalence,
    Implication,
    Relation,
    Statement,
    Symbol,
)


class OrderRanges(Protocol):
    """The values of a family's integer variables, such as `papers.Orders`."""

    def assignments(self): ...


@dataclass(frozen=True)
class Judge:
    """Judges statements under one set of definitions.

    motion: what symbols are on Drake's reference motions (declared name → binding).
    second_engine, motions: whether proofs are rechecked by SymPy and on Drake's motions; without the second
    engine no outcome is `proved`, since one engine alone proves nothing here: it is `probable`.
    """

    definitions: Lookup
    motion: Mapping[Symbol, str] | None = None
    second_engine: bool = True
    motions: bool = True

    def judge(
        self,
        statement: Statement,
        assume: Sequence[Statement] = (),
        hypothesis: Statement | None = None,
        orders: OrderRanges | None = None,
    ) -> Verdict:
        """The verdict on a statement under the stated assumptions.

        hypothesis: a condition that the text does not state; the outcome is `conditional` if the statement
        needs it. orders: the integer variables of a family.
        Raises Unsatisfiable if nothing satisfies the assumptions, EngineDisagreement if the engines differ.
        """
        judged = judge_family(self, statement, tuple(assume), hypothesis, orders)
        return replace(judged, read_back=to_latex(statement))

    def judge_instance(
        self, statement: Statement, assume: tuple[Statement, ...], hypothesis: Statement | None
    ) -> Verdict:
        """The verdict where no integer variable is left to bind. Raises NotExact outside the exact world."""
        verdict = self._judge(statement, assume)
        if hypothesis is None or verdict.outcome in (Outcome.PROVED, Outcome.DEFINITION):
            return verdict
        under = self._judge(statement, (*assume, hypothesis))
        if under.outcome != Outcome.PROVED:
            return under if under.outcome == Outcome.REFUTED else replace(under, reason=under.reason)
        witness = Evidence("witness against the bare statement", verdict.reason or "a point where it fails")
        return Verdict(
            Outcome.CONDITIONAL,
            reason="holds under a hypothesis that the text does not state",
            hypothesis=to_latex(hypothesis),
            counterexample=verdict.counterexample,
            evidence=(*under.evidence, witness),
        )

    def _judge(self, statement: Statement, assume: tuple[Statement, ...]) -> Verdict:
        match statement:
            case Conjunction(parts=parts):
                return _together([self._judge(part, assume) for part in parts])
            case Relation(operator="="):
                return _RelationJudge(self, statement, assume).verdict()
            case Relation():
                return self._judge_inequation(statement, assume)
            case Equivalence(left=Relation() as left, right=Relation() as right):
                return self._judge_zeros(left, right, assume, both_ways=True)
            case Implication(left=left, right=Relation(operator="=") as right):
                return self._judge(right, (*assume, left))
            case Implication(left=Relation() as left, right=Relation() as right):
                return self._judge_zeros(left, right, assume, both_ways=False)
        raise NotExact("a statement of this form")

    def _judge_inequation(self, relation: Relation, assume: tuple[Statement, ...]) -> Verdict:
        """p ≠ 0 is proved only for a non-zero constant, and refuted by a zero."""
        case = _Case(self, [relation], assume)
        trial = case.find(lambda t: t.differences(relation) is not None and not t.holds(relation))
        if trial is not None:
            return _refuted(trial, relation, case.inventory)
        residuals = case.exact.residuals(replace(relation, operator="="))
        if any(p.is_constant() and p != 0 for p in residuals):
            return Verdict(Outcome.PROVED, evidence=(Evidence("exact ring", "a non-zero constant"),))
        return Verdict(Outcome.UNCHECKED, reason="no zero was found and none was excluded")

    def _judge_zeros(
        self, left: Relation, right: Relation, assume: tuple[Statement, ...], both_ways: bool
    ) -> Verdict:
        """left ⇔ right (or ⇒) between `… = …` or `… ≠ …`: a comparison of real zero sets."""
        if left.operator != right.operator:
            return Verdict(Outcome.UNCHECKED, reason="an equivalence between an equation and an inequation")
        case = _Case(self, [left, right], assume)
        verdict = same_zeros(case, left, right, both_ways, self.second_engine)
        if verdict.outcome != Outcome.UNCHECKED:
            return verdict

        def disagrees(trial: Trial) -> bool:
            if trial.differences(left) is None or trial.differences(right) is None:
                return False
            holds_left, holds_right = trial.holds(left), trial.holds(right)
            return (holds_left and not holds_right) or (both_ways and holds_right and not holds_left)

        trial = case.find(disagrees)
        if trial is None:
            return verdict
        return _refuted(trial, right if trial.holds(left) else left, case.inventory)


class _NoDefinitions:
    """Every symbol is free. What holds for any tensor at the place of Φ₄ holds for Φ₄."""

    def lookup(self, symbol: Symbol) -> None:
        return None


class _Case:
    """The engines over the inventory of some relations and their assumptions."""

    def __init__(
        self,
        judge: Judge,
        relations: Sequence[Relation],
        assume: tuple[Statement, ...],
        definitions: Lookup | None = None,
    ) -> None:
        self.judge = judge
        self.definitions = judge.definitions if definitions is None else definitions
        self.assumptions = Assumptions(assume)
        sides = [side for r in (*relations, *self.assumptions.relations) for side in (r.left, r.right)]
        self.inventory: Inventory = take_inventory(sides, self.definitions)

    @cached_property
    def exact(self) -> ExactEngine:
        return ExactEngine(self.inventory, self.definitions)

    def find(self, accept) -> Trial | None:
        """A small point that satisfies the assumptions and is accepted."""
        supposed = self.assumptions.relations
        return first_trial(
            self.inventory,
            self.definitions,
            lambda t: all(t.holds(r) for r in supposed) and accept(t),
            self._completed,
        )

    def _completed(self, point: dict[Parameter, Fraction]) -> dict[Parameter, Fraction]:
        """The point with the parameters that the equations are solved for put to what the others make them."""
        if not self.assumptions.equations:
            return point
        point = dict(point)
        for generator, value in reversed(self._equations.solved):
            point[self.exact.parameter_of(generator)] = self.exact.at(value, point)
        return point

    @cached_property
    def _equations(self) -> Equations:
        return solve(self.exact, self.assumptions.equations)


class _RelationJudge(_Case):
    """One equation, with the assumptions it stands under."""

    def __init__(
        self,
        judge: Judge,
        relation: Relation,
        assume: tuple[Statement, ...],
        definitions: Lookup | None = None,
    ) -> None:
        super().__init__(judge, [relation], assume, definitions)
        self.relation = relation
        self.assume = assume

    def verdict(self) -> Verdict:
        relation = self.relation
        if (
            isinstance(relation.left, Symbol)
            and self.judge.definitions.lookup(relation.left) == relation.right
        ):
            return self._definition()
        if relation.left == relation.right:
            return Verdict(Outcome.UNCHECKED, reason=SAME_TERM)
        if self.assumptions.relations and self.find(lambda trial: True) is None:
            raise Unsatisfiable("no values of the symbols satisfy the assumptions")
        return self._by_names_alone() or self._by_definitions()

    def _by_names_alone(self) -> Verdict | None:
        """The proof that needs no definition, if there is one: with all defined symbols left free."""
        try:
            bare = _RelationJudge(self.judge, self.relation, self.assume, _NoDefinitions())
            screened = bare._screen()
            if screened is False:
                return None
            residuals = bare.exact.residuals(self.relation)
            if not bare._vanishes(residuals) or unimplied(bare.exact, bare.assumptions.nonzero):
                return None
        except (NotExact, ZeroDivisionError):
            return None
        return bare._prove(residuals, screened, on_motions=self)

    def _by_definitions(self) -> Verdict:
        relation = self.relation
        screened = self._screen()
        try:
            residuals = self.exact.residuals(relation)
        except ZeroDivisionError:
            return Verdict(Outcome.UNCHECKED, reason="a denominator is identically zero")
        vanishes = self._vanishes(residuals)
        if screened is False and vanishes and not self.assumptions.equations:
            raise EngineDisagreement(f"zero in the exact ring, not modulo {PRIME}: {to_latex(relation)}")
        if not vanishes:
            return self._refute(residuals)
        return self._prove(residuals, screened)

    def _definition(self) -> Verdict:
        self.exact.value(self.relation.right)
        return Verdict(
            Outcome.DEFINITION, evidence=(Evidence("definitions", "well-formed, and the one in force"),)
        )

    def _screen(self) -> bool | None:
        """Zero at a random point modulo the prime; None where the screen does not apply."""
        if self.assumptions.equations:
            return None
        ring = ResidueRing()
        point = sample(self.inventory, ring, Random(2020), lambda _: True)
        engine = JetEngine(PointSource(ring, point), self.definitions)
        try:
            return not any(engine.differences(self.relation.left, self.relation.right))
        except (NotExact, ZeroDivisionError):
            return None

    def _vanishes(self, residuals: list[Polynomial]) -> bool:
        if self.assumptions.equations:
            return all(self._equations.imply(p) for p in residuals)
        return all(p == 0 for p in residuals)

    def _prove(
        self, residuals: list[Polynomial], screened: bool | None, on_motions: _RelationJudge | None = None
    ) -> Verdict:
        case = on_motions or self
        figures = {"components": len(residuals), "indeterminates": len(self.exact.ring.names)}
        evidence = [Evidence("exact ring over ℚ (FLINT)", "residual is 0", figures)]
        if screened:
            evidence.insert(0, Evidence(f"random point modulo {PRIME}", "residual is 0"))
        gaps = unimplied(self.exact, self.assumptions.nonzero)
        if gaps:
            return self._conditional(gaps, evidence)
        if not self.judge.second_engine:
            return Verdict(Outcome.PROBABLE, reason="second engine left out", evidence=tuple(evidence))
        evidence += self._recheck()
        if self.judge.motions and self.judge.motion and not self.assumptions.equations:
            from workbench.judge.motion_check import VETO, check_on_motions

            checked = check_on_motions(case.relation, case.inventory, case.definitions, self.judge.motion)
            if checked is not None:
                evidence.append(checked)
                if checked.outcome == VETO:
                    reason = "proved, but Drake's motions contradict it: a binding or the workbench is wrong"
                    return Verdict(Outcome.UNCHECKED, reason=reason, evidence=tuple(evidence))
        return Verdict(Outcome.PROVED, evidence=tuple(evidence))

    def _recheck(self) -> list[Evidence]:
        from workbench.judge.drake_ring import recheck_by_drake
        from workbench.judge.sympy_ring import recheck

        equations = self.assumptions.equations
        if not recheck(self.relation, self.inventory, self.definitions, equations):
            raise EngineDisagreement(f"zero in FLINT's ring, not in SymPy's: {to_latex(self.relation)}")
        evidence = [Evidence("SymPy PolyRing on Python integers, Leibniz jets", "residual is 0")]
        by_drake = None if equations else recheck_by_drake(self.relation, self.inventory, self.definitions)
        if by_drake is False:
            raise EngineDisagreement(f"zero in FLINT's ring, not in Drake's: {to_latex(self.relation)}")
        if by_drake:
            evidence.append(Evidence("Drake symbolic Polynomial, Leibniz jets", "residual is 0"))
        return evidence

    def _conditional(self, gaps: list[Polynomial], evidence: list[Evidence]) -> Verdict:
        relation = self.relation
        trial = self.find(lambda t: t.differences(relation) is None)
        return Verdict(
            Outcome.CONDITIONAL,
            reason="a denominator can vanish, and nothing that the claim assumes excludes it",
            counterexample=None if trial is None else counterexample(trial, relation, self.inventory),
            evidence=(
                *evidence,
                Evidence("denominators", "not excluded by the assumptions", {"count": len(gaps)}),
            ),
        )

    def _refute(self, residuals: list[Polynomial]) -> Verdict:
        relation = self.relation

        def fails(trial: Trial) -> bool:
            differences = trial.differences(relation)
            return differences is not None and any(differences)

        trial = self.find(fails)
        if trial is None:
            return Verdict(
                Outcome.UNCHECKED,
                reason="the residual is not 0 in the exact ring, but no small counterexample was found",
            )
        self._confirm(trial, residuals)
        return _refuted(trial, relation, self.inventory)

    def _confirm(self, trial: Trial, residuals: list[Polynomial]) -> None:
        """The first engine must see the counterexample too; norms have no value there as polynomials."""
        if self.inventory.norms or self.assumptions.equations:
            return
        if not any(self.exact.at(p, trial.point) for p in residuals):
            raise EngineDisagreement(f"a counterexample of one engine only: {to_latex(self.relation)}")


def _refuted(trial: Trial, relation: Relation, inventory: Inventory) -> Verdict:
    example: Counterexample = counterexample(trial, relation, inventory)
    evidence = Evidence("rational point, exact arithmetic", "the two sides differ")
    return Verdict(Outcome.REFUTED, counterexample=example, evidence=(evidence,))


def _together(verdicts: list[Verdict]) -> Verdict:
    """A conjunction is as good as its worst part."""
    worst = (Outcome.REFUTED, Outcome.UNCHECKED, Outcome.PROBABLE, Outcome.CONDITIONAL, Outcome.PROVED)
    for outcome in worst:
        for verdict in verdicts:
            if verdict.outcome == outcome:
                evidence = tuple(e for v in verdicts for e in v.evidence)
                return replace(verdict, evidence=evidence if outcome == Outcome.PROVED else verdict.evidence)
    return verdicts[0]
