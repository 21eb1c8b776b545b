"""The statements that a row of a display begins or continues, and the formulas that it adds to them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from workbench.source.rows.display_pieces import Piece, Separator, dangling
from workbench.source.rows.display_statements import Beside, Cut, Doubt, Leftover, Role, Statement
from workbench.source.rows.display_tree import Node, relation_places
from workbench.source.rows.display_vocabulary import Kind, Marks
from workbench.source.rows.row_rules import Layout

#: Roles of equations that are statements, too.
_SEPARATE = (Role.PERHAPS, Role.DEFINITION)


@dataclass
class State:
    """The state between rows.

    columns: the statement in each pair of columns.   waiting: conditions before their statement.
    denial: the words that deny the next statement.
    """

    cut: Cut = field(default_factory=Cut)
    columns: dict[int, Statement] = field(default_factory=dict)
    waiting: list[Beside] = field(default_factory=list)
    waiting_limits: list[str] = field(default_factory=list)
    denial: Node | None = None

    def leave(self, why: Leftover, nodes: Sequence[Node]) -> None:
        if kept := [node for node in nodes if node.tokens]:
            self.cut.leftovers.append((why, kept))


@dataclass(frozen=True)
class Row:
    pieces: Sequence[Piece]
    layout: Layout
    number: str | None
    labels: tuple[str, ...]


class RowStatements:
    """The statements of one row, to which its pieces are added in order."""

    def __init__(self, state: State, row: Row) -> None:
        self._state, self._row = state, row
        self._counts = {id(each): len(each.nodes) for each in state.cut.statements}
        self._made: list[Statement] = []
        self._here: Statement | None = None  # the statement before the next piece
        self._shared: Sequence[Statement] = ()  # the lines of a system before it
        self._last: Beside | None = None  # the formula that the previous piece was added to
        self._column = 0

    def _begin(self, piece: Piece) -> Statement:
        state, layout = self._state, self._row.layout
        statement = Statement(
            list(piece.kept),
            self._row.number,
            self._row.labels,
            denied=state.denial,
            whole=any(node.kind is Kind.IMPLICATION for node in piece.kept[1:]),
            begins_left=not layout.opens and layout.marks is not Marks.NONE,
            indent=piece.indent,
            ends_at_mark=piece.ends_at_mark,
        )
        state.denial = None
        state.cut.statements.append(statement)
        self._made.append(statement)
        self._take_waiting([statement])
        state.columns[self._column] = self._here = statement
        return statement

    def _take_waiting(self, statements: Sequence[Statement]) -> None:
        state = self._state
        for beside in state.waiting:
            beside.first = self._first_step() if beside.role is Role.REASON else 0
        for statement in statements:
            statement.beside += state.waiting
            statement.limits += state.waiting_limits
        if statements:
            state.waiting, state.waiting_limits = [], []

    def _append(self, target: Statement, piece: Piece, question: str, is_below: bool) -> bool:
        """Adds the piece to the statement; True if the comma or space before it was added, too."""
        ends = dangling(target.nodes)
        repeats = ends is not None and ends is piece.lead and target.nodes[-1].name == piece.kept[0].name
        if repeats or (ends is Kind.SIGN and piece.lead is Kind.SIGN and target.nodes[-1].name == "+"):
            self._state.leave(Leftover.REPEATED_SIGN, [target.nodes.pop()])
        if question:
            target.doubts.append(Doubt(len(target.nodes), question))
        signs = (Kind.RELATION, Kind.INFIX, Kind.IMPLICATION)
        is_listed = not is_below and piece.lead not in signs
        is_listed &= piece.lead is not Kind.SIGN or Separator.COMMA in piece.apart
        target.nodes += piece.separator if is_listed else []
        target.nodes += piece.kept
        target.ends_at_mark = piece.ends_at_mark
        target.whole = target.whole or any(node.kind is Kind.IMPLICATION for node in target.nodes[1:])
        return is_listed

    def _with_premises(self, target: Statement) -> Statement:
        """Returns the statement of a = b, c = d ⇒ e = f, which includes the equations before ⇒ in its row."""
        while len(self._made) > 1 and target is self._made[-1]:
            self._made.pop()
            self._state.cut.statements.remove(target)
            first = self._made[-1]
            first.beside = [b for b in first.beside if b.role not in _SEPARATE or b.nodes != target.nodes]
            first.beside += target.beside
            near = target.nodes[0].tokens[0]
            first.nodes += [Node(Kind.COMMA, [near.standing_for(",")], name=","), *target.nodes]
            target = first
        return target

    def _put_beside(self, role: Role, nodes: Sequence[Node], of_the_row: bool = False) -> None:
        is_of_the_row = of_the_row or role is Role.REASON
        beside = Beside(role, list(nodes), self._first_step() if is_of_the_row else 0)
        self._last = beside
        if self._here is None:
            self._state.waiting.append(beside)
        elif self._here in self._shared:
            for statement in self._shared:
                statement.beside.append(beside)
        else:
            self._here.beside.append(beside)

    def _limit(self, words: str) -> None:
        (self._state.waiting_limits if self._here is None else self._here.limits).append(words)

    def _first_step(self) -> int:
        """Returns the index of the first step that this row adds to the statement, or of the one that it
        continues."""
        if self._here is None:
            return 0
        before = self._here.nodes[: self._counts.get(id(self._here), 0)]
        steps = len(relation_places(self._here.nodes))
        return max(0, min(len(relation_places(before)), steps - 1))
