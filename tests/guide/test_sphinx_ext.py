"""The Sphinx extension: a small book is built, and what is wrong in it is a warning at its line."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from importlib.resources import files
from pathlib import Path

import pytest

from tests.guide.example_blocks import blocks

pytest.importorskip("sphinx")
PAGE = files("workbench.guide").joinpath("howto/book.md").read_text("utf-8")
TWO = """# Two

For vectors $\\mathbf{a}$:

$$ \\mathbf{a} + \\mathbf{a} = 2 \\mathbf{a} $$

```{math}
\\mathbf{a} \\times \\mathbf{a} = \\mathbf{a}
```

\\begin{align}
\\mathbf{a} + \\mathbf{a} &= 2 \\mathbf{a} \\\\
  &= 4 \\mathbf{a}
\\end{align}

```{include} /../outside.md
```
"""
FALSE = "$$ \\mathbf{a} \\times \\mathbf{b} = \\mathbf{b} \\times \\mathbf{a} $$\n"


def build(folder: Path, *options: str) -> subprocess.CompletedProcess[str]:
    command = ["-q", "-b", "html", *options, str(folder), str(folder / "_build")]
    return subprocess.run([sys.executable, "-m", "sphinx", *command], capture_output=True, text=True)


def test_the_book_of_the_guide_fails_as_it_says(tmp_path: Path) -> None:
    found = list(blocks(PAGE))
    for block in found:
        if block.file:
            (tmp_path / block.file).write_text(block.body)
    (command,) = [block.body for block in found if block.language == "sh"]
    (told,) = [block.body.strip() for block in found if block.language == "text"]
    words = [sys.executable, "-m", "sphinx", *shlex.split(command)[1:]]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True)
    assert (
        done.returncode == 1 and f"index.rst:8: {told}" in done.stderr and done.stderr.count("WARNING") == 1
    )
    html = (tmp_path / "_build/index.html").read_text("utf-8")
    classes = re.findall(r'<div class="workbench (workbench-[a-z-]+)', html)
    assert classes == ["workbench-ok", "workbench-warning"]
    assert re.search(r'<p class="workbench-says workbench-warning">! refuted, unless', html)
    assert (tmp_path / "_build/_static/workbench.css").exists() and "workbench.css" in html


def test_markdown_pages_have_marks_and_may_be_left_out(tmp_path: Path) -> None:
    pytest.importorskip("myst_parser")
    folder = tmp_path / "book"
    folder.mkdir()
    (tmp_path / "outside.md").write_text(FALSE)
    (folder / "conf.py").write_text(
        "extensions = ['workbench.app.sphinx_ext', 'myst_parser', 'sphinx.ext.mathjax']\n"
        "myst_enable_extensions = ['dollarmath', 'amsmath']\n"
    )
    (folder / "index.md").write_text("# One\n\n```{toctree}\ntwo\noff\nmodel\n```\n")
    (folder / "two.md").write_text(TWO)
    (folder / "off.md").write_text("---\nworkbench: off\n---\n# Off\n\n" + FALSE)
    (folder / "model.md").write_text("# Model\n\n$$ A B = B A $$\n")
    (folder / "model.toml").write_text('source = "model.md"\n[symbols]\nA = "tensor"\nB = "tensor"\n')
    done = build(folder)
    lines = re.findall(r"(\w+\.md):(\d+): WARNING: .*\[workbench\.(.*?)\]", done.stderr)
    assert [each for each in lines if each[2] != "text"] == [
        ("model.md", "3", "refuted"),
        ("two.md", "8", "refuted"),
        ("two.md", "13", "refuted"),
    ]
    html = (folder / "_build/two.html").read_text("utf-8")
    assert re.findall(r"workbench (workbench-[a-z-]+) math", html) == [
        "workbench-ok",
        "workbench-warning",
        "workbench-warning",
    ]
    assert "workbench" not in re.sub(
        r"<head>.*</head>", "", (folder / "_build/off.html").read_text("utf-8"), flags=re.S
    )
    quiet = build(folder, "-E", "-D", "workbench_level=error", "-D", "workbench_marks=0")
    assert re.findall(r"(\w+\.md):(\d+): WARNING: .*\[workbench\.refuted\]", quiet.stderr) == [
        ("model.md", "3")
    ]
    assert "workbench-" not in (folder / "_build/two.html").read_text("utf-8")


def test_a_page_that_cannot_be_used_is_one_warning(tmp_path: Path) -> None:
    (tmp_path / "conf.py").write_text("extensions = ['workbench.app.sphinx_ext', 'sphinx.ext.mathjax']\n")
    (tmp_path / "index.rst").write_text("One\n===\n\n.. math:: a = a\n")
    (tmp_path / "index.toml").write_text('source = "index.rst"\n[symbols\n')
    done = build(tmp_path, "-D", "workbench_level=nothing")
    assert done.returncode == 0 and "Traceback" not in done.stderr
    assert "expected 'warning' or 'error'" in done.stderr and "[workbench.model]" in done.stderr
