"""Certificates of theorem claims: one theorem if the proof can be joined in Coq, else one per equation."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from workbench.certificates import coqc
from workbench.certificates.certified_forms import Certificate
from workbench.certificates.emission.emitted_nodes import NotCertified
from workbench.certificates.generalized import Generalizer
from workbench.certificates.goals.goal_theorem import whole
from workbench.certificates.theorem import theorem_for_all
from workbench.certificates.values.trial import can_be_certified, holds_whatever_they_are
from workbench.context.claims import Claim
from workbench.core.terms import IllFormed
from workbench.core.verdict import Outcome
from workbench.language.goals.goals import Atom, Scope
from workbench.language.goals.proofs import Proof, Proven
from workbench.prover.goals.proof_rules import obligations
from workbench.prover.goals.sequents import Obligation, Premise, Sequent
from workbench.prover.results.claim_results import Certification, ClaimResult


@dataclass(frozen=True)
class Step:
    """One equation of a proof: its certificate, or the first obstacle to one."""

    certificate: Certificate | None
    obstacle: str = ""
    misread: str = ""

    @property
    def checked(self) -> coqc.Checked | None:
        """Coq's cached answer."""
        return coqc.recall(self.certificate.text) if self.certificate else None

    @property
    def certified(self) -> bool:
        said = self.checked
        return said is not None and said.expected and not self.misread


@dataclass(frozen=True)
class Steps:
    """The steps of one theorem claim.

    Attributes:
        whole: The theorem of the goal, or why there is none. Its lemmas are the steps; without it, the steps
            are joined by the rules of the prover only.
    """

    claim: Claim
    steps: tuple[Step, ...]
    whole: Step

    @property
    def asked(self) -> tuple[Step, ...]:
        """The certificates for Coq to check."""
        return (self.whole,) if self.whole.certificate else self.steps

    @property
    def texts(self) -> list[str]:
        return [step.certificate.text for step in self.asked if step.certificate]

    @property
    def is_one_theorem(self) -> bool:
        return self.whole.certified

    @property
    def certified(self) -> list[Step]:
        return list(self.steps) if self.is_one_theorem else [step for step in self.steps if step.certified]

    @property
    def broken(self) -> bool:
        """True if Coq rejects one of them, or the text of one differs from its terms."""
        said = [(step.misread, step.checked) for step in self.asked]
        return any(misread or (s is not None and not s.expected and not s.unfinished) for misread, s in said)

    @property
    def word(self) -> str:
        """A summary such as: steps certified, 3 of 4; not certified: a norm."""
        count = f"steps certified, {len(self.certified)} of {len(self.steps)}"
        if self.is_one_theorem:
            return f"{count}; joined to one theorem"
        obstacle = next((f"; not certified: {step.obstacle}" for step in self.steps if step.obstacle), "")
        refused = self.whole.checked.fault if self.whole.checked else ""
        return f"{count}{obstacle or f'; not joined: {self.whole.obstacle or refused}'}"

    @property
    def certification(self) -> Certification:
        """The certificate as part of a result, in addition to those of the forms."""
        done = [step for step in self.asked if step.certified]
        axioms = {name for step in done if step.checked for name in step.checked.axioms}
        return Certification(
            form="goal" if self.is_one_theorem else "steps",
            checked_by=f"Coq {coqc.version()}" if len(self.certified) == len(self.steps) else None,
            axioms=tuple(sorted(axioms)),
            scope=None,
            statement="\n\n".join(step.certificate.statement for step in done if step.certificate) or None,
            premises_met=None,
            obstacle=next((step.obstacle for step in self.asked if step.obstacle), None),
            word=self.word,
        )


def steps_of(result: ClaimResult, theorems: Mapping[str, object]) -> Steps | None:
    """Returns the steps of a claim; None if the claim is not proved from a goal."""
    claim = result.claim
    proven = theorems.get(claim.proof.theorem or "")
    if result.verdict.outcome != Outcome.PROVED or claim.proof.goal is None or not isinstance(proven, Proven):
        return None
    if proven.proof is None:
        return None
    notation = claim.notation
    given = tuple(Premise(Atom(statement), False) for statement in claim.supposed)
    sequent = Sequent(claim.proof.goal.goal, Scope(notation.symbols, notation.definitions, {}), given)
    asked = [o for o in obligations(sequent, proven.proof) if not o.is_trivial]
    if not asked:
        return None
    return Steps(
        claim,
        tuple(_step(claim, o, i + 1) for i, o in enumerate(asked)),
        _whole(claim, sequent.scope, proven.proof),
    )


def _whole(claim: Claim, scope: Scope, proof: Proof) -> Step:
    try:
        made = whole(claim, scope, proof)
        return Step(made, misread=made.misread)
    except NotCertified as obstacle:
        return Step(None, str(obstacle))


def all_steps(results: Sequence[ClaimResult], theorems: Mapping[str, object]) -> list[Steps]:
    return [steps for result in results if (steps := steps_of(result, theorems)) is not None]


def _step(claim: Claim, obligation: Obligation, number: int) -> Step:
    scope, title = obligation.scope, f"{claim.id}, {obligation.rule}"
    try:
        made = theorem_for_all(f"step_{number}", obligation.statement, obligation.assume, scope)
        if not can_be_certified(made):
            raise NotCertified("a sum, or a derivative of order n, of which the library knows too little")
    except (NotCertified, IllFormed) as obstacle:
        try:
            general_ = Generalizer(scope.definitions, scope.integers)
            equation = general_.equation(obligation.statement)
            made = theorem_for_all(f"step_{number}", equation, general_.premises, scope)
        except (NotCertified, IllFormed):
            return Step(None, str(obstacle))
        if not holds_whatever_they_are(made):
            return Step(None, str(obstacle))
        title = "; ".join([title, *general_.said])
    written = Certificate(None, (made,), title=title)
    return Step(written, misread=written.misread)
