"""The command line.

Exit status: 0 as expected (check: no error), 1 not as expected, 2 unusable input, 3 a defect of the
workbench, 130 interrupted.
"""

from __future__ import annotations

import atexit
import gc
import sys
from collections.abc import Sequence
from dataclasses import replace
from io import TextIOWrapper
from pathlib import Path
from typing import Any

import click

from workbench.app.commands.command_groups import CommandGroups
from workbench.app.commands.judging_options import (
    as_expected,
    engine_options,
    judged_claims,
    loading,
    print_results,
    proposals_flag,
)
from workbench.app.commands.options import (
    Unusable,
    json_flag,
    named_paper,
    paper_option,
    print_json,
    reports_faults,
)


@click.group(cls=CommandGroups, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="kinematics-workbench", prog_name="workbench")
def main() -> None:
    """Checks the printed formulas of kinematics papers: LaTeX in, exact verdict and evidence out."""
    gc.set_threshold(100_000, 50, 100)  # hardly any object of a paper is freed before the end
    atexit.register(gc.freeze)  # and at the end the process frees them all
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")  # for locales without Φ


@click.command("list")
@click.argument("select", nargs=-1)
@paper_option
@json_flag
@reports_faults
def list_claims(select: Sequence[str], paper_name: str | None, as_json: bool) -> None:
    """List the claims of a paper, without judging them."""
    from workbench.app.commands.terminal import claims_table, console
    from workbench.papers.selection import select_claims

    claims = select_claims(named_paper(paper_name).claims, select)
    if as_json:
        print_json(
            [
                {
                    "id": claim.id,
                    "equation": claim.equation,
                    "section": claim.section,
                    "expected": str(claim.expected),
                    "printed": claim.printed.latex or claim.source.statement,
                }
                for claim in claims
            ]
        )
    else:
        console(sys.stdout).print(claims_table(claims))


@click.command()
@click.argument("select", nargs=-1)
@paper_option
@json_flag
@engine_options
@reports_faults
def verify(select: Sequence[str], paper_name: str | None, as_json: bool, **engines: Any) -> None:
    """Judge the claims that SELECT means: equations (58), ranges (45-70), ids (58.det), sections (4.1),
    patterns (58.*); all of them if there is none. Exit status 0 if each verdict is the expected one."""
    paper = named_paper(paper_name, engines["cache"], loading(**engines))
    results = judged_claims(paper, select, **engines)
    print_results(paper, results, as_json)
    sys.exit(0 if as_expected(paper, results) else 1)


@click.command()
@click.argument("claim_id", metavar="ID")
@paper_option
@json_flag
@proposals_flag
@reports_faults
def show(claim_id: str, paper_name: str | None, as_json: bool, proposals: bool) -> None:
    """Show one claim in full: printed, read back, verdict, counterexample, correction, evidence.
    ID may also select several claims, as for verify."""
    from workbench.app.commands.proposal_text import proposal_lines
    from workbench.app.commands.repair_commands import with_proposals
    from workbench.app.commands.terminal import claim_lines, console
    from workbench.certificates.certify import with_certificates
    from workbench.report.to_json import claim_json

    paper = named_paper(paper_name, meanwhile=loading(motions=True))
    results = with_proposals(judged_claims(paper, [claim_id]), proposals)
    results = with_certificates(results, paper)
    if as_json:
        told = [claim_json(result) for result in results]
        print_json(told[0] if len(told) == 1 else told)
    else:
        terminal = console(sys.stdout)
        for result in results:
            for line in (*claim_lines(result), *proposal_lines(result.proposed or (), terminal.is_terminal)):
                terminal.print(line)
    sys.exit(0 if all(result.passed for result in results) else 1)


@click.command()
@click.argument("select", nargs=-1)
@paper_option
@click.option(
    "--out", default="report", show_default=True, type=click.Path(path_type=Path), help="The directory."
)
@click.option(
    "--source",
    type=click.Path(path_type=Path),
    help="The text that the paper file was made from: errata.diff corrects it. A text corrects itself.",
)
@click.option("--pdf", is_flag=True, help="Typeset erratum.tex by pdflatex, and link to erratum.pdf.")
@json_flag
@engine_options
@proposals_flag
@reports_faults
def report(
    select: Sequence[str],
    paper_name: str | None,
    out: Path,
    source: Path | None,
    pdf: bool,
    as_json: bool,
    proposals: bool,
    **engines: Any,
) -> None:
    """Write the report of a paper: HTML, Markdown, JSON, and the errata as LaTeX, JSON and a patch. Exit
    status as for verify."""
    from workbench.app.commands.repair_commands import with_proposals
    from workbench.app.commands.terminal import console, summary_line
    from workbench.certificates.certify import with_certificates
    from workbench.report.render import write_report
    from workbench.report.to_json import report_json

    if out.exists() and not out.is_dir():
        raise Unusable(f"{out}: expected a directory for the report, got a file")
    paper = named_paper(paper_name, engines["cache"], loading(**engines))
    results = judged_claims(paper, select, **engines)
    recheck = "workbench report" + f" --paper {paper_name}" * bool(paper_name)
    cited = replace(paper, citation={"recheck": recheck, **paper.citation})
    told = with_proposals(results, proposals, engines["cache"], beside_right=False, paper=paper)
    told = with_certificates(told, paper)
    written = write_report(cited, told, out, source, pdf)
    if as_json:
        print_json(report_json(cited, told))
    else:
        terminal = console(sys.stdout)
        for path in written:
            terminal.print(str(path), markup=False)
        terminal.print(summary_line(results))
    sys.exit(0 if as_expected(paper, results) else 1)
