"""The elaborator: syntax nodes to typed terms, with sums and brackets."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction as Rational

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.codes.type_codes import Compared
from workbench.core.formula_errors import Fault, TypeMismatch
from workbench.core.shapes import with_scaled_units
from workbench.core.signatures import agree
from workbench.core.terms import Apply, IllFormed, Integer, Number, Term, Unsupported, Zero
from workbench.core.types import TENSOR
from workbench.language.elaboration.empty_cells import entries_of
from workbench.language.elaboration.letters import named
from workbench.language.elaboration.operators.nablas import as_del
from workbench.language.elaboration.products import product
from workbench.language.elaboration.signed_factors import with_signed_factors
from workbench.language.elaboration.spelled import refuse_row_of_vectors
from workbench.language.grammar.syntax import (
    Accented,
    Binomial,
    Bracket,
    Chain,
    Conditional,
    Extremal,
    Fraction,
    Group,
    Infix,
    Leaf,
    Lines,
    Matrix,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
    Summation,
    core,
)
from workbench.language.grammar.vocabulary import BAR
from workbench.language.naming.patterns import Known
from workbench.language.naming.reading_conventions import Relaxation
from workbench.language.naming.scope import Scope
from workbench.language.naming.symbols import SymbolTable

_LONGEST_NUMBER = 100


class Elaborator(Scope):
    """Reads the nodes of one formula."""

    def __init__(self, table: SymbolTable, variables: frozenset[str]) -> None:
        super().__init__(table, variables)
        self._read: dict[tuple[int, frozenset[str]], tuple[Node, Term]] = {}

    def term(self, node: Node) -> Term:
        """Returns the term of a node. Each node is read once, even if several notations of the paper are
        tried on it."""
        key = id(node), self.variables
        if key not in self._read:
            with self.nested(node.at):
                self._read[key] = node, self._term(node)
        return self._read[key][1]

    def _term(self, node: Node) -> Term:
        value = self.integer_expression(node) or self.written(node)
        if value is not None:
            return value
        match node:
            case Sum():
                return self.sum(node)
            case Product():
                return product(self, node.items)
            case Leaf(kind="NUMBER"):
                return self.number(node)
            case Leaf(kind="FUNCTION") | Styled() | Scripted() | Summation() | Fraction():
                return product(self, (node,))
            case Leaf() if as_del(node) is not None:
                return product(self, (node,))
            case Leaf() | Accented():
                return named(self, node)
            case Group(parts=(part,)):
                return self.term(part)
            case Bracket():
                return self.bracket(node)
            case Known():
                return node.term
            case Binomial():
                return self.combinations(node.top, node.bottom)
            case Matrix():
                return self.matrix(node)
        raise _fault_of(node)

    def matrix(self, node: Matrix) -> Term:
        rows = self.build(node.at, entries_of, self, node)
        is_row = len(rows) == 1 and all(entry.type.kind == "scalar" for entry in rows[0])
        if is_row and self.allows(Relaxation.ROW_FOR_COLUMN):
            rows = [[entry] for entry in rows[0]]
        loosely = self.allows(Relaxation.UNIT_TENSOR) and len({len(row) for row in rows}) == 1
        return self.build(node.at, construct.block, with_scaled_units(rows) if loosely else rows)

    def number(self, node: Leaf) -> Term:
        if len(node.text) > _LONGEST_NUMBER:
            raise Fault(
                SyntaxCode.NUMBER_DIGITS_AT_MOST(text=len(node.text), LONGEST_NUMBER=_LONGEST_NUMBER), node.at
            )
        value = Rational(node.text)
        return construct.number(value) if value else construct.zero()

    def entry(self, node: Node) -> Term:
        """Returns an entry of a matrix; a lone dot is 0."""
        is_dot = isinstance(node, Infix) and node.operator == "·"
        return construct.zero() if is_dot else self.term(node)

    # Sums and brackets.

    def sum(self, node: Sum) -> Term:
        addends: list[Term] = []
        places: list[int] = []
        for sign, at, addend in with_signed_factors(self, node.addends):
            term = self.term(addend)
            if sign == "-":
                is_bare = not isinstance(addend, Bracket | Group)
                if not addends and isinstance(term, Number) and is_bare:
                    term = construct.number(-term.value)
                elif isinstance(term, Integer):
                    term = construct.integer(-term.value)
                else:
                    term = construct.apply("neg", term)
            addends.append(term)
            places.append(at)
        if len(addends) == 1:
            return addends[0]
        try:
            if self.table.has_quaternions and {a.type.kind for a in addends} == {"scalar", "vector"}:
                return _parts_of_quaternion(addends)
            return construct.apply("add", *self.with_units(addends))
        except Unsupported as fault:
            raise Fault(fault.reason, places[_first_that_differs(addends)]) from None
        except IllFormed as fault:
            raise TypeMismatch(fault, places[_first_that_differs(addends)]) from None

    def with_units(self, terms: Sequence[Term]) -> Sequence[Term]:
        """Returns the terms, with numbers next to tensors or square matrices of one size as multiples of the
        unit if the paper states so."""
        squares = [each.type for each in terms if each.type.is_square and each.type.kind != "scalar"]
        if not self.allows(Relaxation.UNIT_TENSOR) or len({each.rows for each in squares}) != 1:
            return terms
        unit = construct.identity(squares[0].with_dual(False) if squares[0].kind == "matrix" else TENSOR)
        return [_times_unit(term, unit) for term in terms]

    def bracket(self, node: Bracket) -> Term:
        if node.kind == "[" and len(node.parts) == 1 and isinstance(row := core(node.parts[0]), Product):
            refuse_row_of_vectors(self, row)
        if node.kind == BAR:
            raise Fault(SyntaxCode.EVALUATED_WHERE(), node.at)
        terms = [self.term(part) for part in node.parts]
        if node.kind in ("|", "\\|") and len(terms) == 1:
            own = terms[0].type
            is_determinant = node.kind == "|" and own.is_square and own.rows > 1
            if own.columns > 1 and not is_determinant:
                raise Fault(SyntaxCode.NORM_T_F_READ(own=own), node.at)
            return construct.apply("det" if is_determinant else "norm", terms[0])
        if len(terms) == 1 and node.kind not in ("\\langle", "\\lfloor"):
            return terms[0]
        if len(terms) == 3 and node.kind in ("(", "\\langle") and _are_numbers(terms):
            return self.build(node.at, construct.block, [[term] for term in terms])
        if len(terms) == 3 and node.kind in ("(", "\\langle"):
            return self.apply(node.at, "triple", *terms)
        if self.table.has_quaternions and (parts := _scalar_and_vector(terms)) is not None:
            return self.apply(node.at, "quaternion", *parts)
        if len(terms) == 2 and node.kind in ("(", "[") and _are_beside(*terms):
            return self.build(node.at, construct.block, [terms])  # (a_n, Φ_n): side by side
        if len(terms) == 2 and node.kind == "\\langle" and _are_columns(*terms):
            return self.apply(node.at, "dot", *terms)
        if len(terms) > 1 and node.kind == "(" and _are_numbers(terms):
            return self.build(node.at, construct.block, [[term] for term in terms])  # p = (x, y)
        message = SyntaxCode.TRIPLE_PRODUCT_OR_PAIR()
        raise Fault(SyntaxCode.EXPRESSIONS_BETWEEN_BRACKETS(terms=len(terms), message=message), node.at)


def _are_columns(one: Term, other: Term) -> bool:
    return one.type == other.type and one.type.is_column


def _are_numbers(terms: Sequence[Term]) -> bool:
    return all(term.type.kind == "scalar" for term in terms)


def _times_unit(term: Term, unit: Term) -> Term:
    """Returns n I for a number n or its negative; other terms unchanged."""
    match term:
        case Apply(head="neg", arguments=(Number() | Integer() as inner,)):
            return construct.apply("neg", _times_unit(inner, unit))
        case Number() | Integer():
            return construct.apply("mul", term, unit) if term.value != 1 else unit
    return term


def _are_beside(one: Term, other: Term) -> bool:
    """True if the terms have different kinds and the same height."""
    return one.type.kind != other.type.kind and one.type.rows == other.type.rows


def _scalar_and_vector(terms: Sequence[Term]) -> tuple[Term, Term] | None:
    """Returns the parts of a quaternion written (s, x) or by its four components; None for other terms."""
    if len(terms) == 4 and all(term.type.kind == "scalar" for term in terms):
        return terms[0], construct.block([[term] for term in terms[1:]])
    if len(terms) == 2 and terms[0].type.kind == "scalar":
        is_vector = terms[1].type.kind == "vector" or isinstance(terms[1], Zero)
        return (terms[0], terms[1]) if is_vector else None
    return None


def _parts_of_quaternion(addends: Sequence[Term]) -> Term:
    """Returns s + x as a quaternion: the sums of the scalars and of the vectors."""
    parts = [[a for a in addends if a.type.kind == kind] for kind in ("scalar", "vector")]
    return construct.apply(
        "quaternion", *(p[0] if len(p) == 1 else construct.apply("add", *p) for p in parts)
    )


def _first_that_differs(addends: Sequence[Term]) -> int:
    for count in range(2, len(addends) + 1):
        try:
            agree(addends[:count], Compared.ADDENDS)
        except IllFormed:
            return count - 1
    return 0


def _fault_of(node: Node) -> Fault:
    """Why a node is no term, and where."""
    match node:
        case Group():
            return Fault(SyntaxCode.EXPECTED_ONE_EXPRESSION_BRACES(), node.at)
        case Extremal():
            return Fault(SyntaxCode.MINIMUM_OR_MAXIMUM_STANDS(), node.at)
        case Chain(relations=((sign, at), *_)):
            return Fault(SyntaxCode.RELATION_INSIDE_EXPRESSION(sign=sign), at)
        case Chain() | Conditional() | Lines():
            return Fault(SyntaxCode.EXPECTED_EXPRESSION_NOT_STATEMENT(), node.at)
    return Fault(SyntaxCode.SIGN_WITHOUT_OPERANDS(), node.at)
