"""Facts from sentences, by the lexicon: a property of the symbols that a noun phrase names.

The formulas of a sentence are written ⟦0⟧, ⟦1⟧ in its text. Unformalized words about a symbol make an opaque
fact. A sentence that names no symbol of the claim makes none.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache

from workbench.context.facts import Fact, Origin, Provider, Strength
from workbench.context.formula_subject import names_of
from workbench.context.lexicon import (
    BE,
    CASE,
    CONDITION,
    FOR_ALL,
    KIND_NOUNS,
    NEGATION,
    OPAQUE,
    PREDICATES,
    PROPERTY_WORDS,
    STOP,
)
from workbench.context.property_statements import having, is_stated
from workbench.core.properties import PROPERTIES, Property
from workbench.core.terms import Symbol
from workbench.language.printing.printer import to_latex

_SYMBOLS = r"⟦\d+⟧(?:\s*(?:,|,?\s*and|or)\s*⟦\d+⟧)*"
_FILL = rf"(?:(?!(?:{STOP})\b)[A-Za-z-]+\s+){{0,2}}?"
_NOT, _IF, _CASE = (re.compile(words, re.I) for words in (NEGATION, CONDITION, CASE))
#: Before words in apposition to a symbol: "r its constant radius".
_ITS = r"(?:its|their|the|an?)"
_OPAQUE = re.compile(OPAQUE, re.I)
_CLAUSES = re.compile(r"[,;:.]")
#: Words around a noun phrase that speaks of one symbol, and not of all: "⟦0⟧ is the skew matrix of ⟦1⟧".
_OF_ONE = re.compile(rf"⟦\d+⟧\s*,?\s*(?:{BE}\s+)?(?:the|an?)\s+$", re.I)
_OF_SYMBOL = re.compile(r"\s+of\s+⟦")
#: The number of characters before a match in which a negation counts.
_REACH = 40


_ANY_PROPERTY = re.compile(
    "|".join(rf"\b(?:{words})\b" for table in (PROPERTY_WORDS, PREDICATES) for words in table.values()), re.I
)


def speaks_of(words: str) -> bool:
    """True if the text contains a word for a property."""
    return _ANY_PROPERTY.search(words) is not None


def speaks_for_all(words: str) -> bool:
    """True if the text states something of all symbols of a kind."""
    return any(re.search(KIND_NOUNS[kind], words, re.I) for _, kind in FOR_ALL)


@dataclass(frozen=True)
class Sentence:
    """A sentence near a claim.

    Attributes:
        named: The LaTeX of its formulas.
        is_own: Whether the claim stands in it.
    """

    text: str
    named: Mapping[int, str]
    place: str
    is_own: bool


def told_by(sentence: Sentence, symbols: Sequence[Symbol]) -> Iterator[Fact]:
    """Yields the facts that the sentence states of the symbols of a claim."""
    reader = _Reader(sentence, symbols)
    yield from reader.of_names()
    yield from reader.of_kinds()
    if sentence.is_own:
        yield from reader.opaque()


class _Reader:
    def __init__(self, sentence: Sentence, symbols: Sequence[Symbol]) -> None:
        self._sentence, self._symbols = sentence, symbols
        self._read: list[tuple[int, int]] = []

    @cached_property
    def _known(self) -> dict[str, Symbol]:
        return {flat(to_latex(own)): own for own in self._symbols}

    def of_names(self) -> Iterator[Fact]:
        """Yields the properties of symbols that are named: "the unit vector n", "n is a unit vector"."""
        for name, match in _stated_in(self._sentence.text, self._sentence.is_own):
            row = PROPERTIES[name]
            said = [each for each in self._named_in(match["symbols"]) if is_stated(row, each)]
            for group in _related(said, self._named_in(match.groupdict().get("others") or ""), row):
                self._read.append(match.span())
                yield self._fact(name, group, match[0])

    def of_kinds(self) -> Iterator[Fact]:
        """Yields the properties of all symbols of a kind: "for unit vectors" in the claim's own sentence, or
        "unit quaternions" stated for the rest of the text.
        """
        for name in PROPERTY_WORDS:
            for kind in KIND_NOUNS:
                if self._sentence.is_own or (name, kind) in FOR_ALL:
                    yield from self._of_kind(name, kind)

    def _of_kind(self, name: str, kind: str) -> Iterator[Fact]:
        row, text = PROPERTIES[name], self._sentence.text
        said = [
            own for own in self._symbols if own.type.kind == kind and is_stated(row, own) and not own.index
        ]
        if not said or row.count not in (1, len(said)):
            return
        for match in _of_a_kind(name, kind).finditer(text):
            if _OF_ONE.search(text[: match.start()]) or _OF_SYMBOL.match(text, match.end()):
                continue
            is_meant = (name, kind) in FOR_ALL or _IF.search(_CLAUSES.split(text[: match.start()])[-1])
            if is_meant and not _is_negated(text, match):
                self._read.append(match.span())
                yield self._fact(name, said, match[0])

    def opaque(self) -> Iterator[Fact]:
        """Yields opaque facts for unformalized words about a symbol: "r is approximately …"."""
        start = 0
        for clause in _CLAUSES.split(self._sentence.text):
            words = (start + match.start() for match in _OPAQUE.finditer(clause))
            is_unread = any(not any(a <= at < b for a, b in self._read) for at in words)
            start += len(clause) + 1
            if is_unread and not _NOT.search(clause) and (said := self._named_in(clause)):
                about = names_of([each.declaration for each in said])
                yield Fact(None, about, self._origin(clause.strip()), Strength.HINTED)

    def _named_in(self, words: str) -> list[Symbol]:
        named = (self._sentence.named[int(number)] for number in re.findall(r"⟦(\d+)⟧", words))
        return [self._known[key] for key in map(flat, named) if key in self._known]

    def _fact(self, name: str, said: Sequence[Symbol], words: str) -> Fact:
        about = names_of([each.declaration for each in said])
        return Fact(having(name, said), about, self._origin(words), Strength.HINTED)

    def _origin(self, words: str) -> Origin:
        quoted = re.sub(r"⟦(\d+)⟧", lambda match: f"${self._sentence.named[int(match[1])]}$", words)
        return Origin(Provider.SENTENCE, f"“{quoted}”", self._sentence.place)


@cache
def _of_a_kind(name: str, kind: str) -> re.Pattern[str]:
    """Returns the pattern of a property of all symbols of a kind: "unit vectors", "vectors are unit"."""
    words, noun = PROPERTY_WORDS[name], KIND_NOUNS[kind]
    before = rf"\b(?:{words})\s+{_FILL}(?:{noun})\b(?!\s*⟦)"
    return re.compile(rf"{before}|\b(?:{noun})\s+{BE}\s+{_FILL}(?:{words})\b", re.I)


@lru_cache(maxsize=4096)
def _stated_in(text: str, is_own: bool) -> tuple[tuple[str, re.Match[str]], ...]:
    """Returns the properties of named symbols that a sentence states, whatever the symbols are: it is asked
    once, and not for each claim."""
    return tuple(
        (name, match)
        for name, words in PROPERTY_WORDS.items()
        for match in _matches(words, PREDICATES.get(name), text)
        if not _is_negated(text, match) and (is_own or not is_case(text[: match.start()]))
    )


def _matches(words: str, predicate: str | None, text: str) -> Iterator[re.Match[str]]:
    """Yields "unit vector u", "u is a unit vector", "u has unit length" and "a is perpendicular to b"."""
    symbols = rf"(?P<symbols>{_SYMBOLS})"
    to = rf"\s+(?:to|with)\s+{_FILL}(?P<others>{_SYMBOLS})"
    yield from re.finditer(rf"\b(?:{words})\b\s+{_FILL}{symbols}", text, re.I)
    yield from re.finditer(rf"{symbols}\s*(?:,\s*)?{BE}\s+{_FILL}\b(?:{words})\b(?:{to})?", text, re.I)
    yield from re.finditer(rf"{symbols}\s+(?:{words}){to}", text, re.I)
    yield from re.finditer(rf"{symbols}\s*,?\s*{_ITS}\s+(?:{words})\b(?!\s+{_FILL}⟦)", text, re.I)
    if predicate:
        yield from re.finditer(rf"{symbols}\s+(?P<predicate>{predicate})\b", text, re.I)


def _related(said: Sequence[Symbol], others: Sequence[Symbol], row: Property) -> Iterator[Sequence[Symbol]]:
    """Yields the groups of symbols that have the property: each pair where it relates two of them."""
    if others and row.count == 2:
        yield from ((one, other) for one in said for other in others if row.fits(other))
    elif said and row.count in (1, len(said)):
        yield said


def _is_negated(text: str, match: re.Match[str]) -> bool:
    clause = _CLAUSES.split(text[: match.start()])[-1]
    is_predicate = match.groupdict().get("predicate") is not None
    return bool(_NOT.search(clause[-_REACH:]) or (not is_predicate and _NOT.search(match[0])))


def is_case(before: str) -> bool:
    """True if the words before a property make it one of a case, which no other sentence supposes."""
    return bool(_CASE.search(re.split(r"[;:.]", before)[-1]))


def flat(latex: str) -> str:
    """Returns LaTeX without the marks that do not change the meaning of a name."""
    return re.sub(r"\\(?:left|right|,|;|!|displaystyle)(?![A-Za-z])|[\s{}]", "", latex.strip(" ,.;"))
