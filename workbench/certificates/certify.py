"""The certificates of a paper: written, checked, and what the report says of them."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

from workbench.certificates import coqc
from workbench.certificates.forms import Certificate, Form, certificate, forms_of
from workbench.certificates.nodes import NotCertified
from workbench.certificates.refutation import refutation
from workbench.judge.verdict import Outcome, Verdict
from workbench.verify.claims import ClaimResult


@dataclass(frozen=True)
class Certified:
    """One exact form: its certificate, or the first obstacle to one; what Coq said, if it was asked.

    `outcome`: the verdict on the form, which a certificate never changes.
    """

    form: Form
    outcome: Outcome
    certificate: Certificate | None
    obstacle: str = ""
    checked: coqc.Checked | None = None

    @property
    def broken(self) -> bool:
        """Coq refuses the certificate, or it rests on axioms nobody expects: a defect of the workbench."""
        if self.checked is None or self.checked.expected:
            return False
        return self.outcome == Outcome.PROVED or not self.unfinished

    @property
    def unfinished(self) -> bool:
        return self.checked is not None and self.checked.fault.startswith("not finished")

    @property
    def word(self) -> str:
        """What a table says of it."""
        if self.certificate is None:
            return f"not certified: {self.obstacle}"
        if self.checked is None:
            return "written"
        if self.unfinished:
            return f"not certified: {self.checked.fault}"
        if not self.checked.accepted:
            return f"REFUSED BY COQ: {self.checked.fault}"
        rest = "axioms of the real numbers" if self.checked.axioms else "no axioms"
        return f"certified: Coq {coqc.version()}, {rest}"

    def to_dict(self) -> dict:
        """For the report; nothing in it depends on the machine's speed."""
        said = self.checked
        return {
            "form": self.form.name,
            "checked_by": f"Coq {coqc.version()}" if said and said.expected else None,
            "axioms": list(said.axioms) if said and said.expected else [],
            "scope": self.certificate.scope if self.certificate else None,
            "statement": "\n\n".join(t.statement for t in self.certificate.theorems)
            if self.certificate
            else None,
            "obstacle": self.obstacle or None,
            "word": self.word,
        }


def exact_forms(results: Sequence[ClaimResult]) -> Iterator[tuple[Form, ClaimResult, Verdict]]:
    """The forms that are proved or refuted by their own exact verdict."""
    for result in results:
        verdicts = {"printed": result.verdict, "reading": result.reading, "corrected": result.corrected}
        for form in forms_of(result.claim):
            verdict = verdicts[form.name]
            if verdict is not None and verdict.outcome in (Outcome.PROVED, Outcome.REFUTED):
                yield form, result, verdict


def written(form: Form, verdict: Verdict) -> Certified:
    """The certificate of a form, not yet checked."""
    try:
        if verdict.outcome == Outcome.REFUTED:
            made = refutation(form, verdict)
        else:
            made = certificate(form, every=(verdict.scope or "").startswith("all"))
    except NotCertified as obstacle:
        return Certified(form, verdict.outcome, None, str(obstacle))
    return Certified(form, verdict.outcome, made)


def checked_all(
    certificates: Sequence[Certified], progress: Callable[[object], None] = lambda done: None
) -> list[Certified]:
    """Each certificate put before Coq, on all cores."""
    coqc.library()

    def one(each: Certified) -> Certified:
        if each.certificate is None:
            done = each
        else:
            said = coqc.check(each.certificate.text)
            done = Certified(each.form, each.outcome, each.certificate, each.obstacle, said)
        progress(done)
        return done

    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        return list(pool.map(one, certificates))


def with_certificates(claims: Sequence[dict], results: Sequence[ClaimResult]) -> list[dict]:
    """The claims of a report, each with what is remembered of the certificates of its exact forms."""
    found: dict[str, list[dict]] = {}
    for form, result, verdict in exact_forms(results):
        each = written(form, verdict)
        if each.certificate is not None:
            each = replace(each, checked=coqc.recall(each.certificate.text))
        found.setdefault(result.claim.id, []).append(each.to_dict())
    return [{**claim, "certificates": found.get(claim["id"], [])} for claim in claims]
