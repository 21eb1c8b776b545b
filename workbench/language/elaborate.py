"""Bracket structure to typed terms: sums, brackets, fractions, and the integers in scope."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import contextmanager
from fractions import Fraction as Rational
from typing import TypeVar

from workbench.language import construct
from workbench.language.errors import Fault, Misfit
from workbench.language.integers import Linear
from workbench.language.letters import named
from workbench.language.names import linear, variable_name
from workbench.language.products import product
from workbench.language.signatures import agree
from workbench.language.symbols import SymbolTable
from workbench.language.syntax import (
    Accented,
    Binomial,
    Bracket,
    Chain,
    Conditional,
    Fraction,
    Group,
    Leaf,
    Lines,
    Matrix,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
    Summation,
)
from workbench.language.terms import IllFormed, Integer, Number, Term, Zero

Result = TypeVar("Result")

#: How deep terms may nest; a longer product than this counts as nesting too.
DEEPEST_TERM = 120
_LONGEST_NUMBER = 100


class Elaborator:
    """Reads the nodes of one formula. `variables` are the integer variables in scope."""

    def __init__(self, table: SymbolTable, variables: frozenset[str]) -> None:
        self.table = table
        self.variables = variables
        self.depth = 0
        self.tensor_operand: int | None = None  # where an operator was last applied to a bare tensor

    def build(self, at: int, make: Callable[..., Result], *arguments) -> Result:
        """make(*arguments), with the place `at` put on what does not fit."""
        try:
            return make(*arguments)
        except IllFormed as fault:
            raise Misfit(fault, at) from None

    def apply(self, at: int, head: str, *arguments: Term) -> Term:
        return self.build(at, construct.apply, head, *arguments)

    @contextmanager
    def bound(self, names: Sequence[str], at: int):
        for name in names:
            if name in self.variables or names.count(name) > 1:
                raise Fault(f"the summation variable {name} already has a meaning here", at)
        outer, self.variables = self.variables, self.variables.union(names)
        yield
        self.variables = outer

    @contextmanager
    def nested(self, at: int):
        self.depth += 1
        if self.depth > DEEPEST_TERM:
            raise Fault(f"the formula nests deeper than {DEEPEST_TERM}", at)
        yield
        self.depth -= 1

    def term(self, node: Node) -> Term:
        with self.nested(node.at):
            return self._term(node)

    def _term(self, node: Node) -> Term:
        value = self.integer_expression(node)
        if value is not None:
            return value
        match node:
            case Sum():
                return self.sum(node)
            case Product():
                return product(self, node.items)
            case Leaf(kind="NUMBER"):
                return self.number(node)
            case (
                Leaf(kind="FUNCTION")
                | Scripted(nucleus=Leaf(kind="FUNCTION") | Group(parts=()))
                | Summation()
            ):
                return product(self, (node,))
            case Leaf() | Styled() | Accented() | Scripted():
                return named(self, node)
            case Group(parts=(part,)):
                return self.term(part)
            case Group():
                raise Fault("expected one expression in the braces", node.at)
            case Bracket():
                return self.bracket(node)
            case Fraction():
                return product(self, (node,))
            case Binomial():
                return self.combinations(node.top, node.bottom)
            case Matrix():
                rows = [[self.term(entry) for entry in row] for row in node.rows]
                return self.build(node.at, construct.block, rows)
            case Chain(relations=((sign, at), *_)):
                raise Fault(f"a relation ({sign}) inside an expression", at)
            case Chain() | Conditional() | Lines():
                raise Fault("expected an expression, not a statement", node.at)
        raise Fault("a sign without its operands", node.at)

    # integers and numbers

    def integer_expression(self, node: Node) -> Term | None:
        """n, n+1, 2k − 1 as one integer; numbers alone are left to `number` and `sum`."""
        if isinstance(node, Leaf | Scripted | Sum | Product):
            value = _linear_or_none(node, self.variables)
            if value is not None and not value.is_number:
                for name in value.variables:
                    self.integer_variable(name, node.at)
                return construct.integer(value)
        return None

    def integer_variable(self, name: str, at: int) -> Term:
        if name in self.table.symbols:
            raise Fault(f"{name} is an integer variable and a declared symbol", at)
        return construct.integer(Linear.variable(name))

    def integer(self, node: Node) -> Linear:
        value = linear(node, self.variables)
        if value is None:
            raise Fault(f"expected an integer expression; {self.known_variables()}", node.at)
        return value

    def combinations(self, top: Node, bottom: Node) -> Term:
        """n over k, or over k_1, k_2, …."""
        parts = bottom.parts if isinstance(bottom, Group) else (bottom,)
        lower = [self.integer(part) for part in parts]
        name = "multinomial" if len(lower) > 1 else "binomial"
        return construct.counting(name, self.integer(top), *lower)

    def known_variables(self) -> str:
        return f"integer variables known here: {', '.join(sorted(self.variables)) or 'none'}"

    def number(self, node: Leaf) -> Term:
        if len(node.text) > _LONGEST_NUMBER:
            raise Fault(f"a number of {len(node.text)} digits; at most {_LONGEST_NUMBER}", node.at)
        value = Rational(node.text)
        return construct.number(value) if value else construct.zero()

    # sums and brackets

    def sum(self, node: Sum) -> Term:
        addends, places = [], []
        for sign, at, addend in node.addends:
            term = self.term(addend)
            if sign == "-":
                literal_number = isinstance(term, Number) and not isinstance(addend, Bracket | Group)
                if not addends and literal_number:
                    term = construct.number(-term.value)
                elif isinstance(term, Integer):
                    term = construct.integer(-term.value)
                else:
                    term = self.apply(at, "neg", term)
            addends.append(term)
            places.append(at)
        if len(addends) == 1:
            return addends[0]
        try:
            return construct.apply("add", *addends)
        except IllFormed as fault:
            raise Misfit(fault, places[_first_that_differs(addends)]) from None

    def bracket(self, node: Bracket) -> Term:
        terms = [self.term(part) for part in node.parts]
        if node.kind in ("|", "\\|") and len(terms) == 1:
            return self.apply(node.at, "norm", terms[0])
        if len(terms) == 1 and node.kind != "\\langle":
            return terms[0]
        if len(terms) == 3 and node.kind in ("(", "\\langle"):
            return self.apply(node.at, "triple", *terms)
        if len(terms) == 2 and node.kind == "(" and terms[0].type.kind != terms[1].type.kind:
            return self.build(node.at, construct.block, [terms])  # (a_n, Φ_n): beside each other
        message = "a triple product has three, a pair (a, T) two of different kinds"
        raise Fault(f"{len(terms)} expressions between brackets; {message}", node.at)

    def fraction(self, node: Fraction) -> Term:
        numerator, denominator = self.term(node.numerator), self.term(node.denominator)
        if isinstance(numerator, Number | Zero) and isinstance(denominator, Number) and _literals(node):
            top = numerator.value if isinstance(numerator, Number) else 0
            return construct.number(Rational(top) / denominator.value) if top else construct.zero()
        if isinstance(denominator, Zero):
            raise Fault("division by zero", node.denominator.at)
        return self.apply(node.at, "div", numerator, denominator)

    # sums over integers

    def summation(self, node: Summation, body: Callable[[], Term]) -> Term:
        """Σ_{k=a}^{b} or Σ_{k₁+k₂=k} of the body, which is read with the variables in scope."""
        lower = node.lower.parts[0] if isinstance(node.lower, Group) and node.lower.parts else node.lower
        if not isinstance(lower, Chain) or [sign for sign, _ in lower.relations] != ["="]:
            raise Fault("expected the bounds of the sum, as in \\sum_{k=0}^{n}", node.at)
        left, right = lower.sides
        single = variable_name(left)
        if single is not None:
            if node.upper is None:
                raise Fault("the sum has no upper bound", node.at)
            names, start, end = [single], self.integer(right), self.upper_bound(node.upper)
        else:
            names, start = self.parts_of(left), None
            if node.upper is not None:
                raise Fault("a sum over k_1 + k_2 + … = k has no upper bound", node.upper.at)
            end = self.integer(right)
        with self.bound(names, node.at):
            term = body()
        return self.build(node.at, construct.big_sum, names, start, end, term)

    def upper_bound(self, node: Node) -> Linear:
        inner = node.parts[0] if isinstance(node, Group) and len(node.parts) == 1 else node
        if isinstance(inner, Leaf) and inner.text == "∞":
            raise Fault("an infinite sum; sums have integer bounds", node.at)
        return self.integer(node)

    def parts_of(self, node: Node) -> list[str]:
        names = [variable_name(addend) for _, _, addend in node.addends] if isinstance(node, Sum) else [None]
        if None in names or any(sign == "-" for sign, _, _ in node.addends):
            raise Fault("expected summation variables, as in k_1 + k_2 = k", node.at)
        return names


def _linear_or_none(node: Node, variables: frozenset[str]) -> Linear | None:
    try:
        return linear(node, variables)
    except Fault:
        return None


def _literals(node: Fraction) -> bool:
    """Whether both parts are written as numbers, so that the fraction is one."""
    top, bottom = (
        part.parts[0] if isinstance(part, Group) and len(part.parts) == 1 else part
        for part in (node.numerator, node.denominator)
    )
    if isinstance(top, Sum) and len(top.addends) == 1:
        top = top.addends[0][2]
    return isinstance(top, Leaf) and isinstance(bottom, Leaf)


def _first_that_differs(addends: Sequence[Term]) -> int:
    for count in range(2, len(addends) + 1):
        try:
            agree(addends[:count], "the addends")
        except IllFormed:
            return count - 1
    return 0
