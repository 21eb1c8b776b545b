"""What the right form of a claim is, from its printed form alone; nothing is proposed that is not proved."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from time import monotonic
from typing import Any

from workbench.judge.assumptions import Unsatisfiable
from workbench.judge.inventory import NotExact
from workbench.judge.judge import Judge
from workbench.judge.verdict import Outcome, Verdict
from workbench.language.construct import symbol
from workbench.language.errors import IllFormedAt, ReadError
from workbench.language.integers import Linear
from workbench.language.printer import to_latex
from workbench.language.symbols import SymbolTable
from workbench.language.terms import Apply, Conjunction, IllFormed, Relation, Statement, Symbol, Term
from workbench.papers.formulas import read_statement
from workbench.papers.model import Claim
from workbench.repair.difference import Difference, difference, in_colour
from workbench.repair.edits import edits
from workbench.repair.places import places
from workbench.repair.readings import Readings
from workbench.repair.screen import Screen
from workbench.repair.search import Candidate, Change, Neighbourhood, cost

_PROVED = (Outcome.PROVED, Outcome.DEFINITION)


@dataclass(frozen=True)
class Limits:
    """seconds: of wall time for one claim. candidates: looked at. proposals: made. judged: candidates of one
    stage that are given to the judge. readings: of an ill-formed claim, whose neighbourhoods are searched."""

    seconds: float = 60.0
    candidates: int = 60_000
    proposals: int = 4
    judged: int = 150
    readings: int = 12


#: What one claim gets by default. Candidates run out before time, so that results are the same everywhere.
STANDARD = Limits()


@dataclass(frozen=True)
class Proposal:
    """A proved form, as LaTeX that reads as what was proved, and what is different in it."""

    latex: str
    changes: tuple[Change, ...]
    verdict: Verdict

    @property
    def edit(self) -> str:
        """The changes as a person would say them."""
        return "; ".join(change.description for change in self.changes)

    def difference(self, printed: str) -> Difference:
        return difference(printed, self.latex)

    def to_dict(self, printed: str) -> dict[str, Any]:
        """For the report. difference: see `Difference.to_list`."""
        return {
            "latex": self.latex,
            "edit": self.edit,
            "difference": self.difference(printed).to_list(),
            "verdict": str(self.verdict.outcome),
        }


@dataclass(repr=False)
class Repair:
    """What was found. `candidates`: how many were looked at; `complete`: the search came to its end."""

    claim: Claim | None
    proposals: list[Proposal] = field(default_factory=list)
    candidates: int = 0
    seconds: float = 0.0
    complete: bool = False

    def to_dict(self) -> dict[str, Any]:
        return {
            "id": self.claim.id,
            "printed": self.claim.printed.latex,
            "proposed": self.proposed(),
            "candidates": self.candidates,
            "complete": self.complete,
        }

    @property
    def printed(self) -> str:
        """The printed form in the spelling of the proposals: the canonical one, if it can be read."""
        formula = self.claim.printed
        return formula.latex if formula.statement is None else to_latex(formula.statement)

    def proposed(self) -> list[dict[str, Any]]:
        return [proposal.to_dict(self.printed) for proposal in self.proposals]

    def __str__(self) -> str:
        lines = [
            f"{p.latex}\n    {p.edit} ({p.verdict.outcome})\n    {p.difference(self.printed)}"
            for p in self.proposals
        ]
        return "\n".join(lines) or f"no proposal among {self.candidates} candidates"

    __repr__ = __str__

    def _repr_markdown_(self) -> str:
        lines = []
        for p in self.proposals:
            shown = p.difference(self.printed).highlighted(in_colour)
            lines.append(f"$$ {shown} $$\n\n{p.edit} (**{p.verdict.outcome}**)")
        return "\n\n".join(lines) or f"no proposal among {self.candidates} candidates"


def repair(
    claim: Claim,
    limits: Limits = STANDARD,
    progress: Callable[[Repair], None] = lambda found: None,
    judge: Judge | None = None,
) -> Repair:
    """Proposals for a claim, fewest changes first. Its `reading` and `corrected` are not looked at.

    Ctrl-C ends the search and keeps what was found, and so does the limit on time.
    """
    judge = judge or Judge(claim.notation.definitions, motion=claim.notation.motion)
    found = Repair(claim)
    bench = _Bench(claim, judge, limits, found, progress)
    start = monotonic()
    with suppress(KeyboardInterrupt, _LimitReached):
        bench.run()
    found.seconds = monotonic() - start
    return found


class _LimitReached(Exception):
    """The limit on time or candidates is reached."""


class _Bench:
    """One claim under repair."""

    def __init__(
        self, claim: Claim, judge: Judge, limits: Limits, found: Repair, progress: Callable[[Repair], None]
    ) -> None:
        self.claim, self.judge, self.limits, self.found, self.progress = claim, judge, limits, found, progress
        self.end = monotonic() + limits.seconds
        self.assume = tuple(a.statement for a in claim.assume if a.statement is not None)
        assignments = list(claim.orders.assignments()) if claim.orders else [{}]
        self.instances = assignments
        self.seen: set[Statement] = set()
        self.table = claim.notation.symbols

    def run(self) -> None:
        if self.claim.theorem is not None:
            self.found.complete = True
            return
        printed = self.claim.printed.statement
        if printed is not None:
            self._repair_false([Candidate(printed, ())])
        else:
            self._repair_ill_formed()
        self.found.complete = True

    def _repair_ill_formed(self) -> None:
        """The readings that hold; if none of them is proved, the neighbours of the likeliest readings."""
        readings = Readings(self.claim, self._screen(), self._tick)
        if any(self._offer(stage) for stage in readings.that_hold()):
            return
        likeliest = list(readings.likeliest(self.limits.readings))
        if self._screen() is None or not self._is_equation(likeliest):
            self._offer(iter(likeliest))
        else:
            self._repair_false(likeliest)

    def _is_equation(self, read: Sequence[Candidate]) -> bool:
        screen = self._screen()
        return any(screen.residual(candidate.statement) is not None for candidate in read)

    def _repair_false(self, read: Sequence[Candidate]) -> None:
        """One stage of the search after another, each for all readings."""
        screen = self._screen()
        if screen is None:
            for candidate in read:
                self._offer(_unscreened(candidate))
            return
        second = self._second_screens()
        stages = []
        for candidate in read:
            screen = self._screen()
            neighbourhood = Neighbourhood(
                candidate.statement, screen, second, symbols_like(candidate.statement, self.table), self._tick
            )
            stages.append((candidate, neighbourhood.stages()))
        while stages:
            for entry in list(stages):
                before, rest = entry
                stage = next(rest, None)
                if stage is None:
                    stages.remove(entry)
                    continue
                if self._offer(Candidate(c.statement, (*before.changes, *c.changes)) for c in stage):
                    return

    def _screen(self) -> Screen | None:
        """Several points, at values of the integers that are neither the first nor all the same."""
        some = self.instances[1:4] or self.instances[:1]
        try:
            return Screen(self.judge.definitions, self.assume, (some * 4)[:3] if len(some) > 1 else some * 3)
        except NotExact:
            return None

    def _second_screens(self) -> list[Screen]:
        some = [self.instances[0], self.instances[-1]] if len(self.instances) > 1 else self.instances
        try:
            return [Screen(self.judge.definitions, self.assume, some, seed=77)]
        except NotExact:
            return []

    def _offer(self, candidates: Iterator[Candidate]) -> bool:
        """Judges candidates until those with more changes come than the first that was proved has. Whether
        any was proved."""
        proposals = self.found.proposals
        for judged, candidate in enumerate(self._new(candidates)):
            if proposals and len(candidate.changes) > len(proposals[0].changes):
                break
            if judged == self.limits.judged:
                break
            verdict = self._verdict(candidate.statement)
            if verdict is not None and verdict.outcome in _PROVED:
                latex = self._latex(candidate)
                proposals.append(Proposal(latex, candidate.changes, verdict))
                if len(proposals) >= self.limits.proposals:
                    break
        return bool(proposals)

    def _new(self, candidates: Iterator[Candidate]) -> Iterator[Candidate]:
        for candidate in candidates:
            self._tick()
            if candidate.statement not in self.seen and not is_vacuous(candidate.statement):
                self.seen.add(candidate.statement)
                yield candidate

    def _tick(self) -> None:
        self.found.candidates += 1
        self.progress(self.found)
        if self.found.candidates > self.limits.candidates or monotonic() > self.end:
            raise _LimitReached

    def _latex(self, candidate: Candidate) -> str:
        """As it would have been printed, if that reads as the candidate; else the canonical LaTeX."""
        if candidate.latex is not None:
            with suppress(ReadError, IllFormedAt):
                read, _ = read_statement(candidate.latex, self.claim.notation, self.claim.orders)
                if read == candidate.statement:
                    return candidate.latex
        return to_latex(candidate.statement)

    def _verdict(self, statement: Statement) -> Verdict | None:
        try:
            return self.judge.judge(statement, assume=self.assume, orders=self.claim.orders)
        except (Unsatisfiable, IllFormed, NotExact):
            return None


def _unscreened(printed: Candidate) -> Iterator[Candidate]:
    """One-place edits of what cannot be screened."""
    for edit in sorted(edits(printed.statement), key=cost):
        if edit.statement is not None:
            change = Change(edit.kind, edit.description)
            yield Candidate(edit.statement, (*printed.changes, change))


def symbols_like(statement: Statement, table: SymbolTable) -> list[Term]:
    """The symbols of a paper that may have stood in a statement: those without index, and of each family the
    members whose indices occur in the statement."""
    indices = dict.fromkeys(
        term.index for _, term in places(statement) if isinstance(term, Symbol) and term.index
    )
    found: dict[Term, None] = {}
    for declaration in table.symbols.values():
        if declaration.parameters or declaration.type.kind in ("block", "operator"):
            continue
        for index in indices if declaration.indices else [()]:
            if len(index) == declaration.indices and _is_known(declaration.name, index, table):
                found[symbol(declaration, index)] = None
    return list(found)


def _is_known(name: str, index: tuple[Linear, ...], table: SymbolTable) -> bool:
    return name not in table.introduced or table.defines(name, index)


def is_vacuous(statement: Statement) -> bool:
    """Whether an equation of the statement holds by the order and cancelling of its addends alone, such as
    b = b + c - c. It is proved, but says nothing that could have been meant."""
    match statement:
        case Relation(operator="="):
            counts: Counter[Term] = Counter()
            for sign, side in ((1, statement.left), (-1, statement.right)):
                for factor, term in _addends(side, sign):
                    counts[term] += factor
            return not any(counts.values())
        case Conjunction(parts=parts):
            return any(map(is_vacuous, parts))
    return False


def _addends(term: Term, sign: int) -> Iterator[tuple[int, Term]]:
    match term:
        case Apply(head="add"):
            for addend in term.arguments:
                yield from _addends(addend, sign)
        case Apply(head="neg", arguments=(inner,)):
            yield from _addends(inner, -sign)
        case _:
            yield sign, term
