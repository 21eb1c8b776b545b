"""Decides a statement: a judge for each kind of statement."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import cast

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import relation as equated
from workbench.core.hypotheses import Hypothesis
from workbench.core.terms import (
    Conjunction,
    Equivalence,
    Extremum,
    Implication,
    Naming,
    Relation,
    Statement,
    Symbol,
    sides_of,
)
from workbench.core.verdict import Evidence, Outcome, Strength, Verdict
from workbench.engines.inventory import Lookup, NotExact, WithoutDefinitions
from workbench.engines.inventory.assumptions import Unsatisfiable
from workbench.engines.inventory.elementary_functions import holds_functions, holds_roots
from workbench.engines.inventory.exponentials_of_matrices import holds_matrix_exponentials
from workbench.engines.inventory.first_order import to_first_order
from workbench.engines.inventory.partial_derivatives import positive_coordinates
from workbench.language.definitions import is_definition
from workbench.language.printing.printer import to_latex
from workbench.prover.decide.case import Case, Setting, at_places_apart
from workbench.prover.decide.closed_formulas import judge_closed, refuted_at_numbers
from workbench.prover.decide.disequation import judge_inequation
from workbench.prover.decide.elementary_equations import difference, domain_of, judge_functions, judge_roots
from workbench.prover.decide.equation import BY_DEFINITION, Equation
from workbench.prover.decide.extrema import judge_extremum
from workbench.prover.decide.families.families import WORST_FIRST, InstanceJudge, judge_family
from workbench.prover.decide.families.orders_past_literals import OrderRanges
from workbench.prover.decide.inference import conclusion, generalization
from workbench.prover.decide.inverse_trigonometry import holds_arc, judge_branch
from workbench.prover.decide.linear_integrals import holds_integral, judge_integrals
from workbench.prover.decide.logarithms import holds_logarithm, judge_logarithm, law_of_logarithm
from workbench.prover.decide.matrix_exponentials import judge_matrix_exponentials
from workbench.prover.decide.premise_consequences import (
    ByPremise,
    judge_by_inverse,
    judge_by_premise,
    unless_lasting,
)


@dataclass(frozen=True)
class Judge(Setting):
    """Judges statements under one set of definitions; `Setting` has the options."""

    #: Verdicts on instances, by setting and question: claims share steps of their proofs.
    _known: dict[tuple[Judge, Statement, tuple[Statement, ...], Statement | None], Verdict] = field(
        default_factory=dict, compare=False, repr=False
    )

    def by_one_engine(self) -> Judge:
        return replace(self, second_engine=False)

    def judge(
        self,
        statement: Statement,
        assume: Sequence[Statement] = (),
        hypothesis: Statement | None = None,
        orders: OrderRanges | None = None,
    ) -> Verdict:
        """Returns the verdict on a statement under the stated assumptions.

        hypothesis: a condition that the text does not state; the outcome is `conditional` if the statement
        needs it. orders: the integer variables of a family. Raises Unsatisfiable if nothing satisfies the
        assumptions, EngineDisagreement if the engines differ.
        """
        judge = replace(self, laws=False) if orders else self
        judged = judge_family(cast(InstanceJudge, judge), statement, tuple(assume), hypothesis, orders)
        is_idle = judged.code is VerdictCode.SAME_TERM
        if is_idle and isinstance(statement, Relation) and statement.left != statement.right:
            judged = judge_closed(statement, tuple(assume), self.definitions, self.second_engine) or judged
        return replace(judged, read_back=to_latex(statement))

    def judge_instance(
        self, statement: Statement, assume: tuple[Statement, ...], hypothesis: Statement | None
    ) -> Verdict:
        """Returns the verdict on a statement without integer variables. Raises NotExact outside exact
        arithmetic."""
        asked = self, statement, assume, hypothesis
        if asked not in self._known:
            try:
                self._known[asked] = self._judge_under(statement, assume, hypothesis)
            except NotExact:
                coordinates = positive_coordinates(sides_of(statement), self.definitions)
                if not coordinates:
                    raise
                self._known[asked] = self._of_any_sign(coordinates, statement, assume, hypothesis)
        return self._known[asked]

    def _of_any_sign(
        self,
        coordinates: frozenset[Symbol],
        statement: Statement,
        assume: tuple[Statement, ...],
        hypothesis: Statement | None,
    ) -> Verdict:
        """Returns the verdict if the positive variables of derivatives may be negative, too."""
        judge = replace(self, definitions=WithoutDefinitions(self.definitions, coordinates))
        verdict = judge.judge_instance(statement, assume, hypothesis)
        values = {} if verdict.counterexample is None else verdict.counterexample.values
        for name in map(to_latex, coordinates):
            if name in values and Fraction(*values[name]) <= 0:
                return Verdict(Outcome.UNCHECKED, reason=VerdictCode.OPEN_WHERE_POSITIVE(name=name))
        return verdict

    def _judge_under(
        self, statement: Statement, assume: tuple[Statement, ...], hypothesis: Statement | None
    ) -> Verdict:
        verdict = self._supposing(assume, statement, ())
        if hypothesis is None or verdict.outcome in (Outcome.PROVED, Outcome.DEFINITION):
            return verdict
        under = self._supposing((*assume, hypothesis), statement, ())
        if under.outcome != Outcome.PROVED:
            return under
        if verdict.counterexample is None:
            return replace(under, outcome=Outcome.UNCHECKED, reason=VerdictCode.NO_WITNESS())
        witness = Evidence("witness against the bare statement", verdict.reason or "a point where it fails")
        return Verdict(
            Outcome.CONDITIONAL,
            reason=VerdictCode.UNDER_HYPOTHESIS(),
            hypothesis=Hypothesis.of(to_latex(hypothesis)),
            counterexample=verdict.counterexample,
            evidence=(*under.evidence, witness),
            basis=Strength.HINTED,
        )

    def _judge(self, statement: Statement, assume: tuple[Statement, ...]) -> Verdict:
        return at_places_apart(self._judge_anywhere, statement, assume)

    def _judge_anywhere(self, statement: Statement, assume: tuple[Statement, ...]) -> Verdict:
        """Returns the verdict with the values of a function at its places independent of each other."""
        try:
            verdict = self._judge_form(statement, assume)
        except ZeroDivisionError:
            return Verdict(Outcome.UNCHECKED, reason=VerdictCode.DENOMINATOR_ZERO())
        except NotExact:
            closed = judge_closed(statement, assume, self.definitions, self.second_engine)
            if (found := closed or refuted_at_numbers(statement, assume, self.definitions)) is None:
                raise
            return found
        if verdict.outcome is Outcome.PROVED and is_definition(statement, self.definitions):
            return BY_DEFINITION
        # A point that assigns a value to π is not a counterexample.
        values = verdict.counterexample.values if verdict.counterexample else ()
        is_refuted = verdict.outcome is Outcome.REFUTED and not values
        is_settled = is_refuted or verdict.outcome in (Outcome.PROVED, Outcome.DEFINITION)
        if is_settled or verdict.code is VerdictCode.SAME_TERM:
            return verdict
        closed = judge_closed(statement, assume, self.definitions, self.second_engine)
        if closed is None and verdict.code is VerdictCode.NOT_FROM_FUNCTIONS:
            closed = refuted_at_numbers(statement, assume, self.definitions)
        return closed or verdict

    def _judge_form(self, statement: Statement, assume: tuple[Statement, ...]) -> Verdict:
        match statement:
            case Conjunction(parts=parts):
                return self._of_parts(parts, assume)
            case Relation(operator="=") if holds_logarithm(statement, self.definitions):
                return self._logarithm(statement, assume)
            case Relation() if holds_arc(statement):
                return self._inverse_angle(statement, assume)
            case Relation(operator="=") if holds_integral(statement, self.definitions):
                return self._integral(statement, assume)
            case Relation(operator="=") if holds_matrix_exponentials(statement, self.definitions):
                setting = self.definitions, self.laws
                return judge_matrix_exponentials(statement, assume, setting, self._judge)
            case Relation(operator="=") if holds_functions(statement, self.definitions):
                return self._elementary(statement, assume)
            case Relation(operator="="):
                return self._equation(statement, assume)
            case Relation(operator="≈"):
                return self._approximated(statement, assume)
            case Relation():
                return judge_inequation(self, statement, assume)
            case Equivalence(left=left, right=right):
                return _together([self._one_way(left, right, assume), self._one_way(right, left, assume)])
            case Implication(left=left, right=right):
                return self._implied(left, right, assume)
            case Extremum():
                return judge_extremum(self, statement, assume, self._judge)
            case Naming():
                return self._named(statement, assume)
        raise NotExact("a statement of this form")

    def _equation(self, said: Relation, assume: tuple[Statement, ...]) -> Verdict:
        if (found := self._by_premise(said, assume, judge_by_inverse)) is not None:
            return found
        try:
            verdict = Equation(self, said, assume).verdict()
        except NotExact:
            found = self._by_premise(said, assume)
            if found is None and holds_roots(said, self.definitions):
                found = judge_roots(said, assume, (self.definitions, self.laws), self._judge)
            if found is None:
                raise
            return found
        is_open = verdict.outcome is Outcome.UNCHECKED and said.left != said.right
        return (self._by_premise(said, assume) if is_open else None) or verdict

    def _by_premise(
        self, said: Relation, assume: tuple[Statement, ...], by: ByPremise = judge_by_premise
    ) -> Verdict | None:
        """Returns the verdict if a premise says what a symbol is, else None."""

        def judge(other: Statement, supposed: tuple[Statement, ...], definitions: Lookup) -> Verdict:
            return replace(self, definitions=definitions)._judge(other, supposed)

        return by(said, assume, self.definitions, self.bound, judge)

    def _logarithm(self, said: Relation, assume: tuple[Statement, ...]) -> Verdict:
        def judge(statement: Statement, definitions: Lookup) -> Verdict:
            return replace(self, definitions=definitions)._judge(statement, assume)

        verdict = judge_logarithm(said, bool(assume), self.definitions, judge)
        law = law_of_logarithm(said, self.definitions) if self.laws and not assume else None
        if verdict.outcome is Outcome.REFUTED and law is not None:
            return Verdict(Outcome.UNCHECKED, reason=VerdictCode.STATES_A_LAW(name=to_latex(law)))
        return verdict

    def _integral(self, said: Relation, assume: tuple[Statement, ...]) -> Verdict:
        if is_definition(said, self.definitions):
            return BY_DEFINITION

        def judge(below: Statement) -> Verdict:
            """What is assumed at an instant holds at no other place of the integral."""
            verdict = self._judge(below, assume)
            if not assume or verdict.outcome is Outcome.REFUTED:
                return verdict
            alone = self._judge(below, ())
            is_open = alone.outcome not in (Outcome.PROVED, Outcome.CONDITIONAL)
            return Verdict(Outcome.UNCHECKED, reason=VerdictCode.NOT_FROM_LINEARITY()) if is_open else alone

        return judge_integrals(said, self.definitions, judge, lambda other: self._judge(other, assume))

    def _inverse_angle(self, said: Relation, assume: tuple[Statement, ...]) -> Verdict:
        """Returns the verdict by the branch of an inverse function alone on its side, else by its rates."""
        try:
            return judge_branch(said, self.definitions, lambda other: self._judge(other, assume))
        except NotExact:
            if said.operator != "=":
                raise
            verdict = self._elementary(said, assume)
            if verdict.code is VerdictCode.NOT_FROM_FUNCTIONS:
                raise
            return verdict

    def _elementary(self, said: Relation, assume: tuple[Statement, ...]) -> Verdict:
        return judge_functions(said, assume, (self.definitions, self.laws), self._judge)

    def _approximated(self, said: Relation, assume: tuple[Statement, ...]) -> Verdict:
        compared = to_first_order(said, assume, self.definitions)
        is_same = compared.relation.left == compared.relation.right and said.left != said.right
        verdict = self._judge(difference(compared.relation) if is_same else compared.relation, assume)
        if verdict.outcome is Outcome.REFUTED and compared.has_plain_side:
            return Verdict(Outcome.UNCHECKED, reason=VerdictCode.DIFFERENT_TO_FIRST_ORDER())
        order = f"{compared.order} in {compared.names}"
        evidence = Evidence("dual numbers", f"{order} and their rates, taken together")
        holds = verdict.outcome not in (Outcome.REFUTED, Outcome.UNCHECKED)
        return generalization(verdict, order if holds else None, (*verdict.evidence, evidence))

    def _of_parts(self, parts: Sequence[Statement], assume: tuple[Statement, ...]) -> Verdict:
        """Returns the verdict on a chain or a system: that on its non-trivial parts.

        For a part whose sides are the same term only its definedness is checked, and the evidence records it.
        """
        judged = self._each(parts, assume)
        if all(verdict.code is VerdictCode.SAME_TERM for _, verdict in judged):
            return judged[0][1]
        verdicts, idle = [], []
        for part, verdict in judged:
            if verdict.code is VerdictCode.SAME_TERM and isinstance(part, Relation):
                verdict = self._judge(difference(part), assume)
                idle.append(
                    Evidence("trivial part", VerdictCode.SAME_TERM.template, {"formula": to_latex(part)})
                )
            verdicts.append(verdict)
        verdict = _together(verdicts)
        return replace(verdict, evidence=(*verdict.evidence, *idle))

    def _each(
        self, parts: Sequence[Statement], assume: tuple[Statement, ...]
    ) -> list[tuple[Statement, Verdict]]:
        """Returns the parts with their verdicts.

        Raises NotExact for a part outside exact arithmetic, unless another part is refuted.
        """
        found, faults = [], []
        for part in parts:
            try:
                found.append((part, self._judge(part, assume)))
            except NotExact as fault:
                faults.append(fault)
        if faults and not any(verdict.outcome is Outcome.REFUTED for _, verdict in found):
            raise faults[0]
        return found

    def _named(self, said: Naming, assume: tuple[Statement, ...]) -> Verdict:
        """Returns the verdict on a set or a map: a definition, if its conditions are proved."""
        for part in said.parts:
            verdict = self._judge(part, assume)
            if verdict.outcome not in (Outcome.PROVED, Outcome.DEFINITION):
                return verdict
        if said.undecided:
            return Verdict(Outcome.UNCHECKED, reason=said.undecided)
        terms = [equated("=", term, term) for term in said.terms]
        try:
            Case(self, terms, (*assume, *said.given)).require_satisfiable()
        except Unsatisfiable:
            return Verdict(Outcome.UNCHECKED, reason=VerdictCode.EMPTY_SET())
        for term in terms:  # equality of the value everywhere implies that it is defined everywhere
            verdict = self._defined(term, (*assume, *said.given))
            if verdict.code is VerdictCode.NOT_DEFINED_FOR_ALL:
                return verdict
            if verdict.outcome not in (Outcome.PROVED, Outcome.DEFINITION):
                reason = VerdictCode.NOT_DEFINED_FOR_ALL(left=to_latex(term.left), reason=verdict.reason)
                return replace(verdict, outcome=Outcome.UNCHECKED, reason=reason)
        return Verdict(Outcome.DEFINITION, evidence=(Evidence("sets and maps", "well-formed"),))

    def _defined(self, same: Relation, assume: tuple[Statement, ...]) -> Verdict:
        """Returns `proved` if the term that both sides are is defined everywhere."""
        verdict = self._judge(difference(same), assume)
        if (where := domain_of(verdict)) is None:
            return verdict
        reason = VerdictCode.NOT_DEFINED_FOR_ALL(left=to_latex(same.left), reason=f"only {where}")
        return replace(verdict, outcome=Outcome.UNCHECKED, reason=reason)

    def _one_way(self, premise: Statement, claim: Statement, assume: tuple[Statement, ...]) -> Verdict:
        try:
            return self._implied(premise, claim, assume)
        except Unsatisfiable:
            return Verdict(Outcome.UNCHECKED, reason=VerdictCode.EMPTY_SIDE())

    def _implied(self, premise: Statement, claim: Statement, assume: tuple[Statement, ...]) -> Verdict:
        """Returns the verdict on an implication. x ≠ 0 ⇒ y ≠ 0 means that x = 0 where y = 0, and that y is
        defined where x ≠ 0."""
        if (
            isinstance(premise, Relation)
            and isinstance(claim, Relation)
            and premise.operator == claim.operator == "≠"
        ):
            given, said = (equated("=", *[difference(r).left] * 2) for r in (premise, claim))
            equal, other = (replace(r, operator="=") for r in (claim, premise))
            turned = self._implied(equal, other, (*assume, given))
            defined = self._defined(said, (*assume, premise))
            return turned if defined.outcome is Outcome.PROVED else _together([turned, defined])
        return self._supposing((premise,), claim, assume)

    def _supposing(
        self, premises: Sequence[Statement], claim: Statement, assume: tuple[Statement, ...]
    ) -> Verdict:
        """Returns the verdict on the claim under the premises at the instant.

        A claim that is false only if they do not last, such as f = 1 ⇒ ḟ = 0, is not refuted: its author has
        to state which is meant.
        """
        verdict = self._judge(claim, (*assume, *premises))
        if verdict.outcome is not Outcome.REFUTED:
            return verdict

        def judge(said: Statement, supposed: tuple[Statement, ...]) -> Verdict:
            return self._judge(said, (*assume, *supposed))

        return unless_lasting(verdict, claim, premises, self.definitions, judge)


def _together(verdicts: list[Verdict]) -> Verdict:
    """Returns the verdict on a conjunction: the worst verdict on its parts."""
    worst = min(verdicts, key=lambda verdict: WORST_FIRST.index(verdict.outcome))
    if worst.outcome != Outcome.PROVED:
        return worst
    evidence = tuple(e for v in verdicts for e in v.evidence)
    return conclusion("conjunction", verdicts, evidence, worst.scope)
