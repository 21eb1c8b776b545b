"""workbench check: the verdict on each claim of paper files, of texts, or of the models beside them."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import click

from workbench.app.commands.ask import print_questions
from workbench.app.commands.judging_options import engine_options, judged_papers, proposals_flag
from workbench.app.commands.options import Unusable, memory_of_verdicts, reports_faults
from workbench.app.commands.printed import print_judged

if TYPE_CHECKING:
    from workbench.papers import Paper, PaperError
    from workbench.papers.drafting.judged_draft import Draft
    from workbench.prover.results.claim_results import ClaimResult
    from workbench.source.documents.source_edits import SourceEdit

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
@click.option(
    "--report",
    "report_out",
    type=click.Path(path_type=Path),
    metavar="OUT",
    help="Write the report of the one FILE into the directory OUT, too.",
)
@click.option("--watch", is_flag=True, help="Stay, and judge again what changes.")
@engine_options
@proposals_flag
@click.option(
    "--repair-seconds",
    type=click.FloatRange(min=0, min_open=True),
    default=5.0,
    show_default=True,
    help="The limit on time for the search for one correction; the verdicts do not wait for it.",
)
@click.option("--fix", is_flag=True, help="Make the proved corrections in the texts, if you agree.")
@click.option("--diff", is_flag=True, help="Print the proved corrections for `patch`, and nothing else.")
@click.option("--quiet", "-q", is_flag=True, help="Print errors only, one line each.")
@click.option("--verbose", "-v", is_flag=True, help="Print every display, too.")
@click.option("--ask", is_flag=True, help="Ask what a draft leaves open; the answers go into the model.")
@click.option("--strict", is_flag=True, help="Let a warning count as an error in the exit status.")
@reports_faults
def check(
    files: Sequence[Path],
    json_out: str | None,
    form: str,
    jobs: int | None,
    scheduler: str | None,
    report_out: Path | None,
    watch: bool,
    proposals: bool,
    ask: bool,
    repair_seconds: float,
    strict: bool,
    fix: bool,
    diff: bool,
    quiet: bool,
    verbose: bool,
    **engines: Any,
) -> None:
    """Judge paper files, texts (.tex, .md, .rst, .html, .ipynb) or the models beside them; - is a TeX text on
    standard input.

    Exit status: 0 without an error (with --strict: without an error or a warning), 1 with one, 2 if a file
    cannot be used, or nothing in it could be judged. A claim whose verdict is not the one that its keys
    announce is an error; what is unchecked in a text is none.
    """
    if fix and (json_out is not None or form != "text" or diff):
        raise Unusable("--fix: prints text and asks; expected no --diff, --json or --format")
    if Path("-") in files and (fix or watch):
        raise Unusable("-: standard input cannot be corrected or watched; expected a file")
    if report_out is not None and (watch or len(files) > 1):
        raise Unusable("--report: expected one FILE and no --watch: a report is of one text")
    if watch:
        from workbench.app.servers.watch import watch_files

        if json_out is not None or form in ("json", "sarif") or scheduler:
            raise Unusable("--watch prints text, github or rdjsonl, and judges here")
        watch_files(files, form, jobs, **engines)
        return
    from workbench.app.commands.fix import diff_of, proved_edits
    from workbench.app.commands.judging_options import print_faults
    from workbench.app.commands.repair_commands import with_proposals
    from workbench.papers import PaperError, load_paper
    from workbench.papers.drafting.judged_draft import draft_of, needs_draft, on_drafted_kinds

    drafts: dict[int, Draft] = {}
    papers: list[tuple[str, Paper]] = []
    unusable: list[PaperError] = []
    with memory_of_verdicts(engines["cache"]) as memory:
        for file in dict.fromkeys(map(_read_from, files)):
            try:
                paper = load_paper(file, faults=[], store=memory)
                if needs_draft(paper):
                    drafts[len(papers)] = draft = draft_of(file)
                    paper = draft.paper
                papers.append((str(file), paper))
            except PaperError as error:
                unusable += error.faults
    found = judged_papers(papers, jobs, scheduler, **engines)
    judged = [
        (paper, on_drafted_kinds(drafts[place], results) if place in drafts else results)
        for place, ((_, paper), results) in enumerate(zip(papers, found, strict=True))
    ]
    if ask and form == "text" and json_out is None:
        judged = _asked(judged, drafts, engines)
    if form == "text" and json_out is None and not diff:
        for draft in drafts.values():
            click.echo(draft.summary)
    wanted, cache = proposals or fix or diff, engines["cache"]
    judged = [
        (paper, with_proposals(results, wanted, cache, False, paper, repair_seconds))
        for paper, results in judged
    ]
    if report_out is not None and judged:
        _write_report(*judged[0], report_out)
    edits = proved_edits([result for _, results in judged for result in results])
    if diff:
        print_faults(unusable)
        click.echo(diff_of(edits), nl=False)
    else:
        print_judged(judged, json_out, form, unusable, quiet, verbose)
        if form == "text" and json_out is None and not (quiet or ask):
            for place, draft in drafts.items():
                print_questions(draft, judged[place][1])
    if fix and _fixed(edits):
        context = click.get_current_context()
        context.invoke(check, **{**context.params, "fix": False})
    sys.exit(
        max([_status(paper, results, strict) for paper, results in judged], default=2) if not unusable else 2
    )


def _read_from(file: Path) -> Path:
    """The file itself, or, for -, a copy of standard input, which lasts as long as the command."""
    if str(file) != "-":
        return file
    context = click.get_current_context()
    folder = context.with_resource(TemporaryDirectory(prefix="workbench-"))
    path = Path(folder) / "standard-input.tex"
    path.write_bytes(sys.stdin.buffer.read())
    return path


def _write_report(paper: Paper, results: Sequence[ClaimResult], out: Path) -> None:
    from workbench.certificates.certify import with_certificates
    from workbench.report.render import write_report

    for path in write_report(paper, with_certificates(results, paper), out):
        click.echo(str(path), err=True)


def _fixed(edits: dict[Path, list[SourceEdit]]) -> bool:
    """Makes the corrections, if they are confirmed; whether any was made."""
    from workbench.app.commands.fix import confirmed, write_fixes

    if not edits:
        click.echo("nothing to correct: no proved correction of an error or a warning")
        return False
    if not confirmed(edits):
        return False
    count = write_fixes(edits)
    click.echo(f"{count} correction{'' if count == 1 else 's'} made; judging again")
    return True


def _asked(
    judged: list[tuple[Paper, list[ClaimResult]]], drafts: dict[int, Draft], engines: dict[str, Any]
) -> list[tuple[Paper, list[ClaimResult]]]:
    """Returns the results after the author has answered."""
    from workbench.app.commands.ask import ask
    from workbench.papers.drafting.judged_draft import on_drafted_kinds

    made = list(judged)
    for place, before in drafts.items():
        if (draft := ask(before, judged[place][1])) is not None:
            (results,) = judged_papers([(str(draft.paper.paths[0]), draft.paper)], None, None, **engines)
            made[place] = (draft.paper, on_drafted_kinds(draft, results))
            drafts[place] = draft
    return made


def _status(paper: Paper, results: Sequence[ClaimResult], strict: bool) -> int:
    from workbench.core.verdict import Grade, Outcome
    from workbench.papers.texts.text_paper import TextPaper

    is_text = isinstance(paper, TextPaper)
    if is_text and all(result.verdict.outcome is Outcome.UNCHECKED for result in results):
        return 2
    faults = {Grade.ERROR, Grade.WARNING} if strict else {Grade.ERROR}
    return 1 if paper.faults or any(result.shown in faults for result in results) else 0
