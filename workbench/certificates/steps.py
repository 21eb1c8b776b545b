"""The exact steps of theorem claims: each equation that a goal's proof asks for, as a theorem of its own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from workbench.certificates import coqc
from workbench.certificates.families import general
from workbench.certificates.forms import Certificate
from workbench.certificates.nodes import NotCertified
from workbench.certificates.theorem import theorem
from workbench.judge.theorems.goals import Atom, Scope
from workbench.judge.theorems.proofs import Proven
from workbench.judge.theorems.rules import obligations
from workbench.judge.theorems.sequents import Obligation, Premise, Sequent
from workbench.judge.verdict import Outcome
from workbench.language.terms import IllFormed
from workbench.papers.model import Claim
from workbench.verify.results import Certification, ClaimResult


@dataclass(frozen=True)
class Step:
    """One equation: its certificate, or the first obstacle to one."""

    certificate: Certificate | None
    obstacle: str = ""
    misread: str = ""

    @property
    def checked(self) -> coqc.Checked | None:
        """What Coq is remembered to have said."""
        return coqc.recall(self.certificate.text) if self.certificate else None


@dataclass(frozen=True)
class Steps:
    """The steps of one theorem claim. The rules that join them are the judge's."""

    claim: Claim
    steps: tuple[Step, ...]

    @property
    def texts(self) -> list[str]:
        return [step.certificate.text for step in self.steps if step.certificate]

    @property
    def certified(self) -> list[Step]:
        accepted = (step for step in self.steps if (said := step.checked) is not None and said.expected)
        return [step for step in accepted if not step.misread]

    @property
    def broken(self) -> bool:
        """Coq refuses one of them, or one does not say what its terms say."""
        if any(step.misread for step in self.steps):
            return True
        said = [step.checked for step in self.steps]
        return any(s is not None and not s.expected for s in said)

    @property
    def word(self) -> str:
        """Such as: steps certified, 3 of 4; not certified: a norm."""
        obstacle = next((f"; not certified: {step.obstacle}" for step in self.steps if step.obstacle), "")
        return f"steps certified, {len(self.certified)} of {len(self.steps)}{obstacle}"

    @property
    def certification(self) -> Certification:
        """As a result tells it, beside the forms'."""
        done = self.certified
        axioms = {name for step in done for name in step.checked.axioms}
        return Certification(
            form="steps",
            checked_by=f"Coq {coqc.version()}" if len(done) == len(self.steps) else None,
            axioms=tuple(sorted(axioms)),
            scope=None,
            statement="\n\n".join(t.statement for step in done for t in step.certificate.theorems) or None,
            premises_met=None,
            obstacle=next((step.obstacle for step in self.steps if step.obstacle), None),
            word=self.word,
        )


def steps_of(result: ClaimResult, theorems: Mapping[str, object]) -> Steps | None:
    """None if the claim is not proved from a goal."""
    claim = result.claim
    proven = theorems.get(claim.theorem or "")
    if result.verdict.outcome != Outcome.PROVED or claim.goal is None or not isinstance(proven, Proven):
        return None
    if proven.proof is None:
        return None
    notation = claim.notation
    given = tuple(Premise(Atom(statement), False) for statement in claim.supposed)
    sequent = Sequent(claim.goal.goal, Scope(notation.symbols, notation.definitions, {}), given)
    asked = [o for o in obligations(sequent, proven.proof) if not o.is_trivial]
    return Steps(claim, tuple(_step(claim, o, i + 1) for i, o in enumerate(asked))) if asked else None


def all_steps(results: Sequence[ClaimResult], theorems: Mapping[str, object]) -> list[Steps]:
    return [steps for result in results if (steps := steps_of(result, theorems)) is not None]


def _step(claim: Claim, obligation: Obligation, number: int) -> Step:
    name = f"step_{number}"
    definitions = obligation.scope.definitions
    try:
        statement, supposed, integers = obligation.statement, list(obligation.assume), []
        if obligation.scope.integers:
            try:
                statement, supposed, integers = general(statement, supposed, definitions)
            except NotCertified as obstacle:
                if str(obstacle) != "no integer variable":
                    raise
        made = theorem(name, statement, supposed, definitions, integers)
    except (NotCertified, IllFormed) as obstacle:
        return Step(None, str(obstacle))
    written = Certificate(None, (made,), title=f"{claim.id}, {obligation.rule}")
    return Step(written, misread=written.misread)
