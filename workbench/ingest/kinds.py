"""Which kinds of symbols make a text's formulas fit, beginning with what typeface and words say."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import chain, combinations, islice

from workbench.ingest.asked import Asked, Asks, Outcome
from workbench.ingest.prose import Prose
from workbench.ingest.typefaces import (
    ADJOINT,
    CAPITAL,
    COMPONENT,
    KINDS,
    LABELLED,
    USUAL,
    Guess,
    bare_name,
    by_typeface,
    families,
    flat,
    kinds_by_face,
    letters_in,
    without_bold,
)
from workbench.language.grammar.parser import parses
from workbench.language.naming.declarations import read_key
from workbench.language.naming.spelling import INDEX_LETTERS
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read, unclaimed
from workbench.language.typed.errors import IllFormedAt, ReadError, SpecError
from workbench.language.typed.names import Name
from workbench.language.typed.types import Declaration

_UNKNOWN = re.compile(r"unknown symbol (.+)", re.DOTALL)
_OF_KINDS = re.compile(
    r"(?:expected|transpose of|juxtaposition of) an? (?:scalar|vector|tensor|quaternion)|differ in type"
    r"|^[×∘] of a |^\* on a "
)
#: e with an exponent, which is no transpose and no number.
_EXPONENTIAL = re.compile(r"(?<![A-Za-z\\])e\s*\^\s*\{\s*(?!-?\d+\s*\}|T\s*\}|\*|\\top|\\ast|\()")
_MATRIX = re.compile(r"matrix \d+×\d+")
_MOST_SIZES = 3
#: More symbols than these in a text are tried in turn no further.
MOST_TRIED = 150
_ROUNDS = 6
_MOST_SYMBOLS = 60
_MOST_GROUPS = 200
_MOST_TOGETHER = 4


class Guesser:
    """Reads formulas with guessed symbols, declaring each when it is met."""

    def __init__(self, prose: Prose, ground: SymbolTable | None = None) -> None:
        self.prose = prose
        self.ground = SymbolTable() if ground is None else ground
        self.kinds = (*KINDS, "hamilton quaternion") if prose.has_quaternions else KINDS
        self.guesses: dict[str, Guess] = {}
        self.refused: dict[str, str] = {}
        self.takes_steps = False
        self.has_exponentials = False
        self._symbols: dict[Guess | tuple[Guess, Guess], Mapping[Name, Declaration]] = {}
        self._names: dict[Name, tuple[str, ...]] = {}
        self._read_before: dict[object, Asks | Outcome] = {}
        self._near_before: dict[str, tuple[int, list[str], frozenset[str]]] = {}

    def knowing(self, guesses: Mapping[str, Guess]) -> Guesser:
        """One that has guessed no more than this, and remembers what was read. What the notation or the
        frames spell is no symbol to be guessed."""
        other = Guesser(self.prose, self.ground)
        other.has_exponentials = self.has_exponentials
        other._symbols, other._names, other._read_before = self._symbols, self._names, self._read_before
        for name, guess in guesses.items():
            with suppress(SpecError):
                self._declared(guess)
                if read_key(name)[0] not in self.ground.constants:
                    other.guesses[name] = guess
        return other

    def read_all(self, formulas: Sequence[str]) -> list[Outcome]:
        """Declares what the formulas need; each is read with all the symbols that are known by then."""
        self.has_exponentials = self.has_exponentials or any(map(_EXPONENTIAL.search, formulas))
        return [
            replace(self._read(latex, self.guesses), symbols=_known(latex, self.guesses))
            for latex in formulas
        ]

    def improve(self, formulas: Sequence[str]) -> None:
        """Other kinds where more formulas then fit: type errors tell what typeface did not. Symbols that are
        written alike change their kinds together first."""
        self.takes_steps = False
        for turn in range(_ROUNDS):
            known = len(self.guesses)
            outcomes = self.read_all(formulas)
            users: dict[str, set[int]] = {}
            for place, outcome in enumerate(outcomes):
                for name in outcome.symbols if parses(formulas[place]) else ():
                    users.setdefault(name, set()).add(place)
            fits = [outcome.stage for outcome in outcomes]
            changed = False
            groups = families(list(self.guesses)[:MOST_TRIED])
            if turn:
                groups += _together(outcomes, self.guesses)
            groups.sort(key=lambda group: any(self.guesses[name].is_said for name in group))
            for group in groups[:_MOST_GROUPS]:
                places = sorted(set().union(*(users.get(name, set()) for name in group)))
                places.sort(key=lambda place: fits[place] == 3)  # what cannot gain is read last, if at all
                if any(fits[place] < 3 for place in places):
                    sizes = _sizes(outcomes[place] for place in places) if turn else ()
                    changed |= self._improve(
                        group, [formulas[place] for place in places], places, fits, sizes
                    )
            if turn and not changed and known == len(self.guesses):
                if self.takes_steps:
                    return
                self.takes_steps = True

    def take_magnitudes(self, formulas: Sequence[str]) -> None:
        """A letter without the bold of a vector is its magnitude, where no formula is lost by it."""
        for name, guess in list(self.guesses.items()):
            if guess.why not in (USUAL, CAPITAL) or not self.vector_of(name):
                continue
            scalar = Guess(name, "scalar", f"{self.vector_of(name)} is the vector")
            users = [latex for latex in formulas if flat(name) in flat(latex)]
            before, now = (
                [self._read(latex, guesses).stage for latex in users]
                for guesses in (self.guesses, self.guesses | {name: scalar})
            )
            if all(one <= other for one, other in zip(before, now, strict=True)):
                self.guesses[name] = scalar

    def vector_of(self, name: str) -> str | None:
        """The vector in bold or under an arrow that has the same letter."""
        vectors = (each.name for each in self.guesses.values() if each.kind == "vector" and each.name != name)
        return next((each for each in vectors if without_bold(each) == name), None)

    def _improve(
        self,
        group: Sequence[str],
        users: Sequence[str],
        places: Sequence[int],
        fits: list[int],
        sizes: Sequence[str],
    ) -> bool:
        now = [fits[place] for place in places]
        best, kind = now, None
        for other in (*(kind for kind in kinds_by_face(group[0]) if kind in self.kinds), *sizes):
            if all(self.guesses[name].kind == other for name in group):
                continue
            changed = {name: Guess(name, other) for name in group}
            try:
                fitting = self._fitting(self.guesses | changed, users, self._score(best))
            except SpecError:
                continue
            is_component = any(by_typeface(name).why == COMPONENT for name in group)
            if is_component and fitting.count(3) == best.count(3):
                continue  # a component is no vector for the sake of a formula that is not read either
            if self._score(fitting) > self._score(best):
                best, kind = fitting, other
        if kind is None:
            return False
        why = f"{best.count(3)} of {len(users)} formulas with it fit then"
        for name in group:
            self.guesses[name] = replace(self.guesses[name], kind=kind, why=why, unit=False)
        for place, fit in zip(places, best, strict=True):
            fits[place] = fit
        return True

    def _score(self, fits: Sequence[int], unknown: int = 0) -> tuple[int, int]:
        """How many formulas are read and, where that no longer grows, how far the others are; at most, if
        some are not known."""
        steps = sum(fits) + 3 * unknown if self.takes_steps else 0
        return fits.count(3) + unknown, steps

    def _fitting(
        self, guesses: dict[str, Guess], formulas: Sequence[str], least: tuple[int, int]
    ) -> list[int]:
        """Of each formula, how far it is read; no more of them than it takes to see that this scores no more
        than `least`."""
        fits: list[int] = []
        for count, latex in enumerate(formulas):
            if self._score(fits, len(formulas) - count) <= least:
                break
            fits.append(self._read(latex, guesses).stage)
        return fits

    def _read(self, latex: str, guesses: dict[str, Guess]) -> Outcome:
        """What comes of the formula with these symbols; those that it needs are added to them."""
        for _ in range(_MOST_SYMBOLS):
            outcome = self._attempt(latex, guesses)
            if outcome.statements is not None or outcome.ill_formed:
                break
            unknown = _UNKNOWN.search(outcome.message)
            name = self._labelled(latex, guesses) if unknown is None else bare_name(unknown[1])
            if name is None or (name == "e" and self.has_exponentials):
                break
            name = self._without_accent(name)
            if name in self.refused:
                return Outcome(message=self.refused[name])
            if name in guesses:  # declared, and unknown still
                break
            guess = self.guesses.get(name) or self._guess(name)
            try:
                self._declared(guess)
            except (SpecError, ReadError) as refused:
                self.refused[name] = str(refused)
                break
            guesses[name] = self.guesses[name] = guess
        return outcome

    def _without_accent(self, name: str) -> str:
        """The symbol under an accent that the notation explains."""
        with suppress(SpecError):
            key, _ = read_key(name)
            if key.styles and self.ground.notations.accents(key.styles[0]):
                return str(replace(key, styles=key.styles[1:]))
        return name

    def _attempt(self, latex: str, guesses: Mapping[str, Guess]) -> Outcome:
        """Reading it depends on the kinds that the reader asks for until it fails, on which symbols share a
        letter with it, and on whether any is a quaternion."""
        near, names = self._near(latex, guesses)
        quaternions = (guess for guess in guesses.values() if "quaternion" in guess.kind)
        quaternion = next(quaternions, None) if self.prose.has_quaternions else None

        def answer(name: Name | None) -> object:
            if name is None:
                return names
            found = [guesses.get(each) for each in self._names.get(name, ("",))]
            return tuple((each.kind, each.unit) for each in found if each) if all(found) else None

        key = (latex, quaternion is None)
        known = self._read_before.get(key)
        while isinstance(known, Asks):
            known = known.then.get(answer(known.name))
        if known is None:
            outcome, asked = self._fresh(
                latex, [*(guesses[name] for name in near), *filter(None, [quaternion])]
            )
            place: dict[object, Asks | Outcome] = self._read_before
            slot: object = key
            for name in asked:
                asks = place.get(slot)
                if not isinstance(asks, Asks):
                    asks = place[slot] = Asks(name)
                place, slot = asks.then, answer(name)
            known = place[slot] = outcome
        return known

    def _near(self, latex: str, guesses: Mapping[str, Guess]) -> tuple[list[str], frozenset[str]]:
        """The names that share a letter with the formula; names only ever join, behind the others."""
        count, near, names = self._near_before.get(latex, (0, [], frozenset()))
        if count < len(guesses):
            letters = letters_in(latex) if parses(latex) else frozenset()
            new = islice(guesses, count, None)
            near = [*near, *(name for name in new if not letters.isdisjoint(letters_in(name)))]
            names = frozenset(near)
            self._near_before[latex] = len(guesses), near, names
        return near, names

    def _fresh(self, latex: str, guesses: Sequence[Guess]) -> tuple[Outcome, Iterable[Name | None]]:
        symbols = dict(self.ground.symbols)
        letters = {guess.name: guess for guess in guesses if guess.name in INDEX_LETTERS}
        for guess in guesses:
            symbols |= self._declared(guess)
            for letter in letters.values() if guess.name not in letters else ():
                symbols |= self._beside(guess, letter)
        asked = Asked(symbols)
        table = replace(self.ground, symbols=asked, names_close=False)
        try:
            try:
                outcome = Outcome(read(latex, table))
            except ReadError as error:
                unclaimed(error, latex, table)
                outcome = Outcome(())
        except IllFormedAt as error:
            outcome = Outcome(message=error.message, ill_formed=True)
        except ReadError as error:
            outcome = Outcome(message=error.message, ill_formed=bool(_OF_KINDS.search(error.message)))
        return outcome, asked.asked

    def _declared(self, guess: Guess) -> Mapping[Name, Declaration]:
        """The symbol as a table has it. Raises SpecError, ReadError."""
        if guess not in self._symbols:
            self._symbols[guess] = self.ground.with_specs({guess.name: guess.spec}).symbols
            self._take(self._symbols[guess], guess)
        return self._symbols[guess]

    def _beside(self, guess: Guess, letter: Guess) -> Mapping[Name, Declaration]:
        """The symbol beside another that is a letter of indices elsewhere: T_m beside the mass m."""
        if letter.name not in letters_in(guess.name):
            return {}
        if (guess, letter) not in self._symbols:
            specs = {each.name: each.spec for each in (guess, letter)}
            both = self.ground.with_specs(specs).symbols
            known = self._declared(guess).keys() | self._declared(letter).keys()
            own = {name: both[name] for name in both.keys() - known}
            self._symbols[guess, letter] = own
            self._take(own, guess, letter)
        return self._symbols[guess, letter]

    def _take(self, symbols: Mapping[Name, Declaration], *guesses: Guess) -> None:
        """Whose kinds it takes to know each of these names."""
        new = symbols.keys() - self.ground.symbols.keys()
        self._names |= dict.fromkeys(new, tuple(guess.name for guess in guesses))

    def _labelled(self, latex: str, guesses: Mapping[str, Guess]) -> str | None:
        """A symbol with a capital or a script letter as a superscript, which is no power, and which is not
        known yet."""
        for match in chain(LABELLED.finditer(latex), ADJOINT.finditer(latex)):
            with suppress(SpecError):
                key, places = read_key(match[0])
                if not places and key not in self.ground.symbols and str(key) not in guesses:
                    return str(key)
        return None

    def _guess(self, name: str) -> Guess:
        if (guess := self.prose.guess(name)) is not None:
            return guess
        return by_typeface(name)


def _known(latex: str, names: Iterable[str]) -> set[str]:
    """The names that the formula may use: by their letters."""
    formula = flat(latex)
    return {name for name in names if flat(name) in formula}


def _sizes(outcomes: Iterable[Outcome]) -> list[str]:
    """The sizes of matrices that stand against something else in these formulas."""
    messages = " ".join(outcome.message for outcome in outcomes if outcome.stage == 2)
    return sorted(set(_MATRIX.findall(messages)))[:_MOST_SIZES]


def _together(outcomes: Sequence[Outcome], guesses: Mapping[str, Guess]) -> Iterator[list[str]]:
    """The few symbols of one kind in a formula that does not fit, and pairs of them: as in a × b = c, none
    may help without the others."""
    seen = set()
    for outcome in outcomes:
        for kind in KINDS if outcome.ill_formed else ():
            names = sorted(name for name in outcome.symbols & guesses.keys() if guesses[name].kind == kind)
            if not 1 < len(names) <= _MOST_TOGETHER:
                continue
            for group in [tuple(names), *combinations(names, 2)]:
                if group not in seen:
                    seen.add(group)
                    yield list(group)
