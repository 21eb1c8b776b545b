"""A text without a model, judged under the model that is drafted for it."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial

from workbench.context.claims import Claim
from workbench.context.facts import Act
from workbench.core.codes.context_codes import ContextCode
from workbench.core.codes.doubt_codes import DoubtCode, as_one_doubt, single_doubts
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.reasons import Reason
from workbench.core.terms import IllFormed, Relation, Symbol, Term, sides_of
from workbench.core.verdict import Grade, Outcome, Strength, Verdict
from workbench.language.definitions import expand
from workbench.language.grammar.latex_keys import latex_key
from workbench.language.printing.printer import to_latex
from workbench.papers.drafting.drafted_abbreviations import letters_before_angles
from workbench.papers.drafting.drafted_doubts import (
    is_open_misfit,
    is_told,
    judge_of,
    may_say_what_symbols_are,
    misread,
    other_meanings,
    subject_alone,
)
from workbench.papers.drafting.drafted_texts import Draft
from workbench.papers.drafting.formulary.near_standard import with_standard_formulas
from workbench.papers.drafting.inference.infer import Thin, kind_name
from workbench.papers.drafting.meanings.branches import holds_on_a_branch
from workbench.papers.drafting.meanings.contradictions import display_of
from workbench.papers.drafting.meanings.informing_equations import is_of_positive_numbers, says_what_is
from workbench.papers.drafting.meanings.names_in_claims import (
    by_definitions,
    names_of,
    reached_names,
    symbols_of,
    with_printed_size,
    written,
)
from workbench.papers.drafting.meanings.usual_misprints import (
    contradicted,
    definitions_of,
    distance,
    is_misprint,
)
from workbench.papers.drafting.redefinitions import given_in
from workbench.papers.drafting.typefaces import flat
from workbench.prover.results.claim_results import ClaimResult
from workbench.repair.propose.usual_changes import Nearness
from workbench.source.documents import Display
from workbench.source.documents.condition_words import OF_CASE, OF_CASE_OR_VALUE, in_last_sentence
from workbench.source.documents.surrounding_words import sections_of

#: The words for one of several cases, before a display.
_CASE = in_last_sentence(OF_CASE_OR_VALUE)
#: The words for another case than that of an earlier display.
_OTHER_CASE = in_last_sentence(OF_CASE)
#: The words for a case in which an earlier formula has another form.
_BECOMES = in_last_sentence(r"becomes?|reduces?|simplif\w+|specializ\w+|special|particular")
#: The words before an equation that the text solves.
_TO_SOLVE = re.compile(
    r"\bsolv(?:e|es|ed|ing)\b(?:(?!giv|yield|obtain|find|lead)[^.;,$])*\b(?:equations?|systems?|problems?)\s*:?\s*$",
    re.IGNORECASE,
)
#: The words before an equation that selects the members of a set.
_OF_A_SET = re.compile(
    r"\b(?:set|locus|surface|curve|sphere|ellipsoid|ellipse|circle|plane|region|manifold)\b[^.;]*"
    r"\b(?:defined|given|described|determined)\s+by\b[^.;$]*$",
    re.IGNORECASE,
)
_PLAIN = re.compile(r"\\math(?:rm|sf|it)")
#: The most doubts about symbols that a verdict names.
_MOST_DOUBTS = 3

#: Doubts that count for nothing if a usual change of a false equation makes it true.
_SOFT = frozenset({DoubtCode.SAYS_WHAT_SYMBOLS_ARE})
_RESTS_ON_KINDS = frozenset({Outcome.REFUTED, Outcome.ILL_FORMED, Outcome.CONDITIONAL})


def on_drafted_kinds(draft: Draft, results: Sequence[ClaimResult]) -> list[ClaimResult]:
    """Returns the results with the confidence of drafted kinds.

    A false claim is not decided if a kind that it uses rests on its own formula only. A guess that no true
    formula bears out is one more doubt if another falsehood rests on it, too, unless one usual change makes
    the claim true, or if it is a definition of another section.
    """
    results = [replace(result, verdict=contradicted(draft, result)) for result in results]
    judged = [replace(result, verdict=_on_drafted_kinds(draft, result)) for result in results]
    records = Records.of(draft, judged)
    doubted = [replace(result, verdict=records.doubted(result)) for result in judged]
    return with_standard_formulas(draft, doubted)


def _on_drafted_kinds(draft: Draft, result: ClaimResult) -> Verdict:
    verdict, claim = result.verdict, result.claim
    if verdict.outcome not in _RESTS_ON_KINDS:
        return verdict
    inference, latex = draft.ingested.inference, claim.printed.latex
    confirmed, names = draft.ingested.confirmed, names_of(claim)
    if names and confirmed.issuperset(names):
        return verdict
    thin = [each for each in inference.thin if each.latex == latex and each.name not in confirmed]
    thin = [each for each in thin if each.name != with_printed_size(claim)]
    if verdict.outcome is not Outcome.ILL_FORMED:  # with another kind, it is ill-formed
        thin = [each for each in thin if not each.alone]
    own_misfits = [each for each in inference.misfits if not is_open_misfit(each)]
    misfits = {each.latex: each.cured_by for each in own_misfits}
    given_anew = {name for each in inference.misfits if each.gives_entries for name in each.names}
    reason: Reason | None = None
    is_own = any(each.latex == latex and is_told(verdict, each) for each in own_misfits)
    if verdict.outcome is Outcome.ILL_FORMED and not is_own:
        reason = VerdictCode.NOT_AS_DRAFTED(reason=verdict.reason or "")
    elif thin and latex not in misfits:
        reason = _asked(verdict, thin)
    elif _has_frames(draft, claim):
        reason = VerdictCode.OF_FRAMES(outcome=verdict.outcome)
    if reason is not None:
        return Verdict(Outcome.UNCHECKED, reason=reason, read_back=verdict.read_back)
    is_misfit = verdict.outcome is Outcome.ILL_FORMED and latex in misfits
    own = {name for each in own_misfits if each.latex == latex for name in each.names} - inference.firm
    spoilt = {name for each in own_misfits if each.latex != latex for name in each.names} & own
    unsure = {*misfits[latex], *given_anew, *spoilt} if is_misfit else inference.doubtful(latex)
    # A definition gives a symbol its value; it may be the one formula of the two that is misread.
    given = set() if is_misfit else {each.symbol for each in draft.ingested.definitions if each.sure}
    known = confirmed | given
    kinds = [name for name in names or unsure if name in unsure and name not in known]
    doubts = list(kinds)
    if (elsewhere := _defined_elsewhere(draft, claim) or _of_another_case(draft, claim)) is not None:
        doubts.append(elsewhere)
    doubts += [name for name in (*_given_anew(draft, claim), *_of_other_place(claim)) if name not in doubts]
    doubts += _unwritten_members(draft, claim)
    doubts += _abbreviated_functions(claim)
    unless = _doubts_of(draft, result, doubts, is_misfit)
    said = [own for doubt in verdict.unless for own in _of_the_text(doubt)]
    of_kinds = {DoubtCode.SOMETHING_ELSE(name=name) for name in kinds}
    soft = [*said, *(each for each in unless if each.code in _SOFT or each in of_kinds)]
    is_soft = bool(soft) and len({*unless, *said} - {*soft}) == 1
    if is_soft and verdict.outcome is Outcome.REFUTED and is_misprint(claim):
        said, unless = [], unless[:1]
    reason = verdict.reason or (by_definitions(draft, claim) if verdict.outcome is Outcome.REFUTED else None)
    return replace(verdict, basis=min(verdict.basis, Strength.HINTED), unless=(*said, *unless), reason=reason)


def _doubts_of(draft: Draft, result: ClaimResult, doubts: Sequence[str], is_misfit: bool) -> list[Reason]:
    """Returns the doubts about a false claim.

    doubts: symbols that may be something else.   is_misfit: whether the kinds fit nowhere in the claim.
    """
    verdict, claim, display = result.verdict, result.claim, display_of(result.claim, draft.ingested)
    unless = [
        DoubtCode.DRAFTED_KINDS(),
        *(DoubtCode.SOMETHING_ELSE(name=name) for name in doubts[:_MOST_DOUBTS]),
    ]
    is_contradicted = any(each.claim == claim.id for each in draft.contradicted)
    if not (is_misfit or is_contradicted):
        confirmed = draft.ingested.confirmed
        guesses = {name: each for name, each in draft.ingested.guesses.items() if name not in confirmed}
        unless += other_meanings(claim, definitions_of(claim), guesses)
    if verdict.outcome is Outcome.REFUTED and holds_on_a_branch(
        claim.printed.statement, definitions_of(claim)
    ):
        unless.append(DoubtCode.OTHER_BRANCH())
    if display is not None and _TO_SOLVE.search(display.before):
        unless.append(DoubtCode.TO_SOLVE())
    if display is not None and _OF_A_SET.search(display.before):
        unless.append(DoubtCode.OF_A_SET())
    unless += misread(draft, claim.printed.latex) if is_misfit else ()
    is_open = verdict.code is not ContextCode.GIVEN_OTHERWISE and may_say_what_symbols_are(claim)
    if not doubts and verdict.counterexample is not None and is_open:
        unless.append(DoubtCode.SAYS_WHAT_SYMBOLS_ARE())
    elif verdict.outcome is Outcome.REFUTED and len(unless) == 1 and not (verdict.unless or is_contradicted):
        is_new = partial(_is_new, draft, display)
        unless += says_what_is(claim, definitions_of(claim), judge_of, is_new)
        if is_of_positive_numbers(claim, definitions_of(claim), judge_of):
            unless.append(DoubtCode.POSITIVE())
    is_case = display is not None and _BECOMES.search(display.before) is not None and not is_misfit
    if is_case and _is_given_before(draft, claim) and distance(claim, every=True) is Nearness.FAR:
        unless.append(DoubtCode.OTHER_CASE(fact="that of its first formula"))
    return unless


def _is_new(draft: Draft, display: Display | None, own: Symbol) -> bool:
    """True if no formula with a relation before a display has the symbol."""
    first = draft.ingested.inference.first.get(written(own.declaration.name))
    return any(each.display is display and each.latex == first for each in draft.ingested.formulas)


def _of_the_text(doubt: Reason) -> tuple[Reason, ...]:
    """Returns a doubt without that of transposed rotations: all definitions of a draft are the text's own."""
    parts = single_doubts(doubt)
    return as_one_doubt(each for each in parts if each.code is not DoubtCode.TRANSPOSED_ROTATIONS)


