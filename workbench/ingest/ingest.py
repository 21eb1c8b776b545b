"""Reads a text, guesses what its symbols are, and says what it could and could not read."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from workbench.ingest.asked import Outcome
from workbench.ingest.features import feature_of
from workbench.ingest.kinds import Guesser
from workbench.ingest.proposal import Proposal, ground_of, words_of
from workbench.ingest.proposals import proposals_for
from workbench.ingest.prose import Prose
from workbench.ingest.questions import questions_of
from workbench.ingest.typefaces import Guess
from workbench.ingest.undeclared import letters_in_bold
from workbench.language.printing.printer import to_latex
from workbench.language.typed.integers import Linear
from workbench.language.typed.terms import Apply, Derivative, Relation, Statement, Symbol
from workbench.papers.cutting.chains import Step, steps_of
from workbench.papers.model import PaperError
from workbench.papers.said import stated, terms_of
from workbench.papers.texts import Display, Text, read_text

_DEFINES = re.compile(r"\b(?:defined?|denote[ds]?|where|let|set|introduce|is called)\b", re.IGNORECASE)

#: A formula within a sentence that is longer is no symbol alone, and says of none what it is.
_INLINE = 60
#: Proposals are tried, kinds are found, and with these the other proposals, so often.
_TURNS = 3


@dataclass(frozen=True)
class Formula:
    """One step of a display, and what came of reading it."""

    display: Display
    latex: str
    outcome: Outcome

    @property
    def feature(self) -> str | None:
        if self.outcome.statements is not None:
            return None
        return feature_of(self.latex, self.outcome.message)


@dataclass(frozen=True)
class Proposed:
    """A definition: the symbol's LaTeX and what the text says that it is. `sure`: it is written := ."""

    name: str
    body: str
    line: int
    why: str
    sure: bool


@dataclass(frozen=True)
class Ingested:
    text: Text
    macros: Path | None
    guesses: dict[str, Guess]
    formulas: list[Formula]
    definitions: list[Proposed]
    questions: list[str]
    proposals: list[Proposal] = field(default_factory=list)
    fences: dict[str, str] = field(default_factory=dict)

    def feature_of(self, display: Display) -> str | None:
        """What the display needs; None for one that is read as a whole."""
        own = [formula for formula in self.formulas if formula.display is display]
        if not own:
            return "a formula without a relation"
        return next((formula.feature for formula in own if formula.feature is not None), None)

    def to_dict(self) -> dict[str, Any]:
        """Every display: where it is, and whether it is read."""
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
        return Counter(
            feature for display in self.text.displays if (feature := self.feature_of(display)) is not None
        )


def ingest(path: Path, macros: Path | None = None) -> Ingested:
    """Raises PaperError for a text that cannot be used, or that has no display."""
    text = read_text(path, macros)
    fences = letters_in_bold(text.displays) | {f"\\{name}": body for name, body in text.fences.items()}
    if fences:
        text = read_text(path, macros, bodies=fences)
    if not text.displays:
        raise PaperError(path, None, None, "no displayed equation in it")
    inline = [formula for formula in text.inline if formula.end - formula.start < _INLINE]
    prose = Prose("\n".join(source.text for source in text.sources[:1]), inline)
    best = _Reading.of(_steps(text, frozenset()), [], Guesser(prose))
    known: dict[str, Guess] = {}
    for turn in range(_TURNS):
        count = len(best.proposals)
        for proposal in proposals_for(best.formulas, prose.text):
            if proposal not in best.proposals:
                best = best.tried(text, proposal, known)
        if turn and len(best.proposals) == count:
            break
        best.guesser.improve(best.readable)
        best.guesser.take_magnitudes(best.readable)
        best = _Reading.of(best.steps, best.proposals, best.guesser)
        known = best.guesser.guesses
    made, accepted = best.made(), best.proposals
    questions = [
        *(f"Does {name} print {body}?" for name, body in fences.items()),
        *(proposal.question for proposal in accepted),
        *questions_of(text, best.formulas, best.guesser.guesses),
    ]
    in_displays = _definitions(made)
    in_sentences, more = _in_sentences(inline, best, {each.name for each in in_displays})
    return Ingested(
        text,
        macros,
        best.guesser.knowing(best.guesser.guesses | more).guesses,
        made,
        _each_once([*in_displays, *in_sentences, *_magnitudes(made, best.guesser)]),
        list(dict.fromkeys(questions)),
        accepted,
        fences,
    )


