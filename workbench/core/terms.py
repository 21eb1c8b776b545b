"""Typed terms: the small immutable objects that represent formulas everywhere in the workbench.

`construct.py` builds them and rejects mismatched types or weights. This module knows no LaTeX.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, fields
from fractions import Fraction
from functools import lru_cache
from typing import Any, Literal, dataclass_transform

from workbench.core.codes.type_codes import TypeCode
from workbench.core.integer_expressions import Linear
from workbench.core.reasons import Code, Reason
from workbench.core.types import Declaration, Type, Weight

CountingName = Literal["factorial", "binomial", "multinomial"]
#: The operations on terms; OPERATORS in `operations.py` says what each takes and gives.
Head = Literal[
    "add",
    "neg",
    "dot",
    "cross",
    "kronecker",
    "outer",
    "mul",
    "compose",
    "triple",
    "div",
    "det",
    "trace",
    "symmetric",
    "antisymmetric",
    "skew",
    "vect",
    "vec",
    "transpose",
    "inverse",
    "adjugate",
    "re",
    "du",
    "norm",
    "root",
    "exp",
    "log",
    "pow",
    "sin",
    "cos",
    "arccos",
    "arcsin",
    "arctan",
    "atan2",
    "divergence",
    "curl",
    "partial",
    "total",
    "quaternion",
    "conjugate",
    "scalar part",
    "vector part",
    # of certificates only
    "reciprocal",
    "turn",
]
#: What a relation states of its sides; ≥ only in assumptions.
Sign = Literal["=", "≠", "≈", "≥"]


class IllFormed(ValueError):
    """Types or weights do not match. `intent` names the likely meaning, if there is one."""

    def __init__(self, reason: Reason, intent: str | None = None) -> None:
        super().__init__(reason)
        self.reason = reason
        self.intent = intent

    @property
    def code(self) -> Code:
        return self.reason.code


class Unsupported(IllFormed):
    """A construct that terms cannot represent, although it has a meaning. A claim with it is not
    ill-formed."""


@dataclass(frozen=True, slots=True)
class Term:
    """A formula without a relation. `type` and `weight` are those of its value."""

    type: Type
    weight: Weight
    _hash: int = field(default=0, init=False, repr=False, compare=False)

    @property
    def children(self) -> tuple[Term, ...]:
        return ()

    def walk(self) -> Iterator[Term]:
        """Yields this term and all its subterms, parents first."""
        waiting = [self]
        while waiting:
            term = waiting.pop()
            yield term
            waiting.extend(reversed(term.children))

    def symbols(self) -> Iterator[Symbol]:
        """Yields the symbols in this term, each as often as it occurs."""
        return (term for term in self.walk() if isinstance(term, Symbol))


@dataclass_transform(frozen_default=True)
def _node(cls: Any) -> Any:
    """Returns a frozen dataclass that caches its hash: terms are frequent dictionary keys, and may be
    deep."""
    cls = dataclass(frozen=True, slots=True)(cls)
    structural = cls.__hash__

    def remembered(self: Term) -> int:
        if not self._hash:
            object.__setattr__(self, "_hash", structural(self) or 1)
        return self._hash

    def state(self: Term) -> list[object]:
        return [0 if name == "_hash" else getattr(self, name) for name in names]

    names = [field.name for field in fields(cls)]
    cls.__hash__ = remembered
    cls.__getstate__ = state  # string hashes differ between processes
    return cls


@_node
class Number(Term):
    """A rational constant."""

    value: Fraction


@_node
class Integer(Term):
    """An integer expression used as a scalar, such as the n in n ω."""

    value: Linear


@_node
class Counting(Term):
    """factorial(n), binomial(n, k) or multinomial(n; k₁, …) as a scalar."""

    name: CountingName
    arguments: tuple[Linear, ...]


@_node
class Zero(Term):
    """The 0 of any type. printed: the size printed below it, "3 \\times 1" or "3"; it fixes the type."""

    printed: str = field(default="", compare=False, repr=False)


@_node
class Identity(Term):
    """The unit tensor I, the unit block matrix, or the unit operator, by its type. printed: as for Zero."""

    printed: str = field(default="", compare=False, repr=False)


@_node
class DualUnit(Term):
    """ε with ε² = 0."""


@_node
class TimeOperator(Term):
    """D = d/dt as an operator."""


@_node
class Symbol(Term):
    """A declared symbol: a member of a family (index) or an applied function symbol (arguments)."""

    declaration: Declaration
    index: tuple[Linear, ...] = ()
    arguments: tuple[Term, ...] = ()

    @property
    def children(self) -> tuple[Term, ...]:
        return self.arguments


@_node
class Apply(Term):
    """The operation `head` applied to its arguments; OPERATORS in `operations.py` lists the heads."""

    head: Head
    arguments: tuple[Term, ...]

    @property
    def children(self) -> tuple[Term, ...]:
        return self.arguments


@_node
class Derivative(Term):
    """The time derivative of order `order` (a linear integer expression) of `body`."""

    body: Term
    order: Linear

    @property
    def children(self) -> tuple[Term, ...]:
        return (self.body,)


@_node
class Power(Term):
    """base^exponent; for a vector x² is x·x, for a tensor or an operator the repeated product."""

    base: Term
    exponent: Linear

    @property
    def children(self) -> tuple[Term, ...]:
        return (self.base,)


@_node
class BigSum(Term):
    """Σ of `body` for `variables`: one variable from `lower` to `upper`; or, if `lower` is None,
    all non-negative values of the variables whose sum is `upper`."""

    variables: tuple[str, ...]
    lower: Linear | None
    upper: Linear
    body: Term

    @property
    def children(self) -> tuple[Term, ...]:
        return (self.body,)


@_node
class Integral(Term):
    """An integral or a limit. sign, measure: the LaTeX before and behind the body, as "\\int_{B}" and
    "\\mathrm{d}m".   place: the symbol of the variable, and both bounds or the place; empty if unread."""

    sign: str
    measure: str
    variable: str
    body: Term
    place: tuple[Term, ...] = ()

    @property
    def children(self) -> tuple[Term, ...]:
        return (self.body,)


@_node
class Block(Term):
    """A matrix of blocks, row by row."""

    entries: tuple[tuple[Term, ...], ...]

    @property
    def children(self) -> tuple[Term, ...]:
        return tuple(entry for row in self.entries for entry in row)


@dataclass(frozen=True, slots=True)
class Relation:
    """left = right, left ≠ right, or left ≈ right (equal to first order in all small symbols)."""

    operator: Sign
    left: Term
    right: Term


@dataclass(frozen=True, slots=True)
class Equivalence:
    """left ⇔ right, of two relations."""

    left: Statement
    right: Statement


@dataclass(frozen=True, slots=True)
class Implication:
    """left ⇒ right."""

    left: Statement
    right: Statement


@dataclass(frozen=True, slots=True)
class Conjunction:
    """Several statements that hold together, such as the chain a = b = c."""

    parts: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class Extremum:
    """The statement that `value` is the least (or greatest) value of the body over all values of the bound
    letters, and that the body attains it."""

    least: bool
    letters: tuple[Symbol, ...]
    body: Term
    value: Term

    @staticmethod
    def of(least: bool, letters: tuple[Symbol, ...], body: Term, value: Term) -> Extremum:
        """Returns the statement. Raises IllFormed if the body is not a real scalar of the value's weight."""
        if body.type.kind != "scalar" or body.type.dual:
            raise IllFormed(TypeCode.EXTREMUM_OF_NO_SCALAR(type=body.type))
        if value.type != body.type:
            raise IllFormed(TypeCode.EXTREMUM_OF_DIFFERENT_TYPES(type=body.type, type_2=value.type))
        if None not in (body.weight, value.weight) and body.weight != value.weight:
            raise IllFormed(TypeCode.EXTREMUM_OF_DIFFERENT_WEIGHTS(weight=body.weight, weight_2=value.weight))
        if any(part in letters for part in value.walk()):
            raise IllFormed(TypeCode.EXTREMUM_VARIABLE_OUTSIDE())
        return Extremum(least, letters, body, value)


