"""The steps of the workflow that the manual shows, run in a repository as a runner does."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from importlib.resources import files
from pathlib import Path

import pytest

PAGE = files("workbench.guide").joinpath("howto/ci.md").read_text("utf-8")
STEPS = [step for step in re.findall(r"^ +- run: (.*)$", PAGE, flags=re.M) if step.startswith("workbench")]
TEXT = "%! workbench: symbols.'a' = \"vector\"\n\\[ a + a = 2 a \\]\n"


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    if shutil.which("git") is None:
        pytest.skip("no git is installed")
    (tmp_path / "paper.tex").write_text(TEXT)
    commit = ["-c", "user.name=n", "-c", "user.email=n@example.org", "commit", "-q", "-m", "Begin"]
    for words in (["init", "-q"], ["add", "."], commit, ["update-ref", "refs/remotes/origin/main", "HEAD"]):
        subprocess.run(["git", *words], cwd=tmp_path, check=True)
    (tmp_path / "paper.tex").write_text(TEXT + "\\[ a + a = 3 a \\]\n")
    return tmp_path


def step(command: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Runs a step; the programs of other projects read what they get."""
    tools = folder / "tools"
    tools.mkdir()
    (tools / "reviewdog").write_text("#!/bin/sh\ncat\n")
    (tools / "workbench").write_text(f'#!/bin/sh\nexec {sys.executable} -m workbench "$@"\n')
    for tool in tools.iterdir():
        tool.chmod(0o755)
    path = f"{tools}{os.pathsep}{os.environ['PATH']}"
    return subprocess.run(
        ["bash", "-c", command], cwd=folder, env={**os.environ, "PATH": path}, capture_output=True, text=True
    )


@pytest.mark.parametrize("command", STEPS)
def test_a_step_of_the_workflow_tells_the_new_error(repository: Path, command: str) -> None:
    done = step(command, repository)
    told = (repository / "workbench.sarif").read_text() if "sarif" in command else done.stdout
    assert done.stderr == "" and "refuted" in told and "paper.tex" in told
    assert done.returncode == (0 if "|" in command else 1)
    if "sarif" in command:
        (run,) = json.loads(told)["runs"]
        assert [each["level"] for each in run["results"]] == ["error"]


def test_the_workflow_has_steps() -> None:
    assert len(STEPS) == 3
