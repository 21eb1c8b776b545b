"""`workbench lsp`: a language server that shows verdicts in an editor, over standard input and output."""

from __future__ import annotations

import asyncio
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from importlib.metadata import version
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, Any

import click

from workbench.app.commands.options import Unusable
from workbench.app.pipeline.judged_files import Judged
from workbench.app.servers.desk import Desk, Superseded, Turn
from workbench.app.servers.key_completion import completions
from workbench.app.servers.lsp_answers import (
    ANSWER,
    WRITE_MODEL,
    answer_actions,
    answer_of,
    lenses,
    write_model,
)
from workbench.app.servers.lsp_diagnostics import diagnostic_of, publish, range_of, whole_span
from workbench.app.servers.result_words import told_of
from workbench.app.servers.symbol_places import defining_places, sign_at

if TYPE_CHECKING:
    from lsprotocol.types import CodeAction, Diagnostic, Hover, Location, Position, Range
    from pygls.lsp.server import LanguageServer
    from pygls.workspace import ServerTextPosition

    from workbench.papers.drafting.questions_to_author import Answer
    from workbench.prover.results.claim_results import ClaimResult
    from workbench.report.findings import Finding


@click.command()
@click.option("--motions/--no-motions", default=True, help="Evaluate claims on Drake's motions too.")
def lsp(motions: bool) -> None:
    """Serve an editor: faults under the author's characters as you type, verdicts on hover, proved
    corrections as quick fixes. Needs the extra lsp."""
    try:
        server = server_for(motions)
    except ImportError:
        raise Unusable(
            "the editor server needs the extra lsp: pip install 'kinematics-workbench[lsp]'"
        ) from None
    server.start_io()


#: Seconds without a keystroke after which a text is judged.
_PAUSE = 0.05
#: Seconds between two looks for first verdicts, and after which they are shown where none stood before.
_LOOK, _SOON = 0.02, 0.2


@dataclass
class Known:
    """The results for one file, all or the first ones, and the files with published diagnostics.

    Attributes:
        whole: The last results of the whole file.
    """

    judged: Judged
    told: set[Path] = field(default_factory=set)
    whole: Judged | None = None

    @property
    def is_whole(self) -> bool:
        return self.judged is self.whole


def server_for(motions: bool) -> LanguageServer:
    """Returns the language server. Raises ImportError without pygls."""
    from lsprotocol import types as lsp_types
    from pygls.lsp.server import LanguageServer

    server = LanguageServer("workbench", version("kinematics-workbench"))
    desk = Desk(motions)
    desk.prepare()
    known: dict[Path, Known] = {}
    newest: dict[str, int] = {}
    answers: dict[Path, list[Answer]] = {}

    async def judge(uri: str, is_saved: bool = False) -> None:
        path = _path_of(server, uri)
        if path.suffix.lower() != ".toml" or _is_paper(path):
            buffers = _buffers(server)
            if is_saved:
                buffers.pop(path, None)
            await _judge(server, known, desk.turn(path), path, buffers, answers.get(path, ()))

    @server.feature(lsp_types.TEXT_DOCUMENT_DID_CHANGE)
    async def changed(params: lsp_types.DidChangeTextDocumentParams) -> None:
        uri, number = params.text_document.uri, params.text_document.version
        newest[uri] = number
        await asyncio.sleep(_PAUSE)
        if newest[uri] == number:
            await judge(uri)

    @server.feature(lsp_types.TEXT_DOCUMENT_DID_OPEN)
    async def opened(params: lsp_types.DidOpenTextDocumentParams) -> None:
        await judge(params.text_document.uri)

    @server.feature(lsp_types.TEXT_DOCUMENT_DID_SAVE)
    async def saved(params: lsp_types.DidSaveTextDocumentParams) -> None:
        await judge(params.text_document.uri, is_saved=True)

    @server.feature(lsp_types.SHUTDOWN)
    def stopped(params: None) -> None:
        desk.close()

    _add_queries(server, known)

    @server.command(ANSWER)
    async def answered(*given: Any) -> None:
        if (answer := answer_of(list(given))) is not None:
            uri = given[0]
            own = answers.setdefault(_path_of(server, uri), [])
            own[:] = [each for each in own if (each.table, each.key) != (answer.table, answer.key)]
            own.append(answer)
            await judge(uri)

    @server.command(WRITE_MODEL)
    async def model_written(uri: str) -> None:
        own = known.get(_path_of(server, uri))
        if own is not None and own.is_whole and own.judged.draft is not None:
            message = lsp_types.ShowMessageParams(lsp_types.MessageType.Info, write_model(own.judged))
            server.window_show_message(message)
            answers.pop(_path_of(server, uri), None)
            await judge(uri)

    return server


