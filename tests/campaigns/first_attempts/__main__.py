"""Counts verdicts on texts at their first attempt: python -m tests.campaigns.first_attempts [S1] [S2] [mutants]

With `renaming`: the verdicts that other letters change. Each text is told when it is judged; `--only` chooses texts."""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections import Counter
from collections.abc import Callable
from functools import partial
from pathlib import Path

os.environ["WORKBENCH_CACHE"] = os.devnull
sys.path[:0] = [str(Path(__file__).resolve().parents[2]), str(Path(__file__).resolve().parent)]

from first_attempts import (  # noqa: E402
    Row,
    changed_by_renaming,
    models,
    mutants_of,
    rows_of,
    tally,
    without_claims,
    without_properties,
)

from workbench.core.paper_errors import PaperError  # noqa: E402

ROWS: dict[str, Callable[[Path], list[Row]]] = {
    "S1": partial(rows_of, change=without_claims),
    "S2": partial(rows_of, change=without_properties),
    "mutants": partial(mutants_of, change=without_claims, seed=37),
}


def renaming_of(file: Path) -> None:
    for claim, one, two in changed_by_renaming(file, without_properties):
        print(f"  {file.stem} {claim}: {one.outcome} {one.reason} → {two.outcome} {two.reason}")


def is_wrong(row: Row) -> bool:
    return row.is_true == (str(row.verdict.grade) in ("error", "warning"))


def count(name: str, file: Path) -> dict[bool, Counter[str]]:
    """Returns the grades of a text by truth, and prints its wrong ones."""
    if name == "renaming":
        renaming_of(file)
        return tally([])
    rows = ROWS[name](file)
    print(*(f"  {row}" for row in rows if is_wrong(row)), sep="\n")
    return tally(rows)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("campaigns", nargs="*", default=[*ROWS, "renaming"])
    parser.add_argument("--only", nargs="*", default=[""], help="texts whose name contains one of these")
    options = parser.parse_args()
    chosen = [file for file in models() if any(part in file.stem for part in options.only)]
    for name in options.campaigns:
        totals = tally([])
        for file in chosen:
            start = time.monotonic()
            try:
                found = count(name, file)
            except PaperError as error:
                print(f"{file.stem}: {error}")
                continue
            totals[True] += found[True]
            totals[False] += found[False]
            print(f"{name} {file.stem}: {time.monotonic() - start:.0f} s", flush=True)
        print(name, "false:", dict(totals[False]), "true:", dict(totals[True]), flush=True)


if __name__ == "__main__":
    main()
