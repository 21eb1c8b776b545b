"""`workbench mcp`: the workbench as tools for an assistant, by the Model Context Protocol."""

from __future__ import annotations

from dataclasses import replace
from importlib.metadata import version
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import click

from workbench.app.commands.options import Unusable
from workbench.app.servers.result_words import faults_in_words

if TYPE_CHECKING:
    from mcp.server.mcpserver import MCPServer

    from workbench.app.pipeline.judged_files import Judged
    from workbench.prover.results.claim_results import ClaimResult

_INSTRUCTIONS = """Judges the printed formulas of kinematics texts. Verdicts come from exact algebra, not from
you. Draft a model of a text with draft_model, correct its kinds, frames and definitions, and give it to
check_text. What you say in a model counts as guessed until the person confirms it: a falsehood that rests on
it is a warning. `settles` says what would decide a formula that is not judged."""


@click.command()
def mcp() -> None:
    """Serve an assistant: check_text, check_formula, draft_model, explain, propose_correction.

    Speaks the Model Context Protocol over standard input and output. Needs the extra mcp."""
    try:
        server = server_for_assistants()
    except ImportError:
        raise Unusable(
            "the server for assistants needs the extra mcp: pip install 'kinematics-workbench[mcp]'"
        ) from None
    server.run("stdio")


def server_for_assistants() -> MCPServer:
    """Returns the server. Raises ImportError without the SDK."""
    from mcp.server.mcpserver import MCPServer

    server = MCPServer("workbench", instructions=_INSTRUCTIONS, version=version("kinematics-workbench"))
    for tool in (check_text, check_formula, draft_model, explain, propose_correction):
        server.tool()(tool)
    return server


def check_text(text: str, model: str = "", suffix: str = ".tex") -> dict[str, Any]:
    """Judge every formula of a text. model: TOML with [symbols], [definitions], [frames] …; without it one is
    drafted. suffix: .tex, .md, .rst or .html."""
    with TemporaryDirectory(prefix="workbench-") as folder:
        return _answer(lambda: _checked_text(Path(folder), text, model, suffix))


def check_formula(
    latex: str, symbols: dict[str, str] | None = None, assume: list[str] | None = None
) -> dict[str, Any]:
    """Judge one formula. symbols: LaTeX → kind, such as {"a": "vector"}; kinds that are missing are inferred
    and named."""

    def judged() -> dict[str, Any]:
        from workbench.app.commands.try_formula import judged_formula

        lines, inferred = judged_formula(latex, symbols or {}, assume or ())
        return {"taken_as": inferred, "formulas": [_told(line.result) for line in lines]}

    return _answer(judged)


def draft_model(text: str, suffix: str = ".tex") -> dict[str, Any]:
    """Draft the model of a text: the kinds of its symbols, each with its reason, and what is asked."""

    def drafted() -> dict[str, Any]:
        from workbench.papers.drafting import ingest, meant, model_text
        from workbench.source.toml.file_bytes import within

        with TemporaryDirectory(prefix="workbench-") as folder, within(Path(folder)):
            path = _written(Path(folder), text, suffix)
            return {"model": model_text(meant(ingest(path)), path.with_suffix(".toml"))}

    return _answer(drafted)


def explain(topic: str) -> dict[str, Any]:
    """Explain a message code such as WB-…, or a topic of the manual."""

    def page() -> dict[str, Any]:
        from workbench.app.commands.commands import main
        from workbench.guide.generated import manual
        from workbench.guide.message_page import code_text
        from workbench.guide.pages import find_page

        found = find_page(topic, manual(main))
        text = code_text(topic) if found is None else found.text
        if text is None:
            raise ValueError(f"{topic!r}: expected a topic of the manual or a code, as in WB-SAME-TERM")
        return {"page": text}

    return _answer(page)


