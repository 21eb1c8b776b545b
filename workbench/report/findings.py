"""Findings: the faults of a paper with their positions, for the terminal, editors and CI."""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any
from urllib.parse import quote

from workbench.core.code_labels import suffix
from workbench.core.spans import Span
from workbench.core.verdict import Grade, Outcome
from workbench.papers import Paper, PaperError
from workbench.papers.texts.text_paper import TextPaper
from workbench.prover.results.claim_results import HOLDS, ClaimResult
from workbench.report.counterexamples import told
from workbench.source.documents.source_edits import SourceEdit

#: The severity levels of SARIF, editors and CI.
_LEVEL_OF = {
    Grade.ERROR: "error",
    Grade.WARNING: "warning",
    Grade.OK: "note",
    Grade.NOTE: "note",
    Grade.NOT_JUDGED: "note",
}
_RULES = {
    "refuted": "The formula is well-formed and false.",
    "ill-formed": "Types or weights do not fit as printed.",
    "conditional": "The formula holds only under a condition that the text does not state.",
    "argued": "Prose joins what was proved to the sentence.",
    "probable": "The formula was tested at random points only.",
    "unchecked": "The formula could not be judged.",
    "definition": "The formula says what a symbol is, of which the model says nothing.",
    "known": "A fault that the model names, with its proved correction.",
    "unexpected": "The verdict is not the one that the model announces.",
    "model": "What a model or a paper file says cannot be used, or does not fit the text.",
    "text": "The text could not be read as TeX would read it.",
}


@dataclass(frozen=True)
class Finding:
    """A fault with its position.

    Attributes:
        code: One of the rules above.
        claim: The id of the claim; empty if the finding concerns no claim.
        edits: Edits of the author's characters that produce the proved form.
    """

    level: str
    code: str
    message: str
    span: Span
    claim: str = ""
    latex: str = ""
    edits: tuple[SourceEdit, ...] = ()


def findings(paper: Paper, results: Sequence[ClaimResult]) -> list[Finding]:
    """Returns all findings, in the order of the text; none for proved claims and definitions."""
    found = [finding for finding in _of_results(results)]
    found += [fault_finding(fault, paper.paths[0]) for fault in paper.faults]
    if isinstance(paper, TextPaper):
        found += [
            replace(fault_finding(warning, paper.paths[0]), level="warning", code="text")
            for warning in paper.warnings
        ]
    return sorted(found, key=lambda each: (str(each.span.file), each.span.line, each.span.column))


def _of_results(results: Sequence[ClaimResult]) -> Iterator[Finding]:
    broken: set[str] = set()  # steps of a chain that do not follow
    for result in results:
        if result.known:
            continue
        claim, outcome = result.claim, result.verdict.outcome
        if outcome in (Outcome.REFUTED, Outcome.ILL_FORMED):
            is_first = not broken.intersection(claim.chain)
            broken.add(claim.id)
        else:
            is_first = False
        if result.passed and outcome in HOLDS and _is_settled(result):
            if claim.unread is not None:
                message = f"is judged now: {outcome}; its model can do without `unread`"
                yield Finding("note", "unexpected", message, place_of(result), claim.id, claim.printed.latex)
            continue
        code = str(outcome)
        if result.passed and outcome is not Outcome.DEFINITION:
            code = "known" if claim.skip is None else "unchecked"
        elif not result.passed and (outcome == result.expected or outcome in HOLDS):
            code = "unexpected"
        level = _LEVEL_OF[result.shown]
        message = _message(result, bool(claim.chain), is_first)
        edits = result.edits if result.proposed and result.proposed[0].verdict is Outcome.PROVED else ()
        yield Finding(level, code, message, place_of(result), claim.id, claim.printed.latex, edits)


def _is_settled(result: ClaimResult) -> bool:
    """True if there is nothing to report. A formula that may only define a symbol is reported."""
    return (
        result.verdict.outcome is Outcome.PROVED or result.verdict.code is None or bool(result.claim.unread)
    )


def _message(result: ClaimResult, is_step: bool, is_first: bool) -> str:
    verdict = result.verdict
    parts = [str(verdict.outcome)]
    if is_step and verdict.outcome is Outcome.REFUTED:
        parts[0] += (
            ": the first step that does not follow" if is_first else ": does not follow from the step before"
        )
    if verdict.reason:
        parts[0] += f": {verdict.reason}{suffix(verdict.reason)}"
    if verdict.unless:
        parts[0] += f", unless {'; '.join(verdict.unless)}"
    if verdict.hypothesis:
        parts.append(f"holds if {verdict.hypothesis.prose}")
    if counterexample := verdict.counterexample:
        parts.append(str(told(counterexample, result.claim.shown or "")))
    if not result.passed and result.why_not and verdict.outcome in HOLDS | {result.expected}:
        parts.append(result.why_not)
    return "; ".join(parts)


def place_of(result: ClaimResult) -> Span:
    """Returns the position of the fault; in a text, that of the author's characters."""
    claim = result.claim
    if claim.printed.at is not None:
        return claim.printed.at
    if claim.context.span is not None:
        return claim.context.span
    return Span(claim.source.file or Path(), claim.line or 1, 1, claim.line or 1, 1)


