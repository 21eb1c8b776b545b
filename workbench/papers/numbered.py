"""A formula about e_i for i = 1, 2, 3, of symbols e_1, e_2, e_3 that a model declares one by one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace

from workbench.language.definitions import replaced
from workbench.language.naming.symbols import SymbolTable
from workbench.language.typed.construct import relation, symbol
from workbench.language.typed.errors import IllFormedAt, ReadError
from workbench.language.typed.instances import instantiate
from workbench.language.typed.terms import Conjunction, IllFormed, Relation, Statement, Symbol, Term
from workbench.language.typed.types import Declaration
from workbench.papers.formulas import read_statement
from workbench.papers.model import Notation
from workbench.papers.orders import orders_within

Members = Mapping[Declaration, Sequence[Declaration]]


def written_out(latex: str, notation: Notation) -> Statement | None:
    """What it says for all values of its indices together; None where it is no equation of such symbols, or
    does not say which values there are."""
    members = dict(_families(notation.symbols))
    table = notation.symbols
    for family in members:
        table = table.with_symbol(family)
    with suppress(ReadError, IllFormedAt, IllFormed, ValueError, LookupError):
        statement, ranges = read_statement(latex, replace(notation, symbols=table), None)
        bounds = [bound for each in ranges for bound in (each.lower, each.upper)]
        if any(each.generic for each in ranges) or not all(each and each.is_number for each in bounds):
            return None
        orders = orders_within(None, ranges)
        instances = [instantiate(statement, values) for values in (orders.assignments() if orders else [{}])]
        said = [part for each in instances for part in _equations(each, members)]
        return said[0] if len(said) == 1 else Conjunction(tuple(said))
    return None


def _equations(statement: Statement, members: Members) -> Iterator[Relation]:
    """Raises LookupError where a member is not declared, or it is no equation."""

    def member(own: Symbol) -> Term | None:
        several = members.get(own.declaration)
        (place,) = own.index if several else (1,)
        return None if several is None else symbol([None, *several][int(place)])

    match statement:
        case Relation(operator=sign, left=left, right=right):
            yield relation(sign, replaced(left, member), replaced(right, member))
        case Conjunction(parts=parts):
            for part in parts:
                yield from _equations(part, members)
        case _:
            raise LookupError


def _families(table: SymbolTable) -> Iterator[tuple[Declaration, list[Declaration]]]:
    """Those of symbols of one letter and kind with the subscripts 1, 2, …"""
    for name, first in table.symbols.items():
        family = replace(name, sub=("", ""))
        if name.sub != ("1",) or any(name.sup) or family in table.symbols:
            continue
        several = [first]
        while (other := table.symbols.get(replace(name, sub=(str(len(several) + 1),)))) is not None:
            several.append(other)
        plain = all(not (each.indices or each.parameters or each.of) for each in several)
        if plain and len(several) > 1 and len({each.type for each in several}) == 1:
            yield Declaration(family, first.type, None, indices=1), several
