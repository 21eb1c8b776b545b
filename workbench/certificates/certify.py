"""The certificates of a paper: written, checked, and summarized for the report."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from workbench.certificates import coqc
from workbench.certificates.certified_forms import Certificate, Form, certificate, forms_of
from workbench.certificates.emission.emitted_nodes import NotCertified, OneInstant
from workbench.certificates.goals.goal_theorem import of_one_instant
from workbench.certificates.handwritten import by_hand
from workbench.certificates.refutation import not_empty, refutation
from workbench.certificates.steps import all_steps
from workbench.core.verdict import Outcome, Verdict
from workbench.language.printing.author_spelling import printed_for
from workbench.papers import Paper
from workbench.prover.results.claim_results import Certification, ClaimResult


@dataclass(frozen=True)
class Certified:
    """One exact form with its certificate, or the first obstacle to one, and Coq's answer if it was asked.

    `statement` and `text` are the theorem and its file; `check` asks Coq.

    Attributes:
        outcome: The verdict on the form, which a certificate never changes.
        gap: Why no motion is known that meets the premises.
        met: Coq's answer on the motion that meets the premises.
        misread: The differences between the text and its terms.
    """

    form: Form
    outcome: Outcome
    certificate: Certificate | None
    obstacle: str = ""
    checked: coqc.Checked | None = None
    gap: str = ""
    met: coqc.Checked | None = None
    misread: str = ""

    @property
    def statement(self) -> str:
        """The statement of the theorem, in Coq's language; empty if there is none (`obstacle` says why)."""
        return self.certificate.statement if self.certificate else ""

    @property
    def text(self) -> str:
        """The file for Coq: the statement and its proof; empty if there is none."""
        return self.certificate.text if self.certificate else ""

    def check(self, text: str | None = None) -> coqc.Checked:
        """Returns Coq's answer on the text: whether it is `accepted`, its `axioms`, and the `fault` found.

        The first answer takes half a minute longer, for Coq then compiles the library.

        Args:
            text: Another text that uses the same library, such as a changed or a handwritten one.

        Raises:
            CoqFault: The library does not compile, or the text has no theorem.
        """
        asked = self.text if text is None else text
        if coqc.version() is None:
            return coqc.Checked(False, (), f"there is no coqc here; get it by {coqc.INSTALL}", 0.0)
        return coqc.check(asked if "Print Assumptions" in asked else coqc.with_assumptions(asked))

    @property
    def texts(self) -> list[str]:
        """The texts for Coq to check."""
        made = self.certificate
        return [c.text for c in (made, made.motions) if c] if made else []

    @property
    def certified(self) -> bool:
        """True if Coq accepts the certificate, and that its premises can be met, if it has any."""
        if self.certificate is None or self.checked is None or self.gap or self.misread:
            return False
        met = self.certificate.motions is None or (self.met is not None and self.met.expected)
        return self.checked.expected and met

    @property
    def seconds(self) -> float:
        return sum(said.seconds for said in (self.checked, self.met) if said)

    @property
    def broken(self) -> bool:
        """True if Coq rejects the certificate, it depends on unexpected axioms, or its text differs from its
        terms.

        Each of these is a defect of the workbench.
        """
        if self.misread:
            return True
        refused = [said for said in (self.checked, self.met) if said is not None and not said.expected]
        return any(self.outcome == Outcome.PROVED or not said.unfinished for said in refused)

    @property
    def word(self) -> str:
        """The state of the certificate in words, for tables."""
        if self.certificate is None:
            return f"not certified: {self.obstacle}"
        if self.misread:
            return f"NOT WHAT ITS TERMS SAY: {self.misread}"
        if self.checked is None:
            return "written"
        if self.checked.unfinished:
            return f"not certified: {self.checked.fault}"
        if not self.checked.accepted:
            return f"REFUSED BY COQ: {self.checked.fault}"
        if self.gap:
            return f"not certified: {self.gap}"
        if self.met is not None and not self.met.expected:
            return f"REFUSED BY COQ, a motion that meets the premises: {self.met.fault}"
        rest = "axioms of the real numbers" if self.checked.axioms else "no axioms"
        return f"certified: Coq {coqc.version()}, {rest}"

    @property
    def certification(self) -> Certification:
        """The certificate as part of a result."""
        said = self.checked if self.certified else None
        motions = self.certificate.motions if self.certificate else None
        return Certification(
            form=self.form.name,
            checked_by=f"Coq {coqc.version()}" if said else None,
            axioms=tuple(said.axioms) if said else (),
            scope=self.certificate.scope if self.certificate else None,
            statement=self.certificate.statement if self.certificate else None,
            premises_met=motions.statement if motions else None,
            obstacle=self.obstacle or None,
            word=self.word,
        )


def exact_forms(results: Sequence[ClaimResult]) -> Iterator[tuple[Form, ClaimResult, Verdict]]:
    """Yields the forms that are proved or refuted by their own exact verdict."""
    for result in results:
        for form in forms_of(result.claim):
            verdict = result.verdicts.get(form.name)
            if verdict is not None and verdict.outcome in (Outcome.PROVED, Outcome.REFUTED):
                yield form, result, verdict


def written(form: Form, verdict: Verdict) -> Certified:
    """Returns the certificate of a form, not yet checked."""
    try:
        if verdict.outcome == Outcome.REFUTED:
            with printed_for(
                form.claim.notation.author_notation
            ):  # the counterexample spells symbols that way
                made = refutation(form, verdict)
            return Certified(form, verdict.outcome, made, misread=made.misread)
        made = certificate(form, every=verdict.scope is not None and verdict.is_for_all)
    except OneInstant as obstacle:
        try:
            made = of_one_instant(form)
            misread = made.misread or (made.motions.misread if made.motions else "")
            return Certified(form, verdict.outcome, made, misread=misread)
        except NotCertified:
            return Certified(form, verdict.outcome, None, str(obstacle))
    except NotCertified as obstacle:
        return Certified(form, verdict.outcome, None, str(obstacle))
    try:
        whole = replace(made, motions=not_empty(made))
        return Certified(form, verdict.outcome, whole, misread=made.misread)
    except NotCertified as gap:
        return Certified(form, verdict.outcome, made, gap=str(gap), misread=made.misread)


def recalled(each: Certified) -> Certified:
    """Returns the form with Coq's cached answers."""
    if each.certificate is None:
        return each
    motions = each.certificate.motions
    met = coqc.recall(motions.text) if motions else None
    return replace(each, checked=coqc.recall(each.certificate.text), met=met)


def with_certificates(results: Sequence[ClaimResult], paper: Paper) -> list[ClaimResult]:
    """Returns the results with the cached certifications of their exact forms, theorem steps and handwritten
    theorems."""
    found: dict[str, list[Certification]] = {}
    for form, result, verdict in exact_forms(results):
        each = recalled(written(form, verdict))
        found.setdefault(result.claim.id, []).append(each.certification)
    for steps in all_steps(results, paper.theorems):
        found.setdefault(steps.claim.id, []).append(steps.certification)
    for file in by_hand(paper):
        for claim, certification in file.certifications:
            found.setdefault(claim, []).append(certification)
    return [replace(result, certificates=tuple(found.get(result.claim.id, ()))) for result in results]
