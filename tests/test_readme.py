"""The README: short, every command and example run as it stands there."""

from __future__ import annotations

import re
from importlib.metadata import entry_points
from pathlib import Path

import pytest

from tests.guide.example_blocks import blocks, faults
from workbench.app.commands.command_table import COMMANDS

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")
SET_UP = ("pip install uv && uv run workbench report", "pip install uv && uv run pytest")
GUIDE = "\n".join(path.read_text(encoding="utf-8") for path in ROOT.glob("workbench/guide/*/*.md"))


def test_readme_can_be_read_in_five_minutes() -> None:
    assert len(README.splitlines()) <= 150 and len(README.encode()) <= 9000


@pytest.mark.parametrize("command", SET_UP)
def test_ci_runs_the_set_up(command: str) -> None:
    assert f"\n    {command}\n" in README
    lines = (ROOT / ".ci" / "run").read_text(encoding="utf-8").splitlines()
    assert any(line.strip().startswith(command) for line in lines)


def test_notebooks_can_be_opened() -> None:
    assert "`uv run jupyter lab notebooks`" in README
    assert entry_points(group="console_scripts", name="jupyter-lab")


def test_examples_are_right(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    assert {block.language for block in blocks(README)} >= {"console", "pycon"}
    assert "\n\n".join(faults(README)) == ""


@pytest.mark.parametrize("target", sorted(set(re.findall(r"\]\(([\w./-]+)\)", README))))
def test_linked_file_exists(target: str) -> None:
    assert (ROOT / target).is_file() and (ROOT / target).stat().st_size <= 150_000


@pytest.mark.parametrize(
    "command", sorted(set(re.findall(r"`(?:uv run )?workbench (\w+)[ `]", README + GUIDE)))
)
def test_named_command_exists(command: str) -> None:
    assert command in {entry.name for entry in COMMANDS}


@pytest.mark.parametrize("script", sorted(set(re.findall(r"python (tests/[\w/]+\.py)", README + GUIDE))))
def test_named_script_exists(script: str) -> None:
    assert (ROOT / script).is_file()


def test_extras_are_those_of_the_package() -> None:
    import tomllib

    with (ROOT / "pyproject.toml").open("rb") as file:
        known = set(tomllib.load(file)["project"]["optional-dependencies"])
    line = next(line for line in README.splitlines() if line.startswith("- Install:"))
    assert set(re.findall(r"`(\w+)`", line)) == known
