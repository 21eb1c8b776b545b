"""Decides a claim under a set of facts."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING, TypeAlias

from workbench.context.claims import Claim, Notation
from workbench.context.facts import Duration, Fact, Provider, Supposition
from workbench.core.codes.verdict_codes import UNLESS_IT_LASTS, VerdictCode
from workbench.core.construct import relation
from workbench.core.hypotheses import Hypothesis
from workbench.core.names import Name
from workbench.core.reasons import Reason, reason_of
from workbench.core.terms import Definition, IllFormed, Relation, Statement, Symbol, Term
from workbench.core.verdict import Counterexample, EngineDisagreement, Outcome, Strength, Verdict
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.assumptions import Unsatisfiable, lasting
from workbench.language.definitions import Definitions, replaced
from workbench.prover.decide.mapped_statements import mapped

if TYPE_CHECKING:
    from workbench.prover.decide.decide import Judge

_TRUE = frozenset({Outcome.PROVED, Outcome.CONDITIONAL, Outcome.DEFINITION, Outcome.PROBABLE})

#: Limit on the decisions of one explanation.
MOST_DECISIONS = 40

_PROBLEMS = (RecursionError, IllFormed, NotExact, EngineDisagreement, ZeroDivisionError, ValueError)

JudgeOf: TypeAlias = "Callable[[Notation], Judge]"
_Terms: TypeAlias = dict[Name | Symbol, Term]


def is_true(verdict: Verdict) -> bool:
    """True if the verdict means that the claim is true, or true if its premise lasts."""
    is_same = verdict.code is VerdictCode.SAME_TERM
    return verdict.outcome in _TRUE or is_same or verdict.code in UNLESS_IT_LASTS


class OutOfDecisions(Exception):
    """The explanation of a verdict has used up its decisions."""


class Decider:
    """Decides one claim under sets of facts, each set once.

    second_engine: whether its judges ask both engines."""

    def __init__(self, claim: Claim, judge_of: JudgeOf, second_engine: bool) -> None:
        assert claim.printed.statement is not None
        self.claim, self.judge_of, self._second_engine = claim, judge_of, second_engine
        self._statement: Statement = claim.printed.statement
        self._known: dict[tuple[object, ...], Verdict] = {}
        self._count = 0

    def holds(
        self, facts: Sequence[Fact], statement: Statement | None = None, approximately: bool = False
    ) -> bool:
        """True if the polynomial engine proves it, for every n by both; a random point is tried first.

        A guess that is meant for one instant is not tried for all times.
        """
        is_of_any_n = self.claim.orders is not None and bool(self.claim.orders.generic)
        verdict = self.decide(facts, statement, approximately, by_both=is_of_any_n)
        return is_true(verdict) and not (verdict.code in UNLESS_IT_LASTS and any(map(_is_momentary, facts)))

    def is_refuted(self, facts: Sequence[Fact]) -> bool:
        return self.decide(facts, by_both=False).outcome is Outcome.REFUTED

    def is_consistent(self, facts: Sequence[Fact]) -> bool:
        """True if the claim is decided under the facts, which are consistent then."""
        return self.decide(facts).outcome is not Outcome.UNCHECKED

    def decide(
        self,
        facts: Sequence[Fact],
        statement: Statement | None = None,
        approximately: bool = False,
        by_both: bool = True,
    ) -> Verdict:
        """Returns the verdict; `unchecked` if the facts contradict each other or the declarations.

        Raises OutOfDecisions.
        """
        key = (tuple(facts), statement, approximately, by_both)
        if key not in self._known:
            try:
                self._known[key] = self._decide(facts, statement or self._statement, approximately, by_both)
            except (Unsatisfiable, *_PROBLEMS) as error:
                self._known[key] = Verdict(Outcome.UNCHECKED, reason=reason_of(error))
        return self._known[key]

    def witness(self) -> Counterexample | None:
        """Returns values of which the claim is false on what is declared, be it a law or not."""
        judge = replace(self.judge_of(self.claim.notation), laws=False)
        with suppress(Unsatisfiable, *_PROBLEMS):
            found = judge.judge(self._statement, self.claim.supposed, orders=self.claim.orders)
            return found.counterexample
        return None

    def is_impossible(self, facts: Sequence[Fact]) -> bool:
        """Returns whether no values of its symbols that meet the facts make the claim true."""
        try:
            judged_or_unchecked(lambda: self._decide(facts, self._statement, False, True, is_supposed=True))
        except Unsatisfiable:
            return self.claim.orders is None
        except _PROBLEMS:
            return False
        return False

    def _decide(
        self,
        facts: Sequence[Fact],
        statement: Statement,
        approximately: bool,
        by_both: bool,
        is_supposed: bool = False,
    ) -> Verdict:
        put = _Put(facts)
        claim, put_in = self.claim, put.meaning
        given = [replace(each, body=put_in(each.body)) for each in claim.notation.definitions]
        new = [replace(each, body=put_in(each.body)) for each in put.definitions]
        known = Definitions([*given, *new]) if put.terms or new else claim.notation.definitions
        goal = put.in_statement(statement, approximately)
        base = [put.in_statement(each) for each in claim.supposed]
        always = [put.in_statement(each) for each in put.always]
        lasts = lasting(always, goal, known) if always else []
        instant = [put.in_statement(each) for each in put.instant]
        own = (goal,) if is_supposed else ()
        supposed = tuple(dict.fromkeys((*base, *instant, *lasts, *known.known_of(goal), *own)))
        judge = self._judge(known)
        if not by_both:
            judge = judge.by_one_engine()
            if self._fails_at_random(judge, goal, supposed):
                return Verdict(Outcome.REFUTED)
        self._count += 1
        if self._count > MOST_DECISIONS:
            raise OutOfDecisions
        return judge.judge(goal, supposed, orders=claim.orders)

    def _judge(self, known: Definitions) -> Judge:
        from workbench.prover.decide.decide import Judge

        notation = self.claim.notation
        if known is notation.definitions:
            return self.judge_of(notation)
        bound = frozenset(symbol.declaration.name for symbol in notation.motion)
        return Judge(known, second_engine=self._second_engine, bound=bound)

    def _fails_at_random(self, judge: Judge, goal: Statement, supposed: Sequence[Statement]) -> bool:
        """True for an equation whose residual is not 0 at a random point modulo a prime."""
        from workbench.prover.decide.equation import Equation

        if self.claim.orders or not isinstance(goal, Relation) or goal.operator != "=":
            return False
        if any(isinstance(each, Relation) and each.operator == "≥" for each in supposed):
            return False  # the point need not meet a bound
        with suppress(*_PROBLEMS):
            return Equation(judge, goal, tuple(supposed))._at_random_point() is False
        return False


def _is_momentary(fact: Fact) -> bool:
    return fact.origin.provider is Provider.CONVENTION and fact.duration is Duration.INSTANT


class _Put:
    """Facts sorted by how they enter a claim."""

    def __init__(self, facts: Sequence[Fact]) -> None:
        self.terms: _Terms = {}
        self.definitions: list[Definition] = []
        self.instant: list[Statement] = []
        self.always: list[Statement] = []
        for fact in facts:
            self._add(fact)

    def _add(self, fact: Fact) -> None:
        match fact.content:
            case None:
                pass
            case Definition() as definition:
                self.definitions.append(definition)
            case Supposition(terms=terms, equations=equations):
                for name, term in terms:
                    self._add_term(name, term)
                self.instant += equations
            case said:
                (self.always if fact.duration is Duration.ALWAYS else self.instant).append(said)

    def _add_term(self, name: Name | Symbol, term: Term) -> None:
        """Adds the term of a symbol. A member of a family gets a definition, so that sums reach it."""
        if isinstance(name, Symbol) and not isinstance(term, Symbol):
            self.definitions.append(Definition(name.declaration, name.index, (), term))
        else:
            self.terms[name] = _both(self.terms[name], term) if name in self.terms else term

    def meaning(self, term: Term) -> Term:
        """Returns the term with symbols replaced by their terms."""
        return replaced(term, self._of) if self.terms else term

    def _of(self, own: Symbol) -> Term | None:
        term = self.terms.get(own) or self.terms.get(own.declaration.name)
        if isinstance(term, Symbol) and term.declaration.name == own.declaration.name:
            return replace(term, index=own.index)
        return term

    def in_statement(self, statement: Statement, approximately: bool = False) -> Statement:
        """Returns the statement with the terms put in; approximately: with ≈ for each =."""
        if not (self.terms or approximately):
            return statement

        def put(said: Relation) -> Relation:
            is_weakened = approximately and said.operator == "="
            operator = "≈" if is_weakened else said.operator
            return relation(operator, self.meaning(said.left), self.meaning(said.right))

        return mapped(statement, put)


def _both(one: Term, other: Term) -> Term:
    """Returns the symbol with the flags of both. Raises ValueError for two terms."""
    if one == other:
        return one
    if not (isinstance(one, Symbol) and isinstance(other, Symbol)):
        raise ValueError("two terms for one symbol")
    flags = one.declaration.flags | other.declaration.flags
    return replace(one, declaration=replace(one.declaration, flags=flags))


def judged_alone(claim: Claim, judge_of: JudgeOf) -> Verdict:
    """Returns the verdict under the claim's hypotheses; `unchecked` if they are unsatisfiable."""
    assert claim.printed.statement is not None
    statement = claim.printed.statement
    with suppress(Unsatisfiable):
        judge = judge_of(claim.notation)
        return judged_or_unchecked(lambda: judge.judge(statement, claim.supposed, orders=claim.orders))
    return Verdict(Outcome.UNCHECKED)


