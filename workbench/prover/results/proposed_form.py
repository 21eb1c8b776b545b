"""Proposals of the search, for the report and the cache."""

from __future__ import annotations

from dataclasses import dataclass

from workbench.core.verdict import Outcome


@dataclass(frozen=True)
class Proposed:
    """A correct form that the search proposes. difference: from the printed one, side by side
    (`Difference.parts`)."""

    latex: str
    edit: str
    difference: list[dict[str, str]]
    verdict: Outcome
