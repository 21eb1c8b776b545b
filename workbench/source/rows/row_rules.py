"""Rules for a piece of a row: its relation to the statement before it or above it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum, auto
from itertools import pairwise

from workbench.source.rows.display_pieces import Piece, Separator, dangling
from workbench.source.rows.display_statements import Role, Statement
from workbench.source.rows.display_tree import Node, pairs_of, relation_places, trimmed, with_depth
from workbench.source.rows.display_vocabulary import (
    CASES,
    EQUALITIES,
    ONE_FORMULA,
    RANGE_RELATIONS,
    SIDE_RELATIONS,
    Kind,
    Marks,
)

INDENTED = "a row further in, with a sign and a relation: the rest of the row above, or another equation"
FACTOR = "a row without a relation: a factor of the row above, or an expression of its own"
COLUMN = "a column with a sign and a relation: terms of the equation before it, or another equation"


class Action(Enum):
    """The action for a piece.

    PERHAPS: a separate equation, which may be a condition; OWN_OR_CONDITION: the same, if its position makes
    both likely.
    """

    JOIN = auto()
    NEW = auto()
    CONDITION = auto()
    RANGE = auto()
    PERHAPS = auto()
    OWN_OR_CONDITION = auto()


@dataclass(frozen=True)
class Layout:
    """The surroundings of a row. base: its environment without a star. opens: True if its first cell is
    empty."""

    marks: Marks
    base: str
    opens: bool

    @property
    def is_cases(self) -> bool:
        return self.base in CASES


def below(target: Statement, piece: Piece, layout: Layout, rest: Sequence[Piece]) -> tuple[Action, str]:
    """Returns the action for the first piece of a row, relative to the statement above, and a question if in
    doubt."""
    if _closes(target.nodes, piece.kept):
        return Action.JOIN, ""
    if piece.lead is Kind.IMPLICATION:
        return Action.NEW, ""
    own = [at for at in piece.relations if at]
    if (ends := dangling(target.nodes)) is not None:
        at_mark = target.ends_at_mark or target.nodes[-2:][0].kind is Kind.MARK
        is_left_out = ends is Kind.RELATION and at_mark and piece.lead is not Kind.RELATION
        return (Action.NEW if is_left_out and own and not layout.opens else Action.JOIN), ""  # x &= \\ y &= …
    has_relation = bool(relation_places(target.nodes))
    if piece.lead is Kind.RELATION:
        is_apart = layout.base.startswith("gather") and not has_relation
        return (Action.NEW if is_apart else Action.JOIN), ""
    if piece.lead is Kind.INFIX:
        return Action.JOIN, ""
    if piece.lead is Kind.SIGN:
        return _below_with_a_sign(target, piece, layout, bool(own), has_relation)
    is_followed = any(each.lead is Kind.RELATION for each in rest[:1])
    is_factor = not own and has_relation and layout.base in ONE_FORMULA and not _is_list(target)
    if is_factor and (layout.opens or layout.marks is Marks.NONE) and not is_followed:
        return Action.JOIN, "" if layout.base.startswith("multline") else FACTOR
    return Action.NEW, ""


def _below_with_a_sign(
    target: Statement, piece: Piece, layout: Layout, relates: bool, has_relation: bool
) -> tuple[Action, str]:
    if not relates:
        return (Action.NEW if layout.is_cases and not has_relation else Action.JOIN), ""
    if layout.marks is Marks.CELLS and _relates_at_a_mark(piece):
        return Action.NEW, ""
    if layout.base.startswith("multline") or (layout.opens and target.begins_left):
        return Action.JOIN, ""
    if layout.opens and piece.indent > target.indent:
        return Action.JOIN, INDENTED
    return Action.NEW, ""


def _relates_at_a_mark(piece: Piece) -> bool:
    """True if a relation of the piece begins a cell."""
    solid = [node for node in piece.kept if node.kind is not Kind.GAP]
    return any(a.kind is Kind.MARK and b.kind is Kind.RELATION for a, b in pairwise(solid))


def behind(target: Statement, piece: Piece, layout: Layout, rest: Sequence[Piece]) -> tuple[Action, str]:
    """Returns the action for a piece, relative to the statement before it in its row, and a question if in
    doubt."""
    own = [at for at in piece.relations if at]
    joins = (Kind.IMPLICATION, Kind.RELATION, Kind.INFIX)
    if _closes(target.nodes, piece.kept) or piece.lead in joins or dangling(target.nodes) is not None:
        return Action.JOIN, ""
    if piece.lead is Kind.SIGN and not own:  # a column of terms
        return Action.JOIN, ""
    if piece.lead is Kind.SIGN and Separator.PAIR in piece.apart:
        has_mark = any(node.kind is Kind.MARK for node in piece.kept)
        is_own = not target.begins_left or has_mark
        return (Action.PERHAPS, "") if is_own else (Action.JOIN, COLUMN)
    has_relation = bool(relation_places(target.nodes))
    inner = inside_of(piece.kept)
    if (
        relation_places(inner)
        and has_relation
        and piece.apart & {Separator.MARK, Separator.WIDE, Separator.COMMA}
    ):
        return (Action.RANGE if is_range(inner) else Action.CONDITION), ""
    if not own:
        return _without_relation(target, piece, layout, rest), ""
    if not has_relation:  # x, y \in V
        return Action.JOIN, ""
    return _with_relation(target, piece, layout, rest), ""


def _without_relation(target: Statement, piece: Piece, layout: Layout, rest: Sequence[Piece]) -> Action:
    has_relation = bool(relation_places(target.nodes))
    if (
        Separator.WORDS in piece.apart
        and has_relation
        and piece.lead is not Kind.SIGN
        and not _is_joined(target)
    ):
        return Action.NEW
    ahead = next((at for at, each in enumerate(rest) if each.relations), len(rest))
    is_beside = (
        is_symbol(piece.kept) and has_relation and bool(piece.apart & {Separator.COMMA, Separator.WIDE})
    )
    is_listed = is_beside and ahead < len(rest) and Separator.COMMA in rest[ahead].apart
    if is_listed and is_range(rest[ahead].kept, rest[ahead + 1 :]):  # …, m, n \in N
        return Action.RANGE
    if Separator.MARK in piece.apart and has_relation and layout.is_cases:
        return Action.CONDITION
    return Action.JOIN  # a list, which the reader accepts


def _with_relation(target: Statement, piece: Piece, layout: Layout, rest: Sequence[Piece]) -> Action:
    names = {piece.kept[at].name for at in piece.relations}
    is_equation = any(target.nodes[at].name not in SIDE_RELATIONS for at in relation_places(target.nodes))
    if Separator.WORDS in piece.apart and not piece.apart & {Separator.COMMA, Separator.WIDE, Separator.MARK}:
        return Action.RANGE if is_range(piece.kept, rest) and is_equation else Action.NEW
    if is_range(piece.kept, rest) and is_equation:
        return Action.RANGE
    if names <= SIDE_RELATIONS and is_equation:
        return Action.CONDITION
    if Separator.MARK in piece.apart and layout.is_cases:
        return Action.OWN_OR_CONDITION
    has_mark = any(node.kind is Kind.MARK for node in piece.kept[1:])
    if Separator.MARK in piece.apart and target.begins_left and not has_mark:
        return Action.OWN_OR_CONDITION
    return Action.PERHAPS


def leading_side(piece: Piece, rest: Sequence[Piece]) -> Role | None:
    """Returns the role of n \\geq 1 or x \\in V before an equation in its row; None for other pieces."""
    names = {piece.kept[at].name for at in piece.relations}
    ahead = next((each for each in rest if each.relations), None)
    if not names or not names <= SIDE_RELATIONS or ahead is None or Separator.MARK in ahead.apart:
        return None
    left = trimmed(piece.kept[: piece.relations[0]])
    is_of_a_symbol = is_symbol(left) or (bool(left) and left[0].text.strip().isdecimal())
    if {ahead.kept[at].name for at in ahead.relations} <= SIDE_RELATIONS or not is_of_a_symbol:
        return None
    return Role.RANGE if names <= RANGE_RELATIONS else Role.CONDITION


def inside_of(kept: Sequence[Node]) -> list[Node]:
    """Returns the nodes within the one bracket that the nodes consist of; [] for other nodes."""
    if len(kept) == 1 and kept[0].kind is Kind.GROUP:
        return trimmed(kept[0].inside)
    depths = [depth for _, depth in with_depth(kept)]
    is_bracket = len(kept) > 2 and kept[0].kind is Kind.OPEN and kept[-1].kind is Kind.CLOSE
    return trimmed(kept[1:-1]) if is_bracket and all(depths[1:-1]) else []


def is_range(kept: Sequence[Node], rest: Sequence[Piece] = ()) -> bool:
    """True if the nodes state the range of a symbol: i = 1, 2, 3 with its list after it, i \\geq 1, x \\in
    V."""
    names = {kept[at].name for at in relation_places(kept)}
    if names and names <= RANGE_RELATIONS:
        return True
    texts = [node.text.strip() for node in kept if node.kind is not Kind.GAP]
    if len(texts) < 3 or texts[1] != "=" or not re.fullmatch(r"[a-zN]|\\[a-z]+", texts[0]):
        return False
    is_listed = any(node.kind is Kind.COMMA for node in kept)
    is_listed |= any(Separator.COMMA in each.apart and each.kept and not each.relations for each in rest[:1])
    has_dots = not {"\\dots", "\\ldots", "\\cdots"}.isdisjoint(texts)
    return texts[2].startswith("\\overline") or has_dots or (texts[2].isdecimal() and is_listed)


def names_what(kept: Sequence[Node]) -> bool:
    """True if the nodes define a symbol: R := …, n = a \\times b; but not d = 0."""
    places = relation_places(kept)
    if not places or kept[places[0]].name not in EQUALITIES | {"\\triangleq"}:
        return False
    left, right = trimmed(kept[: places[0]]), trimmed(kept[places[0] + 1 :])
    value = right[0].text.strip() if len(right) == 1 else ""
    is_value = value.isdecimal() or value in ("\\mathbf{0}", "\\pi")
    if not is_symbol(left) or left[0].kind not in (Kind.PLAIN, Kind.GROUP) or is_value:
        return False
    if left[0].text.strip().isdecimal():
        return False
    return left[0].text.strip() not in {node.text.strip() for node, _ in with_depth(right)}


def is_symbol(nodes: Sequence[Node]) -> bool:
    """True if the nodes are one letter or group, with its scripts."""
    return sum(node.kind not in (Kind.SCRIPT, Kind.GAP) for node in nodes) == 1


def _is_joined(target: Statement) -> bool:
    """True if the statement ends with words or an implication that need a continuation."""
    return target.nodes[-1].kind in (Kind.WORDS, Kind.IMPLICATION)


def _closes(nodes: Sequence[Node], kept: Sequence[Node]) -> bool:
    """True if a bracket that is open in the nodes closes in the following ones."""
    for node in nodes:
        if node.name.startswith("left") and "\\right" not in [token.text for token in node.tokens[-2:]]:
            return True
    return pairs_of(nodes)[1] > 0 and pairs_of(kept)[2] > 0


def _is_list(target: Statement) -> bool:
    return any(node.kind is Kind.COMMA and not depth for node, depth in with_depth(target.nodes))


def end_of_a_name(piece: Piece, rest: Sequence[Piece]) -> int:
    """Returns the index after the colon of “L:\\ a = b”; 0 if the piece does not begin so."""
    colon = next((at for at, node in enumerate(piece.kept) if node.name == ":"), 0)
    is_symbol = sum(node.kind not in (Kind.SCRIPT, Kind.GAP) for node in piece.kept[:colon]) == 1
    behind_it = [node for node in piece.kept[colon + 1 :] if node.text != " "]
    if behind_it:
        is_spaced = behind_it[0].kind is Kind.GAP and behind_it[0].text.strip(" ") in ("\\", "~", "\\;")
    else:
        is_spaced = bool(rest) and Separator.WIDE in rest[0].apart
    arrows = {node.name for node in piece.kept} & {"\\to", "\\rightarrow", "\\longrightarrow", "\\mapsto"}
    return colon + 1 if colon and is_symbol and is_spaced and not arrows else 0
