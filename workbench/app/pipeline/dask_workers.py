"""Judging on Dask's workers, with the interface of the local worker pool.

A worker gets the files of a paper, not our terms. Its verdict counts only if the worker computes the same
cache key: the same claim, definitions, options, versions and code. Dask's processes may have no children, and
a judgement must be interruptible, so each worker talks to a separate process.
"""

from __future__ import annotations

import logging
import os
import pickle
import secrets
import subprocess
import sys
import tempfile
import threading
from collections import deque
from collections.abc import Generator, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from time import monotonic, sleep
from typing import TYPE_CHECKING, Any, BinaryIO

from workbench.app.pipeline.judge_claims import PaperJudge
from workbench.app.pipeline.judged_files import loaded_file
from workbench.context.claim_parts import ClaimForm
from workbench.core.paper_errors import PaperError
from workbench.core.verdict import Verdict
from workbench.papers import Paper, find_paper
from workbench.prover.decide.inference import Seal
from workbench.runtime import Budget, OutOfBudget

if TYPE_CHECKING:
    from distributed import Client

#: How often a judgement is retried when its worker dies.
_RETRIES = 5


@dataclass(frozen=True)
class Bundle:
    """The files of a paper, by their paths in a common folder; the name of an installed paper."""

    main: str
    files: Mapping[str, bytes]

    @staticmethod
    def of(paper: Paper, name: str) -> Bundle:
        sources = getattr(paper.text, "sources", ()) if hasattr(paper, "text") else ()
        paths = {path.resolve() for path in (*paper.paths, *(source.path for source in sources))}
        if paper.theorems or not paths:
            return Bundle(name, {})
        beside = {other for path in paths for other in path.parent.iterdir() if _may_be_read(other)}
        root = Path(os.path.commonpath([path.parent for path in paths]))
        files = {str(path.relative_to(root)): path.read_bytes() for path in sorted(paths | beside)}
        return Bundle(str(paper.paths[0].resolve().relative_to(root)), files)

    @property
    def digest(self) -> str:
        told = repr((self.main, sorted(self.files.items())))
        return sha256(told.encode()).hexdigest()

    def load(self) -> Paper:
        if not self.files:
            return find_paper(self.main)
        folder = Path(tempfile.mkdtemp(prefix="workbench-"))
        for name, content in self.files.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
        return loaded_file(folder / self.main).paper


def _may_be_read(path: Path) -> bool:
    suffixes = (".sty", ".cls", ".toml", ".urdf")  # what a text includes is one of its sources
    return path.is_file() and path.suffix in suffixes and path.stat().st_size < 2_000_000


_LOG = logging.getLogger(__name__)

#: How many papers a worker keeps, each with a process that judges; more than a client sends at once.
_KEPT = 10
#: Seconds in which a scheduler must answer.
CONNECT = 10
#: Seconds in which a scheduler that died must be back.
RETURN = 120


class Cluster:
    """A cluster at `address` for judgements. Raises ValueError if there is none."""

    def __init__(self, address: str, options: Mapping[str, Any]) -> None:
        self._address, self._options = address, dict(options)
        self._secret = secrets.token_bytes(32)
        self._client = self._connected()
        self._connections = 1

    def _connected(self) -> Client:
        try:
            from distributed import Client
        except ImportError:
            message = "a scheduler needs the extra dask: pip install 'kinematics-workbench[dask]'"
            raise ValueError(message) from None
        logging.getLogger("distributed.client").setLevel(logging.CRITICAL)  # a lost scheduler is told below
        try:
            return Client(self._address, timeout=CONNECT)
        except (OSError, ValueError) as error:
            raise ValueError(f"{self._address}: no scheduler of Dask answers there: {error}") from None

    def map(
        self, items: Iterable[tuple[Bundle, str, str, str]], budget: Budget
    ) -> Generator[Verdict | OutOfBudget]:
        """Yields the verdict on each (paper, claim, form, key), in order; all are submitted at once.

        If the scheduler dies, what is not yet answered is submitted to its successor at the same address.
        """
        waiting = deque(items)
        tasks: deque[Any] = deque()
        connection = self._connections
        with suppress(OSError):  # of a scheduler that died since; the first answer reconnects
            tasks = self._submitted(waiting, budget)

        def answers() -> Generator[Verdict | OutOfBudget]:
            nonlocal tasks, connection
            in_vain = 0
            while waiting:
                try:
                    if connection != self._connections or not tasks:
                        tasks, connection = self._submitted(waiting, budget), self._connections
                    told = tasks[0].result()
                except Exception as error:
                    if tasks and tasks[0].status == "error":
                        told = f"the workers failed {_RETRIES + 1} times: {error}"
                    elif in_vain == _RETRIES:
                        raise
                    else:  # the scheduler is lost, and all its tasks
                        in_vain += 1
                        if connection == self._connections:
                            self._reconnect(error)
                        continue
                in_vain = 0
                tasks.popleft()
                *_, key = waiting.popleft()
                yield self._answer(told, key)

        return answers()

    def _submitted(self, items: Iterable[tuple[Bundle, str, str, str]], budget: Budget) -> deque[Any]:
        bundles: dict[str, Any] = {}
        tasks: deque[Any] = deque()
        for bundle, *rest in items:
            if bundle.digest not in bundles:
                bundles[bundle.digest] = self._client.submit(Bundle, bundle.main, bundle.files)
            sent = bundles[bundle.digest]
            task = self._client.submit(
                judged_by_worker,
                *(sent, *rest, self._options, budget, self._secret),
                retries=_RETRIES,
                pure=False,
            )
            tasks.append(task)
        return tasks

    def _answer(self, told: dict[str, Any] | str, key: str) -> Verdict | OutOfBudget:
        return OutOfBudget(told) if isinstance(told, str) else Seal(self._secret).opened(key, told)

    def _reconnect(self, error: Exception) -> None:
        """Waits for a scheduler at the same address. Raises ValueError if none comes back in time."""
        with suppress(Exception):  # of a client without a scheduler
            self._client.close(timeout=1)
        _LOG.warning("%s: the scheduler is gone; waiting for it for %d s", self._address, RETURN)
        end = monotonic() + RETURN
        while True:
            try:
                self._client = self._connected()
                self._connections += 1
                return
            except ValueError:
                if monotonic() > end:
                    message = f"{self._address}: the scheduler died and is not back after {RETURN} s: {error}"
                    advice = "the verdicts so far are kept: the same command goes on from there"
                    raise ValueError(f"{message}; {advice}") from None
                sleep(1)

    def close(self) -> None:
        with suppress(Exception):  # of a client without a scheduler
            self._client.close(timeout=5)


