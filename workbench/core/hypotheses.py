"""The condition of a conditional verdict: formulas and words of the text."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Phrase:
    """A part of a condition: LaTeX, or words with formulas between dollar signs."""

    text: str
    is_words: bool = False

    @property
    def prose(self) -> str:
        return self.text if self.is_words else f"${self.text}$"


@dataclass(frozen=True)
class Hypothesis:
    """What holds if all of its phrases do. Its text is LaTeX if no phrase is words, and prose otherwise."""

    phrases: tuple[Phrase, ...]

    @staticmethod
    def of(*latex: str) -> Hypothesis:
        return Hypothesis(tuple(map(Phrase, dict.fromkeys(latex))))

    @staticmethod
    def together(conditions: Iterable[Hypothesis | None], *phrases: Phrase) -> Hypothesis:
        """Returns the condition that all of them hold, each phrase once."""
        known = (phrase for each in conditions if each is not None for phrase in each.phrases)
        return Hypothesis(tuple(dict.fromkeys((*known, *phrases))))

    @staticmethod
    def from_list(data: Sequence[Sequence[Any]]) -> Hypothesis:
        """Inverts `to_list`. Raises TypeError for other data."""
        return Hypothesis(tuple(Phrase(*each) for each in data))

    def to_list(self) -> list[list[Any]]:
        return [[each.text, each.is_words] for each in self.phrases]

    @property
    def has_words(self) -> bool:
        return any(each.is_words for each in self.phrases)

    @property
    def prose(self) -> str:
        return str(self) if self.has_words else f"${self}$"

    def __str__(self) -> str:
        return ", ".join(each.prose if self.has_words else each.text for each in self.phrases)
