"""The public misprints of tests/errata without any model: found, at their place, and false alarms after the mend.

python tests/campaigns/drafts/errata_without_models.py [FOLDER]
"""

from __future__ import annotations

import os
import sys
import tomllib
from pathlib import Path

os.environ["WORKBENCH_CACHE"] = os.devnull
ROOT = Path(__file__).resolve().parents[3]
sys.path[:0] = [str(ROOT)]

from workbench.budget import Budget  # noqa: E402
from workbench.ingest.draft import draft_of, on_drafted_kinds  # noqa: E402
from workbench.judge.verdict import Grade, Outcome  # noqa: E402
from workbench.papers.model import PaperError  # noqa: E402
from workbench.verify.claims import judge_paper  # noqa: E402
from workbench.verify.results import ClaimResult  # noqa: E402

SHOWN = {Grade.ERROR, Grade.WARNING}
TRUE = {Outcome.PROVED, Outcome.CONDITIONAL, Outcome.DEFINITION}


def judged(path: Path) -> list[ClaimResult]:
    """The results of a text under its draft; none where it has no display."""
    try:
        draft = draft_of(path)
    except PaperError:
        return []
    return on_drafted_kinds(draft, judge_paper(draft.paper, motions=False, budget=Budget.of(seconds=10)))


def main(folder: Path) -> None:
    found = alarms = decidable = displays = judgements = 0
    for case in sorted(folder.glob("*/case.toml")):
        about = tomllib.loads(case.read_text("utf-8"))
        before, after = (
            judged(next(path for path in case.parent.glob(f"{name}.*") if path.suffix != ".toml"))
            for name in ("before", "after")
        )
        lines = [int(each["line"]) for each in about["correction"]]
        shown = [result for result in before if result.shown in SHOWN]
        wrong = [result for result in after if result.shown in SHOWN]
        is_found = any(_covers(result, line) for result in shown for line in lines)
        is_decidable = str(about["decidable"]).startswith("yes")
        decidable, found = decidable + is_decidable, found + (is_found and is_decidable)
        alarms, displays = alarms + len(wrong), displays + len(after)
        judgements += sum(result.verdict.outcome in TRUE for result in after)
        reasons = [f"{r.verdict.outcome}: {r.verdict.reason or r.claim.printed.unread or ''}" for r in before]
        state = "found" if is_found else "silent" if is_decidable else "not decidable"
        print(f"{case.parent.name:5} {state:14} {len(wrong)} alarms  {'; '.join(reasons)[:150]}")
    print(
        f"{found} of {decidable} decidable misprints found; {alarms} false alarms on {displays} true formulas"
    )


def _covers(result: ClaimResult, line: int) -> bool:
    claim = result.claim
    first = claim.span.line if claim.span else claim.line
    last = claim.span.end_line if claim.span else claim.line
    return first - bool(claim.chain) <= line <= last


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "tests" / "errata")
