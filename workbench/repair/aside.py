"""Judgements in a process of their own, so that they can be ended: a proof may take minutes in one call."""

from __future__ import annotations

import multiprocessing
import os
import signal
from collections.abc import Sequence
from multiprocessing.connection import Connection
from time import monotonic

from workbench.judge.assumptions import Unsatisfiable
from workbench.judge.inventory import NotExact
from workbench.judge.judge import Judge
from workbench.judge.regular import is_regular
from workbench.judge.verdict import Verdict
from workbench.language.terms import IllFormed, Statement
from workbench.papers.orders import Orders


class OutOfTime(Exception):
    """A judgement was ended before it came to a verdict."""


class JudgeAside:
    """A judge in a forked process, which is made at the first statement and again after one that was ended.

    The process is forked so that terms keep their hashes and nothing is loaded anew. It writes to its pipe
    alone and never comes back to the caller's code, so it needs no lock that another thread may have held.
    """

    def __init__(self, judge: Judge, assume: Sequence[Statement] = (), orders: Orders | None = None) -> None:
        self._judge, self._assume, self._orders = judge, tuple(assume), orders
        self._process: multiprocessing.Process | None = None
        self._pipe: Connection | None = None

    def verdict(self, statement: Statement, seconds: float) -> Verdict | None:
        """None where the statement cannot be judged. Raises OutOfTime, and what the judge itself raises."""
        if self._process is None:
            self._start()
        end = monotonic() + seconds
        self._pipe.send(statement)
        if not self._pipe.poll(max(0.0, end - monotonic())):
            self.close()
            raise OutOfTime
        answer = self._pipe.recv()
        if isinstance(answer, Exception):
            raise answer
        return answer

    def close(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.join()
            self._pipe.close()
            self._process = self._pipe = None

    def _start(self) -> None:
        import workbench.judge.drake_ring
        import workbench.judge.sympy_ring  # noqa: F401  (both once here, not in every process)

        if self._orders is not None:
            is_regular(self._judge)
        context = multiprocessing.get_context("fork")
        self._pipe, theirs = context.Pipe()
        self._process = context.Process(target=self._serve, args=(theirs, self._pipe), daemon=True)
        self._process.start()
        theirs.close()

    def _serve(self, pipe: Connection, callers: Connection) -> None:
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches both; the caller ends this one
        callers.close()
        try:
            while True:
                pipe.send(self._judged(pipe.recv()))
        except (EOFError, OSError):
            os._exit(0)

    def _judged(self, statement: Statement) -> Verdict | Exception | None:
        try:
            return self._judge.judge(statement, assume=self._assume, orders=self._orders)
        except (Unsatisfiable, IllFormed, NotExact):
            return None
        except Exception as defect:  # for the caller to raise
            return defect
