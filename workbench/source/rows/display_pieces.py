"""Pieces of a row: the parts between alignment marks, commas, wide spaces, words and quantifiers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from enum import Enum, auto

from workbench.source.rows.display_tree import Cell, Node, relation_places, trim, trimmed, with_depth
from workbench.source.rows.display_vocabulary import VISIBLE_GAPS, Kind, Marks
from workbench.source.rows.side_words import is_name


class Separator(Enum):
    """The separators before a piece. PAIR: the mark of a further pair of columns."""

    START = auto()
    MARK = auto()
    PAIR = auto()
    COMMA = auto()
    WIDE = auto()
    WORDS = auto()
    COLON = auto()
    FORALL = auto()


_SEPARATORS = {
    Kind.WIDE: Separator.WIDE,
    Kind.GAP: Separator.WIDE,
    Kind.COMMA: Separator.COMMA,
    Kind.FORALL: Separator.FORALL,
}


@dataclass(eq=False)
class Piece:
    """A piece of a row.

    kept: its nodes without the blanks around them, which are `around`.
    separator: the comma, space or quantifier before it.   indent: the wide spaces before it.
    ends_at_mark: True if an alignment mark follows it.
    """

    nodes: list[Node]
    apart: set[Separator]
    separator: list[Node] = field(default_factory=list)
    indent: int = 0
    kept: list[Node] = field(default_factory=list)
    around: list[Node] = field(default_factory=list)
    ends_at_mark: bool = False

    def closed(self) -> Piece:
        """Returns the piece with `kept` and `around` set."""
        self.kept, self.around = trim(self.nodes)
        if self.kept:
            behind = self.nodes[self.nodes.index(self.kept[-1]) :]
            self.ends_at_mark = any(node.kind is Kind.MARK for node in behind)
        return self

    @property
    def lead(self) -> Kind | None:
        return self.kept[0].kind if self.kept else None

    @property
    def relations(self) -> list[int]:
        return relation_places(self.kept)

    @property
    def is_words(self) -> bool:
        return len(self.kept) == 1 and self.kept[0].kind is Kind.WORDS and Separator.WORDS in self.apart


def pieces_of(cells: Sequence[Cell], marks: Marks) -> list[Piece]:
    """Returns the pieces of a row of cells, in order."""
    return [piece.closed() for cell, apart in _units(cells, marks) for piece in _split(cell, apart)]


def dangling(nodes: Sequence[Node]) -> Kind | None:
    """Returns the kind of the sign that the nodes end with, else None."""
    signs = (Kind.RELATION, Kind.INFIX, Kind.SIGN, Kind.IMPLICATION)
    return nodes[-1].kind if nodes and nodes[-1].kind in signs else None


def _units(cells: Sequence[Cell], marks: Marks) -> Iterator[tuple[list[Node], Separator]]:
    """Yields the cells; a left and a right one are one unit if the right one begins with a relation or the
    left one is empty."""
    units: list[tuple[list[Node], Separator]] = []
    for at, cell in enumerate(cells):
        if at and (marks is Marks.CELLS or at % 2 == 1) and _is_one_unit(units[-1][0], cell):
            units[-1] = ([*units[-1][0], *cell], units[-1][1])
            continue
        apart = Separator.START if at == 0 else Separator.MARK
        units.append((list(cell), Separator.PAIR if at and at % 2 == 0 and marks is Marks.PAIRS else apart))
    yield from units


def _is_one_unit(left: Sequence[Node], right: Sequence[Node]) -> bool:
    inner, kept = trimmed(left), trimmed(right)
    lead = kept[0].kind if kept else None
    is_term = lead is Kind.SIGN and not (relation_places(inner) and relation_places(kept))
    return not inner or is_term or lead in (Kind.RELATION, Kind.INFIX) or dangling(inner) is not None


def _split(cell: list[Node], apart: Separator) -> Iterator[Piece]:
    piece = Piece([], {apart} | ({Separator.MARK} if apart is Separator.PAIR else set()))
    for at, (node, depth) in enumerate(with_depth(cell)):
        is_word = node.kind is Kind.WORDS and not is_name(cell, at)
        if depth:
            piece.nodes.append(node)
        elif is_word:
            yield piece
            yield Piece([node], {Separator.WORDS})
            piece = Piece([], {Separator.WORDS})
        elif node.name == ":" and Separator.WORDS in piece.apart and relation_places(piece.nodes):
            yield piece  # for C: A
            piece = Piece([], {Separator.COLON}, [node])
        elif node.kind in (Kind.WIDE, Kind.COMMA, Kind.FORALL) or _ends_a_column(cell, at, piece.nodes):
            if node.kind is Kind.WIDE and _is_within(piece):
                continues = not trimmed(piece.nodes)
                piece.nodes.append(node)
                piece.indent += continues
                piece.apart |= {Separator.WIDE} if continues else set()
                continue
            yield piece
            piece = Piece([], {_SEPARATORS[node.kind]}, [node], indent=int(node.kind is Kind.WIDE))
        else:
            piece.nodes.append(node)
    yield piece


def _is_within(piece: Piece) -> bool:
    """True if a wide space belongs to the piece: it indents it, or follows a sign."""
    kept = trimmed(piece.nodes)
    return not kept or dangling(kept) is not None


def _ends_a_column(cell: Sequence[Node], at: int, piece: Sequence[Node]) -> bool:
    """True if the node is a visible space after a column that ends a formula."""
    node = cell[at]
    if node.kind is not Kind.GAP or node.text.strip(" ") not in {gap.strip(" ") for gap in VISIBLE_GAPS}:
        return False
    last = next((each for each in reversed(cell[:at]) if each.text.strip(" ")), None)
    return (
        last is not None
        and last.kind is Kind.ENVIRONMENT
        and "matrix" in last.name
        and all(len(row) == 1 for row in last.rows)
        and bool(relation_places(piece))
    )
