r"""Seconds from a keystroke in an editor to the mark under the formula, and of the processor, over standard
input and output: python tests/benchmarks/keystroke_to_mark.py TEXT OLD NEW [OLD NEW ...] --rounds 3

Each edit replaces the first OLD by NEW in the buffer, and back. The mark has come when the diagnostics of the
lines of the edit are those that the whole text has in the end. The processor is that of the server and of its
children.
"""

from __future__ import annotations

import argparse
import asyncio
import os
import statistics
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from time import monotonic

from lsprotocol import types
from pygls.lsp.client import BaseLanguageClient


def processor(process: int) -> float:
    """Returns the seconds of a process and of its children."""
    total = 0.0
    for each in (process, *_children(process)):
        fields = Path(f"/proc/{each}/stat").read_text().rpartition(")")[2].split()
        total += sum(map(int, fields[11:15])) / os.sysconf("SC_CLK_TCK")
    return total


def _children(process: int) -> list[int]:
    own = [int(each) for each in Path(f"/proc/{process}/task/{process}/children").read_text().split()]
    return [child for each in own for child in (each, *_children(each))]


def memory(process: int) -> float:
    """Returns the resident megabytes of a process."""
    line = next(e for e in Path(f"/proc/{process}/status").read_text().splitlines() if e.startswith("VmRSS"))
    return int(line.split()[1]) / 1024


def _lines(found: Sequence[types.Diagnostic], line: int) -> set[str]:
    return {each.message for each in found if each.range.start.line <= line <= each.range.end.line}


async def measured(path: Path, edits: Sequence[tuple[str, str]], rounds: int, quiet: float) -> None:
    client, text, version = BaseLanguageClient("keystrokes", "1"), path.read_text("utf-8"), 1
    told: list[tuple[float, float, list[types.Diagnostic]]] = []
    code = "from workbench.app.commands.commands import main; main(['lsp', '--no-motions'])"
    begun = monotonic()
    await client.start_io(sys.executable, "-c", code)
    server = client._server.pid

    @client.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    def on_diagnostics(params: types.PublishDiagnosticsParams) -> None:
        told.append((monotonic(), processor(server), list(params.diagnostics)))

    async def settled() -> None:
        while not told or monotonic() - told[-1][0] < quiet:
            await asyncio.sleep(0.05)

    await client.initialize_async(types.InitializeParams(types.ClientCapabilities()))
    client.initialized(types.InitializedParams())
    item = types.TextDocumentItem(path.as_uri(), "latex", version, text)
    client.text_document_did_open(types.DidOpenTextDocumentParams(item))
    await settled()
    print(f"start to first mark {told[0][0] - begun:.2f} s, to all {told[-1][0] - begun:.2f} s")
    seconds, used, ends = [], [], []
    steps = [step for old, new in edits for step in ((old, new), (new, old))] * rounds
    for old, new in steps:
        line = text[: text.index(old)].count("\n")
        text, version = text.replace(old, new, 1), version + 1
        told.clear()
        start, before = monotonic(), processor(server)
        place = types.VersionedTextDocumentIdentifier(version, path.as_uri())
        whole = types.TextDocumentContentChangeWholeDocument(text)
        client.text_document_did_change(types.DidChangeTextDocumentParams(place, [whole]))
        await settled()
        last = _lines(told[-1][2], line)
        first = len(told) - 1
        while first and _lines(told[first - 1][2], line) == last:
            first -= 1
        seconds.append(told[first][0] - start)
        used.append(told[first][1] - before)
        ends.append(told[-1][0] - start)
    for name, found in (("to the mark", seconds), ("processor to the mark", used), ("to all marks", ends)):
        print(f"{name}: median {statistics.median(found):.2f} s, {min(found):.2f} to {max(found):.2f} s")
    print(f"memory {memory(server):.0f} MB; {len(steps)} keystrokes")
    await client.shutdown_async(None)
    client.exit(None)
    await client.stop()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("text", type=Path)
    parser.add_argument("edits", nargs="+")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument(
        "--quiet", type=float, default=4.0, help="seconds without news after which all is told"
    )
    options = parser.parse_args()
    edits = list(zip(options.edits[::2], options.edits[1::2], strict=True))
    with tempfile.TemporaryDirectory() as folder:
        os.environ["WORKBENCH_CACHE"] = f"{folder}/cache"
        path = Path(folder, options.text.name)
        path.write_bytes(options.text.read_bytes())
        model = options.text.with_suffix(".toml")
        if model.exists():
            (Path(folder) / model.name).write_bytes(model.read_bytes())
        asyncio.run(measured(path, edits, options.rounds, options.quiet))


if __name__ == "__main__":
    main()
