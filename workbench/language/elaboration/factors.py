"""Factors in juxtaposition: each is read once, and they combine to a product."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.codes.type_codes import TypeCode
from workbench.core.formula_errors import Fault, TypeMismatch
from workbench.core.shapes import scalar_and_vector
from workbench.core.terms import Block, IllFormed, Integer, Number, Term
from workbench.language.grammar.syntax import Bracket, Fraction, Leaf, Node, Scripted, is_numeral
from workbench.language.naming.scope import Scope


@dataclass(slots=True)
class Factor:
    term: Term
    at: int
    end: int  # index of the item after it
    node: Node


class Row:
    """A row of factors in juxtaposition."""

    def __init__(self, scope: Scope, items: Sequence[Node], read: Callable[[Row, int], Factor]) -> None:
        self.scope = scope
        self._read = read
        self.items = items
        self._known: dict[int, Factor] = {}
        self.open_head = ""  # the last head whose argument is not bracketed

    def term(self) -> Term:
        return self.multiply(self.factors())

    def factors(self) -> list[Factor]:
        factors, place = [], 0
        while place < len(self.items):
            factor = self.factor(place)
            factors.append(factor)
            place = factor.end
        return factors

    def multiply(self, factors: Sequence[Factor]) -> Term:
        result = factors[0].term
        for place, factor in enumerate(factors[1:], start=1):
            term = factor.term
            if is_numeral(factors[place - 1].node) and is_numeral(factor.node):
                raise Fault(SyntaxCode.TWO_NUMBERS_SIDE_SIDE(), factor.at)
            is_fraction = isinstance(factor.node, Fraction) and isinstance(term, Number)
            if is_numeral(factors[place - 1].node) and is_fraction:
                raise Fault(SyntaxCode.MIXED_NUMBER_OR_PRODUCT(), factor.at)
            if result.type.kind == "operator" and term.type.kind not in ("operator", "scalar"):
                self.operand(factor, factors[place + 1 :])
            number = result.value if place == 1 and isinstance(result, Number) else None
            is_count = number is not None and _is_integer(factors[0])
            if number is not None and is_count and isinstance(term, Integer) and _is_bare(factor.node):
                result = construct.integer(term.value * int(number))
            else:
                result = self._product(result, factors[: place + 1])
        return result

    def _product(self, result: Term, factors: Sequence[Factor]) -> Term:
        *others, last, this = (factor.term.type for factor in factors)
        if last.kind == this.kind == "vector" and result.type.kind == "tensor":
            raise Fault(SyntaxCode.THREE_VECTORS_BESIDE_EACH(), factors[-1].at)
        if last.kind == this.kind == "quaternion" and any(other.columns == 4 for other in others):
            raise Fault(SyntaxCode.MATRIX_BEFORE_PRODUCT_QUATERNIONS(), factors[-1].at)
        pair = (result, factors[-1].term)
        if self.scope.table.has_quaternions and all(map(_is_scalar_above_vector, pair)):
            pair = construct.as_quaternion(pair[0]), construct.as_quaternion(pair[1])
        return self.scope.apply(factors[-1].at, "mul", *pair)

    def operand(self, factor: Factor, more: Sequence[Factor]) -> None:
        """Marks that an operator acts on the factor; raises TypeMismatch if it may act on more than that."""
        if isinstance(factor.node, Bracket):
            return
        if any(other.term.type.kind != "scalar" for other in more):
            raise TypeMismatch(IllFormed(TypeCode.REACH_OF_OPERATOR()), factor.at)
        self.open_head = "the operator"
        if factor.term.type.kind == "tensor":
            self.scope.tensor_operand = factor.at

    def factor(self, place: int) -> Factor:
        """Returns the factor that begins at an item. Each factor is read once."""
        if place not in self._known:
            with self.scope.nested(self.items[place].at):
                self._known[place] = self._read(self, place)
        return self._known[place]


def _is_scalar_above_vector(term: Term) -> bool:
    """True for a quaternion written as a column of four: (s; x), or its components."""
    return isinstance(term, Block) and term.type.rows == 4 and scalar_and_vector(term) is not None


def _is_integer(factor: Factor) -> bool:
    term = factor.term
    return isinstance(factor.node, Leaf) and isinstance(term, Number) and term.value.denominator == 1


def _is_bare(node: Node) -> bool:
    return isinstance(node, Leaf | Scripted)
