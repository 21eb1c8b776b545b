"""Goals: statements with quantifiers, and the scope in which their formulas are read."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from workbench.core.formula_errors import ReadError
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.statement_parts import conjuncts
from workbench.core.terms import Conjunction, Relation, Statement, Term
from workbench.core.types import Declaration
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read_formula, read_term


class GoalError(ValueError):
    """A goal that cannot be parsed."""


@dataclass(frozen=True)
class Variable:
    """A bound letter: its declaration, and for a map the declaration of its argument."""

    declaration: Declaration
    argument: Declaration | None = None

    @property
    def name(self) -> Name:
        return self.declaration.name

    @property
    def letter(self) -> Name:
        """The name of the letter; for a map without its argument."""
        return self.declaration.name.without_arguments()


@dataclass(frozen=True)
class Atom:
    """Equations and disequations without quantifiers, which the judge of formulas decides."""

    statement: Statement


@dataclass(frozen=True)
class AtLeast:
    """left ≥ right for real scalars."""

    left: Term
    right: Term


@dataclass(frozen=True)
class All:
    variables: tuple[Variable, ...]
    body: Goal


@dataclass(frozen=True)
class AllFrom:
    """The statement for every integer from `least` on."""

    integer: str
    least: int
    body: Goal


@dataclass(frozen=True)
class AllBelow:
    """The statement for every integer from `least` on that is less than `bound`."""

    integer: str
    least: int
    bound: Linear
    body: Goal


@dataclass(frozen=True)
class Exists:
    variables: tuple[Variable, ...]
    body: Goal
    unique: bool


@dataclass(frozen=True)
class Implies:
    """An implication. `lasting`: the premise holds at all times, and not only at one instant."""

    premise: Goal
    conclusion: Goal
    lasting: bool = False


@dataclass(frozen=True)
class Iff:
    left: Goal
    right: Goal


@dataclass(frozen=True)
class Both:
    parts: tuple[Goal, ...]


Goal = Atom | AtLeast | All | AllFrom | AllBelow | Exists | Implies | Iff | Both


@dataclass(frozen=True)
class Scope:
    """The scope of formulas: the symbols, their definitions, the integer variables (name → least value)."""

    table: SymbolTable
    definitions: Definitions
    integers: Mapping[str, int]

    def with_variables(self, variables: Sequence[Variable]) -> Scope:
        table = self.table
        for variable in variables:
            formals = () if variable.argument is None else (variable.argument,)
            table = table.with_symbol(variable.declaration, formals)
        return replace(self, table=table)

    def with_integer(self, name: str, least: int) -> Scope:
        return replace(self, integers={**self.integers, name: least})

    def term(self, latex: str) -> Term:
        """Returns the term of a LaTeX text. Raises ReadError or IllFormedAt."""
        return read_term(latex, self.table, self.integers)

    def statement(self, latex: str) -> Statement:
        """Returns the statement of a LaTeX text. Raises ReadError or IllFormedAt; ReadError if the formula
        states another range than its goal."""
        reading = read_formula(latex, self.table, self.integers)
        for stated in reading.ranges:
            if not stated.lower.is_number or self.integers.get(stated.variable) != int(stated.lower):
                message = f"the formula states a range of {stated.variable} that its goal does not"
                raise ReadError(message, 1, 1)
        statements = reading.statements
        return statements[0] if len(statements) == 1 else Conjunction(statements)


def inside(goal: Goal) -> tuple[Goal, ...]:
    """Returns the direct subgoals."""
    match goal:
        case All(body=body) | AllFrom(body=body) | AllBelow(body=body) | Exists(body=body):
            return (body,)
        case Implies(left, right) | Iff(left, right):
            return left, right
        case Both(parts):
            return parts
    return ()


def atoms(goal: Goal) -> Iterator[Statement]:
    """Yields the formulas in the goal."""
    if isinstance(goal, Atom):
        yield goal.statement
    for part in inside(goal):
        yield from atoms(part)


def bound_integers(goal: Goal) -> set[str]:
    """Returns the integers that the goal binds anywhere."""
    own = {goal.integer} if isinstance(goal, AllFrom | AllBelow) else set()
    return own.union(*map(bound_integers, inside(goal)))


def equations(statement: Statement) -> Iterator[Relation]:
    """Yields the relations of a chain or a system. Raises GoalError for a statement with ⇒ or ⇔."""
    for part in conjuncts(statement):
        if not isinstance(part, Relation) or part.operator not in ("=", "≠"):
            raise GoalError("expected equations, got an implication or an approximation")
        yield part
