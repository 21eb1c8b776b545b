"""workbench lsp: the verdicts in an editor, over standard input and output."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from workbench.cli.options import Unusable, memory_of_verdicts

if TYPE_CHECKING:
    from lsprotocol.types import CodeAction, Diagnostic, Range
    from pygls.lsp.server import LanguageServer

    from workbench.papers import Paper
    from workbench.papers.model import Span
    from workbench.report.counterexamples import told
    from workbench.report.findings import Finding
    from workbench.verify.results import ClaimResult


@click.command()
@click.option("--motions/--no-motions", default=True, help="Evaluate claims on Drake's motions too.")
def lsp(motions: bool) -> None:
    """Serve an editor: faults under the author's characters on save, verdicts on hover, proved corrections as
    quick fixes. Needs the extra lsp."""
    try:
        server = server_for(motions)
    except ImportError:
        raise Unusable(
            "the editor server needs the extra lsp: pip install 'kinematics-workbench[lsp]'"
        ) from None
    server.start_io()


@dataclass
class Judged:
    """What is known of one file since it was saved."""

    paper: Paper
    results: list[ClaimResult]
    told: set[Path] = field(default_factory=set)


def server_for(motions: bool) -> LanguageServer:
    """Raises ImportError without pygls."""
    from lsprotocol import types as lsp_types
    from pygls.lsp.server import LanguageServer

    server = LanguageServer("workbench", "1")
    known: dict[Path, Judged] = {}

    def judge(uri: str) -> None:
        path = Path(server.workspace.get_text_document(uri).path)
        if path.suffix.lower() != ".toml" or _is_paper(path):
            _judge(server, known, path, motions)

    @server.feature(lsp_types.TEXT_DOCUMENT_DID_OPEN)
    def opened(params: lsp_types.DidOpenTextDocumentParams) -> None:
        judge(params.text_document.uri)

    @server.feature(lsp_types.TEXT_DOCUMENT_DID_SAVE)
    def saved(params: lsp_types.DidSaveTextDocumentParams) -> None:
        judge(params.text_document.uri)

    @server.feature(lsp_types.TEXT_DOCUMENT_HOVER)
    def hover(params: lsp_types.HoverParams) -> lsp_types.Hover | None:
        path = Path(server.workspace.get_text_document(params.text_document.uri).path)
        for result in (result for judged in known.values() for result in judged.results):
            where = _range(server, _whole(result))
            if _whole(result).file.resolve() == path.resolve() and _holds(where, params.position):
                content = lsp_types.MarkupContent(lsp_types.MarkupKind.Markdown, _told(result))
                return lsp_types.Hover(content, where)
        return None

    options = lsp_types.CodeActionOptions([lsp_types.CodeActionKind.QuickFix])

    @server.feature(lsp_types.TEXT_DOCUMENT_CODE_ACTION, options)
    def actions(params: lsp_types.CodeActionParams) -> list[CodeAction]:
        found = []
        for diagnostic in params.context.diagnostics:
            data = diagnostic.data if isinstance(diagnostic.data, dict) else {}
            if "fix" not in data:
                continue
            where = lsp_types.Range(
                lsp_types.Position(*data["range"][:2]), lsp_types.Position(*data["range"][2:])
            )
            edit = lsp_types.TextEdit(where, data["fix"])
            found.append(
                lsp_types.CodeAction(
                    f"Replace by what is proved: {data['fix']}",
                    lsp_types.CodeActionKind.QuickFix,
                    [diagnostic],
                    edit=lsp_types.WorkspaceEdit({params.text_document.uri: [edit]}),
                )
            )
        return found

    return server


def _is_paper(path: Path) -> bool:
    """Not every TOML file is one."""
    try:
        text = path.read_text("utf-8", errors="replace")
    except OSError:
        return False
    return "[[claim]]" in text or "source" in text


def _judge(server: LanguageServer, known: dict[Path, Judged], path: Path, motions: bool) -> None:
    from workbench.papers import PaperError, load_paper
    from workbench.report.findings import fault_finding, findings
    from workbench.verify.claims import judge_paper

    try:
        paper = load_paper(path, faults=[])
        with memory_of_verdicts(True) as memory:
            results = judge_paper(paper, memory=memory, motions=motions)
        found = findings(paper, results)
        judged = Judged(paper, results)
    except PaperError as error:
        found, judged = [fault_finding(fault, path) for fault in error.faults], None
    told = known[path].told if path in known else ()
    by_file: dict[Path, list[Finding]] = {each: [] for each in (path, *told)}
    for each in found:
        by_file.setdefault(each.span.file, []).append(each)
    by_id = {result.claim.id: result for result in judged.results} if judged else {}
    for file, own in by_file.items():
        _publish(server, file, [_diagnostic(server, each, by_id.get(each.claim)) for each in own])
    if judged is not None:
        judged.told = set(by_file)
        known[path] = judged


def _publish(server: LanguageServer, file: Path, diagnostics: list[Diagnostic]) -> None:
    from lsprotocol.types import PublishDiagnosticsParams

    server.text_document_publish_diagnostics(PublishDiagnosticsParams(file.resolve().as_uri(), diagnostics))


#: What is no fault and waits for its author.
_HINTS = ("states a law", "which nothing defines", "a definition makes it", "unknown symbol")


def _diagnostic(server: LanguageServer, finding: Finding, result: ClaimResult | None) -> Diagnostic:
    from lsprotocol.types import Diagnostic, DiagnosticSeverity

    levels = {"error": DiagnosticSeverity.Error, "warning": DiagnosticSeverity.Warning}
    severity = levels.get(finding.level, DiagnosticSeverity.Information)
    message = finding.message
    if finding.level == "note" and any(words in message for words in _HINTS):
        severity = DiagnosticSeverity.Hint
    data: dict[str, Any] = {"claim": finding.claim}
    if result is not None and (fix := _fix(result)) is not None:
        where = _range(server, _whole(result))
        data |= {
            "fix": fix,
            "range": [where.start.line, where.start.character, where.end.line, where.end.character],
        }
    return Diagnostic(
        _range(server, finding.span), message, severity, code=finding.code, source="workbench", data=data
    )


def _fix(result: ClaimResult) -> str | None:
    """What to write for the claim's own characters: the correction or reading that was proved."""
    from workbench.judge.verdict import Outcome
    from workbench.papers.mends import same_formula

    claim = result.claim
    pairs = ((claim.corrected, result.corrected), (claim.reading, result.reading))
    proved = [form.latex for form, verdict in pairs if form and verdict and verdict.outcome is Outcome.PROVED]
    if not proved or claim.span is None:
        return None
    if not claim.chain:
        return proved[0]
    left, sign, right = proved[0].partition("=")
    return f"{sign}{right}" if same_formula(left, claim.printed.latex.partition("=")[0]) else None


