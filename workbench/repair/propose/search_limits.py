"""Limits of the search for the right form."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Limits:
    """Limits of one search.

    Attributes:
        seconds: Wall time for one claim.
        judgement: Seconds for one candidate.
        candidates: The most candidates considered.
        proposals: The most proposals.
        judged: The most candidates of one stage that are judged.
        unscreened: The same if no random point can exclude candidates before, as with norms.
        readings: The most readings of an ill-formed claim whose neighbourhoods are searched.
    """

    seconds: float = 25.0
    judgement: float = 10.0
    candidates: int = 200_000
    proposals: int = 6
    judged: int = 40
    unscreened: int = 400
    readings: int = 12


#: The default limits. Results are the same on all machines unless time runs out (`Repair.complete`).
STANDARD = Limits()
