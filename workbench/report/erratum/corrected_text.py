"""The errata as a patch of the text: each edit at its position, in the author's own characters."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from workbench.core.spans import Span
from workbench.prover.results.claim_results import ClaimResult
from workbench.report.claim_states import fault_of
from workbench.source.documents.source_edits import Replacement, applied, patch_of

#: The author's faults; a fault of the transcription is correct in print.
FAULTS = ("error", "warning", "misprint", "wording")

_NEWLINE = re.compile(r"\r\n?|\n")
_IGNORED = re.compile(r"\s|&|\\(?:left|right|quad|qquad|displaystyle)(?![A-Za-z])")


def errata_diff(text: str, name: str, results: Sequence[ClaimResult]) -> str:
    """Returns a unified diff of the text; empty if there is nothing to correct, or no edit could be
    placed."""
    return patch_of(text, applied(text, dict.fromkeys(replacements(text, results))), name)


def replacements(text: str, results: Sequence[ClaimResult]) -> Iterator[Replacement]:
    """Yields the proved corrections of the author's faults, at their positions in the text."""
    squeezed = _Squeezed(text)
    read = text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
    lines = [len(text) - len(text.removeprefix("\ufeff")), *(end.end() for end in _NEWLINE.finditer(text))]
    for result in results:
        if fault_of(result) not in FAULTS:
            continue
        span = result.claim.context.span
        bounds = (0, len(text))
        if span is not None and span.end_line <= len(lines):
            bounds = _bounds(span, lines)
        if result.claim.mend.edits:
            yield from _of_edits(squeezed, result, bounds)
        elif result.edits:
            own = (edit for edit in result.edits if edit.source.text == read)
            yield from (Replacement(*_bounds(edit.span, lines), edit.new) for edit in own)


def _bounds(span: Span, lines: Sequence[int]) -> tuple[int, int]:
    """Returns the character range of the span. lines: the offset of each line."""
    return lines[span.line - 1] + span.column - 1, lines[span.end_line - 1] + span.end_column - 1


def _of_edits(text: _Squeezed, result: ClaimResult, bounds: tuple[int, int]) -> Iterator[Replacement]:
    """Yields the edits, each within the printed formula or the passage next to it."""
    claim = result.claim
    around = [claim.shown or "", claim.sentence.quote or "", claim.mend.beside or "", claim.printed.latex]
    for edit in claim.mend.edits:
        for passage in filter(None, around):
            if edit.old in passage and (place := text.within(passage, edit.old, bounds)) is not None:
                yield Replacement(*place, edit.new.strip() if edit.old == edit.old.strip() else edit.new)
                break


class _Squeezed:
    """A text without characters that do not matter in a formula: white space, alignment, sizes of
    brackets."""

    def __init__(self, text: str) -> None:
        self.places: list[int] = []
        kept: list[str] = []
        at = 0
        while at < len(text):
            ignored = _IGNORED.match(text, at)
            if ignored is None:
                kept.append(text[at])
                self.places.append(at)
            at = ignored.end() if ignored else at + 1
        self.text = "".join(kept)

    def within(self, passage: str, old: str, bounds: tuple[int, int]) -> tuple[int, int] | None:
        """Returns the range of `old` in the passage, if the passage occurs once within the bounds."""
        around, inner = _squeezed(passage.strip("“”$.,; ")), _squeezed(old)
        inside = around.find(inner)
        found = [at for at in _all(self.text, around) if bounds[0] <= self.places[at] < bounds[1]]
        if len(found) != 1 or inside < 0 or not inner:
            return None
        start = found[0] + inside
        return self.places[start], self.places[start + len(inner) - 1] + 1


def _squeezed(text: str) -> str:
    return _IGNORED.sub("", text)


def _all(text: str, part: str) -> Iterator[int]:
    at = text.find(part) if part else -1
    while at >= 0:
        yield at
        at = text.find(part, at + 1)
