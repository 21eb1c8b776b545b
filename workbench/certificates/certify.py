"""The certificates of a paper: written, checked, and what the report says of them."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

from workbench.certificates import coqc
from workbench.certificates.forms import Certificate, Form, certificate, forms_of
from workbench.certificates.nodes import NotCertified
from workbench.certificates.refutation import not_empty, refutation
from workbench.certificates.steps import Steps, all_steps
from workbench.certificates.theorem import HEADER
from workbench.judge.verdict import Outcome, Verdict
from workbench.verify.results import Certification, ClaimResult


@dataclass(frozen=True)
class Certified:
    """One exact form: its certificate, or the first obstacle to one; what Coq said, if it was asked.

    `outcome`: the verdict on the form, which a certificate never changes. `gap`: why no motion is known that
    meets the premises; `met`: what Coq said of one. `misread`: what the text says otherwise than the terms.
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
    def certified(self) -> bool:
        """Coq accepts the certificate, and that its premises can be met, if it has any."""
        own = self.checked is not None and self.checked.expected and not (self.gap or self.misread)
        return own and (self.certificate.motions is None or (self.met is not None and self.met.expected))

    @property
    def seconds(self) -> float:
        return sum(said.seconds for said in (self.checked, self.met) if said)

    @property
    def broken(self) -> bool:
        """Coq refuses the certificate, it rests on axioms nobody expects, or it does not say what its terms
        say: a defect of the workbench."""
        if self.misread:
            return True
        refused = [said for said in (self.checked, self.met) if said is not None and not said.expected]
        return any(self.outcome == Outcome.PROVED or not _unfinished(said) for said in refused)

    @property
    def word(self) -> str:
        """What a table says of it."""
        if self.certificate is None:
            return f"not certified: {self.obstacle}"
        if self.misread:
            return f"NOT WHAT ITS TERMS SAY: {self.misread}"
        if self.checked is None:
            return "written"
        if _unfinished(self.checked):
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
        """As a result tells it."""
        said = self.checked if self.certified else None
        return Certification(
            form=self.form.name,
            checked_by=f"Coq {coqc.version()}" if said else None,
            axioms=tuple(said.axioms) if said else (),
            scope=self.certificate.scope if self.certificate else None,
            statement=_statements(self.certificate),
            premises_met=_statements(self.certificate.motions) if self.certificate else None,
            obstacle=self.obstacle or None,
            word=self.word,
        )


def _unfinished(said: coqc.Checked) -> bool:
    return said.fault.startswith("not finished")


def _statements(certificate: Certificate | None) -> str | None:
    return "\n\n".join(t.statement for t in certificate.theorems) if certificate else None


def exact_forms(results: Sequence[ClaimResult]) -> Iterator[tuple[Form, ClaimResult, Verdict]]:
    """The forms that are proved or refuted by their own exact verdict."""
    for result in results:
        for form in forms_of(result.claim):
            verdict = result.verdicts.get(form.name)
            if verdict is not None and verdict.outcome in (Outcome.PROVED, Outcome.REFUTED):
                yield form, result, verdict


def written(form: Form, verdict: Verdict) -> Certified:
    """The certificate of a form, not yet checked."""
    try:
        if verdict.outcome == Outcome.REFUTED:
            made = refutation(form, verdict)
            return Certified(form, verdict.outcome, made, misread=made.misread)
        made = certificate(form, every=(verdict.scope or "").startswith("all"))
    except NotCertified as obstacle:
        return Certified(form, verdict.outcome, None, str(obstacle))
    try:
        whole = replace(made, motions=not_empty(made))
        return Certified(form, verdict.outcome, whole, misread=made.misread)
    except NotCertified as gap:
        return Certified(form, verdict.outcome, made, gap=str(gap), misread=made.misread)


def checked_all(
    certificates: Sequence[Certified], progress: Callable[[object], None] = lambda done: None
) -> list[Certified]:
    """Each certificate put before Coq, on all cores."""
    texts = [
        each.certificate.text
        for each in certificates
        if each.certificate and each.certificate.header == HEADER
    ]  # what several rest on together is what each rests on only where that is nothing
    motions = [each.certificate.motions for each in certificates if each.certificate]
    _together(texts)
    _together([m.text for m in motions if m], alike=True)

    def one(each: Certified) -> Certified:
        done = _with(each, coqc.check)
        progress(done)
        return done

    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        return list(pool.map(one, certificates))


def _together(texts: Sequence[str], alike: bool = False) -> None:
    """Put before Coq in batches. What is not accepted so is then put before Coq by itself."""
    coqc.library()
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        list(pool.map(lambda batch: coqc.check_together(batch, alike), coqc.in_batches(texts)))


def check_steps(all_: Sequence[Steps], progress: Callable[[object], None] = lambda done: None) -> None:
    """The steps of all theorem claims put before Coq, on all cores; what it says is remembered."""
    certificates = [step.certificate for steps in all_ for step in steps.asked if step.certificate]
    _together([c.text for c in certificates if c.header == HEADER])

    def one(text: str) -> None:
        progress(coqc.check(text))

    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        list(pool.map(one, [text for steps in all_ for text in steps.texts]))


def _with(each: Certified, ask: Callable[[str], coqc.Checked | None]) -> Certified:
    if each.certificate is None:
        return each
    motions = each.certificate.motions
    return replace(each, checked=ask(each.certificate.text), met=ask(motions.text) if motions else None)


def with_certificates(results: Sequence[ClaimResult], theorems: Mapping[str, object]) -> list[ClaimResult]:
    """Each with what is remembered of the certificates of its exact forms and of the steps of its theorem."""
    found: dict[str, list[Certification]] = {}
    for form, result, verdict in exact_forms(results):
        each = _with(written(form, verdict), coqc.recall)
        found.setdefault(result.claim.id, []).append(each.certification)
    for steps in all_steps(results, theorems):
        found.setdefault(steps.claim.id, []).append(steps.certification)
    return [replace(result, certificates=tuple(found.get(result.claim.id, ()))) for result in results]
