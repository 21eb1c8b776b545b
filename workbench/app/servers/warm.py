"""One text judged again and again in one process: for editors and assistants."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from workbench.app.commands.options import memory_of_verdicts
from workbench.source.toml.file_bytes import unsaved

if TYPE_CHECKING:
    from workbench.papers import Paper
    from workbench.papers.drafting.judged_draft import Draft
    from workbench.prover.results.claim_results import ClaimResult

#: Seconds for the search for a correction of one claim, where somebody waits.
SEARCH_SECONDS = 5.0


@dataclass(frozen=True)
class Judged:
    """A text, or a paper file, with its results. draft: the model that was drafted for it, if it has none."""

    paper: Paper
    results: Sequence[ClaimResult]
    draft: Draft | None = None


def judged_file(path: Path, buffers: Mapping[Path, str] | None = None, motions: bool = False) -> Judged:
    """The verdicts on a file; verdicts that are remembered are not found again.   buffers: files that read
    otherwise than on disk.   Raises PaperError."""
    from workbench.app.pipeline.judge_claims import judge_paper
    from workbench.papers import load_paper
    from workbench.papers.drafting.judged_draft import draft_of, needs_draft, on_drafted_kinds

    with unsaved(buffers or {}), memory_of_verdicts(True) as memory:
        paper, draft = load_paper(path, faults=[]), None
        if needs_draft(paper):
            draft = draft_of(path)
            paper = draft.paper
        results = judge_paper(paper, memory=memory, motions=motions, jobs=1)
        if draft is not None:
            results = on_drafted_kinds(draft, results)
    return Judged(paper, results, draft)


def with_corrections(judged: Judged, seconds: float = SEARCH_SECONDS) -> Judged:
    """The same with the corrections that a short search proves, as edits of the text."""
    from workbench.app.pipeline.result_proposals import with_proposals
    from workbench.papers.texts.text_paper import TextPaper
    from workbench.repair.author_edits import with_author_edits
    from workbench.repair.propose.search_limits import Limits

    with memory_of_verdicts(True) as memory:
        results = with_proposals(judged.results, Limits(seconds=seconds), memory=memory, beside_right=False)
    text = judged.paper.text if isinstance(judged.paper, TextPaper) else None
    return replace(judged, results=with_author_edits(results, text))
