"""workbench check: the verdict on each claim of paper files, of texts, or of the models beside them."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from workbench.cli.judging import (
    engine_options,
    judged_papers,
    print_results,
    proposals_flag,
    write_atomically,
)
from workbench.cli.options import Unusable, json_text, print_json, reports_faults
from workbench.cli.repair import claims_with_proposals

if TYPE_CHECKING:
    from workbench.papers import Paper
    from workbench.report.findings import Finding
    from workbench.verify.claims import ClaimResult

FORMATS = ("text", "json", "github", "sarif", "rdjsonl")


@click.command()
@click.argument("files", nargs=-1, required=True, metavar="FILE...", type=click.Path(path_type=Path))
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
@click.option("--jobs", type=click.IntRange(1, 1000), help="Judge by so many processes.")
@click.option(
    "--scheduler", metavar="ADDRESS", help="Judge by the workers of Dask's scheduler, as in tcp://host:8786."
)
@click.option("--watch", is_flag=True, help="Stay, and judge again what changes.")
@engine_options
@proposals_flag
@reports_faults
def check(
    files: Sequence[Path],
    json_out: str | None,
    form: str,
    jobs: int | None,
    scheduler: str | None,
    watch: bool,
    proposals: bool,
    **engines: Any,
) -> None:
    """Judge paper files, texts (.tex, .md, .rst, .html, .ipynb) or the models beside them.

    Exit status: 0 if all verdicts are those that the claims expect, 1 if some are not, 2 if a file cannot be
    used, or nothing in it could be judged.
    """
    if watch:
        from workbench.cli.watch import watch_files

        if json_out is not None or form in ("json", "sarif") or scheduler:
            raise Unusable("--watch prints text, github or rdjsonl, and judges here")
        watch_files(files, form, **engines)
        return
    from workbench.papers import PaperError, load_paper

    papers: list[tuple[str, Paper]] = []
    unusable = False
    for file in dict.fromkeys(files):
        try:
            papers.append((str(file), load_paper(file, faults=[])))
        except PaperError as error:
            if len(files) == 1:
                raise
            click.echo(f"Error: {error}", err=True)
            unusable = True
    if not papers:
        sys.exit(2)
    found = judged_papers(papers, jobs, scheduler, **engines)
    judged = [(paper, results) for (_, paper), results in zip(papers, found, strict=True)]
    print_judged(judged, json_out, form, proposals)
    sys.exit(max([_status(paper, results) for paper, results in judged], default=2) if not unusable else 2)


def print_judged(
    judged: Sequence[tuple[Paper, Sequence[ClaimResult]]], json_out: str | None, form: str, proposals: bool
) -> None:
    from workbench.verify.results import report_dict

    if form in ("github", "sarif", "rdjsonl"):
        _print_findings(judged, form)
        return
    reports = []
    for paper, results in judged:
        data = report_dict(paper, results)
        data["claims"] = claims_with_proposals(data["claims"], results, proposals)
        reports.append(data)
        if form != "json" and json_out != "-":
            if len(judged) > 1:
                click.echo(f"{paper.paths[0]}:")
            _print_text(paper, results, data)
    if form == "json" or json_out is not None:
        told = [data | _faults_dict(paper) for (paper, _), data in zip(judged, reports, strict=True)]
        shown = told[0] if len(told) == 1 else told
        if form == "json" or json_out == "-":
            print_json(shown)
        else:
            write_atomically(Path(json_out), json_text(shown))


def _status(paper: Paper, results: Sequence[ClaimResult]) -> int:
    from workbench.judge.verdict import Outcome
    from workbench.papers.text_paper import TextPaper

    is_text = isinstance(paper, TextPaper)
    if is_text and all(result.verdict.outcome is Outcome.UNCHECKED for result in results):
        return 2
    return 0 if all(result.passed for result in results) and not paper.faults else 1


def _print_findings(judged: Sequence[tuple[Paper, Sequence[ClaimResult]]], form: str) -> None:
    from workbench.cli.carets import lines_of
    from workbench.report.findings import findings, github, rdjsonl, sarif
    from workbench.verify.results import report_dict

    found = [finding for paper, results in judged for finding in findings(paper, results)]
    if form == "github":
        click.echo(github(found), nl=False)
    elif form == "sarif":
        print_json(sarif(found, report_dict(judged[0][0], ())["versions"]["workbench"]))
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
        if (hint := _hint(paper, results)) is not None:
            terminal.print(hint, markup=False)
    else:
        for fault in paper.faults:
            click.echo(f"Error: {fault}", err=True)
        print_results(paper, results, False)
    for claim in data["claims"]:
        for line in repair_lines(claim, terminal.is_terminal) if claim["proposed"] else ():
            terminal.print(line)


def _hint(paper: Paper, results: Sequence[ClaimResult]) -> str | None:
    """What a text without a model needs, where symbols are unknown."""
    unknown = sum("unknown symbol" in (result.claim.printed.unread or "") for result in results)
    if len(paper.paths) > 1 or not unknown:
        return None
    name = paper.paths[0]
    return (
        f"{unknown} of {len(results)} steps use symbols that nothing declares: `workbench ingest {name}`"
        " writes a model with guessed kinds beside it; until then, none is guessed"
    )


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

    kinds = [("faults", paper.faults)]
    if isinstance(paper, TextPaper):
        kinds.append(("warnings", paper.warnings))
    elif not paper.faults:
        return {}
    return {
        key: [{"file": str(e.file), "line": e.line, "column": e.column, "message": e.message} for e in errors]
        for key, errors in kinds
    }
