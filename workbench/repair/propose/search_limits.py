"""How far a search for the right form goes."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Limits:
    """seconds: of wall time for one claim. judgement: seconds for one candidate. candidates: looked at.
    proposals: made. judged: candidates of one stage that are given to the judge; unscreened: so many where no
    random point tells right from wrong before, as with norms. readings: of an ill-formed claim, whose
    neighbourhoods are searched."""

    seconds: float = 25.0
    judgement: float = 10.0
    candidates: int = 200_000
    proposals: int = 6
    judged: int = 40
    unscreened: int = 400
    readings: int = 12


#: What one claim gets by default. Results are the same everywhere, unless time runs out (`Repair.complete`).
STANDARD = Limits()
