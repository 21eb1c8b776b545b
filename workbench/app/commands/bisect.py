"""workbench bisect: the commit since which each display of a text is false."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import click

from workbench.app.commands.history import Commit, Repository
from workbench.app.commands.options import reports_faults
from workbench.app.pipeline.judged_files import judged_file

if TYPE_CHECKING:
    from workbench.prover.results.claim_results import ClaimResult


@click.command()
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "--most",
    type=click.IntRange(min=1),
    default=200,
    show_default=True,
    help="Go back at most so many commits that changed the text.",
)
@reports_faults
def bisect(file: Path, most: int) -> None:
    """Find the commit since which each display of FILE is false, from the newest commit back.

    A display is known by what it shows, whatever its line. Exit status 0 if no display is false, 1 if one
    is, 2 if FILE cannot be used or has no history."""
    from workbench.app.servers.watch import paths_of
    from workbench.report.baseline import content_of

    repository = Repository.around(file)
    judged = judged_file(file)
    faults = [result for result in judged.results if result.is_wrong]
    if not faults:
        click.echo(f"{file}: no display is false")
        return
    commits = list(repository.commits(paths_of(judged.paper)))
    versions = _versions(repository, commits[:most], file)
    found = _traced({content_of(each) for each in faults}, versions, len(commits) > most)
    for each in faults:
        _print(each, found[content_of(each)])
    sys.exit(1)


@dataclass(frozen=True)
class Version:
    """A text as a commit has it: of each formula whether it is false. None: the text cannot be judged."""

    commit: Commit
    is_false: dict[str, bool] | None


@dataclass(frozen=True)
class Origin:
    """since: the oldest commit in a row that has a formula as false; None: no commit has.   before: how it
    was before."""

    since: Commit | None
    before: str


def _traced(wanted: set[str], versions: Iterator[Version], is_cut: bool) -> dict[str, Origin]:
    """Returns where each formula became false. versions: the newest first; no more are judged than needed."""
    since: dict[str, Commit | None] = dict.fromkeys(wanted)
    found: dict[str, Origin] = {}
    for version in versions:
        if version.is_false is None:
            continue
        for formula in wanted - found.keys():
            match version.is_false.get(formula):
                case True:
                    since[formula] = version.commit
                case False:
                    found[formula] = Origin(since[formula], f"not false in {version.commit}")
                case None:
                    found[formula] = Origin(since[formula], "the formula is new there")
        if len(found) == len(wanted):
            return found
    before = "no older commit was judged" if is_cut else "the formula is new there"
    return {formula: found.get(formula) or Origin(since[formula], before) for formula in wanted}


def _versions(repository: Repository, commits: Sequence[Commit], file: Path) -> Iterator[Version]:
    """Yields the text in each commit, judged; none once a commit does not have it."""
    from workbench.papers import PaperError
    from workbench.report.baseline import content_of

    name = file.resolve().relative_to(repository.folder)
    for commit in commits:
        with repository.at(commit.revision) as folder:
            if not (folder / name).is_file():
                return
            try:
                results = judged_file(folder / name).results
            except PaperError:
                yield Version(commit, None)
                continue
            faults = {content_of(each) for each in results if each.is_wrong}
            yield Version(commit, {content_of(each): content_of(each) in faults for each in results})


def _print(result: ClaimResult, origin: Origin) -> None:
    from workbench.app.commands.carets import printable
    from workbench.app.commands.listing_text import MARKS
    from workbench.report.baseline import content_of
    from workbench.report.findings import place_of

    place = place_of(result)
    click.echo(printable(f"{MARKS[result.shown]} {place.file}:{place.line}: {content_of(result)}"))
    since = origin.since or "changes that are not committed"
    click.echo(printable(f"    false since {since}; {origin.before}"))
