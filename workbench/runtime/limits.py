"""Limits on processor time and memory."""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from math import isfinite
from types import FrameType


class OutOfBudget(Exception):
    """A call was ended because it exceeded its budget."""


#: Seconds of processor time after which an ignored exception is raised again.
_AGAIN = 0.01


class OutOfTime(BaseException):
    """A part of a call was ended because it exceeded its processor time. Only `within` catches it."""


@contextmanager
def within(seconds: float) -> Iterator[None]:
    """Ends its body after that much processor time, without an error.

    There is no limit outside of a main thread, and on systems without timers of processor time. Python
    ignores an exception in a callback of a weak reference or in __del__; it is raised again right after.
    """
    if not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return

    def end(number: int, frame: FrameType | None) -> None:
        raise OutOfTime

    def ignored(told: sys.UnraisableHookArgs) -> None:
        if told.exc_type is OutOfTime:
            signal.setitimer(signal.ITIMER_VIRTUAL, _AGAIN)
        else:
            hook(told)

    hook = sys.unraisablehook
    before = signal.signal(signal.SIGVTALRM, end)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
    sys.unraisablehook = ignored
    try:
        yield
    except OutOfTime:
        pass
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)
        sys.unraisablehook = hook


@dataclass(frozen=True)
class Budget:
    """Limits of one judgement.

    seconds: processor time, so that the load of the machine changes no verdict.
    megabytes: memory beyond that of the process at its start.

    Raises ValueError for numbers that are not positive and finite.
    """

    seconds: float = 20.0
    megabytes: float = 4000.0

    def __post_init__(self) -> None:
        for name in ("seconds", "megabytes"):
            value = getattr(self, name)
            if isinstance(value, bool) or not isinstance(value, int | float):
                raise ValueError(f"{name}: expected a positive number, got {value!r}")
            if not (isfinite(value) and value > 0):
                raise ValueError(f"{name}: expected a positive number, got {value}")

    @staticmethod
    def of(**limits: float | None) -> Budget | None:
        """Returns a budget with the given limits and the standard ones otherwise; None if no limit is
        given."""
        given = {name: value for name, value in limits.items() if value is not None}
        return Budget(**given) if given else None


#: The default budget of a judgement.
STANDARD = Budget()
