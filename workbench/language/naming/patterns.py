"""Patterns of syntax nodes, in which letters stand for other nodes."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass, fields, replace
from functools import cache
from typing import Any, cast

from workbench.core.terms import Term
from workbench.language.grammar.syntax import Bracket, Chain, Infix, Leaf, Node, Product, Sum, core, in_a_row


@dataclass(frozen=True, slots=True)
class Known(Node):
    """A term that replaces a formal argument."""

    term: Term


@cache
def _fields(kind: Any) -> tuple[str, ...]:
    """Returns the compared fields of a node class, without its offset."""
    return tuple(each.name for each in fields(kind) if each.name != "at" and each.compare)


def parts_of(value: Any) -> Iterable[Any]:
    """Returns the fields of a node, without its offset, and their contents."""
    if isinstance(value, Sum):
        return [(sign, addend) for sign, _, addend in value.addends]
    if isinstance(value, Chain):
        return [*value.sides, *(sign for sign, _ in value.relations)]
    if isinstance(value, Node):
        return [getattr(value, name) for name in _fields(cast(Hashable, type(value)))]
    return value if isinstance(value, tuple) else ()


def occurs(letter: str, value: Any) -> bool:
    if isinstance(value, Leaf):
        return value.text == letter
    return any(occurs(letter, part) for part in parts_of(value))


def same(one: Any, other: Any) -> bool:
    return agrees(one, other, {}, {})


def agrees(pattern: Any, node: Any, formals: Mapping[str, str], found: dict[str, Node]) -> bool:
    if isinstance(pattern, Node) and isinstance(node, Node):
        pattern, node = core(pattern), core(node)
        if isinstance(pattern, Leaf) and pattern.text in formals:
            if pattern.text in found:
                return same(found[pattern.text], node)
            found[pattern.text] = node
            return True
        node = _before_a_sign(pattern, node)
    if isinstance(pattern, Node | tuple):
        mine, its = list(parts_of(pattern)), list(parts_of(node))
        return (
            type(pattern) is type(node)
            and len(mine) == len(its)
            and all(agrees(a, b, formals, found) for a, b in zip(mine, its, strict=True))
        )
    return pattern == node


def _before_a_sign(pattern: Node, node: Node) -> Node:
    """Returns a b \\times, or a + b \\times, as one factor and a sign, if the pattern is x \\times."""
    match pattern, node:
        case Product(items=(Leaf(), Infix())), Sum(
            addends=(*first, (sign, at, Product(items=(*rest, Infix() as end))))
        ):
            inner = Sum(node.at, (*first, (sign, at, in_a_row(at, rest))))
            return Product(node.at, (Bracket(node.at, "(", (inner,)), end))
        case Product(items=(Leaf(), Infix())), Product(items=(*factors, Infix() as sign)):
            if len(factors) > 1 and not any(isinstance(factor, Infix) for factor in factors):
                return Product(node.at, (Product(node.at, tuple(factors)), sign))
    return node


def fill(value: Any, given: Mapping[str, Node]) -> Any:
    if isinstance(value, Leaf) and value.kind == "LETTER" and value.text in given:
        return replace(given[value.text], at=value.at)
    if isinstance(value, Node):
        changed = {name: fill(getattr(value, name), given) for name in _fields(cast(Hashable, type(value)))}
        return type(value)(value.at, **changed)
    if isinstance(value, tuple):
        return tuple(fill(part, given) for part in value)
    return value
