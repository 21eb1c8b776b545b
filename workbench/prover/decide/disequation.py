"""Decides one disequation (≠)."""

from __future__ import annotations

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.terms import Relation, Statement
from workbench.core.verdict import EngineDisagreement, Evidence, Outcome, Verdict
from workbench.prover.decide.case import Case, Setting
from workbench.prover.decide.denominators import denominators_named
from workbench.prover.decide.inference import agreement


def judge_inequation(setting: Setting, relation: Relation, assume: tuple[Statement, ...]) -> Verdict:
    """Returns the verdict on p ≠ 0: proved only for a non-zero constant, refuted by a zero."""
    case = Case(setting, [relation], assume)
    trial = case.find(lambda t: t.differences(relation) is not None and not t.holds(relation))
    if trial is not None:
        return case.refuted(trial, relation)
    residuals = case.exact.residuals(relation)
    if not any(p.is_constant() and p for p in residuals):
        return Verdict(Outcome.UNCHECKED, reason=VerdictCode.NO_ZERO_FOUND())
    if gaps := case.solved.gaps():
        denominator = denominators_named(case.exact, case.sides, case.definitions, gaps)
        reason = VerdictCode.DENOMINATOR_CAN_VANISH(denominator=denominator)
        return Verdict(Outcome.UNCHECKED, reason=reason)
    evidence = [Evidence("exact ring over ℚ (FLINT)", "the sides differ by a number that is not 0")]
    if not setting.second_engine:
        return Verdict(
            Outcome.PROBABLE, reason=VerdictCode.SECOND_ENGINE_LEFT_OUT(), evidence=tuple(evidence)
        )
    from workbench.engines.jet.consequences import recheck_distance
    from workbench.engines.jet.sympy_ring import METHOD

    if not recheck_distance(relation, case.second):
        raise EngineDisagreement("FLINT and SymPy differ on an inequation")
    evidence.append(Evidence(METHOD, "the sides differ by a number that is not 0"))
    return agreement(evidence[0], evidence[1], evidence)
