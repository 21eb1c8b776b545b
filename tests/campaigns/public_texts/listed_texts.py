"""The texts of the campaign: python -m tests.campaigns.public_texts.listed_texts MIRRORS FOLDER [--part PART]

texts.tsv lists them: the part of the campaign, the repository, its commit, and the path. MIRRORS holds a folder
owner+name for each repository, with its git directory as `repo`. The texts are written below FOLDER.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

LIST = Path(__file__).with_name("texts.tsv")


class ListedText(NamedTuple):
    """part: "tuned" for texts whose findings were looked at before the code changed, "held out" for others."""

    part: str
    repository: str
    commit: str
    path: str


def listed_texts() -> list[ListedText]:
    return [ListedText(*line.split("\t")) for line in LIST.read_text(encoding="utf-8").splitlines()]


def main(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mirrors", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--part", choices=sorted({each.part for each in listed_texts()}))
    options = parser.parse_args(arguments)
    missing = 0
    for each in listed_texts():
        if options.part not in (None, each.part):
            continue
        name = each.repository.replace("/", "+")
        git = ["git", "-C", str(options.mirrors / name / "repo"), "show", f"{each.commit}:{each.path}"]
        shown = subprocess.run(git, capture_output=True, check=False)
        missing += shown.returncode != 0
        if shown.returncode == 0:
            path = options.folder / name / each.path
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(shown.stdout)
    print(f"{missing} texts are missing" if missing else "all texts are written")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
