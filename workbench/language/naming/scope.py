"""The scope of one formula while it is read: its symbols, its integer variables, and its nesting depth."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import Any, TypeVar

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault, TypeMismatch
from workbench.core.integer_expressions import Linear
from workbench.core.terms import (
    Apply,
    Block,
    CountingName,
    Derivative,
    Head,
    IllFormed,
    Power,
    Symbol,
    Term,
    Unsupported,
    Zero,
)
from workbench.core.types import VECTOR, type_of_kind
from workbench.language.accented_symbols import is_accented_symbol, is_rate
from workbench.language.grammar.syntax import (
    Accented,
    Bracket,
    Group,
    Leaf,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
    core,
)
from workbench.language.naming.linear_indices import linear, linear_or_none
from workbench.language.naming.notations import is_shape
from workbench.language.naming.reading_conventions import Gradient, Points, Relaxation
from workbench.language.naming.spelling import Named, in_bracket, spell_label
from workbench.language.naming.symbols import SymbolTable

Result = TypeVar("Result")

#: Limit on the nesting of terms; a longer product counts as nesting, too.
DEEPEST_TERM = 120
_WHICH = "a point or a direction? write the column of four"
#: [I 0]: the first three of four.
_FIRST_THREE = construct.block([[construct.identity(), construct.zero(VECTOR)]])


@dataclass
class Reaches:
    """The products below sines and cosines, and the factors behind those with a sum in brackets.

    Attributes:
        angles: The two factors of each.
        behind: An addend and the factor, with the function and its offset.
        known: m and \\theta of each \\cos m\\theta of the statement.
    """

    angles: set[frozenset[str]] = field(default_factory=set)
    behind: dict[frozenset[str], tuple[str, int]] = field(default_factory=dict)
    known: frozenset[tuple[str, str]] = frozenset()


class Scope(ABC):
    """The scope in which letters, products and sums are read. `variables` are the integer variables in
    scope."""

    def __init__(self, table: SymbolTable, variables: frozenset[str]) -> None:
        self.table = table
        self.variables = variables
        self.depth = 0
        #: the contents of the bracket after a symbol that states its dependence
        self.places: dict[Named, tuple[str, ...]] = {}
        self.instants: dict[Named, tuple[str, ...]] = {}
        #: the brackets after a symbol, by whether they multiply it
        self.brackets: dict[Named, dict[bool, Bracket]] = {}
        #: the contents of a square bracket, by the symbol and its letters
        self.members: dict[tuple[Named, str], str] = {}
        self.takes_bars = False
        self.evaluations: list[Any] = []  # the bars \left. f \right|_{x = 0} of the statement so far
        self.apart: list[Any] = []  # what stands outside of the bars of all statements
        self.tensor_operand: int | None = None  # offset of the last operator on a bare tensor
        self.reaches = Reaches()
        self.italic_differentials: list[int] = []  # offsets of the d of the statement so far
        self.has_differentials = False  # whether the statement has any, besides derivatives of maps

    def allows(self, relaxation: Relaxation) -> bool:
        """True if the paper uses this reading."""
        return self.table.conventions.allow(relaxation)

    def tries_as_function(self, symbol: str) -> bool:
        """True if the reader tries the symbol as a function of the bracket after it."""
        return self.table.conventions.apply(symbol)

    def asks_about(self, symbol: str) -> bool:
        """True if the reader asks whether the symbol is a function of the bracket after it."""
        return symbol in self.table.conventions.asked

    @abstractmethod
    def term(self, node: Node) -> Term:
        """Returns the term of a node."""

    def rate(self, at: int, body: Term, order: Linear, frame: Node | None) -> Term:
        """Returns d/dt, or {}^F d/dt: with ω of the frame, ẋ − ω × x for a vector."""
        if (
            frame is not None
            and body.type.kind not in ("vector", "scalar")
            and not isinstance(self.frame(frame), Zero)
        ):
            raise Fault(SyntaxCode.RATE_IN_FRAME(type=body.type), at)
        if body.type.kind == "tensor" and frame is None and self._holds_kept(body):
            if isinstance(body, Symbol):
                return construct.zero(body.type)
            raise Fault(SyntaxCode.TENSOR_RATE_IN_FRAME(), at)
        if body.type.kind != "vector" or (frame is None and not self.table.frames.velocities):
            return self.build(at, construct.derivative, body, order)
        if frame is None:
            if self.table.frames.dot is None:
                raise Fault(SyntaxCode.FRAME_CONVENTIONS_DOT_SAYS(), at)
            spin = self.table.frames.velocities[self.table.frames.dot]
        else:
            spin = self.frame(frame)
        if isinstance(spin, Zero):
            return self.build(at, construct.derivative, body, order)
        if not order.is_number:
            raise Fault(SyntaxCode.DERIVATIVE_ORDER_N_FRAME(), at)
        for _ in range(int(order)):
            rate = self.build(at, construct.derivative, body, 1)
            turning = construct.apply("neg", construct.apply("cross", spin, body))
            body = self.apply(at, "add", rate, turning)
        return body

    def _holds_kept(self, body: Term) -> bool:
        kept = self.table.frames.constant
        return bool(kept) and any(p.declaration.name in kept for p in body.symbols())

    def partial(self, at: int, head: Head, body: Term, by: Term) -> Term:
        """Returns ∂f/∂x, a row or a column as the paper states."""
        if not is_rate(by):
            raise Fault(SyntaxCode.DERIVATIVE_ANYTHING_BUT_SYMBOL(), at)
        if isinstance(by, Derivative) and isinstance(by.body, Symbol) and by.body.declaration.constant:
            raise Fault(SyntaxCode.DERIVATIVE_RATE_CONSTANT(), at)
        if by.type.kind == "scalar":
            if body.type.kind == "vector" and self.table.frames.velocities:
                raise Fault(SyntaxCode.PARTIAL_DERIVATIVE_VECTOR_SEEN(), at)
            return self.apply(at, head, body, by)
        if self.table.conventions.gradient is None and not by.type.algebra:
            raise Fault(SyntaxCode.ROWS_OR_COLUMNS_CONVENTIONS(), at)
        slope = self.apply(at, head, body, by)
        turned = Gradient.COLUMN if by.type.is_column else Gradient.ROW
        is_turned = self.table.conventions.gradient is turned and body.type.kind == "scalar"
        return construct.apply("transpose", slope) if is_turned else slope

    def frame(self, label: Node) -> Term:
        """Returns the angular velocity of the frame of that label; \\mathcal{B} is B, unless it is another
        frame."""
        name, plain = spell_label(label) or "", core(label)
        while name not in self.table.frames.velocities and isinstance(plain, Styled):
            plain = core(plain.body)
            name = spell_label(plain) or ""
        if name not in self.table.frames.velocities:
            known = ", ".join(self.table.frames.velocities) or "none"
            raise Fault(SyntaxCode.DERIVATIVE_FRAME_FRAMES_DECLARED(name=name, known=known), label.at)
        return self.table.frames.velocities[name]

    def written(self, node: Node) -> Term | None:
        """Returns the term of a bracket or matrix in the paper's notation; None for other nodes."""
        return self.spelt(node) if is_shape(node) else self.in_bracket(node)

    def spelt(self, node: Node) -> Term | None:
        """Like `written`, but for every node, such as a letter before its argument."""
        found = self.table.notations.shapes(node)
        if isinstance(node, Bracket) and self.allows(Relaxation.MERE_BRACKETS):
            found = []
        is_own = any(not entry.formals for entry, _ in found)
        if not is_own and (named := self.in_bracket(node)) is not None:
            return named
        for entry, places in found:
            terms = {letter: self.term(part) for letter, part in places.items()}
            if entry.fits(terms):
                return self.term(entry.filled(terms))
            column = next((term for term in terms.values() if _is_other_column(term)), None)
            if column is not None and isinstance(node, Bracket):
                message = SyntaxCode.NOTATION_OF_OTHERS(type=column.type)
                raise Fault(SyntaxCode.FAULT_OF_KEY(key=entry.key, message=message), node.at)
        return None

    def in_bracket(self, node: Node) -> Term | None:
        """Returns the matrix [BN], also as [\\dot{BN}]; None for other brackets."""
        within, order = node, 0
        match node:
            case Bracket(kind="[", parts=(Accented(accent="1" | "2" as dots, body=body),)):
                within, order = replace(node, parts=(body,)), int(dots)
        pair = in_bracket(within)
        if pair is None:
            return None
        if (declared := self.table.symbols.get(pair.name)) is not None:
            term = self.build(node.at, construct.symbol, declared)
            return self.rate(node.at, term, Linear(order), None) if order else term
        if all(label in self.table.frames.velocities for label in pair.labels):
            phrase = f"rotation to {pair.labels[0]} from {pair.labels[1]}"
            message = SyntaxCode.PRODUCT_OR_FRAMES()
            raise Fault(SyntaxCode.NOTATION_WANTED(name=pair.name, message=message, phrase=phrase), node.at)
        return None

    def build(self, at: int, make: Callable[..., Result], *arguments) -> Result:
        """Returns make(*arguments); a mismatch is raised as a TypeMismatch or Fault at the offset `at`."""
        try:
            return make(*arguments)
        except Unsupported as fault:
            raise Fault(fault.reason, at) from None
        except IllFormed as fault:
            raise TypeMismatch(fault, at) from None

    def apply(self, at: int, head: Head, *arguments: Term) -> Term:
        are_vectors = head == "mul" and {x.type.kind for x in arguments} == {"vector"}
        if are_vectors and self.allows(Relaxation.DYADS):
            head = "outer"
        elif head == "mul":
            self._refuse_pure(at, *arguments)
        if head == "mul" and arguments[0].type == type_of_kind("transform"):
            if isinstance(arguments[1], Zero) and self.table.conventions.points:
                raise Fault(_WHICH, at)
            column = self.as_point(arguments[1], at)
            if self.table.conventions.points is Points.VECTORS and column is not arguments[1]:
                return construct.apply("mul", _FIRST_THREE, construct.apply("mul", arguments[0], column))
            arguments = (arguments[0], column)
        return self.build(at, construct.apply, head, *arguments)

    def _refuse_pure(self, at: int, left: Term, right: Term) -> None:
        """Raises Fault for products of vectors, and for their powers next to a quaternion.

        They may be quaternions without a scalar part: ω² is then −ω·ω instead of ω·ω.
        """
        kinds = {left.type.kind, right.type.kind}
        parts = (part for side in (left, right) for part in (side, *side.children))
        is_power = any(isinstance(part, Power) and part.base.type.kind == "vector" for part in parts)
        if self.table.has_quaternions and (kinds == {"vector"} or ("quaternion" in kinds and is_power)):
            raise Fault(SyntaxCode.VECTORS_OR_QUATERNIONS_WRITE(), at)

    def quaternion_of_four(self, term: Term) -> Term:
        """Returns an explicit column of four as a quaternion, in a paper with quaternions; other terms
        unchanged."""
        is_written_out = isinstance(term, Block) and (term.type.rows, term.type.columns) == (4, 1)
        return construct.as_quaternion(term) if is_written_out and self.table.has_quaternions else term

    def as_point(self, term: Term, at: int) -> Term:
        """The column (p, 1) of a point, where the paper writes p for it; anything else as it is."""
        if self.table.conventions.points is None or term.type.kind != "vector":
            return term
        own = term.declaration if isinstance(term, Symbol) else None
        is_moved = isinstance(term, Apply) and term.children[0] == _FIRST_THREE
        if not is_moved and (own is None or own.unit or own.name in self.table.frames.directions):
            raise Fault(_WHICH, at)
        return construct.block([[term], [construct.number(1)]])

    @contextmanager
    def bound(self, names: Sequence[str], at: int) -> Iterator[None]:
        """Adds the names as integer variables within the context."""
        for name in names:
            if name in self.variables or names.count(name) > 1:
                raise Fault(SyntaxCode.SUMMATION_VARIABLE_ALREADY_HAS(name=name), at)
        outer, self.variables = self.variables, self.variables.union(names)
        try:
            yield
        finally:
            self.variables = outer

    @contextmanager
    def nested(self, at: int) -> Iterator[None]:
        if self.depth == DEEPEST_TERM:
            raise Fault(SyntaxCode.FORMULA_NESTS_DEEPER_THAN(DEEPEST_TERM=DEEPEST_TERM), at)
        self.depth += 1
        try:
            yield
        finally:
            self.depth -= 1

    def is_time(self, node: Node) -> bool:
        """True for the letter t as the time."""
        is_t = isinstance(node, Leaf) and node.text == "t"
        return is_t and not self.knows("t")

    def knows(self, name: str) -> bool:
        """True if the name is a symbol or an integer variable in scope."""
        return name in self.table or name in self.variables

    # Integers.

    def integer_expression(self, node: Node) -> Term | None:
        """Returns n, n+1 or 2k − 1 as one integer; None for numbers alone, which `number` and `sum` read."""
        if isinstance(node, Leaf | Scripted | Sum | Product):
            value = linear_or_none(node, self.variables)
            if value is not None and not value.is_number:
                for name in value.variables:
                    self.integer_variable(name, node.at)
                return construct.integer(value)
        return None

    def integer_variable(self, name: str, at: int) -> Term:
        if name in self.table:
            raise Fault(SyntaxCode.INTEGER_VARIABLE_DECLARED_SYMBOL(name=name), at)
        return construct.integer(Linear.variable(name))

    def integer(self, node: Node) -> Linear:
        value = linear(node, self.variables)
        if value is None:
            raise Fault(
                SyntaxCode.EXPECTED_INTEGER_EXPRESSION(known_variables=self.known_variables()), node.at
            )
        return value

    def combinations(self, top: Node, bottom: Node) -> Term:
        """Returns n over k, or over k_1, k_2, …."""
        parts = bottom.parts if isinstance(bottom, Group) else (bottom,)
        lower = [self.integer(part) for part in parts]
        name: CountingName = "multinomial" if len(lower) > 1 else "binomial"
        return construct.counting(name, self.integer(top), *lower)

    def known_variables(self) -> str:
        return f"integer variables known here: {', '.join(sorted(self.variables)) or 'none'}"


def _is_other_column(term: Term) -> bool:
    """True for a symbol of a column other than a vector."""
    return term.type.is_column and term.type.kind == "matrix" and is_accented_symbol(term)
