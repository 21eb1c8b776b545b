"""Each display of a text has the verdict that is marked behind it."""

from __future__ import annotations

from itertools import zip_longest
from pathlib import Path

import pytest

from tests.texts.marked_texts import MarkedText, marked_texts
from tests.texts.written import doubts, paper_of, told
from workbench.app.pipeline.judge_claims import judge_paper

TEXTS = list(marked_texts())


def faults_of(text: MarkedText, folder: Path) -> list[str]:
    """Returns what is not as the marks say."""
    paper = paper_of(folder, text.text, f"source = 'p.md'\n{text.model}", "md")
    faults = [str(fault) for fault in paper.faults]
    results = judge_paper(paper, motions=False, jobs=1)
    spans = [result.claim.context.span for result in results]
    lines = [span.line if span else 0 for span in spans]
    for result, mark, line, below in zip_longest(results, text.marks, lines, lines[1:]):
        if result is None or mark is None:
            faults.append("one mark for each claim expected")
            break
        if not line <= mark.line < (below if below not in (None, line) else mark.line + 1):
            faults.append(f"the mark of line {line} expected behind it, got it behind line {mark.line}")
        found, words = told(result.verdict), doubts(result.verdict)
        if found != mark.told or mark.words not in words:
            faults.append(f"line {line}: expected {mark.told}: {mark.words}, got {found}: {words}")
    return faults


@pytest.mark.parametrize("text", TEXTS, ids=lambda text: text.name)
def test_displays_have_the_verdicts_of_their_marks(text: MarkedText, tmp_path: Path) -> None:
    assert faults_of(text, tmp_path) == []


def test_wrong_missing_and_misplaced_marks_are_found(tmp_path: Path) -> None:
    text = next(text for text in TEXTS if len(text.marks) > 1)
    first, *others = text.marks
    wrong = [
        [first._replace(told="argued"), *others],
        others,
        [first._replace(words="no such words"), *others],
    ]
    for marks in [*wrong, [first._replace(line=others[-1].line), *others]]:
        assert faults_of(text._replace(marks=marks), tmp_path)


def test_each_file_has_texts_and_all_displays_have_marks() -> None:
    assert TEXTS and all(text.marks and text.model for text in TEXTS)
