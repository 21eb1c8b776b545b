"""Contents of a display: its statements, the formulas next to each of them, and the leftovers."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import Enum, auto

from workbench.source.documents import Display, Token
from workbench.source.rows.display_tree import Node
from workbench.source.rows.display_vocabulary import GAPS


class Role(Enum):
    """The role of an equation next to a statement.

    DEFINITION: a separate statement that defines a symbol of it, as in "where f = g^2".
    PERHAPS: a separate statement or a condition.
    """

    CONDITION = auto()
    REASON = auto()
    RANGE = auto()
    DEFINITION = auto()
    PERHAPS = auto()


class Leftover(Enum):
    """Reasons why tokens are in no statement."""

    LAYOUT = "layout"
    NUMBER = "a number set by hand"
    ELLIPSIS = "an ellipsis in place of a row"
    REPEATED_SIGN = "a sign that the next row repeats"
    OPEN_SIGN = "a sign without a side"
    NO_RELATION = "beside a statement, without a relation"
    OF_NOTHING = "a condition of no statement"


@dataclass(eq=False)
class Beside:
    """A formula next to a statement. first: the first step that it applies to."""

    role: Role
    nodes: list[Node]
    first: int = 0


@dataclass(frozen=True)
class Doubt:
    """Two readings of a statement: as one, or split before its node `at`."""

    at: int
    question: str


@dataclass(frozen=True)
class RowEnd:
    """The end of a row of the display in a statement: the count of its nodes so far."""

    count: int
    number: str | None
    labels: tuple[str, ...]


@dataclass(eq=False)
class Statement:
    """One statement of a display.

    limits: words next to it that limit it.   denied: the words that deny it.
    whole: True if it contains several formulas, as an implication does.
    begins_left: True if its first row has text before the alignment mark.
    is_condition_of: the statement that it may only be a condition of.
    serves: the statements that it may be a condition of.   indent: the wide spaces before its first row.
    ends_at_mark: True if an alignment mark follows it.
    explains: True if it defines a symbol of a statement next to it, as in "where f = g^2".
    """

    nodes: list[Node]
    number: str | None = None
    labels: tuple[str, ...] = ()
    beside: list[Beside] = field(default_factory=list)
    doubts: list[Doubt] = field(default_factory=list)
    limits: list[str] = field(default_factory=list)
    denied: Node | None = None
    whole: bool = False
    begins_left: bool = False
    is_condition_of: Statement | None = None
    serves: tuple[Statement, ...] = ()
    indent: int = 0
    ends_at_mark: bool = False
    explains: bool = False
    rows: list[RowEnd] = field(default_factory=list)

    def shift(self, count: int) -> None:
        """Shifts the indices after the first `count` nodes are removed."""
        self.rows = [RowEnd(end.count - count, end.number, end.labels) for end in self.rows]
        self.doubts = [Doubt(doubt.at - count, doubt.question) for doubt in self.doubts]


@dataclass
class Cut:
    """The statements of a display, the words next to them, and the leftovers by name."""

    statements: list[Statement] = field(default_factory=list)
    remarks: list[Node] = field(default_factory=list)
    leftovers: list[tuple[Leftover, list[Node]]] = field(default_factory=list)

    def places(self) -> Iterator[list[Node]]:
        """Yields the nodes of each part that a token can be in."""
        for statement in self.statements:
            yield statement.nodes
            yield from (beside.nodes for beside in statement.beside)
        yield self.remarks
        yield from (nodes for _, nodes in self.leftovers)

    def lost(self, display: Display) -> list[Token]:
        """Returns the printed tokens of the display that the cut lacks; there must be none."""
        held = {id(token) for nodes in self.places() for node in nodes for token in node.tokens}
        printed = (token for row in display.rows for token in row.tokens)
        return [token for token in printed if id(token) not in held and token.text not in GAPS]
