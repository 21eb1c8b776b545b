"""Equivalences and implications between `… = 0` or `… ≠ 0`: comparisons of real zero sets."""

from __future__ import annotations

from collections.abc import Callable

from workbench.algebra.differential_ring import Polynomial
from workbench.judge.evidence.points import Trial
from workbench.judge.kernel.case import Case, Setting
from workbench.judge.kernel.vanishing import unimplied
from workbench.judge.verdict import EngineDisagreement, Evidence, Outcome, Verdict
from workbench.language.terms import Relation, Statement


def judge_inequation(setting: Setting, relation: Relation, assume: tuple[Statement, ...]) -> Verdict:
    """p ≠ 0 is proved only for a non-zero constant, and refuted by a zero."""
    case = Case(setting, [relation], assume)
    trial = case.find(lambda t: t.differences(relation) is not None and not t.holds(relation))
    if trial is not None:
        return case.refuted(trial, relation)
    residuals = case.exact.residuals(relation)
    if not any(p.is_constant() and p != 0 for p in residuals):
        return Verdict(Outcome.UNCHECKED, reason="no zero was found and none was excluded")
    if unimplied(case.exact, case.assumptions.nonzero):
        return Verdict(Outcome.UNCHECKED, reason="a denominator can vanish")
    evidence = [Evidence("exact ring over ℚ (FLINT)", "the sides differ by a number that is not 0")]
    if not setting.second_engine:
        return Verdict(Outcome.PROBABLE, reason="second engine left out", evidence=tuple(evidence))
    from workbench.judge.second.sympy_ring import METHOD, recheck_distance

    if not recheck_distance(relation, case.inventory, case.definitions):
        raise EngineDisagreement("FLINT and SymPy differ on an inequation")
    evidence.append(Evidence(METHOD, "the sides differ by a number that is not 0"))
    return Verdict(Outcome.PROVED, evidence=tuple(evidence))


def judge_zeros(
    setting: Setting, left: Relation, right: Relation, assume: tuple[Statement, ...], both_ways: bool
) -> Verdict:
    """left ⇔ right, or left ⇒ right, both equations or both inequations."""
    if left.operator != right.operator:
        return Verdict(Outcome.UNCHECKED, reason="an equivalence between an equation and an inequation")
    case = Case(setting, [left, right], assume)
    case.require_satisfiable()
    if not both_ways and case.find(lambda t: t.holds(left)) is None:
        return Verdict(Outcome.UNCHECKED, reason="no point was found where the premise holds")
    verdict = _same_zeros(case, left, right, both_ways, setting.second_engine)
    if verdict.outcome != Outcome.UNCHECKED:
        return verdict

    def disagrees(trial: Trial) -> bool:
        if trial.differences(left) is None or trial.differences(right) is None:
            return False
        holds_left, holds_right = trial.holds(left), trial.holds(right)
        return (holds_left and not holds_right) or (both_ways and holds_right and not holds_left)

    trial = case.find(disagrees) or _find_on_zeros(case, (left, right), disagrees)
    if trial is None:
        return verdict
    return case.refuted(trial, right if trial.holds(left) else left)


def _find_on_zeros(
    case: Case, sides: tuple[Relation, Relation], disagrees: Callable[[Trial], bool]
) -> Trial | None:
    """A point where one side vanishes and the other does not, among the zeros of either side on lines."""
    for relation in sides:
        p = _scalar(case, relation)
        if p != 0:
            trial = case.find_on(p, disagrees)
            if trial is not None:
                return trial
    return None


def _same_zeros(case: Case, left: Relation, right: Relation, both_ways: bool, second_engine: bool) -> Verdict:
    """left ≠ 0 ⇔ right ≠ 0 (or ⇒), proved by factors; 0 vanishes everywhere.

    A vector x vanishes exactly where x·x does. If every irreducible factor of the one scalar divides the
    other, the other vanishes wherever the one does. The second engine checks the division that says so.
    """
    p, q = (_scalar(case, relation) for relation in (left, right))
    if unimplied(case.exact, case.assumptions.nonzero) or case.assumptions.equations:
        return Verdict(Outcome.UNCHECKED, reason="an equivalence with denominators, or under an equation")
    needed = [(q, p)] if left.operator == "≠" else [(p, q)]
    if both_ways:
        needed = [(p, q), (q, p)]
    for of, divides in needed:
        if divides != 0 and (of == 0 or any(divmod(divides, f)[1] != 0 for f, _ in of.factor()[1])):
            reason = "the factors of the two sides differ, and no point tells them apart"
            return Verdict(Outcome.UNCHECKED, reason=reason)
    evidence = [Evidence("exact ring over ℚ (FLINT)", "the two sides have the same irreducible factors")]
    if not second_engine:
        return Verdict(Outcome.PROBABLE, reason="second engine left out", evidence=tuple(evidence))
    from workbench.judge.second.sympy_ring import METHOD, recheck_division

    if not recheck_division(left, right, both_ways, case.inventory, case.definitions):
        raise EngineDisagreement("FLINT and SymPy differ on the factors of an equivalence")
    evidence.append(Evidence(METHOD, "each side divides a power of the other"))
    return Verdict(Outcome.PROVED, evidence=tuple(evidence))


def _scalar(case: Case, relation: Relation) -> Polynomial:
    residuals = case.exact.residuals(relation)
    if len(residuals) == 1:
        return residuals[0]
    return case.exact.ring.reduce(sum((p * p for p in residuals), case.exact.ring.zero))
