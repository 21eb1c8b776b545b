"""Whether an italic d is the sign of a differential: each addend of each formula has one before a letter."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from workbench.core.formula_errors import Fault
from workbench.language.elaboration.operators.differentials import is_differential_sign, takes_differential
from workbench.language.elaboration.operators.integrals import parts_of_integral
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import (
    Bracket,
    Chain,
    Fraction,
    Integration,
    Matrix,
    Node,
    Product,
    Sum,
    core,
    is_numeral,
)
from workbench.language.naming.patterns import parts_of


def has_differentials(formulas: Iterable[str]) -> bool:
    """True if the letter d stands in one of the formulas, and in all of them as a differential."""
    found = [_is_homogeneous(chain) for latex in formulas for chain in _chains(latex) if _shows_d(chain)]
    return bool(found) and all(found)


def _chains(latex: str) -> Iterator[Chain]:
    try:
        waiting: list[Any] = [parse(latex)]
    except (Fault, RecursionError):
        return
    while waiting:
        node = waiting.pop()
        if isinstance(node, Chain):
            yield node
        elif isinstance(node, Node | tuple):
            waiting += parts_of(node)


def _shows_d(node: Any) -> bool:
    """True if a d stands in the node, outside of the fractions d/dt."""
    if isinstance(node, Fraction) and _is_rate(node):
        return False
    if isinstance(node, Node) and is_differential_sign(node):
        return True
    if isinstance(node, Product):
        return any(map(_shows_d, _without_integrals(node.items)))
    return isinstance(node, Node | tuple) and any(map(_shows_d, parts_of(node)))


def _is_rate(fraction: Fraction) -> bool:
    parts = (fraction.numerator, fraction.denominator)
    return all(is_differential_sign(_items(part)[0]) for part in parts if _items(part))


def _without_integrals(items: Sequence[Node]) -> Sequence[Node]:
    """Returns the factors without the signs of integrals and their differentials."""
    place = next((place for place, item in enumerate(items) if isinstance(item, Integration)), None)
    found = None if place is None else parts_of_integral(items[place + 1 :])
    if place is None or found is None:
        return items
    return [*items[:place], *found[0], *_without_integrals(found[2])]


def _items(node: Node) -> Sequence[Node]:
    inner = core(node)
    return inner.items if isinstance(inner, Product) else (inner,)


def _is_homogeneous(chain: Chain) -> bool:
    return frozenset().union(*map(_degrees, chain.sides)) == {1}


def _degrees(node: Node) -> frozenset[int]:
    """Returns how many differentials the addends of a node hold."""
    inner = core(node)
    match inner:
        case Sum():
            return frozenset().union(*(_degrees(addend) for _, _, addend in inner.addends))
        case Matrix():
            return frozenset().union(*(_degrees(entry) for row in inner.rows for entry in row))
        case Bracket(parts=(part,)):
            return _degrees(part)
        case Fraction() if not _is_rate(inner):
            below = _degrees(inner.denominator)
            return frozenset(i - j for i in _degrees(inner.numerator) for j in below)
        case Product():
            return _of_product(_without_integrals(inner.items))
    if is_numeral(inner) and getattr(inner, "text", "") == "0":
        return frozenset()
    return frozenset({-1} if is_differential_sign(inner) else {0})


def _of_product(items: Sequence[Node]) -> frozenset[int]:
    found, place = frozenset({0}), 0
    while place < len(items):
        behind = items[place + 1 : place + 2]
        if is_differential_sign(items[place]) and behind and takes_differential(behind[0]):
            own, place = frozenset({1}), place + 2
        else:
            own, place = _degrees(items[place]), place + 1
        found = frozenset(i + j for i in found for j in own)
    return found
