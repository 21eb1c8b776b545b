"""The command line. Exit status: 0 as expected (check: all proved), 1 not so, 2 the input cannot be used,
3 a defect of the workbench, 130 interrupted."""

from __future__ import annotations

import math
import os
import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from workbench.cli_options import Unusable, json_flag, json_text, paper_option, print_json, reports_faults
from workbench.cli_repair import claims_with_proposals, errata, repair_claim

if TYPE_CHECKING:
    from workbench.papers import Paper
    from workbench.verify import ClaimResult

#: Of a robot's motion: beyond it Drake's numbers, in doubles, have no correct digit left to compare with.
HIGHEST_ORDER = 20

_proposals_flag = click.option(
    "--proposals/--no-proposals", default=True, help="Search for the right form of what is not right."
)
_engines = [
    click.option(
        "--second-engine/--no-second-engine",
        default=True,
        help="Recheck every proof by the second engine; without it, nothing counts as proved.",
    ),
    click.option("--motions/--no-motions", default=True, help="Evaluate claims on Drake's motions too."),
]


def _engine_options(command: Callable[..., None]) -> Callable[..., None]:
    for option in reversed(_engines):
        command = option(command)
    return command


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name="kinematics-workbench", prog_name="workbench")
def main() -> None:
    """Checks the printed formulas of kinematics papers: LaTeX in, exact verdict and evidence out."""
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="backslashreplace")  # where the locale has no Φ


main.add_command(repair_claim)
main.add_command(errata)


@main.command("list")
@click.argument("select", nargs=-1)
@paper_option
@json_flag
@reports_faults
def list_claims(select: Sequence[str], paper_name: str | None, as_json: bool) -> None:
    """List the claims of a paper, without judging them."""
    from workbench.papers import find_paper
    from workbench.selection import select_claims
    from workbench.terminal import claims_table, console

    claims = select_claims(find_paper(paper_name).claims, select)
    if as_json:
        print_json(
            [
                {
                    "id": claim.id,
                    "equation": claim.equation,
                    "section": claim.section,
                    "expected": str(claim.expected),
                    "printed": claim.printed.latex or claim.statement,
                }
                for claim in claims
            ]
        )
    else:
        console(sys.stdout).print(claims_table(claims))


@main.command()
@click.argument("select", nargs=-1)
@paper_option
@json_flag
@_engine_options
@reports_faults
def verify(
    select: Sequence[str], paper_name: str | None, as_json: bool, second_engine: bool, motions: bool
) -> None:
    """Judge the claims that SELECT means: equations (58), ranges (45-70), ids (58.det), sections (4.1),
    patterns (58.*); all of them if there is none. Exit status 0 if each verdict is the expected one."""
    from workbench.papers import find_paper

    paper = find_paper(paper_name)
    results = _judged(paper, select, second_engine=second_engine, motions=motions)
    _print_results(paper, results, as_json)
    sys.exit(0 if all(result.passed for result in results) else 1)


@main.command()
@click.argument("claim_id", metavar="ID")
@paper_option
@json_flag
@_proposals_flag
@reports_faults
def show(claim_id: str, paper_name: str | None, as_json: bool, proposals: bool) -> None:
    """Show one claim in full: printed, read back, verdict, counterexample, correction, evidence.
    ID may also select several claims, as for verify."""
    from workbench.papers import find_paper
    from workbench.repair.shown import proposal_lines
    from workbench.results import claim_dict
    from workbench.terminal import claim_lines, console

    results = _judged(find_paper(paper_name), [claim_id])
    claims = claims_with_proposals([claim_dict(result) for result in results], results, proposals)
    if as_json:
        print_json(claims[0] if len(claims) == 1 else claims)
    else:
        terminal = console(sys.stdout)
        for claim in claims:
            for line in (*claim_lines(claim), *proposal_lines(claim, coloured=terminal.is_terminal)):
                terminal.print(line)
    sys.exit(0 if all(result.passed for result in results) else 1)


@main.command()
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "--json",
    "json_out",
    is_flag=False,
    flag_value="-",
    metavar="OUT",
    help="Write the report as JSON to OUT (standard output if OUT is - or missing).",
)
@_engine_options
@_proposals_flag
@reports_faults
def check(file: Path, json_out: str | None, second_engine: bool, motions: bool, proposals: bool) -> None:
    """Judge a paper file. Exit status: 0 if all claims are proved or definitions, 1 if some are not,
    2 if the file cannot be used."""
    from workbench.papers import load_paper
    from workbench.repair.shown import repair_lines
    from workbench.results import report_dict
    from workbench.terminal import console
    from workbench.verify import HOLDS

    paper = load_paper(file)
    results = _judged(paper, (), second_engine=second_engine, motions=motions)
    data = report_dict(paper, results)
    data["claims"] = claims_with_proposals(data["claims"], results, proposals)
    if json_out == "-":
        print_json(data)
    else:
        if json_out is not None:
            _write_atomically(Path(json_out), json_text(data))
        _print_results(paper, results, False)
        terminal = console(sys.stdout)
        for claim in data["claims"]:
            for line in repair_lines(claim, terminal.is_terminal) if claim["proposed"] else ():
                terminal.print(line)
    sys.exit(0 if all(result.verdict.outcome in HOLDS for result in results) else 1)


