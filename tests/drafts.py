"""Texts under drafted models, for tests."""

from __future__ import annotations

from pathlib import Path

from workbench.papers.drafting.draft_model import ingest
from workbench.papers.drafting.drafted_texts import Draft, draft_from


def draft_of(path: Path) -> Draft:
    """Returns a text under a drafted model. Raises PaperError."""
    return draft_from(ingest(path))
