"""Equation numbers are those that LaTeX gives. The figures here are pdflatex's own (texlive 2022), by \\newlabel."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from workbench.source.documents import read_text

#: Documents, each behind a comment with the number of each label.
DOCUMENTS = sorted((Path(__file__).parent / "numbered").glob("*.tex"))


def numbers_in(document: Path) -> dict[str, str]:
    """Returns the number of each label by the document's first line."""
    first = document.read_text(encoding="utf-8").partition("\n")[0]
    return dict(pair.split(": ") for pair in first.removeprefix("% ").split("; "))


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.stem)
def test_every_label_has_the_number_that_latex_gives(document: Path) -> None:
    assert read_text(document).labels == numbers_in(document)


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="no pdflatex")
@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.stem)
def test_pdflatex_agrees(tmp_path: Path, document: Path) -> None:
    path = Path(shutil.copy(document, tmp_path / "paper.tex"))
    numbers = numbers_in(document)
    command = ["pdflatex", "-draftmode", "-interaction=batchmode", path.name]
    done = subprocess.run(command, cwd=tmp_path, check=False, capture_output=True, timeout=120)
    if b".cls' not found" in done.stdout + path.with_suffix(".log").read_bytes():
        pytest.skip("this class is not installed")
    aux = re.sub(r"\\mbox\s*\{(.*?)\}", r"\1", path.with_suffix(".aux").read_text())
    aux = re.sub(r"\\M@TitleReference |Appendix \\nobreakspace\s*\{\}", "", aux)
    told = re.findall(r"\\newlabel\{([^}]*)\}\{\{\{?([^{}]*)\}", aux.replace(r"\,", " "))
    assert {label: number for label, number in told if label in numbers} == numbers


def test_a_document_that_includes_itself_is_read_once(tmp_path: Path) -> None:
    (tmp_path / "a.tex").write_text(r"\[ a = b \]\input{b}")
    (tmp_path / "b.tex").write_text(r"\[ c = d \]\input{a}\input{b}")
    text = read_text(tmp_path / "a.tex")
    assert [display.latex for display in text.displays] == ["a = b", "c = d"]
    assert ["includes itself" in warning.message for warning in text.warnings] == [True, True]
