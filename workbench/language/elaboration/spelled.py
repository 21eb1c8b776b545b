"""What stands in a row as authors write it: \\Delta t, one symbol; \\mathbf{pq}, two."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from workbench.language.names import PREFIXES
from workbench.language.scope import Scope
from workbench.language.spelling import prefixed
from workbench.language.syntax import (
    Accented,
    Bracket,
    Group,
    Leaf,
    Node,
    Product,
    Scripted,
    Styled,
    core,
)
from workbench.language.vocabulary import FONTS


def spelled_out(scope: Scope, items: Sequence[Node]) -> list[Node]:
    """The items, each a factor or a sign."""
    return _with_prefixes(scope, [part for item in items for part in letters_in_one_font(item)])


def letters_in_one_font(item: Node) -> Iterator[Node]:
    """\\mathbf{pq}^* is \\mathbf{p} \\mathbf{q}^*: no symbol has two letters in one font. The hat of
    \\hat{pq} stands over the product."""
    inner = item.nucleus if isinstance(item, Scripted) else item
    body = core(inner.body) if isinstance(inner, Styled) and inner.style in FONTS else None
    if not isinstance(body, Product) or not all(_is_letter(part) for part in body.items):
        yield item
        return
    *first, last = (Styled(part.at, inner.style, part) for part in body.items)
    yield from first
    yield replace(item, nucleus=last) if isinstance(item, Scripted) else last


def _is_letter(node: Node) -> bool:
    inner = node.nucleus if isinstance(node, Scripted) else node
    return isinstance(inner, Leaf) and inner.kind == "LETTER"


def _with_prefixes(scope: Scope, items: Sequence[Node]) -> list[Node]:
    found: list[Node] = []
    for item in items:
        before = found[-1] if found else None
        if isinstance(before, Leaf) and before.text in PREFIXES:
            joined = prefixed(before, item)
            if joined is not None and scope.table.has_prefixed(*_styled_letter(joined)):
                found[-1] = joined
                continue
        found.append(item)
    return found


def _styled_letter(node: Node) -> tuple[tuple[str, ...], str]:
    styles: tuple[str, ...] = ()
    while not isinstance(node, Leaf):
        match node:
            case Styled(style=style, body=body):
                styles, node = (*styles, style), body
            case Accented(body=body) | Scripted(nucleus=body) | Group(parts=(body,)):
                node = body
            case _:
                return styles, ""
    return styles, node.text


def is_euclidean(scope: Scope, node: Node, sub: Node) -> bool:
    """Whether it is \\|x\\|_2 of a column, which is \\|x\\|; that of a matrix is another norm."""
    is_norm = isinstance(node, Bracket) and node.kind in ("|", "\\|") and len(node.parts) == 1
    two = core(sub)
    if not is_norm or not isinstance(two, Leaf) or two.text != "2":
        return False
    type_ = scope.term(node.parts[0]).type
    return type_.columns == 1 and type_.rows > 1