def _defined_elsewhere(draft: Draft, claim: Claim) -> str | None:
    """Returns the symbol alone on the left that another section defines, which may be another one here."""
    match claim.printed.statement:
        case Relation(left=Symbol(declaration=declaration)):
            return next(iter(_of_other_sections(draft, claim, {written(declaration.name)})), None)
    return None


def _of_another_case(draft: Draft, claim: Claim) -> str | None:
    """Returns the symbol alone on the left that an earlier display defines, and this one for another case."""
    match claim.printed.statement:
        case Relation(left=Symbol(declaration=declaration)):
            name, line = written(declaration.name), claim.line or 0
            is_known = any(
                each.sure and each.symbol == name and each.line < line for each in draft.ingested.definitions
            )
            own = (each for each in draft.ingested.text.displays if each.line == line)
            is_case = any(_OTHER_CASE.search(each.before) for each in own)
            return name if is_known and is_case else None
    return None


def _is_given_before(draft: Draft, claim: Claim) -> bool:
    """True if an earlier formula defines the symbol alone on the left, and none restricts the others."""
    if any(fact.act is Act.CONSTRAIN and fact.content is not None for fact in claim.context.facts):
        return False
    own, line = subject_alone(claim), claim.line or 0
    name = written(own.declaration.name) if own is not None else ""
    given = (each for each in draft.ingested.definitions if each.sure and not each.in_sentence)
    return any(each.symbol == name and each.line < line for each in given)


