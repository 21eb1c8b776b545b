"""The examples of the manual: every command, its output, every Python session."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.guide.example_blocks import agrees, blocks, console_steps, faults
from workbench.guide.pages import FOLDER

PAGES = sorted(FOLDER.glob("*/*.md"))
#: Run in each default run; the others with --slow.
ALWAYS = {"accents", "frames", "ci"}


@pytest.mark.parametrize(
    "path",
    [
        pytest.param(path, id=path.stem, marks=() if path.stem in ALWAYS else pytest.mark.slow)
        for path in PAGES
        if any(block.language in ("console", "pycon") for block in blocks(path.read_text("utf-8")))
    ],
)
def test_examples_of_page_are_right(path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert "\n\n".join(faults(path.read_text(encoding="utf-8"))) == ""


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_page_says_what_it_is_first(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert re.match(r"# [^\n]+\n\n[A-Z`0-9][^\n]+", text)


def test_wrong_output_is_detected(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    page = "```console\n$ workbench --version\nworkbench, version 9\n```\n```pycon\n>>> 1 + 1\n3\n```\n"
    assert len(list(faults(page))) == 2


@pytest.mark.parametrize(
    ("expected", "right"), [(["a", "…", "c"], True), (["…"], True), (["a", "c"], False), (["a", "…"], True)]
)
def test_elision_stands_for_any_lines(expected: list[str], right: bool) -> None:
    assert agrees(expected, ["a", "b", "c"]) is right


def test_each_command_has_its_output() -> None:
    body = "$ one\n1\n2\n$ two\n"
    assert list(console_steps(body)) == [("one", ["1", "2"]), ("two", [])]
