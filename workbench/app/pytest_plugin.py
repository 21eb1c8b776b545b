"""pytest plugin: each claim of a paper file is a test item, `file.toml::58.det`.

A TOML file without `[[claim]]` is ignored, unless it is named on the command line.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from _pytest._code.code import TerminalRepr, TracebackStyle

    from workbench.app.pipeline.judge_claims import PaperJudge
    from workbench.papers import Claim
    from workbench.prover.results.claim_results import ClaimResult

_CLAIM_HEADER = re.compile(rb"^\s*\[\[\s*(claim|\"claim\"|'claim')\s*\]\]", re.MULTILINE)


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    if file_path.suffix != ".toml":
        return None
    if parent.session.isinitpath(file_path) or _has_claims(file_path):
        return PaperFile.from_parent(parent, path=file_path)
    return None


def _has_claims(path: Path) -> bool:
    try:
        return _CLAIM_HEADER.search(path.read_bytes()) is not None
    except OSError:
        return False


class PaperFile(pytest.File):
    """A paper file; its claims share one judge."""

    def collect(self) -> Iterator[ClaimItem]:
        from workbench.app.pipeline.judge_claims import PaperJudge
        from workbench.papers import PaperError
        from workbench.papers.load import load_part

        try:
            paper = load_part(self.path)
        except PaperError as error:
            raise self.CollectError("\n".join(str(fault) for fault in error.faults)) from None
        if paper.faults:
            raise self.CollectError("\n".join(str(error) for error in paper.faults))
        judge = PaperJudge(paper)
        for claim in paper.claims:
            yield ClaimItem.from_parent(self, name=claim.id, claim=claim, judge=judge)


class NotAsExpected(Exception):
    """The verdict of a claim is not the one that its keys expect."""

    def __init__(self, result: ClaimResult) -> None:
        super().__init__(result.why_not)
        self.result = result


class DoubtfulVerdict(UserWarning):
    """A claim is false, unless an unconfirmed fact holds."""


class ClaimItem(pytest.Item):
    """A test that passes if the claim has the verdicts that its keys expect.

    A claim of a text is skipped if it is not judged, and warns if it is false under a doubt.
    """

    def __init__(self, *, name: str, parent: pytest.Collector, claim: Claim, judge: PaperJudge) -> None:
        super().__init__(name, parent)
        self.claim, self.judge = claim, judge

    def runtest(self) -> None:
        from workbench.core.verdict import Grade

        result = self.judge.result(self.claim)
        if result.shown is Grade.ERROR:
            raise NotAsExpected(result)
        if result.shown is Grade.WARNING:
            warnings.warn(DoubtfulVerdict(f"claim {self.claim.id}: {result.why_not}"), stacklevel=1)
        if result.shown is Grade.NOT_JUDGED:
            pytest.skip(result.why_not)

    def repr_failure(
        self, excinfo: pytest.ExceptionInfo[BaseException], style: TracebackStyle | None = None
    ) -> str | TerminalRepr:
        from workbench.app.commands.terminal import claim_lines
        from workbench.papers import PaperError

        if isinstance(excinfo.value, PaperError):
            return str(excinfo.value)
        if not isinstance(excinfo.value, NotAsExpected):
            return super().repr_failure(excinfo, style)
        place = f"{self.claim.source.file}:{self.claim.line}: claim {self.claim.id}"
        lines = [str(line) for line in claim_lines(excinfo.value.result)]
        return "\n".join([place, str(excinfo.value), *lines])

    def reportinfo(self) -> tuple[Path, int, str]:
        return self.path, self.claim.line - 1, f"claim {self.claim.id}"
