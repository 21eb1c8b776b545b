"""The patch of the text that was read: it applies, and changes what the edits say and nothing else."""

from __future__ import annotations

import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner
from sample_report import claim, report_of

from workbench.cli.commands import main
from workbench.papers.model import Edit, Mend
from workbench.report import ReportError
from workbench.report.corrected_text import errata_diff
from workbench.report.render import write_report

TEXT = (
    "# A text\n\nFirst.\n\n$$a  = b + c \\quad (1)$$\n\nThen (3) says so.\n\n$$a = b + c + d \\quad (2)$$\n"
)


def wrong(printed: str, old: str, new: str, fault: str = "error", **more: object) -> object:
    mend = Mend(edits=(Edit(old, new, is_math=True),), **more)
    result = claim("1", "1", "1", "refuted", printed=printed, mend=mend)
    return replace(result, claim=replace(result.claim, fault=fault))


def test_edit_is_placed_by_what_is_printed_whatever_its_spacing():
    patch = errata_diff(TEXT, "a.md", [wrong("a = b + c + d", "+ d", "- d")])
    assert "-$$a = b + c + d \\quad (2)$$\n+$$a = b + c - d \\quad (2)$$\n" in patch
    assert patch.count("\n-$") == 1


def test_edit_that_fits_twice_is_not_placed():
    assert errata_diff(TEXT, "a.md", [wrong("b + c", "+ c", "- c")]) == ""


def test_loss_of_the_transcription_is_not_in_the_patch():
    assert errata_diff(TEXT, "a.md", [wrong("a = b + c + d", "+ d", "- d", "transcription")]) == ""


@pytest.mark.skipif(shutil.which("patch") is None, reason="needs patch")
def test_patch_applies(tmp_path):
    (tmp_path / "a.md").write_text(TEXT)
    (tmp_path / "p").write_text(errata_diff(TEXT, "a.md", [wrong("a = b + c + d", "+ d", "- d")]))
    subprocess.run(["patch", "-p1", "-i", "p"], cwd=tmp_path, check=True, capture_output=True)
    assert (tmp_path / "a.md").read_text() == TEXT.replace("+ d", "- d")


def test_report_of_a_paper_corrects_the_text_that_is_named(tmp_path):
    paper = report_of([wrong("a = b + c + d", "+ d", "- d")])
    source = tmp_path / "a.md"
    with pytest.raises(ReportError, match=r"a\.md: the text that was read cannot be opened"):
        write_report(*paper, tmp_path / "out", source)
    source.write_text(TEXT)
    assert "errata.diff" in {path.name for path in write_report(*paper, tmp_path / "out", source)}
    write_report(*paper, tmp_path / "out")
    assert not (tmp_path / "out" / "errata.diff").exists()


def test_check_writes_the_report_of_a_text(tmp_path):
    text = tmp_path / "paper.tex"
    text.write_text(
        "\\documentclass{article}\\title{Of squares}\\begin{document}\n"
        '% workbench: symbols.a = "scalar"\n'
        "\\begin{equation} (1+2)^2 = 1^2 + 2^2 \\end{equation}\n\\end{document}\n"
    )
    result = CliRunner().invoke(
        main, ["check", str(text), "--report", str(tmp_path / "out"), "--no-proposals"]
    )
    assert result.exit_code in (0, 1), result.output
    page = (tmp_path / "out" / "report.html").read_text("utf-8")
    assert "<h1>Of squares</h1>" in page and "Read: paper.tex" in page


def test_report_of_two_texts_is_refused():
    files = [str(Path(__file__)), str(Path(__file__).with_name("conftest.py"))]
    result = CliRunner().invoke(main, ["check", *files, "--report", "out"])
    assert result.exit_code == 2 and "--report: expected one FILE" in result.output
