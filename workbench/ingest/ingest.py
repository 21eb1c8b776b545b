"""Reads a text, guesses what its symbols are, and says what it could and could not read."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from workbench.ingest.features import feature_of
from workbench.ingest.kinds import Guess, Guesser, Outcome
from workbench.ingest.questions import questions_of
from workbench.language.definitions import Definitions
from workbench.language.terms import Relation, Statement, Symbol
from workbench.papers.model import PaperError
from workbench.papers.steps import Step, steps_of
from workbench.papers.text_paper import stated
from workbench.papers.texts import Display, Text, read_text

_DEFINES = re.compile(r"\b(?:defined?|denote[ds]?|where|let|set|introduce|is called)\b", re.IGNORECASE)


@dataclass(frozen=True)
class Formula:
    """One step of a display, and what came of reading it."""

    display: Display
    step: Step
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
    if not text.displays:
        raise PaperError(path, None, None, "no displayed equation in it")
    steps = [(display, step) for display in text.displays for line in steps_of(display) for step in line]
    formulas = [step.spelled()[0] for _, step in steps]
    guesser = Guesser("\n".join(source.text for source in text.sources[:1]))
    blocked = {place for place, (display, _) in enumerate(steps) if _opaque(display, formulas[place])}
    readable = [latex for place, latex in enumerate(formulas) if place not in blocked]
    guesser.improve(readable, guesser.read_all(readable))
    outcomes = iter(guesser.read_all(readable))
    made = [
        Formula(display, step, latex, _blocked(display, latex) if place in blocked else next(outcomes))
        for place, ((display, step), latex) in enumerate(zip(steps, formulas, strict=True))
    ]
    questions = questions_of(text, formulas, guesser.guesses)
    return Ingested(text, macros, guesser.guesses, made, _definitions(made), questions)


def _opaque(display: Display, latex: str) -> list[str]:
    return [name for name in sorted(display.opaque) if re.search(rf"\\{re.escape(name)}(?![A-Za-z])", latex)]


def _blocked(display: Display, latex: str) -> Outcome:
    names = ", ".join(f"\\{name}" for name in _opaque(display, latex))
    return Outcome(message=f"the macro {names} could not be expanded")


def _definitions(formulas: list[Formula]) -> list[Proposed]:
    """Symbols alone on the left where they first occur, and where the text says so or writes := ."""
    found: dict[str, Proposed] = {}
    seen: set[str] = set()
    for formula in formulas:
        new = formula.outcome.symbols - seen
        seen |= formula.outcome.symbols
        statements = formula.outcome.statements or ()
        if len(statements) != 1 or not isinstance(statements[0], Relation):
            continue
        name = _lone_left(statements[0])
        if name is None or name in found or stated(statements[0], Definitions()) is None:
            continue
        sure = ":=" in formula.latex
        words = _DEFINES.search(formula.display.before)
        if sure or (words and name in new):
            body = re.split(r":=|=", formula.latex, maxsplit=1)[1].strip()
            why = "written :=" if sure else f'the text says "{words[0]}" before it'
            found[name] = Proposed(name, body, formula.display.line, why, sure)
    return list(found.values())


def _lone_left(statement: Statement) -> str | None:
    left = statement.left if isinstance(statement, Relation) else None
    is_plain = isinstance(left, Symbol) and not left.index and not left.arguments
    return left.declaration.name if is_plain else None
