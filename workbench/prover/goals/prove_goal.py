"""Verdicts on goals: judges the obligations of the proof, or finds a counterexample."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import TypeAlias, cast

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import relation
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.integer_instances import free_integers, instantiate
from workbench.core.terms import IllFormed, Relation, Statement
from workbench.core.verdict import Evidence, Outcome, Verdict
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.assumptions import Unsatisfiable
from workbench.language.definitions import Definitions
from workbench.language.goals.goals import (
    All,
    AllFrom,
    Atom,
    Both,
    Exists,
    Goal,
    GoalError,
    Iff,
    Implies,
    Scope,
    Variable,
)
from workbench.language.goals.proofs import (
    Against,
    At,
    Broken,
    ExistsIntroduction,
    False_,
    Impossible,
    Kernel,
    Part,
    Proof,
    Proven,
    TwoWitnesses,
)
from workbench.language.printing.printer import to_latex
from workbench.prover.decide.decide import Judge
from workbench.prover.decide.elementary_equations import domain_of
from workbench.prover.decide.equation import Equation
from workbench.prover.decide.families.families import InstanceJudge
from workbench.prover.decide.families.orders_past_literals import FIRST, FirstMembers
from workbench.prover.decide.inference import conclusion, equal_terms, generalization
from workbench.prover.goals.definedness import is_defined_everywhere, taken_by_maps, that_is_defined
from workbench.prover.goals.named_members import read_members
from workbench.prover.goals.proof_rules import obligations
from workbench.prover.goals.sequents import (
    FORMULA,
    NotShown,
    Obligation,
    Premise,
    Sequent,
    relations_of,
    supposed,
)
from workbench.prover.goals.simplified_equations import Form, forms
from workbench.prover.goals.substitution import Substitution, at_integer

#: Verdicts of one judge on equations, by statement, hypotheses, and integers with their least values.
Lemmas: TypeAlias = "dict[tuple[Statement, tuple[Statement, ...], tuple[tuple[str, int], ...]], Verdict]"

_SHOWN = (Outcome.PROVED, Outcome.DEFINITION)


def prove(
    goal: Goal,
    scope: Scope,
    judge: Judge,
    proven: Proven,
    assume: Sequence[Statement] = (),
    bare: Goal | None = None,
    lemmas: Lemmas | None = None,
) -> Verdict:
    """Returns `proved` or `refuted`; or `unchecked` with the rule and the reason if the proof does not show
    the goal.

    bare: the goal without a hypothesis that the text does not state; if that is refuted, the verdict is
    `conditional`. lemmas: obligations of other proofs for the same judge; this one adds to them.
    """
    given = tuple(Premise(Atom(statement), False) for statement in assume)
    prover = _Prover(judge, {} if lemmas is None else lemmas)
    try:
        if proven.proof is None:
            if proven.against is None:
                raise NotShown("expected a proof or what stands against the goal")
            return prover.refute(Sequent(goal, scope, given), proven.against)
        shown = prover.show(Sequent(goal, scope, given), proven.proof)
        if bare is None or shown.outcome != Outcome.PROVED:
            return shown
        if proven.against is None:
            raise NotShown("expected what stands against the goal without the hypothesis")
        without = prover.refute(Sequent(bare, scope, given), proven.against)
    except (NotShown, GoalError, ReadError, IllFormedAt, IllFormed) as error:
        return Verdict(Outcome.UNCHECKED, reason=VerdictCode.GOAL_NOT_SHOWN(why=error))
    if without.outcome != Outcome.REFUTED:
        return replace(without, outcome=Outcome.UNCHECKED)
    return Verdict(
        Outcome.CONDITIONAL,
        scope=shown.scope,
        reason=VerdictCode.UNDER_HYPOTHESIS(),
        counterexample=without.counterexample,
        evidence=(*shown.evidence, *without.evidence),
    )


#: No engine has a normal form for members to a symbolic n: the terms themselves are compared.
SAME_ADDENDS = Evidence("operators applied, sums shifted and split", "both sides have the same addends")


@dataclass(frozen=True)
class _Prover:
    judge: Judge
    lemmas: Lemmas

    @property
    def definitions(self) -> Definitions:
        """The definitions of the paper; premises add none."""
        return cast(Definitions, self.judge.definitions)

    def holds(self, sequent: Sequent, proof: Proof) -> Verdict:
        """Returns `proved` or `unchecked`, as `show` does, for a part of another verdict. Both sides may be
        one term."""
        verdict = self.show(sequent, proof, part=True)
        return verdict if verdict.outcome == Outcome.PROVED else replace(verdict, outcome=Outcome.UNCHECKED)

    def show(self, sequent: Sequent, proof: Proof, part: bool = False) -> Verdict:
        found: list[Evidence] = []
        premises: list[Verdict] = []
        for obligation in list(obligations(sequent, proof)):
            if (undefined := self._undefined(obligation)) is not None:
                return _not_shown(obligation, undefined)
            if obligation.is_trivial:
                if part or obligation.rule != FORMULA:
                    found.append(Evidence(f"goal, {obligation.rule}", "both sides are the same term"))
                continue
            verdict = self._judge(obligation)
            if verdict.outcome not in _SHOWN:
                refuted = verdict.outcome == Outcome.REFUTED and proof == Kernel()
                if refuted and _only_for_all(sequent.goal):
                    return verdict
                return _not_shown(obligation, verdict)
            premises.append(verdict)
            found.append(_evidence(obligation, verdict))
        if not found:
            return Verdict(Outcome.UNCHECKED, reason=VerdictCode.SAME_TERM())
        return conclusion(type(proof).__name__, premises, found, _scope_of(sequent.goal))

    def _undefined(self, obligation: Obligation) -> Verdict | None:
        """Returns the verdict on a term that is not shown to be defined; None if all are.

        The judge of formulas does not evaluate the common term of both sides, nor the arguments of maps.
        """
        said, known = obligation.statement, self.definitions
        asked = list(taken_by_maps(said, known)) if isinstance(said, Relation) else []
        if (
            isinstance(said, Relation)
            and obligation.is_trivial
            and not is_defined_everywhere(said.left, known)
        ):
            asked.append(said.left)
        verdicts = (self._judge(replace(obligation, statement=that_is_defined(term))) for term in asked)
        return next((v for v in verdicts if v.outcome not in _SHOWN), None)

    def _judge(self, obligation: Obligation) -> Verdict:
        used = _integers(obligation)
        simpler = list(forms(obligation.statement, cast(InstanceJudge, self.judge), used)) if used else []
        try:
            same = any(form.is_same_sum and form.holds_from(used) for form in simpler)
            if same and self._first_hold(obligation, used):
                return equal_terms(SAME_ADDENDS)
            verdict = self._judged(obligation.statement, obligation, used)
            if verdict.outcome in (Outcome.REFUTED, Outcome.CONDITIONAL, *_SHOWN):
                return verdict
            simpler = simpler or list(forms(obligation.statement, cast(InstanceJudge, self.judge), used))
            soon = [form for form in simpler if form.holds_from(used)]
            if (shown := self._one_of(soon, obligation, used)) is not None:
                return shown
            late = [form for form in simpler if form not in soon and form.holds_from(used, FIRST)]
            if late:
                first = self.judge.judge(obligation.statement, obligation.assume, orders=FirstMembers(used))
                if first.outcome in _SHOWN and (shown := self._one_of(late, obligation, used)) is not None:
                    return replace(shown, evidence=(*first.evidence, *shown.evidence))
            return verdict
        except Unsatisfiable:
            reason = VerdictCode.CONTRADICTORY_PREMISES()
            return Verdict(Outcome.UNCHECKED, reason=reason)

    def _first_hold(self, obligation: Obligation, used: Mapping[str, int]) -> bool:
        """True if the first members, which may be missing on both sides, hold at a random point."""
        for more in (0, 2):
            values = {name: least + more for name, least in used.items()}
            said, *assume = (instantiate(s, values) for s in (obligation.statement, *obligation.assume))
            with suppress(NotExact):
                if isinstance(said, Relation) and Equation(self.judge, said, tuple(assume)).screen() is False:
                    return False
        return True

    def _judged(self, statement: Statement, obligation: Obligation, used: Mapping[str, int]) -> Verdict:
        asked = (statement, obligation.assume, tuple(used.items()))
        if asked not in self.lemmas:
            orders = FirstMembers(used, endless=frozenset(used)) if used else None
            verdict = self.judge.judge(statement, obligation.assume, orders=orders)
            if where := domain_of(verdict):
                reason = VerdictCode.NOT_DEFINED_FOR_ALL(left=to_latex(statement), reason=f"only {where}")
                verdict = replace(verdict, outcome=Outcome.UNCHECKED, reason=reason)
            self.lemmas[asked] = verdict
        return self.lemmas[asked]

    def _one_of(
        self, simpler: Sequence[Form], obligation: Obligation, used: Mapping[str, int]
    ) -> Verdict | None:
        """Returns the proof of a simpler form without operators and sums, or None.

        The integers before the form's first ones have been tested one by one.
        """
        same = obligation.rule != FORMULA and any(form.is_same_sum for form in simpler)
        if same and self._first_hold(obligation, used):
            return equal_terms(SAME_ADDENDS)
        for form in simpler:
            left = _integers(replace(obligation, statement=form.equation))
            left = {name: max(least, form.since.get(name, 0)) for name, least in left.items()}
            verdict = self._judged(form.equation, obligation, left)
            if verdict.outcome in _SHOWN:
                return generalization(verdict, "all", verdict.evidence) if used else verdict
        return None

    def refute(self, sequent: Sequent, against: Against) -> Verdict:
        goal = sequent.goal
        match goal, against:
            case ((All() | AllFrom()), At(values, then)):
                return self.refute(_at(sequent, dict(values)), then)
            case All(variables, body), _:
                inner = replace(sequent, goal=body, scope=sequent.scope.with_variables(variables))
                return self.refute(inner, against)
            case Both(parts), Part(place, then):
                return self.refute(sequent.of(parts[place]), then)
            case Iff(left, right), Part(place, then):
                return self.refute(
                    sequent.of(Implies(left, right) if place == 0 else Implies(right, left)), then
                )
            case Implies(premise, conclusion, lasting), Broken(then, shown):
                known = sequent.at_all_times() if lasting else sequent
                held = self.holds(known.of(premise), shown)
                if held.outcome != Outcome.PROVED:
                    return held
                return _with(self.refute(sequent.of(conclusion), then), held)
            case Implies(premise, conclusion, lasting=False), False_():
                return self.refute(sequent.given(premise, False).of(conclusion), against)
            case Exists(variables, body, True), TwoWitnesses():
                return self._two(sequent, variables, body, against)
            case Exists(variables, body), Impossible(then, so):
                absurd = Atom(sequent.scope.statement(so))
                none = self.holds(sequent.of(All(variables, Implies(body, absurd))), then)
                if none.outcome != Outcome.PROVED:
                    return none
                return _with(self.refute(sequent.of(absurd), False_()), none)
            case Atom(statement), False_():
                verdict = self._judge(_obligation(sequent, statement))
                if verdict.outcome != Outcome.REFUTED:
                    reason = VerdictCode.EXPECTED_TO_FAIL(
                        statement=to_latex(statement), outcome=verdict.outcome
                    )
                    return Verdict(Outcome.UNCHECKED, reason=reason)
                return verdict
        raise NotShown(f"{type(against).__name__} does not stand against {type(goal).__name__}")

    def _two(
        self, sequent: Sequent, variables: tuple[Variable, ...], body: Goal, against: TwoWitnesses
    ) -> Verdict:
        sought = Exists(variables, body, unique=False)
        shown = [
            self.holds(sequent.of(sought), ExistsIntroduction(members, proof))
            for members, proof in ((against.first, against.firstly), (against.second, against.secondly))
        ]
        for verdict in shown:
            if verdict.outcome != Outcome.PROVED:
                return verdict
        first, second = (
            read_members(sequent.scope, variables, members) for members in (against.first, against.second)
        )
        reasons = []
        for variable, one in first.items():
            verdict = self._judge(_obligation(sequent, relation("=", one, second[variable])))
            if verdict.outcome == Outcome.REFUTED:
                reason = VerdictCode.TWO_OF_THEM(one=to_latex(one), other=to_latex(second[variable]))
                verdict = replace(verdict, reason=reason, read_back=None)
                return _with(verdict, *shown)
            reasons.append(f"{variable.name}: {verdict.outcome}")
        raise NotShown(f"the two are not seen to differ ({'; '.join(reasons)})")


def _obligation(sequent: Sequent, statement: Statement) -> Obligation:
    """Returns the statement under all premises: a failure without one of them is not a counterexample."""
    every = tuple(range(len(sequent.premises)))
    return Obligation(FORMULA, statement, sequent.scope, tuple(supposed(sequent, every)))


def _with(verdict: Verdict, *others: Verdict) -> Verdict:
    return replace(verdict, evidence=(*(e for o in others for e in o.evidence), *verdict.evidence))


def _at(sequent: Sequent, values: dict[str, str]) -> Sequent:
    """Returns the goal at values of the letters that its leading ∀ bind; letters without a value stay."""
    goal, scope = sequent.goal, sequent.scope
    while values and isinstance(goal, All | AllFrom):
        if isinstance(goal, AllFrom):
            value = values.pop(goal.integer, None)
            if value is None:
                raise NotShown(f"no value is given for {goal.integer}")
            if not value.isdigit() or int(value) < goal.least:
                raise NotShown(f"{goal.integer} = {value} is not {goal.least} or more")
            goal = at_integer(goal.body, goal.integer, int(value))
            continue
        taken = {v: values.pop(str(v.letter), None) for v in goal.variables}
        given = {str(v.letter): value for v, value in taken.items() if value is not None}
        open_ = tuple(v for v, value in taken.items() if value is None)
        closed = tuple(v for v in goal.variables if v not in open_)
        terms = read_members(scope, closed, given)
        for variable in terms:
            if variable.declaration.rotation or variable.declaration.unit:
                raise NotShown(f"{variable.name}: a rotation or a unit vector is not put in as a value")
        scope = scope.with_variables(open_)
        goal = Substitution(terms, scope.definitions).goal(goal.body)
    if values:
        raise NotShown(f"the goal does not bind {', '.join(values)}")
    return replace(sequent, goal=goal, scope=scope)


def _only_for_all(goal: Goal) -> bool:
    while isinstance(goal, All | AllFrom):
        goal = goal.body
    return isinstance(goal, Atom)


def _integers(obligation: Obligation) -> dict[str, int]:
    """Returns the integer variables of the obligation with their least values."""
    said = [r for s in (obligation.statement, *obligation.assume) for r in relations_of(s)]
    names = set().union(*(free_integers(side) for r in said for side in (r.left, r.right)))
    return {name: least for name, least in obligation.scope.integers.items() if name in names}


def _scope_of(goal: Goal) -> str | None:
    """Returns the range of integers that the goal covers, else None."""
    said = list(_ranges(goal))
    return "all " + ", ".join(said) if said else None


def _ranges(goal: Goal) -> Iterator[str]:
    match goal:
        case AllFrom(integer, least, body):
            yield f"{integer} ≥ {least}"
            yield from _ranges(body)
        case All(body=body) | Exists(body=body):
            yield from _ranges(body)
        case Implies(left, right) | Iff(left, right):
            yield from dict.fromkeys((*_ranges(left), *_ranges(right)))
        case Both(parts):
            yield from dict.fromkeys(r for part in parts for r in _ranges(part))


def _evidence(obligation: Obligation, verdict: Verdict) -> Evidence:
    figures: dict[str, object] = {"formula": to_latex(obligation.statement)}
    if obligation.assume:
        figures["assuming"] = [to_latex(s) for s in obligation.assume]
    figures["engines"] = [e.method for e in verdict.evidence]
    return Evidence(f"goal, {obligation.rule}", str(verdict.outcome), figures)


def _not_shown(obligation: Obligation, verdict: Verdict) -> Verdict:
    said = {
        "rule": obligation.rule,
        "formula": to_latex(obligation.statement),
        "outcome": verdict.outcome,
    }
    return Verdict(
        Outcome.UNCHECKED,
        reason=VerdictCode.STEP_NOT_SHOWN_BECAUSE(**said, reason=verdict.reason)
        if verdict.reason
        else VerdictCode.STEP_NOT_SHOWN(**said),
        counterexample=verdict.counterexample,
        evidence=verdict.evidence,
    )
