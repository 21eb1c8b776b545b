"""The author's notation: terms that the [notation] of a paper has a spelling for."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from workbench.core.construct import symbol
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.integer_instances import free_integers
from workbench.core.names import Name
from workbench.core.terms import Apply, Identity, Integer, Number, Symbol, Term, Zero
from workbench.core.types import Declaration, type_of_kind
from workbench.language.naming.declarations import UNIT
from workbench.language.naming.notations import Notation
from workbench.language.naming.reading_conventions import Gradient
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import meaning_of, read_term

#: Marks the symbol of a slot, so that it differs from all other symbols.
_PLACE = ("a place",)


class AuthorNotation:
    """The notation of one table by its meanings. Spellings that the reader would misread are left out."""

    def __init__(self, table: SymbolTable) -> None:
        self._table = table
        entries = (
            *table.notations.entries,
            *(_derivative_in(frame) for frame in table.frames.velocities if frame != table.frames.dot),
        )
        meanings = ((entry, _meaning(entry, table)) for entry in entries)
        known = [(entry, meaning) for entry, meaning in meanings if meaning is not None]
        self._entries = sorted(known, key=lambda pair: -sum(1 for _ in pair[1].walk()))
        self._read: dict[tuple[str, frozenset[str]], Term | None] = {}

    @property
    def is_plain(self) -> bool:
        return not (self._entries or self.owns_unit or self.has_columns)

    @property
    def owns_unit(self) -> bool:
        return UNIT in self._table.symbols

    @property
    def has_columns(self) -> bool:
        return self._table.conventions.gradient is Gradient.COLUMN

    def spellings(self, term: Term) -> Iterator[tuple[Notation, Mapping[str, Term]]]:
        for entry, meaning in self._entries:
            found: dict[str, Term] = {}
            if _matches(meaning, term, found) and found.keys() == entry.formals.keys():
                yield entry, found

    def reads(self, text: str, term: Term) -> bool:
        asked = text, free_integers(term)
        if asked not in self._read:
            try:
                self._read[asked] = read_term(text, self._table, asked[1])
            except (ReadError, IllFormedAt):
                self._read[asked] = None
        return self._read[asked] == term


def _derivative_in(frame: str) -> Notation:
    spelling = rf"\frac{{{{}}^{{{frame}}} d}}{{dt}}"
    return Notation.read(rf"{spelling} x", {"where": {"x": "vector"}, "means": rf"{spelling} x"})


def _meaning(entry: Notation, table: SymbolTable) -> Term | None:
    """Returns the meaning of the entry, with symbols in the slots of its arguments; None if terms cannot be
    recognized by it."""
    places = {
        letter: symbol(Declaration(Name(letter, of=_PLACE), kind))
        for letter, said in entry.formals.items()
        if (kind := type_of_kind(said.replace("quaternion", "hamilton quaternion")))
    }
    meaning = meaning_of(entry.filled(places), table)
    return None if isinstance(meaning, Symbol | Number | Integer | Zero) else meaning


def _matches(meaning: Term, term: Term, found: dict[str, Term]) -> bool:
    """True if the term has the structure of the meaning, with terms in its slots; records these in
    `found`."""
    if isinstance(meaning, Symbol) and meaning.declaration.name.of == _PLACE:
        same_type = meaning.type == term.type or isinstance(term, Zero)
        return same_type and found.setdefault(meaning.declaration.name.letter, term) == term
    if isinstance(meaning, Identity) or not meaning.children:
        return meaning == term
    heads = [part.head if isinstance(part, Apply) else type(part) for part in (meaning, term)]
    return (
        heads[0] == heads[1]
        and len(meaning.children) == len(term.children)
        and all(_matches(*pair, found) for pair in zip(meaning.children, term.children, strict=True))
    )
