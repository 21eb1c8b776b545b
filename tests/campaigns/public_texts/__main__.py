"""The campaign on public texts: python -m tests.campaigns.public_texts FOLDER --out RESULTS.jsonl --jobs 2

Each text below FOLDER is judged by `workbench check` without a model, in a process of its own with a limit on
the time of its CPU. RESULTS gets a line for each text; the same command goes on where it stopped. Then the table is printed, and
a sample of findings to look at by eye.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import random
import resource
import signal
import sys
import traceback
from collections import Counter
from collections.abc import Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import redirect_stdout, suppress
from io import StringIO
from pathlib import Path
from tempfile import TemporaryDirectory, TemporaryFile
from typing import Any, NoReturn

from workbench.app.commands.commands import main as command
from workbench.source.documents import texts_in

ARGUMENTS = ["check", "--format", "json", "--no-proposals", "--no-motions"]
KEPT = ("printed", "verdict", "grade", "basis", "reason", "unless", "counterexample", "place", "read_back")


def judged(path: Path, seconds: float) -> dict[str, Any]:
    """Returns what the command says of a text in so many seconds of a CPU: its claims, or why there are none.

    The command runs in a fork of this process, which has imported it.
    """
    with TemporaryFile() as out, TemporaryFile() as error:
        child = os.fork()
        if not child:
            _run(path, out.fileno(), error.fileno(), math.ceil(seconds))
        _, status, used = os.wait4(child, 0)
        told = {"text": str(path), "seconds": round(used.ru_utime + used.ru_stime, 1)}
        out.seek(0)
        error.seek(0)
        printed, complaint = out.read(), error.read().decode(errors="replace")
    if os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGXCPU, signal.SIGKILL):
        return {**told, "ended": "time"}
    if "Traceback" in complaint or os.waitstatus_to_exitcode(status) not in (0, 1, 2):
        return {**told, "ended": "traceback", "stderr": complaint[-2000:]}
    try:
        claims = json.loads(printed)["claims"]
    except (ValueError, KeyError, TypeError):
        return {**told, "ended": "unusable", "stderr": complaint[-500:]}
    return {**told, "ended": "judged", "claims": [{key: each[key] for key in KEPT} for each in claims]}


def _import_all() -> None:
    """Judges a text in this process, so that no fork has to import what judging needs."""
    with TemporaryDirectory() as folder, redirect_stdout(StringIO()), suppress(SystemExit):
        text = Path(folder) / "text.md"
        text.write_text(r"The vectors $a$ and $b$: $$ a \times b + b \times a = 0 $$")
        command([*ARGUMENTS, str(text)], prog_name="workbench")


def _run(path: Path, out: int, error: int, seconds: int) -> NoReturn:
    """Runs the command in this process, with its output to two files, and ends the process."""
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))
    os.dup2(out, 1)
    os.dup2(error, 2)
    status = 3
    try:
        command([*ARGUMENTS, str(path)], prog_name="workbench")
    except SystemExit as end:
        status = end.code if isinstance(end.code, int) else 3
    except BaseException:
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)


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
    parser.add_argument("--seconds", type=float, default=30.0, help="of a CPU for each text")
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
    _import_all()
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
