"""workbench check: the verdict on each claim of a paper file, of a text, or of the model beside one."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from workbench.cli.judging import engine_options, judged, print_results, proposals_flag, write_atomically
from workbench.cli.options import json_text, print_json, reports_faults
from workbench.cli.repair import claims_with_proposals

if TYPE_CHECKING:
    from workbench.papers import Paper
    from workbench.report.findings import Finding
    from workbench.verify.claims import ClaimResult

FORMATS = ("text", "json", "github", "sarif", "rdjsonl")


@click.command()
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "--json",
    "json_out",
    is_flag=False,
    flag_value="-",
    metavar="OUT",
    help="Write the report as JSON to OUT (standard output if OUT is - or missing).",
)
@click.option(
    "--format",
    "form",
    type=click.Choice(FORMATS),
    default="text",
    show_default=True,
    help="How the faults are printed: for people, or for what runs the check.",
)
@engine_options
@proposals_flag
@reports_faults
def check(file: Path, json_out: str | None, form: str, proposals: bool, **engines: Any) -> None:
    """Judge a paper file, a text (.tex, .md, .rst, .html, .ipynb) or the model beside one.

    Exit status: 0 if all verdicts are those that the claims expect, 1 if some are not, 2 if the file cannot
    be used, or nothing in a text could be judged.
    """
    from workbench.papers import load_paper
    from workbench.verify.results import report_dict

    paper = load_paper(file)
    results = judged(paper, (), **engines)
    if form in ("github", "sarif", "rdjsonl"):
        _print_findings(paper, results, form)
        sys.exit(_status(paper, results))
    data = report_dict(paper, results)
    data["claims"] = claims_with_proposals(data["claims"], results, proposals)
    if form == "json" or json_out is not None:
        data |= _faults_dict(paper)
    if form == "json" or json_out == "-":
        print_json(data)
    else:
        if json_out is not None:
            write_atomically(Path(json_out), json_text(data))
        _print_text(paper, results, data)
    sys.exit(_status(paper, results))


def _status(paper: Paper, results: Sequence[ClaimResult]) -> int:
    from workbench.judge.verdict import Outcome
    from workbench.papers.text_paper import TextPaper

    if not isinstance(paper, TextPaper):
        return 0 if all(result.passed for result in results) else 1
    if all(result.verdict.outcome is Outcome.UNCHECKED for result in results):
        return 2
    return 0 if all(result.passed for result in results) and not paper.faults else 1


def _print_findings(paper: Paper, results: Sequence[ClaimResult], form: str) -> None:
    from workbench.cli.carets import lines_of
    from workbench.report.findings import findings, github, rdjsonl, sarif
    from workbench.verify.results import report_dict

    found = findings(paper, results)
    if form == "github":
        click.echo(github(found), nl=False)
    elif form == "sarif":
        print_json(sarif(found, report_dict(paper, ())["versions"]["workbench"]))
    else:
        files = {each.span.file for each in found}
        click.echo(rdjsonl(found, {path: lines_of(path) for path in files}), nl=False)


def _print_text(paper: Paper, results: Sequence[ClaimResult], data: dict[str, Any]) -> None:
    from workbench.cli.proposals import repair_lines
    from workbench.cli.terminal import console, summary_line
    from workbench.papers.text_paper import TextPaper

    terminal = console(sys.stdout)
    if isinstance(paper, TextPaper):
        _print_places(paper, results)
        terminal.print(summary_line(results))
    else:
        print_results(paper, results, False)
    for claim in data["claims"]:
        for line in repair_lines(claim, terminal.is_terminal) if claim["proposed"] else ():
            terminal.print(line)


def _print_places(paper: Paper, results: Sequence[ClaimResult]) -> None:
    from workbench.cli.carets import finding_lines, lines_of
    from workbench.cli.terminal import console
    from workbench.report.findings import findings

    terminal = console(sys.stdout)
    found: Sequence[Finding] = findings(paper, results)
    lines = {path: lines_of(path) for path in {each.span.file for each in found}}
    for each in found:
        for line in finding_lines(each, lines[each.span.file]):
            terminal.print(line)


def _faults_dict(paper: Paper) -> dict[str, Any]:
    from workbench.papers.text_paper import TextPaper

    if not isinstance(paper, TextPaper):
        return {}
    return {
        key: [{"file": str(e.file), "line": e.line, "column": e.column, "message": e.message} for e in errors]
        for key, errors in (("faults", paper.faults), ("warnings", paper.warnings))
    }
