"""Diagnostics of an editor: a finding with its range in the client's units, and its correction as edits."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from workbench.app.servers.result_words import proved_form
from workbench.core.codes.syntax_codes import UNKNOWN_SYMBOLS
from workbench.core.codes.verdict_codes import WAITS_FOR_ITS_AUTHOR
from workbench.core.reasons import Code

if TYPE_CHECKING:
    from lsprotocol.types import Diagnostic, Range
    from pygls.lsp.server import LanguageServer

    from workbench.core.spans import Span
    from workbench.prover.results.claim_results import ClaimResult
    from workbench.report.findings import Finding


def publish(server: LanguageServer, file: Path, diagnostics: list[Diagnostic]) -> None:
    from lsprotocol.types import PublishDiagnosticsParams

    server.text_document_publish_diagnostics(PublishDiagnosticsParams(file.resolve().as_uri(), diagnostics))


#: Codes that wait for the author and are no faults.
_HINTS: frozenset[Code] = WAITS_FOR_ITS_AUTHOR | UNKNOWN_SYMBOLS


def diagnostic_of(server: LanguageServer, finding: Finding, result: ClaimResult | None) -> Diagnostic:
    from lsprotocol.types import Diagnostic, DiagnosticSeverity

    levels = {"error": DiagnosticSeverity.Error, "warning": DiagnosticSeverity.Warning}
    severity = levels.get(finding.level, DiagnosticSeverity.Information)
    reason = result.verdict.reason if result is not None else None
    waits = finding.code == "definition" or (reason is not None and not reason.codes.isdisjoint(_HINTS))
    if finding.level == "note" and waits:
        severity = DiagnosticSeverity.Hint
    data: dict[str, Any] = {"claim": finding.claim}
    if result is not None:
        data |= _quick_fix(server, result)
    return Diagnostic(
        range_of(server, finding.span),
        finding.message,
        severity,
        code=finding.code,
        source="workbench",
        data=data,
    )


def _quick_fix(server: LanguageServer, result: ClaimResult) -> dict[str, Any]:
    """Returns the title and the edits of a proved correction: (file, start, end, new text); empty if none is
    known."""
    from workbench.source.typeset.plain_text import in_plain_text

    edits = [(each.span, each.new) for each in result.edits]
    title = in_plain_text(result.proposed[0].edit) if result.proposed else ""
    if not edits and (fix := proved_form(result)) is not None:
        edits, title = [(whole_span(result), fix)], f"replace by what is proved: {fix}"
    if not edits:
        return {}
    told = []
    for span, new in edits:
        where = range_of(server, span)
        told.append(
            (
                span.file.resolve().as_uri(),
                where.start.line,
                where.start.character,
                where.end.line,
                where.end.character,
                new,
            )
        )
    return {"title": title[:1].upper() + title[1:], "edits": told}


def whole_span(result: ClaimResult) -> Span:
    """Returns the span of the whole claim."""
    from workbench.report.findings import place_of

    return result.claim.context.span or place_of(result)


def range_of(server: LanguageServer, span: Span) -> Range:
    """Returns the range in the units that the client counts."""
    from lsprotocol.types import Position, Range

    document = server.workspace.get_text_document(span.file.resolve().as_uri())
    lines = [f"{line}\n" for line in document.source.split("\n")]
    whole = Range(
        Position(span.line - 1, span.column - 1), Position(span.end_line - 1, max(0, span.end_column - 1))
    )
    return document.position_codec.range_to_client_units(lines, whole)
