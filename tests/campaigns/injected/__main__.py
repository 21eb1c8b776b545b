"""Misprints put into proved formulas: python -m tests.campaigns.injected --count 300 --manifest injected.jsonl

One at a time over the chapter, the installed texts and the corrected errata: how many are found, corrected as
it was, and silent, by kind."""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from random import Random

os.environ["WORKBENCH_CACHE"] = os.devnull
sys.path.insert(0, str(Path(__file__).resolve().parent))

from injected_errors import (
    FALSE_PROOF,
    FOUND,
    KINDS,
    SILENT,
    STILL_TRUE,
    Injected,
    injected,
    proved_claims,
    sample,
)


def main(arguments: Sequence[str]) -> int:
    """The exit status: 1 where something false is proved."""
    parser = argparse.ArgumentParser(prog="python -m tests.campaigns.injected", description=__doc__)
    parser.add_argument("--count", type=int, default=300, help="misprints; 0 for one of each kind and claim")
    parser.add_argument("--seed", type=int, default=39)
    parser.add_argument("--seconds", type=float, default=5.0, help="of each search for the correction")
    parser.add_argument(
        "--source", nargs="*", default=[], help="chapter, errata, or names of installed texts"
    )
    parser.add_argument("--manifest", type=Path, help="a file for one JSON line a misprint")
    options = parser.parse_args(arguments)
    start = time.perf_counter()
    chosen = sample(Random(options.seed), list(proved_claims(options.source)), options.count)
    rows = [row for each in chosen if (row := injected(*each, options.seconds)) is not None]
    if options.manifest is not None:
        lines = (json.dumps(row.to_dict(), ensure_ascii=False, sort_keys=True) for row in rows)
        options.manifest.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(table(rows), f"\n{time.perf_counter() - start:.0f} s", sep="")
    return 1 if any(row.result == FALSE_PROOF for row in rows) else 0


def table(rows: Sequence[Injected]) -> str:
    """By kind: how many are false, found, corrected, silent."""
    lines = [f"{'kind':18} {'false':>6} {'found':>6} {'corrected':>9} {'silent':>6} {'still true':>10}"]
    for kind in (*KINDS, "all"):
        own = [row for row in rows if kind in ("all", row.kind)]
        found = [row for row in own if row.result == FOUND]
        silent = sum(row.result == SILENT for row in own)
        wrong = sum(row.result == FALSE_PROOF for row in own)
        true = sum(row.result == STILL_TRUE for row in own)
        fixed = sum(row.corrected for row in found)
        lines.append(
            f"{kind:18} {len(found) + silent + wrong:>6} {len(found):>6} {fixed:>9} {silent:>6} {true:>10}"
        )
    reasons: dict[str, int] = {}
    for row in rows:
        if row.result == SILENT:
            reasons[row.reason[:90]] = reasons.get(row.reason[:90], 0) + 1
    lines += [f"{count:>6}  {reason}" for reason, count in sorted(reasons.items(), key=lambda x: -x[1])]
    return "\n".join(lines)


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
