"""Results on a terminal. Formulas are Text objects, so that their brackets are not markup."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import IO, TYPE_CHECKING, Any

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table
from rich.text import Text

from workbench.context.claim_parts import ClaimForm
from workbench.core.code_labels import coded
from workbench.report.counterexamples import told
from workbench.report.counts import summary, witness_counts
from workbench.report.shown_kinds import STATES, VERDICTS
from workbench.source.typeset.plain_text import in_plain_text

if TYPE_CHECKING:
    from workbench.context.claims import Claim
    from workbench.prover.results.claim_results import ClaimResult

_STYLES = {name: kind.style for name, kind in VERDICTS.items()}
_UNLIMITED = 100_000

#: Figures of evidence that only a plot can show.
_UNSHOWN = ("course",)


def console(stream: IO[str]) -> Console:
    """Returns a console: colours only on a terminal (rich also respects NO_COLOR), and no wrapping
    elsewhere."""
    width = None if stream.isatty() else _UNLIMITED
    return Console(file=stream, width=width, highlight=False, emoji=False, soft_wrap=False)


def outcome_text(outcome: str) -> Text:
    return Text(str(outcome), style=_STYLES.get(str(outcome), ""))


def claims_table(claims: Sequence[Claim]) -> Table:
    table = _table("id", "equation", "section", "expected", "printed")
    for claim in claims:
        table.add_row(
            Text(claim.id),
            Text(claim.equation or ""),
            Text(claim.section or ""),
            outcome_text(claim.expected),
            Text(_one_line(claim.printed.latex or claim.sentence.quote or claim.source.statement or "")),
        )
    return table


def results_table(results: Sequence[ClaimResult]) -> Table:
    table = _table("id", "equation", "verdict", "scope", "reading", "corrected", "as expected")
    for result in results:
        table.add_row(
            Text(result.claim.id),
            Text(result.claim.equation or ""),
            outcome_text(result.verdict.outcome),
            Text(result.verdict.scope or ""),
            outcome_text(result.reading.outcome) if result.reading else Text(""),
            outcome_text(result.corrected.outcome) if result.corrected else Text(""),
            Text("yes", style="green") if result.passed else Text(f"NO: {result.why_not}", style="bold red"),
        )
    return table


def summary_line(results: Sequence[ClaimResult]) -> Text:
    line = Text(f"{len(results)} claims: ")
    for position, (name, count) in enumerate(summary(results).items()):
        line.append(", " if position else "")
        line.append(f"{count} {name}", style=_STYLES[name])
    failed = sum(not result.passed for result in results)
    line.append("; all as expected" if not failed else f"; {failed} not as expected")
    return line


def motions_line(results: Sequence[ClaimResult]) -> Text | None:
    """Returns the number of claims evaluated on Drake's motions; None if there are none.

    `show` gives the reason for each other claim.
    """
    counts = witness_counts(results)
    if not (seen := counts.pop("Drake")):
        return None
    names = {"none": "for other reasons not"}
    others = [f"{count} {names.get(name, name)}" for name, count in counts.items() if count]
    return Text("; ".join([f"on Drake's motions: {seen} claims", *others]))


def claim_lines(result: ClaimResult, with_expectation: bool = True) -> Iterator[Text]:
    """Yields one claim in full: fault, edits, reason, counterexample, evidence.

    with_expectation: also its id, and whether it passed.
    """
    claim, verdict = result.claim, result.verdict
    if with_expectation:
        yield Text(claim.id, style="bold")
    yield from _field("equation", claim.equation)
    yield from _field("section", claim.section)
    if result.fault:
        yield from _fault(result.fault, claim)
    yield from _field("statement", claim.source.statement)
    yield from _field("printed", claim.shown)
    yield from _field("our formula", claim.our_formula)
    yield from _field("goal", claim.proof.goal.latex if claim.proof.goal else None)
    yield from _field("for", str(claim.orders or ""))
    for condition in (*claim.assume, *claim.context.given):
        yield from _field("assuming", condition.latex)
    yield Text.assemble(f"{'verdict':>15}  ", outcome_text(verdict.outcome))
    yield from _field("scope", verdict.scope)
    if claim.reading is None or not claim.source.note:  # else the note explains the reading
        yield from _field("because", coded(verdict.reason))
    yield from _field("unless", in_plain_text("; ".join(verdict.unless)))
    yield from _field("hypothesis", str(result.hypothesis or ""))
    for form in (ClaimForm.READING, ClaimForm.CORRECTED):
        if own := result.verdicts.get(form):
            yield from _field(form, claim.forms[form].latex)
            yield Text.assemble(" " * 17, outcome_text(own.outcome))
            yield from _field("because", coded(own.reason))
    if result.counterexample:
        said = claim.our_formula or claim.shown or ""
        yield from _field("counterexample", str(told(result.counterexample, said)))
    yield from _field("read as", verdict.read_back)
    for evidence in verdict.evidence:
        figures = ", ".join(f"{k} {v}" for k, v in evidence.figures.items() if k not in _UNSHOWN)
        text = f"{evidence.method}: {evidence.outcome}" + (f" ({figures})" if figures else "")
        yield from _field("evidence", text)
    yield from _field("on motions", result.on_motions.line)
    for certificate in result.certificates or ():
        yield from _field("certificate", f"{certificate.form}: {certificate.word}")
        if certificate.statement:
            yield from (Text(f"{'':17}{line}") for line in certificate.statement.splitlines())
    yield from _field("bears on", ", ".join(claim.inherits))
    if not result.fault:
        yield from _field("note", claim.source.note)
    if with_expectation and not result.passed:
        yield Text(f"{'NOT AS EXPECTED':>15}  {result.why_not}", style="bold red")


def _fault(fault: str, claim: Claim) -> Iterator[Text]:
    """Yields what is wrong, and the edits for it."""
    kind, mend = STATES[fault], claim.mend
    yield Text.assemble(f"{'fault':>15}  ", (kind.label, kind.style), f": {kind.meaning}")
    yield from _field("where", mend.place)
    yield from _field("beside it", mend.beside)
    for edit in mend.edits:
        yield from _field("for", edit.old)
        yield from _field("read", edit.new or "nothing")
    yield from _field("add", mend.add)
    yield from _field("mended by", mend.by)
    yield from _field("why", claim.source.note)
    yield from _field("for example", mend.example)


@contextmanager
def progress_bar(total: int, what: str) -> Iterator[Any]:
    """Shows a progress bar on standard error, if that is a terminal; yields the function that advances it."""
    if not sys.stderr.isatty() or total < 2:
        yield lambda result: None
        return
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task(what, total=total)
        yield lambda result: progress.update(task, advance=1)


def certificates_table(certificates: Sequence[Any]) -> Table:
    """Returns one row for each exact form: its verdict, and Coq's answer."""
    table = _table("claim", "form", "verdict", "scope", "certificate")
    for each in certificates:
        scope = each.certificate.scope if each.certificate else None
        table.add_row(each.form.claim.id, each.form.name, str(each.outcome), scope or "", each.word)
    return table


def _table(*headings: str) -> Table:
    table = Table(box=None, pad_edge=False, header_style="bold")
    for heading in headings:
        table.add_column(heading, overflow="fold")
    return table


def _field(name: str, value: str | None) -> Iterator[Text]:
    if value:
        yield Text(f"{name:>15}  {_one_line(value)}")


def _one_line(text: str) -> str:
    """Returns the text on one line with control characters replaced."""
    return "".join(c if c.isprintable() else "\ufffd" for c in " ".join(text.split()))
