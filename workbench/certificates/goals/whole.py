"""A goal and its proof as one theorem of Coq."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from workbench.certificates.forms import Certificate
from workbench.certificates.goals.joins import Joiner
from workbench.certificates.goals.lemmas import at_an_instant
from workbench.certificates.goals.places import Place
from workbench.certificates.goals.propositions import Speaker, said
from workbench.certificates.goals.propositions_read import faults
from workbench.certificates.meaning import OfTerm, OfText
from workbench.certificates.nodes import NotCertified
from workbench.certificates.theorem import HEADER, Theorem, binder_faults, differs, premise_faults
from workbench.judge.theorems.goals import (
    Goal,
    GoalError,
    Scope,
    atoms,
)
from workbench.judge.theorems.members import bound_names
from workbench.judge.theorems.proofs import Proof
from workbench.judge.theorems.sequents import NotShown, names_of, relations_of
from workbench.language.errors import IllFormedAt, ReadError
from workbench.language.terms import IllFormed, Symbol, Term
from workbench.papers.model import Claim

OF_MOMENTS = HEADER.replace(
    "Open Scope Q_scope.", "From Kin Require Import Smooth Moment.\nOpen Scope Q_scope.", 1
)


@dataclass
class Whole:
    """The theorem that says the goal, after the lemmas that are the steps of its proof."""

    name: str
    goal: Goal
    scope: Scope
    speaker: Speaker
    proposition: str
    lemmas: Sequence[Theorem]
    lines: Sequence[str]
    top: Sequence[str]
    at_instant: frozenset[str]
    names: Mapping[str, Term]

    @property
    def statement(self) -> str:
        binders = "".join(f" ({name} : {type_})" for name, type_ in self.speaker.binders)
        return "\n  ".join(
            [f"Theorem {self.name} (now : instant){binders} :", *self.top, f"{self.proposition}."]
        )

    @property
    def proof(self) -> str:
        introduced = self.speaker.introduced
        start = [f"intros {' '.join(introduced)}."] if introduced else []
        return "\n  ".join(["Proof.", *start, *self.lines]) + "\nQed."

    @property
    def text(self) -> str:
        lemmas = "".join(
            lemma.text + (at_an_instant(lemma) if lemma.name in self.at_instant else "")
            for lemma in self.lemmas
        )
        return f"{lemmas}Notation K := smooth_functions.\n{self.statement}\n{self.proof}\n"

    def read_back_faults(self) -> list[str]:
        """Where the text, read again, does not say what the goal says, or is not the text again."""
        speaker = self.speaker
        of_term = OfTerm(speaker.definitions)
        found = [fault for line in self.top for fault in self._line(line, of_term)]
        found += binder_faults(speaker, self.names)
        return found + faults(self.proposition, self.goal, of_term, self.names)

    def _line(self, line: str, of_term: OfTerm) -> list[str]:
        """A definition, or that cosine and sine are those of an angle."""
        if line.startswith("let "):
            name, text = line.removeprefix("let ").removesuffix(" in").split(" := ", 1)
            body = self.speaker.definitions.lookup(self.names[name])
            return differs(name, text, OfText(self.names, of_term), of_term(body))
        return premise_faults(line.removesuffix(" ->"), OfText(self.names, of_term), ())


def whole(claim: Claim, scope: Scope, proof: Proof) -> Certificate:
    """Raises NotCertified with the first obstacle."""
    goal = claim.goal.goal
    name = "claim_" + re.sub(r"\W+", "_", claim.id).strip("_")
    if claim.supposed:
        raise NotCertified("a goal under suppositions of its claim")
    speaker = Speaker(scope.definitions)
    try:
        _speak_of_what_is_free(speaker, goal, scope)
        top = list(speaker.statement)
        proposition = said(speaker, goal)
        names = dict(speaker.read_back)
        introduced = list(speaker.introduced)
        joiner = Joiner(speaker)
        joiner.show(Place(goal, scope), proof)
    except (NotShown, GoalError, ReadError, IllFormedAt, IllFormed) as error:
        raise NotCertified(str(error)) from None
    speaker.introduced = introduced
    made = Whole(
        name,
        goal,
        scope,
        speaker,
        proposition,
        joiner.lemmas,
        joiner.lines,
        top,
        frozenset(joiner.at_instant),
        names,
    )
    return Certificate(None, (made,), header=OF_MOMENTS, title=f"{claim.id}, the goal")


def _speak_of_what_is_free(speaker: Speaker, goal: Goal, scope: Scope) -> None:
    """Symbols of the paper, and what is defined of them, before the goal."""
    bound = set(bound_names(goal))
    for statement in atoms(goal):
        for one in relations_of(statement):
            for side in (one.left, one.right):
                for part in side.walk():
                    if (
                        isinstance(part, Symbol)
                        and part.declaration.name not in bound
                        and not names_of(part, scope) & bound
                    ):
                        speaker.symbol(part)
                    elif getattr(part, "head", "") in ("cos", "sin") and not names_of(part, scope) & bound:
                        speaker.term(part)
    for text, name in [(t, n) for n, t in speaker.binders]:
        speaker.known[text] = name
