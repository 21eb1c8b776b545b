"""Parts of a claim that hold no statement: forms, source, sentence, fault and correction."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

#: The kinds of faults.
FAULTS = ("error", "misprint", "transcription", "wording", "hypothesis")


class ClaimForm(StrEnum):
    """The forms of a claim that are formulas."""

    PRINTED = "printed"
    READING = "reading"
    CORRECTED = "corrected"


@dataclass(frozen=True)
class ClaimSource:
    """The position of a claim in its paper, and remarks.

    Attributes:
        equation: The number of the equation.
        label: The label of its row, or of a display without numbers; not that of another numbered row.
        section: The number of the section.
        line: The line in the file, from 1.
        statement: The claim in words.
    """

    equation: str | None = None
    section: str | None = None
    file: Path | None = None
    line: int = 0
    statement: str | None = None
    note: str = ""
    label: str | None = None


@dataclass(frozen=True)
class Sentence:
    """The statement of a claim that is printed in words.

    Attributes:
        quote: The printed sentence.
        ours: Whether the formula of the claim is ours.
    """

    quote: str | None = None
    ours: bool = False


@dataclass(frozen=True)
class Edit:
    """A replacement of `old` by `new` in the printed text; an empty `new` deletes.

    Both are LaTeX if `is_math`, else prose with LaTeX between dollar signs.
    """

    old: str
    new: str
    is_math: bool


@dataclass(frozen=True)
class Mend:
    """A fault and its correction.

    Attributes:
        fault: The kind of the fault.
        edits: The edits of the printed formula, or of `beside`.
        beside: A sentence or formula next to the printed one.
        place: The position in the equation, in words.
        cause: The common cause of several faults, in words.
        add: A missing hypothesis in the author's own words.
        example: A counterexample in words, for faults that values of symbols do not explain.
        by: The claim whose edits also correct this one.
    """

    fault: str | None = None
    edits: tuple[Edit, ...] = ()
    beside: str | None = None
    place: str | None = None
    cause: str | None = None
    add: str | None = None
    example: str | None = None
    by: str | None = None
