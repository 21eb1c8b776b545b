"""Explains a verdict by the context of its claim: facts in order of strength, and a minimal set of them.

A claim that is false under the declarations is tried under the stated facts, then under the hints, then under
each guess. A hint that makes it true gives `conditional`; a guess or an opaque fact is a doubt, and it stays
refuted.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace

from workbench.context.claims import Claim
from workbench.context.conventions import conventional
from workbench.context.facts import Act, Context, Fact, Provider, Strength
from workbench.context.formula_acts import act_by_sign, subject_of
from workbench.context.formula_subject import Subject
from workbench.context.free_symbols import free_in, names_in
from workbench.context.repeated_laws import GIVES, given_by, laws_in, order_in, rate_in
from workbench.core.codes.context_codes import ContextCode
from workbench.core.codes.doubt_codes import DoubtCode, as_one_doubt
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.reasons import Reason
from workbench.core.terms import Definition, Relation, Symbol, sides_of
from workbench.core.verdict import Outcome, Verdict
from workbench.language.printing.printer import to_latex
from workbench.prover.explain.decide_under_facts import (
    Decider,
    JudgeOf,
    OutOfDecisions,
    is_true,
    minimise,
)
from workbench.prover.explain.excluded_poles import POLES, without_poles
from workbench.prover.explain.fact_layers import further_equations, layers_of, restricts
from workbench.prover.explain.false_premises import under_premises
from workbench.prover.explain.family_facts import for_members
from workbench.prover.explain.field_alternatives import other_convention, with_other_gradient
from workbench.prover.explain.guessed_kinds import on_guessed_kinds
from workbench.prover.explain.known_members import for_known_members
from workbench.prover.explain.laws_of_motion import is_all_assumed, is_law, rates_a_definition
from workbench.prover.explain.near_identities import is_near_identity, is_without
from workbench.prover.explain.other_readings import is_rounded, other_reading, without_free_pi
from workbench.prover.explain.stated_properties import with_stated_properties
from workbench.prover.explain.verdicts_under_facts import (
    holds_rate,
    is_small,
    only_said,
    says_what_is,
    terms_said,
    undecided_guesses,
    under,
    unmet_bounds,
    unmet_statements,
)
from workbench.runtime.limits import within

_SURE = frozenset({Outcome.PROVED, Outcome.CONDITIONAL})
_TESTED = GIVES | {Act.CONSTRAIN}
#: Number of unusable facts that a message names.
_NAMED = 2


class Explainer:
    """judge_of: the judge of a notation.   second_engine: whether the judges ask both engines.   seconds: the
    limit on the processor time of one explanation, so that a refutation stands when it is used up."""

    def __init__(self, judge_of: JudgeOf, second_engine: bool, seconds: float) -> None:
        self._judge_of, self._second_engine, self._seconds = judge_of, second_engine, seconds

    def verdict(self, claim: Claim, base: Verdict) -> Verdict:
        """Returns the verdict on a claim in its context; base: the verdict under the declarations."""
        verdict = base
        if base.outcome is Outcome.PROVED and claim.context.span is not None:
            verdict = under_premises(claim, base, self._judge_of, self._explained)
        elif base.outcome is Outcome.REFUTED or (
            base.outcome is Outcome.UNCHECKED and claim.context.span is not None and is_law(claim)
        ):
            verdict = self._explained(claim, base)
        elif base.code in POLES and claim.context.span is not None and claim.corrected is None:
            decider = Decider(claim, self._judge_of, self._second_engine)
            with within(self._seconds), suppress(OutOfDecisions):
                verdict = without_poles(claim, base, decider)
        elif base.outcome is Outcome.ILL_FORMED:
            verdict = with_other_gradient(claim, base, self._judge_of)
        verdict = with_stated_properties(claim, verdict, self._judge_of, self._explained)
        return on_guessed_kinds(claim, verdict)

    def _explained(self, claim: Claim, base: Verdict) -> Verdict:
        if claim.corrected is not None:
            return base
        claim = for_members(claim)
        is_in_text, subject = claim.context.span is not None, subject_of(claim)
        act, own = claim.context.act if is_in_text else act_by_sign(claim.printed, claim.notation)
        is_assumed = act in GIVES and own is not None and own.declaration.name in subject.assumed
        if is_assumed or is_all_assumed(claim):  # equations determine the symbol, or all symbols
            act = Act.ASSERT
        if act is Act.ASSIGN:
            return only_said(base, act, own)
        decider = Decider(claim, self._judge_of, self._second_engine)
        explained = _Explanation(claim, subject, base, decider, act, own)
        with within(self._seconds), suppress(OutOfDecisions):
            return without_free_pi(claim, explained.verdict())
        return without_free_pi(claim, explained.unfinished())


@dataclass
class _Explanation:
    """One claim that is false or open under the declarations.

    known: the largest layer of stated facts under which it is refuted too.   against: that refutation.
    pending: the facts that no refutation includes, because no engine, or only the first, could use them.
    hints: the hints that can hold together with what is known.   doubts: why it may be no claim."""

    claim: Claim
    subject: Subject
    base: Verdict
    decider: Decider
    act: Act
    own: Symbol | None
    known: list[Fact] = field(default_factory=list)
    against: Verdict | None = None
    pending: list[Fact] = field(default_factory=list)
    hints: list[Fact] = field(default_factory=list)
    doubts: list[Reason] = field(default_factory=list)

    def verdict(self) -> Verdict:
        may_be = self.base.outcome is Outcome.REFUTED and self.act in _TESTED
        if may_be and not self.subject.conditioned and self._is_no_condition():
            self.act = Act.ASSERT
        elif may_be and self.claim.context.explains:
            return only_said(self.base, self.act, self.own)
        is_refuted = self.base.outcome is Outcome.REFUTED and not self.claim.context.alone
        if is_refuted and (why := other_reading(self.claim, self.base, self.decider)) is not None:
            return Verdict(Outcome.UNCHECKED, reason=why, read_back=self.base.read_back)
        held = for_known_members(self.claim, self.base, self.decider.judge_of) if is_refuted else None
        if held is not None or (held := self._by_what_is_stated()) is not None:
            return held
        was, own = self.act, self.own
        self._count_again()
        if self.base.outcome is not Outcome.REFUTED:
            rated = rates_a_definition(self.claim, self.known)
            self.doubts += [DoubtCode.OTHER_CASE(fact=law) for law in rated]
            is_known = was is Act.POSTULATE or bool(self._definitions() or self._laws())
            is_claim = self.act is Act.ASSERT and is_known
            if not is_claim or self.against is None or self.against.outcome is not Outcome.REFUTED:
                if was is Act.ASSERT and (found := self._on_hints()) is not None:
                    return found
                gives = was in GIVES
                return self._said_or_held(was if gives else Act.POSTULATE, own if gives else None)
            self.base = self.against
        if self.act in GIVES:
            return self._said_or_held(self.act, self.own)
        context = self._context()
        if (held := self._by_hints(context)) is not None:
            return held
        return self._refuted(context) if self._is_claim() else self._only_constrained()

    def _is_no_condition(self) -> bool:
        """Returns whether nothing makes the equation true, or it is meant to hold for all its symbols."""
        own = self.own if self.act is Act.CONSTRAIN else None
        if self.decider.is_impossible(()) or (own is not None and is_near_identity(self.claim, own)):
            return True
        return own is not None and is_without(self.claim, self.subject.constrained or [own])

    def _on_hints(self) -> Verdict | None:
        """Returns the verdict if hints decide it, as that a symbol rests if the text takes no rate of it."""
        context = self._context()
        if (held := self._by_hints(context)) is not None or not self.hints:
            return held
        found = self.decider.decide([*self.known, *self.hints])
        if found.outcome is not Outcome.REFUTED:
            return None
        self.base = found
        return self._refuted(context)

    def _said_or_held(self, act: Act, own: Symbol | None) -> Verdict:
        """Returns what the formula says of a symbol, unless its sentence states a property that proves it."""
        facts = self.claim.context.facts
        said = tuple(fact for fact in facts if fact.origin.provider is Provider.SENTENCE)
        return self._by_hints(Context(said)) or only_said(self.base, act, own)

    def unfinished(self) -> Verdict:
        """Returns the verdict if the limit on decisions is reached; a refuted claim stays refuted."""
        reason = self.base.reason
        if reason is not None and self.base.code is VerdictCode.STATES_A_LAW:
            return replace(self.base, reason=VerdictCode.LAW_NOT_COMPARED(name=reason.arguments["name"]))
        if self.base.outcome is not Outcome.REFUTED:
            return self.base
        if self.act is not Act.ASSERT:
            return only_said(self.base, self.act, self.own)
        return replace(self.base, unless=(DoubtCode.NOT_TRIED(),))

    def _by_what_is_stated(self) -> Verdict | None:
        """Returns the verdict if it is proved under some layer; else records the results for the layers."""
        layers = list(layers_of(self.claim, self.subject))
        met: set[Fact] = set()
        for layer in layers:
            if self.decider.holds(layer):
                if (held := self._under(layer)) is not None:
                    return held
            elif self.decider.is_refuted(layer):
                met.update(layer)
                self.known = layer if len(layer) >= len(self.known) else self.known
        tried = dict.fromkeys(fact for layer in layers for fact in layer)
        self.pending = [f for f in tried if f not in met and restricts(f, self.subject, list(tried))]
        self.against = self.decider.decide(self.known) if self.known else self.base
        if self.against.outcome is not Outcome.REFUTED:
            return None
        known = list(self.known)
        for fact in further_equations(self.claim, self.subject, known):
            if self.decider.holds([*known, fact]):
                return self._under([*known, fact])
            if self.decider.is_refuted([*known, fact]):
                known.append(fact)
            elif restricts(fact, self.subject, list(tried)):
                self.pending.append(fact)
        if known != self.known and (found := self.decider.decide(known)).outcome is Outcome.REFUTED:
            self.known, self.against = known, found
        return None

    def _under(self, facts: Sequence[Fact]) -> Verdict | None:
        """Returns the verdict under those of the facts that both engines need, if they prove it."""
        for core in (minimise(facts, self.decider.holds), facts):
            found = self.decider.decide(core)
            if found.outcome in _SURE:
                witness = self.base.counterexample or self.decider.witness()
                return under(found, core, replace(self.base, counterexample=witness))
        return None

    def _count_again(self) -> None:
        """Determines the act again, with the definitions and laws expanded that the refutation includes.

        x = … is a claim about a known x, or constrains another symbol.
        """
        said, laws = self._definitions(), self._laws()
        if (said or laws) and self.act in _TESTED:
            self.subject = replace(subject_of(self.claim, said), laws=laws)
            self.act, self.own = self.subject.act
        statement, definitions = self.claim.printed.statement, self.claim.notation.definitions
        own = self.claim.context.act[1]
        is_law = self.act is Act.POSTULATE or self.claim.context.repeats
        if own is None or not is_law or not isinstance(statement, Relation):
            return
        given = given_by(statement, own, self.known, definitions)
        if given and self.act is Act.POSTULATE:
            self.act = Act.ASSERT
        order = order_in(statement, own)
        if given and all(order_in(fact.content, own) == order for fact in given):
            self.doubts.append(DoubtCode.OTHER_CASE(fact=given[0]))

    def _laws(self) -> tuple[Relation, ...]:
        """Returns the laws that the refutation includes, if they contain every symbol of the claim."""
        laws = laws_in(self.known)
        spoken = free_in((side for law in laws for side in sides_of(law)), self.claim.notation.definitions)
        return laws if self.subject.declarations <= spoken else ()

    def _definitions(self) -> list[Definition]:
        return [fact.content for fact in self.known if isinstance(fact.content, Definition)]

    def _is_claim(self) -> bool:
        """Returns whether the equation asserts something; adds the doubt that it says what a symbol is.

        It does if nothing that meets the facts makes it true, if a condition says what its symbol is, or if
        conditions speak of every symbol of which it may say something."""
        if self.act is not Act.CONSTRAIN or self.own is None:
            return True
        symbol = f"${to_latex(self.own)}$"
        says_what_it_is = DoubtCode.SAYS_WHAT_IS(symbol=symbol)
        for facts in filter(None, (self.known, self.hints and [*self.known, *self.hints])):
            if self.decider.is_impossible(facts):
                if facts is not self.known:
                    hints = ", ".join(map(str, self.hints))
                    self.doubts.append(DoubtCode.SAYS_WHAT_IS_DESPITE(symbol=symbol, hints=hints))
                return True
        given = next((each for each in self.known if says_what_is(self.own, each.content)), None)
        if any(says_what_is(self.own, each) for each in self._beside):
            return True
        if given is None:
            is_spoken_of = self._are_spoken_of(self.subject.constrained)
            self.doubts += [says_what_it_is] * is_spoken_of
            return is_spoken_of
        self.doubts += [says_what_it_is] * (given.origin.provider is Provider.UNREAD)
        return True

    @property
    def _beside(self) -> list[Relation]:
        """The equations that are conditions beside the formula, or define its symbols."""
        formulas = (*self.claim.assume, *self.claim.context.given)
        return [each.statement for each in formulas if isinstance(each.statement, Relation)]

    def _are_spoken_of(self, symbols: Sequence[Symbol]) -> bool:
        """Returns whether equations that are conditions of the sentence speak of each of the symbols."""
        beside = [each for each in self.known if each.origin.provider is Provider.CONDITION]
        said = [*self._beside, *(each.content for each in beside if isinstance(each.content, Relation))]
        names = {
            name for each in said if each.operator == "=" and not holds_rate(each) for name in names_in(each)
        }
        return {each.declaration.name for each in symbols} <= names

    def _only_constrained(self) -> Verdict:
        """Returns that the equation says what a symbol is, with the values of which it is not true."""
        shown = (self.against or self.base).counterexample
        return replace(only_said(self.base, self.act, self.own), counterexample=shown)

    def _context(self) -> Context:
        """Returns the facts that the refutation must include, and the guesses."""
        claim = self.claim
        others = [f for f in claim.context.facts if f.is_opaque or f.bound is not None]
        if claim.context.span is None or claim.context.alone:
            return Context((*self.known, *others))
        said = self._definitions()
        hinted = (Provider.SENTENCE, Provider.CONVENTION)
        sentences = [f for f in claim.context.facts if f.origin.provider in hinted and not f.is_opaque]
        context = conventional(subject_of(claim, said) if said else self.subject)
        facts = dict.fromkeys((*self.known, *sentences, *context.facts, *others))
        guessed = [fact for fact in claim.context.facts if fact.strength is Strength.GUESSED]
        guesses = {fact.origin: tuple(f for f in guessed if f.origin == fact.origin) for fact in guessed}
        return Context(tuple(facts), (*guesses.values(), *context.alternatives))

    def _by_hints(self, context: Context) -> Verdict | None:
        hints = [fact for fact in context.formal if fact.strength is Strength.HINTED]
        self.hints = self._joint(hints)
        tries = [[*self.known, *self.hints]]
        tries += [[*self.known, hint] for hint in hints if hint not in self.hints]
        for facts in tries:
            if len(facts) > len(self.known) and self._holds(facts):
                core = minimise(facts, self._holds)
                for own in (core, facts):
                    found = self.decider.decide(own, approximately=is_small(own))
                    if is_true(found):
                        return under(found, own, self.base)
                self.pending += [fact for fact in core if fact not in (*self.known, *self.pending)]
        return None

    def _joint(self, hints: Sequence[Fact]) -> list[Fact]:
        """Returns the hints that are jointly consistent with the known facts."""
        if hints and self.decider.is_consistent([*self.known, *hints]):
            return list(hints)
        usable: list[Fact] = []
        for hint in hints:
            if len(hints) > 1 and self.decider.is_consistent([*self.known, *usable, hint]):
                usable.append(hint)
        return usable

    def _holds(self, facts: Sequence[Fact]) -> bool:
        return self.decider.holds(facts, approximately=is_small(facts))

    def _refuted(self, context: Context) -> Verdict:
        """Returns the refutation with its doubts."""
        against = self.against or self.base
        with_hints = self.decider.decide([*self.known, *self.hints]) if self.hints else against
        meets = with_hints.outcome is Outcome.REFUTED
        shown = (with_hints if meets else against).counterexample or self.base.counterexample
        if shown is not None and is_rounded(self.claim.printed.latex, shown):
            return Verdict(Outcome.UNCHECKED, reason=ContextCode.ROUNDED(), read_back=self.base.read_back)
        if bounds := unmet_bounds(self.known, self.pending, self.decider.decide):
            return Verdict(Outcome.UNCHECKED, reason=bounds, read_back=self.base.read_back)
        unless = [*self._rescuing(context), *self.doubts]
        decide, notation = self.decider.decide, self.claim.notation
        more = unmet_statements(context.opaque, self.known, notation, decide)
        unless += [DoubtCode.MORE_IS_SAID(fact=fact) for fact in more]
        values = shown.values if shown else {}
        pending = [each for each in self.pending if not (each.bound and each.bound.allows(values))]
        pending += undecided_guesses(context, self.known, self.decider)
        unless += [DoubtCode.NOT_DECIDED_WITH(fact=fact) for fact in pending[:_NAMED]]
        if not meets:
            facts = ", ".join(map(str, self.hints or self.known))
            unless.append(DoubtCode.NOT_DECIDED_UNDER(facts=facts))
        broken = [fact for fact in context.facts if fact.bound and not fact.bound.allows(values)]
        unless += [DoubtCode.NOT_WITHIN(fact=fact) for fact in broken]
        basis = min((fact.strength for fact in self.known), default=Strength.DECLARED)
        doubt = as_one_doubt(unless)  # the context counts once
        found = replace(self.base, counterexample=shown, basis=basis, unless=doubt)
        return found if doubt else replace(found, reason=self._given_otherwise() or found.reason)

    def _given_otherwise(self) -> Reason | None:
        """Returns the reason that earlier formulas give the symbol of this one, and speak of its others."""
        _, own = self.claim.context.act
        terms = (term for fact in self.known for term in terms_said(fact))
        if own is None or not self.subject.declarations <= free_in(terms, self.claim.notation.definitions):
            return None
        given = [fact for fact in self.known if fact.act in GIVES and rate_in(fact.content, own) is not None]
        facts = ", ".join(map(str, given))
        return ContextCode.GIVEN_OTHERWISE(symbol=f"${to_latex(own)}$", facts=facts) if given else None

    def _rescuing(self, context: Context) -> list[Reason]:
        """Returns the first guess under which it holds, with the hints that it needs for that."""
        for group in context.alternatives:
            if self._holds([*self.known, *group]):
                return [DoubtCode.FACTS(facts=group[0])]
            if self.hints and self._holds([*self.known, *self.hints, *group]):
                core = minimise([*self.hints, *group], lambda facts: self._holds([*self.known, *facts]))
                return [DoubtCode.FACTS(facts=" and ".join(map(str, core)))]
        if self.claim.context.span is None or self.claim.context.alone:
            return []
        other = other_convention(self.claim, self.decider, [*self.known, *self.hints])
        return [other] if other is not None else []
