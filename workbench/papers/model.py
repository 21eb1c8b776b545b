"""What a paper file says: the paper, its notation and its claims."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from workbench.judge.verdict import Outcome
from workbench.papers.orders import Orders

if TYPE_CHECKING:
    from workbench.judge.verdict import Verdict
    from workbench.language.definitions import Definitions
    from workbench.language.symbols import SymbolTable
    from workbench.language.terms import Statement, Symbol


class PaperError(ValueError):
    """A paper that cannot be used: the file and, where the fault has one, the line and column, from 1."""

    def __init__(self, file: Path | str | None, line: int | None, column: int | None, message: str) -> None:
        place = ":".join(str(part) for part in (file, line, column) if part is not None)
        super().__init__(f"{place}: {message}" if place else message)
        self.file, self.line, self.column, self.message = file, line, column, message

    def __reduce__(self) -> tuple:
        """So that it can come from another process."""
        return PaperError, (self.file, self.line, self.column, self.message)


@dataclass(frozen=True)
class Formula:
    """LaTeX as the file has it, and what was read: a statement, or why it is ill-formed."""

    latex: str
    statement: Statement | None = None
    ill_formed: str | None = None

    def __str__(self) -> str:
        return self.latex


@dataclass(frozen=True)
class Notation:
    """What the formulas of one file are written in. `motion`: symbol → its name on Drake's motions."""

    symbols: SymbolTable
    definitions: Definitions
    motion: Mapping[Symbol, str]


@dataclass(frozen=True)
class Claim:
    """One `[[claim]]` of a paper file, or one line of it. `statement` and `theorem` belong together: what one
    identity cannot say, in words, and the name of its proof in the installed paper."""

    id: str
    printed: Formula
    notation: Notation
    equation: str | None = None
    section: str | None = None
    reading: Formula | None = None
    corrected: Formula | None = None
    hypothesis: Formula | None = None
    assume: tuple[Formula, ...] = ()
    orders: Orders | None = None
    note: str = ""
    inherits: tuple[str, ...] = ()
    statement: str | None = None
    theorem: str | None = None
    file: Path | None = None
    line: int = 0

    @property
    def expected(self) -> Outcome:
        """What the keys of the claim say of its printed form."""
        if self.reading is not None:
            return Outcome.ILL_FORMED
        if self.corrected is not None:
            return Outcome.REFUTED
        return Outcome.PROVED if self.hypothesis is None else Outcome.CONDITIONAL

    @property
    def supposed(self) -> tuple[Statement, ...]:
        """The conditions that the text states."""
        return tuple(formula.statement for formula in self.assume)

    @property
    def instances(self) -> list[dict[str, int]]:
        """All values of the claim's integers; {} alone for a claim without any."""
        return list(self.orders.assignments()) if self.orders else [{}]


@dataclass(frozen=True)
class Paper:
    """A paper and its claims in reading order.

    notation: that of its one file; of several files, the first notation file that one of them names, or else
    that of the first. Each claim carries its own.   theorems: name → proof.
    """

    title: str
    doi: str | None
    paths: tuple[Path, ...]
    notation: Notation
    claims: tuple[Claim, ...]
    theorems: Mapping[str, Callable[[], Verdict]] = field(default_factory=dict)

    @property
    def symbols(self) -> SymbolTable:
        return self.notation.symbols

    @property
    def definitions(self) -> Definitions:
        return self.notation.definitions

    @property
    def motion(self) -> Mapping[Symbol, str]:
        return self.notation.motion


@dataclass(frozen=True)
class InstalledPaper:
    """What the entry points of the group `workbench.papers` name: the claim files of a paper in reading order
    and the theorems that they refer to."""

    files: tuple[Path, ...]
    theorems: Mapping[str, Callable[[], Verdict]] = field(default_factory=dict)
