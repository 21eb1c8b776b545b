"""Derivatives of maps: D f(x), D f_x, D_x f and T_x f, and each of them along v.

With d the direction must follow, and no other differential may stand in the formula: d f(x) g is else an
addend of the product rule.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault, SpecError
from workbench.core.terms import Symbol, Term
from workbench.core.types import SCALAR
from workbench.language.definitions import Definitions
from workbench.language.elaboration.factors import Factor, Row
from workbench.language.elaboration.operators.differentials import is_differential_sign, takes_differential
from workbench.language.elaboration.superscripts import raised
from workbench.language.grammar.syntax import (
    Accented,
    Bracket,
    Infix,
    Leaf,
    Node,
    Product,
    Scripted,
    Styled,
    core,
    unstyled,
)
from workbench.language.naming.declarations import key_spelling
from workbench.language.naming.patterns import parts_of
from workbench.language.naming.scope import Scope
from workbench.language.printing.printer import to_latex


@dataclass(frozen=True, slots=True)
class MapDerivative:
    """The parts of D f(x): its letter, with the subscript if that is the place; the map, the place, the
    superscript behind it, and the number of items."""

    sign: Node
    letter: str
    body: Node
    at: Node
    items: int
    sup: Node | None = None


@dataclass(frozen=True)
class Dependence:
    """A map and the symbol by which it is differentiated. The map must depend on it."""

    body: Term
    by: Symbol
    at: int

    def require(self, definitions: Definitions) -> None:
        """Raises Fault if neither the definition of the map nor its declaration contains the symbol."""
        reached = list(definitions.symbols_in(self.body))
        if self.by not in reached and all(self.by not in part.declaration.of for part in reached):
            name, place = to_latex(self.body), to_latex(self.by)
            raise Fault(SyntaxCode.MAP_OF_OTHERS(name=name, place=place), self.at)


def map_derivatives(items: Sequence[Node]) -> Iterator[MapDerivative]:
    """Yields the derivatives of maps with which the items may begin: D f_x (v) is one at v, or at x."""
    if len(items) < 2 or not (letter := _letter_of(items[0])):
        return
    sign, body = items[:2]
    if isinstance(sign, Scripted):
        if sign.sub is not None and sign.sup is None and not sign.primes and takes_differential(body):
            yield MapDerivative(sign, letter, body, sign.sub, 2)
        return
    if letter == "T":
        return
    match items[1:3]:
        case [name, Bracket(kind="(", parts=(at,))] if takes_differential(name):
            yield MapDerivative(sign, letter, name, at, 3)
        case [
            name,
            Scripted(nucleus=Bracket(kind="(", parts=(at,)), sub=None, sup=Node() as sup, primes=0),
        ] if takes_differential(name):
            yield MapDerivative(sign, letter, name, at, 3, sup)
    match body:
        case Scripted(nucleus=name, sub=Node() as at, sup=None, primes=0):
            yield MapDerivative(sign, letter, name, at, 2)


def _letter_of(sign: Node) -> str:
    """Returns D, d or T, without its font and subscript; nothing for other nodes."""
    styles, letter = unstyled(sign.nucleus if isinstance(sign, Scripted) else sign)
    is_sign = styles in ((), ("\\mathrm",)) and isinstance(letter, Leaf) and letter.text in ("D", "d", "T")
    return letter.text if is_sign and isinstance(letter, Leaf) else ""


def without_brackets(items: Sequence[Node]) -> list[Node]:
    """Returns the items with D f(x) (v) for (D f(x)) (v)."""
    found: list[Node] = []
    for item, behind in zip(items, (*items[1:], None), strict=True):
        match item:
            case Bracket(kind="(", parts=(Product(items=inner),)) if isinstance(behind, Bracket) and any(
                each.items == len(inner) for each in map_derivatives(inner)
            ):
                found += inner
            case _:
                found.append(item)
    return found


def ends_map_derivative(scope: Scope, items: Sequence[Node]) -> bool:
    """True if the items end with a derivative of a map, so that a dot behind them is its application."""
    ends = [items[-n:] for n in (3, 2) if len(items) >= n]
    found = (each for end in ends for each in map_derivatives(end) if each.items == len(end))
    return any(_is_read(scope, each) for each in found)


def derivative_of_map(row: Row, place: int) -> Factor | None:
    """Returns the derivative of a map, or its value along a direction; None for other items. Raises Fault."""
    scope = row.scope
    found = next((each for each in map_derivatives(row.items[place:]) if _is_read(scope, each)), None)
    if found is None:
        return None
    end = place + found.items
    behind = row.items[end] if end < len(row.items) else None
    along = _direction(behind)
    is_bracketed = isinstance(behind, Bracket) and behind.kind == "["
    if found.letter == "d" and not is_bracketed and (along is None or scope.has_differentials):
        return None
    body, by = scope.term(found.body), scope.term(found.at)
    if not isinstance(by, Symbol) or not (by.type.is_column or by.type == SCALAR):
        return None
    direction = scope.term(along) if along is not None else None
    is_applied = direction is not None and direction.type == by.type and found.sup is None
    if not is_applied and (found.letter == "d" or is_bracketed or not by.type.is_column):
        return None
    scope.apart.append(Dependence(body, by, found.at.at))
    slope = scope.apply(found.sign.at, "partial", body, by)
    if direction is None or not is_applied:
        slope = slope if found.sup is None else raised(scope, slope, found.sup)
        return Factor(slope, found.sign.at, end, found.sign)
    value = scope.apply(found.sign.at, "mul", slope, direction)
    return Factor(value, found.sign.at, end + 1, found.sign)


def _direction(behind: Node | None) -> Node | None:
    """Returns v of [v] and (v), and a letter; None for other nodes."""
    match behind:
        case Bracket(kind="(" | "[", parts=(part,)):
            return part
        case Leaf(kind="LETTER") | Styled() | Accented() | Scripted(nucleus=Leaf(kind="LETTER") | Styled()):
            return behind
    return None


def _is_read(scope: Scope, found: MapDerivative) -> bool:
    """True if no letter of the sign is a symbol, and the map and the place below are."""
    plain = found.sign.nucleus if isinstance(found.sign, Scripted) else found.sign
    if _is_symbol(scope, plain) or _is_symbol(scope, found.sign):
        return False
    if found.items == 3:
        return not isinstance(found.body, Scripted) or _is_symbol(scope, found.body)
    is_open = found.sign is plain and not isinstance(found.body, Bracket)  # D f_x
    return _is_symbol(scope, found.at) and (not is_open or _is_symbol(scope, found.body))


def _is_symbol(scope: Scope, node: Node) -> bool:
    try:
        spelling = key_spelling(core(node), "")
    except SpecError:
        return False
    return scope.table.find(spelling) is not None


def has_differentials(node: Any) -> bool:
    """True if a differential d x stands in a formula that is no derivative of a map."""
    items = without_brackets(node.items) if isinstance(node, Product) else []
    for place, (sign, behind) in enumerate(pairwise(items)):
        is_differential = is_differential_sign(sign) and takes_differential(behind)
        if is_differential and not any(applied(items[place:])):
            return True
    return any(has_differentials(part) for part in items or parts_of(node))


def applied(items: Sequence[Node]) -> Iterator[tuple[MapDerivative, Node, int]]:
    """Yields the derivatives of maps with which the items may begin, their directions, and the places of the
    items after them."""
    for found in map_derivatives(items):
        behind = items[found.items :]
        is_dot = bool(behind) and isinstance(behind[0], Infix) and behind[0].operator == "·"
        along = _direction(next(iter(behind[is_dot:]), None))
        if along is not None:
            yield found, along, found.items + is_dot + 1
