"""check --baseline, --write-baseline and --since: marks findings that were known before."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from workbench.app.commands.judging_options import write_atomically
from workbench.app.commands.options import Unusable
from workbench.app.pipeline.judged_files import Judged, judged_file

if TYPE_CHECKING:
    from workbench.report.baseline import Known


def without_known(
    judged: Sequence[Judged], baseline: Path | None, written: Path | None, since: str | None
) -> list[Judged]:
    """Returns the results, with those marked that a file lists or that were wrong in a revision.

    written: the file to which all findings are written, which makes them known.
    """
    made = list(judged)
    if since is not None:
        made = [_since(each, since) for each in made]
    if baseline is not None:
        made = _by_file(made, baseline)
    return made if written is None else _written(judged, made, written)


def _by_file(judged: Sequence[Judged], path: Path) -> list[Judged]:
    from workbench.report.baseline import read_baseline

    known, folder = read_baseline(path), path.resolve().parent
    made = [_marked(each, known, folder) for each in judged]
    _tell_stale(judged, known, path)
    return made


def _tell_stale(judged: Sequence[Judged], rest: Counter[Known], path: Path) -> None:
    """Prints the entries about the judged files that are no longer wrong."""
    from workbench.app.servers.watch import paths_of

    folder = path.resolve().parent
    own = {file.resolve() for each in judged for file in paths_of(each.paper)}
    stale = sorted(each for each in rest.elements() if (folder / each.file).resolve() in own)
    for each in stale:
        click.echo(f"{path}: {each.file}: is no longer wrong: {each.formula}", err=True)
    if stale:
        click.echo(f"`workbench check --write-baseline {path}` leaves them out", err=True)


def _written(judged: Sequence[Judged], made: Sequence[Judged], path: Path) -> list[Judged]:
    from workbench.report.baseline import all_known, baseline_text

    folder = path.resolve().parent
    known = all_known([result for each in judged for result in each.results], folder)
    write_atomically(path, baseline_text(known))
    count = known.total()
    click.echo(f"{path}: {count} known finding{'' if count == 1 else 's'}", err=True)
    return [_marked(each, known, folder) for each in made]


def _since(judged: Judged, name: str) -> Judged:
    """Returns the results, with those marked whose display was already wrong in a revision.

    A display is identified by its content, independent of its surroundings.
    """
    from workbench.app.commands.history import Repository
    from workbench.papers import PaperError
    from workbench.report.baseline import all_known

    path = judged.paper.paths[0]
    repository = Repository.around(path)
    with repository.at(repository.revision(name)) as folder:
        old = folder / path.resolve().relative_to(repository.folder)
        if not old.exists():
            return judged
        try:
            before = judged_file(old)
        except PaperError as error:
            why = f"{path}: cannot be judged as it was in {name}: {error.message}"
            raise Unusable(f"{why}; expected a revision in which it can") from None
        known = all_known(before.results, folder)
    return _marked(judged, known, repository.folder)


def _marked(judged: Judged, known: Counter[Known], folder: Path) -> Judged:
    from workbench.report.baseline import as_known

    return replace(judged, results=as_known(judged.results, known, folder))
