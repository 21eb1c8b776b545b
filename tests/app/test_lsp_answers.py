"""What the editor offers beside verdicts: answers to questions, the drafted model, keys of models."""

from __future__ import annotations

import asyncio
import sys
from pathlib import Path

import pytest

pytest.importorskip("pygls")
from lsprotocol import types
from pygls.lsp.client import BaseLanguageClient

from workbench.app.servers.key_completion import completions

TEXT = "\\[ 2 a + a = 3 a \\]\n\\[ \\mathbf{f} \\times a = 2 \\mathbf{f} \\times a \\]\n"


async def session(folder: Path) -> dict[str, object]:
    client = BaseLanguageClient("test", "1")
    published: list[list] = []
    came = asyncio.Event()

    @client.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    def on_diagnostics(params: types.PublishDiagnosticsParams) -> None:
        published.append(params.diagnostics)
        came.set()

    @client.feature(types.WINDOW_SHOW_MESSAGE)
    def on_message(params: types.ShowMessageParams) -> None:
        found["message"] = params.message

    async def judged() -> list:
        await asyncio.wait_for(came.wait(), 60)
        came.clear()
        return published[-1]

    found: dict[str, object] = {}
    await client.start_io(
        sys.executable, "-c", "from workbench.app.commands.commands import main; main(['lsp'])"
    )
    await client.initialize_async(
        types.InitializeParams(types.ClientCapabilities(), root_uri=folder.as_uri())
    )
    client.initialized(types.InitializedParams())
    uri = (folder / "p.tex").as_uri()
    (folder / "p.tex").write_text(TEXT)
    place = types.TextDocumentIdentifier(uri)
    client.text_document_did_open(
        types.DidOpenTextDocumentParams(types.TextDocumentItem(uri, "latex", 1, TEXT))
    )
    await judged()
    while not (lenses := await client.text_document_code_lens_async(types.CodeLensParams(place))):
        await judged()
    found["lenses"] = lenses
    nothing = types.CodeActionContext([])

    async def actions(line: int) -> list:
        where = types.Range(types.Position(line, 0), types.Position(line, 9))
        return list(
            await client.text_document_code_action_async(types.CodeActionParams(place, where, nothing))
        )

    found["elsewhere"] = await actions(0)
    found["actions"] = [each.title for each in await actions(1)]
    # pygls's own client takes such an action for a bare command, whose name is then the whole of it
    found["command"] = str((await actions(1))[0].command)
    answer = [uri, "symbols", "'a'", '"vector"']
    await client.workspace_execute_command_async(types.ExecuteCommandParams("workbench.answer", answer))
    while not any(each.severity == types.DiagnosticSeverity.Warning for each in published[-1]):
        await judged()
    found["settled"] = await actions(1)
    await client.workspace_execute_command_async(types.ExecuteCommandParams("workbench.writeModel", [uri]))
    model = types.TextDocumentItem(
        (folder / "q.toml").as_uri(), "toml", 1, 'source = "p.tex"\n[symbols]\n𝒳 = { k'
    )
    client.text_document_did_open(types.DidOpenTextDocumentParams(model))
    at = types.CompletionParams(types.TextDocumentIdentifier(model.uri), types.Position(2, 9))
    found["keys"] = await client.text_document_completion_async(at)
    await client.shutdown_async(None)
    client.exit(None)
    await client.stop()
    return found


def test_an_editor_answers_writes_the_model_and_completes_keys(tmp_path: Path) -> None:
    found = asyncio.run(session(tmp_path))
    summary, write = (each.command for each in found["lenses"])
    assert summary.title == "no error found; 1 not judged, 1 holds"
    assert "workbench.answer" in found["command"] and "symbols" in found["command"]
    assert found["elsewhere"] == [] and found["settled"] == []
    assert found["actions"][0] == 'What is a? "vector" (decides 1 formula)'
    assert write.title == "write the drafted model to p.toml"
    assert found["message"].startswith("the model is ") and (tmp_path / "p.toml").exists()
    keys = {each.label: each.documentation for each in found["keys"]}
    assert {"kind", "unit", "constant"} <= keys.keys() and "vector" in keys["kind"]


MODEL = [
    'source = "p.tex"',
    "",
    "[conventions]",
    "",
    "[symbols]",
    "'a' = { kind = \"vector\", ",
    "",
    "[[claim]]",
    "",
]


@pytest.mark.parametrize(
    "lines,line,column,some,none",
    [
        (MODEL, 1, 0, {"symbols", "macros", "guessed"}, {"at"}),
        (MODEL, 3, 0, {"quaternion", "gradient"}, {"kind"}),
        (MODEL, 6, 0, set(), {"kind"}),
        (MODEL, 5, 26, {"unit", "constant"}, {"at"}),
        (MODEL, 8, 0, {"at", "given", "skip"}, {"printed_by", "kind"}),
        ([""], 0, 0, {"symbols", "claim"}, {"guessed"}),
        (["[[claim]]", ""], 1, 0, {"id", "printed"}, {"at"}),
        (["[conventions]", "quaternion = "], 1, 13, {'"hamilton, scalar first"'}, {"quaternion"}),
        (["% text", "%! workbench: "], 1, 14, {"symbols", "conventions"}, {"claim"}),
        (["# note "], 0, 7, set(), {"symbols"}),
        (["[unheard]", ""], 1, 0, set(), {"symbols"}),
        (["x"], 5, 0, {"symbols"}, set()),
    ],
)  # fmt: skip
def test_keys_are_those_of_the_table(
    lines: list[str], line: int, column: int, some: set[str], none: set[str]
) -> None:
    found = {name for name, _ in completions(lines, line, column)}
    assert some <= found and not none & found
