"""A goal and its proof as one Coq theorem."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

from workbench.certificates.certified_forms import Certificate, Form
from workbench.certificates.emission.emitted_nodes import ATOM, NotCertified
from workbench.certificates.goals.lemmas import at_an_instant
from workbench.certificates.goals.proof_positions import Place
from workbench.certificates.goals.propositions import Speaker, families_in, said, speak_of_what_is_free
from workbench.certificates.goals.propositions_read import faults
from workbench.certificates.goals.tactics import Joiner
from workbench.certificates.reading.compare import binder_faults, line_faults
from workbench.certificates.reading.meaning import OfTerm, OfText
from workbench.certificates.theorem import HEADER, Theorem, relations
from workbench.context.claims import Claim
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.integer_instances import instantiate
from workbench.core.terms import IllFormed, Relation, Symbol, Term
from workbench.language.goals.goals import Atom, Exists, Goal, GoalError, Implies, Scope, Variable
from workbench.language.goals.proofs import Kernel, Proof
from workbench.prover.goals.sequents import NotShown

OF_MOMENTS = HEADER.replace(
    "Open Scope Q_scope.", "From Kin Require Import Smooth Moment.\nOpen Scope Q_scope.", 1
)


@dataclass
class Whole:
    """The theorem of a goal, after the lemmas of its proof."""

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
    prefix: str = ""  # prefix of the names of lemmas, if a file has several theorems

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
        own = f"Notation K := smooth_functions.\n{self.statement}\n{self.proof}\n"
        if not self.prefix:
            return lemmas + own
        section = f"Section {self.prefix}.\n{own}End {self.prefix}.\n"
        return re.sub(r"\bstep_(?=\d)", f"{self.prefix}_step_", lemmas + section)

    def read_back_faults(self) -> list[str]:
        """Returns where the text, read back, differs from the goal, or does not reproduce the text."""
        speaker, of_term = self.speaker, OfTerm(self.speaker.definitions)
        of_text = OfText(self.names, of_term, speaker.families)
        found = [fault for line in self.top for fault in line_faults(speaker, line, of_text, ())]
        found += binder_faults(speaker, self.names)
        alone = [d.declaration for d in speaker.definitions if d.index and d.index[0].is_number]
        found += [
            f"{n}: a member is defined apart" for d, n in speaker.families.items() if alone.count(d) > 1
        ]
        return found + faults(self.proposition, self.goal, of_term, self.names, speaker.families)


def whole(claim: Claim, scope: Scope, proof: Proof) -> Certificate:
    """Returns the certificate of a goal. Raises NotCertified with the first obstacle."""
    if claim.proof.goal is None:
        raise NotCertified("a claim without a goal")
    if claim.supposed:
        raise NotCertified("a goal under suppositions of its claim")
    name = "claim_" + re.sub(r"\W+", "_", claim.id).strip("_")
    made = joined(name, claim.proof.goal.goal, scope, proof)
    return Certificate(None, (made,), header=OF_MOMENTS, title=f"{claim.id}, the goal")


def of_one_instant(form: Form) -> Certificate:
    """Returns the certificate of a form whose premises give values of free symbols at one instant.

    That these symbols may have any values is the theorem that the premises can be met.
    """
    claim, notation = form.claim, form.claim.notation
    scope, theorems = Scope(notation.symbols, notation.definitions, {}), []
    chosen: dict[Relation, Whole] = {}
    for values in claim.instances:
        name = form.identifier + "".join(f"_{n}{value}" for n, value in values.items())
        supposed = [one for s in claim.supposed for one in relations(instantiate(s, values))]
        chosen |= {one: _chosen(one, scope) for one in supposed}
        goal = Implies(Atom(supposed[0]), Atom(instantiate(form.statement, values)))
        theorems.append(replace(joined(name, goal, scope, Kernel()), prefix=f"in_{name}"))
    if len(chosen) > 1:
        raise NotCertified("several premises at one instant")
    motions = Certificate(None, tuple(chosen.values()), header=OF_MOMENTS, title="premises are met")
    return Certificate(form, tuple(theorems), str(claim.orders), OF_MOMENTS, motions)


def _chosen(one: Relation, scope: Scope) -> Whole:
    """Returns the theorem that a free symbol can have this value at any instant."""
    if not isinstance(one.left, Symbol) or one.operator != "=":
        raise NotCertified("premises at one instant that do not say what a free symbol is")
    own = one.left.declaration
    if own.rotation or own.unit or scope.definitions.lookup(one.left):
        raise NotCertified("premises at one instant that do not say what a free symbol is")
    goal, speaker = Exists((Variable(own),), Atom(one), False), Speaker(scope.definitions)
    proposition, value = said(speaker, goal), speaker.term(one.right).at(ATOM)
    if speaker.binders or own.constant:
        raise NotCertified("premises at one instant on several symbols, or on constants")
    lines = [f"exists {value}.", "exact (same_at now _)."]
    return Whole("chosen", goal, scope, speaker, proposition, (), lines, (), frozenset(), {})


def joined(name: str, goal: Goal, scope: Scope, proof: Proof) -> Whole:
    try:
        return _joined(name, goal, scope, proof, False)
    except NotCertified:
        if families_in(goal):
            with suppress(NotCertified):  # the proof can be about every member of a family
                return _joined(name, goal, scope, proof, True)
        raise


def _joined(name: str, goal: Goal, scope: Scope, proof: Proof, by_families: bool) -> Whole:
    speaker = Speaker(scope.definitions)
    try:
        speak_of_what_is_free(speaker, goal, scope, by_families)
        speaker.known |= {text: name for name, text in speaker.binders}
        top = list(speaker.statement)
        proposition = said(speaker, goal)
        names = {name: term for name, term in speaker.read_back.items() if " " not in name}
        introduced = list(speaker.introduced)
        joiner = Joiner(speaker)
        joiner.show(Place(goal, scope), proof)
    except (NotShown, GoalError, ReadError, IllFormedAt, IllFormed) as error:
        raise NotCertified(str(error)) from None
    speaker.introduced = introduced
    at_instant = frozenset(joiner.at_instant)
    return Whole(name, goal, scope, speaker, proposition, joiner.lemmas, joiner.lines, top, at_instant, names)
