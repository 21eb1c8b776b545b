"""With the memory cold, warm, shared or off, in any order, in one process or two: the same results."""

from __future__ import annotations

from pathlib import Path
from random import Random

import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

from tests.context import generated_texts as texts
from tests.context.generated_texts import Piece
from workbench.app.pipeline.judge_claims import PaperJudge
from workbench.app.pipeline.verdict_keys import Memory
from workbench.context.claims import Paper
from workbench.papers import load_paper

CAMPAIGN = [1, pytest.param(100, marks=pytest.mark.slow)]


def results_of(paper: Paper, memory: Memory | None, jobs: int = 1, seed: int | None = None) -> dict[str, str]:
    """Returns all that is found, as text. seed: of the order in which the claims are judged."""
    claims = list(paper.claims)
    if seed is not None:
        Random(seed).shuffle(claims)
    judge = PaperJudge(paper, memory=memory, motions=False)
    try:
        found = {result.claim.id: str(result.verdicts) for result in judge.results(claims, jobs)}
    finally:
        judge.close()
    return dict(sorted(found.items()))


@pytest.mark.parametrize("number", CAMPAIGN)
def test_memory_and_order_and_processes_change_no_result(tmp_path: Path, number: int) -> None:
    shared = Memory(tmp_path / "shared.sqlite")

    def law(pieces: list[Piece], seed: int) -> None:
        (tmp_path / "p.md").write_text(texts.lettered(texts.text_of(pieces), texts.PLAIN))
        (tmp_path / "p.toml").write_text(texts.model_of())
        paper = load_paper(tmp_path / "p.toml", faults=[])
        off = results_of(paper, None)
        assert results_of(paper, None, seed=seed) == off
        assert results_of(paper, shared, jobs=2, seed=seed) == off
        assert results_of(paper, shared) == off
        assert results_of(load_paper(tmp_path / "p.toml", faults=[]), shared, seed=seed + 1) == off

    law([texts.WHOLE[11], texts.FORMULAS[0], texts.WHOLE[11], *texts.WHOLE[:5]], 1)
    quiet = settings(max_examples=number, phases=(Phase.generate,))
    quiet(given(texts.texts, st.integers(0, 99))(law))()
    shared.close()
