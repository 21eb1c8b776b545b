"""What a report says of motions: what errors cost there, in words and in a picture, and what has no motion."""

import re
import shutil
import subprocess

import pytest
from judge.motions.motion_papers import paper

from workbench.app.pipeline.judge_claims import judge_paper
from workbench.context.claims import Claim, Formula
from workbench.core.codes.motion_codes import MotionCode
from workbench.core.reasons import Reason
from workbench.core.verdict import Evidence, Outcome, Verdict
from workbench.prover.results.claim_results import ClaimResult
from workbench.prover.results.motion_summary import ALGEBRA, METHOD
from workbench.report import render
from workbench.report.motion_coverage import Unseen, motions_of

NONE = MotionCode.ALGEBRA()


def result(name: str, no_motion: Reason | None = None) -> ClaimResult:
    seen = (
        () if no_motion else (Evidence(METHOD, "the sides part", {"residual": 1, "motion": "", "time": 0}),)
    )
    return ClaimResult(
        Claim(name, Formula("a"), None), Verdict(Outcome.REFUTED, evidence=seen, no_motion=no_motion)
    )


def test_claims_without_a_motion_are_listed_by_their_reasons():
    places = {"a": ("Eq. (1)", "a"), "b": ("Eq. (1)", "b"), "c": ("Eq. (2)", "c"), "d": ("Eq. (3)", "d")}
    results = [
        result("a", NONE),
        result("b", NONE),
        result("c"),
        result("d", MotionCode.AS_STATED(why="a word")),
    ]
    found = motions_of(results, places)
    assert (found.seen, found.claims) == (1, 4)
    assert found.unseen == (
        Unseen("a word", 1, (("Eq. (3)", "d"),)),
        Unseen(ALGEBRA, 2, (("Eq. (1)", "a"),)),
    )
    assert motions_of(results[:2], places) is None


@pytest.fixture(scope="module")
def texts(tmp_path_factory):
    loaded = paper(
        tmp_path_factory.mktemp("paper"),
        r"""
        equation = "7"
        printed = '\dot{R} = -\tilde{\omega} R'
        corrected = '\dot{R} = \tilde{\omega} R'
        fault = "error"
        """,
        r"printed = 'a \times x = -x \times a'",
    )
    return render.render(loaded, judge_paper(loaded))


def test_an_error_has_its_cost_and_its_pictures_with_words(texts):
    page, note = texts["report.html"], texts["erratum.tex"]
    assert "the sides differ by up to 200" in page and "the sides differ by up to 200" in note
    every, spark = re.findall(r"<svg.*?</svg>", page, re.DOTALL)
    assert 'role="img"' in every and "<title" in every and "<desc" in every and ">(7)<" in every
    assert 'role="img"' in spark and "as printed off by up to 200 %" in spark
    assert spark.count("<polyline") == 2 and "script" not in every + spark


def test_each_report_says_what_is_no_motion(texts):
    for name in ("report.html", "report.md"):
        assert "1 formulas not simulated (no motion: algebra)" in texts[name]
    assert "Of 2 formulas 1 were simulated" in texts["erratum.tex"]
    assert "1 (no motion: algebra): " in texts["erratum.tex"]


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="needs pdflatex")
def test_the_note_is_set(texts, tmp_path):
    (tmp_path / "erratum.tex").write_text(texts["erratum.tex"], "utf-8")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "erratum.tex"]
    subprocess.run(command, cwd=tmp_path, check=True, capture_output=True)
