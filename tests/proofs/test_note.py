"""The note on the chapter: what it begins with, how long it is, and that nothing of ours stands in it."""

import re
import shutil
import subprocess

import pytest

from workbench.app.pipeline.judge_claims import judge_paper
from workbench.papers import find_paper
from workbench.report import render
from workbench.report.document import document_of

ERRORS = {
    "Eqs. (37), (107), (108), (110), (111), (112), (113)",
    "Eqs. (64), (66), (67), (68)",
    "Eqs. (61), (62)",
    "Theorem 2",
    *("Eq. (10)", "Eq. (31)", "Eq. (34)", "Eq. (70)", "Eq. (132)"),
}


@pytest.fixture(scope="module")
def report():
    paper = find_paper(None)
    return paper, judge_paper(paper)


def unfolded(page):
    """What is seen of a page whose folds are closed; folds stand within folds."""
    seen, depth = [], 0
    for piece in re.split(r"(<details\b|</details>)", page):
        if piece == "</details>":
            depth -= 1
        elif piece == "<details":
            depth += 1
        elif depth == 0:
            seen.append(piece)
    return "".join(seen)


@pytest.mark.slow
def test_the_errors_are_these(report):
    errata = document_of(*report).errata
    assert {erratum.heading for erratum in errata.errors} == ERRORS
    assert [each.heading for each in errata.errors[1].corrections][:2] == ["Eq. (67)", "Eq. (67)"]


@pytest.mark.slow
def test_nothing_of_ours_stands_where_a_reader_looks(report):
    texts = render.render(*report)
    note = texts["erratum.tex"].split(r"\begin{document}")[1]
    page = re.sub(r"<[^>]*>", " ", unfolded(texts["report.html"].split("<body>")[1]))
    for text in (note, page):
        assert not re.search(r"U\+[0-9A-F]{4}|column \d|\b\d+\.(?:by13|det|adjugate|inverse|div)\b", text)
    assert "LaTeX source" not in page


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
def test_errors_begin_on_page_1_and_all_but_the_appendix_fill_6(report, tmp_path):
    """The sections are told by the pages on which they begin."""
    note = render.render(*report)["erratum.tex"]
    for name in ("Errors", "Misprints", "Appendix"):
        note = note.replace(rf"\section*{{{name}", rf"\typeout{{{name} on \thepage}}\section*{{{name}", 1)
    (tmp_path / "erratum.tex").write_text(note, "utf-8")
    for _ in range(2):
        run = subprocess.run(
            ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "erratum.tex"],
            cwd=tmp_path, capture_output=True, timeout=120,
        )  # fmt: skip
    log = run.stdout.decode("utf-8", "replace")
    assert run.returncode == 0 and "Overfull" not in log
    pages = {name: int(page) for name, page in re.findall(r"(Errors|Misprints|Appendix) on (\d+)", log)}
    assert pages["Errors"] == 1 and pages["Misprints"] <= 3 and pages["Appendix"] - 1 <= 6
