"""The first verdicts on a changed text, under the newest model that still fits it.

Only what a change touches is read and judged. The whole text is read and judged again behind it: that counts,
and takes the verdicts from the cache whose claims it reads alike.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from workbench.app.pipeline.judged_files import Judged, Loaded
from workbench.app.pipeline.verdict_memory import memory_of_verdicts
from workbench.source.toml.file_bytes import unsaved, within

if TYPE_CHECKING:
    from workbench.context.claims import Notation
    from workbench.papers.drafting.drafted_texts import Draft
    from workbench.papers.drafting.questions_to_author import Answer
    from workbench.papers.texts.changed_text import ChangedText
    from workbench.papers.texts.text_paper import TextPaper
    from workbench.prover.results.claim_results import ClaimResult
    from workbench.source.documents import Text


@dataclass(frozen=True)
class Changed:
    """A changed text with its last results, of which those that stand are shown where they stand now."""

    before: Judged
    changed: ChangedText
    draft: Draft | None

    def judged(self, results: Sequence[ClaimResult]) -> Judged:
        """Returns the standing results, and the given ones of new claims that the whole text cannot change
        by its size."""
        loaded = Loaded(self.changed.paper, self.draft)
        own = {result.claim.id: result for result in loaded.at_once(results).results}
        stood = {result.claim.id: result for result in self.before.results}
        made = []
        for claim in self.changed.paper.claims:
            if claim.id in own and claim.printed.unread is None:
                made.append(own[claim.id])
            elif claim.id in stood and claim.id not in self.changed.new:
                made.append(replace(stood[claim.id], claim=claim, edits=(), edited=None))
        return Judged(self.changed.paper, made, self.draft)


def first_verdicts(
    path: Path,
    before: Judged,
    buffers: Mapping[Path, str],
    motions: bool,
    answers: Sequence[Answer],
    seen: Callable[[Judged], None],
    folder: Path | None,
) -> None:
    """Judges what has changed of a text, and calls `seen` with the results after each verdict.

    It does nothing if the text has to be read as a whole first. before: the last results of the whole text.
    """
    from workbench.app.pipeline.judge_claims import judge_paper
    from workbench.core.paper_errors import PaperError

    with unsaved(buffers), within(folder), memory_of_verdicts(True) as memory:
        try:
            changed = _changed(path, before, answers)
        except PaperError:
            return
        if changed is None:
            return
        results: list[ClaimResult] = []

        def told(result: ClaimResult) -> None:
            results.append(result)
            seen(changed.judged(results))

        seen(changed.judged(()))
        new = changed.changed.new
        if new:
            judge_paper(changed.changed.paper, new, told, 1, memory=memory, motions=motions)


def _changed(path: Path, before: Judged, answers: Sequence[Answer]) -> Changed | None:
    from workbench.papers.drafting.drafted_texts import undeclared_text
    from workbench.papers.texts.load_texts import text_of_model
    from workbench.papers.texts.text_paper import TextPaper

    paper = before.paper
    if not isinstance(paper, TextPaper) or paper.text is None or paper.text.directives or paper.faults:
        return None
    if before.draft is None:
        text = text_of_model(paper)
        return None if text is None else _of_text(before, paper, text, None)
    text = undeclared_text(path)
    if text is None:
        return None
    if tuple(answers) != before.answers:
        return _under_answers(path, before, paper, text, answers)
    return _of_draft(before, paper, text)


def _of_draft(before: Judged, paper: TextPaper, text: Text) -> Changed | None:
    """Returns a changed text under its draft; None if its brackets are others."""
    from workbench.papers.drafting.draft_model import with_fences

    assert before.draft is not None and paper.text is not None
    found = before.draft.ingested
    text, fences = with_fences(text, found.macros)
    if fences != found.fences:
        return None
    return _of_text(before, paper, text, before.draft)


def _of_text(before: Judged, paper: TextPaper, text: Text, draft: Draft | None) -> Changed | None:
    """Returns a changed text; None if no display changed, or one with which a scope begins."""
    from workbench.papers.texts.changed_text import (
        changed_text,
        kept_displays,
        notation_before,
        without_definitions,
    )

    assert paper.text is not None
    old = paper.text.displays
    kept = kept_displays(paper.text, text)
    gone = [display for place, display in enumerate(old) if place not in {*kept.values()}]
    if len(kept) == len(text.displays) and not gone:
        return None
    undone: set[str] = set()
    if draft is not None:
        lines = {display.line for display in gone}
        if any(scope.display.line in lines for scope in draft.ingested.scopes):
            return None
        undone = {each.symbol for each in draft.ingested.definitions if each.line in lines}
    nearest = notation_before(paper, kept)
    notations: dict[int, Notation] = {}

    def notation(index: int) -> Notation:
        found = nearest(index)
        return notations.setdefault(id(found), without_definitions(found, undone))

    made = changed_text(paper, text, kept, notation)
    return None if made is None else Changed(before, made, draft and replace(draft, paper=made.paper))


def _under_answers(
    path: Path, before: Judged, paper: TextPaper, text: Text, answers: Sequence[Answer]
) -> Changed | None:
    """Returns an unchanged text under other answers; None if its whole draft has to be made again."""
    from workbench.papers.drafting.drafted_texts import Draft
    from workbench.papers.drafting.model_file import loaded_model
    from workbench.papers.drafting.questions_to_author import answered
    from workbench.papers.texts.changed_text import changed_text, touched_displays

    assert before.draft is not None and paper.text is not None
    old = {(each.table, each.key) for each in before.answers}
    new = [each for each in answers if each not in before.answers]
    is_same = [source.text for source in text.sources] == [source.text for source in paper.text.sources]
    if not is_same or old - {(each.table, each.key) for each in answers}:
        return None
    if any(each.table not in ("symbols", "definitions") for each in new):
        return None
    found = before.draft.ingested
    for answer in new:
        found = answered(found, answer)
    names = {each.symbol for each in new}
    kept_scopes = replace(found, scopes=list(before.draft.scopes))
    _, model, scopes = loaded_model(kept_scopes, path.with_suffix(".toml"), is_confirmed=True)
    notations = model.notations()

    def notation(index: int) -> Notation:
        return [made for start, made in notations if start <= index][-1]

    touched = touched_displays(paper, names)
    kept = {place: place for place in range(len(paper.text.displays)) if place not in touched}
    made = changed_text(paper, paper.text, kept, notation)
    return None if made is None else Changed(before, made, Draft(found, made.paper, scopes))
