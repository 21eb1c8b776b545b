"""The package: what its wheel holds, and that it works in an empty folder."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path
from zipfile import ZipFile

import pytest

ROOT = Path(__file__).parents[1]


def test_project_names_urls_authors_and_classifiers() -> None:
    with (ROOT / "pyproject.toml").open("rb") as file:
        project = tomllib.load(file)["project"]
    assert all(project.get(key) for key in ("urls", "authors", "classifiers", "keywords", "license"))


@pytest.mark.slow
def test_wheel_works_in_an_empty_folder(tmp_path: Path) -> None:
    uv = shutil.which("uv")
    if uv is None:
        pytest.skip("uv is not installed")
    built = subprocess.run(
        [uv, "build", "-q", "--wheel", "-o", str(tmp_path / "dist"), str(ROOT)],
        capture_output=True,
        text=True,
    )
    assert built.returncode == 0, built.stderr
    (wheel,) = (tmp_path / "dist").glob("*.whl")
    unpacked, empty = tmp_path / "unpacked", tmp_path / "empty"
    empty.mkdir()
    with ZipFile(wheel) as archive:
        archive.extractall(unpacked)
    source = "\n".join(
        [
            "import workbench",
            "from workbench.app.commands.commands import main",
            "print(workbench.__file__)",
            "main(['help', 'frames'], standalone_mode=False)",
            "main(['help', 'messages'], standalone_mode=False)",
            "main(['try', 'a \\\\times a = 0', '-s', 'a=vector'])",
        ]
    )
    done = subprocess.run(
        [sys.executable, "-c", source],
        cwd=empty,
        env=os.environ | {"PYTHONPATH": str(unpacked)},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert str(unpacked) in done.stdout and "# Frames and points" in done.stdout and "✓ holds" in done.stdout
