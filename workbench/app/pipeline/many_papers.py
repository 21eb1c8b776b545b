"""Judges many texts and papers, one after the other, and caches the verdicts as they arrive."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator
from contextlib import AbstractContextManager, closing, nullcontext
from typing import Any

from workbench.app.pipeline.dask_workers import Cluster, PaperOnCluster
from workbench.app.pipeline.judge_claims import ClaimResult, PaperJudge, in_order
from workbench.app.pipeline.judged_files import Judged, Loaded
from workbench.app.pipeline.verdict_keys import Memory
from workbench.runtime import Budget

#: How many papers a cluster has beside the one whose results are awaited.
AHEAD = 8

#: Shows the progress of a number of claims: a context of the function that takes each result.
Progress = Callable[[int], AbstractContextManager[Callable[[ClaimResult], None]]]


def judge_papers(
    papers: Iterable[tuple[str, Loaded]],
    jobs: int | None = None,
    scheduler: str | None = None,
    progress: Progress = lambda count: nullcontext(lambda result: None),
    budget: Budget | None = None,
    memory: Memory | None = None,
    **options: Any,
) -> Generator[Judged]:
    """Yields each paper with its results, in order, as soon as it is judged.

    A paper is loaded when its turn comes. Cached verdicts are not judged again, so that an interrupted run
    continues where it stopped.

    papers: (name for `find_paper`, paper).
    jobs: the number of local processes.
    scheduler: the address of a Dask scheduler, whose workers judge; a worker or a scheduler that dies and
    comes back loses nothing. Raises ValueError if it cannot be used.
    """
    waiting: deque[tuple[Loaded, PaperJudge, Iterator[ClaimResult]]] = deque()
    with closing(Cluster(scheduler, options)) if scheduler else nullcontext() as cluster:
        try:
            for name, loaded in papers:
                judge = PaperJudge(loaded.paper, budget=budget, memory=memory, **options)
                pool = PaperOnCluster(cluster, judge, name) if cluster else None
                waiting.append((loaded, judge, judge.results(loaded.paper.claims, jobs, pool)))
                if len(waiting) > (AHEAD if cluster else 0):
                    yield _collected(*waiting.popleft(), progress, budget, memory)
            while waiting:
                yield _collected(*waiting.popleft(), progress, budget, memory)
        finally:
            for _, judge, _ in waiting:
                judge.close()


def _collected(
    loaded: Loaded,
    judge: PaperJudge,
    results: Iterator[ClaimResult],
    progress: Progress,
    budget: Budget | None,
    memory: Memory | None,
) -> Judged:
    claims = loaded.paper.claims
    try:
        with progress(len(claims)) as advance:
            found = judge.on_shared_guesses(in_order(results, claims, advance))
        return loaded.judged(found, budget, memory)
    finally:
        judge.close()