def propose_correction(latex: str, symbols: dict[str, str] | None = None) -> dict[str, Any]:
    """Search for the right form of one false formula; only proved forms are proposed."""

    def proposed() -> dict[str, Any]:
        from workbench.app.commands.try_formula import judged_formula
        from workbench.app.pipeline.judged_files import SEARCH_SECONDS
        from workbench.repair.propose.search_limits import Limits

        lines, inferred = judged_formula(latex, symbols or {}, ())
        found = [line.repair(Limits(seconds=SEARCH_SECONDS)).proposed() for line in lines]
        told = [[{"latex": each.latex, "edit": each.edit} for each in own] for own in found]
        return {"taken_as": inferred, "formulas": [_told(each.result) for each in lines], "proposed": told}

    return _answer(proposed)


def _checked_text(folder: Path, text: str, model: str, suffix: str) -> dict[str, Any]:
    from workbench.app.pipeline.judged_files import judged_file, with_corrections
    from workbench.papers.texts.text_paper import TextPaper
    from workbench.report.listing import listing

    path = _written(folder, text, suffix)
    if model:
        path.with_suffix(".toml").write_text(_with_source(model, path), encoding="utf-8")
    judged = judged_file(path, folder=folder)
    if model:
        judged = _as_guessed(judged)
    judged = with_corrections(judged)
    summary = listing(judged.paper, judged.results).summary if isinstance(judged.paper, TextPaper) else ""
    formulas = [_told(result) for result in judged.results]
    faults = faults_in_words((*judged.paper.faults, *getattr(judged.paper, "warnings", ())), path)
    return {"summary": summary, "formulas": formulas, "questions": _questions(judged), "not_read": faults}


def _questions(judged: Judged) -> list[dict[str, Any]]:
    """What only the author can answer, with the lines of a model that do."""
    from workbench.papers.drafting.questions_to_author import questions_about

    if judged.draft is None:
        return []
    return [
        {
            "question": question.text,
            "line": question.line,
            "settles": list(question.settles),
            "answers": ["\n".join(answer.lines) for answer in question.answers],
        }
        for question in questions_about(judged.draft, judged.results)
    ]


def _as_guessed(judged: Judged) -> Judged:
    """Returns the results with the confidence of guessed kinds, as an assistant wrote the model."""
    from workbench.core.verdict import Strength

    lowered = [
        replace(result, verdict=replace(result.verdict, basis=Strength.GUESSED)) for result in judged.results
    ]
    return replace(judged, results=lowered)


def _written(folder: Path, text: str, suffix: str) -> Path:
    from workbench.source.documents import SUFFIXES

    if suffix not in SUFFIXES:
        raise ValueError(f"suffix: expected one of {', '.join(sorted(SUFFIXES))}, got {suffix!r}")
    path = folder / f"text{suffix}"
    path.write_text(text, encoding="utf-8")
    return path


def _with_source(model: str, path: Path) -> str:
    lines = [line for line in model.splitlines() if not line.startswith("source")]
    return "\n".join([f"source = '{path.name}'", *lines]) + "\n"


def _told(result: ClaimResult) -> dict[str, Any]:
    from workbench.core.verdict import Grade
    from workbench.report.counterexamples import told

    claim, verdict = result.claim, result.verdict
    example = verdict.counterexample
    return {
        "id": claim.id,
        "latex": claim.printed.latex,
        "verdict": str(verdict.outcome),
        "grade": str(result.shown),
        "basis": str(verdict.basis),
        "read_as": verdict.read_back,
        "counterexample": str(told(example, claim.printed.latex)) if example else None,
        "holds_if": None if verdict.hypothesis is None else str(verdict.hypothesis),
        "unless": list(verdict.unless),
        "settles": str(verdict.reason) if result.shown is Grade.NOT_JUDGED else None,
        "because": str(verdict.reason) if verdict.reason else None,
        "corrections": [{"latex": each.latex, "edit": each.edit} for each in result.proposed or ()],
        "edits": [{"line": each.span.line, "old": each.old, "new": each.new} for each in result.edits],
    }


def _answer(work: Any) -> dict[str, Any]:
    """Returns the result of the work; errors of its input as `errors`."""
    try:
        answer: dict[str, Any] = work()
        return answer
    except (ValueError, LookupError) as error:
        faults = getattr(error, "faults", None)
        return {"errors": [str(error)] if faults is None else faults_in_words(faults, Path("text.tex"))}
