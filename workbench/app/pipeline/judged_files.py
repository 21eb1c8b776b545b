"""The steps from a file to its verdicts, once or repeatedly in one process."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from workbench.app.pipeline.verdict_memory import memory_of_verdicts
from workbench.source.toml.file_bytes import unsaved, within

if TYPE_CHECKING:
    from workbench.app.pipeline.verdict_keys import Memory
    from workbench.papers import Paper
    from workbench.papers.drafting.drafted_texts import Draft
    from workbench.papers.drafting.questions_to_author import Answer
    from workbench.prover.results.claim_results import ClaimResult
    from workbench.runtime import Budget

#: Seconds for the search for a correction of one claim in interactive use.
SEARCH_SECONDS = 5.0


@dataclass(frozen=True)
class Loaded:
    """A text, or a paper file. draft: the model that was drafted for it, if it has none."""

    paper: Paper
    draft: Draft | None = None

    def judged(
        self, results: Sequence[ClaimResult], budget: Budget | None = None, memory: Memory | None = None
    ) -> Judged:
        """Returns the results with the basis that the kinds of the draft have.

        budget, memory: of judgements at other sizes."""
        from workbench.app.pipeline.open_sizes import at_other_sizes
        from workbench.papers.drafting.judged_draft import on_drafted_kinds

        if self.draft is None:
            return Judged(self.paper, list(results))
        own = at_other_sizes(self.draft, on_drafted_kinds(self.draft, results), budget, memory)
        return Judged(self.paper, own, self.draft)

    def at_once(self, results: Sequence[ClaimResult]) -> Judged:
        """Returns the first results, before the others are ready; without those that are to be judged at
        other sizes."""
        from workbench.app.pipeline.open_sizes import at_one_size
        from workbench.papers.drafting.judged_draft import on_drafted_kinds

        order = {claim.id: place for place, claim in enumerate(self.paper.claims)}
        results = sorted(results, key=lambda result: order[result.claim.id])
        if self.draft is None:
            return Judged(self.paper, results)
        return Judged(self.paper, at_one_size(self.draft, on_drafted_kinds(self.draft, results)), self.draft)


@dataclass(frozen=True)
class Judged:
    """A text or a paper file with its results. draft: as in `Loaded`. answers: those that it has."""

    paper: Paper
    results: list[ClaimResult]
    draft: Draft | None = None
    answers: tuple[Answer, ...] = ()


def loaded_file(path: Path, memory: Memory | None = None, answers: Sequence[Answer] = ()) -> Loaded:
    """Returns a file as it is read; a text without a model, under a drafted one.   answers: of its author to
    the questions of the draft.   Raises PaperError."""
    from workbench.papers import load_paper
    from workbench.papers.drafting.drafted_texts import draft_from, newest_draft, undeclared_text
    from workbench.papers.drafting.questions_to_author import answered

    if (text := undeclared_text(path)) is None:
        return Loaded(load_paper(path, faults=[], store=memory))
    draft = newest_draft(text, memory)
    if answers:
        found = draft.ingested
        for answer in answers:
            found = answered(found, answer)
        draft = draft_from(found)
    return Loaded(draft.paper, draft)


def judged_file(
    path: Path,
    buffers: Mapping[Path, str] | None = None,
    motions: bool = False,
    answers: Sequence[Answer] = (),
    progress: Callable[[Loaded, ClaimResult], None] = lambda loaded, result: None,
    folder: Path | None = None,
) -> Judged:
    """Returns the verdicts on a file. Raises PaperError.

    buffers: contents of files that are not saved.
    progress: called with the loaded file and each result as soon as it is ready.
    folder: no file outside of it is read.
    """
    from workbench.app.pipeline.judge_claims import judge_paper

    with unsaved(buffers or {}), within(folder), memory_of_verdicts(True) as memory:
        loaded = loaded_file(path, memory, answers)
        results = judge_paper(loaded.paper, (), partial(progress, loaded), 1, memory=memory, motions=motions)
        return replace(loaded.judged(results, memory=memory), answers=tuple(answers))


def with_corrections(
    judged: Judged, seconds: float = SEARCH_SECONDS, found: Callable[[], None] = lambda: None
) -> Judged:
    """Returns the results with the corrections that a short search proves, as edits of the text.

    found: called after each search; an exception of it ends the other searches.
    """
    from workbench.app.pipeline.result_proposals import with_proposals
    from workbench.papers.texts.text_paper import TextPaper
    from workbench.repair.propose.search_limits import Limits

    text = judged.paper.text if isinstance(judged.paper, TextPaper) else None
    with memory_of_verdicts(True) as memory:
        limits = Limits(seconds=seconds)
        results = with_proposals(
            judged.results, limits, lambda _: found(), memory, beside_right=False, text=text
        )
    return replace(judged, results=results)
