"""Matrices with empty cells: the cells are zeros, or space around a block of several columns."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate, pairwise
from typing import Protocol

from workbench.core import construct
from workbench.core.formula_errors import Fault
from workbench.core.shapes import filling
from workbench.core.terms import Term
from workbench.language.grammar.syntax import Group, Matrix, Node

_ROWS = list[list[Term | None]]


class _Reader(Protocol):
    def entry(self, node: Node) -> Term: ...


def entries_of(reader: _Reader, node: Matrix) -> list[list[Term]]:
    """Returns the entries row by row.

    If the printed blocks of a row fill all of its columns, its empty cells are space around them, and so are
    empty rows; other empty cells are zeros. Raises Fault if a whole row or column is empty.
    """
    cells: _ROWS = [[None if _is_empty(each) else reader.entry(each) for each in row] for row in node.rows]
    if not any(None in row for row in cells):
        return [[entry for entry in row if entry is not None] for row in cells]
    if len({len(row) for row in cells}) > 1:
        raise Fault("the rows of a matrix have unequal lengths", node.at)
    rows = _without_room(cells)
    spanned = [row for row in rows if _is_spanned(row)]
    if spanned:
        widths = [term.type.columns for term in spanned[0] if term is not None]
        return [_spread(row, widths, node.at) for row in rows]
    if any(_is_nothing(row) for row in rows) or any(
        _is_nothing(column) for column in zip(*rows, strict=True)
    ):
        raise Fault("a row or column without any entry: zeros, or room? write 0 for a zero", node.at)
    return [[construct.zero() if entry is None else entry for entry in row] for row in rows]


def _is_empty(node: Node) -> bool:
    return isinstance(node, Group) and not node.parts


def _is_nothing(cells: Sequence[Term | None]) -> bool:
    return all(cell is None for cell in cells)


def _without_room(rows: _ROWS) -> _ROWS:
    """Returns the rows without the empty ones if the other rows' blocks fill the height; else all rows."""
    kept = [row for row in rows if not _is_nothing(row)]
    heights = [max(term.type.rows for term in row if term is not None) for row in kept]
    return kept if len(kept) < len(rows) == sum(heights) else rows


def _is_spanned(row: Sequence[Term | None]) -> bool:
    """True if the entries, some of several columns, are together as wide as the row."""
    return None in row and sum(term.type.columns for term in row if term is not None) == len(row)


def _spread(row: Sequence[Term | None], widths: Sequence[int], at: int) -> list[Term]:
    """Returns the entries of a row as blocks of these widths."""
    own = [term for term in row if term is not None]
    if _is_spanned(row):
        if [term.type.columns for term in own] != list(widths):
            raise Fault("blocks of a matrix that stand below others of another width", at)
        return own
    pieces = [row[start:end] for start, end in pairwise([0, *accumulate(widths)])]
    return [_joined(piece) for piece in pieces]


def _joined(cells: Sequence[Term | None]) -> Term:
    terms = [construct.zero() if cell is None else cell for cell in cells]
    if all(filling(term) == "zero" for term in terms):
        return construct.zero()
    return terms[0] if len(terms) == 1 else construct.block([terms])
