"""The command line as a whole: groups, summaries, examples, completion, names that are unknown."""

from __future__ import annotations

import os
import shlex
import subprocess
import sys

import click
import pytest
from click.testing import CliRunner

from workbench.app.commands.command_table import COMMANDS
from workbench.app.commands.commands import main

CONTEXT = click.Context(main, info_name="workbench")
NAMES = main.list_commands(CONTEXT)


def command(name: str) -> click.Command:
    found = main.get_command(CONTEXT, name)
    assert found is not None
    return found


def test_help_lists_the_groups_in_order() -> None:
    shown = CliRunner().invoke(main, ["--help"], terminal_width=80).output
    places = [shown.index(f"\n{group}:") for group in ("Check", "Read", "Robot", "Chapter")]
    assert places == sorted(places) and "…" not in shown and "..." not in shown.split("Options:")[1]


def test_summaries_fit_80_columns() -> None:
    width = max(map(len, NAMES))
    assert [e.name for e in COMMANDS if 2 + width + 2 + len(e.summary) > 80] == []


@pytest.mark.parametrize("entry", COMMANDS, ids=lambda entry: entry.name)
def test_examples_are_accepted_and_shown(entry: object) -> None:
    shown = CliRunner().invoke(main, [entry.name, "--help"]).output  # type: ignore[attr-defined]
    for example in entry.examples:  # type: ignore[attr-defined]
        words = shlex.split(example)
        assert words[0] == "workbench" and f"  {example}" in shown
        command(words[1]).make_context(words[1], words[2:])


#: `report` writes what is recorded; a search takes minutes.
DIFFERING = {("report", "--proposals")}


def test_same_option_has_the_same_default_everywhere() -> None:
    defaults: dict[str, dict[str, object]] = {}
    for name in NAMES:
        for parameter in command(name).params:
            for option in parameter.opts:
                shared = ("--cache", "--motions", "--proposals", "--seconds", "--megabytes", "--paper")
                if (
                    option in shared
                    and (name, option) not in DIFFERING
                    and not getattr(parameter, "hidden", False)
                ):
                    defaults.setdefault(option, {})[name] = parameter.default
    differing = {
        option: found for option, found in defaults.items() if len(set(map(str, found.values()))) > 1
    }
    assert differing == {}


def test_unknown_command_names_the_closest() -> None:
    result = CliRunner().invoke(main, ["verfy"])
    assert result.exit_code == 2 and "Did you mean verify" in result.output


def test_unknown_id_names_the_closest() -> None:
    result = CliRunner().invoke(main, ["list", "58.dte"])
    assert result.exit_code == 2 and "Did you mean 58.det" in result.output


def test_python_m_workbench_runs() -> None:
    done = subprocess.run([sys.executable, "-m", "workbench", "--version"], capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout.startswith("workbench, version")


@pytest.mark.parametrize(
    ("typed", "completion"),
    [
        ("workbench ver", "verify"),
        ("workbench help model", "model-keys"),
        ("workbench list --paper ki", "kindr"),
    ],
)
def test_shell_completion_completes(typed: str, completion: str) -> None:
    done = _completed("bash", typed, str(len(typed.split()) - 1))
    assert f"plain,{completion}" in done.stdout.splitlines()
    done = _completed("zsh", typed, str(len(typed.split()) - 1))
    assert ["plain", completion] in [
        done.stdout.splitlines()[k : k + 2] for k in range(len(done.stdout.splitlines()))
    ]
    done = _completed("fish", typed, typed.split()[-1])
    assert f"plain,{completion}" in [line.split("\t")[0] for line in done.stdout.splitlines()]


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completion_after_an_unknown_command_offers_nothing(shell: str) -> None:
    done = _completed(shell, "workbench chk fi", "fi" if shell == "fish" else "2")
    assert (done.returncode, done.stdout.strip(), done.stderr) == (0, "", "")


def _completed(shell: str, typed: str, at: str) -> subprocess.CompletedProcess[str]:
    words = {"COMP_WORDS": typed, "COMP_CWORD": at, "_WORKBENCH_COMPLETE": f"{shell}_complete"}
    code = "from workbench.app.commands.commands import main; main(prog_name='workbench')"
    return subprocess.run(
        [sys.executable, "-c", code], env=os.environ | words, capture_output=True, text=True
    )


HEAVY = ("numpy", "scipy", "sympy", "flint", "pydrake", "lark", "numba", "jinja2", "rich")


@pytest.mark.parametrize("words", [["--version"], ["--help"]])
def test_command_line_starts_without_heavy_imports(words: list[str]) -> None:
    code = (
        "import sys\nfrom workbench.app.commands.commands import main\n"
        f"main({words!r}, standalone_mode=False)\n"
        f"print([m for m in {HEAVY!r} if m in sys.modules], file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.stderr.strip() == "[]"


def test_first_check_imports_the_engines_only() -> None:
    heavy = ("numba", "llvmlite", "scipy", "jinja2", "rich", "matplotlib")
    code = (
        "import sys\nfrom workbench import check\ncheck('a = b', symbols={'a': 'vector', 'b': 'vector'})\n"
        f"print([m for m in {heavy!r} if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.stdout.strip() == "[]"
