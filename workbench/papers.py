"""Paper files: the claims of a paper, its symbols and its definitions, as TOML says them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbench.judge.verdict import Verdict
    from workbench.language.definitions import Definitions
    from workbench.language.symbols import SymbolTable
    from workbench.language.terms import Statement


class PaperError(ValueError):
    """A paper file that cannot be used; line and column count from 1."""

    def __init__(self, file: Path | str, line: int | None, column: int | None, message: str) -> None:
        place = ":".join(str(part) for part in (file, line, column) if part is not None)
        super().__init__(f"{place}: {message}")
        self.file, self.line, self.column, self.message = Path(file), line, column, message


_MOST_INSTANCES = 1000
_ONE_ORDER = re.compile(r"\s*([A-Za-z])\s*=\s*(\d{1,6})\s*\.\.\s*(\d{1,6})\s*")


@dataclass(frozen=True)
class Orders:
    """The values of the integer variables of a family: `n = 1..8`, or `m = 1..3, n = 1..4`; ends included."""

    ranges: Mapping[str, range]

    @staticmethod
    def parse(text: str) -> Orders:
        """Raises ValueError on anything but `variable = first..last`, separated by commas."""
        ranges: dict[str, range] = {}
        for part in text.split(","):
            match = _ONE_ORDER.fullmatch(part)
            if match is None:
                raise ValueError(f"orders: expected `n = 1..8` or `m = 1..3, n = 1..4`, got {text!r}")
            name, first, last = match[1], int(match[2]), int(match[3])
            if first > last:
                raise ValueError(f"orders: {name} runs from {first} to {last}, which is empty")
            if name in ranges:
                raise ValueError(f"orders: {name} is given twice")
            ranges[name] = range(first, last + 1)
        orders = Orders(ranges)
        if orders.count > _MOST_INSTANCES:
            raise ValueError(f"orders: {orders.count} instances, more than {_MOST_INSTANCES}")
        return orders

    @property
    def variables(self) -> tuple[str, ...]:
        return tuple(self.ranges)

    @property
    def count(self) -> int:
        count = 1
        for values in self.ranges.values():
            count *= len(values)
        return count

    def assignments(self) -> Iterator[dict[str, int]]:
        """Every combination of values, the last variable fastest."""
        for values in product(*self.ranges.values()):
            yield dict(zip(self.ranges, values, strict=True))

    def __str__(self) -> str:
        return ", ".join(f"{name} = {r.start}..{r.stop - 1}" for name, r in self.ranges.items())


@dataclass(frozen=True)
class Formula:
    """LaTeX as the file has it, and what was read: a statement, or why it is ill-formed."""

    latex: str
    statement: Statement | None = None
    ill_formed: str | None = None

    def __str__(self) -> str:
        return self.latex


@dataclass(frozen=True)
class Claim:
    """One `[[claim]]` of a paper file, or one line of it. `statement` and `theorem` belong together: what one
    identity cannot say, in words, and the name of its proof in the installed paper."""

    id: str
    printed: Formula
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


@dataclass(frozen=True)
class Paper:
    """A paper: what its symbols are, and its claims in reading order. `theorems`: name → proof."""

    title: str
    doi: str | None
    paths: tuple[Path, ...]
    symbols: SymbolTable
    definitions: Definitions
    motion: Mapping[str, str]
    claims: tuple[Claim, ...]
    theorems: Mapping[str, Callable[[], Verdict]] = field(default_factory=dict)


@dataclass(frozen=True)
class InstalledPaper:
    """What the entry points of the group `workbench.papers` name: the claim files of a paper in reading order
    and the theorems that they refer to."""

    files: tuple[Path, ...]
    theorems: Mapping[str, Callable[[], Verdict]] = field(default_factory=dict)