def _of_other_place(claim: Claim) -> Iterator[str]:
    """Yields the function E of E(v) = …, where the text defines E(p): it may be the E as a function of v."""
    match claim.printed.statement:
        case Relation(left=Symbol(declaration=own, arguments=arguments) as left):
            for definition in claim.notation.definitions.about(left):
                pairs = zip(definition.parameters, arguments, strict=False)
                if any(isinstance(a, Symbol) and a.declaration.name != p.name for p, a in pairs):
                    yield written(own.name)


def _of_other_sections(draft: Draft, claim: Claim, names: Collection[str]) -> list[str]:
    """Returns those of the names that the draft defines in a section that does not contain the claim."""
    displays, own = draft.ingested.text.displays, display_of(claim, draft.ingested)
    defining = {display.line: display for display in reversed(displays)}
    known = (each for each in draft.ingested.definitions if each.sure and each.symbol in names)
    return list(dict.fromkeys(each.symbol for each in known if not _reaches(defining.get(each.line), own)))


def _reaches(definition: Display | None, place: Display | None) -> bool:
    """True if the section of a definition contains the place, or if a place is not known."""
    if definition is None or place is None or definition.source is not place.source:
        return True
    return sections_of(definition.source.prose).holds(definition.start, place.start)


@dataclass(frozen=True)
class Records:
    """The formulas of a text that hold with each symbol, and those that would be false.

    Attributes:
        true: Name → section → formulas.
        false: Name → formulas.
        values: Name → formulas that give its value or a power of it, and are not true.
    """

    draft: Draft
    true: Mapping[str, Mapping[str | None, frozenset[str]]]
    false: Mapping[str, frozenset[str]]
    values: Mapping[str, frozenset[str]]

    @staticmethod
    def of(draft: Draft, results: Sequence[ClaimResult]) -> Records:
        true: dict[str, dict[str | None, frozenset[str]]] = {}
        false: dict[str, frozenset[str]] = {}
        values: dict[str, frozenset[str]] = {}
        for result in results:
            claim, outcome = result.claim, result.verdict.outcome
            alone = subject_alone(claim)
            is_number = alone is not None and alone.type.kind == "scalar"
            if alone is not None and is_number and outcome not in (Outcome.PROVED, Outcome.CONDITIONAL):
                name = written(alone.declaration.name)
                values[name] = values.get(name, frozenset()) | {claim.printed.latex}
            if outcome in (Outcome.PROVED, Outcome.CONDITIONAL):
                for name in reached_names(claim):
                    own = true.setdefault(name, {})
                    section = claim.source.section
                    own[section] = own.get(section, frozenset()) | {claim.printed.latex}
            elif _is_warning(result):
                for name in names_of(claim):
                    false[name] = false.get(name, frozenset()) | {claim.printed.latex}
        return Records(draft, true, false, values)

    def doubted(self, result: ClaimResult) -> Verdict:
        """Returns the verdict with the guesses that are not borne out as doubts."""
        verdict, claim = result.verdict, result.claim
        if not _is_warning(result):
            return verdict
        inference, confirmed = self.draft.ingested.inference, self.draft.ingested.confirmed
        defined = {each.symbol for each in self.draft.ingested.definitions if each.sure}
        shared = [
            name
            for name in names_of(claim)
            if name not in inference.firm | confirmed | defined
            and len(self.false[name] - {claim.printed.latex})
            > sum(map(len, self.true.get(name, {}).values()))
        ]
        reached = reached_names(claim) - confirmed
        anew = [
            name
            for name in _of_other_sections(self.draft, claim, reached)
            if not any(claim.source.section in self.true.get(each, {}) for each in self._given_with(name))
        ]
        alone = subject_alone(claim)
        given = written(alone.declaration.name) if alone is not None else ""
        # beside this formula, one is the definition
        several = [each for each in (given, *sorted(reached & defined)) if len(self.values.get(each, ())) > 2]
        if shared and not (anew or several) and is_misprint(claim):
            shared = []
        names = (*shared, *anew, *several)
        doubts = dict.fromkeys(DoubtCode.SOMETHING_ELSE(name=name) for name in names)
        return replace(verdict, unless=(*verdict.unless, *list(doubts)[:_MOST_DOUBTS]))

    def _given_with(self, name: str) -> Iterator[str]:
        """Yields the symbols that the display with the definition of a symbol defines."""
        known = [each for each in self.draft.ingested.definitions if each.sure]
        lines = {each.line for each in known if each.symbol == name}
        yield from (each.symbol for each in known if each.line in lines)


