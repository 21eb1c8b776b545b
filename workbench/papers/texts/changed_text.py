"""The paper of a changed text: what did not change stands, and what changed is read in its old notation.

It is made in a tenth of the time of reading the whole text, which follows and counts.
"""

from __future__ import annotations

from bisect import bisect_right, insort
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, replace
from difflib import SequenceMatcher
from pathlib import Path

from workbench.context.claims import Claim, Notation
from workbench.context.formula_facts import with_moving
from workbench.core.spans import Span
from workbench.core.terms import sides_of
from workbench.language.definitions import Definitions
from workbench.language.grammar.latex_keys import latex_key
from workbench.papers.texts.functions_in_sentences import asked_if_function, functions_in
from workbench.papers.texts.model_assignments import Placed
from workbench.papers.texts.text_paper import (
    TextPaper,
    claim_of,
    placed_steps,
    with_facts_of_formulas,
    with_own_facts,
)
from workbench.source.documents import Display, Text


@dataclass(frozen=True)
class ChangedText:
    """A changed text as a paper.

    Attributes:
        paper: The claims of displays that did not change, under their ids, and the new ones.
        new: The ids of the new claims.
    """

    paper: TextPaper
    new: tuple[str, ...]


def kept_displays(before: Text, now: Text) -> dict[int, int]:
    """Returns the displays that did not change: the index of each, and the one that it had before."""
    old, new = ([_content(display) for display in text.displays] for text in (before, now))
    matcher = SequenceMatcher(None, old, new, autojunk=False)
    return {b + k: a + k for a, b, size in matcher.get_matching_blocks() for k in range(size)}


def _content(display: Display) -> tuple[str, str, str]:
    source = display.source
    return str(source.path), source.text[display.start : display.end], display.latex


def notation_before(before: TextPaper, kept: Mapping[int, int]) -> Callable[[int], Notation]:
    """Returns a function: the index of a display → the notation of the nearest unchanged one before it."""
    own = _by_display(before)

    def notation(index: int) -> Notation:
        old = next((kept[place] for place in range(index, -1, -1) if place in kept), -1)
        claims = (own[place] for place in range(old, -1, -1) if place in own)
        return next((found[0].notation for found in claims), before.notation)

    return notation


def without_definitions(notation: Notation, names: Collection[str]) -> Notation:
    """Returns the notation without the definitions of these symbols and functions."""
    own = [(each, str(each.declaration.name.without_arguments())) for each in notation.definitions]
    kept = [each for each, name in own if name not in names]
    return replace(notation, definitions=Definitions(kept)) if names else notation


def touched_displays(paper: TextPaper, names: Collection[str]) -> set[int]:
    """Returns the displays with a claim that speaks of these symbols, or may, itself or by its context."""
    return {
        place
        for place, claims in _by_display(paper).items()
        if any(_may_speak_of(claim, names) for claim in claims)
    }


def _may_speak_of(claim: Claim, names: Collection[str]) -> bool:
    if claim.printed.statement is None:
        formula = latex_key(claim.printed.latex)
        return any(latex_key(name) in formula for name in names)
    said = [claim.printed, *claim.assume, *claim.context.given]
    sides = [side for each in said if each.statement is not None for side in sides_of(each.statement)]
    about = {name for fact in claim.context.facts for name in fact.about}
    about |= {each.declaration.name for each in claim.notation.definitions.symbols_in(*sides)}
    return any(str(each) in names for each in about)


def changed_text(
    before: TextPaper, text: Text, kept: Mapping[int, int], notation: Callable[[int], Notation]
) -> ChangedText | None:
    """Returns the paper of a changed text; None if the model speaks of a display that changed.

    kept: the displays whose claims stand, each with its index before.
    notation: of the display at an index.
    """
    assert before.text is not None, "a text has been read"
    own = _by_display(before)
    standing = {claim.id: claim for old in kept.values() for claim in own.get(old, ())}
    if not before.keyed <= standing.keys():
        return None
    guessed = sorted({name for claim in before.claims for name in claim.context.guessed})
    functions = functions_in(text)
    made: list[tuple[Claim, Display]] = []
    new: dict[str, Placed] = {}
    for index, display in enumerate(text.displays):
        if index in kept:
            old = before.text.displays[kept[index]]
            made += [(_moved(claim, old, display), display) for claim in own.get(kept[index], ())]
            continue
        for each in placed_steps([display], [(0, notation(index))], standing.keys() | new.keys()):
            new[each.id] = each
            made.append((asked_if_function(claim_of(each, (), guessed), functions), display))
    claims = with_moving([claim for claim, _ in made])
    told = [claim for claim in claims if claim.id in new]
    said = {each.id: each for each in with_own_facts(told, [*new.values()], text)} if new else {}
    claims = with_facts_of_formulas([said.get(claim.id, claim) for claim in claims], [d for _, d in made])
    whole = tuple(one if one.id in new else old for one, (old, _) in zip(claims, made, strict=True))
    return ChangedText(replace(before, text=text, claims=whole), tuple(new))


def _by_display(paper: TextPaper) -> dict[int, list[Claim]]:
    """Returns the claims of each display."""
    assert paper.text is not None, "a text has been read"
    places: dict[Path, list[tuple[int, int]]] = {}
    for place, display in enumerate(paper.text.displays):
        insort(places.setdefault(display.source.path, []), (display.start, place))
    sources = {display.source.path: display.source for display in paper.text.displays}
    made: dict[int, list[Claim]] = {}
    for claim in paper.claims:
        span = claim.context.span
        assert span is not None, "a claim of a text has a span"
        offset = sources[span.file].offset(span.line, span.column)
        at = bisect_right(places[span.file], (offset, len(paper.text.displays))) - 1
        made.setdefault(places[span.file][max(at, 0)][1], []).append(claim)
    return made


def _moved(claim: Claim, old: Display, new: Display) -> Claim:
    """Returns the claim where its display stands now."""
    here, there = (each.source.place(each.start) for each in (old, new))
    if here == there or claim.context.span is None:
        return claim
    lines, columns = there[0] - here[0], there[1] - here[1]

    def moved(span: Span) -> Span:
        return Span(
            span.file,
            span.line + lines,
            span.column + columns * (span.line == here[0]),
            span.end_line + lines,
            span.end_column + columns * (span.end_line == here[0]),
        )

    at = claim.printed.at
    return replace(
        claim.with_context(span=moved(claim.context.span)),
        printed=replace(claim.printed, at=moved(at) if at is not None else None),
        source=replace(claim.source, line=claim.source.line + lines),
    )
