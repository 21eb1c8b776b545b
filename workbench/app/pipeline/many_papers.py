"""Judges many papers together, and caches the verdicts as they arrive."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from workbench.app.pipeline.dask_workers import Cluster, PaperOnCluster
from workbench.app.pipeline.judge_claims import ClaimResult, PaperJudge, in_order
from workbench.app.pipeline.verdict_keys import Memory
from workbench.papers import Paper
from workbench.runtime import Budget


def judge_papers(
    papers: Sequence[tuple[str, Paper]],
    jobs: int | None = None,
    scheduler: str | None = None,
    progress: Callable[[ClaimResult], None] = lambda result: None,
    budget: Budget | None = None,
    memory: Memory | None = None,
    **options: Any,
) -> Iterator[list[ClaimResult]]:
    """Yields the results of each paper, in order.

    Cached verdicts are not judged again, so that an interrupted run continues where it stopped.

    papers: (name for `find_paper`, paper).
    jobs: the number of local processes.
    scheduler: the address of a Dask scheduler, whose workers judge; a worker that dies loses nothing. Raises
    ValueError if it cannot be used.
    """
    judges = [PaperJudge(paper, budget=budget, memory=memory, **options) for _, paper in papers]
    cluster = None
    try:
        cluster = Cluster(scheduler, options) if scheduler else None
        running = []
        for (name, paper), judge in zip(papers, judges, strict=True):
            pool = PaperOnCluster(cluster, judge, name) if cluster else None
            running.append(judge.results(paper.claims, jobs, pool))
        for (_, paper), results in zip(papers, running, strict=True):
            yield in_order(results, paper.claims, progress)
    finally:
        for judge in judges:
            judge.close()
        if cluster is not None:
            cluster.close()