@main.command()
@click.argument("select", nargs=-1)
@paper_option
@click.option(
    "--out", default="report", show_default=True, type=click.Path(path_type=Path), help="The directory."
)
@json_flag
@_engine_options
@click.option(
    "--proposals/--no-proposals",
    default=False,
    show_default=True,
    help="Search for the right form of what is not right; takes a minute or two.",
)
@reports_faults
def report(
    select: Sequence[str],
    paper_name: str | None,
    out: Path,
    as_json: bool,
    second_engine: bool,
    motions: bool,
    proposals: bool,
) -> None:
    """Write the report of a paper: JSON, HTML, Markdown and LaTeX. Exit status as for verify."""
    from workbench.papers import find_paper
    from workbench.results import report_dict
    from workbench.terminal import console, summary_line

    _require_directory(out)
    paper = find_paper(paper_name)
    results = _judged(paper, select, second_engine=second_engine, motions=motions)
    data = report_dict(paper, results)
    if proposals:
        data["claims"] = claims_with_proposals(data["claims"], results, True)
    written = _write_report_atomically(data, out)
    if as_json:
        print_json(data)
    else:
        terminal = console(sys.stdout)
        for path in written:
            terminal.print(str(path), markup=False)
        terminal.print(summary_line(results))
    sys.exit(0 if all(result.passed for result in results) else 1)


@main.command()
@click.argument("urdf", type=click.Path(path_type=Path))
@click.option("--body", required=True, help="The body B.")
@click.option(
    "--order",
    type=click.IntRange(1, HIGHEST_ORDER),
    default=4,
    show_default=True,
    help="1 velocity, 2 acceleration, 3 jerk, ...",
)
@click.option("--point", default="0,0,0", show_default=True, metavar="X,Y,Z", help="p_BoP_B in m.")
@click.option("--at", default=0.0, show_default=True, help="The time in s.")
@click.option(
    "--joint",
    "joints",
    multiple=True,
    metavar="NAME=C0,C1,...",
    help="The position of a joint as a polynomial: c0 + c1 t + ... (rad or m). Joints not named stay at 0; "
    "if none is named, all follow sines.",
)
@json_flag
@reports_faults
def motion(
    urdf: Path, body: str, order: int, point: str, at: float, joints: Sequence[str], as_json: bool
) -> None:
    """Higher-order kinematics of a body of a real robot: acceleration tensors, invariant vectors, centres,
    beside Drake's own numbers. Exit status 1 if they disagree."""
    import numpy as np

    from workbench.kinematics.robot import motion_report
    from workbench.terminal import console, motion_lines

    try:
        path = dict(_joint_polynomial(text) for text in joints) or None
        with np.errstate(all="ignore"):  # an overflow ends in a message of its own
            report = motion_report(urdf, body, _numbers(point, "point", 3), order, at, path)
    except ValueError as error:
        raise Unusable(str(error)) from None
    data = report.to_dict()
    if as_json:
        print_json(data)
    else:
        terminal = console(sys.stdout)
        for line in motion_lines(data):
            terminal.print(line)
    sys.exit(0 if all(order["drake"]["agrees"] for order in data["orders"]) else 1)


def _joint_polynomial(text: str) -> tuple[str, tuple[float, ...]]:
    name, equals, coefficients = text.partition("=")
    if not equals or not name.strip():
        raise ValueError(f"joint: expected NAME=C0,C1,..., got {text!r}")
    return name.strip(), _numbers(coefficients, f"joint {name.strip()}")


def _numbers(text: str, what: str, count: int | None = None) -> tuple[float, ...]:
    try:
        numbers = tuple(float(part) for part in text.split(","))
    except ValueError:
        numbers = ()
    if not numbers or len(numbers) != (count or len(numbers)) or not all(map(math.isfinite, numbers)):
        wanted = f"{count} finite numbers" if count else "finite numbers"
        raise ValueError(f"{what}: expected {wanted} with commas between, got {text!r}")
    return numbers


def _judged(paper: Paper, select: Sequence[str], **engines: bool) -> list[ClaimResult]:
    from workbench.selection import select_claims
    from workbench.terminal import progress_bar
    from workbench.verify import judge_paper

    with progress_bar(len(select_claims(paper.claims, select)), "judging") as advance:
        return judge_paper(paper, select, progress=advance, **engines)


def _print_results(paper: Paper, results: Sequence[ClaimResult], as_json: bool) -> None:
    from workbench.results import report_dict
    from workbench.terminal import console, results_table, summary_line

    if as_json:
        print_json(report_dict(paper, results))
    else:
        terminal = console(sys.stdout)
        terminal.print(results_table(results))
        terminal.print(summary_line(results))


def _require_directory(out: Path) -> None:
    if out.exists() and not out.is_dir():
        raise Unusable(f"{out}: expected a directory for the report, got a file")


def _write_report_atomically(data: dict[str, Any], out: Path) -> list[Path]:
    """Each file appears in `out` only when all of them are written."""
    from workbench.report import write_report

    try:
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=out, prefix=".unfinished-") as unfinished:
            drafts = write_report(data, Path(unfinished))
            written = [out / draft.relative_to(unfinished) for draft in drafts]
            for draft, path in zip(drafts, written, strict=True):
                path.parent.mkdir(parents=True, exist_ok=True)
                os.replace(draft, path)
    except OSError as error:
        raise Unusable(f"{out}: the report cannot be written: {error.strerror or error}") from None
    return written


def _write_atomically(path: Path, text: str) -> None:
    draft = path.with_name(f".unfinished-{os.getpid()}-{path.name}")
    try:
        draft.write_text(text, encoding="utf-8")
        os.replace(draft, path)
    except OSError as error:
        raise Unusable(f"{path}: cannot be written: {error.strerror or error}") from None
    finally:
        draft.unlink(missing_ok=True)
