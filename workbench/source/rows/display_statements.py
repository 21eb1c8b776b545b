"""What a display says: its statements, what stands beside each of them, and what is left over."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import Enum, auto

from workbench.source.documents import Display, Token
from workbench.source.rows.display_tree import Node
from workbench.source.rows.display_vocabulary import GAPS


class Role(Enum):
    """What an equation beside a statement is. PERHAPS: a statement of its own, or a condition."""

    CONDITION = auto()
    REASON = auto()
    RANGE = auto()
    PERHAPS = auto()


class Leftover(Enum):
    """Why tokens are in no statement."""

    LAYOUT = "layout"
    NUMBER = "a number set by hand"
    ELLIPSIS = "an ellipsis in place of a row"
    REPEATED_SIGN = "a sign that the next row repeats"
    OPEN_SIGN = "a sign without a side"
    NO_RELATION = "beside a statement, without a relation"
    OF_NOTHING = "a condition of no statement"


@dataclass(eq=False)
class Beside:
    """What stands beside a statement. first: the first of its steps that it is said of."""

    role: Role
    nodes: list[Node]
    first: int = 0


@dataclass(frozen=True)
class Doubt:
    """Two readings of a statement: as one, or as two that are parted before its node `at`."""

    at: int
    question: str


@dataclass(frozen=True)
class RowEnd:
    """Where a row of the display ends in a statement: the count of its nodes so far."""

    count: int
    number: str | None
    labels: tuple[str, ...]


@dataclass(eq=False)
class Statement:
    """One statement of a display.

    limits: words beside it that limit it.   denied: the words that deny it.   whole: whether it states more
    than one formula, as an implication does.   begins_left: whether its first row has something before the
    alignment mark.   is_condition_of: the statement that it may only be a condition of.   serves: the
    statements that it may be a condition of.   indent: the wide spaces before its first row.
    ends_at_mark: whether an alignment mark stands behind it."""

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
    rows: list[RowEnd] = field(default_factory=list)

    def shift(self, count: int) -> None:
        """Counts its nodes without the first `count`, which are left out."""
        self.rows = [RowEnd(end.count - count, end.number, end.labels) for end in self.rows]
        self.doubts = [Doubt(doubt.at - count, doubt.question) for doubt in self.doubts]


@dataclass
class Cut:
    """The statements of a display, the words beside them, and what is left over by its name."""

    statements: list[Statement] = field(default_factory=list)
    remarks: list[Node] = field(default_factory=list)
    leftovers: list[tuple[Leftover, list[Node]]] = field(default_factory=list)

    def places(self) -> Iterator[list[Node]]:
        """The nodes of each place that a token can be in."""
        for statement in self.statements:
            yield statement.nodes
            yield from (beside.nodes for beside in statement.beside)
        yield self.remarks
        yield from (nodes for _, nodes in self.leftovers)

    def lost(self, display: Display) -> list[Token]:
        """The printed tokens of the display that are nowhere in the cut: none, by the law of conservation."""
        held = {id(token) for nodes in self.places() for node in nodes for token in node.tokens}
        printed = (token for row in display.rows for token in row.tokens)
        return [token for token in printed if id(token) not in held and token.text not in GAPS]
