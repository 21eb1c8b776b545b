"""The result on a claim: the verdict on each of its forms, and the conclusions from them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, reduce

from workbench.context.claim_parts import ClaimForm
from workbench.context.claims import Claim, Formula
from workbench.core.codes.verdict_codes import ResultCode, VerdictCode
from workbench.core.hypotheses import Hypothesis
from workbench.core.reasons import Reason
from workbench.core.verdict import Counterexample, Grade, Outcome, Verdict
from workbench.prover.results.motion_summary import Witnessed, witnessed
from workbench.prover.results.proposed_form import Proposed
from workbench.source.documents.source_edits import SourceEdit
from workbench.source.typeset.differences import difference

#: Outcomes that count as true; a definition is true because it is one.
HOLDS = frozenset({Outcome.PROVED, Outcome.DEFINITION})


@dataclass(frozen=True)
class Certification:
    """The recorded result of Coq for one form of a claim, or for the steps of its theorem.

    `word`: the whole result in words. Nothing in it depends on the machine's speed.
    """

    form: str
    checked_by: str | None
    axioms: tuple[str, ...]
    scope: str | None
    statement: str | None
    premises_met: str | None
    obstacle: str | None
    word: str


@dataclass(frozen=True)
class ClaimResult:
    """The verdict on a claim as printed, on its reading and on its correction.

    proposed, certificates: the proposals of the search and the results of Coq; None if not requested.
    edits: of the author's characters, which turn the formula into the first proposal.
    edited: the author's formula with these edits, macros expanded.
    known: whether a baseline already lists the claim as wrong.
    """

    claim: Claim
    verdict: Verdict
    reading: Verdict | None = None
    corrected: Verdict | None = None
    proposed: tuple[Proposed, ...] | None = None
    certificates: tuple[Certification, ...] | None = None
    edits: tuple[SourceEdit, ...] = ()
    edited: str | None = None
    known: bool = False

    @property
    def expected(self) -> Outcome:
        return self.claim.expected

    @property
    def passed(self) -> bool:
        return not self.why_not

    @property
    def is_wrong(self) -> bool:
        """True if the claim is reported as an error or a warning."""
        return self.shown in (Grade.ERROR, Grade.WARNING)

    @cached_property
    def shown(self) -> Grade:
        """The grade under which the claim is reported.

        A verdict that the claim's keys announce is not an error of the file; any other unexpected verdict is.
        A claim that a baseline already lists as wrong is a note.
        """
        if self.known:
            return Grade.NOTE
        if self.passed:
            return Grade.OK if self.verdict.outcome in HOLDS else Grade.NOTE
        is_announced = self.claim.context.span is None or self.expected is not Outcome.PROVED
        if is_announced or self.verdict.outcome in HOLDS:
            return Grade.ERROR
        return self.verdict.grade

    @cached_property
    def why_not(self) -> str:
        """If the claim did not pass, the expected verdict and the actual one; else ""."""
        found = list(_unexpected(self))
        return (
            reduce(lambda first, second: ResultCode.SEVERAL(first=first, second=second), found)
            if found
            else ""
        )

    @property
    def verdicts(self) -> dict[str, Verdict]:
        """The verdicts by form."""
        found = dict(zip(ClaimForm, (self.verdict, self.reading, self.corrected), strict=True))
        return {form: verdict for form, verdict in found.items() if verdict is not None}

    @property
    def right(self) -> Formula | None:
        """The correct formula in place of the printed one, if there is one."""
        return self.claim.corrected or self.claim.reading

    @property
    def hypothesis(self) -> Hypothesis | None:
        """The condition that the text does not state."""
        own = self.claim.correction.hypothesis
        return self.verdict.hypothesis if own is None else Hypothesis.of(own.latex)

    @property
    def counterexample(self) -> Counterexample | None:
        """The counterexample to the printed form, or else to its reading."""
        if self.verdict.counterexample or self.reading is None:
            return self.verdict.counterexample
        return self.reading.counterexample

    @cached_property
    def on_motions(self) -> Witnessed:
        """The results of Drake's motions on its forms."""
        return witnessed(self.verdicts)

    @cached_property
    def fault(self) -> str | None:
        """The claim's `fault`, or the derived one; None if it is right as printed or nothing is known.

        Derived: a claim that needs a condition lacks a hypothesis, unless its text states the condition
        elsewhere; one that is false as meant is an error; one that is right as meant is a loss of the
        transcription if only marks differ, else a misprint.
        """
        claim, outcome = self.claim, self.verdict.outcome
        if claim.mend.fault is not None or outcome in HOLDS | {Outcome.UNCHECKED, Outcome.PROBABLE}:
            return claim.mend.fault
        if outcome is Outcome.CONDITIONAL and claim.correction.hypothesis is None:
            is_stated = claim.context.span is not None and self.verdict.grade is Grade.OK
            return None if is_stated else "hypothesis"
        if outcome in (Outcome.CONDITIONAL, Outcome.ARGUED) and claim.correction.hypothesis is not None:
            return "hypothesis"
        if outcome is Outcome.ARGUED:
            return "error" if claim.corrected is not None else None
        if Outcome.REFUTED in (outcome, self.reading and self.reading.outcome):
            return "error"
        return "transcription" if _only_marks_differ(claim) else "misprint"


def _only_marks_differ(claim: Claim) -> bool:
    if claim.reading is None or not claim.printed.latex:
        return False
    found = difference(claim.printed.latex, claim.reading.latex)
    return bool(found and found.changes and all(change.kind == "mark" for change in found.changes))


def _unexpected(result: ClaimResult) -> Iterator[Reason]:
    claim = result.claim
    is_idle = result.verdict.code is VerdictCode.SAME_TERM and result.expected is Outcome.PROVED
    if claim.context.span is not None and is_idle:  # a step of a chain of the form x = x
        return
    if claim.unread is None or result.verdict.outcome not in HOLDS:  # no verdict was expected yet
        yield from _differs("as printed", result.expected, result.verdict)
    if result.reading is not None:
        intended = Outcome.PROVED
        if claim.corrected is not None:
            intended = Outcome.REFUTED
        elif claim.correction.hypothesis is not None:
            intended = Outcome.CONDITIONAL
        yield from _differs("the reading", intended, result.reading)
    if result.corrected is not None:
        yield from _differs("the correction", Outcome.PROVED, result.corrected)


def _differs(what: str, expected: Outcome, verdict: Verdict) -> Iterator[Reason]:
    got = verdict.outcome
    if got == Outcome.PROVED and not verdict.evidence:
        yield ResultCode.WITHOUT_EVIDENCE(form=what)
    if got == expected or (expected == Outcome.PROVED and got in HOLDS):
        return
    if verdict.reason:
        yield ResultCode.UNEXPECTED_BECAUSE(form=what, expected=expected, got=got, reason=verdict.reason)
    else:
        yield ResultCode.UNEXPECTED(form=what, expected=expected, got=got)
