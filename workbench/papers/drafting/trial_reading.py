"""Trial reading of a text's formulas with the inferred kinds: the outcome of each."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cache
from itertools import chain

from workbench.context.free_symbols import terms_of
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import IllFormedAt, ReadError, SpecError
from workbench.core.names import Name
from workbench.core.reasons import Reason
from workbench.core.terms import Statement, Symbol
from workbench.language.function_places import symbols_behind
from workbench.language.naming.declarations import read_key
from workbench.language.naming.spelling import INDEX_LETTERS
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read, unclaimed
from workbench.papers.drafting.drafted_functions import DraftedFunction, with_functions
from workbench.papers.drafting.typefaces import ADJOINT, LABELLED, Guess, bare_name, flat
from workbench.runtime import stop_if_asked

#: e with an exponent that is no transpose and no number.
EXPONENTIAL = re.compile(r"(?<![A-Za-z\\])e\s*\^\s*\{\s*(?!-?\d+\s*\}|T\s*\}|\*|\\top|\\ast|\()")
_MOST_SYMBOLS = 60
_CELL = r"(?:[^(),]|\([^(),]*\))+"
#: x = (a, b), also as a column.
_PAIR = re.compile(
    rf"(?P<left>[^=]+)=\s*\((?P<cells>{_CELL},{_CELL})\)\s*(?:\^\s*\{{?\s*(?:T|\\top|\\mathsf\s*\{{?T\}}?)\s*\}}?)?\s*"
)


@dataclass
class Outcome:
    """The outcome of reading one formula: its statements, or the reason why not.

    Attributes:
        ill_formed: Whether the kinds of the formula do not fit.
    """

    statements: tuple[Statement, ...] | None = None
    reason: Reason | None = None
    ill_formed: bool = False
    symbols: set[str] = field(default_factory=set)

    @property
    def progress(self) -> tuple[bool, Reason | None]:
        """(whether the formula is read, the reason if it is not)."""
        return self.statements is not None, self.reason


class Reader:
    """Reads formulas with guessed symbols, and declares new symbols by their typeface.

    Attributes:
        has_exponentials: Whether e is a number.
        functions: The defined functions that the reader knows.
    """

    def __init__(
        self,
        ground: SymbolTable,
        guesses: Mapping[str, Guess],
        has_exponentials: bool,
        by_face: Callable[[str], Guess],
        functions: Sequence[DraftedFunction] = (),
    ) -> None:
        self.ground, self.has_exponentials, self._by_face = ground, has_exponentials, by_face
        self.guesses: dict[str, Guess] = {}
        self.refused: dict[str, Reason] = {}
        self._table = replace(ground, names_close=False)
        names = {each.name for each in functions}
        self._declare(each for each in guesses.values() if each.name not in names)
        self._table, self.functions = with_functions(self._table, functions)
        known = {each.name for each in self.functions}
        self._declare(each for each in guesses.values() if each.name in names - known)

    def read(self, latex: str) -> Outcome:
        """Returns the outcome for the formula, after declaring the symbols that it needs."""
        stop_if_asked()
        for _ in range(_MOST_SYMBOLS):
            outcome = self._attempt(latex)
            if outcome.statements is not None or outcome.ill_formed:
                break
            unknown = _unknown_symbol(outcome.reason)
            name = self._labelled(latex) if unknown is None else bare_name(unknown)
            if name is None or (name == "e" and self.has_exponentials):
                break
            name = self._without_accent(name)
            if name in self.refused:
                outcome = Outcome(reason=self.refused[name])
                break
            if name in self.guesses:  # it was declared before, and is still unknown
                break
            self._declare([self._by_face(name)])
        outcome.symbols = self._used(latex, outcome.statements)
        return outcome

    def read_in_space(self, latex: str) -> tuple[str, Outcome]:
        """Returns the formula and the outcome for it.

        A vector of two components, as in e = (cos θ, sin θ), gets the third one 0 if it fits then.
        """
        outcome = self.read(latex)
        if outcome.ill_formed and (pair := _PAIR.fullmatch(latex)) is not None:
            in_space = f"{pair['left']}= ({pair['cells']}, 0)"
            again = self.read(in_space)
            if again.statements is not None:
                return in_space, again
        return latex, outcome

    def _declare(self, guesses: Iterable[Guess]) -> None:
        """Declares the symbols that the notation does not explain, except those that the table rejects."""
        specs: dict[str, Mapping[str, object]] = {}
        for guess in guesses:
            if guess.name == "e" and self.has_exponentials:
                continue
            with suppress(SpecError, ReadError):
                if read_key(guess.name)[0] not in self.ground.notations.constants:
                    specs[guess.name] = guess.spec
                    self.guesses[guess.name] = guess
        while specs:
            try:
                self._table = self._table.with_specs(specs)
                return
            except SpecError as refused:
                key = refused.key if refused.key in specs else next(reversed(specs))
                self.refused[key] = refused.reason
                del specs[key], self.guesses[key]

    def _used(self, latex: str, statements: tuple[Statement, ...] | None) -> set[str]:
        if statements:
            terms = [term for each in statements for term in terms_of(each)]
            symbols = [term for term in terms if isinstance(term, Symbol)]
            symbols += [each for term in symbols for each in symbols_behind(term)]
            used = {each.declaration.name for each in symbols}
            return {name for name in self.guesses if not used.isdisjoint(_declared_names(name))}
        formula = flat(latex)
        return {name for name in self.guesses if flat(name) in formula}

    def _without_accent(self, name: str) -> str:
        """Returns the symbol under an accent that the notation explains."""
        with suppress(SpecError):
            key, _ = read_key(name)
            if key.styles and self.ground.notations.accents(key.styles[0]):
                return str(replace(key, styles=key.styles[1:]))
        return name

    def _labelled(self, latex: str) -> str | None:
        """Returns an undeclared symbol whose superscript is a capital or a script letter, and thus not a
        power."""
        for match in chain(LABELLED.finditer(latex), ADJOINT.finditer(latex)):
            with suppress(SpecError):
                key, places = read_key(match[0])
                if not places and key not in self.ground.symbols and str(key) not in self.guesses:
                    return str(key)
        return None

    def _attempt(self, latex: str) -> Outcome:
        try:
            try:
                return Outcome(read(latex, self._table))
            except ReadError as error:
                unclaimed(error, latex, self._table)
                return Outcome(())
        except IllFormedAt as error:
            return Outcome(reason=error.message, ill_formed=True)
        except ReadError as error:
            return Outcome(reason=error.message)


@cache
def _declared_names(key: str) -> frozenset[Name]:
    """Returns the names that a key may declare: a plain symbol, or a family with an index."""
    return frozenset(read_key(key, letters)[0] for letters in (INDEX_LETTERS, frozenset()))


def _unknown_symbol(reason: Reason | None) -> str | None:
    """Returns the symbol that is unknown, if that is why the formula is not read."""
    for part in reason.parts() if reason is not None else ():
        if part.code is SyntaxCode.UNKNOWN_SYMBOL:
            return part.arguments["text"]
    return None
