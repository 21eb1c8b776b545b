"""Tables of a campaign's findings."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence

from judged_claims import KINDS, WRONG, Finding, Judged


def table(title: str, findings: Iterable[Finding], by: Callable[[Finding], str]) -> str:
    """How many findings there are of each kind, by what `by` says of them."""
    counts: dict[str, Counter[str]] = {}
    for each in findings:
        for row in (by(each), "all"):
            counts.setdefault(row, Counter())[each.kind] += 1
            counts[row]["formulas"] += each.step is not None
    heads = ("formulas", *KINDS)
    width = max(len(title), *(len(row) for row in counts), 12)
    lines = [" | ".join([title.ljust(width), *heads])]
    rows = [*sorted(row for row in counts if row != "all"), "all"]
    for row in rows:
        cells = [str(counts[row][head]).rjust(len(head)) for head in heads]
        lines.append(" | ".join([row.ljust(width), *cells]))
    return "\n".join(lines)


def tables(results: Sequence[Judged]) -> str:
    """The findings by family, layout, format and way of writing a condition."""
    findings = [each for one in results for each in one.findings]
    parts = [
        table("family", findings, lambda each: each.family),
        table("layout", findings, lambda each: each.display.layout),
        table("format", findings, lambda each: each.format + ("" if each.free else ", not free")),
        table(
            "condition",
            [each for each in findings if each.step is not None and each.step.beside is not None],
            lambda each: each.step.beside,
        ),
    ]
    broken = [f"no verdicts: {one.document.format}: {one.broken}" for one in results if one.broken]
    return "\n\n".join([*parts, *broken])


def wrong(results: Sequence[Judged]) -> list[Finding]:
    """The findings that are wrong verdicts, or formulas cut wrongly."""
    return [each for one in results for each in one.findings if each.kind in WRONG]


def told(finding: Finding) -> str:
    """One finding in full."""
    step, seen = finding.step, finding.seen
    lines = [
        f"## {finding.kind}: {finding.display.layout}, {finding.family}, {finding.format}, {finding.display.name}"
    ]
    lines.append(finding.display.source)
    if step is not None:
        lines.append(f"   printed: {step.left} = {step.right}   [{step.truth}]")
    if seen is not None:
        lines.append(f"   claim {seen.id}: {seen.latex}   [{seen.outcome}: {seen.reason[:200]}]")
    return "\n".join(lines)
