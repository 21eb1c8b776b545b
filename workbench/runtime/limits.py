"""Limits on processor time and memory."""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite


class OutOfBudget(Exception):
    """A call was ended because it exceeded its budget."""


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
