"""Judges the claims of a paper: printed form, reading and correction get separate verdicts.

A claim passes if these verdicts are those that its keys expect.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Protocol, TypedDict, Unpack

from workbench.app.pipeline.motion_witnesses import Witnesses
from workbench.app.pipeline.verdict_keys import Keys, Memory
from workbench.context.circular_conditions import without_circular
from workbench.context.claim_parts import ClaimForm
from workbench.context.claims import Claim, Formula, Notation, Paper
from workbench.core.codes.input_codes import InputCode
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.paper_errors import PaperError
from workbench.core.reasons import reason_of
from workbench.core.terms import Relation
from workbench.core.verdict import Evidence, Outcome, Verdict
from workbench.engines.inventory.assumptions import Unsatisfiable
from workbench.language.goals.proofs import Proven
from workbench.language.printing.author_spelling import printed_for
from workbench.papers.selection import select_claims
from workbench.prover.explain.ambiguous_displays import in_both_readings, served_by, with_what_stands_beside
from workbench.prover.explain.decide_under_facts import judged_alone, judged_or_unchecked
from workbench.prover.explain.explain import Explainer
from workbench.prover.explain.shared_guesses import on_shared_guesses
from workbench.prover.preload import load_engines
from workbench.prover.results.claim_results import ClaimResult
from workbench.runtime import STANDARD, Budget, OutOfBudget, Workers

if TYPE_CHECKING:
    from workbench.prover.decide.decide import Judge
    from workbench.prover.explain.goal_claims import TheoremJudge

#: The number of claims from which on a process for each core is started.
MANY = 40

#: Errors that no formula should cause; one must not cost the other formulas of a text their verdicts.
_DEFECTS = (ArithmeticError, AssertionError, AttributeError, LookupError, TypeError, ValueError)


class Pool(Protocol):
    """A pool that judges forms: local processes, or a cluster."""

    def map(self, items: Sequence[tuple[str, str]]) -> Generator[Verdict | OutOfBudget]:
        """Yields the verdict on each form of a claim, in order."""

    def close(self) -> None:
        """Ends the pool."""


class EngineOptions(TypedDict, total=False):
    """Which engines and witnesses a judge of claims asks."""

    second_engine: bool
    motions: bool


class JudgeOptions(EngineOptions, total=False):
    """What a judge of claims can be given, as `ClaimJudge` has it."""

    budget: Budget | None
    memory: Memory | None


class ClaimJudge:
    """The judges of claims: one for each notation, created on first use.

    Attributes:
        theorems: The proofs that claims may name.
        budget: The limits of each judgement.
        memory: The cache of verdicts.
    """

    def __init__(
        self,
        claims: Sequence[Claim],
        theorems: Mapping[str, Proven] = MappingProxyType({}),
        second_engine: bool = True,
        motions: bool = True,
        budget: Budget | None = None,
        memory: Memory | None = None,
    ) -> None:
        self._theorems = theorems
        self._second_engine = second_engine
        self.budget = budget or STANDARD
        self._waiting: Sequence[Claim] = ()
        self._judges: dict[tuple[int, int], Judge] = {}
        self._explainer = Explainer(self._judge, second_engine, self.budget.seconds / 2)
        self._claims = {claim.id: claim for claim in claims}
        self._workers = self._new_workers(1)
        self._memory = memory
        seen = {"second_engine": second_engine, "motions": motions, "budget": self.budget}
        self._keys = Keys(theorems, seen)
        self._witnesses = Witnesses(memory, self._keys) if motions else None

    def result(self, claim: Claim) -> ClaimResult:
        """Returns the result for one of the claims."""
        (result,) = self.results([claim])
        return result

    def results(
        self, claims: Sequence[Claim], jobs: int | None = None, pool: Pool | None = None
    ) -> Iterator[ClaimResult]:
        """Yields the results for some of the claims as soon as they are ready, cached ones first, then by
        notation.

        Many claims are judged on all cores, by `jobs` processes, or by the pool. Claims are independent. A
        pool gets its work before the first result is requested.
        """
        known = {claim.id: {form: self._recall(claim, form) for form in claim.forms} for claim in claims}
        new = _dear_first([claim for claim in claims if None in known[claim.id].values()])
        self._waiting = new
        asked = [(c.id, form) for c in new for form, verdict in known[c.id].items() if verdict is None]
        count = jobs or (os.cpu_count() or 1 if len(asked) >= MANY else 1)
        workers = pool or (self._workers if count == 1 else self._new_workers(count))
        there = [claim for claim in claims if None not in known[claim.id].values()]
        return self._collected([*there, *new], known, workers, workers.map(asked))

    def _collected(
        self,
        claims: Sequence[Claim],
        known: Mapping[str, dict[ClaimForm, Verdict | None]],
        workers: Pool,
        verdicts: Generator[Verdict | OutOfBudget],
    ) -> Iterator[ClaimResult]:
        try:
            for claim in claims:
                found = known[claim.id]
                for form in found:
                    if found[form] is None:
                        found[form] = self._remember(claim, form, next(verdicts))
                printed = found[ClaimForm.PRINTED]
                assert printed is not None, f"{claim.id} is not judged as printed"
                reading, corrected = found.get(ClaimForm.READING), found.get(ClaimForm.CORRECTED)
                yield ClaimResult(claim, printed, reading, corrected)
        finally:
            verdicts.close()
            if workers is not self._workers:
                workers.close()

    def on_shared_guesses(self, results: Sequence[ClaimResult]) -> list[ClaimResult]:
        """Returns the results of a text; a guess that several of its formulas need is a hint in them all."""
        claims = on_shared_guesses(results)
        if not claims:
            return list(results)
        again = ClaimJudge(
            claims,
            self._theorems,
            self._second_engine,
            self._witnesses is not None,
            self.budget,
            self._memory,
        )
        try:
            own = {result.claim.id: result for result in again.results(claims, jobs=1)}
        finally:
            again.close()
        return [own.get(result.claim.id, result) for result in results]

    def key(self, claim: Claim, form: str) -> str:
        """Returns the cache key of the verdict on a form: a digest of everything that it depends on."""
        return self._keys.of(claim, form)

    def judged_now(self, claim: Claim, form: str) -> Verdict | OutOfBudget:
        """Returns the verdict on one form, bypassing the cache."""
        self._waiting = [claim]
        (answer,) = self._workers.map([(claim.id, form)])
        return answer

    def _recall(self, claim: Claim, form: str) -> Verdict | None:
        return self._memory.recall(self._keys.of(claim, form)) if self._memory else None

    def _remember(self, claim: Claim, form: str, answer: Verdict | OutOfBudget) -> Verdict:
        """Returns the answer as a verdict, and caches it unless it depends on the speed of the machine."""
        if isinstance(answer, OutOfBudget):
            return Verdict(Outcome.UNCHECKED, reason=VerdictCode.OUT_OF_BUDGET(limit=answer))
        if self._memory:
            self._memory.remember(self._keys.of(claim, form), answer)
        return answer

    def close(self) -> None:
        """Ends the worker processes."""
        self._workers.close()

    def _new_workers(self, count: int) -> Workers:
        return Workers(self._verdict_on, self.budget, count, self._prepare, self._notation_of)

    def _notation_of(self, name_and_form: tuple[str, str]) -> int:
        return id(self._claims[name_and_form[0]].notation)

    def _prepare(self) -> None:
        load_engines()
        if any(claim.proof.goal is not None for claim in self._waiting):
            _ = self._of_theorems
        if self._witnesses:
            for claim in self._waiting:
                self._witnesses.prepare(claim)

    def _verdict_on(self, name_and_form: tuple[str, str]) -> Verdict:
        name, form = name_and_form
        claim = self._keys.parts.of(self._claims[name])
        with printed_for(claim.notation.author_notation):
            try:
                if form == ClaimForm.PRINTED:
                    return self._printed(claim)
                under = claim.correction.hypothesis if form == ClaimForm.READING else None
                return self._verdict(claim, claim.forms[ClaimForm(form)], under)
            except PaperError as error:
                raise _placed(error, self._claims[name]) from None
            except _DEFECTS as error:
                if claim.context.span is None:
                    raise
                return Verdict(Outcome.UNCHECKED, reason=VerdictCode.DEFECT(error=repr(error)))

    def _printed(self, claim: Claim) -> Verdict:
        if claim.proof.goal is not None:
            verdict = judged_or_unchecked(lambda: self._of_theorems.verdict(claim))
            return self._seen(verdict, claim, claim.printed, claim.correction.hypothesis)
        if claim.skip is not None:
            return Verdict(Outcome.UNCHECKED, reason=VerdictCode.LEFT_OUT(why=claim.skip))
        return in_both_readings(claim, self._in_one_reading(claim), self._in_one_reading)

    def _in_one_reading(self, claim: Claim) -> Verdict:
        free, circular = without_circular(claim)
        verdict = self._under_conditions(free)
        if circular and verdict.outcome in (Outcome.REFUTED, Outcome.UNCHECKED):
            reason = VerdictCode.CONDITION_IS_THE_CLAIM(formula=", ".join(map(str, circular)))
            return Verdict(Outcome.UNCHECKED, reason=reason, read_back=verdict.read_back)
        return verdict

    def _under_conditions(self, claim: Claim) -> Verdict:
        if claim.context.given:  # the given formulas may be hard to assume, and not needed
            free = claim.with_context(given=())
            alone = self._verdict(free, claim.printed, claim.correction.hypothesis)
            if alone.outcome is Outcome.PROVED:
                alone = self._explainer.verdict(free, alone)
            if alone.outcome is Outcome.PROVED:
                return alone
        bare = self._verdict(claim, claim.printed, claim.correction.hypothesis)
        if (served := served_by(claim, bare, self._alone)) is not None:
            reason = VerdictCode.MAY_BE_CONDITION(formula=served)
            return Verdict(Outcome.UNCHECKED, reason=reason, read_back=bare.read_back)
        verdict = self._explainer.verdict(*with_what_stands_beside(claim, bare, self._alone))
        return _as_given(verdict, claim) if claim.context.given else verdict

    @cached_property
    def _of_theorems(self) -> TheoremJudge:
        from workbench.prover.explain.goal_claims import TheoremJudge

        return TheoremJudge(self._theorems, self._judge)

    def _verdict(self, claim: Claim, formula: Formula, hypothesis: Formula | None) -> Verdict:
        if formula.ill_formed is not None:
            return Verdict(Outcome.ILL_FORMED, reason=formula.ill_formed)
        if formula.unread is not None:
            return Verdict(Outcome.UNCHECKED, reason=formula.unread)
        judge = self._judge(claim.notation)
        if claim.context.alone:
            judge = replace(judge, laws=False)
        try:
            verdict = judged_or_unchecked(
                lambda: judge.judge(
                    formula.parsed,
                    assume=claim.supposed,
                    hypothesis=None if hypothesis is None else hypothesis.statement,
                    orders=claim.orders,
                )
            )
        except Unsatisfiable as error:
            if claim.context.span is not None:
                return Verdict(Outcome.UNCHECKED, reason=reason_of(error))
            raise PaperError(None, None, None, str(error)) from None
        if verdict.outcome is Outcome.PROVED and not verdict.is_for_all:
            verdict = judged_or_unchecked(lambda: self._of_theorems.for_every_n(claim, formula, verdict))
        return self._seen(verdict, claim, formula, hypothesis)

    def _alone(self, claim: Claim) -> Verdict:
        return judged_alone(claim, self._judge)

    def _seen(self, verdict: Verdict, claim: Claim, form: Formula, hypothesis: Formula | None) -> Verdict:
        return self._witnesses.seen(verdict, claim, form, hypothesis) if self._witnesses else verdict

    def _judge(self, notation: Notation) -> Judge:
        key = id(notation.definitions), id(notation.motion)  # `JudgedParts` keeps both alive
        if key not in self._judges:
            from workbench.prover.decide.decide import Judge

            self._judges[key] = Judge(
                notation.definitions,
                bound=frozenset(s.declaration.name for s in notation.motion),
                second_engine=self._second_engine,
            )
        return self._judges[key]


def _placed(error: PaperError, claim: Claim) -> PaperError:
    """Returns the error with the position of the claim, which the judges do not know."""
    if error.file is not None:
        return error
    if error.path:  # an entry of another table of the file
        table = ".".join(map(str, error.path))
        reason = InputCode.OF_CLAIM(claim=f"{table}: {claim.id}", message=error.reason)
        return PaperError(claim.source.file, None, None, reason)
    reason = InputCode.OF_CLAIM(claim=f"claim {claim.id}", message=error.reason)
    return PaperError(claim.source.file, claim.line or None, None, reason)


def _as_given(verdict: Verdict, claim: Claim) -> Verdict:
    given = ", ".join(map(str, claim.context.given))
    evidence = (*verdict.evidence, Evidence("given", "holds always", {"formula": given}))
    reason = verdict.reason
    if verdict.outcome is Outcome.UNCHECKED and reason is not None:
        reason = VerdictCode.GIVEN_IS(reason=reason, given=given)
    return replace(verdict, reason=reason, evidence=evidence)


class PaperJudge(ClaimJudge):
    """The judges of a paper, with the given limits, the paper's, or the standard ones."""

    def __init__(self, paper: Paper, **options: Unpack[JudgeOptions]) -> None:
        options["budget"] = options.get("budget") or paper.budget
        super().__init__(paper.claims, paper.theorems, **options)
        self.paper = paper


