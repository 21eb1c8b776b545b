"""`workbench lsp` as an editor meets it: over standard input and output."""

from __future__ import annotations

import asyncio
import os
import sys
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

types = pytest.importorskip("lsprotocol.types")
client_module = pytest.importorskip("pygls.lsp.client")

MODEL = r"""source = "é p.md"
[symbols]
'a' = { kind = "vector" }
'b' = { kind = "vector" }
'm' = { kind = "scalar" }
'c' = { kind = "vector" }
[[claim]]
at = "one"
corrected = 'a \times b = -b \times a'
"""
TEXT = "𝒳é: $$ a \\times b = b \\times a $$ (one)\n\n$$ c = a \\times b $$ (two)\n\n$$ a + m = 0 $$\n\n$$ a + b = b + a $$\n"


async def session(folder: Path) -> dict[str, object]:
    client = client_module.BaseLanguageClient("test", "1")
    published: dict[str, list] = {}
    came = asyncio.Event()

    @client.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    def on_diagnostics(params: types.PublishDiagnosticsParams) -> None:
        published[params.uri] = params.diagnostics
        came.set()

    code = "from workbench.app.commands.commands import main; main(['lsp'])"
    await client.start_io(sys.executable, "-c", code)
    await client.initialize_async(
        types.InitializeParams(types.ClientCapabilities(), root_uri=folder.as_uri())
    )
    client.initialized(types.InitializedParams())
    path = folder / "é p.md"
    uri = path.as_uri()

    async def saved(text: str, codes: set[str]) -> list:
        """The verdicts on a saved text, once they have these codes; the first ones may come before."""
        path.write_text(text)
        client.text_document_did_save(types.DidSaveTextDocumentParams(types.TextDocumentIdentifier(uri)))
        while {each.code for each in published[uri]} != codes:
            came.clear()
            await asyncio.wait_for(came.wait(), 60)
        return published[uri]

    item = types.TextDocumentItem(uri, "markdown", 1, TEXT)
    client.text_document_did_open(types.DidOpenTextDocumentParams(item))
    while not any(each.code == "ill-formed" for each in published.get(uri, ())):
        came.clear()
        await asyncio.wait_for(came.wait(), 60)
    found: dict[str, object] = {"opened": published[uri]}
    place = types.TextDocumentIdentifier(uri)
    found["hover"] = await client.text_document_hover_async(types.HoverParams(place, types.Position(6, 6)))
    found["false"] = await client.text_document_hover_async(types.HoverParams(place, types.Position(0, 12)))
    found["nothing"] = await client.text_document_hover_async(types.HoverParams(place, types.Position(1, 0)))
    (known,) = [each for each in published[uri] if each.code == "known"]
    found["actions"] = await client.text_document_code_action_async(
        types.CodeActionParams(place, known.range, types.CodeActionContext([known]))
    )
    mended = TEXT.replace("= b \\times a", "= - b \\times a").replace("a + m", "a - a")
    found["mended"] = await saved(mended, {"unexpected", "definition"})
    (folder / "é p.toml").write_text("source = [")
    found["text"] = await saved(TEXT, set())
    while (model := (folder / "é p.toml").as_uri()) not in published:
        came.clear()
        await asyncio.wait_for(came.wait(), 60)
    found["broken"] = published[model]
    await client.shutdown_async(None)
    client.exit(None)
    await client.stop()
    return found


@pytest.fixture(scope="module")
def found(tmp_path_factory) -> dict:
    folder = tmp_path_factory.mktemp("editor")
    (folder / "é p.toml").write_text(MODEL)
    (folder / "é p.md").write_text(TEXT)
    before = os.environ.get("WORKBENCH_CACHE")
    os.environ["WORKBENCH_CACHE"] = str(folder / "cache")
    try:
        return asyncio.run(session(folder))
    finally:
        os.environ["WORKBENCH_CACHE"] = before or ""


