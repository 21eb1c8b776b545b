"""A budget of processor time and memory."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite


class OutOfBudget(Exception):
    """What was asked for was ended, because it cost more than it may."""


@dataclass(frozen=True)
class Budget:
    """seconds: of processor time for one judgement, so that a busy machine changes no verdict.
    megabytes: of memory that it may take beyond what the process has when it starts.

    Raises ValueError for anything but positive, finite numbers."""

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
        """The budget with the limits that are given and the standard ones else; None if none is given."""
        given = {name: value for name, value in limits.items() if value is not None}
        return Budget(**given) if given else None


#: What a judgement gets where nothing else is said.
STANDARD = Budget()
