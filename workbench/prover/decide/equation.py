"""Decides one equation.

Inventory → a random point modulo a prime → the polynomial engine → the jet engine; or, if the residual is not
zero, a small rational counterexample.
"""

from __future__ import annotations

from workbench.algebra.differential_ring import Polynomial
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.terms import Relation, Statement, Symbol
from workbench.core.verdict import EngineDisagreement, Evidence, Outcome, Strength, Verdict
from workbench.engines.inventory import Lookup, NoDefinitions, NotExact
from workbench.engines.inventory.inventory import has_gradient
from workbench.engines.jet.rings import PRIME
from workbench.language.definitions import Definitions, is_definition
from workbench.language.printing.printer import to_latex
from workbench.prover.counterexamples.rational_points import Trial
from workbench.prover.counterexamples.real_angles import surely_differ
from workbench.prover.decide.bounded_denominators import not_bounded_away
from workbench.prover.decide.case import Case, Setting
from workbench.prover.decide.denominators import denominators_named
from workbench.prover.decide.frame_change import in_rotated_frame
from workbench.prover.decide.inference import agreement
from workbench.prover.decide.law_statements import law_for

_NONE = NoDefinitions()
BY_DEFINITION = Verdict(
    Outcome.DEFINITION, evidence=(Evidence("definitions", "well-formed, and the one in force"),)
)