def test_fault_ranges_use_the_units_of_the_client(found: dict) -> None:
    by_code = {each.code: each for each in found["opened"]}
    known, ill_formed = by_code["known"], by_code["ill-formed"]
    assert known.range.start == types.Position(0, TEXT.index("a") + 1), "𝒳 is two units of UTF-16"
    assert ill_formed.range.start.line == 4 and ill_formed.severity == types.DiagnosticSeverity.Error
    assert known.severity == types.DiagnosticSeverity.Information


def test_a_formula_that_needs_a_definition_is_a_hint(found: dict) -> None:
    (hint,) = [each for each in found["opened"] if each.severity == types.DiagnosticSeverity.Hint]
    assert "defines c" in hint.message and hint.range.start.line == 2


def test_hover_shows_verdict_reading_and_evidence(found: dict) -> None:
    told = found["hover"].contents.value
    assert "**proved**" in told and "read as `" in told and "FLINT" in told
    assert found["nothing"] is None


def test_hover_over_a_false_formula_shows_the_counterexample(found: dict) -> None:
    told = found["false"].contents.value
    assert "**refuted**" in told and "counterexample: with" in told and "the right side" in told


def test_the_proved_correction_is_a_quick_fix(found: dict) -> None:
    (action,) = found["actions"]
    ((edit,),) = action.edit.changes.values()
    start, end = edit.range.start, edit.range.end
    line = TEXT.split("\n")[0].encode("utf-16-le")
    assert line[2 * start.character : 2 * end.character].decode("utf-16-le") == "a \\times b = b \\times a"
    assert edit.new_text == "a \\times b = -b \\times a"


def test_a_save_judges_again_and_a_broken_model_is_one_fault(found: dict) -> None:
    assert {each.code for each in found["mended"]} == {"unexpected", "definition"}
    assert [each.code for each in found["broken"]] == ["model"] and not found["text"]


TYPED = """%! workbench: symbols.'a' = { kind = "vector" }
%! workbench: symbols.'b' = { kind = "vector" }
\\newcommand{\\va}{a}
\\[ \\va \\times b = b \\times \\va \\]
"""


async def typed(folder: Path) -> dict[str, object]:
    """A text that is opened with a fault, which its quick fix corrects without a save."""
    client = client_module.BaseLanguageClient("test", "1")
    published: list[list] = []
    came = asyncio.Event()

    @client.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    def on_diagnostics(params: types.PublishDiagnosticsParams) -> None:
        published.append(params.diagnostics)
        came.set()

    async def until(is_there) -> list:
        while not published or not is_there(published[-1]):
            came.clear()
            await asyncio.wait_for(came.wait(), 60)
        return published[-1]

    await client.start_io(
        sys.executable, "-c", "from workbench.app.commands.commands import main; main(['lsp'])"
    )
    await client.initialize_async(
        types.InitializeParams(types.ClientCapabilities(), root_uri=folder.as_uri())
    )
    client.initialized(types.InitializedParams())
    path = folder / "typed.tex"
    path.write_text(TYPED)
    uri = path.as_uri()
    client.text_document_did_open(
        types.DidOpenTextDocumentParams(types.TextDocumentItem(uri, "latex", 1, TYPED))
    )
    faults = await until(lambda found: any("edits" in (each.data or {}) for each in found))
    document = types.TextDocumentIdentifier(uri)
    (action,) = await client.text_document_code_action_async(
        types.CodeActionParams(document, faults[0].range, types.CodeActionContext(faults))
    )
    ((edit,),) = action.edit.changes.values()
    change = types.TextDocumentContentChangePartial(range=edit.range, text=edit.new_text)
    client.text_document_did_change(
        types.DidChangeTextDocumentParams(types.VersionedTextDocumentIdentifier(2, uri), [change])
    )
    after = await until(lambda found: not found)
    await client.shutdown_async(None)
    client.exit(None)
    await client.stop()
    return {"title": action.title, "new": edit.new_text, "after": tuple(after), "on disk": path.read_text()}


def test_quick_fix_edits_what_is_typed_and_it_is_judged_unsaved(tmp_path: Path) -> None:
    found = asyncio.run(typed(tmp_path))
    assert found == {"title": "Change the sign of b × a", "new": "-", "after": (), "on disk": TYPED}


