"""Runs the claims of a paper: each printed form, its reading and its correction get a verdict of their own,
and the claim passes if the verdicts are those that its keys announce."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import cache
from multiprocessing import get_all_start_methods, get_context

from workbench.judge.assumptions import Unsatisfiable
from workbench.judge.judge import Judge
from workbench.judge.verdict import Outcome, Verdict
from workbench.papers.model import Claim, Formula, Notation, Paper, PaperError
from workbench.selection import select_claims

#: Outcomes that count as true: what a definition says is true by its being one.
HOLDS = frozenset({Outcome.PROVED, Outcome.DEFINITION})

#: From this many claims on it pays to start a process for each core.
MANY = 40

Verdicts = tuple[Verdict, Verdict | None, Verdict | None]

_forked: tuple[PaperJudge, Sequence[Claim]] | None = None


@dataclass(frozen=True)
class ClaimResult:
    """The verdict on a claim as printed, on its reading and on its correction. `why_not`: if the claim did
    not pass, which verdict was expected and which one came."""

    claim: Claim
    verdict: Verdict
    reading: Verdict | None
    corrected: Verdict | None
    expected: Outcome
    passed: bool
    why_not: str = ""


class PaperJudge:
    """The judges of a paper: one for each notation, made on first use."""

    def __init__(self, paper: Paper, second_engine: bool = True, motions: bool = True) -> None:
        self.paper = paper
        self.options = {"second_engine": second_engine, "motions": motions}
        self._judges: dict[int, Judge] = {}
        self._theorem = cache(lambda name: paper.theorems[name]())  # several claims can rest on one

    def result(self, claim: Claim) -> ClaimResult:
        """Raises EngineDisagreement: a defect of the workbench, which no verdict may hide."""
        return _result(claim, *self.verdicts(claim))

    def verdicts(self, claim: Claim) -> Verdicts:
        """On the printed form, the reading and the correction; None for a form that the claim has not."""
        reading = claim.reading and self._verdict(claim, claim.reading, claim.hypothesis)
        corrected = claim.corrected and self._verdict(claim, claim.corrected, None)
        return self._printed(claim), reading, corrected

    def _printed(self, claim: Claim) -> Verdict:
        if claim.theorem is not None:
            return self._theorem(claim.theorem)
        return self._verdict(claim, claim.printed, claim.hypothesis)

    def _verdict(self, claim: Claim, formula: Formula, hypothesis: Formula | None) -> Verdict:
        if formula.ill_formed is not None:
            return Verdict(Outcome.ILL_FORMED, reason=formula.ill_formed)
        try:
            return self._judge(claim.notation).judge(
                formula.statement,
                assume=claim.supposed,
                hypothesis=hypothesis and hypothesis.statement,
                orders=claim.orders,
            )
        except Unsatisfiable as error:
            raise PaperError(claim.file, claim.line or None, None, f"claim {claim.id}: {error}") from None

    def _judge(self, notation: Notation) -> Judge:
        if id(notation) not in self._judges:
            self._judges[id(notation)] = Judge(notation.definitions, motion=notation.motion, **self.options)
        return self._judges[id(notation)]


def judge_paper(
    paper: Paper,
    select: Sequence[str] = (),
    progress: Callable[[ClaimResult], None] = lambda result: None,
    **options: bool,
) -> list[ClaimResult]:
    """The results of the selected claims, in reading order; `progress` sees each as soon as it is there.

    Many claims are judged on all cores, where the system can fork: a claim does not depend on another.
    """
    judge = PaperJudge(paper, **options)
    claims = select_claims(paper.claims, select)
    results = []
    for claim, verdicts in zip(claims, _verdicts(judge, claims), strict=True):
        results.append(_result(claim, *verdicts))
        progress(results[-1])
    return results


def _verdicts(judge: PaperJudge, claims: Sequence[Claim]) -> Iterator[Verdicts]:
    cores = os.cpu_count() or 1
    if len(claims) < MANY or cores < 2 or "fork" not in get_all_start_methods():
        yield from map(judge.verdicts, claims)
        return
    global _forked
    _forked = judge, claims  # what a forked process finds in place, without a copy being sent
    executor = ProcessPoolExecutor(cores, get_context("fork"), initializer=_end_quietly_at_an_interrupt)
    try:
        yield from executor.map(_forked_verdicts, range(len(claims)))
    finally:
        executor.shutdown(cancel_futures=True)
        _forked = None


def _end_quietly_at_an_interrupt() -> None:
    """Ctrl-C reaches all processes; the first one says what there is to say."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def _forked_verdicts(place: int) -> Verdicts:
    judge, claims = _forked
    return judge.verdicts(claims[place])


def _result(
    claim: Claim, verdict: Verdict, reading: Verdict | None, corrected: Verdict | None
) -> ClaimResult:
    expected = claim.expected
    faults = list(_faults(claim, expected, verdict, reading, corrected))
    return ClaimResult(claim, verdict, reading, corrected, expected, not faults, "; ".join(faults))


def _faults(
    claim: Claim, expected: Outcome, verdict: Verdict, reading: Verdict | None, corrected: Verdict | None
) -> Iterator[str]:
    yield from _differs("as printed", expected, verdict)
    if reading is not None:
        intended = Outcome.PROVED
        if claim.corrected is not None:
            intended = Outcome.REFUTED
        elif claim.hypothesis is not None:
            intended = Outcome.CONDITIONAL
        yield from _differs("the reading", intended, reading)
    if corrected is not None:
        yield from _differs("the correction", Outcome.PROVED, corrected)


def _differs(what: str, expected: Outcome, verdict: Verdict) -> Iterable[str]:
    got = verdict.outcome
    if got == Outcome.PROVED and not verdict.evidence:
        yield f"{what}: proved without evidence"
    if got == expected or (expected == Outcome.PROVED and got in HOLDS):
        return
    reason = f" ({verdict.reason})" if verdict.reason else ""
    yield f"{what}: expected {expected}, got {got}{reason}"
