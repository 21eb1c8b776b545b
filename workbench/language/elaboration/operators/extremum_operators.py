"""Extrema \\min_{x \\in V_3} f = m: the body, the bound letters and the value."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeGuard

from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault
from workbench.core.terms import Extremum, Symbol, Term
from workbench.core.types import SCALAR, VECTOR
from workbench.language.elaboration.elaborate import Elaborator
from workbench.language.elaboration.ranges import set_name
from workbench.language.elaboration.sets import Members, letter_name, letter_spelling, members_of
from workbench.language.grammar.syntax import Chain, Extremal, Group, Infix, Node, Product, in_a_row
from workbench.language.naming.symbols import SymbolTable


def is_extremal(side: Node) -> TypeGuard[Product]:
    """True if the side is \\min or \\max of a term."""
    return isinstance(side, Product) and isinstance(side.items[0], Extremal)


def extrema(reader: Elaborator, chain: Chain) -> list[Extremum]:
    """Returns the extrema of a chain with \\min or \\max on some sides. All equal its one other side.

    Raises Fault and TypeMismatch.
    """
    for sign, at in chain.relations:
        if sign != "=":
            raise Fault(SyntaxCode.MINIMUM_OR_MAXIMUM_SAID(sign=sign), at)
    values = [side for side in chain.sides if not is_extremal(side)]
    if not values:
        raise Fault(SyntaxCode.MINIMUM_OR_MAXIMUM_FORMULA(), chain.at)
    if len(values) > 1:
        raise Fault(SyntaxCode.SEVERAL_SIDES_BESIDE_MINIMUM(), values[1].at)
    value = reader.term(values[0])
    return [_extremum(reader, side, value) for side in chain.sides if is_extremal(side)]


def _extremum(reader: Elaborator, side: Product, value: Term) -> Extremum:
    operator, *rest = side.items
    assert isinstance(operator, Extremal), "an extremal side"
    if any(isinstance(item, Extremal) for item in rest):
        raise Fault(SyntaxCode.MINIMUM_OR_MAXIMUM_WITHIN(), side.at)
    if isinstance(rest[0], Infix):
        raise Fault(SyntaxCode.NOTHING_BETWEEN_MINIMUM_OR(), rest[0].at)
    if operator.over is None:
        what = "minimum" if operator.least else "maximum"
        raise Fault(SyntaxCode.OVER_WHAT_WRITE_UNDER(what=what), operator.at)
    table, letters = reader.table, []
    for node, members in _bound(operator.over):
        symbol = _letter(table, reader, node, members)
        table = table if symbol.declaration.name in table.symbols else table.with_symbol(symbol.declaration)
        letters.append(symbol)
    inner = Elaborator(table, reader.variables)
    body = inner.term(in_a_row(rest[0].at, rest))
    return reader.build(side.at, Extremum.of, operator.least, tuple(letters), body, value)


def _bound(over: Node) -> Iterator[tuple[Node, Members | None]]:
    """Yields the letters under the sign with their sets; None if no set is given."""
    waiting: list[Node] = []
    for part in over.parts if isinstance(over, Group) else (over,):
        if isinstance(part, Chain):
            if [sign for sign, _ in part.relations] != ["∈"]:
                raise Fault(SyntaxCode.CONDITION_UNDER_MINIMUM_OR(), part.at)
            letter, domain = part.sides
            members = members_of(domain)
            if members is None or members.type not in (SCALAR, VECTOR):
                known = "ℝ, V_3, and S^2 (unit vectors)"
                raise Fault(
                    SyntaxCode.MINIMUM_OR_MAXIMUM_OVER(set_name=set_name(domain), known=known), part.at
                )
            yield from ((node, members) for node in (*waiting, letter))
            waiting = []
        else:
            waiting.append(part)
    yield from ((node, None) for node in waiting)


def _letter(table: SymbolTable, reader: Elaborator, node: Node, members: Members | None) -> Symbol:
    """Returns the letter with its declaration; an undeclared letter is a constant of its set."""
    name = letter_name(node)
    if name is None or str(name) in reader.variables:
        raise Fault(SyntaxCode.EXPECTED_LETTER_SUCH_X(), node.at)
    spelling = letter_spelling(node)
    if spelling is None or table.find(spelling) is None:
        if members is None:
            raise Fault(SyntaxCode.OVER_SET_EXPECTED_LETTER(), node.at)
        declaration = members.letter(name)
        return Symbol(declaration.type, None, declaration)
    symbol = reader.term(node)
    if not isinstance(symbol, Symbol) or symbol.declaration.name in table.defined.members:
        raise Fault(SyntaxCode.MINIMUM_OR_MAXIMUM_TAKEN(), node.at)
    declaration = symbol.declaration
    fits = declaration.type in (SCALAR, VECTOR) and not (declaration.clock or declaration.of)
    if members is not None:
        fits = fits and (declaration.type, declaration.unit) == (members.type, members.trait == "unit")
    if not fits:
        raise Fault(SyntaxCode.DECLARED_ANOTHER_THING_THAN(name=declaration.name), node.at)
    return symbol
