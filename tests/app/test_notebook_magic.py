"""%%check in a notebook: each step of a derivation with its mark."""

from __future__ import annotations

import re
from importlib.resources import files
from pathlib import Path

import pytest

pytest.importorskip("IPython")
from IPython.core.error import UsageError
from IPython.core.interactiveshell import InteractiveShell

from workbench.app.notebook_magic import check_cell

STEPS = "a \\times b &= -b \\times a \\\\\n &= b \\times a"


@pytest.fixture(scope="module")
def shell():
    made = InteractiveShell()
    made.run_line_magic("load_ext", "workbench")
    return made


def test_each_step_of_a_derivation_has_its_mark(shell) -> None:
    cell = shell.run_cell_magic("check", "-s a=vector -s b=vector", STEPS)
    assert [str(result.shown) for result in cell.results] == ["ok", "error"]
    html = cell._repr_html_()
    assert html.count("<tr>") == 2 and html.index("✓") < html.index("✗") and html.count("<math") > 3
    assert repr(cell).startswith("%%check: 1 error, 1 holds") and "right side (0, 1, 0)" in repr(cell)


@pytest.mark.parametrize(
    "cell",
    [
        "\\begin{equation} \\mathbf{a} \\times \\mathbf{a} = \\mathbf{0} \\end{equation}",
        "For a vector $\\mathbf{a}$:\n\n$$ \\mathbf{a} \\times \\mathbf{a} = \\mathbf{0} $$",
        "\\mathbf{a} \\times \\mathbf{a} = \\mathbf{0}",
        "\\[ \\mathbf{a} \\times \\mathbf{a} = \\mathbf{0} \\]",
        "\\begin{bmatrix} 1 & 0 \\\\ 0 & 1 \\end{bmatrix}^T = \\begin{bmatrix} 1 & 0 \\\\ 0 & 1 \\end{bmatrix}",
    ],
)
def test_a_cell_is_tex_markdown_or_bare_lines(cell: str) -> None:
    assert [str(result.shown) for result in check_cell("", cell).results] == ["ok"]


def test_the_kind_of_a_symbol_may_be_given(shell) -> None:
    assert [str(r.shown) for r in check_cell("-s A=scalar -s B=scalar", "A B = B A").results] == ["ok"]
    assert [str(r.shown) for r in check_cell("-s A=tensor -s B=tensor", "A B = B A").results] == ["error"]


@pytest.mark.parametrize("line", ["-s", "-x a=vector", "a=vector", "-s a", "-s 'a", "-s a=spinor"])
def test_bad_options_are_one_error(shell, line: str) -> None:
    with pytest.raises(UsageError):
        shell.run_cell_magic("check", line, "a = a")


def test_no_file_is_read_and_no_markup_let_through(tmp_path: Path) -> None:
    secret = tmp_path / "secret.tex"
    secret.write_text("\\[ s = s + s \\]")
    text = f"\\input{{{secret}}}\n\\[ \\text{{<img src=x>}} = a + 1 \\]\n"
    html = check_cell("", text)._repr_html_()
    assert "<img" not in html and html.count("<tr>") == 1


def test_the_cells_of_the_guide_run(shell, capsys: pytest.CaptureFixture) -> None:
    page = files("workbench.guide").joinpath("howto/notebook.md").read_text("utf-8")
    cells = re.findall(r"```ipython\n(.*?)```", page, re.S)
    told = re.findall(r"```text\n(.*?)```", page, re.S)
    assert len(cells) == 2 and len(told) == 1
    results = [shell.run_cell(cell) for cell in cells]
    assert all(each.success for each in results) and repr(results[1].result) == told[0].rstrip("\n")
