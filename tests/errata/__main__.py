"""The public misprints from the command line: python -m tests.errata [FOLDER] [--drafted] [--case AH1 …]

Prints the table and compares it with expected.json beside it; --write freezes the table."""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
import tomllib
from collections.abc import Sequence
from pathlib import Path

os.environ["WORKBENCH_CACHE"] = os.devnull
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from errata_cases import SECONDS, Row, case_in, measured  # noqa: E402
from errata_table import differences, expected, table, write_expected  # noqa: E402

from workbench.core.formula_errors import ReadError  # noqa: E402
from workbench.core.paper_errors import PaperError  # noqa: E402


def main(arguments: Sequence[str]) -> int:
    """The exit status: 1 where a row is worse than expected."""
    parser = argparse.ArgumentParser(prog="python -m tests.errata", description=__doc__)
    parser.add_argument("folder", type=Path, nargs="?", default=HERE, help="of cases; this one if none")
    parser.add_argument("--drafted", action="store_true", help="without the models of the cases")
    parser.add_argument("--case", nargs="*", default=[], help="only these cases")
    parser.add_argument("--seconds", type=float, default=SECONDS, help="of each search for a correction")
    parser.add_argument("--write", action="store_true", help="write what is found to expected.json")
    parser.add_argument("--json", action="store_true", help="print the rows as JSON")
    options = parser.parse_args(arguments)
    start = time.perf_counter()
    rows: dict[Row, float] = {}
    for folder in sorted(file.parent for file in options.folder.glob("*/case.toml")):
        if not options.case or folder.name in options.case:
            try:
                row, seconds = measured(case_in(folder), options.drafted, options.seconds)
            except (PaperError, ReadError, OSError, tomllib.TOMLDecodeError) as fault:
                print(f"{folder.name}: {fault}", file=sys.stderr)
                return 2
            rows[row] = seconds
            print(f"{row.name}: {seconds:.1f} s", file=sys.stderr)
    if options.json:
        print(json.dumps([row.to_dict() for row in rows], indent=1))
    else:
        print(table(rows), f"\n{time.perf_counter() - start:.0f} s", sep="")
    if options.write:
        write_expected(options.folder, options.drafted, list(rows))
    worse = differences(list(rows), expected(options.folder, options.drafted))
    print(*worse, sep="\n", end="\n" * bool(worse))
    return 1 if worse else 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
