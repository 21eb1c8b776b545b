"""Calls in separate processes that can be ended: a proof may take hours in one call of C code.

The processes are forked, so that the function and its data need not be sent, terms keep their hashes, and
nothing is loaded again. They write to their pipes only and never return to the caller's code, so they need no
lock that another thread may hold.
"""

from __future__ import annotations

import gc
import os
import resource
import signal
import sys
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from itertools import groupby
from multiprocessing import connection, current_process, get_all_start_methods, get_context
from multiprocessing.connection import Connection
from time import monotonic
from typing import Any
from weakref import finalize

from workbench.runtime.limits import Budget, OutOfBudget

#: Limit on wall time, as a multiple of the processor time because the machine may be busy; and its least
#: value in seconds.
PATIENCE, LEAST = 10.0, 60.0
#: Seconds between two calls of `check` in `interruptible`.
_CHECKED = 0.05

_check: ContextVar[Callable[[], None] | None] = ContextVar("check", default=None)


@contextmanager
def interruptible(check: Callable[[], None]) -> Iterator[None]:
    """Within it, waiting for workers ends as soon as `check` raises an exception, which the caller gets."""
    before = _check.set(check)
    try:
        yield
    finally:
        _check.reset(before)


def stop_if_asked() -> None:
    """Raises what `check` of `interruptible` raises; long work in this process calls it now and then."""
    if (check := _check.get()) is not None:
        check()


class Workers:
    """Calls of one function in up to `count` processes, each within the budget (None: no limits).

    prepare: called in this process before the first fork, to load what all processes need.
    alike: a key of an item. Adjacent items with the same key go to one process, which reuses its results for
    them, until another process is idle.

    If the system cannot fork, or the process may not have children, calls run in this process without limits.
    """

    def __init__(
        self,
        function: Callable[[Any], Any],
        budget: Budget | None,
        count: int = 1,
        prepare: Callable[[], None] = lambda: None,
        alike: Callable[[Any], Any] = lambda item: None,
    ) -> None:
        self._function, self._budget, self._prepare, self._alike = function, budget, prepare, alike
        forks = "fork" in get_all_start_methods() and not current_process().daemon
        self._workers: list[_Worker] = []
        self._workers += [_Worker(function, budget, self._workers) for _ in range(count if forks else 0)]
        finalize(self, _end_all, self._workers)  # at the latest when Python exits

    def __enter__(self) -> Workers:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def call(self, item: Any, seconds: float | None = None) -> Any:
        """Returns function(item), sent by pickle both ways. Raises OutOfBudget past the budget or past
        `seconds` of wall time, and the exceptions of the function."""
        (answer,) = self.map([item], seconds)
        if isinstance(answer, OutOfBudget):
            raise answer
        return answer

    def map(
        self,
        items: Iterable[Any],
        seconds: float | None = None,
        meanwhile: Callable[[], None] = lambda: None,
    ) -> Generator[Any]:
        """Yields function(item) for each item, in order; an OutOfBudget stands for a call that was ended.

        Raises the exceptions of the function. meanwhile: called once, when all processes are busy.
        """
        if not self._workers:
            yield from map(self._function, items)
            return
        asked = list(enumerate(items))
        if asked and not any(worker.runs for worker in self._workers):
            self._prepare()
        waiting = deque(deque(run) for _, run in groupby(asked, lambda each: self._alike(each[1])))
        free = list(self._workers)
        places: dict[_Worker, int] = {}
        answers: dict[int, Any] = {}
        try:
            self._ask(free, waiting, places, seconds)
            meanwhile()
            for place, _ in asked:
                while place not in answers:
                    for worker in _answering(places):
                        answers[places.pop(worker)] = worker.answer()
                        free.append(worker)
                    self._ask(free, waiting, places, seconds)
                answer = answers.pop(place)
                if isinstance(answer, _Raised):
                    raise answer.error
                yield answer
        finally:
            for worker in places:
                worker.end()
            for worker in self._workers:
                worker.queue.clear()

    def _ask(
        self,
        free: list[_Worker],
        waiting: deque[deque[tuple[int, Any]]],
        places: dict[_Worker, int],
        seconds: float | None,
    ) -> None:
        """Sends waiting items to the free processes; `places` maps a process to the index of its item."""
        while free and (waiting or any(worker.queue for worker in self._workers)):
            worker = free.pop()
            places[worker], item = self._next(worker, waiting)
            worker.ask(item, seconds)

    def _next(self, worker: _Worker, waiting: deque[deque[tuple[int, Any]]]) -> tuple[int, Any]:
        """Returns the next item of the worker's run or of a new run; at the end, the last item of the longest
        run."""
        if not worker.queue and not waiting:
            return max(self._workers, key=lambda other: len(other.queue)).queue.pop()
        if not worker.queue:
            worker.queue = waiting.popleft()
        return worker.queue.popleft()

    def close(self) -> None:
        """Ends the processes; a later call starts them again."""
        _end_all(self._workers)


class _Raised:
    """An exception of a call, to be raised in the caller."""

    def __init__(self, error: Exception) -> None:
        self.error = error