SLOW = """import time, workbench.app.servers.desk as desk
desk.with_corrections = lambda judged, seconds, found: (time.sleep(8), found(), judged)[2]
from workbench.app.commands.commands import main
main(['lsp'])
"""


@asynccontextmanager
async def opened(code: str, folder: Path, text: str) -> AsyncIterator[OpenText]:
    """A language server run by the code, with the text opened and its first verdicts published."""
    client = client_module.BaseLanguageClient("test", "1")
    uri = (folder / "typed.tex").as_uri()
    own = OpenText(client, uri)

    @client.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    def on_diagnostics(params: types.PublishDiagnosticsParams) -> None:
        own.published.append(params.diagnostics)
        own.came.set()

    await client.start_io(sys.executable, "-c", code)
    await client.initialize_async(
        types.InitializeParams(types.ClientCapabilities(), root_uri=folder.as_uri())
    )
    client.initialized(types.InitializedParams())
    item = types.TextDocumentItem(uri, "latex", 1, text)
    client.text_document_did_open(types.DidOpenTextDocumentParams(item))
    await asyncio.wait_for(own.came.wait(), 60)
    yield own
    await client.shutdown_async(None)
    client.exit(None)
    await client.stop()


@dataclass
class OpenText:
    """A text that a client has opened, with the faults published for it."""

    client: Any
    uri: str
    published: list[list] = field(default_factory=list)
    came: asyncio.Event = field(default_factory=asyncio.Event)

    def correct(self) -> None:
        """Changes the text to one without a fault."""
        self.came.clear()
        right = types.TextDocumentContentChangeWholeDocument(TYPED.replace("= b", "= -b"))
        self.client.text_document_did_change(
            types.DidChangeTextDocumentParams(types.VersionedTextDocumentIdentifier(2, self.uri), [right])
        )

    async def no_fault(self) -> None:
        """Waits until no fault is published."""
        while self.published[-1]:
            self.came.clear()
            await asyncio.wait_for(self.came.wait(), 60)


async def while_searching(folder: Path) -> tuple[float, list]:
    """The seconds until a hover is answered during a long search, and the verdicts on the changed text."""
    (folder / "typed.tex").write_text(TYPED)
    async with opened(SLOW, folder, TYPED) as own:
        start = time.monotonic()
        own.correct()
        document = types.TextDocumentIdentifier(own.uri)
        await own.client.text_document_hover_async(types.HoverParams(document, types.Position(3, 6)))
        seconds = time.monotonic() - start
        await own.no_fault()
    return seconds, own.published[-1]


def test_hover_does_not_wait_for_a_search(tmp_path: Path) -> None:
    seconds, after = asyncio.run(while_searching(tmp_path))
    assert seconds < 6 and not after


HARD = """import time
from workbench.app.pipeline.judge_claims import ClaimJudge
judged = ClaimJudge._verdict_on
def slow(self, asked):
    time.sleep(40 * (self._claims[asked[0]].printed.latex.count("b + b") > 1))
    return judged(self, asked)
ClaimJudge._verdict_on = slow
from workbench.app.commands.commands import main
main(['lsp'])
"""
HARD_TEXT = TYPED + "\\[ b + b + b + b + b = 5 a + b \\]\n"


async def beside_a_hard_formula(folder: Path) -> tuple[list, float]:
    """The first verdicts on a text with a formula that takes long, and the seconds after its removal."""
    async with opened(HARD, folder, HARD_TEXT) as own:
        first = list(own.published[0])
        start = time.monotonic()
        own.correct()
        await own.no_fault()
        seconds = time.monotonic() - start
    return first, seconds


def test_first_verdicts_do_not_wait_for_a_hard_formula(tmp_path: Path) -> None:
    first, seconds = asyncio.run(beside_a_hard_formula(tmp_path))
    assert [each.code for each in first] == ["refuted"], "the other formula is judged for 40 s"
    assert seconds < 20, "a change ends the judging of the text before it"
