"""The patch of the text that was read: it applies, and changes what the edits say and nothing else."""

from __future__ import annotations

import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner
from sample_report import claim, report_of, with_fault

from workbench.app.commands.commands import main
from workbench.context.claim_parts import Edit, Mend
from workbench.core.spans import Span
from workbench.report import ReportError
from workbench.report.erratum.corrected_text import errata_diff
from workbench.report.render import write_report
from workbench.source.documents import Source
from workbench.source.documents.source_edits import SourceEdit

TEXT = (
    "# A text\n\nFirst.\n\n$$a  = b + c \\quad (1)$$\n\nThen (3) says so.\n\n$$a = b + c + d \\quad (2)$$\n"
)


def wrong(printed: str, old: str, new: str, fault: str = "error", **more: object) -> object:
    mend = Mend(edits=(Edit(old, new, is_math=True),), **more)
    result = claim("1", "1", "1", "refuted", printed=printed, mend=mend)
    return with_fault(result, fault)


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


@pytest.mark.skipif(shutil.which("patch") is None, reason="needs patch")
@pytest.mark.parametrize("layout", ["{}", "\ufeff{}", "\f\u2028\n{}"], ids=["plain", "mark", "form feed"])
@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_patch_of_a_text_edits_its_own_characters(tmp_path, layout, newline):
    lines = ["\\begin{equation}", "(1+2)^2 = 1^2 + 2^2 + 3", "\\end{equation}", ""]
    text = layout.format("\n".join(lines)).replace("\n", newline)
    file = tmp_path / "a.tex"
    file.write_bytes(text.encode())
    at = text.removeprefix("\ufeff").replace("\r\n", "\n").index("+ 3")
    source = Source.open(file)
    span = Span(file, *source.place(at), *source.place(at + 3))
    result = claim("1", "1", "1", "refuted", printed="(1+2)^2 = 1^2 + 2^2 + 3")
    right = SourceEdit(span, source, at, at + 3, "+ 3", "+ 4")
    result = replace(with_fault(result, "error"), edits=(right,))
    (tmp_path / "p").write_bytes(errata_diff(text, "a.tex", [result]).encode())
    subprocess.run(["patch", "--binary", "-p1", "-i", "p"], cwd=tmp_path, check=True, capture_output=True)
    assert file.read_bytes().decode() == text.replace("+ 3", "+ 4")


def test_edit_of_another_file_is_not_in_the_patch(tmp_path):
    (tmp_path / "macros.tex").write_text(r"\newcommand{\half}{\frac{1}{3}}")
    source = Source.open(tmp_path / "macros.tex")
    span = Span(source.path, 1, 28, 1, 29)
    result = claim("1", "1", "1", "refuted", printed=r"\half + \half = 1")
    right = SourceEdit(span, source, 27, 28, "3", "2")
    result = replace(with_fault(result, "error"), edits=(right,))
    assert errata_diff(TEXT, "a.md", [result]) == ""


def test_a_claim_below_the_end_of_the_text_is_still_corrected(tmp_path):
    result = wrong("a = b + c + d", "+ d", "- d")
    result = replace(result, claim=result.claim.with_context(span=Span(tmp_path / "b.md", 99, 1, 99, 9)))
    assert "+$$a = b + c - d" in errata_diff(TEXT, "a.md", [result])


def test_report_of_a_text_has_the_patch_of_check(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    kinds = "".join(f"%! workbench: symbols.'{name}' = 'vector'\n" for name in "ab")
    Path("a.tex").write_text(
        f"{kinds}\\begin{{document}}\n\\[ a \\times b = b \\times a \\]\n\\end{{document}}\n"
    )
    CliRunner().invoke(main, ["report", "--paper", "a.tex", "--proposals", "--no-motions"])
    checked = CliRunner().invoke(main, ["check", "a.tex", "--diff", "--no-motions"])
    assert Path("report/errata.diff").read_text() == checked.stdout != ""