def fault_finding(error: PaperError, file: Path) -> Finding:
    """Returns the finding of an error. file: used if the error has no file."""
    line, column = error.line or 1, error.column or 1
    span = Span(Path(error.file or file), line, column, line, column + 1)
    return Finding("error", "model", f"{error.message}{suffix(error.reason)}", span)


def github(found: Sequence[Finding]) -> str:
    """Returns workflow commands, which GitHub shows next to the lines."""
    lines = []
    for each in found:
        level = "notice" if each.level == "note" else each.level
        places = {
            "file": str(each.span.file),
            "line": each.span.line,
            "endLine": each.span.end_line,
            "col": each.span.column,
            "endColumn": each.span.end_column,
            "title": f"{each.code} {each.claim}".strip(),
        }
        properties = ",".join(f"{name}={_escaped(str(value), ':,')}" for name, value in places.items())
        lines.append(f"::{level} {properties}::{_escaped(each.message)}\n")
    return "".join(lines)


def _escaped(text: str, more: str = "") -> str:
    text = text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")
    for character in more:
        text = text.replace(character, f"%{ord(character):02X}")
    return text


def sarif(found: Sequence[Finding], version: str) -> dict[str, Any]:
    """Returns SARIF 2.1.0; columns count code points, and the end column is exclusive."""
    used = sorted({each.code for each in found})
    rules = [{"id": code, "shortDescription": {"text": _RULES[code]}} for code in used]
    driver = {"name": "workbench", "version": version, "rules": rules}
    return {
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [
            {
                "tool": {"driver": driver},
                "columnKind": "unicodeCodePoints",
                "results": [
                    _sarif_result(each, used, mark)
                    for each, mark in zip(found, fingerprints(found), strict=True)
                ],
            }
        ],
    }


def fingerprints(found: Sequence[Finding]) -> list[str]:
    """Returns a mark for each finding: by what is displayed, not by its line; equal ones are numbered."""
    marks: list[str] = []
    seen: Counter[tuple[str, str, str]] = Counter()
    for each in found:
        shown = each.latex or each.message
        key = (each.span.file.name, each.code, " ".join(shown.split()))
        seen[key] += 1
        marks.append(hashlib.sha256("\n".join((*key, str(seen[key]))).encode()).hexdigest()[:32])
    return marks


def _sarif_result(each: Finding, used: Sequence[str], mark: str) -> dict[str, Any]:
    location = {"artifactLocation": {"uri": _uri(each.span.file)}, "region": _region(each.span)}
    fixes = {"fixes": [_sarif_fix(each.edits)]} if each.edits else {}
    return {
        "ruleId": each.code,
        "ruleIndex": used.index(each.code),
        "level": each.level,
        "message": {"text": each.message},
        "locations": [{"physicalLocation": location}],
        "partialFingerprints": {"display/v1": mark},
        **fixes,
    }


def _uri(file: Path) -> str:
    """A reference of RFC 3986: blanks and letters beyond ASCII are escaped."""
    return file.as_uri() if file.is_absolute() else quote(file.as_posix())


def _region(span: Span) -> dict[str, int]:
    return {
        "startLine": span.line,
        "startColumn": span.column,
        "endLine": span.end_line,
        "endColumn": span.end_column,
    }


def _sarif_fix(edits: Sequence[SourceEdit]) -> dict[str, Any]:
    changes: dict[str, list[dict[str, Any]]] = {}
    for edit in edits:
        change = {"deletedRegion": _region(edit.span), "insertedContent": {"text": edit.new}}
        changes.setdefault(_uri(edit.span.file), []).append(change)
    files = [{"artifactLocation": {"uri": uri}, "replacements": own} for uri, own in changes.items()]
    return {"description": {"text": "The proved correction"}, "artifactChanges": files}


def rdjsonl(found: Sequence[Finding], lines_of: dict[Path, list[str]]) -> str:
    """Returns Reviewdog's JSON lines; columns count UTF-8 bytes, from 1."""
    severities = {"error": "ERROR", "warning": "WARNING", "note": "INFO"}
    made = []
    for each in found:
        lines = lines_of.get(each.span.file, [])
        data: dict[str, Any] = {
            "message": each.message,
            "location": {"path": str(each.span.file), "range": _range(each.span, lines)},
            "severity": severities[each.level],
            "source": {"name": "workbench"},
            "code": {"value": each.code},
        }
        if each.edits:
            data["suggestions"] = [
                {"range": _range(edit.span, lines), "text": edit.new} for edit in each.edits
            ]
        made.append(json.dumps(data, ensure_ascii=False) + "\n")
    return "".join(made)


def _range(span: Span, lines: Sequence[str]) -> dict[str, Any]:
    start = {"line": span.line, "column": _bytes(lines, span.line, span.column)}
    end = {"line": span.end_line, "column": _bytes(lines, span.end_line, span.end_column)}
    return {"start": start, "end": end}


def _bytes(lines: Sequence[str], line: int, column: int) -> int:
    text = lines[line - 1] if 0 < line <= len(lines) else ""
    return len(text[: column - 1].encode("utf-8", "replace")) + 1