class Equation(Case):
    """One equation with its assumptions."""

    def __init__(
        self,
        setting: Setting,
        relation: Relation,
        assume: tuple[Statement, ...],
        definitions: Lookup | None = None,
    ) -> None:
        super().__init__(setting, [relation], assume, definitions)
        self.relation = relation
        self.assume = assume

    def verdict(self) -> Verdict:
        relation = self.relation
        if is_definition(relation, self.setting.definitions):
            return self._definition()
        if relation.left == relation.right:
            return Verdict(Outcome.UNCHECKED, reason=VerdictCode.SAME_TERM())
        self.require_satisfiable()
        return self._in_rotated_frame() or self._by_names_alone() or self._by_definitions()

    def _in_rotated_frame(self) -> Verdict | None:
        """Returns the proof of an expensive relation by an equivalent cheaper one, or None.

        The relation itself must be zero at a random point, which checks the rewriting.
        """
        cheaper = in_rotated_frame(self.relation, self.definitions)
        if cheaper is None or self.assumptions.equations or not self.screen():
            return None
        rotated = Equation(self.setting, cheaper, self.assume, self.definitions)
        residuals = rotated.exact.residuals(cheaper)
        if not rotated._vanishes(residuals):
            return None
        rewriting = Evidence("rotated frame", "holds where this does", {"relation": to_latex(cheaper)})
        return rotated._prove(residuals, True, case=self, before=(rewriting,))

    def _by_names_alone(self) -> Verdict | None:
        """Returns the proof that needs no definitions, with all defined symbols free, or None.

        A free symbol does not depend on the coordinate, so div and curl need the definitions.
        """
        if has_gradient(self.sides):
            return None
        try:
            bare = Equation(self.setting, self.relation, self.assume, _NONE)
            screened = bare._at_random_point()
            if screened is False:
                return None
            residuals = bare.exact.residuals(self.relation)
            if not bare._vanishes(residuals) or bare.solved.gaps() or bare.solved.limits():
                return None
        except (NotExact, ZeroDivisionError):
            return None
        return bare._prove(residuals, screened, case=self)

    def _by_definitions(self) -> Verdict:
        relation = self.relation
        screened = self.screen()
        residuals = self.exact.residuals(relation)
        vanishes = self._vanishes(residuals)
        if screened is False and vanishes and not self.assumptions.equations:
            raise EngineDisagreement(f"zero in the exact ring, not modulo {PRIME}: {to_latex(relation)}")
        if not vanishes:
            return self._refute(residuals)
        return self._prove(residuals, screened)

    def _definition(self) -> Verdict:
        self.exact.value(self.relation.right)
        return BY_DEFINITION

    def screen(self) -> bool | None:
        """Returns whether the residual is zero at a random point modulo the prime, by the jet engine; None if
        it does not apply."""
        return self._at_random_point() if self.setting.second_engine else None

    def _at_random_point(self) -> bool | None:
        if self.assumptions.equations:
            return None
        engine = self.setting.engines.residues(self.inventory, self.definitions)
        try:
            return not any(engine.differences(self.relation.left, self.relation.right))
        except (NotExact, ZeroDivisionError):
            return None

    def _vanishes(self, residuals: list[Polynomial]) -> bool:
        if self.assumptions.equations:
            return self.solved.imply(residuals)
        return not any(residuals)

    def _prove(
        self,
        residuals: list[Polynomial],
        screened: bool | None,
        case: Equation | None = None,
        before: tuple[Evidence, ...] = (),
    ) -> Verdict:
        case = case or self
        figures = {"components": len(residuals), "indeterminates": len(self.exact.ring.names)}
        exact = Evidence("exact ring over ℚ (FLINT)", "residual is 0", figures)
        evidence = [*before, exact]
        if not self.setting.second_engine:
            return Verdict(
                Outcome.PROBABLE, reason=VerdictCode.SECOND_ENGINE_LEFT_OUT(), evidence=tuple(evidence)
            )
        if screened:
            evidence.insert(0, Evidence(f"random point modulo {PRIME}", "residual is 0"))
        rechecked = self._recheck()
        if rechecked is None:
            reason = VerdictCode.SECOND_ENGINE_OPEN()
            return Verdict(Outcome.UNCHECKED, reason=reason, evidence=tuple(evidence))
        evidence += rechecked
        gaps = not_bounded_away(self.exact, self.sides, self.definitions, self.solved.gaps())
        if gaps:
            return case._conditional(gaps, evidence)
        if self.solved.limits():
            reason = VerdictCode.LIMITS()
            return Verdict(Outcome.UNCHECKED, reason=reason, evidence=tuple(evidence))
        return agreement(exact, rechecked[0], evidence)

    def _recheck(self) -> list[Evidence] | None:
        """Returns the evidence of the jet engine, or None if it cannot derive the relation from the
        equations.

        None is no contradiction: each engine divides by the equations in its own order.
        """
        from workbench.engines.jet.consequences import recheck
        from workbench.engines.jet.drake_ring import recheck_by_drake
        from workbench.engines.jet.sympy_ring import METHOD

        equations = self.assumptions.equations
        if not recheck(self.relation, self.second, self.assumptions):
            if equations:
                return None
            raise EngineDisagreement(f"zero in FLINT's ring, not in SymPy's: {to_latex(self.relation)}")
        evidence = [Evidence(f"{METHOD}, Leibniz jets", "residual is 0")]
        by_drake = None if equations else recheck_by_drake(self.relation, self.inventory, self.definitions)
        if by_drake is False:
            raise EngineDisagreement(f"zero in FLINT's ring, not in Drake's: {to_latex(self.relation)}")
        if by_drake:
            evidence.append(Evidence("Drake symbolic Polynomial, Leibniz jets", "residual is 0"))
        return evidence

    def _conditional(self, gaps: list[Polynomial], evidence: list[Evidence]) -> Verdict:
        relation = self.relation
        trial = self.find(lambda t: t.differences(relation) is None)
        gap = Evidence("denominators", "not excluded by the assumptions", {"factors": len(gaps)})
        denominator = denominators_named(self.exact, self.sides, self.definitions, gaps)
        if trial is None:
            reason = VerdictCode.DENOMINATOR_OPEN(denominator=denominator)
            return Verdict(Outcome.UNCHECKED, reason=reason, evidence=(*evidence, gap))
        if self.assumptions.equations and self.find(lambda t: t.holds(relation)) is None:
            reason = VerdictCode.NO_POINT_FOUND()
            return Verdict(Outcome.UNCHECKED, reason=reason, evidence=(*evidence, gap))
        return Verdict(
            Outcome.CONDITIONAL,
            reason=VerdictCode.DENOMINATOR_NOT_EXCLUDED(denominator=denominator),
            counterexample=self.counterexample(trial, relation),
            evidence=(*evidence, gap),
            basis=Strength.HINTED,
        )

    def _refute(self, residuals: list[Polynomial]) -> Verdict:
        relation = self.relation
        tied = self.assumptions.equations or any(
            s.declaration.name in self.setting.bound or self._is_of_a_recurrence(s)
            for s in self.inventory.orders
        )
        may_be_law = self.setting.laws and not tied
        law = law_for(relation, self.inventory, self.definitions) if may_be_law else None
        if law is not None:
            name = to_latex(law)
            reason = VerdictCode.STATES_A_LAW(name=name)
            return Verdict(Outcome.UNCHECKED, reason=reason)

        def fails(trial: Trial) -> bool:
            differences = trial.differences(relation)
            return differences is not None and any(differences)

        def differs(trial: Trial) -> bool:
            return surely_differ(trial, relation)

        trial = self.find_real(differs) if self.has_pi else None
        trial = trial or self.find(fails) or self.find_real(differs)
        if trial is None:
            return Verdict(
                Outcome.UNCHECKED,
                reason=VerdictCode.NO_COUNTEREXAMPLE(),
            )
        self._confirm(trial, residuals)
        return self.refuted(trial, relation)

    def _is_of_a_recurrence(self, symbol: Symbol) -> bool:
        """True if other members of the symbol's family, or definitions, may determine it."""
        is_member = all(place.is_number for place in symbol.index)
        return bool(symbol.declaration.indices) and not (
            is_member and isinstance(self.definitions, Definitions) and not self.definitions.about(symbol)
        )

    def _confirm(self, trial: Trial, residuals: list[Polynomial]) -> None:
        """Raises EngineDisagreement unless the polynomial engine confirms a rational counterexample."""
        if trial.real or self.assumptions.equations:
            return
        if not any(self.exact.at(p, trial.point) for p in residuals):
            raise EngineDisagreement(f"a counterexample of one engine only: {to_latex(self.relation)}")
