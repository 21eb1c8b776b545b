"""Questions that a draft leaves to its author, each with its answers as lines of the model."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.verdict import Grade, Outcome
from workbench.papers.drafting.draft_model import Ingested
from workbench.papers.drafting.drafted_definitions import Proposed
from workbench.papers.drafting.drafted_frames import labels_in
from workbench.papers.drafting.drafted_texts import Draft
from workbench.papers.drafting.inference.kind_signatures import Kind
from workbench.papers.drafting.model_file import string
from workbench.papers.drafting.model_proposal import tables_of
from workbench.papers.drafting.symbol_guesses import kind_of_model
from workbench.papers.drafting.typefaces import Guess, flat
from workbench.prover.results.claim_results import ClaimResult

#: The most answers that are offered.
_MOST = 4


@dataclass(frozen=True)
class Answer:
    """One answer: an entry of the model."""

    table: str
    key: str
    value: str

    @property
    def lines(self) -> tuple[str, str]:
        """The lines to write into the model."""
        return f"[{self.table}]", f"{self.key} = {self.value}"

    @property
    def symbol(self) -> str:
        """The symbol that it is about, of an entry."""
        return next(iter(tomllib.loads(self.lines[1])))

    @property
    def is_entry(self) -> bool:
        """True if its lines are one entry of a table that a draft has: of a text, or of [points] a table."""
        expected = {"symbols": str, "definitions": str, "points": dict}.get(self.table)
        try:
            found = list(tomllib.loads(self.lines[1]).values())
        except (tomllib.TOMLDecodeError, RecursionError):
            return False
        return expected is not None and len(found) == 1 and type(found[0]) is expected


@dataclass(frozen=True)
class Question:
    """A question to the author. settles: the ids of the claims that an answer makes decidable."""

    text: str
    line: int
    answers: tuple[Answer, ...]
    settles: tuple[str, ...]

    def __str__(self) -> str:
        count = len(self.settles)
        return f"{self.text} (line {self.line}; decides {count} equation{'' if count == 1 else 's'})"


def questions_about(draft: Draft, results: Sequence[ClaimResult]) -> list[Question]:
    """Returns the questions whose answers settle the open claims of a draft, the most decisive first.

    Questions are added until each open claim is named once.
    """
    found = [*_of_kinds(draft, results), *_of_points(draft, results), *_of_definitions(draft, results)]
    asked: list[Question] = []
    settled: set[str] = set()
    for question in sorted(found, key=lambda each: (-len(each.settles), each.line, each.text)):
        if not settled.issuperset(question.settles):
            asked.append(question)
            settled.update(question.settles)
    return asked


def answered(ingested: Ingested, answer: Answer) -> Ingested:
    """Returns the draft with an answer, which counts as confirmed."""
    ((name, said),) = tomllib.loads(answer.lines[1]).items()
    confirmed = ingested.confirmed | {name}
    if answer.table == "symbols":
        guess = Guess(name, said, "the author says so")
        return replace(ingested, guesses={**ingested.guesses, name: guess}, confirmed=confirmed)
    if answer.table == "definitions":
        own = Proposed(name, said, 0, "the author says so", True)
        others = [each for each in ingested.definitions if each.name != name]
        return replace(ingested, definitions=[*others, own], confirmed=confirmed)
    entries = {answer.key: answer.value}
    known = tables_of(ingested.proposals).get(answer.table, {})
    if answer.key in known:
        entries = {answer.key: _merged(known[answer.key][0], answer.value)}
    kept = [
        replace(each, entries={key: value for key, value in each.entries.items() if key != answer.key})
        if each.table == answer.table
        else each
        for each in ingested.proposals
    ]
    if not kept:
        return ingested  # the text speaks of no frame any more
    proposal = replace(kept[-1], table=answer.table, entries=entries, why="the author says so", question="")
    return replace(ingested, proposals=[*kept, proposal], confirmed=confirmed)


def _merged(known: str, more: str) -> str:
    """Returns two inline tables as one."""
    return f"{known.rstrip(' }')}, {more.lstrip('{ ')}"


def _open(result: ClaimResult) -> bool:
    """True if a claim is not judged, or false only on doubtful kinds."""
    is_false = result.verdict.outcome in (Outcome.REFUTED, Outcome.ILL_FORMED)
    return result.shown is Grade.NOT_JUDGED or (is_false and result.shown is Grade.NOTE)


def _of_kinds(draft: Draft, results: Sequence[ClaimResult]) -> Iterator[Question]:
    """Yields questions about kinds that rest on one formula only, or that another kind would suit as well."""
    inference = draft.ingested.inference
    defined = {each.symbol for each in draft.ingested.definitions if each.sure}
    users: dict[str, list[ClaimResult]] = {}
    others: dict[str, tuple[Kind, ...]] = {}
    for each in inference.thin:
        others[each.name] = (each.other,)
    for result in filter(_open, results):
        latex = result.claim.printed.latex
        names = {each.name for each in inference.thin if each.latex == latex}
        if result.verdict.outcome is not Outcome.UNCHECKED:
            formula = flat(latex)
            names |= {name for name in inference.doubtful(latex) if flat(name) in formula}
        for name in names - defined:
            users.setdefault(name, []).append(result)
    for name, own in users.items():
        found = inference.kinds[name]
        kinds = dict.fromkeys((found.kind, *others.get(name, ()), *(kind for kind, _ in found.others)))
        answers = tuple(_kind(name, kind) for kind in list(kinds)[:_MOST])
        yield Question(f"What is {name}?", own[0].claim.line or 1, answers, _ids(own))


def _kind(name: str, kind: Kind) -> Answer:
    return Answer("symbols", string(name), f'"{kind_of_model(kind)}"')


def _ids(results: Sequence[ClaimResult]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(result.claim.id for result in results))


def _of_points(draft: Draft, results: Sequence[ClaimResult]) -> Iterator[Question]:
    """Yields questions about the frame in which each point is fixed."""
    tables: Mapping[str, Mapping[str, tuple[str, str]]] = tables_of(draft.ingested.proposals)
    if "points" not in tables or "frames" not in tables:
        return
    frames = labels_in(tables["frames"].get("names", ("", ""))[0])
    own = [result for result in results if result.verdict.code is VerdictCode.OF_FRAMES]
    fixed = labels_in(tables["points"].get("fixed", ("", ""))[0])
    for point in labels_in(tables["points"].get("names", ("", ""))[0]):
        users = [result for result in own if _has_label(result.claim.printed.latex, point)]
        answers = tuple(Answer("points", "fixed", f"{{ '{point}' = '{frame}' }}") for frame in frames[:_MOST])
        if users and answers and point not in fixed[::2]:
            line = users[0].claim.line or 1
            yield Question(f"In which frame is {point} fixed, if in any?", line, answers, _ids(users))


def _has_label(latex: str, label: str) -> bool:
    return label in latex.replace("{", " ").replace("}", " ").replace("/", " ").replace("^", " ").split()


def _of_definitions(draft: Draft, results: Sequence[ClaimResult]) -> Iterator[Question]:
    """Yields questions whether a formula with a letter alone on a side defines that letter."""
    defined = {each.symbol for each in draft.ingested.definitions if each.sure}
    guesses = draft.ingested.guesses
    for result in results:
        left, sign, right = result.claim.printed.latex.partition("=")
        name = next((each for each in guesses if flat(each) == flat(left)), None)
        if not sign or name is None or name in defined or result.verdict.outcome is not Outcome.UNCHECKED:
            continue
        users = (each for each in results if _open(each) and flat(name) in flat(each.claim.printed.latex))
        later = [result, *users]
        answer = Answer("definitions", string(name), string(right.strip()))
        yield Question(
            f"Does this formula say what {name} is?", result.claim.line or 1, (answer,), _ids(later)
        )
