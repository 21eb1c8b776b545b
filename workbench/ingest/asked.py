"""What comes of reading a formula, and which symbols the reader asked for on the way."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, ValuesView
from dataclasses import dataclass, field

from workbench.language.typed.names import Name
from workbench.language.typed.terms import Statement
from workbench.language.typed.types import Declaration


@dataclass
class Outcome:
    """What came of reading one formula: statements, or a message, and whether its types do not fit."""

    statements: tuple[Statement, ...] | None = None
    message: str = ""
    ill_formed: bool = False
    symbols: set[str] = field(default_factory=set)

    @property
    def stage(self) -> int:
        """How far the reader comes: 3 if it reads the formula, 2 if only its two sides do not fit."""
        if self.statements is not None:
            return 3
        return (2 if "the two sides differ" in self.message else 1) if self.ill_formed else 0

    @property
    def progress(self) -> tuple[bool, str]:
        """Whether the formula is read, and what keeps it from it."""
        return self.statements is not None, self.message


@dataclass
class Asks:
    """What the reader asks next, and what comes of each answer. name: whose kind; None: which are known."""

    name: Name | None
    then: dict[object, Asks | Outcome] = field(default_factory=dict)


@dataclass
class Asked(Mapping[Name, Declaration]):
    """Symbols, and what was asked of them."""

    symbols: Mapping[Name, Declaration]
    asked: dict[Name | None, None] = field(default_factory=dict)

    def __getitem__(self, name: Name) -> Declaration:
        self.asked[name] = None
        return self.symbols[name]

    def __iter__(self) -> Iterator[Name]:
        self.asked[None] = None
        return iter(self.symbols)

    def __len__(self) -> int:
        return len(self.symbols)

    def values(self) -> ValuesView[Declaration]:
        """The reader looks for a quaternion among them."""
        return self.symbols.values()
