"""Facts from the sentences of a text; `context.sentences` reads the words."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property, partial
from pathlib import Path

from workbench.context.claims import Notation
from workbench.context.condition_facts import InlineFormulas
from workbench.context.facts import Fact
from workbench.context.formula_acts import is_before_scope
from workbench.context.sentences import Sentence, flat, speaks_for_all, speaks_of, told_by
from workbench.core.construct import symbol
from workbench.core.terms import Statement, Symbol, sides_of
from workbench.language.printing.printer import to_latex
from workbench.source.documents import Display, spelled
from workbench.source.documents.source_view import Source
from workbench.source.documents.surrounding_words import sentence_around, sentence_ends, supposed_before
from workbench.source.rows.chains import Step

#: The characters around a formula in prose.
_OPENING, _CLOSING = "$`(\\ \n", ("$", "`", "\\", ")")
_LABEL = re.compile(r"\\(?:label|ref|eqref|cite)\s*\{[^}]*\}|:math:")


class TextSentences:
    """The sentences of a text, read once for all of its displays."""

    def __init__(self, inline: Sequence[Display], spoken: InlineFormulas, notation: Notation) -> None:
        self._inline = inline
        self._steps = partial(spoken.steps, notation=notation)
        self._files: dict[Path, _FileSentences] = {}

    def facts(self, display: Display, statement: Statement, notation: Notation) -> Iterator[Fact]:
        """Yields the facts that the sentence of a display, and earlier sentences, state of its symbols."""
        symbols = _symbols(statement, notation)
        known = {flat(to_latex(own)): own for own in symbols}
        for sentence, line in self._of(display.source).up_to(display):
            told = symbols
            if not sentence.is_own:
                is_named = not known.keys().isdisjoint(map(flat, sentence.named.values()))
                if not (is_named or speaks_for_all(sentence.text)):
                    continue
                path = display.source.path
                told = [
                    own
                    for own in symbols
                    if not is_before_scope([own.declaration.name], path, line, notation)
                ]
            yield from told_by(sentence, told)

    def _of(self, source: Source) -> _FileSentences:
        if source.path not in self._files:
            inline = [each for each in self._inline if each.source.path == source.path]
            self._files[source.path] = _FileSentences(source, inline, self._steps)
        return self._files[source.path]


class _FileSentences:
    def __init__(
        self, source: Source, inline: Sequence[Display], steps: Callable[[Display], Sequence[Step]]
    ) -> None:
        self._source, self._steps = source, steps
        self._inline = sorted(inline, key=lambda each: each.start)

    def up_to(self, display: Display) -> Iterator[tuple[Sentence, int]]:
        """Yields the sentence of a display, and then the earlier sentences that may state a property of a
        symbol, each with its line.
        """
        prose = self._source.prose
        first, last = sentence_around(prose, display.start, display.end)
        first -= len(supposed_before(prose, first))
        line = self._source.place(display.start)[0]
        yield self._numbered(first, last, line, display), line
        for start, end, sentence, at in self._telling:
            if end <= first and start < first:
                yield sentence, at

    @cached_property
    def _telling(self) -> list[tuple[int, int, Sentence, int]]:
        """The sentences that name a symbol and contain a word of the lexicon."""
        prose = self._source.prose
        ends = [end for end in sentence_ends(prose) if not any(f.start < end < f.end for f in self._inline)]
        found, start = [], 0
        for end in [*ends, len(prose)]:
            has_formula = any(start <= each.start < end for each in self._inline)
            words = prose[start:end]
            if speaks_of(words) and (has_formula or speaks_for_all(words)):
                line = self._source.place(start + len(words) - len(words.lstrip()))[0]
                found.append((start, end, self._numbered(start, end, line, None), line))
            start = end
        return found

    def _numbered(self, first: int, last: int, line: int, display: Display | None) -> Sentence:
        """Returns the prose from first to last with ⟦0⟧, ⟦1⟧ for its formulas."""
        prose = self._source.prose
        inside = [each for each in self._inline if first <= each.start < last]
        inside = sorted([*inside, *([display] if display else [])], key=lambda each: each.start)
        pieces: list[str] = []
        named: dict[int, str] = {}
        at = first
        for formula in inside:
            pieces.append(prose[at : formula.start].rstrip(_OPENING) + " ")
            at = formula.end
            if formula is display:
                pieces.append(" ; ")
                continue
            for part in self._steps(formula):
                pieces.append(f" ⟦{len(named)}⟧ ")
                named[len(named)] = spelled(part.tokens)[0]
            while prose[at : at + 1] in _CLOSING and at < last:
                at += 1
        pieces.append(prose[at:last])
        text = " ".join(_LABEL.sub(" ", "".join(pieces)).split())
        return Sentence(text, named, f"line {line}", display is not None)


def _symbols(statement: Statement, notation: Notation) -> list[Symbol]:
    found = dict.fromkeys(notation.definitions.symbols_in(*sides_of(statement)))
    return [each if each.index else symbol(each.declaration) for each in found if not each.arguments]
