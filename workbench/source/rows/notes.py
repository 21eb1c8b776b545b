"""Premises in the notes of a formula: \\stackrel{C}{=}, \\underbrace{x}_{= 0}, \\cancel{x}."""

from __future__ import annotations

from collections.abc import Sequence

from workbench.source.rows.display_statements import Beside, Role, Statement
from workbench.source.rows.display_tree import Node, relation_places, trimmed
from workbench.source.rows.display_vocabulary import Kind

_BEFORE_AN_ADDEND = (Kind.RELATION, Kind.SIGN, Kind.OPEN, Kind.IMPLICATION, Kind.COMMA)
_BEHIND_AN_ADDEND = (*_BEFORE_AN_ADDEND, Kind.CLOSE, Kind.STOP)


def with_notes(statement: Statement) -> None:
    """Adds the premises in the notes of a statement, from the step on in which each occurs."""
    steps = 0
    places = set(relation_places(statement.nodes))
    for at, node in enumerate(statement.nodes):
        if node.kind is Kind.RELATION and at in places:
            steps += 1
            if relation_places(node.note):
                statement.beside.append(Beside(Role.CONDITION, node.note, steps - 1))
        for premise in _premises([node], statement.nodes, at):
            statement.beside.append(Beside(Role.REASON, premise, max(0, steps - 1)))


def _premises(nodes: Sequence[Node], around: Sequence[Node], at: int) -> list[list[Node]]:
    """Returns the equations in the notes of the nodes, also in brackets; `at` is the index of the first
    node."""
    found: list[list[Node]] = []
    for place, node in enumerate(nodes, at):
        if node.kind is Kind.BRACE_NOTE and (note := trimmed(node.note)) and note[0].kind is Kind.RELATION:
            found.append([*node.inside, *note])
        elif node.kind is Kind.CANCEL and node.inside and _is_addend(around, place):
            near = node.tokens[0]
            value = node.note or [Node(Kind.PLAIN, [near.standing_for("0")])]
            sign = Node(Kind.RELATION, [near.standing_for("=")], name="=")
            found.append([*node.inside, sign, *value])
        elif node.kind is Kind.GROUP:
            found += _premises(node.inside, node.inside, 0)
    return found


def _is_addend(nodes: Sequence[Node], at: int) -> bool:
    """True if the node is a term of a sum: a cancelled factor does not vanish."""
    before = next((node.kind for node in reversed(nodes[:at]) if not node.is_blank), Kind.RELATION)
    behind = next((node.kind for node in nodes[at + 1 :] if not node.is_blank), Kind.RELATION)
    return before in _BEFORE_AN_ADDEND and behind in _BEHIND_AN_ADDEND
