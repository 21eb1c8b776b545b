"""`workbench mcp` as an assistant meets it: the SDK's client over standard input and output."""

from __future__ import annotations

import asyncio
import json
import sys
from pathlib import Path
from typing import Any

import pytest

from workbench.app.servers.mcp import check_text, draft_model, propose_correction

mcp = pytest.importorskip("mcp")
stdio = pytest.importorskip("mcp.client.stdio")

TEXT = r"""\begin{document}
Let $\mathbf{a}$ and $\mathbf{b}$ be vectors.
\begin{equation} \mathbf{a} \times \mathbf{b} = \mathbf{b} \times \mathbf{a} \end{equation}
\end{document}
"""
MODEL = """[symbols]
'\\mathbf{a}' = { kind = "vector" }
'\\mathbf{b}' = { kind = "vector" }
"""


async def session(*calls: tuple[str, dict[str, Any]]) -> tuple[set[str], list[dict[str, Any]]]:
    code = "from workbench.app.commands.commands import main; main(['mcp'])"
    server = stdio.StdioServerParameters(command=sys.executable, args=["-c", code])
    async with stdio.stdio_client(server) as (read, write), mcp.ClientSession(read, write) as client:
        await client.initialize()
        names = {tool.name for tool in (await client.list_tools()).tools}
        answers = []
        for name, arguments in calls:
            found = await client.call_tool(name, arguments)
            answers.append(json.loads(found.content[0].text))
        return names, answers


def test_assistant_drafts_checks_and_corrects() -> None:
    names, (drafted, checked, formula, page, proposed, bad) = asyncio.run(
        session(
            ("draft_model", {"text": TEXT}),
            ("check_text", {"text": TEXT, "model": MODEL}),
            ("check_formula", {"latex": r"$a × b = b × a$", "symbols": {"a": "vector", "b": "vector"}}),
            ("explain", {"topic": "WB-SAME-TERM"}),
            ("propose_correction", {"latex": r"a \times b = b \times a", "symbols": {"a": "vector", "b": "vector"}}),
            ("check_formula", {"latex": r"a = \foo{b}"}),
        )
    )  # fmt: skip
    assert names == {"check_text", "check_formula", "draft_model", "explain", "propose_correction"}
    assert "vector" in drafted["model"]
    (claim,) = checked["formulas"]
    assert (claim["verdict"], claim["grade"], claim["basis"]) == ("refuted", "warning", "guessed")
    assert claim["counterexample"] and claim["edits"][0]["new"] == "-"
    assert formula["formulas"][0]["grade"] == "error"
    assert "same term" in page["page"]
    assert proposed["proposed"][0][0]["latex"] == r"a \times b = -b \times a"
    assert "\\foo" in bad["formulas"][0]["because"]


def test_assistant_reads_no_file_of_the_machine(tmp_path: Path) -> None:
    (tmp_path / "secret.tex").write_text(r"\[ \mathbf{s} = \mathbf{s} + \mathbf{s} \]")
    text = TEXT.replace("Let", f"\\input{{{tmp_path}/secret}} Let")
    assert len(check_text(text)["formulas"]) == 1
    assert "mathbf{s}" not in draft_model(text)["model"]
    answer = check_text(TEXT, f"macros = '{tmp_path}/secret.tex'\n" + MODEL)
    assert "outside of the folder" in answer["errors"][0]


@pytest.mark.parametrize(
    ("text", "model", "told"),
    [
        ("no formula", "", "text.tex: no displayed equation in it"),
        (TEXT, "[symbols", "text.toml, line 2: not TOML"),
        (TEXT, "[symbols]\n'a' = { kind = 'spinor' }\n", "text.toml, line 3: a: kind is 'spinor'"),
    ],
)
def test_errors_name_no_folder_of_the_server(text: str, model: str, told: str) -> None:
    (error,) = check_text(text, model)["errors"]
    assert error.startswith(told)


def test_assistant_is_told_what_is_not_read() -> None:
    (told,) = check_text(TEXT.replace("Let", "\\input{other} Let"))["not_read"]
    assert told.startswith("line 2") and "other" in told


def test_no_correction_without_a_verdict() -> None:
    answer = propose_correction(r"a \times")
    assert answer["proposed"] == [[]] and "cannot be read" in answer["formulas"][0]["because"]


def test_assistant_gets_the_questions_of_a_draft() -> None:
    text = "\\[ 2 a + a = 3 a \\]\n\\[ \\mathbf{f} \\times a = 2 \\mathbf{f} \\times a \\]\n"
    answer = check_text(text)
    (question,) = answer["questions"]
    assert question["question"] == "What is a?" and question["settles"] == ["L2"]
    assert question["answers"][0] == "[symbols]\n'a' = \"vector\""
    assert [each["grade"] for each in answer["formulas"]] == ["ok", "not judged"]
