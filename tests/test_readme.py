"""Every command and every example of the README, run as it stands there."""

import re
import shlex
import subprocess
import sys
import tomllib
from importlib.metadata import entry_points
from pathlib import Path

import pytest
from click.testing import CliRunner

from workbench.cli.commands import main

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")
COMMANDS = [
    line.strip().split("   ")[0].strip()
    for line in re.findall(r"^    ((?:pip|uv) .*)$", README, re.MULTILINE)
]
BY_CI = {
    "pip install uv && uv run workbench report",
    "pip install uv && uv run pytest",
    "uv run workbench certify --check",
}
#: Run with other arguments here: programs that measure for minutes.
INSTEAD = {
    "uv run python tests/benchmarks/exact_proving.py": [
        "tests/benchmarks/exact_proving.py",
        "--largest",
        "2",
    ],
    "uv run --group peers python tests/benchmarks/chain_derivatives.py": [
        "tests/benchmarks/chain_derivatives.py",
        "--help",
    ],
    "uv run python tests/benchmarks/cold_verify.py ../earlier": [
        "tests/benchmarks/cold_verify.py",
        "--help",
    ],
}
INTERACTIVE = "uv run jupyter lab notebooks"
FILES = {"paper.toml": "paper.toml", "robot.urdf": "robot.urdf"}

ROBOT = """<robot name="arm">
  <link name="base"/>
  <link name="hand"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="hand"/><axis xyz="0 0 1"/>
    <limit lower="-3" upper="3" effort="1" velocity="1"/>
  </joint>
</robot>
"""


def block(language):
    return re.search(rf"```{language}\n(.*?)```", README, re.DOTALL)[1]


@pytest.fixture
def files(tmp_path, monkeypatch):
    (tmp_path / "paper.toml").write_text(block("toml"), encoding="utf-8")
    (tmp_path / "robot.urdf").write_text(ROBOT, encoding="utf-8")
    return tmp_path


def test_the_readme_has_its_commands():
    assert len(COMMANDS) >= 9 and set(COMMANDS) >= BY_CI


@pytest.mark.parametrize("command", sorted(BY_CI))
def test_ci_runs_the_main_commands(command):
    lines = (ROOT / ".ci" / "run").read_text(encoding="utf-8").splitlines()
    assert any(line.strip().startswith(command) for line in lines)


def test_the_interactive_program_is_installed():
    assert INTERACTIVE in COMMANDS
    assert entry_points(group="console_scripts", name="jupyter-lab")


@pytest.mark.parametrize("command", sorted(set(COMMANDS) - BY_CI - {INTERACTIVE}))
def test_command(command, files):
    if command in INSTEAD:
        done = subprocess.run(
            [sys.executable, *INSTEAD[command]], cwd=ROOT, capture_output=True, text=True, timeout=120
        )
        assert done.returncode == 0, done.stderr
        return
    words = shlex.split(command)
    assert words[:3] == ["uv", "run", "workbench"], f"{command} is run nowhere"
    arguments = [str(files / FILES[w]) if w in FILES else w for w in words[3:]]
    result = CliRunner().invoke(main, arguments)
    assert result.exit_code == 0, result.output


def test_the_output_shown_is_the_output():
    shown = re.search(r"\$ workbench (show \S+)\n(.*?)```", README, re.DOTALL)
    lines = CliRunner().invoke(main, shown[1].split()).output.splitlines()
    claimed = [line.rstrip() for line in shown[2].splitlines() if line != "…"]
    missing = [line for line in claimed if line not in {x.rstrip() for x in lines}]
    assert shown[2] and not missing


def test_the_python_example():
    outcomes = [
        str(eval(line.split("  #")[0], {"check": __import__("workbench").check}).verdict.outcome)
        for line in block("python").splitlines()
        if line.startswith("check(")
    ]
    said = re.findall(r"# .*?(proved|refuted)$", block("python"), re.MULTILINE)
    assert outcomes == said == ["proved", "refuted", "proved"]


def test_the_example_paper_is_toml():
    assert tomllib.loads(block("toml"))["claim"]
