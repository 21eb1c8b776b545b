"""What the search proposes, for whoever shows or keeps it."""

from __future__ import annotations

from dataclasses import dataclass

from workbench.core.verdict import Outcome


@dataclass(frozen=True)
class Proposed:
    """A right form that the machine proposes. difference: from the printed one, side by side
    (`Difference.parts`)."""

    latex: str
    edit: str
    difference: list[dict[str, str]]
    verdict: Outcome