def _path_of(server: LanguageServer, uri: str) -> Path:
    return Path(server.workspace.get_text_document(uri).path)


def _add_queries(server: LanguageServer, known: Mapping[Path, Known]) -> None:
    """Adds the features that answer from what is known: hover, corrections, lenses and completion."""
    from lsprotocol import types as lsp_types

    @server.feature(lsp_types.TEXT_DOCUMENT_HOVER)
    def hover(params: lsp_types.HoverParams) -> lsp_types.Hover | None:
        return _hover(server, known.values(), _path_of(server, params.text_document.uri), params.position)

    @server.feature(lsp_types.TEXT_DOCUMENT_DEFINITION)
    def defined(params: lsp_types.DefinitionParams) -> list[lsp_types.Location]:
        return _definitions(server, known.values(), params.text_document.uri, params.position)

    options = lsp_types.CodeActionOptions([lsp_types.CodeActionKind.QuickFix])

    @server.feature(lsp_types.TEXT_DOCUMENT_CODE_ACTION, options)
    def actions(params: lsp_types.CodeActionParams) -> list[CodeAction]:
        found = [*_correction_actions(params.context.diagnostics)]
        uri = params.text_document.uri
        own = known.get(_path_of(server, uri))
        return found if own is None else [*found, *answer_actions(uri, own.judged, params.range)]

    @server.feature(lsp_types.TEXT_DOCUMENT_CODE_LENS)
    def code_lenses(params: lsp_types.CodeLensParams) -> list[lsp_types.CodeLens]:
        own = known.get(_path_of(server, params.text_document.uri))
        if own is None or not own.is_whole:
            return []
        return list(lenses(params.text_document.uri, own.judged))

    triggers = lsp_types.CompletionOptions(trigger_characters=["{", '"'])

    @server.feature(lsp_types.TEXT_DOCUMENT_COMPLETION, triggers)
    def completed(params: lsp_types.CompletionParams) -> list[lsp_types.CompletionItem]:
        lines, place = _own_place(server, params.text_document.uri, params.position)
        kind = lsp_types.CompletionItemKind.Property
        found = completions(lines, place.line, place.character)
        return [lsp_types.CompletionItem(name, kind=kind, documentation=meaning) for name, meaning in found]


def _at(
    server: LanguageServer, known: Iterable[Known], path: Path, position: Position
) -> tuple[Known, ClaimResult, Range] | None:
    """Returns the result for the formula at a position of a file, with its range."""
    for each in known:
        for result in each.judged.results:
            where = range_of(server, whole_span(result))
            if whole_span(result).file.resolve() == path.resolve() and where.start <= position <= where.end:
                return each, result, where
    return None


def _hover(server: LanguageServer, known: Iterable[Known], path: Path, position: Position) -> Hover | None:
    """Returns the verdict on the formula at a position of a file."""
    from lsprotocol import types as lsp_types

    if (found := _at(server, known, path, position)) is None:
        return None
    content = lsp_types.MarkupContent(lsp_types.MarkupKind.Markdown, told_of(found[1]))
    return lsp_types.Hover(content, found[2])


def _definitions(
    server: LanguageServer, known: Iterable[Known], uri: str, position: Position
) -> list[Location]:
    """Returns the places that define the symbol at a position, or all symbols of the formula there."""
    from lsprotocol import types as lsp_types

    if (found := _at(server, known, _path_of(server, uri), position)) is None:
        return []
    lines, place = _own_place(server, uri, position)
    sign = sign_at(lines[place.line], place.character) if place.line < len(lines) else ""
    spans = defining_places(found[0].judged, found[1], sign)
    return [lsp_types.Location(each.file.resolve().as_uri(), range_of(server, each)) for each in spans]


def _own_place(server: LanguageServer, uri: str, at: Position) -> tuple[list[str], ServerTextPosition]:
    """Returns the lines of a file, and a position of the client in characters."""
    document = server.workspace.get_text_document(uri)
    lines = document.source.split("\n")
    return lines, document.position_codec.position_from_client_units([f"{line}\n" for line in lines], at)


