"""Draft of a model: reads a text, infers the kinds of its symbols, and records which formulas it can read."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from workbench.context.unread_facts import without_bound
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.paper_errors import NoDisplay, PaperError
from workbench.core.reasons import Reason
from workbench.papers.drafting.drafted_abbreviations import abbreviations
from workbench.papers.drafting.drafted_definitions import (
    Formula,
    Proposed,
    definitions_in,
    each_once,
    in_order_of_use,
    in_sentences,
    magnitudes,
    spins_of_tensors,
)
from workbench.papers.drafting.drafted_frames import rates_in_turning_frames, with_spins
from workbench.papers.drafting.drafted_functions import (
    DraftedFunction,
    functions_elsewhere,
    functions_in,
    with_places,
)
from workbench.papers.drafting.formula_shapes import (
    axes,
    columns,
    components,
    components_of,
    coordinates,
    jacobians,
    matrices,
)
from workbench.papers.drafting.inference.infer import Inference, Source, infer
from workbench.papers.drafting.marked_text import MarkedText
from workbench.papers.drafting.meanings.printed_jacobians import printed_jacobians
from workbench.papers.drafting.missing_features import feature_of
from workbench.papers.drafting.model_proposal import Proposal, ground_of, words_of
from workbench.papers.drafting.notation_proposals import proposals_for, unit_tensor
from workbench.papers.drafting.questions import questions_of
from workbench.papers.drafting.redefinitions import Scope, parted_quaternions, scopes_of
from workbench.papers.drafting.sentence_kinds import Facts, facts_of
from workbench.papers.drafting.sentence_scopes import for_the_text, scopes_of_sentences, used_in
from workbench.papers.drafting.symbol_guesses import guesses_of, labels_in
from workbench.papers.drafting.trial_reading import EXPONENTIAL, Outcome, Reader
from workbench.papers.drafting.typefaces import Guess, by_typeface, without_bold
from workbench.papers.drafting.undeclared_macros import letters_in_bold
from workbench.papers.drafting.words_on_symbols import Prose
from workbench.source.documents import Display, Text, read_text
from workbench.source.rows.chains import Step, steps_of

#: The length above which an inline formula is not taken as a symbol or a statement about one.
_INLINE = 60


@dataclass(frozen=True)
class Ingested:
    """The draft of a text's model.

    Attributes:
        formulas: One for each step of a display.
        fences: Macros that only TeX can expand, each with what it seems to print.
        confirmed: Names that the author has confirmed.
    """

    text: Text
    macros: Path | None
    guesses: dict[str, Guess]
    formulas: list[Formula]
    definitions: list[Proposed]
    questions: list[str]
    proposals: list[Proposal]
    fences: dict[str, str]
    inference: Inference
    scopes: list[Scope]
    confirmed: frozenset[str] = frozenset()

    def feature_of(self, display: Display) -> str | None:
        """Returns the missing feature that the display needs; None if the display is read as a whole."""
        own = [formula for formula in self.formulas if formula.display is display]
        if not own:
            return "a formula without a relation"
        unread = (each for each in own if each.outcome.statements is None)
        return next((feature_of(each.latex, each.outcome.reason) for each in unread), None)

    def to_dict(self) -> dict[str, Any]:
        """Returns every display with its position and whether it is read."""
        return {
            "displays": [
                {
                    "file": str(display.source.path),
                    "line": display.line,
                    "label": next(iter(display.labels), None),
                    "number": next(iter(display.numbers), None),
                    "latex": display.latex,
                    "read": feature is None,
                    "feature": feature,
                }
                for display in self.text.displays
                for feature in [self.feature_of(display)]
            ]
        }

    def missing(self) -> Counter[str]:
        features = map(self.feature_of, self.text.displays)
        return Counter(feature for feature in features if feature is not None)


def ingest(path: Path, macros: Path | None = None) -> Ingested:
    """Returns a draft of a model. Raises PaperError for a text that cannot be used, or has no display."""
    return ingested(read_text(path, macros), macros)


def ingested(text: Text, macros: Path | None = None, given: Sequence[Guess] = ()) -> Ingested:
    """Returns a draft of the model of a text that was read with these macros. Raises PaperError if it has no
    display.

    given: symbols whose kinds are known. They may have any value of their kinds.
    """
    text, fences = with_fences(text, macros)
    inline, prose = _words(text, given)
    steps = _steps(text.displays, frozenset())
    functions = functions_in((step.spelled()[0], display.line) for display, step in steps)
    inference = _inferred(text, steps, prose, [each.name for each in functions])
    facts = facts_of(MarkedText(text))
    latex = (each.latex for each in (*text.displays, *text.inline))
    labels = {each.name: each for each in labels_in(latex) if each.name not in inference.kinds}
    guessed = labels | _with_facts(guesses_of(inference, prose), facts)
    known = {name: guess for name in guessed if (guess := prose.given_for(name)) is not None}
    elsewhere = functions_elsewhere(step.spelled()[0] for _, step in steps)
    start = with_places(guessed | known, elsewhere, functions)
    guessed, known = ({name: start[name] for name in each} for each in (guessed, known))
    spoken = tuple(each.latex for each in inline if "=" in each.latex and not _opaque(each, each.latex))
    reading = _Reading.of(steps, [], _Start(guessed | known, prose, functions, spoken))
    spins = facts.spins
    for proposal in proposals_for([*reading.formulas, *spoken], prose.text, inference):
        if proposal.table == "frames":
            proposal, spins = with_spins(proposal, spins), []
        reading = reading.tried(text, proposal)
    if spins:
        reading = reading.tried(text, with_spins(None, spins))
    for name in facts.units:
        reading = reading.tried(text, replace(unit_tensor(name), stands=True))
    made = reading.made()
    reader = reading.reader
    lines = _first_lines(made)
    questions = [
        *(f"Does {name} print {body}?" for name, body in fences.items()),
        *(proposal.question for proposal in reading.proposals),
        *questions_of(text),
    ]
    in_displays = definitions_in(made)
    shown = set().union(*(formula.outcome.symbols for formula in made))
    own = {each.symbol for each in in_displays}
    spoken_equations = ((each, without_bound(each.latex)) for each in inline)
    sentences = [
        Formula(display, *reader.read_in_space(latex))
        for display, latex in spoken_equations
        if latex.count("=") == 1 and not _opaque(display, latex)
    ]
    turning = list(spins_of_tensors([*made, *sentences], own))
    own |= {each.symbol for each in turning}
    parts = [(each, whole) for each, whole in components(reader.guesses, lines, own) if each.name in shown]
    for part, whole in parts:
        lines.setdefault(whole, lines[part.name])
    shown |= {whole for _, whole in parts}
    said = list(in_sentences(sentences, {name: lines.get(name, 0) for name in shown}, text.inline))
    rates = [each for each in facts.definitions(_dot(reading.proposals)) if each.name in reader.guesses]
    of_functions = [_function(each) for each in reader.functions]
    short = list(abbreviations(reader.guesses, lines, (each.latex for each in inline)))
    written = [
        *rates,
        *turning,
        *of_functions,
        *short,
        *columns(reader.guesses, lines, own),
        *matrices(reader.guesses, lines, own),
        *axes(reader.guesses, lines, own, inference.moving),
        *rates_in_turning_frames(reading.formulas, reader.guesses, lines),
        *(each for each, _ in parts),
        *sorted([*for_the_text(said), *in_displays], key=_rank),
    ]
    found = [each for each in in_order_of_use(each_once(written)) if each.name not in known]
    guesses = dict(reader.guesses)
    columns_of = {each.name: cells for each in found if (cells := components_of(each.body))}
    of_rates = jacobians(made, columns_of, {each.name: each for each in found})
    of_words = [
        reader.read(f"{each.name} = {each.body}") for each in found if each.in_sentence or each in short
    ]
    for jacobian, places in (*of_rates, *printed_jacobians(made, {each.name for each in found}, of_words)):
        found = [*(each for each in found if each.name != jacobian.name), jacobian]
        guesses |= {name: replace(guesses[name], independent=True) for name in places if name in guesses}
    found = each_once([*found, *magnitudes(made, guesses)])
    free = {*guesses} - {each.symbol for each in found}
    for name in coordinates(made) & free:
        if guesses[name].kind == "scalar" and not guesses[name].constant:
            guesses[name] = replace(guesses[name], independent=True)
    displayed = {name: guess for name, guess in guesses.items() if name in shown}
    parted = parted_quaternions(facts.quaternions, displayed)
    found = [each for each in found if each.name not in parted]
    sure = {each.name: each for each in found if each.sure}
    scopes = scopes_of(text.displays, made, displayed, sure, facts.quaternions)
    scopes += scopes_of_sentences(said, text.displays, guesses, sure)
    scopes.sort(key=lambda scope: text.displays.index(scope.display))
    return Ingested(
        text,
        macros,
        {name: guess for name, guess in guesses.items() if name in shown | used_in(said) | labels.keys()},
        made,
        found,
        list(dict.fromkeys(questions)),
        reading.proposals,
        fences,
        inference,
        scopes,
    )


def _with_facts(guesses: Mapping[str, Guess], facts: Facts) -> dict[str, Guess]:
    """Returns the guesses with properties that sentences state of the symbols."""
    made = dict(guesses)
    for name, guess in guesses.items():
        if name in facts.constants and guess.kind in ("scalar", "vector", "tensor"):
            made[name] = replace(guess, constant=True)
        elif name in facts.free:
            made[name] = replace(guess, free=True)
        elif name in facts.directions and guess.kind == "vector":
            made[name] = replace(guess, unit=True)
    return made


def _rank(proposed: Proposed) -> tuple[bool, int]:
    """Returns the order of definitions: by line, but one by components of the same letter gives way."""
    parts = components_of(proposed.body)
    letter = without_bold(proposed.name)
    return bool(parts) and all(part.startswith(f"{letter}_") for part in parts), proposed.line


def _first_lines(formulas: Sequence[Formula]) -> dict[str, int]:
    lines: dict[str, int] = {}
    for formula in formulas:
        for name in formula.outcome.symbols:
            lines.setdefault(name, formula.display.line)
    return lines


def _dot(proposals: Sequence[Proposal]) -> str:
    """Returns the frame in which a dot differentiates; "" if the text has no frames."""
    return next((each.entries["dot"].strip("'") for each in proposals if "dot" in each.entries), "")


def _inferred(
    text: Text, steps: Sequence[tuple[Display, Step]], prose: Prose, functions: Sequence[str] = ()
) -> Inference:
    sources = [*_sources(steps, False), *_sources(_steps(text.inline, frozenset()), True)]
    return infer(sources, prose, functions)


def _function(function: DraftedFunction) -> Proposed:
    why = "taken at other values elsewhere"
    return Proposed(function.key, function.body, function.line, why, True, function.name)


def _words(text: Text, given: Sequence[Guess] = ()) -> tuple[list[Display], Prose]:
    """Returns the short inline formulas, and the prose."""
    inline = [formula for formula in text.inline if formula.end - formula.start < _INLINE]
    return inline, Prose("\n".join(source.text for source in text.sources[:1]), inline, text.displays, given)


def with_fences(text: Text, macros: Path | None) -> tuple[Text, dict[str, str]]:
    """Returns the text, and what the macros that only TeX can expand seem to print."""
    fences = letters_in_bold(text.displays) | {f"\\{name}": body for name, body in text.fences.items()}
    if fences:
        text = read_text(text.path, macros, bodies=fences)
    if not text.displays:
        raise NoDisplay(text.path)
    return text, fences


@dataclass(frozen=True)
class _Start:
    """The guesses and words with which a text's formulas are read."""

    guesses: dict[str, Guess]
    prose: Prose
    functions: list[DraftedFunction]
    #: the equations of sentences
    spoken: tuple[str, ...] = ()

    def reader(self, proposals: Sequence[Proposal], formulas: Sequence[str]) -> Reader:
        """Returns a reader. Raises PaperError for proposals that contradict each other."""
        has_exponentials = any(map(EXPONENTIAL.search, formulas))
        return Reader(ground_of(proposals), self.guesses, has_exponentials, self.by_face, self.functions)

    def by_face(self, name: str) -> Guess:
        return self.prose.guess(name) or by_typeface(name)


