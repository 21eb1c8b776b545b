"""Texts under drafted models, for tests."""

from __future__ import annotations

from pathlib import Path

from workbench.app.pipeline.judge_claims import judge_paper
from workbench.papers.drafting.draft_model import ingest
from workbench.papers.drafting.drafted_texts import Draft, draft_from
from workbench.papers.drafting.judged_draft import on_drafted_kinds
from workbench.prover.results.claim_results import ClaimResult


def draft_of(path: Path) -> Draft:
    """Returns a text under a drafted model. Raises PaperError."""
    return draft_from(ingest(path))


def judged_draft_of(path: Path) -> list[ClaimResult]:
    """Returns the results of a text under a drafted model. Raises PaperError."""
    draft = draft_of(path)
    return on_drafted_kinds(draft, judge_paper(draft.paper, motions=False))