@dataclass
class _Reading:
    """What is read with some proposals. `blocked`: formulas with a macro that could not be expanded."""

    proposals: list[Proposal]
    steps: list[tuple[Display, Step]]
    formulas: list[str]
    blocked: set[int]
    start: Guesser

    @staticmethod
    def of(steps: list[tuple[Display, Step]], proposals: list[Proposal], guesser: Guesser) -> _Reading:
        formulas = [step.spelled()[0] for _, step in steps]
        blocked = {place for place, (display, _) in enumerate(steps) if _opaque(display, formulas[place])}
        return _Reading(proposals, steps, formulas, blocked, guesser)

    @cached_property
    def readable(self) -> list[str]:
        return [latex for place, latex in enumerate(self.formulas) if place not in self.blocked]

    @cached_property
    def outcomes(self) -> list[Outcome]:
        return self.guesser.read_all(self.readable)

    @cached_property
    def guesser(self) -> Guesser:
        """It knows all symbols by the time that all is read."""
        self.start.read_all(self.readable)
        return self.start

    def tried(self, text: Text, proposal: Proposal, known: Mapping[str, Guess]) -> _Reading:
        """With the proposal, if formulas come further with it and none is lost; one that others stand on may
        do nothing yet. `known`: what else is guessed by then."""
        concerned = [place for place, latex in enumerate(self.readable) if proposal.trigger.search(latex)]
        proposals = [*self.proposals, proposal]
        if not concerned:
            return self
        try:
            guesser = Guesser(self.start.prose, ground_of(proposals))
        except PaperError:
            return self
        words = words_of(proposals)
        if words == words_of(self.proposals):
            new = replace(self, proposals=proposals, start=guesser)
        else:
            new = _Reading.of(_steps(text, words), proposals, guesser)
        before, now = (
            [
                outcome.progress
                for outcome in each.start.knowing(known).read_all([each.readable[i] for i in concerned])
            ]
            for each in (self, new)
        )
        lost = any(one[0] > other[0] for one, other in zip(before, now, strict=True))
        is_read = sum(each[0] for each in now) > sum(each[0] for each in before)
        if lost or not (proposal.stands or (is_read if proposal.reads else before != now)):
            return self
        new.start = guesser.knowing(known)
        return new

    def made(self) -> list[Formula]:
        outcomes = iter(self.outcomes)
        return [
            Formula(display, latex, _blocked(display, latex) if place in self.blocked else next(outcomes))
            for place, ((display, _), latex) in enumerate(zip(self.steps, self.formulas, strict=True))
        ]


def _steps(text: Text, words: frozenset[str]) -> list[tuple[Display, Step]]:
    return [
        (display, step) for display in text.displays for line in steps_of(display, words) for step in line
    ]


def _opaque(display: Display, latex: str) -> list[str]:
    return [name for name in sorted(display.opaque) if re.search(rf"\\{re.escape(name)}(?![A-Za-z])", latex)]


def _blocked(display: Display, latex: str) -> Outcome:
    names = ", ".join(f"\\{name}" for name in _opaque(display, latex))
    return Outcome(message=f"the macro {names} could not be expanded")


def _each_once(proposed: Iterable[Proposed]) -> list[Proposed]:
    """Of each symbol what is proposed first."""
    first: dict[str, Proposed] = {}
    for each in proposed:
        first.setdefault(each.name, each)
    return list(first.values())