class PaperOnCluster:
    """The worker pool for one paper, which reports progress."""

    def __init__(self, cluster: Cluster, judge: PaperJudge, name: str) -> None:
        self._cluster, self._judge, self._bundle = cluster, judge, Bundle.of(judge.paper, name)
        self._claims = {claim.id: claim for claim in judge.paper.claims}

    def map(self, items: Sequence[tuple[str, str]]) -> Generator[Verdict | OutOfBudget]:
        far = [item for item in items if self._is_judged(*item)]
        answers = self._cluster.map(
            ((self._bundle, name, form, self._judge.key(self._claims[name], form)) for name, form in far),
            self._judge.budget,
        )
        sent = set(far)
        return (next(answers) if item in sent else self._told(*item) for item in items)

    def close(self) -> None:
        """Does nothing: the cluster is shared."""

    def _is_judged(self, name: str, form: str) -> bool:
        claim = self._claims[name]
        special = claim.proof.goal is not None or claim.proof.theorem is not None
        return claim.skip is None and (special or claim.forms[ClaimForm(form)].statement is not None)

    def _told(self, name: str, form: str) -> Verdict | OutOfBudget:
        return self._judge.judged_now(self._claims[name], form)


_SERVER: list[subprocess.Popen] = []
_TURN = threading.Lock()


def judged_by_worker(
    bundle: Bundle,
    name: str,
    form: str,
    key: str,
    options: Mapping[str, Any],
    budget: Budget,
    secret: bytes,
) -> dict[str, Any] | str:
    """Returns the sealed answer of the worker's own process; a text if nothing was decided."""
    with _TURN:
        if not _SERVER or _SERVER[-1].poll() is not None:
            call = [sys.executable, "-m", "workbench.app.pipeline.dask_workers"]
            _SERVER[:] = [subprocess.Popen(call, stdin=subprocess.PIPE, stdout=subprocess.PIPE)]
        server = _SERVER[-1]
        assert server.stdin is not None and server.stdout is not None, "both are pipes"
        pickle.dump((bundle, name, form, key, dict(options), budget, secret), server.stdin)
        server.stdin.flush()
        return pickle.load(server.stdout)


def serve(asked: BinaryIO, told: BinaryIO) -> None:
    """Answers requests until its worker ends."""
    judges: dict[tuple, Any] = {}
    while True:
        try:
            request = pickle.load(asked)
        except EOFError:
            return
        try:
            answer = _judged(judges, *request)
        except (PaperError, ValueError, OSError) as error:
            answer = f"the worker cannot judge it: {error}"
        pickle.dump(answer, told)
        told.flush()


def _judged(
    judges: dict[tuple, Any],
    bundle: Bundle,
    name: str,
    form: str,
    key: str,
    options: Mapping[str, Any],
    budget: Budget,
    secret: bytes,
) -> dict[str, Any] | str:
    place = (bundle.digest, repr(sorted(options.items())), budget)
    if place not in judges:
        while len(judges) >= _KEPT:
            judges.pop(next(iter(judges))).close()
        judges[place] = PaperJudge(bundle.load(), budget=budget, **options)
    judge = judges[place]
    claim = next((claim for claim in judge.paper.claims if claim.id == name), None)
    if claim is None or judge.key(claim, form) != key:
        return "the worker's workbench is another one, or its files; its verdict does not count"
    verdict = judge.judged_now(claim, form)
    return str(verdict) if isinstance(verdict, OutOfBudget) else Seal(secret).closed(key, verdict)


if __name__ == "__main__":
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # prints of libraries must not mix with the answers
    serve(sys.stdin.buffer, answers)
