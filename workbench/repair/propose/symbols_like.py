"""Symbols of a paper that may replace those of a statement."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

from workbench.core.construct import symbol
from workbench.core.integer_expressions import Linear
from workbench.core.terms import Statement, Symbol, Term
from workbench.core.types import Declaration
from workbench.language.naming.symbols import SymbolTable
from workbench.repair.terms.subterm_positions import places


def symbols_like(
    statement: Statement, table: SymbolTable, integers: Sequence[str] = ()
) -> tuple[list[Term], list[Term]]:
    """Returns the likely and the less likely symbols that a statement may have been meant to contain.

    Likely ones are symbols without index, and members of families whose indices occur in the statement. Less
    likely ones are members with other small indices.
    """
    terms = [term for _, term in places(statement)]
    occurring = dict.fromkeys(t.index for t in terms if isinstance(t, Symbol) and t.index)
    named = {t.declaration for t in terms if isinstance(t, Symbol)}
    variables = [Linear.variable(name) for name in integers]
    entries = dict.fromkeys((*(i for index in occurring for i in index), *variables, Linear(1)))
    small = [*map(Linear, range(7)), *(v + k for v in variables for k in (1, -1, 2, -2))]
    near: dict[Term, None] = {}
    far: dict[Term, None] = {}
    for declaration in table.symbols.values():
        if declaration.parameters:
            continue
        if not declaration.indices:
            near[symbol(declaration)] = None
            continue
        likely = [*occurring, *product(entries, repeat=declaration.indices)]
        if declaration in named:
            likely += [(v + k,) for v in variables for k in (1, -1)]
        for family, indices in ((near, likely), (far, [(i,) for i in small])):
            for index in indices:
                if len(index) == declaration.indices and _is_known(declaration, index, table):
                    family[symbol(declaration, index)] = None
    return list(near), [term for term in far if term not in near]


def _is_known(declaration: Declaration, index: tuple[Linear, ...], table: SymbolTable) -> bool:
    return not declaration.introduced or table.defined.covers(declaration.name, index)
