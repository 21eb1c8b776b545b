"""Claims on matrices of n rows, whose n the text does not give: judged at other sizes, too."""

from __future__ import annotations

from collections.abc import Collection, Container, Mapping, Sequence
from dataclasses import replace

from workbench.app.pipeline.judge_claims import judge_paper
from workbench.app.pipeline.verdict_keys import Memory
from workbench.context.free_symbols import terms_of
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.paper_errors import PaperError
from workbench.core.terms import Symbol
from workbench.core.verdict import Outcome, Verdict
from workbench.papers.drafting.drafted_texts import Draft, draft_from
from workbench.papers.drafting.inference.kind_signatures import Kind
from workbench.papers.drafting.symbol_guesses import kind_of_model, open_kinds
from workbench.prover.results.claim_results import ClaimResult
from workbench.runtime import Budget

#: The sizes at which claims are judged again; the draft has the size 2, and twists have the size 6.
_OTHERS, _OF_TWISTS = "3", "6"
_FIT = frozenset({Outcome.ILL_FORMED})
_DECIDED = frozenset({Outcome.PROVED, Outcome.CONDITIONAL, Outcome.REFUTED}) | _FIT


def at_other_sizes(
    draft: Draft, results: Sequence[ClaimResult], budget: Budget | None = None, memory: Memory | None = None
) -> list[ClaimResult]:
    """Returns the results of a draft; what holds, fails or fits at one size n only is not judged."""
    kinds = open_kinds(draft.ingested.inference, draft.ingested.guesses)
    found = list(results)
    for size in (_OTHERS, _OF_TWISTS) if kinds else ():
        concerned = {
            each.claim.id
            for each in found
            if each.verdict.outcome in (_FIT if size == _OF_TWISTS else _DECIDED) and _uses(each, kinds)
        }
        again = _judged_at(size, draft, kinds, concerned, budget, memory) if concerned else {}
        found = [_agreed(each, again.get(each.claim.id), size) for each in found]
    return found


def at_one_size(draft: Draft, results: Sequence[ClaimResult]) -> list[ClaimResult]:
    """Returns the results that no judgement at another size can change."""
    kinds = open_kinds(draft.ingested.inference, draft.ingested.guesses)
    return [each for each in results if each.verdict.outcome not in _DECIDED or not _uses(each, kinds)]


def _judged_at(
    size: str,
    draft: Draft,
    kinds: Mapping[str, Kind],
    concerned: Collection[str],
    budget: Budget | None,
    memory: Memory | None,
) -> dict[str, Verdict]:
    """Returns the verdicts on these claims at another size; none if the draft has no such size."""
    guesses = draft.ingested.guesses
    larger = {name: replace(guesses[name], kind=kind_of_model(kind, size)) for name, kind in kinds.items()}
    try:
        paper = draft_from(replace(draft.ingested, guesses=guesses | larger)).paper
    except PaperError:
        return {}
    ids = sorted({each.id for each in paper.claims} & {*concerned})
    again = judge_paper(paper, ids, jobs=1, motions=False, budget=budget, memory=memory) if ids else []
    return {each.claim.id: each.verdict for each in again}


def _uses(result: ClaimResult, names: Container[str]) -> bool:
    statement = result.claim.printed.statement
    terms = terms_of(statement) if statement is not None else ()
    return any(isinstance(term, Symbol) and str(term.declaration.name) in names for term in terms)


def _agreed(result: ClaimResult, other: Verdict | None, size: str) -> ClaimResult:
    own = result.verdict
    if other is None or other.outcome is own.outcome:
        return result
    reason = VerdictCode.OF_ONE_SIZE(outcome=own.outcome, other=other.outcome, size=size)
    return replace(result, verdict=Verdict(Outcome.UNCHECKED, reason=reason, read_back=own.read_back))
