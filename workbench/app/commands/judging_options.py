"""Shared parts of the commands that judge: options, progress bar, printing, writing files."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import closing
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from workbench.app.commands.options import Unusable, cache_option, print_json
from workbench.app.pipeline.verdict_memory import memory_of_verdicts
from workbench.runtime.atomic_files import replace_file

if TYPE_CHECKING:
    from workbench.app.pipeline.judged_files import Judged, Loaded
    from workbench.papers import Paper, PaperError
    from workbench.prover.results.claim_results import ClaimResult

proposals_flag = click.option(
    "--proposals/--no-proposals", default=True, help="Search for the right form of what is not right."
)
_engines = [
    click.option(
        "--second-engine/--no-second-engine",
        default=True,
        help="Recheck every proof by the second engine; without it, nothing counts as proved.",
    ),
    click.option("--motions/--no-motions", default=True, help="Evaluate claims on Drake's motions too."),
    click.option(
        "--seconds",
        type=float,
        show_default="what the paper says, or 20",
        help="Processor time for each judgement, past which it is unchecked.",
    ),
    click.option(
        "--megabytes",
        type=float,
        show_default="what the paper says, or 4000",
        help="Memory for each judgement, past which it is unchecked.",
    ),
    cache_option,
]


def engine_options(command: Callable[..., None]) -> Callable[..., None]:
    for option in reversed(_engines):
        command = option(command)
    return command


def loading(motions: bool, **_: Any) -> Callable[[], None]:
    """Returns a function that makes the preparations which every judgement needs."""

    def load() -> None:
        from workbench.app.pipeline.motion_witnesses import load_motions
        from workbench.prover.preload import load_engines

        load_engines()
        if motions:
            load_motions()

    return load


def judged_claims(
    paper: Paper,
    select: Sequence[str],
    seconds: float | None = None,
    megabytes: float | None = None,
    cache: bool = True,
    **engines: bool,
) -> list[ClaimResult]:
    from workbench.app.commands.terminal import progress_bar
    from workbench.app.pipeline.judge_claims import judge_paper
    from workbench.papers.selection import select_claims
    from workbench.runtime import Budget

    try:
        budget = Budget.of(seconds=seconds, megabytes=megabytes)
    except ValueError as error:
        raise Unusable(str(error)) from None
    count = len(select_claims(paper.claims, select))
    with memory_of_verdicts(cache) as memory, progress_bar(count, "judging") as advance:
        return judge_paper(paper, select, progress=advance, budget=budget, memory=memory, **engines)


def judged_files(
    files: Iterable[Path],
    unusable: list[PaperError],
    jobs: int | None = None,
    scheduler: str | None = None,
    seconds: float | None = None,
    megabytes: float | None = None,
    cache: bool = True,
    **engines: bool,
) -> Iterator[Judged]:
    """Yields each file as soon as it is judged, by this many processes or on a cluster.

    unusable: gets the faults of files that cannot be read.
    """
    from workbench.app.commands.terminal import progress_bar
    from workbench.app.pipeline.judged_files import loaded_file
    from workbench.app.pipeline.many_papers import judge_papers
    from workbench.papers import PaperError
    from workbench.runtime import Budget

    def loaded() -> Iterator[tuple[str, Loaded]]:
        for file in files:
            try:
                yield str(file), loaded_file(file, memory)
            except PaperError as error:
                unusable.extend(error.faults)

    try:
        budget = Budget.of(seconds=seconds, megabytes=megabytes)
        with memory_of_verdicts(cache) as memory:
            bar = partial(progress_bar, what="judging")
            with closing(judge_papers(loaded(), jobs, scheduler, bar, budget, memory, **engines)) as found:
                yield from found
    except PaperError:
        raise
    except ValueError as error:
        raise Unusable(str(error)) from None


def as_expected(paper: Paper, results: Sequence[ClaimResult]) -> bool:
    """Returns whether each verdict is the expected one, and prints the faults of a model."""
    print_faults(paper.faults)
    return not paper.faults and all(result.passed for result in results)


def print_faults(faults: Sequence[PaperError]) -> None:
    from workbench.app.commands.carets import faults_text

    if faults:
        click.echo(faults_text(faults), err=True)


def print_results(paper: Paper, results: Sequence[ClaimResult], as_json: bool) -> None:
    from workbench.app.commands.terminal import console, motions_line, results_table, summary_line
    from workbench.report.to_json import report_json

    if as_json:
        print_json(report_json(paper, results))
        return
    terminal = console(sys.stdout)
    terminal.print(results_table(results))
    if (line := motions_line(results)) is not None:
        terminal.print(line)
    terminal.print(summary_line(results))


def write_atomically(path: Path, text: str) -> None:
    try:
        replace_file(path, text.encode("utf-8"))
    except OSError as error:
        raise Unusable(f"{path}: cannot be written: {error.strerror or error}") from None