def _correction_actions(diagnostics: Iterable[Diagnostic]) -> Iterator[CodeAction]:
    """Yields the corrections that the diagnostics carry."""
    from lsprotocol import types as lsp_types

    for diagnostic in diagnostics:
        data = diagnostic.data if isinstance(diagnostic.data, dict) else {}
        if "edits" not in data:
            continue
        changes: dict[str, list[Any]] = {}
        for uri, *places, new in data["edits"]:
            where = lsp_types.Range(lsp_types.Position(*places[:2]), lsp_types.Position(*places[2:]))
            changes.setdefault(uri, []).append(lsp_types.TextEdit(where, new))
        kind, edit = lsp_types.CodeActionKind.QuickFix, lsp_types.WorkspaceEdit(changes)
        yield lsp_types.CodeAction(data["title"], kind, [diagnostic], edit=edit)


def _is_paper(path: Path) -> bool:
    """True if a TOML file may be a paper file or a model."""
    try:
        text = path.read_text("utf-8", errors="replace")
    except OSError:
        return False
    return "[[claim]]" in text or "source" in text


async def _judge(
    server: LanguageServer,
    known: dict[Path, Known],
    turn: Turn,
    path: Path,
    buffers: Mapping[Path, str],
    answers: Sequence[Answer],
) -> None:
    """Publishes the verdicts, and again with the corrections, if a search finds any; nothing once the file is
    to be judged anew."""
    from workbench.papers import PaperError
    from workbench.report.findings import fault_finding

    try:
        judged = await _verdicts(server, known, turn, path, buffers, answers)
        _tell_judged(server, known, path, judged)
        if any(result.is_wrong for result in judged.results):
            corrected = await turn.corrections(judged)
            if any(result.edits for result in corrected.results):
                _tell_judged(server, known, path, corrected)
    except Superseded:
        return
    except PaperError as error:
        _tell(server, known, path, [fault_finding(fault, path) for fault in error.faults], None)


async def _verdicts(
    server: LanguageServer,
    known: dict[Path, Known],
    turn: Turn,
    path: Path,
    buffers: Mapping[Path, str],
    answers: Sequence[Answer],
) -> Judged:
    """Returns the verdicts; publishes the first ones if the others take longer. Raises as the turn."""
    from workbench.report.findings import findings

    before = known[path].whole if path in known else None
    judging = asyncio.ensure_future(turn.verdicts(path, buffers, answers, before))
    told, start = 0, monotonic()
    while not (await asyncio.wait({judging}, timeout=_LOOK))[0]:
        is_time = turn.has_standing or monotonic() - start > _SOON
        if is_time and turn.news > told and (first := turn.at_once()) is not None:
            told = turn.news
            _tell(server, known, path, findings(first.paper, first.results), first, is_whole=False)
    return judging.result()


def _tell_judged(server: LanguageServer, known: dict[Path, Known], path: Path, judged: Judged) -> None:
    from workbench.report.findings import findings

    _tell(server, known, path, findings(judged.paper, judged.results), judged)
    workspace = server.client_capabilities.workspace
    if workspace is not None and workspace.code_lens is not None and workspace.code_lens.refresh_support:
        server.workspace_code_lens_refresh(None)


def _buffers(server: LanguageServer) -> dict[Path, str]:
    """Returns the contents of the editor's buffers, which may not be saved."""
    return {Path(each.path): each.source for each in server.workspace.text_documents.values() if each.path}


def _tell(
    server: LanguageServer,
    known: dict[Path, Known],
    path: Path,
    found: list[Finding],
    judged: Judged | None,
    is_whole: bool = True,
) -> None:
    told = known[path].told if path in known else ()
    by_file: dict[Path, list[Finding]] = {each: [] for each in (path, *told)}
    for each in found:
        by_file.setdefault(each.span.file, []).append(each)
    by_id = {result.claim.id: result for result in judged.results} if judged else {}
    for file, own in by_file.items():
        publish(server, file, [diagnostic_of(server, each, by_id.get(each.claim)) for each in own])
    if judged is not None:
        whole = judged if is_whole else known[path].whole if path in known else None
        known[path] = Known(judged, set(by_file), whole)
