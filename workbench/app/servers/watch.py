"""`workbench check --watch`: judges changed papers again, in a process that has everything else loaded."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, Any, Unpack

import click

from workbench.app.pipeline.verdict_memory import memory_of_verdicts

if TYPE_CHECKING:
    from workbench.app.pipeline.judge_claims import EngineOptions
    from workbench.papers import Paper

#: Milliseconds to wait for an editor to finish writing a file.
_PAUSE = 100
#: Milliseconds between polls, since changes while a paper is judged give no notification.
_LOOK = 1000


def watch_files(
    files: Sequence[Path],
    form: str,
    jobs: int | None = None,
    seconds: float | None = None,
    megabytes: float | None = None,
    cache: bool = True,
    **engines: Unpack[EngineOptions],
) -> None:
    """Judges the files, and again what changes in them or in what they include, until interrupted."""
    from watchfiles import watch

    from workbench.runtime import Budget

    budget = Budget.of(seconds=seconds, megabytes=megabytes)
    with memory_of_verdicts(cache) as memory:
        known: dict[Path, list[Path]] = {}
        stamps: dict[Path, tuple[int, int] | None] = {}
        waiting = list(dict.fromkeys(files))
        while True:
            for file in waiting:
                known[file] = _judged(file, form, known.get(file), jobs, budget, memory, engines)
            parts = {path.resolve(): file for file, paths in known.items() for path in paths}
            folders = {path.parent for path in parts}
            stamps |= {path: _stamp(path) for path in parts if path not in stamps}
            while not (touched := {path for path in parts if _stamp(path) != stamps[path]}):
                notice = watch(
                    *folders,
                    step=_PAUSE,
                    recursive=False,
                    raise_interrupt=True,
                    rust_timeout=_LOOK,
                    yield_on_timeout=True,
                )
                next(notice, None)
            stamps |= {path: _stamp(path) for path in touched}
            waiting = list(dict.fromkeys(parts[path] for path in touched if path in parts))


def _stamp(path: Path) -> tuple[int, int] | None:
    """Returns a stamp that differs for a changed file; None if there is no file."""
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size


def _judged(
    file: Path,
    form: str,
    before: list[Path] | None,
    jobs: int | None,
    budget: Any,
    memory: Any,
    engines: EngineOptions,
) -> list[Path]:
    """Judges a file, and returns the paths that it depends on."""
    from workbench.app.commands.judging_options import print_faults
    from workbench.app.commands.printed import print_judged
    from workbench.app.pipeline.judge_claims import judge_paper
    from workbench.app.pipeline.judged_files import loaded_file
    from workbench.papers import PaperError

    start = monotonic()
    try:
        loaded = loaded_file(file, memory)
        results = judge_paper(loaded.paper, (), lambda _: None, jobs, budget=budget, memory=memory, **engines)
        judged = loaded.judged(results, budget, memory)
    except PaperError as error:
        print_faults(error.faults)
        return before or [file, file.with_suffix(".toml")]
    print_judged([judged], None, form)
    if form == "text":
        click.echo(f"{file}: judged in {monotonic() - start:.1f} s; waiting for changes")
    return [file, *paths_of(judged.paper)]


def paths_of(paper: Paper) -> list[Path]:
    """Returns the files of a paper, and the path of a model that may be created for it."""
    from workbench.papers.texts.text_paper import TextPaper

    text = paper.text if isinstance(paper, TextPaper) else None
    sources = [] if text is None else [source.path for source in text.sources]
    return [*paper.paths, *sources, *(path.with_suffix(".toml") for path in paper.paths)]
