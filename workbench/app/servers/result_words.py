"""A result in words for a hover, the form that a quick fix writes, and faults of a text in words."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from workbench.core.code_labels import suffix

if TYPE_CHECKING:
    from workbench.core.paper_errors import PaperError
    from workbench.prover.results.claim_results import ClaimResult


def told_of(result: ClaimResult) -> str:
    """Returns verdict, reading and evidence in words."""
    from workbench.report.counterexamples import told
    from workbench.source.typeset.plain_text import in_plain_text, plain_text

    verdict = result.verdict
    lines = [f"**{verdict.outcome}**" + (f" ({verdict.scope})" if verdict.scope else "")]
    lines += [in_plain_text(f"{verdict.reason}{suffix(verdict.reason)}")] if verdict.reason else []
    lines += [in_plain_text(f"unless {'; '.join(verdict.unless)}")] if verdict.unless else []
    lines += [f"read as `{plain_text(verdict.read_back)}`"] if verdict.read_back else []
    if example := verdict.counterexample:
        lines += [f"counterexample: {told(example, result.claim.printed.latex)}"]
    for name in ("reading", "corrected"):
        form, its = getattr(result.claim, name), getattr(result, name)
        lines += (
            [f"{name}: `{plain_text(form.latex)}`: {its.outcome}"]
            if form is not None and its is not None
            else []
        )
    lines += [f"- {each.method}: {each.outcome}" for each in verdict.evidence]
    return "\n\n".join(lines)


def proved_form(result: ClaimResult) -> str | None:
    """Returns the proved correction or reading for the claim's own characters."""
    from workbench.core.verdict import Outcome
    from workbench.papers.corrections import same_formula

    claim = result.claim
    pairs = ((claim.corrected, result.corrected), (claim.reading, result.reading))
    proved = [form.latex for form, verdict in pairs if form and verdict and verdict.outcome is Outcome.PROVED]
    if not proved or claim.context.span is None:
        return None
    if not claim.chain:
        return proved[0]
    left, sign, right = proved[0].partition("=")
    return f"{sign}{right}" if same_formula(left, claim.printed.latex.partition("=")[0]) else None


def faults_in_words(faults: Sequence[PaperError], file: Path) -> list[str]:
    """Returns the messages of faults, without the folder; those of the text itself with the line only."""
    made = []
    for fault in faults:
        other = "" if str(fault.file) == str(file) or fault.file is None else Path(fault.file).name
        line = f"line {fault.line}" if fault.line else ""
        place = ", ".join(part for part in (other, line) if part)
        made.append(f"{place}: {fault.message}" if place else str(fault.message))
    return made
