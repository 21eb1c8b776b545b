"""Formulas with an index i over symbols e_1, e_2, e_3 that a model declares one by one.

Likewise for ω_{ij} over ω_{11}, ω_{12}, …, and for δ_{ij}, which is 1 or 0 if the model has no symbol of that
letter.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace

from workbench.context.claims import Notation
from workbench.context.index_values import orders_within
from workbench.context.read_formulas import read_statement
from workbench.core.construct import number, relation, symbol, zero
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.integer_instances import free_integers, instantiate
from workbench.core.names import Name
from workbench.core.statement_parts import conjuncts
from workbench.core.terms import Conjunction, IllFormed, Relation, Statement, Symbol, Term
from workbench.core.types import SCALAR, Declaration
from workbench.language.definitions import replaced
from workbench.language.naming.symbols import SymbolTable

#: Family → the term for each index. Raises LookupError for an index without a term.
Members = Mapping[Declaration, Callable[[tuple[int, ...]], Term]]

_KRONECKER = Declaration(Name("\\delta", sub=("", " ", "")), SCALAR, None, indices=2)
_FIGURES = re.compile(r"([1-9])(?:(,?)([1-9]))?")


def written_out(latex: str, notation: Notation) -> Statement | None:
    """Returns the conjunction of the formula for all values of its indices.

    Returns None if it is no equation of such symbols, or if the values are not stated.
    """
    members = dict(_families(notation.symbols))
    table = notation.symbols
    for family in members:
        table = table.with_symbol(family)
    with suppress(ReadError, IllFormedAt, IllFormed, ValueError, LookupError):
        statement, ranges = read_statement(latex, replace(notation, symbols=table), None)
        bounds = [bound for each in ranges for bound in (each.lower, each.upper)]
        if any(each.generic for each in ranges) or not all(each and each.is_number for each in bounds):
            return None
        if any(_may_be_contracted(each, members) for each in _relations(statement)):
            return None
        orders = orders_within(None, ranges)
        instances = [instantiate(statement, values) for values in (orders.assignments() if orders else [{}])]
        said = [_equation(part, members) for each in instances for part in _relations(each)]
        return said[0] if len(said) == 1 else Conjunction(tuple(said))
    return None


def _relations(statement: Statement) -> Iterator[Relation]:
    """Yields the equations of a statement. Raises LookupError if it is none."""
    for part in conjuncts(statement):
        if not isinstance(part, Relation):
            raise LookupError
        yield part


def _may_be_contracted(equation: Relation, members: Members) -> bool:
    """True if an index of a member with two indices occurs on one side only, which may mean a sum over it."""
    sides = equation.left, equation.right
    own = [part for side in sides for part in side.symbols() if len(part.index) > 1]
    left, right = map(free_integers, sides)
    return any(each.declaration in members for each in own) and left != right


def _equation(equation: Relation, members: Members) -> Relation:
    """Returns the equation over members. Raises LookupError if a member is not declared."""

    def member(own: Symbol) -> Term | None:
        several = members.get(own.declaration)
        return None if several is None else several(tuple(map(int, own.index)))

    return relation(equation.operator, replaced(equation.left, member), replaced(equation.right, member))


def _families(table: SymbolTable) -> Iterator[tuple[Declaration, Callable[[tuple[int, ...]], Term]]]:
    """Yields the families of symbols of one letter and kind with the subscripts 1, 2, …, or 11, 12, …"""
    found: dict[Name, dict[tuple[int, ...], Declaration]] = {}
    for name, each in table.symbols.items():
        family, index = _place(name, table)
        if index and not (each.indices or each.parameters or each.of or family in table.symbols):
            found.setdefault(family, {})[index] = each
    for family, several in found.items():
        types = [*{each.type for each in several.values()}]
        if len(several) > 1 and len(types) == 1:
            members = {index: symbol(each) for index, each in several.items()}
            yield Declaration(family, types[0], indices=family.indices), members.__getitem__
    if not table.has_letter(_KRONECKER.name.letter):
        yield _KRONECKER, lambda index: number(1) if len({*index}) == 1 else zero()


def _place(name: Name, table: SymbolTable) -> tuple[Name, tuple[int, ...]]:
    """Returns the family and the index of a name; () if its subscript is not an index.

    The 12 of x_{12} is not read as 1 and 2 if there is an x_9.
    """
    figures = None if any(name.sup) else _FIGURES.fullmatch("".join(name.sub))
    if figures is None:
        return name, ()
    first, sign, second = figures.groups()
    if second is None:
        return replace(name, sub=("", "")), (int(first),)
    if replace(name, sub=("9",)) in table.symbols:
        return replace(name, sub=("", "")), (int(first + second),) if not sign else ()
    return replace(name, sub=("", sign or " ", "")), (int(first), int(second))
