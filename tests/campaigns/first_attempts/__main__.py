"""Counts verdicts on texts at their first attempt: python -m tests.campaigns.first_attempts [S1] [S2] [mutants]

With `renaming`: the verdicts that other letters change."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Sequence
from functools import partial
from pathlib import Path

os.environ["WORKBENCH_CACHE"] = os.devnull
sys.path[:0] = [str(Path(__file__).resolve().parents[2]), str(Path(__file__).resolve().parent)]

from first_attempts import (  # noqa: E402
    changed_by_renaming,
    models,
    mutants_of,
    rows_of,
    tally,
    usable,
    without_claims,
    without_properties,
)

CHANGES = {"S1": without_claims, "S2": without_properties}


def main(asked: Sequence[str]) -> None:
    for name in asked or ("S1", "S2", "mutants", "renaming"):
        start = time.perf_counter()
        if name == "renaming":
            for file in models():
                for claim, one, two in changed_by_renaming(file, without_properties):
                    print(f"  {file.stem} {claim}: {one.outcome} {one.reason} → {two.outcome} {two.reason}")
        elif name == "mutants":
            rows = usable(models(), lambda file: mutants_of(file, without_claims, 37))
            print(name, dict(tally(rows)[False]))
            print(*(f"  {row}" for row in rows if str(row.verdict.grade) != "error"), sep="\n")
        else:
            rows = usable(models(), partial(rows_of, change=CHANGES[name]))
            counts = tally(rows)
            print(name, "false:", dict(counts[False]), "true:", dict(counts[True]))
            wrong = [r for r in rows if r.is_true == (str(r.verdict.grade) in ("error", "warning"))]
            print(*(f"  {row}" for row in wrong), sep="\n")
        print(f"{name}: {time.perf_counter() - start:.0f} s", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
