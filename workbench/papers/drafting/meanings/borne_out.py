"""Replaces the first formula of a symbol as its definition, if words or other formulas give another one.

The other one counts only if the first formula follows from it after one usual change: it is a misprint then.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from functools import cached_property
from time import process_time

from workbench.context.claims import Claim, Notation
from workbench.context.free_symbols import free_in
from workbench.context.read_formulas import read_statement
from workbench.context.repeated_laws import closes_circle
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.terms import (
    Apply,
    Definition,
    Derivative,
    IllFormed,
    Power,
    Relation,
    Statement,
    Symbol,
    Term,
    sides_of,
)
from workbench.core.types import Declaration
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.inventory import take_inventory
from workbench.language.definitions import Definitions
from workbench.language.printing.printer import to_latex
from workbench.papers.drafting.draft_model import Ingested
from workbench.papers.drafting.drafted_definitions import Proposed, in_order_of_use
from workbench.papers.drafting.meanings.contradictions import display_of, equations_of_sentences, flagged
from workbench.papers.drafting.meanings.word_meanings import Meaning, Scene, Subject, meanings_of
from workbench.papers.drafting.typefaces import flat
from workbench.papers.texts.text_paper import TextPaper
from workbench.repair.propose.usual_changes import Nearness, Points, nearness, usual_changes
from workbench.source.documents import Display
from workbench.source.documents.condition_words import APPROXIMATES, OF_CASE_OR_VALUE, in_last_sentence

#: The limits of all tests of meanings by words, of those of changed definitions, and of one test.
_SECONDS, _SECONDS_OF_CHANGES, _SECONDS_OF_ONE = 2.0, 6.0, 0.5
#: The characters of words beside a symbol in a sentence.
_BESIDE = 50
_CASE = in_last_sentence(OF_CASE_OR_VALUE, APPROXIMATES)


def with_meanings(ingested: Ingested, paper: TextPaper) -> Ingested:
    """Returns the draft with the definitions of which a first formula is a misprint."""
    bench = _Bench(ingested, paper)
    found = {each.name: each for each in bench.by_words()}
    found |= {each.name: each for each in bench.by_formulas() if each.name not in found}
    if not found:
        return ingested
    guesses = dict(ingested.guesses)
    for each in found.values():
        for name in each.coordinates & guesses.keys():
            guesses[name] = replace(guesses[name], independent=True)
    kept = [each for each in ingested.definitions if each.name not in found]
    lines = {each.name: each.line for each in ingested.definitions}
    new = [
        Proposed(each.name, each.body, lines.get(each.name, bench.lines[each.name]), each.why, True)
        for each in found.values()
    ]
    return replace(ingested, definitions=in_order_of_use([*kept, *new]), guesses=guesses)


@dataclass(frozen=True)
class _First:
    """A formula that gives a symbol for the first time. own: the symbol."""

    claim: Claim
    own: Symbol
    display: Display


@dataclass(frozen=True)
class _Said:
    """An equation of the text."""

    statement: Statement
    known: Definitions
    assume: tuple[Statement, ...] = ()
    instances: Sequence[Mapping[str, int]] = ({},)

    def points(self, known: Definitions) -> Points:
        return Points(self.statement, known, self.assume, self.instances)

    @cached_property
    def used(self) -> frozenset[Declaration]:
        return frozenset(each.declaration for each in self.known.symbols_in(*sides_of(self.statement)))

    @cached_property
    def is_decided(self) -> bool:
        is_equation = isinstance(self.statement, Relation) and self.statement.operator == "="
        return is_equation and self.points(self.known).has_value()

    @cached_property
    def holds(self) -> bool:
        return self.points(self.known).vanishes()

    def nearness(self, known: Definitions) -> Nearness:
        return nearness(
            self.statement, known, self.assume, self.instances, _SECONDS_OF_ONE, True, factors=True
        )

    def is_near(self, known: Definitions) -> bool:
        return self.nearness(known) is Nearness.NEAR


@dataclass(frozen=True)
class _Change:
    """A changed first formula. held, rest: the count of false formulas that hold with it, and the others."""

    first: _First
    body: Term
    known: Definitions
    held: int
    rest: tuple[_Said, ...]


def _best(changes: Sequence[_Change], score: Callable[[_Change], int]) -> list[_Change]:
    scores = [score(each) for each in changes]
    return [each for each, own in zip(changes, scores, strict=True) if own == max(scores)]


class _Bench:
    """The tests of one text."""

    def __init__(self, ingested: Ingested, paper: TextPaper) -> None:
        self.ingested, self.paper = ingested, paper
        self.end = 0.0
        self._known: dict[int, Definitions] = {}
        self._far: dict[tuple[int, int], bool] = {}
        self.lines: dict[str, int] = {}
        self.displays = {each.line: each for each in reversed(ingested.text.displays)}

    def by_words(self) -> Iterator[Meaning]:
        """Yields the meanings by words from which a first formula follows after one change."""
        self.end = process_time() + _SECONDS
        for first in self.firsts:
            name = str(first.own.declaration.name)
            subject = Subject(name, first.own.type, self._words(name, first.display), self._row(first))
            near = None
            for meaning in meanings_of(subject, self.scene):
                if process_time() > self.end:
                    return
                found = self._tested(meaning, first)
                if found is Nearness.HOLDS:
                    near = None
                    break
                if found is Nearness.NEAR and near is None:
                    near = meaning
            if near is not None:
                self.lines[name] = first.claim.line
                yield near

    def by_formulas(self) -> Iterator[Meaning]:
        """Yields the changed first formula with which the most other formulas of the text hold, and without
        not; none if several serve equally."""
        self.end = process_time() + _SECONDS_OF_CHANGES
        found: list[_Change] = []
        for first in self.firsts:
            statement, known = self._at_rest(first.claim.printed.parsed, first.claim.notation)
            if not isinstance(statement, Relation) or len(known.about(first.own)) != 1:
                continue
            if first.own != statement.left:
                continue
            about = [each for each in self.judged if first.own.declaration in each.used]
            false = [each for each in about if not each.holds]
            if not false or (len(false) == 1 and not self._is_far(false[0], known)):
                continue
            true = [each for each in about if each.holds]
            changed = self._changed(first, known, statement, false, true)
            found += changed
        best = _best(found, lambda each: each.held)
        if len({each.first.claim.id for each in best}) > 1:
            best = _best(best, lambda each: sum(said.is_near(each.known) for said in each.rest))
        if process_time() < self.end and len({each.first.claim.id for each in best}) == 1:
            first = best[0].first
            name = str(first.own.declaration.name)
            self.lines[name] = first.claim.line
            yield Meaning(name, to_latex(best[0].body), "other formulas hold with it")

    def _changed(
        self,
        first: _First,
        definitions: Definitions,
        statement: Relation,
        false: Sequence[_Said],
        true: Sequence[_Said],
    ) -> Iterator[_Change]:
        """Yields the changed right sides with which false formulas hold, and none fails that held.

        These are two formulas or all, or one that no change of its own makes true."""
        far = [each for each in false if self._is_far(each, definitions)]
        least = min(1 if far else 2, len(false))
        for changed in usual_changes(statement):
            if process_time() > self.end:
                return
            if not isinstance(changed, Relation) or changed.right.type != statement.right.type:
                continue
            known = _with(definitions, first.own, changed.right)
            if known is None:
                continue
            rest: list[_Said] = []
            for each in false:
                if not each.points(known).vanishes():
                    rest.append(each)
                    if len(rest) > len(false) - least:
                        break
            held = [each for each in false if each not in rest]
            is_told = len(held) >= min(2, len(false)) or any(each in far for each in held)
            if is_told and all(each.points(known).vanishes() for each in true):
                yield _Change(first, changed.right, known, len(held), tuple(rest))

    def _is_far(self, said: _Said, known: Definitions) -> bool:
        """True if no change of a false formula makes it true."""
        key = (id(said), id(known))
        if key not in self._far:
            self._far[key] = said.nearness(known) is Nearness.FAR
        return self._far[key]

    @cached_property
    def judged(self) -> list[_Said]:
        """The equations of displays and sentences that are no first formulas and have a value at a point."""
        firsts = {first.claim.id for first in self.firsts}
        found = []
        for claim in self.paper.claims:
            if claim.printed.statement is not None and claim.id not in firsts:
                statement, known = self._at_rest(claim.printed.parsed, claim.notation)
                supposed = tuple(self._at_rest(each, claim.notation)[0] for each in claim.supposed)
                found.append(_Said(statement, known, supposed, claim.instances))
        for _, read in equations_of_sentences(self.ingested, self.paper):
            found.append(_Said(*self._at_rest(read, self.paper.notation)))
        return [each for each in found if process_time() < self.end and each.is_decided]

    @cached_property
    def firsts(self) -> list[_First]:
        """The formulas by which the draft defines a symbol, or which give its square."""
        given = {each.name: each for each in self.ingested.definitions if each.sure and not each.function}
        found = []
        for claim in self.paper.claims:
            statement, display = claim.printed.statement, display_of(claim, self.ingested)
            if display is None or not isinstance(statement, Relation) or claim.assume or claim.chain:
                continue
            left = statement.left.base if isinstance(statement.left, Power) else statement.left
            if not isinstance(left, Symbol) or left.index or left.arguments:
                continue
            if _CASE.search(display.before):
                continue
            own = given.get(str(left.declaration.name))
            if own is None and left is statement.left:
                continue
            if own is not None and (own.in_sentence or own.line != display.line):
                continue
            found.append(_First(claim, left, display))
        return found

    @cached_property
    def scene(self) -> Scene:
        types: dict[str, Declaration] = {}
        moving: set[str] = set()
        for claim in self.paper.claims:
            sides = sides_of(claim.printed.statement) if claim.printed.statement is not None else ()
            for part in claim.notation.definitions.reached(*sides):
                if isinstance(part, Symbol):
                    types[str(part.declaration.name)] = part.declaration
                elif isinstance(part, Derivative):
                    moving |= {str(each.declaration.name) for each in part.body.symbols()}
        known = self.paper.notation.definitions
        for each in known:
            types.setdefault(str(each.declaration.name), each.declaration)
        uses = {
            str(each.declaration.name): frozenset(str(free.name) for free in free_in([each.body], known))
            for each in known
        }
        angles = {name for name, guess in self.ingested.guesses.items() if guess.words.startswith("angle")}
        groups = [tuple(names) for names in self._groups() if len(names) > 1]
        defined = [each.name for each in self.ingested.definitions if each.sure and not each.function]
        return Scene(
            {name: declaration.type for name, declaration in types.items()},
            defined,
            groups,
            frozenset(moving | angles),
            uses,
        )

    def _groups(self) -> Iterator[list[str]]:
        """Yields the numbers that one display defines, and the coordinates x, y, z with one label."""
        rows: dict[int, list[str]] = {}
        for each in self.ingested.definitions:
            guess = self.ingested.guesses.get(each.name)
            if each.sure and guess is not None and guess.kind == "scalar":
                rows.setdefault(each.line, []).append(each.name)
        yield from rows.values()
        known = {name for row in rows.values() for name in row}
        for label in sorted(name[1:] for name in known if name[0] == "x"):
            axes = [f"{axis}{label}" for axis in "xyz" if f"{axis}{label}" in known]
            if axes not in rows.values():
                yield axes

    def _tested(self, meaning: Meaning, first: _First) -> Nearness:
        claim, notation = first.claim, first.claim.notation
        statement = claim.printed.parsed
        try:
            said, _ = read_statement(f"{meaning.name} = {meaning.body}", notation, claim.orders)
        except (ReadError, IllFormedAt, IllFormed):
            return Nearness.OPEN
        if (
            not isinstance(said, Relation)
            or said.right.type != first.own.type
            or not isinstance(statement, Relation)
        ):
            return Nearness.OPEN
        known = _with(notation.definitions, first.own, said.right)
        if known is None or not _are_alike(statement.right, said.right, known):
            return Nearness.FAR
        rest = self._resting

        def flag_of(each: str) -> str:
            return "independent" if each in meaning.coordinates else "constant" if each in rest else ""

        statement, known = flagged(statement, known, flag_of)
        supposed = [flagged(each, Definitions(), flag_of)[0] for each in claim.supposed]
        return nearness(statement, known, supposed, claim.instances, _SECONDS_OF_ONE)

    @cached_property
    def _resting(self) -> frozenset[str]:
        """The free symbols for which the text has neither a rate nor a definition."""
        defined = {str(each.declaration.name) for each in self.paper.notation.definitions}
        return frozenset(self.scene.types) - self.scene.moving - defined

    def _at_rest(self, statement: Statement, notation: Notation) -> tuple[Statement, Definitions]:
        """Returns a statement and the definitions with the symbols at rest as constants."""
        known = self._known.get(id(notation))
        if known is None:
            given = notation.definitions
            _, known = flagged(None, given, lambda of: "constant" if of in self._resting else "")
            self._known[id(notation)] = known
        still, _ = flagged(statement, Definitions(), lambda of: "constant" if of in self._resting else "")
        return still, known

    def _row(self, first: _First) -> tuple[int, int]:
        """Returns the row of a formula for a number among those of its display, and their count."""
        own = [
            each for each in self.firsts if each.display is first.display and each.own.type.kind == "scalar"
        ]
        at = next((k for k, each in enumerate(own) if each is first), 0)
        return at, len(own)

    def _words(self, name: str, display: Display) -> str:
        """Returns the words before a display, and those beside the symbol where a sentence names it."""
        words, key = [display.before], flat(name)
        for formula in self.ingested.text.inline:
            if flat(formula.latex.partition("=")[0]) == key:
                text = formula.source.prose
                words += [
                    re.split(r"[.;]\s", text[max(0, formula.start - _BESIDE) : formula.start])[-1],
                    re.split(r"[.;]\s", text[formula.end : formula.end + _BESIDE])[0],
                ]
        return " ".join(" ".join(words).split())


def _with(definitions: Definitions, own: Symbol, body: Term) -> Definitions | None:
    """Returns the definitions with another one of a symbol; None if that closes a circle."""
    others = [each for each in definitions if each.declaration.name != own.declaration.name]
    new = Definition(own.declaration, (), (), body)
    return None if closes_circle(new, others) else Definitions([*others, new])


def _are_alike(printed: Term, meant: Term, known: Definitions) -> bool:
    """True if two terms have the same free symbols up to the same rates, but for one of each."""
    try:
        one, other = (take_inventory([term], known).orders for term in (printed, meant))
    except (NotExact, IllFormed, ZeroDivisionError):
        return False
    if _are_close(one.items(), other.items()):
        return True
    lower = all(one[each] <= other.get(each, 0) for each in one)
    is_component = isinstance(meant, Apply) and meant.head == "dot"  # its highest rates may cancel
    return is_component and lower and _are_close(one.keys(), other.keys())


def _are_close(one: Set[object], other: Set[object]) -> bool:
    return bool(one & other) and len(one - other) <= 1 and len(other - one) <= 1
