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


class KnownFindings:
    """What was known before a run: the findings that a file lists, and those of a git revision."""

    def __init__(self, baseline: Path | None = None, since: str | None = None) -> None:
        """Raises PaperError for an unusable file."""
        self._path, self._since = baseline, since
        self._judged: list[Judged] = []
        if baseline is not None:
            from workbench.report.baseline import read_baseline

            self._listed, self._folder = read_baseline(baseline), baseline.resolve().parent

    def marked(self, judged: Judged) -> Judged:
        """Returns the results, with those marked that were known."""
        if self._since is not None:
            judged = _since(judged, self._since)
        if self._path is not None:
            self._judged.append(judged)
            judged = _marked(judged, self._listed, self._folder)
        return judged

    def tell_stale(self) -> None:
        """Prints the entries about the judged files that are no longer wrong."""
        if self._path is not None:
            _tell_stale(self._judged, self._listed, self._path)


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


def written_baseline(judged: Sequence[Judged], marked: Sequence[Judged], path: Path) -> list[Judged]:
    """Writes all findings into a file, and returns the marked results with these marked, too."""
    from workbench.report.baseline import all_known, baseline_text

    folder = path.resolve().parent
    known = all_known([result for each in judged for result in each.results], folder)
    write_atomically(path, baseline_text(known))
    count = known.total()
    click.echo(f"{path}: {count} known finding{'' if count == 1 else 's'}", err=True)
    return [_marked(each, known, folder) for each in marked]


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
