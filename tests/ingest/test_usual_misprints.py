"""First formulas against what words say: a misprint is a warning, a right formula none."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.drafts import draft_of
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Grade, Outcome
from workbench.papers.drafting.judged_draft import on_drafted_kinds

_TURNS = (
    r"The elementary rotations are $$\begin{{aligned}} A &= \begin{{bmatrix}} \cos a & -\sin a \\ \sin a & \cos a"
    r" \end{{bmatrix}} \\ B &= \begin{{bmatrix}} \cos b & \sin b \\ {} & \cos b \end{{bmatrix}} \end{{aligned}}$$"
)

#: A text, and the formulas that are warnings, by a part of each; none if all are right.
TEXTS = [
    # several rotations
    (_TURNS.format(r"-\sin b"), []),
    (_TURNS.format(r"\sin b"), ["B ="]),
]


@pytest.mark.parametrize(("text", "wrong"), TEXTS)
def test_warnings_are_the_misprints(text: str, wrong: list[str], tmp_path: Path) -> None:
    path = tmp_path / "text.md"
    path.write_text(text.replace("$$ ", "$$\n\n").replace(" $$", "\n\n$$").replace("$$$$", "$$\n\n$$"))
    draft = draft_of(path)
    results = on_drafted_kinds(draft, judge_paper(draft.paper, motions=False))
    false = [r for r in results if r.verdict.outcome in (Outcome.REFUTED, Outcome.ILL_FORMED)]
    warned = [r.claim.printed.latex for r in false if r.verdict.grade in (Grade.WARNING, Grade.ERROR)]
    assert len(warned) == len(wrong)
    assert all(
        part.replace(" ", "") in latex.replace(" ", "") for part, latex in zip(wrong, warned, strict=True)
    )