def judge_paper(
    paper: Paper,
    select: Sequence[str] = (),
    progress: Callable[[ClaimResult], None] = lambda result: None,
    jobs: int | None = None,
    **options: Unpack[JudgeOptions],
) -> list[ClaimResult]:
    """Returns the results of the selected claims, in reading order.

    progress: called with each result as soon as it is ready.
    options: those of PaperJudge.
    """
    return _judged(PaperJudge(paper, **options), select_claims(paper.claims, select), progress, jobs)


def judge_claims(claims: Sequence[Claim], **options: Unpack[JudgeOptions]) -> list[ClaimResult]:
    """Returns the results of claims outside of a paper. options: those of ClaimJudge."""
    return _judged(ClaimJudge(claims, **options), claims)


def _judged(
    judge: ClaimJudge,
    claims: Sequence[Claim],
    progress: Callable[[ClaimResult], None] = lambda result: None,
    jobs: int | None = None,
) -> list[ClaimResult]:
    try:
        return judge.on_shared_guesses(in_order(judge.results(claims, jobs), claims, progress))
    finally:
        judge.close()


def in_order(
    results: Iterable[ClaimResult], claims: Sequence[Claim], progress: Callable[[ClaimResult], None]
) -> list[ClaimResult]:
    """Returns the results in the order of the claims."""
    found = {}
    for result in results:
        found[result.claim.id] = result
        progress(result)
    return [found[claim.id] for claim in claims]


def _dear_first(claims: Sequence[Claim]) -> list[Claim]:
    """Returns the claims by notation, groups with many expensive claims first, to balance the workers."""
    groups: dict[int, list[Claim]] = {}
    for claim in claims:
        groups.setdefault(id(claim.notation), []).append(claim)
    ordered = sorted(groups.values(), key=lambda group: sum(map(_is_likely_cheap, group)) - len(group))
    return [claim for group in ordered for claim in sorted(group, key=_is_likely_cheap)]


def _is_likely_cheap(claim: Claim) -> bool:
    """True if the claim is one relation, and no theorem, family or extremum."""
    said = [formula.statement for formula in claim.forms.values()]
    is_relation = all(statement is None or isinstance(statement, Relation) for statement in said)
    return claim.proof.goal is None and claim.orders is None and is_relation
