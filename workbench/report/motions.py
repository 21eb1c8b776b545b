"""Which claims Drake's motions were asked about, and why the others were not."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Unseen:
    """What has one reason in common. places: headings and anchors, each once."""

    reason: str
    count: int
    places: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Motions:
    """How many of the claims were evaluated on motions, and the others by their reasons."""

    seen: int
    claims: int
    unseen: tuple[Unseen, ...]


def motions_of(claims: Sequence[Mapping[str, Any]], places: Mapping[str, tuple[str, str]]) -> Motions | None:
    """None for a paper of which nothing was evaluated. places: id → heading and anchor."""
    reasons: dict[str, list[tuple[str, str]]] = {}
    for claim in claims:
        motion = claim.get("motion") or {}
        if motion.get("witness") != "Drake":
            reasons.setdefault(motion.get("because") or "not judged", []).append(places[claim["id"]])
    unseen = [
        Unseen(reason, len(found), tuple(reversed(dict(reversed(found)).items())))
        for reason, found in sorted(reasons.items())
    ]
    seen = len(claims) - sum(each.count for each in unseen)
    return Motions(seen, len(claims), tuple(unseen)) if seen else None
