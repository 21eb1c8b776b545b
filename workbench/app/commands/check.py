"""`workbench check`: judges the claims of paper files, of texts, or of the models of texts."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import click

from workbench.app.commands.baselines import KnownFindings, written_baseline
from workbench.app.commands.judging_options import (
    engine_options,
    judged_claims,
    judged_files,
    print_faults,
    proposals_flag,
)
from workbench.app.commands.options import Unusable, reports_faults
from workbench.app.commands.printed import print_for_people, print_judged
from workbench.app.pipeline.judged_files import Judged, Loaded
from workbench.core.paper_errors import NoDisplay

if TYPE_CHECKING:
    from workbench.papers import PaperError
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
@click.option(
    "--baseline",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Report only what this file of known findings does not list.",
)
@click.option(
    "--write-baseline",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Write all that is wrong into a file of known findings.",
)
@click.option("--since", metavar="REV", help="Report only what was not wrong in this git revision.")
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
    baseline: Path | None,
    write_baseline: Path | None,
    since: str | None,
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
    """Judge paper files, texts (.tex, .md, .rst, .html, .ipynb) or their models; - is a TeX text on standard
    input.

    Exit status: 0 without an error (with --strict: without an error or a warning), 1 with one, 2 if a file
    cannot be used, or nothing in it could be judged. A claim with another verdict than its keys expect is an
    error; an unchecked claim of a text is not.
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
        if baseline or write_baseline or since:
            raise Unusable("--watch: expected no --baseline, --write-baseline or --since")
        watch_files(_texts(files), form, jobs, **engines)
        return
    from workbench.app.commands.fix import diff_of, proved_edits

    unusable: list[PaperError] = []
    texts = _texts(files)
    known = KnownFindings(baseline, since)
    is_text = form == "text" and json_out is None
    shows_at_once = is_text and not (diff or write_baseline)
    asks = not (quiet or ask)
    found: list[Judged] = []
    judged: list[Judged] = []
    for each in judged_files(texts, unusable, jobs, scheduler, **engines):
        if ask and is_text:
            each = _asked(each, engines)
        found.append(each)
        each = _corrected(known.marked(each), proposals or fix or diff, engines["cache"], repair_seconds)
        judged.append(each)
        if shows_at_once:
            print_for_people(each, quiet, verbose, asks, is_one_of_many=len(texts) > 1)
    unusable = [fault for fault in unusable if not (isinstance(fault, NoDisplay) and _is_found(fault, files))]
    known.tell_stale()
    if write_baseline is not None:
        judged = written_baseline(found, judged, write_baseline)
    if report_out is not None and judged:
        _write_report(judged[0], report_out)
    edits = proved_edits([result for each in judged for result in each.results])
    if shows_at_once or diff:
        print_faults(unusable)
        click.echo(diff_of(edits) if diff else "", nl=False)
    else:
        print_judged(judged, json_out, form, unusable, quiet, verbose, asks)
    if fix and _fixed(edits):
        context = click.get_current_context()
        context.invoke(check, **{**context.params, "fix": False})
    sys.exit(max([_status(each, strict) for each in judged], default=2) if not unusable else 2)


def _texts(files: Sequence[Path]) -> list[Path]:
    """Returns the files, with the texts of each folder in its place. Raises PaperError."""
    from workbench.source.documents import texts_in

    return list(
        dict.fromkeys(
            text for file in files for text in (texts_in(file) if file.is_dir() else [_read_from(file)])
        )
    )


def _is_found(fault: PaperError, files: Sequence[Path]) -> bool:
    """True if the file of the fault was not named, but found in a folder."""
    return any(folder in Path(fault.file or "").parents for folder in files if folder.is_dir())


def _read_from(file: Path) -> Path:
    """Returns the file, or, for -, a temporary copy of standard input."""
    if str(file) != "-":
        return file
    context = click.get_current_context()
    folder = context.with_resource(TemporaryDirectory(prefix="workbench-"))
    path = Path(folder) / "standard-input.tex"
    path.write_bytes(sys.stdin.buffer.read())
    return path


def _write_report(judged: Judged, out: Path) -> None:
    from workbench.certificates.certify import with_certificates
    from workbench.report.render import write_report

    for path in write_report(judged.paper, with_certificates(judged.results, judged.paper), out):
        click.echo(str(path), err=True)


def _fixed(edits: dict[Path, list[SourceEdit]]) -> bool:
    """Applies the corrections if they are confirmed, and returns whether any was made."""
    from workbench.app.commands.fix import confirmed, write_fixes

    if not edits:
        click.echo("nothing to correct: no proved correction of an error or a warning")
        return False
    if not confirmed(edits):
        return False
    count = write_fixes(edits)
    click.echo(f"{count} correction{'' if count == 1 else 's'} made; judging again")
    return True


def _asked(judged: Judged, engines: dict[str, Any]) -> Judged:
    """Returns the results after the author has answered the questions."""
    from workbench.app.commands.ask import ask

    if judged.draft is None or (draft := ask(judged.draft, judged.results)) is None:
        return judged
    return Loaded(draft.paper, draft).judged(judged_claims(draft.paper, (), **engines))


def _corrected(judged: Judged, wanted: bool, cache: bool, seconds: float) -> Judged:
    from workbench.app.commands.repair_commands import with_proposals

    results = with_proposals(judged.results, wanted, cache, False, judged.paper, seconds)
    return replace(judged, results=results)


def _status(judged: Judged, strict: bool) -> int:
    from workbench.core.verdict import Grade, Outcome
    from workbench.papers.texts.text_paper import TextPaper

    is_text = isinstance(judged.paper, TextPaper)
    if is_text and all(result.verdict.outcome is Outcome.UNCHECKED for result in judged.results):
        return 2
    faults = {Grade.ERROR, Grade.WARNING} if strict else {Grade.ERROR}
    is_faulty = judged.paper.faults or any(result.shown in faults for result in judged.results)
    return 1 if is_faulty else 0
