"""Scopes of definitions in sentences that count in their section, or that another sentence replaces."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from workbench.context.introducing_words import counts_in_section_only
from workbench.papers.drafting.drafted_definitions import Formula, Proposed
from workbench.papers.drafting.redefinitions import Scope
from workbench.papers.drafting.typefaces import Guess
from workbench.source.documents import Display

Said = tuple[Proposed, Formula]


def for_the_text(said: Sequence[Said]) -> list[Proposed]:
    """Returns the definitions that do not count in their section only."""
    return [each for each, formula in said if not counts_in_section_only(formula.display)]


def scopes_of_sentences(
    said: Sequence[Said],
    displays: Sequence[Display],
    guesses: Mapping[str, Guess],
    defined: Mapping[str, Proposed],
) -> Iterator[Scope]:
    """Yields the scopes of definitions that count in their section, and of those in another section than the
    definition of the text.
    """
    sections = {each.line: _section(formula.display) for each, formula in said}
    for each, formula in said:
        if each.name not in guesses:
            continue
        is_local, first = counts_in_section_only(formula.display), defined.get(each.name)
        is_other = first is not None and first.in_sentence and first.body != each.body
        if not is_local and not (is_other and first and sections.get(first.line) != sections[each.line]):
            continue
        behind = [d for d in displays if d.source is formula.display.source and d.start > formula.display.end]
        own = [d for d in behind if _section(d) == sections[each.line]]
        if own:
            yield Scope(own[0], "a sentence of the section says so", definitions={each.name: each.body})
        if not own or not (others := behind[behind.index(own[-1]) + 1 :]):
            continue
        if is_local:
            kind = guesses[each.name].kind
            yield Scope(others[0], "another section", symbols={each.name: f'{{ kind = "{kind}" }}'})
        elif first is not None:
            yield Scope(others[0], "another section", definitions={each.name: first.body})


def _section(display: Display) -> tuple[str, str]:
    return display.section or "", display.heading or ""


def used_in(said: Sequence[Said]) -> set[str]:
    """Returns the symbols of the defining formulas in sentences."""
    return set().union(*(formula.outcome.symbols for _, formula in said))
