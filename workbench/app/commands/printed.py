"""The output of `workbench check`: for people, as JSON, or for CI."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from workbench.app.commands.ask import print_questions
from workbench.app.commands.judging_options import print_faults, print_results, write_atomically
from workbench.app.commands.options import json_text, print_json
from workbench.core.code_labels import label_of
from workbench.report.counts import versions
from workbench.report.to_json import report_json

if TYPE_CHECKING:
    from workbench.app.pipeline.judged_files import Judged
    from workbench.papers import Paper, PaperError
    from workbench.papers.texts.text_paper import TextPaper
    from workbench.prover.results.claim_results import ClaimResult


def print_judged(
    judged: Sequence[Judged],
    json_out: str | None,
    form: str,
    unusable: Sequence[PaperError] = (),
    quiet: bool = False,
    verbose: bool = False,
    asks: bool = True,
) -> None:
    """Prints the results.

    unusable: the faults of papers of which nothing could be judged.
    quiet, verbose: how much of a text's listing is printed.
    asks: whether the questions of drafts are printed.
    """
    if form in ("github", "sarif", "rdjsonl"):
        _print_findings(judged, unusable, form)
        return
    print_faults(unusable)
    if form == "json" or json_out is not None:
        told = [report_json(each.paper, each.results) | _faults_json(each.paper) for each in judged]
        told += [{"faults": [_fault_json(fault) for fault in unusable]}] if unusable else []
        text = json_text(told[0] if len(told) == 1 else told)
        if form == "json" or json_out is None or json_out == "-":
            click.echo(text, nl=False)
            return
        write_atomically(Path(json_out), text)
    for each in judged:
        print_for_people(each, quiet, verbose, asks and json_out is None, json_out is None, len(judged) > 1)


def print_for_people(
    judged: Judged,
    quiet: bool = False,
    verbose: bool = False,
    asks: bool = True,
    tells_draft: bool = True,
    is_one_of_many: bool = False,
) -> None:
    """Prints the results of one paper: the listing of a text, or the table of a paper file.

    asks: whether the questions of a draft are printed.
    tells_draft: whether it is said that a model was drafted.
    """
    if judged.draft is not None and tells_draft:
        click.echo(judged.draft.summary)
    _print_text(judged.paper, judged.results, quiet, verbose, is_one_of_many)
    if judged.draft is not None and asks:
        print_questions(judged.draft, judged.results)


def _print_findings(judged: Sequence[Judged], unusable: Sequence[PaperError], form: str) -> None:
    from workbench.app.commands.carets import lines_of
    from workbench.report.findings import fault_finding, findings, github, rdjsonl, sarif

    found = [fault_finding(fault, Path()) for fault in unusable]
    found += [finding for each in judged for finding in findings(each.paper, each.results)]
    if form == "github":
        click.echo(github(found), nl=False)
    elif form == "sarif":
        print_json(sarif(found, versions()["workbench"]))
    else:
        files = {each.span.file for each in found}
        click.echo(rdjsonl(found, {path: lines_of(path) for path in files}), nl=False)


def _print_text(
    paper: Paper, results: Sequence[ClaimResult], quiet: bool, verbose: bool, is_one_of_many: bool
) -> None:
    from workbench.app.commands.proposal_text import proposed_lines
    from workbench.app.commands.terminal import console
    from workbench.papers.texts.text_paper import TextPaper

    terminal = console(sys.stdout)
    if isinstance(paper, TextPaper):
        _print_listing(paper, results, quiet, verbose)
        return
    if is_one_of_many:
        click.echo(f"{paper.paths[0]}:")
    print_faults(paper.faults)
    print_results(paper, results, False)
    for result in results:
        if result.proposed:
            for line in proposed_lines(result.claim, result.proposed, terminal.is_terminal):
                terminal.print(line)


def _print_listing(paper: TextPaper, results: Sequence[ClaimResult], quiet: bool, verbose: bool) -> None:
    from workbench.app.commands.carets import printable
    from workbench.app.commands.listing_text import in_ascii, listing_lines
    from workbench.app.commands.terminal import console
    from workbench.report.listing import listing

    terminal = console(sys.stdout)
    print_faults(paper.faults)
    for warning in paper.warnings:
        click.echo(printable(f"warning: {warning}"), err=True)
    is_ascii = not _writes(sys.stdout, "✗…·")
    for line in listing_lines(listing(paper, results), quiet, verbose):
        if is_ascii:
            line = line.copy()
            line.plain = in_ascii(line.plain)
        terminal.print(line, soft_wrap=True)


def _writes(stream: Any, characters: str) -> bool:
    """True if the stream's encoding has the characters."""
    try:
        characters.encode(getattr(stream, "encoding", None) or "utf-8")
    except UnicodeEncodeError:
        return False
    return True


def _faults_json(paper: Paper) -> dict[str, Any]:
    from workbench.papers.texts.text_paper import TextPaper

    kinds = [("faults", paper.faults)]
    if isinstance(paper, TextPaper):
        kinds.append(("warnings", paper.warnings))
    elif not paper.faults:
        return {}
    return {key: [_fault_json(error) for error in errors] for key, errors in kinds}


def _fault_json(error: PaperError) -> dict[str, Any]:
    place = {"file": str(error.file), "line": error.line, "column": error.column}
    return {**place, "message": error.message, "code": label_of(error.reason)}
