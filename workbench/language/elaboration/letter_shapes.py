"""Shapes of the syntax nodes beside a letter."""

from __future__ import annotations

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault
from workbench.core.terms import Apply, Term
from workbench.language.grammar.syntax import (
    Bracket,
    Group,
    Node,
    Product,
    Sum,
    is_function,
)
from workbench.language.naming.scope import Scope


def is_braced(node: Node) -> bool:
    """True for a sum or a product, in braces that print nothing."""
    match node:
        case Group(parts=(Product(items=(first, *_)),)):
            return not is_function(first)
        case Group(parts=(Sum(),)):
            return True
    return False


def column(scope: Scope, row: Bracket) -> Term:
    """Returns (x, y, z)^T, a column; if the parts are rows, they become the rows of a matrix."""
    terms = [scope.term(part) for part in row.parts]
    if not all(term.type.rows == 1 for term in terms):
        raise Fault(SyntaxCode.COLUMNS_BESIDE_EACH_OTHER(), row.at)
    return scope.build(row.at, construct.block, [[upright(term)] for term in terms])


def upright(term: Term) -> Term:
    if term.type.columns == 1:
        return term
    if isinstance(term, Apply) and term.head == "transpose":
        return term.arguments[0]
    return construct.apply("transpose", term)
