"""Formulas of a text that are one usual misprint away from a standard formula."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache, partial
from itertools import chain

from workbench.core import construct
from workbench.core.codes.context_codes import ContextCode
from workbench.core.codes.doubt_codes import DoubtCode
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.operations import PARTIALS
from workbench.core.terms import Apply, IllFormed, Relation, Symbol, Term
from workbench.core.types import Declaration
from workbench.core.verdict import Grade, Outcome, Strength, Verdict
from workbench.language.definitions import Definitions, replaced
from workbench.language.printing.printer import to_latex
from workbench.papers.drafting.draft_model import Ingested
from workbench.papers.drafting.drafted_texts import Draft
from workbench.papers.drafting.formulary.comparison import misprint_of, renamings
from workbench.papers.drafting.formulary.normal_sums import Sum, TooLong, equation_sum, leaves_of
from workbench.papers.drafting.formulary.renamings import Renaming, letter_of
from workbench.papers.drafting.formulary.standard_formulas import (
    LONG,
    StandardFormula,
    profile_of,
    standard_formulas,
)
from workbench.papers.drafting.meanings.contradictions import Contradiction, display_of
from workbench.papers.texts.text_paper import TextPaper
from workbench.prover.decide.decide import Judge
from workbench.prover.explain.decide_under_facts import judged_or_unchecked
from workbench.prover.results.claim_results import ClaimResult
from workbench.source.documents.condition_words import APPROXIMATES, DENIES, in_last_sentence

#: A formula with fewer symbols needs all its letters, and its words within so many characters before it.
_SMALL, _BEFORE = 5, 600
#: A formula with fewer symbols and addends needs the letter of its left side.
_LARGE = 11
#: The share of its letters that a formula needs, by the count of its symbols and addends.
_SHARES = ((LONG, Fraction(0)), (_LARGE, Fraction(3, 5)), (0, Fraction(3, 4)))
#: The words before a formula that is none of the standard formulas.
_OTHER = in_last_sentence(DENIES, APPROXIMATES, "derivative")
#: Operations that an abbreviation of a letter stands for.
_ABBREVIATED = frozenset({"sin", "cos", "skew"})


def with_standard_formulas(draft: Draft, results: Sequence[ClaimResult]) -> list[ClaimResult]:
    """Returns the results, where a formula that nothing decides is false if it is near a standard formula."""
    is_open = {each.claim.id for each in results if _is_open(each.verdict)}
    found = dict(near_standard_formulas(draft.ingested, draft.paper, is_open))
    return [
        replace(each, verdict=_refuted(each.verdict, *found[each.claim.id]))
        if each.claim.id in found
        else each
        for each in results
    ]


def _is_open(verdict: Verdict) -> bool:
    is_told = verdict.grade in (Grade.ERROR, Grade.WARNING)
    return verdict.outcome in (Outcome.DEFINITION, Outcome.REFUTED, Outcome.UNCHECKED) and not is_told


def _refuted(verdict: Verdict, other: Contradiction, standard: StandardFormula) -> Verdict:
    """Returns the verdict under a standard formula, if it refutes the printed one."""
    judge = Judge(other.known)
    found = judged_or_unchecked(partial(judge.judge, other.statement, other.assume))
    if found.outcome is not Outcome.REFUTED:
        return verdict
    unless = (DoubtCode.OTHER_QUANTITY(name=standard.name),)
    basis = min(found.basis, Strength.HINTED)
    return replace(found, reason=other.reason, read_back=verdict.read_back, basis=basis, unless=unless)


def near_standard_formulas(
    ingested: Ingested, paper: TextPaper, wanted: Collection[str]
) -> Iterator[tuple[str, tuple[Contradiction, StandardFormula]]]:
    """Yields the formulas that differ from a standard formula by names and one usual misprint.

    Those that differ from another standard formula by names alone are right.   wanted: ids of claims.
    """
    prose = "\n".join(source.prose for source in ingested.text.sources).lower()
    statements = {each.id: each.printed.statement for each in paper.claims}
    for claim in (each for each in paper.claims if each.id in wanted):
        said, display = claim.printed.statement, display_of(claim, ingested)
        if not isinstance(said, Relation) or said.operator != "=" or display is None:
            continue
        first = statements[claim.chain[0]] if claim.chain else None
        said = Relation("=", first.left if isinstance(first, Relation) else said.left, said.right)
        in_full = _in_full(said, claim.notation.definitions)
        before = display.source.prose[max(0, display.start - _BEFORE) : display.start].lower()
        if _OTHER.search(before):
            continue
        if (found := _nearest(said, in_full, prose, before)) is not None:
            with suppress(IllFormed):
                yield claim.id, (_contradiction(claim.id, in_full, *found), found[0])


@lru_cache(maxsize=8)
def _usual_in(prose: str) -> tuple[StandardFormula, ...]:
    """Returns the formulas whose words stand in a text."""
    by_words = {each.words: each for each in standard_formulas()}
    said = {words for words, each in by_words.items() if each.is_meant_in(prose)}
    return tuple(each for each in standard_formulas() if each.words in said)


@lru_cache(maxsize=1 << 12)
def _nearest(
    said: Relation, in_full: Relation, prose: str, before: str
) -> tuple[StandardFormula, Renaming] | None:
    """Returns the standard formula that a printed one is a misprint of; None if it is another one."""
    if _is_negative(said.left):
        return None
    sums: list[Sum] = []
    with suppress(TooLong, ZeroDivisionError):
        sums = list(dict.fromkeys(map(equation_sum, (said, in_full))))
    equal = [each for own in sums for each in _equal_to(own, prose)]
    if equal:
        return _exchanged(equal)
    return next(chain.from_iterable(_misprints_in(own, prose, before) for own in sums), None)


def _exchanged(equal: Sequence[tuple[StandardFormula, Renaming]]) -> tuple[StandardFormula, Renaming] | None:
    """Returns the standard formula with the names of a printed one, which has them exchanged.

    So is p v - q u that of q u - p v, and m/L (l_f/C_f - l_r/C_r) that with l_r and l_f."""
    kept = max(found.kept for _, found in equal)
    for each, found in equal:
        if found.common > kept and (right := found.without_exchange()) is not None:
            return each, right
    return None


def _misprints_in(own: Sum, prose: str, before: str) -> Iterator[tuple[StandardFormula, Renaming]]:
    """Yields the formulas that a printed one is a misprint of."""
    letters = {letter_of(leaf.base) for leaf in leaves_of(own)}
    profile = profile_of(own)
    for each in _usual_in(prose):
        if each.profile.may_be(profile) and each.may_keep_letters(letters):
            found = misprint_of(each.sum, own, each.left, each.size < _SMALL)
            if found is not None and _is_likely(each, found, before):
                yield each, found


def _equal_to(own: Sum, prose: str) -> Iterator[tuple[StandardFormula, Renaming]]:
    """Yields the formulas of which renamings make a printed one."""
    profile = profile_of(own)
    for each in _usual_in(prose):
        if each.profile.may_be(profile):
            yield from ((each, found) for found in renamings(each.sum, own, each.size < _SMALL))


def _is_negative(own: Term) -> bool:
    return isinstance(own, Apply) and own.head == "neg"


def _is_likely(standard: StandardFormula, found: Renaming, before: str) -> bool:
    """True if a printed formula can hardly be another one by chance. before: the words before it."""
    if standard.size < _SMALL:
        return len(found.letters) > 1 and standard.is_meant_in(before)
    own = standard.statement.left
    if standard.weight < _LARGE and own in found.of and letter_of(own) != letter_of(found.of[own][0]):
        return False
    return found.alike >= next(share for least, share in _SHARES if standard.weight >= least)


def _in_full(said: Relation, definitions: Definitions) -> Relation:
    """Returns an equation with the sine or cosine for each symbol that is defined as one."""

    def change(part: Symbol) -> Term | None:
        body = definitions.lookup(part)
        return body if isinstance(body, Apply) and body.head in _ABBREVIATED else None

    return Relation(said.operator, replaced(said.left, change), replaced(said.right, change))


def _contradiction(
    claim: str, printed: Relation, standard: StandardFormula, found: Renaming
) -> Contradiction:
    """Returns what would hold if the printed formula did. Raises IllFormed."""
    own = standard.statement
    right = Relation("=", _renamed(own.left, found), _renamed(own.right, found))
    formula = f"${to_latex(right)}$"
    reason = ContextCode.UNUSUAL(name=standard.name, formula=formula, source=standard.entry.source)
    right, printed = _with_free_symbols(right), _with_free_symbols(printed)
    if right.left == printed.left:
        both = construct.relation("=", right.right, printed.right)
        return Contradiction(claim, both, (), Definitions(), reason)
    return Contradiction(claim, printed, (right,), Definitions(), reason)


def _with_free_symbols(said: Relation) -> Relation:
    """Returns an equation with a symbol of its own for each member of a family, function and partial
    derivative. Raises IllFormed."""

    def change(term: Term) -> Term:
        is_family = isinstance(term, Symbol) and (term.index or term.arguments)
        if is_family or (isinstance(term, Apply) and term.head in PARTIALS):
            return construct.symbol(Declaration(Name(to_latex(term)), term.type))
        return construct.with_children(term, change)

    return Relation(said.operator, change(said.left), change(said.right))


def _renamed(term: Term, found: Renaming) -> Term:
    def change(part: Symbol) -> Term | None:
        base, order = found.of.get(part, (part, 0))
        return construct.derivative(base, Linear(order)) if order else base

    return replaced(term, change)