def _told(result: ClaimResult) -> str:
    """Verdict, reading and evidence."""
    verdict = result.verdict
    lines = [f"**{verdict.outcome}**" + (f" ({verdict.scope})" if verdict.scope else "")]
    lines += [verdict.reason] if verdict.reason else []
    lines += [f"unless {'; '.join(verdict.unless)}"] if verdict.unless else []
    lines += [f"read as `{verdict.read_back}`"] if verdict.read_back else []
    if example := verdict.counterexample:
        lines += [f"counterexample: {told(example, result.claim.printed.latex)}"]
    for name in ("reading", "corrected"):
        form, its = getattr(result.claim, name), getattr(result, name)
        lines += [f"{name}: `{form.latex}`: {its.outcome}"] if form is not None and its is not None else []
    lines += [f"- {evidence}" for evidence in verdict.evidence]
    return "\n\n".join(lines)


def _whole(result: ClaimResult) -> Span:
    """All that the claim says, where it stands."""
    from workbench.report.findings import place_of

    return result.claim.span or place_of(result)


def _range(server: LanguageServer, span: Span) -> Range:
    """In the units that the client counts."""
    from lsprotocol.types import Position, Range

    from workbench.cli.carets import lines_of

    document = server.workspace.get_text_document(span.file.resolve().as_uri())
    lines = [f"{line}\n" for line in lines_of(span.file)]
    whole = Range(
        Position(span.line - 1, span.column - 1), Position(span.end_line - 1, max(0, span.end_column - 1))
    )
    return document.position_codec.range_to_client_units(lines, whole)


def _holds(where: Range, position: Any) -> bool:
    return where.start <= position <= where.end