@dataclass(frozen=True, slots=True)
class Naming:
    """A named set or map. said: its property, as LaTeX.   terms: its constituents.   parts: the conditions
    under which it is a set or map.   given: the hypotheses on its members.   undecided: the part that is not
    checked, if any."""

    said: str
    terms: tuple[Term, ...]
    parts: tuple[Statement, ...]
    given: tuple[Statement, ...] = ()
    undecided: Reason | None = None


Statement = Relation | Equivalence | Implication | Conjunction | Extremum | Naming


@dataclass(frozen=True, slots=True)
class Definition:
    """The definition symbol := body. Each index is a number (Φ₁) or one variable plus a number (Φ_{n+1});
    `parameters` are the formal arguments of a function symbol."""

    declaration: Declaration
    index: tuple[Linear, ...]
    parameters: tuple[Declaration, ...]
    body: Term


def sides_of(statement: Statement) -> Iterator[Term]:
    """Yields the terms that the statement relates."""
    match statement:
        case Relation():
            yield from (statement.left, statement.right)
        case Conjunction(parts=parts):
            for part in parts:
                yield from sides_of(part)
        case Extremum():
            yield from (statement.body, statement.value)
        case Naming():
            yield from statement.terms
        case _:
            yield from sides_of(statement.left)
            yield from sides_of(statement.right)


def column_of_symbols(term: Term | None) -> tuple[Symbol, ...]:
    """Returns the entries of a literal column of distinct scalar symbols, or of a quaternion written by four
    such numbers; () for other terms."""
    match term:
        case Apply(head="quaternion", arguments=(scalar, Block(entries=entries))):
            parts = (scalar, *(entry for row in entries for entry in row))
        case Block() if term.type.is_column:
            parts = term.children
        case _:
            return ()
    symbols = tuple(part for part in parts if isinstance(part, Symbol))
    return symbols if len(set(symbols)) == len(parts) == term.type.rows else ()


@lru_cache(maxsize=1 << 14)
def heads_in(term: Term) -> frozenset[str]:
    """Returns the heads of the operations in a term."""
    own = (term.head,) if isinstance(term, Apply) else ()
    return frozenset(own).union(*map(heads_in, term.children))
