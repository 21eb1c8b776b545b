"""The note on ten formulas of a textbook, five of them with a slip: judged, written, and set by pdflatex."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from workbench.app.pipeline.judge_claims import judge_paper
from workbench.papers import load_paper
from workbench.report import render
from workbench.report.to_json import claim_json

TEXTBOOK = Path(__file__).parent.parent / "papers" / "textbook.toml"


@pytest.fixture(scope="module")
def report():
    paper = load_paper(TEXTBOOK)
    results = judge_paper(paper, motions=False)
    assert [result.claim.id for result in results if not result.passed] == []
    return paper, results


@pytest.fixture(scope="module")
def note(report):
    return render.render(*report)["erratum.tex"]


def test_each_slip_is_in_the_note_once_and_what_is_right_is_not(note):
    body = note.split(r"\section*{Appendix")[0]
    for name, equation in {
        "Errors": "3.2",
        "Misprints": "3.4",
        "Wording": "3.6",
        "Probably lost": "3.8",
        "Conditions": "3.9",
    }.items():
        section = re.split(r"\\section\*", body.split(rf"\section*{{{name}", 1)[-1])[0]
        assert re.findall(r"Eq\. \((3\.\d+)\)", section) == [equation], name
    assert "changes also (3.3)" in body


def test_edits_make_the_proved_forms(report):
    told = map(claim_json, report[1])
    edited = [claim for claim in told if (claim["mend"] or {}).get("edits") and not claim["formula"]]
    assert len(edited) == 3 and all(claim["mend"]["is_proved"] for claim in edited)


def test_two_runs_give_the_same_bytes(report):
    again = load_paper(TEXTBOOK)
    assert render.render(*report) == render.render(again, judge_paper(again, motions=False))


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
def test_the_note_has_two_pages(note, tmp_path):
    (tmp_path / "erratum.tex").write_text(note, "utf-8")
    for _ in range(2):
        run = subprocess.run(
            ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "erratum.tex"],
            cwd=tmp_path, capture_output=True, timeout=60,
        )  # fmt: skip
    log = run.stdout.decode("utf-8", "replace")
    assert run.returncode == 0, log[-2000:]
    assert "Overfull" not in log and "(2 pages" in log
