"""What is refuted as it stands and may be meant otherwise: by what its text says elsewhere, or leaves out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import replace

from workbench.core.reasons import Reason
from workbench.core.verdict_codes import VerdictCode
from workbench.judge.kernel.closed import is_of_numbers
from workbench.judge.subject.angles import sum_of_products
from workbench.judge.verdict import Outcome, Verdict
from workbench.language.definitions import Definitions, expand, only_turns
from workbench.language.printing.printer import to_latex
from workbench.language.typed.errors import IllFormedAt, ReadError
from workbench.language.typed.integers import Linear
from workbench.language.typed.operators import CIRCULAR
from workbench.language.typed.terms import Apply, Definition, Implication, Relation, Symbol, Term, sides_of
from workbench.papers.formulas import read_statement
from workbench.papers.model import Aside, Claim, Formula, Said
from workbench.papers.said import (
    assigns,
    constrains,
    free_in,
    introduces,
    says_of_defined,
    stated,
    terms_of,
)
from workbench.papers.text_claims.unsettled import of_an_example
from workbench.verify.by_laws import by_laws
from workbench.verify.judged_parts import differentiates_product
from workbench.verify.laws import has_laws, is_all_given, is_law, says_no_more
from workbench.verify.rounding import ROUNDED, is_rounded
from workbench.verify.under import Under, conditional, with_asides

#: What another kind of a symbol could undo, and what its author would take for a fault of the paper.
_RESTS_ON_KINDS = frozenset({Outcome.REFUTED, Outcome.ILL_FORMED, Outcome.CONDITIONAL})

_OR_ALONE = "makes it a claim, or `given = []`, if it needs none"


_REACH = "how far does d/dt reach? bracket what it differentiates"


class Meant:
    """options: those of a judge."""

    def __init__(self, under: Under, options: Mapping[str, bool]) -> None:
        self._under, self._options = under, options

    def verdict(self, claim: Claim, verdict: Verdict) -> Verdict:
        """The verdict on what is printed, given that on its formula."""
        is_refuted = verdict.outcome is Outcome.REFUTED
        is_open = verdict.outcome is Outcome.UNCHECKED and bool(claim.laws or claim.beside) and is_law(claim)
        if (is_refuted or is_open) and (held := by_laws(self._under, claim, verdict)) is not None:
            verdict = held
        elif is_refuted:
            verdict = self._of_refuted(_as_all_given(claim) if is_all_given(claim) else claim, verdict)
        elif verdict.outcome is Outcome.PROVED and claim.span is not None:
            verdict = self._under_what_holds(claim, verdict)
        if claim.guessed and verdict.outcome in _RESTS_ON_KINDS:
            return _open(_as_guessed(verdict, claim.guessed), verdict)
        return verdict

    def _under_what_holds(self, claim: Claim, proved: Verdict) -> Verdict:
        """Of a text nothing is proved from what is false of the symbols that its model defines, or from a
        given formula that is reported as false."""
        said, definitions = claim.printed.statement, claim.notation.definitions
        premises = [said.left] if isinstance(said, Implication) else []
        premises += [formula.statement for formula in claim.given]
        bare = {"given": (), "assume": (), "orders": None, "hypothesis": None}
        alone = replace(claim, **bare, says=None, says_of=None, unsettled=None)
        for place, premise in enumerate(premises):
            formula = Formula(to_latex(premise), premise)
            as_claim = replace(alone, printed=formula, states=stated(premise, claim.notation))
            is_given = place >= len(premises) - len(claim.given)
            contradicts = says_of_defined(premise, definitions)
            if not contradicts and (not is_given or constrains(premise, definitions)):
                continue
            judged = self._under.verdict(as_claim)
            if judged.outcome is Outcome.REFUTED and not contradicts:
                judged = self.verdict(as_claim, judged)
            if judged.outcome is Outcome.REFUTED:
                hypotheses = [*filter(None, [proved.hypothesis]), formula.latex]
                why = VerdictCode.CONTRADICTS_DEFINITIONS()
                if not contradicts:
                    why = VerdictCode.GIVEN_IS_FALSE(formula=formula.latex)
                return conditional(proved, hypotheses, why, judged)
        return proved

    def _of_refuted(self, claim: Claim, refuted: Verdict) -> Verdict:
        if (why := self._why_open(claim, refuted)) is not None:
            return _open(why, refuted)
        return self._with_the_text(claim, refuted) if claim.corrected is None else refuted

    def _why_open(self, claim: Claim, verdict: Verdict) -> str | None:
        if claim.states is not None and not self._under.is_impossible(claim):
            return VerdictCode.SAYS_WHAT_IT_IS(symbol=claim.states)
        if assigns(claim.printed):
            return VerdictCode.ASSIGNMENT()
        if introduces(claim.printed, claim.notation):
            return VerdictCode.INTRODUCES()
        if claim.corrected is not None:
            return None
        if is_rounded(claim.printed.latex, verdict.counterexample):
            return ROUNDED
        statement = claim.printed.statement
        if claim.span is not None and isinstance(statement, Relation) and statement.operator == "≠":
            return VerdictCode.EQUAL_IN_PLACES()
        return (
            _of_two_indices(claim)
            or claim.unsettled
            or (None if is_of_numbers(verdict) else _of_pi(claim))
            or self._if_special(claim, ())
            or self._of_reach(claim)
        )

    def _of_reach(self, claim: Claim) -> str | None:
        """d/dt A P is the rate of the product, unless that is false and that with the rate of A is proved."""
        if not differentiates_product(claim.printed):
            return None
        symbols = claim.notation.symbols
        near = replace(claim.notation, symbols=replace(symbols, loose=symbols.loose | {"near"}))
        with suppress(ReadError, IllFormedAt, ValueError):
            statement, _ = read_statement(claim.printed.latex, near, claim.orders)
            printed = replace(claim.printed, statement=statement)
            if statement != claim.printed.statement:
                verdict = self._under.verdict(replace(claim, printed=printed), ())
                proved = (Outcome.PROVED, Outcome.DEFINITION, Outcome.CONDITIONAL)
                holds = verdict.outcome in proved or verdict.code is VerdictCode.SAME_TERM
                return _REACH if holds else None
        return None

    def _with_the_text(self, claim: Claim, refuted: Verdict) -> Verdict:
        """With what the text says of its symbols, or by a law of motion that it states anywhere."""
        verdict = self._with_what_it_says(claim, refuted)
        if verdict.outcome is Outcome.CONDITIONAL:
            return verdict
        said = [law for law in has_laws(claim) if not self._under.is_known(law, claim.notation)]
        if not said:
            return verdict
        if self._is_false_anyway(claim, said):
            return refuted
        if verdict.outcome is not Outcome.REFUTED:
            return verdict
        places = ", ".join(law.place for law in said)
        return _open(VerdictCode.FALSE_FOR_ANY_MOTION(places=places), refuted)

    def _is_false_anyway(self, claim: Claim, laws: Sequence[Said]) -> bool:
        """Whether the text says no more of its symbols than these laws, and it is false under each."""
        places = {law.place for law in laws}
        is_all = not (claim.beside or claim.says) and all(each.place in places for each in claim.rests)
        return (
            is_all
            and says_no_more(laws, claim)
            and all(self._under.given(claim, [law]).outcome is Outcome.REFUTED for law in laws)
        )

    def _with_what_it_says(self, claim: Claim, refuted: Verdict) -> Verdict:
        """A refuted formula of a text may be true all the same, with what the text says of its symbols beside
        it or elsewhere. One that is false with that, too, and clearly so, is false."""
        if (held := self._with_asides(claim, refuted)) is not None:
            return held
        if claim.beside and (why := self._if_special(_beside(claim), ())) is not None:
            return _open(why, refuted)
        unused = (said for said in claim.rests if said.statement not in claim.supposed)
        rests = [said for said in unused if not self._under.is_known(said, claim.notation)]
        if rests:
            return self._with_what_is_said(claim, rests, refuted)
        if claim.says and not (_is_said_beside(claim) or self._under.is_impossible(claim)):
            return _open(claim.says, refuted)
        return self._under_asides(claim, refuted)

    def _with_what_is_said(self, claim: Claim, rests: Sequence[Said], refuted: Verdict) -> Verdict:
        """With what formulas elsewhere say of its symbols."""
        definitions = {said.name: said.definition for said in rests if said.definition is not None}
        known, shown = tuple(definitions.values()), ", ".join(f"{said.name} ({said.place})" for said in rests)
        under = Verdict(Outcome.UNCHECKED)
        if definitions.keys() == {said.name for said in rests}:
            under = self._under.verdict(claim, _premises(claim), known)
        if under.outcome is Outcome.PROVED:
            alone = self._under.verdict(claim, (), known).outcome is Outcome.PROVED
            hypotheses = [to_latex(said.statement) for said in rests]
            hypotheses += [] if alone else [aside.latex for aside in _premises(claim)]
            return conditional(under, hypotheses, VerdictCode.SYMBOLS_SAID_ELSEWHERE(symbols=shown), refuted)
        if under.outcome is not Outcome.REFUTED or len(definitions) < len(rests):
            return _open(VerdictCode.FALSE_FOR_FREE(symbols=shown), refuted)
        says = None if _is_said_beside(claim) else claim.says
        if says and str(claim.says_of) in definitions:
            is_free = free_in((each.body for each in known), claim.notation.definitions)
            says = of_an_example(claim.printed.statement) if is_free else None
        why = self._if_special(claim, known) or says
        return self._under_asides(claim, refuted) if why is None else _open(why, refuted)

    def _if_special(self, claim: Claim, said: Sequence[Definition]) -> str | None:
        if claim.alone:
            return None
        from workbench.verify.special import special_case

        found = special_case(claim, said, self._options)
        return found and f"holds for {found}; if the text means one, declare it so"

    def _under_asides(self, claim: Claim, refuted: Verdict) -> Verdict:
        """What is false as it stands may be meant under what the sentences around it suppose."""
        if not claim.beside:
            return refuted
        premises = _premises(claim)
        verdict = self._under.verdict(claim, premises)
        against = verdict.counterexample
        is_allowed = against is not None and all(aside.allows(against.values) for aside in claim.beside)
        if verdict.outcome is Outcome.REFUTED and is_allowed:
            return verdict
        shown = list(dict.fromkeys(map(str, claim.beside)))[:5]
        code = VerdictCode.FALSE_WITHOUT_PREMISE if premises else VerdictCode.FALSE_WITHOUT_DECLARATION
        return _open(code(conditions=", ".join(shown)), refuted)

    def _with_asides(self, claim: Claim, refuted: Verdict) -> Verdict | None:
        """What is proved with them is conditional on those that the proof needs."""
        premises = _premises(claim)
        verdict = self._under.verdict(claim, premises) if premises else Verdict(Outcome.UNCHECKED)
        if verdict.outcome is not Outcome.PROVED:
            return None
        alone = ([aside] for aside in premises if len(premises) > 1)
        needed = next((e for e in alone if self._under.verdict(claim, e).outcome is Outcome.PROVED), premises)
        reason = VerdictCode.CONDITION_BESIDE(conditions=", ".join(dict.fromkeys(map(str, needed))))
        return conditional(verdict, [aside.latex for aside in needed], reason, refuted)


def _of_pi(claim: Claim) -> str | None:
    """Of π no more is known than the cosine and sine of its half."""
    definitions = claim.notation.definitions
    bodies = (said.definition.body for said in claim.rests if said.definition is not None)
    said = [*sides_of(claim.printed.statement), *bodies]
    reached = (part for term in said for part in definitions.reached(term) if isinstance(part, Symbol))
    if not any(definitions.is_pi(part.declaration) for part in reached):
        return None
    terms = [expand(term, definitions) for term in said]
    is_open = not all(_has_known_turns(term, definitions) for term in terms)
    return "false for some values of \\pi; if it is the number, that says nothing" if is_open else None


def _has_known_turns(term: Term, definitions: Definitions) -> bool:
    """Whether π stands in it only where a sine or the like takes a multiple of its half, and multiplies no
    other angle."""

    def is_pi(part: Term) -> bool:
        return isinstance(part, Symbol) and definitions.is_pi(part.declaration)

    if not all(only_turns(term, part) for part in term.walk() if is_pi(part)):
        return False
    if isinstance(term, Apply) and term.head in CIRCULAR:
        addends = sum_of_products(term.arguments[0], definitions).items()
        sizes = [
            (factors, size) for factors, size in addends if any(is_pi(p) for f in factors for p in f.walk())
        ]
        return all(len(f) == 1 and is_pi(f[0]) and (2 * size).denominator == 1 for f, size in sizes)
    return not is_pi(term) and all(_has_known_turns(child, definitions) for child in term.children)


def _of_two_indices(claim: Claim) -> str | None:
    """R_{12} of a family R_n, which nothing defines: its twelfth member, or that of 1 and 2?"""
    symbols = (term for term in terms_of(claim.printed.statement) if isinstance(term, Symbol))
    for symbol in symbols:
        own, (number, *others) = symbol.declaration.name, symbol.index or (Linear(0),)
        is_said = others or not number.is_number or claim.notation.symbols.defines(own, symbol.index)
        if not is_said and int(number) > 9:
            name = own.shown(symbol.index)
            return f"{name}: by its number, or by two indices? a definition or `free = true` of it says so"
    return None


def _as_guessed(verdict: Verdict, names: Sequence[str]) -> Reason:
    shown = ", ".join(names[:5]) + (", …" if len(names) > 5 else "")
    if verdict.reason:
        return VerdictCode.AS_GUESSED_BECAUSE(outcome=verdict.outcome, symbols=shown, reason=verdict.reason)
    return VerdictCode.AS_GUESSED(outcome=verdict.outcome, symbols=shown)


def _is_said_beside(claim: Claim) -> bool:
    """Whether a sentence speaks of the symbol that the formula may say something of."""
    parts = (part for aside in _premises(claim) for part in terms_of(aside.premise))
    return any(part.declaration.name == claim.says_of for part in parts if isinstance(part, Symbol))


def _beside(claim: Claim) -> Claim:
    """The claim under what its text supposes beside it."""
    return with_asides(claim, _premises(claim))


def _as_all_given(claim: Claim) -> Claim:
    """The claim, with nothing that it may say of its symbols itself, or that its text says elsewhere."""
    return replace(claim, states=None, says=None, rests=(), laws=())


def _premises(claim: Claim) -> list[Aside]:
    return [aside for aside in claim.beside if aside.premise is not None]


def _open(why: str, verdict: Verdict) -> Verdict:
    reason = why if isinstance(why, Reason) else VerdictCode.MEANT_OTHERWISE(meant=why)
    return Verdict(Outcome.UNCHECKED, reason=reason, read_back=verdict.read_back)