@dataclass
class _Reading:
    """The formulas of a text as read with some proposals.

    Attributes:
        blocked: Formulas with a macro that could not be expanded.
    """

    proposals: list[Proposal]
    steps: list[tuple[Display, Step]]
    formulas: list[str]
    blocked: set[int]
    start: _Start
    known: dict[str, Outcome] = field(default_factory=dict)

    @staticmethod
    def of(steps: list[tuple[Display, Step]], proposals: list[Proposal], start: _Start) -> _Reading:
        formulas = [step.spelled()[0] for _, step in steps]
        blocked = {index for index, (display, _) in enumerate(steps) if _opaque(display, formulas[index])}
        return _Reading(proposals, steps, formulas, blocked, start)

    @cached_property
    def reader(self) -> Reader:
        return self.start.reader(self.proposals, self.formulas)

    def outcome(self, latex: str) -> Outcome:
        if latex not in self.known:
            self.known[latex] = self.reader.read(latex)
        return self.known[latex]

    def tried(self, text: Text, proposal: Proposal) -> _Reading:
        """Returns the reading with one more proposal, if it reads more formulas and loses none.

        A proposal that others depend on may have no effect yet.
        """
        readable = self._readable()
        concerned = [place for place, latex in enumerate(readable) if proposal.trigger.search(latex)]
        if not concerned:
            return self
        proposals = [*self.proposals, proposal]
        if words_of(proposals) == words_of(self.proposals):
            new = _Reading(proposals, self.steps, self.formulas, self.blocked, self.start)
            unconcerned = {*readable} - {readable[place] for place in concerned}
            new.known = {latex: self.known[latex] for latex in unconcerned & self.known.keys()}
        else:
            new = _Reading.of(_steps(text.displays, words_of(proposals)), proposals, self.start)
        try:
            now = new.progress(concerned)
        except PaperError:
            return self
        before = self.progress(concerned)
        lost = any(one[0] > other[0] for one, other in zip(before, now, strict=True))
        return self if lost or not (proposal.stands or before != now) else new

    def _readable(self) -> list[str]:
        """Returns the formulas of displays and sentences that can be read."""
        own = (latex for place, latex in enumerate(self.formulas) if place not in self.blocked)
        return [*own, *self.start.spoken]

    def progress(self, places: Sequence[int]) -> list[tuple[bool, Reason | None]]:
        readable = self._readable()
        return [self.outcome(readable[place]).progress for place in places]

    def made(self) -> list[Formula]:
        return [
            Formula(
                display, latex, _blocked(display, latex) if index in self.blocked else self.outcome(latex)
            )
            for index, ((display, _), latex) in enumerate(zip(self.steps, self.formulas, strict=True))
        ]


def _steps(displays: Sequence[Display], words: frozenset[str]) -> list[tuple[Display, Step]]:
    return [(display, step) for display in displays for line in steps_of(display, words) for step in line]


def _sources(steps: Sequence[tuple[Display, Step]], inline: bool) -> Iterator[Source]:
    for display, step in steps:
        section = f"{display.section} {display.heading}".strip()
        yield Source(step.spelled()[0], display.line, inline, section)


def _opaque(display: Display, latex: str) -> list[str]:
    return [name for name in sorted(display.opaque) if re.search(rf"\\{re.escape(name)}(?![A-Za-z])", latex)]


def _blocked(display: Display, latex: str) -> Outcome:
    names = ", ".join(f"\\{name}" for name in _opaque(display, latex))
    return Outcome(reason=SyntaxCode.OPAQUE_MACROS(names=names))
