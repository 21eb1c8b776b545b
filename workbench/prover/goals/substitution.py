"""Substitution of terms for letters, with the conditions that make it sound."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from workbench.core.construct import rebuild, relation, with_children, zero
from workbench.core.integer_expressions import Linear, as_linear
from workbench.core.integer_instances import free_integers, instantiate
from workbench.core.names import Name
from workbench.core.operations import COMPONENTWISE, GRADIENTS, PARTIALS
from workbench.core.terms import (
    Apply,
    BigSum,
    Conjunction,
    Definition,
    Derivative,
    Equivalence,
    Extremum,
    Implication,
    Naming,
    Relation,
    Statement,
    Symbol,
    Term,
    TimeOperator,
    Zero,
)
from workbench.language.definitions import Definitions, expand
from workbench.language.goals.goals import (
    All,
    AllBelow,
    AllFrom,
    AtLeast,
    Atom,
    Both,
    Exists,
    Goal,
    GoalError,
    Iff,
    Implies,
    Variable,
)


def is_constant(term: Term, definitions: Definitions) -> bool:
    """True if nothing in the term depends on time."""
    return not any(
        isinstance(part, Symbol) and not part.declaration.constant
        for part in expand(term, definitions).walk()
    )


def is_function(term: Term, definitions: Definitions) -> bool:
    """True for a function that the paper defines: its definition may differentiate its argument."""
    return isinstance(term, Symbol) and bool(term.arguments) and bool(definitions.about(term))


def differentiates(term: Term, name: Name, definitions: Definitions, below: bool = False) -> bool:
    """True if the letter is, or could be, under a time derivative."""
    if isinstance(term, Symbol) and term.declaration.name == name:
        return below
    below = below or isinstance(term, Derivative | TimeOperator) or is_function(term, definitions)
    below = below or (getattr(term, "head", "") == "mul" and term.children[0].type.kind == "operator")
    return any(differentiates(child, name, definitions, below) for child in term.children)


def _differentiates_by_place(term: Term, definitions: Definitions) -> bool:
    """True for a div, a curl or a ∂, or for a function that the paper defines by one."""
    if not is_function(term, definitions):
        return _is_by_place(term)
    return any(map(_is_by_place, definitions.reached(term)))


def _is_by_place(term: Term) -> bool:
    return isinstance(term, Apply) and term.head in GRADIENTS | PARTIALS


class Substitution:
    """Terms for the bound letters of one quantifier.

    A term for a constant letter under a derivative, or in a statement about all times, must be constant, too:
    at one instant a constant has the value of the term, but not its derivatives. Nothing is substituted under
    div, curl and ∂: a letter has the value of the term at one position only. Definitions that use a letter of
    the paper are expanded.
    """

    def __init__(self, terms: Mapping[Variable, Term], definitions: Definitions) -> None:
        self.definitions = definitions
        self.terms = {v.declaration.name: (v, term) for v, term in terms.items()}
        self.moving = {
            v.declaration.name
            for v, term in terms.items()
            if v.declaration.constant and not is_constant(term, definitions)
        }
        self.used = {each.declaration.name for each in definitions.symbols_in(*terms.values())}
        self.integers = frozenset().union(*map(free_integers, terms.values()))

    def goal(self, goal: Goal, lasting: bool = False) -> Goal:
        """Returns the goal after substitution. Raises GoalError if a letter would be captured or
        differentiated illegally.

        lasting: the goal holds at all times.
        """
        match goal:
            case Atom(statement):
                return Atom(self.statement(statement, lasting))
            case AtLeast(left, right):
                return AtLeast(self.term(left, lasting), self.term(right, lasting))
            case All(variables, body) | Exists(variables, body):
                for variable in variables:
                    if variable.name in self.used or variable.name in self.terms:
                        raise GoalError(f"{variable.name} is bound again where a term with it is put in")
                new = self.goal(body, lasting)
                return All(variables, new) if isinstance(goal, All) else Exists(variables, new, goal.unique)
            case AllFrom(integer, _, body) | AllBelow(integer, _, _, body):
                if integer in self.integers:
                    raise GoalError(f"{integer} is bound again where a term with it is put in")
                return replace(goal, body=self.goal(body, lasting))
            case Implies(premise, conclusion, always):
                before, after = (self.goal(part, lasting or always) for part in (premise, conclusion))
                return Implies(before, after, always)
            case Iff(left, right):
                return Iff(self.goal(left, lasting), self.goal(right, lasting))
            case Both(parts):
                return Both(tuple(self.goal(part, lasting) for part in parts))

    def statement(self, statement: Statement, lasting: bool = False) -> Statement:
        match statement:
            case Relation(operator, left, right):
                return relation(operator, self.term(left, lasting), self.term(right, lasting))
            case Conjunction(parts):
                return Conjunction(tuple(self.statement(part, lasting) for part in parts))
            case Equivalence(left, right) | Implication(left, right):
                return type(statement)(self.statement(left, lasting), self.statement(right, lasting))
            case Naming():
                raise GoalError("a set or a map within a goal")
            case Extremum(least, letters, body, value):
                for letter in letters:
                    if letter.declaration.name in self.used or letter.declaration.name in self.terms:
                        raise GoalError(f"{letter.declaration.name} varies where a term with it is put in")
                return Extremum.of(least, letters, self.term(body, lasting), self.term(value, lasting))

    def term(self, term: Term, lasting: bool = False) -> Term:
        if not any(self._is_reached_by(definition, set()) for definition in self.definitions):
            return self._term(term, lasting)
        whole = expand(term, self.definitions)
        for part in whole.walk():
            if isinstance(part, Symbol) and self._left_over(part):
                raise GoalError(f"{part.declaration.name} is known by its recurrence only, and uses a letter")
        return self._term(whole, lasting)

    def as_written(self, term: Term) -> Term:
        """Returns the term with its letters replaced where they occur; definitions are not expanded."""
        return self._term(term, False)

    def _stands_in(self, term: Term) -> bool:
        return any(p.declaration.name in self.terms for p in term.symbols())

    def _left_over(self, part: Symbol) -> bool:
        """True if a member of a family, which stays as it is, depends on one of the letters."""
        return any(self._is_reached_by(definition, set()) for definition in self.definitions.about(part))

    def _is_reached_by(self, definition: Definition, seen: set[Name]) -> bool:
        """True if the definition uses one of the letters, other than as a formal argument."""
        formals = {parameter.name for parameter in definition.parameters}
        for part in definition.body.walk():
            if not isinstance(part, Symbol) or part.declaration.name in seen | formals:
                continue
            seen.add(part.declaration.name)
            if part.declaration.name in self.terms:
                return True
            if any(self._is_reached_by(other, seen) for other in self.definitions.about(part)):
                return True
        return False

    def _term(self, term: Term, differentiated: bool) -> Term:
        if _differentiates_by_place(term, self.definitions) and self._stands_in(term):
            raise GoalError("a letter is under a derivative by the place, or by a coordinate")
        if isinstance(term, Symbol) and term.declaration.name in self.terms:
            variable, new = self.terms[term.declaration.name]
            if differentiated and variable.name in self.moving:
                raise GoalError(
                    f"{variable.name} is a constant under a derivative, and what replaces it is not"
                )
            if variable.argument is None:
                return new
            if differentiated:
                raise GoalError(f"{variable.name} is a map under a derivative")
            argument = self.as_written(term.arguments[0])
            return Substitution({Variable(variable.argument): argument}, self.definitions).as_written(new)
        if isinstance(term, Derivative) or is_function(term, self.definitions):
            return with_children(term, lambda child: self._term(child, True))
        if isinstance(term, Apply) and term.head == "mul" and term.arguments[0].type.kind == "operator":
            left, right = term.arguments
            return _without_zeros(rebuild(term, [self._term(left, differentiated), self._term(right, True)]))
        children = tuple(self._term(child, differentiated) for child in term.children)
        if all(new is old for new, old in zip(children, term.children, strict=True)):
            return term
        if isinstance(term, BigSum) and not self.integers.isdisjoint(term.variables):
            raise GoalError(f"{', '.join(term.variables)} is summed over where a term with it is put in")
        return _without_zeros(rebuild(term, children))


def _without_zeros(term: Term) -> Term:
    """Returns 0 for a linear operation on a 0, also for an unknown operator."""
    is_linear = isinstance(term, Apply) and term.head in COMPONENTWISE
    return zero(term.type) if is_linear and any(isinstance(c, Zero) for c in term.children) else term


def at_integer(goal: Goal, name: str, value: Linear | int) -> Goal:
    """Returns the goal with an integer substituted. Raises IllFormed for a member that does not exist."""
    values = {name: value}
    match goal:
        case Atom(statement):
            return Atom(instantiate(statement, values))
        case AtLeast(left, right):
            return AtLeast(instantiate(left, values), instantiate(right, values))
        case All(variables, body):
            return All(variables, at_integer(body, name, value))
        case Exists(variables, body, unique):
            return Exists(variables, at_integer(body, name, value), unique)
        case AllFrom(integer, _, body) | AllBelow(integer, _, _, body):
            if integer == name or integer in as_linear(value).variables:
                raise GoalError(f"{integer} is bound twice")
            inner = at_integer(body, name, value)
            if isinstance(goal, AllBelow):
                return replace(goal, body=inner, bound=goal.bound.substitute(values))
            return replace(goal, body=inner)
        case Implies(premise, conclusion, lasting):
            return Implies(at_integer(premise, name, value), at_integer(conclusion, name, value), lasting)
        case Iff(left, right):
            return Iff(at_integer(left, name, value), at_integer(right, name, value))
        case Both(parts):
            return Both(tuple(at_integer(part, name, value) for part in parts))
