"""Scores of pages without a model against their truth: the false rows found, and the false alarms."""

from __future__ import annotations

import json
import tempfile
import time
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from tests.drafts import judged_draft_of
from workbench.context.claims import Claim
from workbench.core.verdict import Grade, Outcome

HERE = Path(__file__).resolve().parent
_FALSE = frozenset({Outcome.REFUTED, Outcome.ILL_FORMED})


@dataclass(frozen=True)
class Page:
    """A page, and the lines of the rows that its truth calls false."""

    path: Path
    false: frozenset[int]

    @property
    def name(self) -> str:
        return f"{self.path.parent.name}/{self.path.name}"


@dataclass(frozen=True)
class Score:
    """What is found on a page.

    found, missed: lines of false rows with and without an error or a warning.
    alarms: lines of other rows with one.
    """

    name: str
    found: tuple[int, ...]
    missed: tuple[int, ...]
    alarms: tuple[int, ...]
    seconds: float = 0.0

    def to_dict(self) -> dict[str, object]:
        return {key: list(getattr(self, key)) for key in ("found", "missed", "alarms")}


def pages(folder: Path = HERE) -> list[Page]:
    """Returns the pages of a folder and of those in it, by name."""
    truths = sorted(folder.rglob("*.truth"))
    return [_page(truth) for truth in truths]


def _page(truth: Path) -> Page:
    (path,) = (each for each in truth.parent.glob(f"{truth.stem}.*") if each.suffix in (".tex", ".md"))
    rows = (line.split("\t") for line in truth.read_text(encoding="utf-8").splitlines())
    return Page(path, frozenset(int(row[0]) for row in rows if len(row) > 1 and row[1] == "false"))


def scored(page: Page) -> Score:
    """Returns the score of a page under its draft, judged in a folder without other files."""
    start = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder, page.path.name)
        copy.write_text(page.path.read_text(encoding="utf-8"), encoding="utf-8")
        results = judged_draft_of(copy)
    warned = [
        each.claim
        for each in results
        if each.verdict.outcome in _FALSE and each.verdict.grade in (Grade.ERROR, Grade.WARNING)
    ]
    found = {line for line in page.false if any(_covers(claim, line) for claim in warned)}
    alarms = {claim.line or 0 for claim in warned if not any(_covers(claim, line) for line in page.false)}
    lines = (tuple(sorted(each)) for each in (found, page.false - found, alarms))
    return Score(page.name, *lines, time.perf_counter() - start)


def _covers(claim: Claim, line: int) -> bool:
    """True if the line prints a part of the formula."""
    span = claim.context.span
    return claim.line == line if span is None else span.line <= line <= max(span.end_line, span.line)


def table(scores: Sequence[Score]) -> str:
    """Returns a row for each page, and the sums."""
    rows = [f"{'page':36} {'found':>7} {'alarms':>6} {'s':>6}  missed lines; alarms"]
    for each in scores:
        false = len(each.found) + len(each.missed)
        lines = ", ".join(map(str, each.missed)) + (
            f"; {', '.join(map(str, each.alarms))}" if each.alarms else ""
        )
        rows.append(
            f"{each.name:36} {f'{len(each.found)}/{false}':>7} {len(each.alarms):>6} {each.seconds:>6.1f}  {lines}"
        )
    return "\n".join([*rows, summary(scores)])


def summary(scores: Iterable[Score]) -> str:
    """Returns recall and precision over all pages."""
    all_of = list(scores)
    found, missed, alarms = (
        sum(len(getattr(each, key)) for each in all_of) for key in ("found", "missed", "alarms")
    )
    recall, right = found / max(found + missed, 1), found / max(found + alarms, 1)
    return (
        f"{len(all_of)} pages: {found} of {found + missed} false rows found ({recall:.0%}), "
        f"{alarms} false alarms ({right:.0%} of errors and warnings right)"
    )


def expected() -> dict[str, Mapping[str, object]]:
    """Returns the frozen scores by page."""
    path = HERE / "expected.json"
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}


def write_expected(scores: Iterable[Score]) -> None:
    """Freezes the scores beside those of other pages."""
    kept = {**expected(), **{each.name: each.to_dict() for each in scores}}
    lines = [f" {json.dumps(name)}: {json.dumps(kept[name])}" for name in sorted(kept)]
    (HERE / "expected.json").write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")
