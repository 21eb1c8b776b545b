"""Addends of an untyped side, also those in brackets, and the side reduced to one of them."""

from __future__ import annotations

from workbench.core.operations import LINEAR
from workbench.language.grammar.syntax import Bracket, Fraction, Group, Leaf, Node, Product, Sum
from workbench.repair.trees.tree_nodes import below, exchanged


def addends_of(node: Node) -> list[Node]:
    """Returns the addends of a side, also those in brackets that only have numbers and linear functions
    before them."""
    match node:
        case Sum(addends=addends):
            return [leaf for _, _, addend in addends for leaf in addends_of(addend)]
        case Bracket(parts=(part,)) | Group(parts=(part,)):
            return addends_of(part) if _holds_sum(part) else [node]
        case Fraction(numerator=numerator) if _holds_sum(numerator):
            return addends_of(numerator)
        case Product(items=items):
            sums = [item for item in items if _holds_sum(item)]
            if len(sums) == 1 and all(item is sums[0] or _is_plain(item) for item in items):
                return addends_of(sums[0])
    return [node]


def _holds_sum(node: Node) -> bool:
    match node:
        case Sum():
            return True
        case Bracket(parts=(part,)) | Group(parts=(part,)) | Fraction(numerator=part):
            return _holds_sum(part)
        case Product(items=items):
            return any(_holds_sum(item) for item in items)
    return False


def _is_plain(node: Node) -> bool:
    match node:
        case Leaf(kind="NUMBER"):
            return True
        case Leaf(kind="FUNCTION", text=text):
            return text in LINEAR
        case Fraction():
            return all(isinstance(part, Fraction | Group) or _is_plain(part) for part in below(node))
    return False


def alone(side: Node, leaf: Node) -> Node:
    """Returns the side with each sum around the leaf reduced to the addend that contains it."""
    cut: dict[int, Node] = {}
    sums = [part for part in below(side) if isinstance(part, Sum)]
    for node in reversed(sums):
        for sign, at, addend in node.addends:
            if any(part is leaf for part in below(addend)):
                cut[id(node)] = Sum(node.at, ((sign, at, exchanged(addend, cut)),))
                break
    return exchanged(side, cut)
