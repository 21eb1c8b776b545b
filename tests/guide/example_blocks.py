"""The examples of a Markdown page: files, console commands with their output, Python sessions. Runs them.

A fenced block after a line such as "`paper.tex`:" is that file. A block `console` has commands after "$ ",
each followed by its output; a line "…" stands for any number of lines. A block `pycon` is a Python session.
`python -m tests.guide.example_blocks PAGE…` writes the output that the commands have today."""

from __future__ import annotations

import contextlib
import doctest
import io
import os
import re
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from click.testing import CliRunner

from workbench.app.commands.commands import main

ROOT = Path(__file__).parents[2]
_FENCE = re.compile(
    r"(?:^`(?P<file>[\w./-]+)`(?:,[^\n`]*)?:\n\n)?^```(?P<language>\w*)\n(?P<body>.*?)^```$", re.M | re.S
)
ELISION = "…"


@dataclass(frozen=True)
class Block:
    """A fenced block of a page. file: the file that it is, if the line before it says so."""

    language: str
    body: str
    file: str | None
    start: int
    end: int


def blocks(text: str) -> Iterator[Block]:
    """Yields the fenced blocks of the page, in order."""
    for found in _FENCE.finditer(text):
        yield Block(found["language"], found["body"], found["file"], found.start("body"), found.end("body"))


def console_steps(body: str) -> Iterator[tuple[str, list[str]]]:
    """Yields each command of a console block with the lines of its output."""
    parts = re.split(r"^\$ (.*)\n", body, flags=re.M)
    for command, output in zip(parts[1::2], parts[2::2], strict=True):
        yield command, [line.rstrip() for line in output.splitlines()]


def run(command: str) -> list[str]:
    """Runs one command in the current folder; returns the lines that it prints."""
    words = shlex.split(command, comments=True)
    if words[:2] == ["uv", "run"]:
        words = words[2:]
    if words[0] == "workbench":
        result = CliRunner().invoke(main, words[1:], terminal_width=80, env={"COLUMNS": "80"})
        if result.exception is not None and not isinstance(result.exception, SystemExit):
            raise result.exception
        output = result.output
    else:
        words = [sys.executable, *words[1:]] if words[0] == "python" else words
        done = subprocess.run(words, capture_output=True, text=True, timeout=300)
        output = done.stdout + done.stderr
    return [line.rstrip() for line in output.splitlines()]


def agrees(expected: Sequence[str], got: Sequence[str]) -> bool:
    """Whether the output is the expected one, in which a line "…" stands for any lines."""
    pattern = "".join("(?:.*\n)*" if line.strip() == ELISION else re.escape(line) + "\n" for line in expected)
    return re.fullmatch(pattern, "".join(f"{line}\n" for line in got)) is not None


def session(body: str, names: dict[str, object]) -> str:
    """Runs a Python session; returns what differs from the output shown, or ""."""
    test = doctest.DocTestParser().get_doctest(body, names, "page", None, 0)
    report = io.StringIO()
    runner = doctest.DocTestRunner(
        optionflags=doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS | doctest.IGNORE_EXCEPTION_DETAIL
    )
    runner.run(test, out=report.write, clear_globs=False)
    names.update(test.globs)
    return report.getvalue()


@contextlib.contextmanager
def folder_of(place: Path) -> Iterator[None]:
    """Works in the folder."""
    before = Path.cwd()
    os.chdir(place)
    try:
        yield
    finally:
        os.chdir(before)


def faults(text: str) -> Iterator[str]:
    """Runs the examples of a page in the current folder; yields what differs from what the page shows."""
    names: dict[str, object] = {}
    for block in blocks(text):
        if block.file is not None:
            Path(block.file).parent.mkdir(parents=True, exist_ok=True)
            Path(block.file).write_text(block.body, encoding="utf-8")
        elif block.language == "console":
            for command, expected in console_steps(block.body):
                got = run(command)
                if not agrees(expected, got):
                    yield "\n".join([f"$ {command}", "expected", *expected, "got", *got])
        elif block.language == "pycon" and (difference := session(block.body, names)):
            yield difference


def rewritten(text: str) -> str:
    """The page with the output that its commands have in the current folder; blocks with "…" stay."""
    made, at = [], 0
    for block in blocks(text):
        if block.file is not None:
            Path(block.file).write_text(block.body, encoding="utf-8")
        elif block.language == "console":
            steps = [
                [f"$ {command}", *(shown if ELISION in map(str.strip, shown) else run(command))]
                for command, shown in console_steps(block.body)
            ]
            made += [text[at : block.start], "".join(f"{line}\n" for step in steps for line in step)]
            at = block.end
    return "".join([*made, text[at:]])


if __name__ == "__main__":
    for name in sys.argv[1:]:
        page = Path(name).resolve()
        with tempfile.TemporaryDirectory() as place, folder_of(ROOT if page.parent == ROOT else Path(place)):
            told = rewritten(page.read_text(encoding="utf-8"))
        page.write_text(told, encoding="utf-8")
