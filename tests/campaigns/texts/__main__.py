"""The campaign on texts from the command line: python -m tests.campaigns.texts --count 5000 --seed 1 --jobs 2

With --checkout DIR the product of another checkout is judged, by its own interpreter."""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

os.environ["WORKBENCH_CACHE"] = os.devnull
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from context_laws import laws  # noqa: E402
from judged_claims import Judged, judged  # noqa: E402
from tally import tables, told, wrong  # noqa: E402
from written_documents import documents  # noqa: E402


def main(arguments: Sequence[str]) -> int:
    """The exit status: 1 where a verdict is wrong."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=500, help="at least so many formulas")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1, help="processes")
    parser.add_argument("--show", type=int, default=0, help="so many wrong findings in full")
    parser.add_argument(
        "--laws", type=int, default=0, help="count renaming and irrelevance on so many formulas"
    )
    parser.add_argument("--save", type=Path, help="a folder for the documents with wrong findings")
    parser.add_argument("--checkout", type=Path, help="judge the product of this checkout")
    options = parser.parse_args(arguments)
    if options.checkout is not None:
        return _elsewhere(options.checkout, arguments)
    start = time.perf_counter()
    results = _all_judged(options)
    print(tables(results))
    faults = wrong(results)
    for each in faults[: options.show]:
        print(told(each), "\n")
    if options.save is not None:
        _save(options.save, results)
    if options.laws:
        print(laws(options.seed, options.laws))
    print(f"{len(faults)} wrong findings, {time.perf_counter() - start:.0f} s")
    return 1 if faults or any(one.broken for one in results) else 0


def _all_judged(options: argparse.Namespace) -> list[Judged]:
    texts = documents(options.seed, options.count)
    if options.jobs == 1:
        return [judged(each) for each in texts]
    with ProcessPoolExecutor(options.jobs) as pool:
        return list(pool.map(judged, texts))


def _save(folder: Path, results: Sequence[Judged]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for place, one in enumerate(results):
        if one.broken or wrong([one]):
            (folder / f"{place}").mkdir(exist_ok=True)
            (folder / f"{place}" / f"text.{one.document.format}").write_text(one.document.text)
            (folder / f"{place}" / "text.toml").write_text(one.document.model)


def _elsewhere(checkout: Path, arguments: Sequence[str]) -> int:
    rest, skip = [], False
    for each in arguments:
        if not skip and not each.startswith("--checkout"):
            rest.append(each)
        skip = each == "--checkout"
    python = checkout.resolve() / ".venv" / "bin" / "python"
    with tempfile.TemporaryDirectory() as folder:
        return subprocess.run([python, HERE / "__main__.py", *rest], cwd=folder, check=False).returncode


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