class _Worker:
    """One process, forked for the first call and again after a call that was ended."""

    def __init__(
        self, function: Callable[[Any], Any], budget: Budget | None, siblings: Sequence[_Worker]
    ) -> None:
        self._function, self._budget, self._siblings = function, budget, siblings
        self.queue: deque[tuple[int, Any]] = deque()  # items to be asked, with their indices
        self._owner = os.getpid()
        self._process: Any = None
        self._pipe: Connection | None = None
        self.end_at: float | None = None

    @property
    def runs(self) -> bool:
        return self._process is not None

    @property
    def pipe(self) -> Connection:
        """The connection to the running process."""
        assert self._pipe is not None, "the process does not run"
        return self._pipe

    def ask(self, item: Any, seconds: float | None) -> None:
        if self._process is not None and not self._process.is_alive():
            self.end()
        if self._process is None:
            self._start()
        if seconds is None and self._budget is not None:
            seconds = max(LEAST, PATIENCE * self._budget.seconds)
        self.end_at = None if seconds is None else monotonic() + seconds
        self.pipe.send(item)

    def answer(self) -> Any:
        """Returns the result of the call; an OutOfBudget if it was ended or has to be ended now."""
        if not self.pipe.poll():
            self.end()
            return OutOfBudget("not decided in time")
        try:
            answer = self.pipe.recv()
        except EOFError:
            answer = self._cause_of_end()
        if isinstance(answer, _Raised) and isinstance(answer.error, MemoryError):
            self.end()
            return self._out_of_memory()
        return answer

    def end(self) -> None:
        if self._process is not None and os.getpid() == self._owner:  # not in a process forked from it
            self._process.kill()
            self._process.join()
            self.pipe.close()
            self._process = self._pipe = None

    def _cause_of_end(self) -> OutOfBudget:
        self._process.join()
        code = self._process.exitcode
        self.end()
        if code == -signal.SIGPROF and self._budget is not None:
            return OutOfBudget(f"not decided within {self._budget.seconds:g} s of processor time")
        return self._out_of_memory()

    def _out_of_memory(self) -> OutOfBudget:
        if self._budget is None:
            return OutOfBudget("its process ended before it came to an answer")
        return OutOfBudget(f"not decided within {self._budget.megabytes:g} MB of memory")

    def _start(self) -> None:
        context = get_context("fork")
        self._pipe, theirs = context.Pipe()
        self._process = context.Process(target=self._serve, args=(theirs,))
        stdin, sys.stdin = sys.stdin, None  # type: ignore[assignment]  # closing it would interrupt a reader
        try:
            self._process.start()
        finally:
            sys.stdin = stdin
        theirs.close()

    def _serve(self, pipe: Connection) -> None:
        gc.set_threshold(1_000_000, 10, 10)  # few cycles arise, and calls are short
        gc.freeze()  # do not scan what was loaded before the fork; scanning takes a tenth of the time
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches all processes; the caller ends this one
        signal.signal(signal.SIGPROF, signal.SIG_DFL)
        for worker in self._siblings:
            if worker.runs:
                worker.pipe.close()
        if self._budget is not None:
            _limit_memory(self._budget.megabytes)
        try:
            while True:
                item = pipe.recv()
                self._spend(0 if self._budget is None else self._budget.seconds)
                answer = self._called(item)
                self._spend(0)
                pipe.send(answer)
        except (EOFError, OSError):
            os._exit(0)

    def _called(self, item: Any) -> Any:
        try:
            return self._function(item)
        except Exception as error:  # the caller raises it
            return _Raised(error)

    @staticmethod
    def _spend(seconds: float) -> None:
        """Sets the limit of further processor time after which the system ends this process; 0: no limit."""
        signal.setitimer(signal.ITIMER_PROF, seconds)


def _end_all(workers: Iterable[_Worker]) -> None:
    for worker in workers:
        worker.end()


def _answering(workers: Iterable[_Worker]) -> list[_Worker]:
    """Returns the workers that have answered or whose time is over; waits for at least one."""
    by_pipe = {worker.pipe: worker for worker in workers}
    end = min((worker.end_at for worker in by_pipe.values() if worker.end_at is not None), default=None)
    answered = [by_pipe[pipe] for pipe in _ready(list(by_pipe), end) if isinstance(pipe, Connection)]
    late = [w for w in by_pipe.values() if w.end_at is not None and w.end_at <= monotonic()]
    return list(dict.fromkeys(answered + late))


def _ready(pipes: list[Connection], end: float | None) -> list[Any]:
    """Returns the pipes with an answer; waits for one until `end`."""
    check = _check.get()
    while True:
        left = None if end is None else max(0.0, end - monotonic())
        if check is None:
            return connection.wait(pipes, left)
        check()
        if (ready := connection.wait(pipes, min(_CHECKED, left or _CHECKED))) or left == 0.0:
            return ready


def _limit_memory(megabytes: float) -> None:
    """Limits memory to the present size plus `megabytes`; sets no limit if the system does not report the
    size."""
    try:
        with open("/proc/self/status", encoding="ascii") as status:
            had = next(int(line.split()[1]) * 1024 for line in status if line.startswith("VmData"))
        resource.setrlimit(resource.RLIMIT_DATA, (had + int(megabytes * 1e6), resource.RLIM_INFINITY))
    except (OSError, StopIteration, ValueError):
        return
