"""Recall and precision on pages without a model: python -m tests.pages [FOLDER] [--page NAME …]

Prints the table and compares it with expected.json beside it; --write freezes the table."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from pathlib import Path

os.environ["WORKBENCH_CACHE"] = os.devnull
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from page_scores import expected, pages, scored, table, write_expected  # noqa: E402


def main(arguments: Sequence[str]) -> int:
    """Returns the exit status: 1 if a score differs from the expected one."""
    parser = argparse.ArgumentParser(prog="python -m tests.pages", description=__doc__)
    parser.add_argument("folder", type=Path, nargs="?", default=HERE, help="of pages; all if none")
    parser.add_argument("--page", nargs="*", default=[], help="only pages with one of these in their names")
    parser.add_argument("--write", action="store_true", help="write the scores to expected.json")
    options = parser.parse_args(arguments)
    chosen = [
        each
        for each in pages(options.folder)
        if not options.page or any(part in each.name for part in options.page)
    ]
    scores = []
    for page in chosen:
        scores.append(scored(page))
        print(f"{page.name}: {scores[-1].seconds:.1f} s", file=sys.stderr)
    print(table(scores))
    frozen = expected()
    other = [each for each in scores if frozen.get(each.name, each.to_dict()) != each.to_dict()]
    for each in other:
        print(f"{each.name}: {each.to_dict()}, expected {frozen[each.name]}")
    if options.write:
        write_expected(scores)
    return 1 if other else 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
