"""The cutter: from the tree of a display to its statements, with the formulas next to each of them.

Every printed token of the display is in one statement, condition, reason, range, remark or named leftover.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from workbench.language.grammar.vocabulary import NUMBER
from workbench.source.documents import Display, joined
from workbench.source.rows.display_pieces import Piece, dangling, pieces_of
from workbench.source.rows.display_statements import Cut, Leftover, Statement
from workbench.source.rows.display_tree import (
    Cell,
    Node,
    pairs_of,
    parse,
    relation_places,
    rows_of,
    trim,
    trimmed,
    without,
)
from workbench.source.rows.display_vocabulary import ARROWS, ELLIPSES, LINES, MATRICES_OF_LINES, Kind, Marks
from workbench.source.rows.notes import with_notes
from workbench.source.rows.row_reader import RowReader
from workbench.source.rows.row_rules import Layout
from workbench.source.rows.row_statements import Row, State

#: Brackets around the rows of a system.
_SYSTEM_BRACKETS = ("{", "left\\{", "left.", "left\\lbrace", "left[", "left(")


@dataclass(frozen=True)
class _Line:
    """A row of the display or of an environment in it."""

    cells: list[Cell]
    number: str | None
    labels: tuple[str, ...]


def cut_display(display: Display) -> Cut:
    """Returns the statements of the display."""
    cutter = _Cutter()
    base = display.environment.rstrip("*")
    lines = [
        _Line(cells, row.number, row.labels) for row in display.rows for cells in rows_of(parse(row.tokens))
    ]
    is_aligned = LINES.get(base, Marks.NONE) is not Marks.NONE or base in ("gather", "multline")
    if len(display.rows) == 1 and not is_aligned:
        row = display.rows[0]
        cutter.content(parse(row.tokens), row.number, row.labels)
    elif len(lines) == 1 and len(lines[0].cells) == 1:
        cutter.content(lines[0].cells[0], lines[0].number, lines[0].labels)
    else:
        cutter.lines(lines, base)
    return cutter.done()


@dataclass
class _Cutter:
    state: State = field(default_factory=State)

    @property
    def cut(self) -> Cut:
        return self.state.cut

    def content(self, nodes: list[Node], number: str | None, labels: tuple[str, ...]) -> None:
        """Reads one formula, or an environment of lines with the text next to it."""
        nodes = self._without_brackets(nodes)
        if any(node.kind is Kind.BREAK for node in nodes):
            rows = rows_of(nodes)
            base = "aligned" if any(node.kind is Kind.MARK for node in nodes) else "lines"
            self.lines([_Line(cells, number, labels) for cells in rows], base)
            return
        line = _Line(rows_of(nodes)[0], number, labels)
        self._row(line, Layout(Marks.NONE, "", opens=False), may_hold_lines=True)

    def lines(self, lines: Sequence[_Line], base: str) -> None:
        """Reads the rows of an environment."""
        base = base.rstrip("*")
        has_marks = any(len(line.cells) > 1 for line in lines)
        marks = LINES.get(base, Marks.CELLS if has_marks else Marks.NONE)
        flat = [node for line in lines for cell in line.cells for node in cell]
        for place in pairs_of(flat)[0]:
            flat[place].paired = True
        outer, self.state.columns = self.state.columns, {}
        for line in lines:
            opens = len(line.cells) > 1 and not trimmed(line.cells[0])
            self._row(line, Layout(marks, base, opens), may_hold_lines=marks is Marks.NONE)
        self.state.columns = outer

    def _without_brackets(self, nodes: list[Node]) -> list[Node]:
        """Returns the nodes of {a = b}, and the rows of a system, without the bracket around them."""
        kept, around = trim(nodes)
        if len(kept) != 1 or kept[0].kind is not Kind.GROUP or kept[0].name not in _SYSTEM_BRACKETS:
            return nodes
        inner = trimmed(kept[0].inside)
        is_system = len(inner) == 1 and is_lines(inner[0])
        is_lines_in_a_brace = kept[0].name in _SYSTEM_BRACKETS[1:4]
        if not (is_system and is_lines_in_a_brace) and not (kept[0].name == "{" and relation_places(inner)):
            return nodes
        self.state.leave(Leftover.LAYOUT, around)
        self.state.leave(Leftover.LAYOUT, [Node(Kind.NOTHING, without(kept, *kept[0].inside))])
        return self._without_brackets(kept[0].inside)

    def _row(self, line: _Line, layout: Layout, may_hold_lines: bool) -> None:
        pieces = pieces_of(line.cells, layout.marks)
        for piece in pieces:
            self.state.leave(Leftover.LAYOUT, piece.around)
        row = Row(pieces, layout, line.number, line.labels)
        reader = RowReader(self.state, row)
        for place, piece in enumerate(pieces):
            self._number_behind_lines(piece)
            if not piece.kept or _is_ellipsis(piece, pieces):
                self.state.leave(Leftover.LAYOUT, piece.separator)
                self.state.leave(Leftover.ELLIPSIS, piece.kept)
            elif may_hold_lines and reader.begins(piece) and (system := system_in(piece.kept)) is not None:
                self._system(piece, system, line, reader)
            else:
                reader.read(place)
        reader.end()

    def _system(self, piece: Piece, system: Node, line: _Line, reader: RowReader) -> None:
        """Reads the rows of an environment within a row; the text after it applies to each of them."""
        around = without([*piece.separator, *piece.kept], *system.inside)
        self.state.leave(Leftover.LAYOUT, [Node(Kind.NOTHING, around)])
        first = len(self.cut.statements)
        self.lines([_Line(cells, line.number, line.labels) for cells in system.rows], system.name)
        reader.stands_behind(self.cut.statements[first:])

    def _number_behind_lines(self, piece: Piece) -> None:
        """Moves a number set by hand after an environment of lines to the leftovers."""
        places = [at for at, node in enumerate(piece.kept) if is_lines(node) and node.name != "array"]
        if places and (behind := trimmed(piece.kept[places[-1] + 1 :])) and is_number(behind):
            self.state.leave(Leftover.NUMBER, piece.kept[places[-1] + 1 :])
            piece.kept = piece.kept[: places[-1] + 1]

    def done(self) -> Cut:
        """Returns the cut after all rows are read."""
        for statement in self.cut.statements:
            self._without_open_signs(statement)
            statement.whole = statement.whole or _maps(statement.nodes)
            with_notes(statement)
        for statement in [each for each in self.cut.statements if not each.nodes]:
            self.cut.statements.remove(statement)
            self.state.waiting += statement.beside
        if self.cut.statements and not self.cut.statements[-1].explains:
            self.cut.statements[-1].beside += self.state.waiting
        else:
            for beside in self.state.waiting:
                self.state.leave(Leftover.OF_NOTHING, beside.nodes)
        return self.cut

    def _without_open_signs(self, statement: Statement) -> None:
        """Moves relation signs at both ends of a statement to the leftovers; a continuation is judged
        separately."""
        nodes = statement.nodes
        while nodes and nodes[0].kind in (Kind.IMPLICATION, Kind.RELATION):
            self.state.leave(Leftover.OPEN_SIGN, nodes[:1])
            kept, around = trim(nodes[1:])
            self.state.leave(Leftover.LAYOUT, around)
            statement.shift(len(nodes) - len(kept) if kept else len(nodes))
            nodes = statement.nodes = kept
        while nodes and dangling(nodes) is Kind.RELATION:
            self.state.leave(Leftover.OPEN_SIGN, nodes[-1:])
            kept, around = trim(nodes[:-1])
            self.state.leave(Leftover.LAYOUT, around)
            nodes = statement.nodes = kept


def is_lines(node: Node) -> bool:
    """True for an environment of lines."""
    return node.kind is Kind.ENVIRONMENT and node.name.rstrip("*") in LINES


def is_number(nodes: Iterable[Node]) -> bool:
    """True if the nodes print the number of a formula, such as (2.1)."""
    return NUMBER.fullmatch(joined([token for node in nodes for token in node.tokens])) is not None


def system_in(kept: list[Node]) -> Node | None:
    """Returns the environment of lines that the nodes consist of, perhaps in a bracket; else None."""
    if len(kept) == 1 and kept[0].kind is Kind.GROUP and kept[0].name in _SYSTEM_BRACKETS[:4]:
        kept = trimmed(kept[0].inside)
    elif len(kept) == 2 and kept[0].kind is Kind.OPEN:
        kept = kept[1:]
    if len(kept) != 1 or kept[0].kind is not Kind.ENVIRONMENT:
        return None
    node = kept[0]
    filled = [row for row in node.rows if trimmed(row[0]) or len(row) > 1]
    if node.name.rstrip("*") in MATRICES_OF_LINES:
        return node if all(len(row) == 1 and relation_places(row[0]) for row in filled) else None
    if node.name == "array" and not any(relation_places(cell) for row in filled for cell in row):
        return None
    return node if is_lines(node) else None


def _is_ellipsis(piece: Piece, pieces: Sequence[Piece]) -> bool:
    """True if the row contains only dots."""
    is_only = sum(bool(each.kept) for each in pieces) == 1
    return is_only and all(node.name in ELLIPSES or node.kind in (Kind.STOP, Kind.GAP) for node in piece.kept)


def _maps(nodes: Sequence[Node]) -> bool:
    """True if a = b \\to c = d is an implication, and not a map."""
    arrows = [at for at in relation_places(nodes) if nodes[at].name in ARROWS]
    return bool(arrows) and all(
        any(node.name == "=" for node in part) for at in arrows for part in (nodes[:at], nodes[at + 1 :])
    )
