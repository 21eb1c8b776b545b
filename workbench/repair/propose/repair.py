"""Search for the right form of a claim, from its printed form alone.

Every proposal is proved, at least where the printed denominators do not vanish.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cached_property
from itertools import islice
from time import monotonic

from workbench.context.claims import Claim
from workbench.context.read_formulas import read_statement
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.terms import Apply, Statement, Symbol
from workbench.core.types import SCALAR
from workbench.core.verdict import Outcome, Verdict
from workbench.engines.inventory import NotExact
from workbench.language.printing.author_spelling import printed_for
from workbench.language.printing.printer import to_latex
from workbench.prover.decide.decide import Judge
from workbench.prover.explain.laws_of_motion import under_its_laws
from workbench.repair.propose.candidate_judge import judging
from workbench.repair.propose.chain_neighbours import ALONE, Neighbours
from workbench.repair.propose.fitting import FITS, fitting, says_what, with_lost_words
from workbench.repair.propose.lost_property import (
    HAS_PROPERTY,
    other_values,
    property_stated_of,
    under_guesses,
)
from workbench.repair.propose.proposal import Proposal, Repair
from workbench.repair.propose.search_limits import STANDARD, Limits
from workbench.repair.propose.symbols_like import symbols_like
from workbench.repair.screening.real_values import RealValues
from workbench.repair.screening.sameness import Sameness
from workbench.repair.screening.screen import Screen
from workbench.repair.screening.vacuous import is_idle, is_vacuous, like_terms, says_less
from workbench.repair.terms.changes import Candidate
from workbench.repair.terms.divisors import divisors
from workbench.repair.terms.edit_search import Neighbourhood, candidate_of, cost
from workbench.repair.terms.false_members import membership, other_members
from workbench.repair.terms.relation_signs import other_signs
from workbench.repair.terms.subterm_positions import places
from workbench.repair.terms.term_edits import Edit, edits
from workbench.repair.trees.as_printed import as_printed
from workbench.repair.trees.tree_readings import Readings
from workbench.runtime import OutOfBudget

_PROVED = (Outcome.PROVED, Outcome.DEFINITION)


def repair(
    claim: Claim,
    limits: Limits = STANDARD,
    progress: Callable[[Repair], None] = lambda found: None,
    judge: Judge | None = None,
    beside: Neighbours = ALONE,
) -> Repair:
    """Returns proposals for a claim, fewest changes first; its `reading` and `corrected` are not used.

    Ctrl-C and the time limit end the search and keep the proposals so far.

    beside: the neighbouring steps in its chain; proposals that agree with them are preferred.
    """
    claim = under_its_laws(claim)
    judge = judge or Judge(claim.notation.definitions)
    found = Repair(claim)
    start = monotonic()
    for supposing, most_signs in under_guesses(claim):
        bench = _Bench(supposing, judge, limits, found, progress, beside)
        bench.most_signs, bench.end = most_signs, start + limits.seconds
        try:
            with printed_for(claim.notation.author_notation):
                bench.run()
        except (KeyboardInterrupt, _LimitReached) as cut:
            found.complete, found.interrupted = False, isinstance(cut, KeyboardInterrupt)
        finally:
            bench.aside.close()
        if found.proposals or not found.complete:
            break
    found.seconds = monotonic() - start
    return found


class _LimitReached(Exception):
    """The limit of time or candidates is reached."""


class _Bench:
    """The search for one claim."""

    def __init__(
        self,
        claim: Claim,
        judge: Judge,
        limits: Limits,
        found: Repair,
        progress: Callable[[Repair], None],
        beside: Neighbours,
    ) -> None:
        self.claim, self.judge, self.limits, self.found, self.progress = claim, judge, limits, found, progress
        self.beside = beside
        self.end = monotonic() + limits.seconds
        self.assume, self.instances = claim.supposed, claim.instances
        self.integers = claim.orders.variables if claim.orders else ()
        self.seen: set[Statement] = set()
        self.proved: list[Statement] = []
        self.idle: list[Candidate] = []
        self.apart: list[Candidate] = []  # candidates that contradict a neighbouring step
        printed = claim.printed.statement
        self.printed_size = None if printed is None else _size(printed)
        self.like_terms = None if printed is None else like_terms(printed)
        self.table = claim.notation.symbols
        self.of_value, self.most_signs = property_stated_of(claim), 1
        self.aside = judging(claim, judge)

    def run(self) -> None:
        self.found.complete = True  # until a stage is cut short
        if self.claim.proof.theorem is not None:
            return
        printed = self.claim.printed.statement
        if printed is not None and not any(isinstance(term, Symbol) for _, term in places(printed)):
            return  # a false sum of numbers has no right form
        if printed is not None and (parts := membership(self.claim.printed.latex)) is not None:
            notation, orders = self.claim.notation, self.claim.orders
            self._offer(other_members(parts, notation, orders, self.screen, self._tick))
        elif printed is not None and self.of_value is not None:
            self._repair_value(printed, self.of_value)
        elif printed is not None:
            if not self._offer(other_signs(printed)):
                self._repair_false([Candidate(printed, ())])
            if not self.found.proposals:
                self._offer(with_lost_words(self.claim))
        else:
            self._repair_ill_formed()
        for unlikely in (self.apart, self.idle):
            if not self.found.proposals:
                self._judge_best(unlikely[: self.limits.judged])

    @cached_property
    def screen(self) -> Screen | None:
        return self._screen()

    @cached_property
    def reals(self) -> RealValues | None:
        """The values at real points, where points modulo the prime exclude nothing."""
        printed = self.claim.printed.statement
        is_screened = (
            self.screen is not None and printed is not None and self.screen.residual(printed) is not None
        )
        return None if is_screened else RealValues.under(self.judge.definitions, self.assume)

    @cached_property
    def sameness(self) -> Sameness:
        return Sameness(self.judge.definitions, self.assume, self.instances[-2:])

    def _repair_ill_formed(self) -> None:
        """Searches forms that are well-typed after one change and hold, or that give the value of a free
        symbol.

        After that, it searches the readings that hold; if none is proved, the neighbourhoods of the likeliest
        readings.
        """
        fits = [candidate for candidate in fitting(self.claim, self.beside) if self._is_met(candidate)]
        first = self.screen
        if first is not None and self._offer(c for c in fits if first.vanishes(c.statement)):
            return
        said = [c for c in fits if says_what(c.statement, self.judge.definitions, self.assume)]
        if said and (any(map(self._suggest, said)) or self.found.proposals):
            return
        readings = Readings(self.claim, self._screen(), self._tick)
        if any(self._offer(stage) for stage in readings.that_hold()):
            return
        likeliest = list(readings.likeliest(self.limits.readings))
        screen = self.screen
        if screen is not None and self._offer(c for c in likeliest if screen.vanishes(c.statement)):
            return
        if screen is None or all(screen.residual(c.statement) is None for c in likeliest):
            self._offer(iter(likeliest))
        else:
            self._repair_false(likeliest)

    def _repair_value(self, printed: Statement, of_value: Callable[[Statement], Statement]) -> None:
        """Searches values with the property that the text states, and suggests them."""
        stages = (
            ()
            if self.screen is None
            else other_values(printed, of_value, self.screen, self.most_signs, self._tick)
        )
        for stage in stages:
            for candidate in sorted(islice(stage, self.limits.judged), key=self._rank):
                verdict = self._verdict(of_value(candidate.statement))
                if verdict is not None and verdict.outcome in _PROVED:
                    enough = self._suggest(candidate, HAS_PROPERTY)
                    if enough:
                        return
            if self.found.proposals:
                return

    def _is_met(self, candidate: Candidate) -> bool:
        self._tick()
        return not is_vacuous(candidate.statement)

    def _suggest(self, candidate: Candidate, verdict: Verdict = FITS) -> bool:
        """Proposes a form that cannot be tested further, and returns whether enough are found."""
        proposals = self.found.proposals
        if not any(self.sameness.same(known, candidate.statement) for known in self.proved):
            proposals.append(Proposal(self._latex(candidate), candidate.changes, verdict))
            self.proved.append(candidate.statement)
        return len(proposals) >= self.limits.proposals

    def _repair_false(self, read: Sequence[Candidate]) -> None:
        """Runs the stages of the search in turn, each for all readings."""
        if self.screen is None:
            for candidate in read:
                self._offer(_unscreened(candidate))
            return
        for candidate in read:
            if _turns_by_exponent(candidate.statement) and self._offer(_unscreened(candidate)):
                return  # points do not know that exp(R x) and exp(x) have one angle
        second = self._second_screens()
        seen_at_points = {c.statement for c in read if self.screen.residual(c.statement) is not None}
        stages = []
        for candidate in read:
            near, far = symbols_like(candidate.statement, self.table, self.integers)
            own = self._screen()  # the screen keeps values of its own
            assert own is not None
            neighbourhood = Neighbourhood(
                candidate.statement, own, second, near, far, len(read) > 1, self._tick
            )
            stages.append((candidate, neighbourhood.stages()))
        while stages:
            for entry in list(stages):
                before, rest = entry
                stage = next(rest, None)
                if stage is None:
                    stages.remove(entry)
                    continue
                most = self.limits.judged if before.statement in seen_at_points else self.limits.unscreened
                if self._offer((replace(c, changes=(*before.changes, *c.changes)) for c in stage), most):
                    return

    def _screen(self) -> Screen | None:
        """Returns a screen of several points, with varied values of the integers that are not the first
        ones."""
        some = self.instances[1:4] or self.instances[:1]
        try:
            points = (some * 4)[:3] if len(some) > 1 else some * 3
            return Screen(self.judge.definitions, self.assume, points, about=self.claim.printed.statement)
        except NotExact:
            return None

    def _second_screens(self) -> list[Screen]:
        some = [self.instances[0], self.instances[-1]] if len(self.instances) > 1 else self.instances
        try:
            about = self.claim.printed.statement
            return [Screen(self.judge.definitions, self.assume, some, seed=77, about=about)]
        except NotExact:
            return []

    def _offer(self, candidates: Iterator[Candidate], most: int | None = None) -> bool:
        """Judges up to `most` candidates of one stage, and returns whether any was proved."""
        self._judge_best(list(islice(self._new(candidates), most or self.limits.judged)))
        return bool(self.found.proposals)

    def _judge_best(self, candidates: Sequence[Candidate]) -> None:
        """Adds proposals for the proved candidates, the likeliest first, if they have no more changes than
        the first.

        If none is proved, candidates that hold where the printed denominators do not vanish are proposed.
        """
        proposals = self.found.proposals
        conditional: list[Proposal] = []
        for candidate in sorted(candidates, key=self._rank):
            if proposals and len(candidate.changes) > len(proposals[0].changes):
                break
            judged = self.beside.joined(candidate.statement)
            if any(self.sameness.same(known, judged) for known in self.proved):
                continue
            verdict = self._verdict(judged)
            if verdict is not None and verdict.outcome in _PROVED:
                proposals.append(Proposal(self._latex(candidate), candidate.changes, verdict))
                self.proved.append(judged)
                if len(proposals) >= self.limits.proposals:
                    break
            elif verdict is not None and self._holds_where_printed_does(verdict, candidate):
                conditional.append(Proposal(self._latex(candidate), candidate.changes, verdict))
        if not proposals and conditional:
            least = min(len(each.changes) for each in conditional)
            likeliest = [each for each in conditional if len(each.changes) == least]
            proposals += likeliest[: self.limits.proposals]

    def _holds_where_printed_does(self, verdict: Verdict, candidate: Candidate) -> bool:
        """True if the candidate holds unless a denominator vanishes, and has no more of them than the print.

        A misprint loses no denominator, but it may stand in one.
        """
        printed = self.claim.printed.statement
        if verdict.outcome is not Outcome.CONDITIONAL or printed is None or candidate.latex is not None:
            return verdict.outcome is Outcome.CONDITIONAL
        return len(divisors(candidate.statement)) <= len(divisors(printed))

    def _rank(self, candidate: Candidate) -> tuple:
        """Returns the sort key of a candidate: the number of changes, the likelihood of the misprint, the
        length."""
        size = _size(candidate.statement)
        growth = size - self.printed_size if self.printed_size else 0
        kind, *rest = candidate.unlikely or (0,)
        likely = kind + 2 * max(-1, min(growth, 3))
        return len(candidate.changes), likely, size, rest

    def _new(self, candidates: Iterator[Candidate]) -> Iterator[Candidate]:
        for candidate in candidates:
            self._tick()
            statement = candidate.statement
            if statement in self.seen:
                continue
            vacuous = is_vacuous(statement)
            mends_step = (
                vacuous and len(candidate.changes) == 1 and self.beside.joined(statement) != statement
            )
            if vacuous and not mends_step:
                continue
            if self.like_terms is not None and like_terms(candidate.statement) > self.like_terms:
                continue  # an addend that another one partly cancels
            printed = self.claim.printed.statement
            if printed is not None and says_less(statement, printed):
                continue
            self.seen.add(candidate.statement)
            if self.beside.repeat(candidate.statement, len(candidate.changes)):
                continue
            if self.reals is not None and self.reals.differ(self.beside.joined(statement)):
                continue
            if not self._agrees(candidate.statement):
                self.apart.append(candidate)
                continue
            if not mends_step and self.screen is not None and is_idle(candidate.statement, self.screen):
                self.idle += [candidate] * (len(candidate.changes) == 1)
            else:
                yield candidate

    def _agrees(self, statement: Statement) -> bool:
        printed = self.claim.printed.statement
        if self.screen is None or printed is None or self.beside is ALONE:
            return True
        return self.beside.agree_with(statement, printed, self.screen)

    def _tick(self) -> None:
        self.found.candidates += 1
        self.progress(self.found)
        if self.found.candidates > self.limits.candidates or monotonic() > self.end:
            raise _LimitReached

    def _latex(self, candidate: Candidate) -> str:
        """Returns LaTeX in the printed spelling, if that reads as the candidate; else the canonical LaTeX."""
        canonical = to_latex(candidate.statement)
        integers = self.claim.orders.variables if self.claim.orders else ()
        respelled = as_printed(canonical, self.claim.printed.latex, self.table, integers)
        for latex in (candidate.latex, respelled):
            with suppress(ReadError, IllFormedAt):
                if latex is not None:
                    read, _ = read_statement(latex, self.claim.notation, self.claim.orders)
                    if read == candidate.statement:
                        return latex
        return canonical

    def _verdict(self, statement: Statement) -> Verdict | None:
        left = self.end - monotonic()
        try:
            return self.aside.call(statement, min(left, self.limits.judgement))
        except OutOfBudget:
            self.found.complete = False
            if monotonic() >= self.end:
                raise _LimitReached from None
            return None


def _unscreened(printed: Candidate) -> Iterator[Candidate]:
    """Yields one-position edits of a statement that cannot be screened."""
    for edit in sorted(edits(printed.statement), key=cost):
        if isinstance(edit, Edit):
            candidate = candidate_of(edit)
            yield replace(candidate, changes=(*printed.changes, *candidate.changes))


def _turns_by_exponent(statement: Statement) -> bool:
    """True if the exponential of a matrix stands in the statement."""
    parts = (term for _, term in places(statement))
    return any(isinstance(each, Apply) and each.head == "exp" and each.type != SCALAR for each in parts)


def _size(statement: Statement) -> int:
    """Returns the number of printed terms, without signs."""
    return sum(not (isinstance(term, Apply) and term.head == "neg") for _, term in places(statement))
