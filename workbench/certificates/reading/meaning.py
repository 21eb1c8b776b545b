"""Meanings of statements as nested tuples: once from the Coq text, once from the typed term.

Their equality checks the emitter, with which this module shares no code. Only these differences are ignored:
the embedding of real quantities in dual ones, a scalar's position in a product, and x⁴ of a vector as (x·x)².
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from workbench.certificates.reading.read_back import Expression, Unread, number
from workbench.core.construct import rebuild, symbol
from workbench.core.integer_expressions import Linear, as_linear
from workbench.core.integer_instances import count, instantiate
from workbench.core.names import Name
from workbench.core.terms import (
    Apply,
    BigSum,
    Block,
    Counting,
    Derivative,
    DualUnit,
    Identity,
    Integer,
    Number,
    Power,
    Symbol,
    Term,
    TimeOperator,
    Zero,
)
from workbench.core.types import Declaration
from workbench.engines.inventory import NoDefinitions
from workbench.engines.inventory.rodrigues import angle_and_axis
from workbench.language.definitions import Definitions
from workbench.language.goals.goals import Scope
from workbench.language.naming.symbols import SymbolTable
from workbench.prover.goals.sequents import names_of

_UNARY = {
    "skew": "skew",
    "vect": "vect",
    "sym": "symmetric",
    "anti": "antisymmetric",
    "transpose": "transpose",
    "adj": "adjugate",
    "det": "det",
    "trace": "trace",
    "real_part": "re",
    "dual_part": "du",
    "neg": "neg",
    "neg_op": "neg",
    "mneg": "neg",
}
#: What a value is put into, and stays what it is.
_TRANSPARENT = frozenset({"embed", "cell", "times", "scale"})
_CONSTANTS = {"zero": "zero", "void": "zero", "ident": "one", "eps": "eps", "D": "D", "unit_op": "one"}
_BINARY = {"·": "dot", "×": "cross", "⊗": "outer", "∘": "mul", "@": "mul", "•": "mul", "⊚": "mul"}


def added(parts: list[Any]) -> Any:
    """Returns a sum that is flattened in its first addend."""
    first, *rest = parts
    return ("add", *(first[1:] if first[0] == "add" else (first,)), *rest)


def is_written_out(symbol: Symbol, definitions: Definitions, letters: Collection[Name]) -> bool:
    """True if a goal must expand the symbol, since its definition depends on letters that the goal binds."""
    return bool(letters) and not names_of(symbol, Scope(SymbolTable(), definitions, {})).isdisjoint(letters)


class OfText:
    """Meanings of expressions. names: name → term."""

    def __init__(
        self,
        names: Mapping[str, Term],
        of_term: OfTerm,
        families: Mapping[Declaration, str] | None = None,
        integers: Mapping[str, str] | None = None,
    ) -> None:
        self.names, self.of_term = names, of_term
        self.bound: Mapping[str, Any] = {}
        self.families = {name: declaration for declaration, name in (families or {}).items()}
        self.integers = {name: Linear.variable(v) for v, name in (integers or {}).items()}

    def __call__(self, e: Expression) -> Any:
        if str(e) in self.bound:
            return self.bound[str(e)]
        if str(e) in self.names:
            if self.of_term.written_out(self.names[str(e)]) is not None:
                raise Unread(f"{e}, which is about a letter that is bound anew")
            return self.of_term(self.names[str(e)])
        if e.head in ("+", "⊕"):
            return added([self(a) for a in e.arguments])
        if e.head == "-":
            return added([self(e.arguments[0]), ("neg", self(e.arguments[1]))])
        if e.head in _BINARY:
            return (_BINARY[e.head], *map(self, e.arguments))
        if e.head == "neg":
            return ("neg", self(e.arguments[0]))
        if e.head == ":":
            return self(e.arguments[0])
        if e.head == "":
            return self._call(*e.arguments)
        if e.head in _CONSTANTS:
            return (_CONSTANTS[e.head],)
        raise Unread(f"the name {e.head}")

    def _call(self, function: Expression, *arguments: Expression) -> Any:
        name = function.head
        if name in _TRANSPARENT:
            return self(arguments[0])
        for read in (self._number_call, self._derivative_call, self._product_call, self._function_call):
            if (found := read(name, arguments)) is not None:
                return found
        if name in self.families:
            places = tuple(Linear() + self.index(a) for a in arguments)
            return ("symbol", symbol(self.families[name], places))
        if name in _UNARY:
            return (_UNARY[name], *map(self, arguments))
        if len(arguments) == 1:  # an operator on a value
            return applied(self(function), self(arguments[0]))
        raise Unread(f"the function {name}")

    def _number_call(self, name: str, arguments: Sequence[Expression]) -> Any:
        """A number, or one that depends on n; None for another function."""
        match name:
            case "number":
                return ("number", number(arguments[0]))
            case "whole":
                return ("whole", *self._number(arguments[0]))
            case "sum_from":
                return self._sum(*arguments)
        return None

    def _derivative_call(self, name: str, arguments: Sequence[Expression]) -> Any:
        """A derivative by the time or by the place; None for another function."""
        match name:
            case "D":
                return ("der", 1, self(arguments[0]))
            case "mdot":
                return differentiated(self(arguments[0]), 1)
            case "der":
                return ("der", self.index(arguments[0]), self(arguments[1]))
            case "divergence" | "curl":
                variable, body = arguments[0].arguments
                place = self(arguments[1])
                self.bound = {str(variable): place}
                inner = self(body)
                self.bound = {}
                return (name, inner)
        return None

    def _product_call(self, name: str, arguments: Sequence[Expression]) -> Any:
        """A product, a power, or a block of values; None for another function."""
        match name:
            case "square":
                return ("square", self(arguments[0]))
            case "tpower" | "spower" | "power_op":
                return ("power", self(arguments[0]), int(arguments[1].head))
            case "triple":
                return ("triple", *map(self, arguments))
            case "V":
                first, second, third = map(self, arguments)
                return ("above", 1, first, ("above", 1, second, third))
            case "mplus":
                return added([self(a) for a in arguments])
            case "mprod" | "beside" | "above":
                size = [] if name == "mprod" else [int(arguments[0].head)]
                return ({"mprod": "mul"}.get(name, name), *size, *map(self, arguments[1:]))
            case "mscale":
                return ("mul", *map(self, arguments))
        return None

    def _function_call(self, name: str, arguments: Sequence[Expression]) -> Any:
        """A reciprocal, a norm, a cosine, a sine or an exponential; None for another function."""
        match name:
            case "over" | "length" | "cosine_of" | "sine_of" if arguments[0].head == "now":
                word = {"length": "norm", "cosine_of": "cos", "sine_of": "sin"}.get(name, name)
                return (word, self(arguments[1]))
            case "dual_over" | "dual_length":
                return self._by_its_real_part(name, *map(self, arguments))
            case "dual_cos" | "dual_sin":
                return (name[5:], self(arguments[0]))
            case "rodrigues":
                return ("exp", self(arguments[0])[1], self(arguments[2]))
            case "exp_eps":
                return ("exp", ("mul", ("eps",), self(arguments[0])))
        return None

    def index(self, e: Expression) -> Linear | int:
        """Returns a natural number of Coq; one without variables is an int."""
        if e.head in self.integers:
            return self.integers[e.head]
        if e.head.removesuffix("%nat").isdigit():
            return int(e.head.removesuffix("%nat"))
        name = e.arguments[0].head if e.arguments else ""
        match name, [self.index(a) for a in e.arguments[1:]]:
            case "S", [one]:
                return one + 1
            case "pred", [one]:
                return one - 1
            case "nat_plus", [int(one), int(two)]:
                return one + two
            case "nat_plus", [one, two]:
                return as_linear(one) + two
            case "nat_minus", [int(one), int(two)]:
                return one - two
            case "nat_minus", [one, two]:
                return as_linear(one) - two
        raise Unread(f"the number {e}")

    def _number(self, e: Expression) -> tuple[Any, ...]:
        if e.head == "" and e.arguments[0].head == "choose":
            return ("binomial", *(Linear() + self.index(a) for a in e.arguments[1:]))
        return (self.index(e),)

    def _sum(self, first: Expression, many: Expression, addend: Expression) -> Any:
        variable, body = addend.arguments
        lower, count_ = Linear() + self.index(first), Linear() + self.index(many)
        outer = self.integers
        self.integers = {**outer, str(variable): Linear.variable(bound(len(outer)))}
        inner = self(body)
        self.integers = outer
        return ("sum", lower, count_, inner)

    def _by_its_real_part(self, name: str, value: Any, *helpers: Any) -> Any:
        over = ("over", ("re", value)), ("over", ("norm", ("re", value)))
        wanted = (over[0],) if name == "dual_over" else (("norm", ("re", value)), over[1])
        if helpers != wanted:
            raise Unread(f"{name} of {helpers}")
        return ("over" if name == "dual_over" else "norm", value)


def bound(depth: int) -> str:
    """Returns the placeholder for the variable of a sum."""
    return f"·{depth}"


def applied(operator: Any, value: Any) -> Any:
    return ("der", 1, value) if operator == ("D",) else ("mul", operator, value)


def differentiated(value: Any, order: int) -> Any:
    return ("der", order + value[1], value[2]) if value[0] == "der" else ("der", order, value)


class OfTerm:
    """Meanings of typed terms; symbols stand for themselves."""

    def __init__(
        self, definitions: Definitions, integers: int = 0, letters: frozenset[Name] = frozenset()
    ) -> None:
        self.definitions, self.depth, self.letters = definitions, integers, letters

    def with_letters(self, letters: Iterable[Name], integers: int) -> OfTerm:
        """Returns the meanings inside a quantifier that binds these letters, on which definitions may
        depend."""
        return OfTerm(self.definitions, integers, self.letters.union(letters))

    def written_out(self, t: Term) -> Term | None:
        """Returns the definition of a symbol that depends on such letters."""
        if not self.letters or not isinstance(t, Symbol):
            return None
        body = self.definitions.lookup(t)
        return body if body is not None and is_written_out(t, self.definitions, self.letters) else None

    def __call__(self, t: Term) -> Any:
        match t:
            case Number(value=value):
                return ("number", value)
            case Integer(value=value):
                return ("number", Fraction(int(value))) if value.is_number else ("whole", value)
            case Counting(name=name, arguments=arguments):
                if not all(a.is_number for a in arguments):
                    return ("whole", name, *arguments)
                return self(count(name, arguments))
            case Zero():
                return ("zero",)
            case Identity():
                return ("one",)
            case DualUnit():
                return ("eps",)
            case TimeOperator():
                return ("D",)
            case Symbol():
                body = self.written_out(t)
                return ("symbol", t) if body is None else self(body)
            case Derivative(body=body, order=order):
                return self._derivative(body, order)
            case BigSum(variables=(variable,), lower=Linear() as lower, upper=upper, body=body):
                self.depth += 1
                inner = self(instantiate(body, {variable: Linear.variable(bound(self.depth - 1))}))
                self.depth -= 1
                return ("sum", lower, upper - lower + 1, inner)
            case Power(base=base, exponent=exponent):
                return self._power(base, int(exponent))
            case Block(entries=entries):
                return self._block(entries)
            case Apply():
                return self._apply(t)
        raise Unread(type(t).__name__)

    def _derivative(self, body: Term, order: Linear) -> Any:
        if order.is_number:
            return ("der", int(order), self(body))
        more = max(order.constant, 0)
        free = ("der", order - more, self(body))
        return ("der", more, free) if more else free

    def _power(self, base: Term, exponent: int) -> Any:
        if base.type.kind == "vector":
            square = ("square", self(base))
            return square if exponent == 2 else ("power", square, exponent // 2)
        return ("power", self(base), exponent)

    def _block(self, entries: tuple[tuple[Term, ...], ...]) -> Any:
        rows = []
        for line in entries:
            row = self(line[-1])
            for cell in reversed(line[:-1]):
                row = ("beside", cell.type.columns, self(cell), row)
            rows.append(row)
        total = rows[-1]
        for line, row in zip(reversed(entries[:-1]), reversed(rows[:-1]), strict=True):
            total = ("above", line[0].type.rows, row, total)
        return total

    def _apply(self, t: Apply) -> Any:
        head, arguments = t.head, t.arguments
        if head == "add":
            return added([self(a) for a in arguments])
        if head == "div":
            below = arguments[1]
            factor = ("number", 1 / below.value) if isinstance(below, Number) else ("over", self(below))
            return ("mul", factor, self(arguments[0]))
        if head == "reciprocal":
            return ("over", self(arguments[0]))
        if head == "exp":
            turn = angle_and_axis(arguments[0], NoDefinitions())
            if turn is not None:
                return ("exp", self(turn[0]), self(turn[1]))
            return ("exp", self._epsilon_first(arguments[0]))
        if head in ("divergence", "curl"):
            return (head, self(self._written_out(arguments[0])))
        if head in ("mul", "compose"):
            left, right = arguments
            if right.type.kind == "scalar" and left.type.kind != "scalar":
                left, right = right, left
            if left.type.kind == "operator" and right.type.kind != "operator":
                return applied(self(left), self(right))
            return ("mul", self(left), self(right))
        return (head, *(self(a) for a in arguments))

    def _epsilon_first(self, argument: Term) -> Any:
        if isinstance(argument, Apply) and argument.head == "neg":
            inner = self._epsilon_first(argument.arguments[0])
            return ("mul", ("eps",), ("neg", inner[2]))
        return self(argument)

    def _written_out(self, field: Term) -> Term:
        """Returns the field with symbols that depend on the coordinate replaced by their definitions."""
        if isinstance(field, Symbol):
            body = self.definitions.lookup(field)
            if body is None or not self._depends(body):
                return field
            return self._written_out(body)
        parts = [self._written_out(child) for child in field.children]
        return rebuild(field, parts) if parts else field

    def _depends(self, term: Term) -> bool:
        for part in term.walk():
            if isinstance(part, Symbol):
                if part.declaration.coordinate:
                    return True
                body = self.definitions.lookup(part)
                if body is not None and self._depends(body):
                    return True
        return False
