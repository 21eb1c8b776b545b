"""Sizes printed below a zero, a unit matrix or a bracket; they fix the type."""

from __future__ import annotations

from dataclasses import replace

from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.codes.type_codes import TypeCode
from workbench.core.construct import zero
from workbench.core.formula_errors import Fault, TypeMismatch
from workbench.core.shapes import filling, sizes
from workbench.core.terms import Block, Identity, IllFormed, Term, Zero
from workbench.core.types import Type
from workbench.language.grammar.syntax import Bracket, Infix, Leaf, Matrix, Node, Product, core
from workbench.language.naming.scope import Scope


def size_below(sub: Node | None) -> tuple[Type | None, bool]:
    """Returns the type of 3×1 or a single 3 below a zero or a unit tensor, and whether it is a single
    number."""
    inner = core(sub)
    match inner:
        case Product(
            items=(Leaf(kind="NUMBER") as rows, Infix(operator="×"), Leaf(kind="NUMBER") as columns)
        ):
            sizes = (rows.text, columns.text)
        case Leaf(kind="NUMBER"):
            sizes = (inner.text, inner.text)
        case _:
            return None, False
    if not all(size.isdecimal() and 0 < int(size) < 100 for size in sizes):
        return None, False
    return Type(int(sizes[0]), int(sizes[1])), isinstance(inner, Leaf)


def sized_as_printed(term: Term, sub: Node | None, at: int) -> Term:
    """Returns a zero or a unit matrix with the printed size; other terms unchanged. Raises TypeMismatch."""
    size, is_single = size_below(sub)
    if not isinstance(term, Zero | Identity) or filling(term) is None or term.printed or size is None:
        return term
    if isinstance(term, Identity) and not size.is_square:
        raise TypeMismatch(IllFormed(TypeCode.UNIT_MATRIX_NOT_SQUARE(sizes=sizes([size]))), at)
    is_column = isinstance(term, Zero) and is_single
    printed = str(size.rows) if is_single else f"{size.rows} \\times {size.columns}"
    return replace(term, type=Type(size.rows, 1) if is_column else size, printed=printed)


def sized_matrix(scope: Scope, node: Node, sub: Node) -> Term:
    """Returns the term of a bracket or matrix with its size below it. Raises Fault and TypeMismatch."""
    size, is_single = size_below(sub)
    if size is None or is_single or not isinstance(core(node), Bracket | Matrix):
        raise Fault(SyntaxCode.SUBSCRIPT_ON_EXPRESSION(), node.at)
    term = scope.term(node)
    if isinstance(term, Block) and term.children == (zero(),):
        (term,) = term.children
    term = sized_as_printed(term, sub, sub.at)
    if term.type.with_dual(False) != size:
        both = f"{sizes([term.type])} and the size below it {sizes([size])}"
        raise TypeMismatch(IllFormed(TypeCode.SIZE_OF_MATRIX(both=both)), sub.at)
    return term
