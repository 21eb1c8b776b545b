"""What a kind of notation is tested with: a paper file without claims, and identities in it."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Kit:
    """notation: a paper file without claims.   identities: what holds there.   supposing: definitions that
    make what the identities suppose true, and that the judge is not told.   places: of frames, what the
    evaluator takes for the points."""

    notation: str
    identities: tuple[str, ...]
    supposing: dict[str, str] = field(default_factory=dict)
    places: dict[str, str] = field(default_factory=dict)


def lines(text: str) -> tuple[str, ...]:
    return tuple(line.strip() for line in text.strip().splitlines())