def _is_warning(result: ClaimResult) -> bool:
    return result.verdict.outcome is Outcome.REFUTED and result.verdict.grade is Grade.WARNING


def _given_anew(draft: Draft, claim: Claim) -> list[str]:
    """Returns the symbols of a claim that the text gives anew between their definition and the claim.

    So does a matrix that stands in another section, or behind words on another case.
    """
    displays = draft.ingested.text.displays
    defined = {each.symbol: each for each in draft.ingested.definitions if each.sure}
    places = {id(display): index for index, display in enumerate(displays)}
    found = []
    for given in given_in(draft.ingested.formulas, places):
        known, display = defined.get(given.name), displays[given.place]
        if known is None or given.name not in reached_names(claim) or "matrix}" not in given.body:
            continue
        first = next((each for each in displays if each.line == known.line), display)
        is_elsewhere = (first.section, first.heading) != (display.section, display.heading)
        is_another_case = all(_CASE.search(each.before) for each in (first, display))
        if known.line < display.line <= (claim.line or 0) and (is_elsewhere or is_another_case):
            found.append(given.name)
    return found


def _unwritten_members(draft: Draft, claim: Claim) -> list[str]:
    """Returns the members of families in the definitions of a claim that the text never writes.

    α_2 in A_2 has its value by other means: in a table or in words.
    """
    statement, known = claim.printed.statement, definitions_of(claim)
    sides: list[Term] = []
    with suppress(IllFormed):
        sides = [expand(side, known) for side in sides_of(statement)] if statement is not None else []
    symbols = {part for side in sides for part in side.symbols() if part.index}
    members = {to_latex(each) for each in symbols if all(index.is_number for index in each.index)}
    if not members:
        return []
    written = "".join(latex_key(source.text) for source in draft.ingested.text.sources)
    return sorted(each for each in members if latex_key(each) not in written)


def _abbreviated_functions(claim: Claim) -> list[str]:
    r"""Returns c and s of c\theta s\psi, which may be the cosine and the sine."""
    before = letters_before_angles(claim.printed.latex)
    alone = {name for name in names_of(claim) if _PLAIN.sub("", flat(name)) in before}
    return sorted(alone) if before >= {"c", "s"} else []


def _has_frames(draft: Draft, claim: Claim) -> bool:
    """True if a claim has axes or points whose motion the draft does not know."""
    made = [name for name in symbols_of(claim) if name in claim.notation.framed]
    tables = (each.entries for each in draft.ingested.proposals if each.table == "frames")
    spins = [flat(key) for table in tables for key, phrase in table.items() if "angular" in phrase]
    return any(not any(flat(name.base) in key for key in spins) for name in made)


def _asked(verdict: Verdict, thin: Sequence[Thin]) -> Reason:
    kinds = " and ".join(f"{each.name} is a {kind_name(each.kind)}" for each in thin[:2])
    other = thin[0]
    return VerdictCode.NEEDED_ONCE(
        outcome=verdict.outcome, kinds=kinds, name=other.name, other=kind_name(other.other)
    )