def _in_sentences(
    inline: list[Display], reading: _Reading, defined: Container[str]
) -> tuple[list[Proposed], dict[str, Guess]]:
    """What a sentence says of a symbol of the displays, "where $L = J \\omega$", and guesses of what it says
    that with."""
    guesser = reading.guesser.knowing(reading.guesser.guesses)
    shown = set().union(*(outcome.symbols for outcome in reading.outcomes))
    found: list[Proposed] = []
    guesses: dict[str, Guess] = {}
    for display in inline:
        if display.latex.count("=") == 1 and not _opaque(display, display.latex):
            (outcome,) = guesser.read_all([display.latex])
            for each in _definitions([Formula(display, display.latex, outcome)]):
                if each.name in shown and each.name not in defined:
                    found.append(replace(each, why="a sentence says so", sure=False))
                    guesses |= {name: guesser.guesses[name] for name in outcome.symbols}
    return found, guesses


def _magnitudes(formulas: list[Formula], guesser: Guesser) -> Iterator[Proposed]:
    """ω as ‖𝛚‖, where both occur."""
    for name, guess in guesser.guesses.items():
        vector = guesser.vector_of(name) if guess.kind == "scalar" else None
        users = [each.display.line for each in formulas if name in each.outcome.symbols]
        if vector is not None and users:
            yield Proposed(name, rf"\|{vector}\|", users[0], f"{vector} has the same letter", False)


def _definitions(formulas: list[Formula]) -> list[Proposed]:
    """Symbols alone on the left where they first occur, or written := ."""
    found: dict[str, Proposed] = {}
    seen: set[str] = set()
    for formula in formulas:
        statements = [each for each in formula.outcome.statements or () if isinstance(each, Relation)]
        terms = (term for each in statements for term in terms_of(each))
        used = {str(term.declaration.name) for term in terms if isinstance(term, Symbol)}
        new = used - seen
        seen |= used
        words = _DEFINES.search(formula.display.before)
        for said in statements:
            if (spin := _spin(said)) is not None:
                why = "what the rate of a rotation says"
                found.setdefault(spin[0], Proposed(*spin, formula.display.line, why, False))
                continue
            name, sure = _lone_left(said), ":=" in formula.latex and len(statements) == 1
            if name is None or name in found or stated(said) is None or not (sure or name in new):
                continue
            _, sign, written = re.split("(:=|=|$)", formula.latex, maxsplit=1)
            is_written = bool(sign) and len(statements) == 1
            body = written.strip() if is_written else to_latex(said.right)
            why = (
                f'the text says "{words[0]}" before it' if words else "alone on the left where it comes first"
            )
            found[name] = Proposed(name, body, formula.display.line, "written :=" if sure else why, sure)
    return list(found.values())


def _lone_left(statement: Statement) -> str | None:
    match statement:
        case Relation(left=Symbol(declaration=declaration, index=(), arguments=())):
            return str(declaration.name)
    return None


def _spin(said: Relation) -> tuple[str, str] | None:
    """ω, and vect(Ṙ Rᵀ) or vect(Rᵀ Ṙ), of Ṙ = ω̃ R and Ṙ = R ω̃."""
    match said:
        case Relation(
            left=Derivative(body=Symbol(declaration=turning), order=order),
            right=Apply(head="mul", arguments=(one, other)),
        ) if turning.rotation and order == Linear(1):
            name = str(turning.name)
        case _:
            return None
    match one, other:
        case Apply(head="skew", arguments=(Symbol() as spin,)), Symbol(declaration=turned) if (
            turned == turning
        ):
            return str(spin.declaration.name), rf"\operatorname{{vect}}(\dot{{{name}}} {name}^T)"
        case Symbol(declaration=turned), Apply(head="skew", arguments=(Symbol() as spin,)) if (
            turned == turning
        ):
            return str(spin.declaration.name), rf"\operatorname{{vect}}({name}^T \dot{{{name}}})"
    return None
