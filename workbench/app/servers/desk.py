"""Judging in threads for the event loop of an editor server or a page, which never waits."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Hashable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from workbench.app.pipeline.changed_files import first_verdicts
from workbench.app.pipeline.judged_files import (
    SEARCH_SECONDS,
    Judged,
    Loaded,
    judged_file,
    with_corrections,
)
from workbench.runtime import interruptible

if TYPE_CHECKING:
    from workbench.papers.drafting.questions_to_author import Answer
    from workbench.prover.results.claim_results import ClaimResult

Result = TypeVar("Result")

#: Seconds for the search for the corrections of a whole text.
_ALL_SECONDS = 60.0


class Superseded(Exception):
    """The text was changed, so that the running computation is obsolete."""


class Desk:
    """Judges and corrects texts in turns; a new turn ends the previous one.

    One thread judges and searches, beside the thread of requests: a process that is forked while another
    thread forks can wait for ever. It stops waiting for a judgement or a search when a new turn begins.
    """

    def __init__(self, motions: bool = False) -> None:
        self.motions = motions
        self._turns: dict[Hashable, int] = {}
        self._working = ThreadPoolExecutor(1)

    def prepare(self) -> None:
        """Loads the engines before the first request."""
        from workbench.prover.preload import load_engines

        self._working.submit(load_engines)

    def turn(self, text: Hashable, folder: Path | None = None) -> Turn:
        """Begins a turn of a text. folder: no file outside of it is read; None for no limit."""
        self._turns[text] = self._turns.get(text, 0) + 1
        return Turn(self, text, self._turns[text], folder)

    def close(self) -> None:
        """Ends all running computations."""
        self._turns.clear()
        self._working.shutdown(wait=False, cancel_futures=True)

    def is_of(self, text: Hashable, turn: int) -> bool:
        return self._turns.get(text) == turn

    async def run(self, work: Callable[[], Result]) -> Result:
        """Returns the result of the work, done in the thread."""
        return await asyncio.get_running_loop().run_in_executor(self._working, work)


class Turn:
    """One turn of a text at a desk."""

    def __init__(self, desk: Desk, text: Hashable, number: int, folder: Path | None) -> None:
        self._desk, self._text, self._number, self._folder = desk, text, number, folder
        self._loaded: Loaded | None = None
        self._results: list[ClaimResult] = []
        self._changed: list[Judged] = []

    @property
    def judged(self) -> int:
        """The number of judged claims."""
        return len(self._results)

    @property
    def news(self) -> int:
        """A number that grows when `at_once` has more to tell."""
        return len(self._changed) or len(self._results)

    @property
    def has_standing(self) -> bool:
        """True if the first verdicts are those on a change, beside those that stand."""
        return bool(self._changed)

    def at_once(self) -> Judged | None:
        """Returns the verdicts that are ready; None before the first, and if a later turn has begun.

        After a change they are those that stand, and those on what changed.
        """
        if not self._desk.is_of(self._text, self._number):
            return None
        if self._changed:
            return self._changed[-1]
        return None if self._loaded is None else self._loaded.at_once(list(self._results))

    async def verdicts(
        self,
        path: Path,
        buffers: Mapping[Path, str],
        answers: Sequence[Answer] = (),
        before: Judged | None = None,
    ) -> Judged:
        """Returns the verdicts on a file. Raises PaperError, and Superseded if a later turn has begun.

        before: the last verdicts on the file before it changed.
        """

        def seen(loaded: Loaded, result: ClaimResult) -> None:
            self._loaded = loaded
            self._results.append(result)
            self._check()

        def told(judged: Judged) -> None:
            self._changed.append(judged)
            self._check()

        def judge() -> Judged:
            motions = self._desk.motions
            if before is not None:
                first_verdicts(path, before, buffers, motions, answers, told, self._folder)
            return judged_file(path, buffers, motions, answers, seen, self._folder)

        return await self._run(judge)

    async def corrections(self, judged: Judged) -> Judged:
        """Returns the verdicts with proved corrections; the search is shorter for more faults. Raises
        Superseded."""
        wrong = sum(result.is_wrong for result in judged.results)
        seconds = max(1.0, min(SEARCH_SECONDS, _ALL_SECONDS / max(wrong, 1)))
        search = partial(with_corrections, judged, seconds, self._check)
        return await self._run(search)

    def _check(self) -> None:
        if not self._desk.is_of(self._text, self._number):
            raise Superseded

    async def _run(self, work: Callable[[], Result]) -> Result:
        def checked() -> Result:
            self._check()
            with interruptible(self._check):
                return work()

        try:
            result = await self._desk.run(checked)
        except asyncio.CancelledError:
            if self._desk.is_of(self._text, self._number):  # and not of a later turn, which goes on
                self._desk.turn(self._text)  # ends the work in its thread
            raise
        except Exception:
            self._check()
            raise
        self._check()
        return result
