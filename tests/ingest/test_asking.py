"""Questions that drafts leave open, with their answers as lines of the model; `check --ask` on a terminal."""

from __future__ import annotations

import os
import pty
import subprocess
import sys
import tomllib
from pathlib import Path

from tests.drafts import draft_of
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Grade, Outcome
from workbench.papers.drafting.drafted_texts import Draft, draft_from
from workbench.papers.drafting.judged_draft import on_drafted_kinds
from workbench.papers.drafting.questions_to_author import answered, questions_about
from workbench.prover.results.claim_results import ClaimResult

OPEN = "$$ 2 a + a = 3 a $$\n\n$$ \\mathbf{f} \\times a = 2 \\mathbf{f} \\times a $$\n"


def judged(draft: Draft) -> list[ClaimResult]:
    return on_drafted_kinds(draft, judge_paper(draft.paper, motions=False))


def opened(tmp_path: Path) -> Draft:
    path = tmp_path / "p.md"
    path.write_text(OPEN)
    return draft_of(path)


def test_a_thin_kind_is_asked_for_with_the_lines_that_answer(tmp_path: Path) -> None:
    draft = opened(tmp_path)
    (question,) = questions_about(draft, judged(draft))
    assert (question.line, question.settles) == (3, ("L3",))
    assert question.answers[0].lines == ("[symbols]", "'a' = \"vector\"")
    assert str(question) == "What is a? (line 3; decides 1 equation)"


def test_an_answer_settles_what_it_says_that_it_settles(tmp_path: Path) -> None:
    draft = opened(tmp_path)
    (question,) = questions_about(draft, judged(draft))
    after = draft_from(answered(draft.ingested, question.answers[0]))
    last = judged(after)[-1]
    assert (last.verdict.outcome, last.shown) == (Outcome.REFUTED, Grade.WARNING)
    assert questions_about(after, judged(after)) == []


def test_an_answer_about_a_primed_letter_is_taken(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text("$$ 2 a' + a' = 3 a' $$\n\n$$ \\mathbf{f} \\times a' = 2 \\mathbf{f} \\times a' $$\n")
    draft = draft_of(path)
    (question,) = questions_about(draft, judged(draft))
    after = answered(draft.ingested, question.answers[0])
    assert after.confirmed == {"a'"} and after.guesses.keys() == draft.ingested.guesses.keys()
    assert judged(draft_from(after))[-1].verdict.outcome is Outcome.REFUTED


def test_a_point_is_asked_for_once(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text(
        "$$ {}^A v^{P} \\times {}^A v^{Q} = 2 {}^A v^{P} \\times {}^A v^{Q} $$\n\n"
        "$$ {}^A v^{P} = 2 {}^B v^{P} + 3 {}^B v^{P} - {}^A v^P $$\n"
    )
    draft = draft_of(path)
    question, *_ = questions_about(draft, judged(draft))
    assert question.answers[0].lines == ("[points]", "fixed = { 'P' = 'B' }")
    after = draft_from(answered(draft.ingested, question.answers[0]))
    assert question.text not in {each.text for each in questions_about(after, judged(after))}


def test_a_paper_that_is_judged_is_asked_nothing() -> None:
    draft = draft_of(Path(__file__).parent / "papers" / "two_link_arm.tex")
    assert questions_about(draft, judged(draft)) == []


def test_check_asks_on_the_terminal_and_writes_the_model(tmp_path: Path) -> None:
    opened(tmp_path)
    main, child = pty.openpty()
    command = [sys.executable, "-m", "workbench", "check", "p.md", "--ask", "--no-proposals", "--no-motions"]
    environment = {**os.environ, "WORKBENCH_CACHE": os.devnull}
    process = subprocess.Popen(
        command, cwd=tmp_path, stdin=child, stdout=subprocess.PIPE, env=environment, text=True
    )
    os.write(main, b"1\n")
    out, _ = process.communicate(timeout=100)
    os.close(child)
    os.close(main)
    assert "What is a? (line 3; decides 1 equation)" in out and "the answers are in p.toml" in out
    model = tomllib.loads((tmp_path / "p.toml").read_text())
    assert model["symbols"]["a"]["kind"] == "vector" and "a" not in model["guessed"]
