"""The campaign on public texts: python -m tests.campaigns.public_texts FOLDER --out RESULTS.jsonl --jobs 2

Each text below FOLDER is judged by `workbench check` without a model, in a process of its own with a limit on
time. RESULTS gets a line for each text; the same command goes on where it stopped. Then the table is printed, and
a sample of findings to look at by eye.
"""

from __future__ import annotations

import argparse
import json
import random
import subprocess
import sys
from collections import Counter
from collections.abc import Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from time import monotonic
from typing import Any

from workbench.source.documents import texts_in

COMMAND = [sys.executable, "-m", "workbench", "check", "--format", "json", "--no-proposals", "--no-motions"]
KEPT = ("printed", "verdict", "grade", "basis", "reason", "unless", "counterexample", "place", "read_back")


def judged(path: Path, seconds: float) -> dict[str, Any]:
    """Returns what the command says of a text: its claims, or why there are none."""
    start = monotonic()
    try:
        done = subprocess.run([*COMMAND, str(path)], capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return {"text": str(path), "ended": "time", "seconds": seconds}
    told = {"text": str(path), "seconds": round(monotonic() - start, 1)}
    if "Traceback" in done.stderr or done.returncode not in (0, 1, 2):
        return {**told, "ended": "traceback", "stderr": done.stderr[-2000:]}
    try:
        claims = json.loads(done.stdout)["claims"]
    except (ValueError, KeyError, TypeError):
        return {**told, "ended": "unusable", "stderr": done.stderr[-500:]}
    return {**told, "ended": "judged", "claims": [{key: each[key] for key in KEPT} for each in claims]}


def table(results: Sequence[dict[str, Any]]) -> str:
    claims = [claim for each in results for claim in each.get("claims", ())]
    read = [claim for claim in claims if not (claim["reason"] or "").startswith("cannot be read")]
    grades = Counter(claim["grade"] for claim in claims)
    ended = Counter(each["ended"] for each in results)
    rows = [("texts", len(results)), *ended.items(), ("formulas", len(claims)), ("read", len(read))]
    rows += [("decided", sum(claim["verdict"] != "unchecked" for claim in claims)), *grades.items()]
    rows.append(("seconds", round(sum(each["seconds"] for each in results))))
    return "\n".join(f"{name:>12} {count:>7}" for name, count in rows)


def findings(results: Iterable[dict[str, Any]]) -> list[dict[str, Any]]:
    return [
        {"text": each["text"], **claim}
        for each in results
        for claim in each.get("claims", ())
        if claim["grade"] in ("error", "warning")
    ]


def main(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--jobs", type=int, default=1, help="processes")
    parser.add_argument("--seconds", type=float, default=120.0, help="for each text")
    parser.add_argument("--count", type=int, help="only so many texts, drawn by the seed")
    parser.add_argument("--sample", type=int, default=60, help="so many findings are printed")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args(arguments)
    lines = options.out.read_text().splitlines() if options.out.exists() else []
    results = [json.loads(line) for line in lines]
    known = {each["text"] for each in results}
    texts = texts_in(options.folder)
    random.Random(options.seed).shuffle(texts)
    waiting = [path for path in texts[: options.count] if str(path) not in known]
    with options.out.open("a") as out, ThreadPoolExecutor(options.jobs) as pool:
        for each in pool.map(lambda path: judged(path, options.seconds), waiting):
            results.append(each)
            out.write(json.dumps(each, ensure_ascii=False) + "\n")
            out.flush()
    print(table(results))
    found = findings(results)
    for each in random.Random(options.seed).sample(found, min(options.sample, len(found))):
        print(
            f"\n{each['text']}:{each['place']['line']}: {each['grade']}: {each['verdict']}\n  {each['printed']}"
        )
        print(
            f"  {each['reason'] or ''}\n  unless: {'; '.join(each['unless'])}\n  {each['counterexample'] or ''}"
        )
    return 1 if any(each["ended"] == "traceback" for each in results) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