def minimise(facts: Sequence[Fact], holds: Callable[[Sequence[Fact]], bool]) -> list[Fact]:
    """Returns a minimal subset of the facts under which it still holds; weak facts are removed first."""
    needed = list(facts)
    for fact in sorted(facts, key=lambda each: each.strength):
        fewer = [each for each in needed if each is not fact]
        if len(needed) > 1 and holds(fewer):
            needed = fewer
    return needed


def conditional(under: Verdict, hypothesis: Hypothesis, reason: Reason, bare: Verdict) -> Verdict:
    """Returns the verdict on a claim that is proved under a hypothesis and refuted without them."""
    return replace(
        under,
        outcome=Outcome.CONDITIONAL,
        hypothesis=hypothesis,
        reason=reason,
        counterexample=bare.counterexample,
        basis=Strength.STATED,
    )


def judged_or_unchecked(judge: Callable[[], Verdict]) -> Verdict:
    """Returns the verdict; `unchecked` if the engines disagree or do not finish.

    These are defects of the workbench that must not stop the other claims; the reason reports them. The
    verdict is also `unchecked` if a theorem has no second engine.
    """
    try:
        return judge()
    except NotExact as outside:
        return Verdict(Outcome.UNCHECKED, reason=reason_of(outside))
    except EngineDisagreement as error:
        return Verdict(Outcome.UNCHECKED, reason=VerdictCode.ENGINES_DISAGREE(error=error))
    except RecursionError:
        return Verdict(Outcome.UNCHECKED, reason=VerdictCode.NESTS_TOO_DEEP())
