"""A refutation stands when its explanation has used up its processor time."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from tests.context.judged_texts import FALSE, TRUE, model, text_of
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.verdict import Grade, Outcome
from workbench.papers import load_paper
from workbench.prover.explain.decide_under_facts import Decider, OutOfDecisions
from workbench.runtime import STANDARD


def test_endless_explanation_leaves_the_refutation(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def endless(*_: Any, **__: Any) -> bool:
        while True:
            pass

    monkeypatch.setattr(Decider, "holds", endless)
    (tmp_path / "p.md").write_text(text_of([*FALSE[:2], *TRUE[:2]]), encoding="utf-8")
    (tmp_path / "p.toml").write_text(model(), encoding="utf-8")
    paper = load_paper(tmp_path / "p.toml", faults=[])
    budget = replace(STANDARD, seconds=1.0)
    results = judge_paper(paper, motions=False, jobs=1, budget=budget)
    assert [each.verdict.outcome for each in results] == [Outcome.REFUTED] * 2 + [Outcome.PROVED] * 2
    assert {each.verdict.grade for each in results[:2]} == {Grade.WARNING}
    assert all("not tried" in each.verdict.unless[0] for each in results[:2])


def test_second_law_that_is_not_compared_in_time_is_told_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def too_long(*_: Any, **__: Any) -> bool:
        raise OutOfDecisions

    monkeypatch.setattr(Decider, "holds", too_long)
    (tmp_path / "p.md").write_text("$$ \\dot{f} = f g $$\n\nand\n\n$$ \\dot{f} = f h $$\n", encoding="utf-8")
    (tmp_path / "p.toml").write_text("source = 'p.md'\n[symbols]\nf = 'scalar'\ng = 'scalar'\nh = 'scalar'\n")
    first, second = judge_paper(load_paper(tmp_path / "p.toml"), motions=False, jobs=1)
    assert first.verdict.outcome is Outcome.DEFINITION
    assert (second.verdict.outcome, second.verdict.code) == (Outcome.UNCHECKED, VerdictCode.LAW_NOT_COMPARED)
    assert r"\dot{f}" in (second.verdict.reason or "") and "nothing here defines" not in (
        second.verdict.reason or ""
    )
