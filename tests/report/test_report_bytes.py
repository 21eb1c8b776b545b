"""Two runs of `workbench report` give the same bytes: whatever seeds Python's hashes, judged anew or remembered."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

EVERY_VERDICT = Path(__file__).parent.parent / "papers" / "every_verdict.toml"


def files(out: Path, cache: Path, seed: str, *options: str) -> dict[str, bytes]:
    call = [
        sys.executable,
        "-c",
        "from workbench.app.commands.commands import main; main()",
        "report",
        "--out",
        out,
    ]
    seeded = os.environ | {"PYTHONHASHSEED": seed, "WORKBENCH_CACHE": str(cache)}
    done = subprocess.run([*call, *options], env=seeded, capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    return {path.name: path.read_bytes() for path in out.iterdir()}


@pytest.mark.parametrize(
    "options",
    [["--paper", str(EVERY_VERDICT)], pytest.param([], marks=pytest.mark.slow)],
    ids=["all verdicts", "chapter"],
)
def test_two_runs_give_the_same_bytes(options, tmp_path):
    first = files(tmp_path / "first", tmp_path / "cache", "1", *options)
    assert len(first) == 5
    assert first == files(tmp_path / "anew", tmp_path / "another cache", "2", *options)
    assert first == files(tmp_path / "remembered", tmp_path / "cache", "3", *options)
