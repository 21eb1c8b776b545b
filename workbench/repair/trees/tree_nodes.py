"""Untyped formulas as trees: subtrees by identity, and their replacement.

An ill-typed formula has no term, so its edits are made on the syntax tree.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, replace
from functools import partial
from typing import Any

from workbench.language.grammar.syntax import Node, core


def below(node: Node) -> Iterator[Node]:
    """Yields the node and all its descendants, outer ones first."""
    yield node
    for child in children(node):
        yield from below(child)


def children(node: Node) -> Iterator[Node]:
    for name in _fields(node):
        yield from _nodes_in(getattr(node, name))


_FIELDS: dict[type[Node], tuple[str, ...]] = {}


def _fields(node: Node) -> tuple[str, ...]:
    """Returns the names of the fields in which a node of this kind may hold others."""
    kind = type(node)
    if kind not in _FIELDS:
        names = (field.name for field in fields(kind) if field.type not in ("int", "str", "bool"))
        _FIELDS[kind] = tuple(names)
    return _FIELDS[kind]


def bare(node: Node) -> Node:
    """Returns the node without braces around it."""
    inner = core(node)
    assert inner is not None
    return inner


def _nodes_in(value: Any) -> Iterator[Node]:
    if isinstance(value, Node):
        yield value
    elif isinstance(value, tuple):
        for part in value:
            yield from _nodes_in(part)


def exchanged(node: Node, new: Mapping[int, Node]) -> Node:
    """Returns the tree with the nodes of these ids replaced; unchanged subtrees are shared."""
    if id(node) in new:
        return new[id(node)]
    changed = {}
    for name in _fields(node):
        value = getattr(node, name)
        other = _exchanged_in(value, new)
        if other is not value:
            changed[name] = other
    return replace(node, **changed) if changed else node


def _exchanged_in(value: Any, new: Mapping[int, Node]) -> Any:
    if isinstance(value, Node):
        return exchanged(value, new)
    if isinstance(value, tuple):
        parts = tuple(_exchanged_in(part, new) for part in value)
        return value if all(a is b for a, b in zip(parts, value, strict=True)) else parts
    return value


def hole(root: Node, inner: Node) -> Callable[[Node], Node]:
    """Returns a function that puts another node in the position of `inner`."""
    filled = _hole(root, inner)
    if filled is None:
        raise ValueError("expected a node of the tree")
    return filled


def _hole(value: Any, inner: Node) -> Callable[[Node], Any] | None:
    if value is inner:
        return lambda new: new
    if isinstance(value, Node):
        for name in _fields(value):
            if (filled := _hole(getattr(value, name), inner)) is not None:
                return partial(_with_field, value, name, filled)
    if isinstance(value, tuple):
        for index, part in enumerate(value):
            if (filled := _hole(part, inner)) is not None:
                return partial(_with_part, value, index, filled)
    return None


def _with_field(node: Node, name: str, filled: Callable[[Node], Any], new: Node) -> Node:
    return replace(node, **{name: filled(new)})


def _with_part(parts: tuple, place: int, filled: Callable[[Node], Any], new: Node) -> tuple:
    return (*parts[:place], filled(new), *parts[place + 1 :])
