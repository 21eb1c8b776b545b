"""What is known while one formula is read: its symbols, the integers in scope, and how deep it nests."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from contextlib import contextmanager
from typing import TypeVar

from workbench.language import construct
from workbench.language.errors import Fault, Misfit
from workbench.language.integers import Linear
from workbench.language.names import linear
from workbench.language.symbols import SymbolTable
from workbench.language.syntax import Group, Leaf, Node, Product, Scripted, Sum
from workbench.language.terms import IllFormed, Term

Result = TypeVar("Result")

#: How deep terms may nest; a longer product than this counts as nesting too.
DEEPEST_TERM = 120


class Scope(ABC):
    """What letters, products and sums are read in. `variables` are the integer variables in scope."""

    def __init__(self, table: SymbolTable, variables: frozenset[str]) -> None:
        self.table = table
        self.variables = variables
        self.depth = 0
        self.tensor_operand: int | None = None  # where an operator was last applied to a bare tensor

    @abstractmethod
    def term(self, node: Node) -> Term:
        """The term of any node."""

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

    def knows(self, name: str) -> bool:
        """Whether the name is a symbol or an integer variable here."""
        return name in self.table.symbols or name in self.variables

    # integers

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


def _linear_or_none(node: Node, variables: frozenset[str]) -> Linear | None:
    try:
        return linear(node, variables)
    except Fault:
        return None
