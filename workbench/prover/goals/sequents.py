"""Sequents: a goal with its scope and premises; obligations: equations for the judge of formulas."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from workbench.core.integer_instances import free_integers
from workbench.core.names import Name
from workbench.core.terms import Extremum, Naming, Relation, Statement, Symbol, Term
from workbench.language.goals.goals import (
    All,
    AllBelow,
    AllFrom,
    AtLeast,
    Atom,
    Both,
    Exists,
    Goal,
    Iff,
    Implies,
    Scope,
    Variable,
    inside,
)

FORMULA = "formula"


class NotShown(Exception):
    """A proof does not show its goal; the message gives the rule and the reason."""


@dataclass(frozen=True)
class Premise:
    """A premise. `lasting`: it holds at all times, so that its sides may be differentiated."""

    goal: Goal
    lasting: bool


@dataclass(frozen=True)
class Sequent:
    """A goal with its letters and premises."""

    goal: Goal
    scope: Scope
    premises: tuple[Premise, ...] = ()

    def of(self, goal: Goal) -> Sequent:
        return replace(self, goal=goal)

    def given(self, goal: Goal, lasting: bool) -> Sequent:
        return replace(self, premises=(*self.premises, Premise(goal, lasting)))

    @property
    def lasts(self) -> bool:
        """True if consequences of the premises hold at all times: if all premises do."""
        return all(premise.lasting for premise in self.premises)

    def at_all_times(self) -> Sequent:
        """Returns the sequent with only the premises that hold at all times."""
        return replace(self, premises=tuple(premise for premise in self.premises if premise.lasting))

    def with_integer(self, name: str, least: int) -> Sequent:
        """Returns the sequent with an integer from `least` on. Raises NotShown for a letter in use."""
        if name in self.scope.integers:
            raise NotShown(f"{name} is an integer already; bind another letter")
        return replace(self, scope=self.scope.with_integer(name, least))


@dataclass(frozen=True)
class Obligation:
    """An obligation for the judge of formulas: `statement` under `assume`, for all the integers."""

    rule: str
    statement: Statement
    scope: Scope
    assume: tuple[Statement, ...] = ()

    @property
    def is_trivial(self) -> bool:
        return isinstance(self.statement, Relation) and self.statement.left == self.statement.right


def kind_of(goal: Goal) -> str:
    if isinstance(goal, Exists):
        return "∃!" if goal.unique else "∃"
    names = {Atom: "a formula", AtLeast: "≥", All: "∀", AllFrom: "∀ n", Implies: "⇒", Iff: "⇔", Both: "∧"}
    return (names | {AllBelow: "∀ k < n"})[type(goal)]


def atoms_of(goal: Both) -> tuple[Atom, ...] | None:
    """Returns the parts if all of them are atoms, else None."""
    atoms = tuple(part for part in goal.parts if isinstance(part, Atom))
    return atoms if len(atoms) == len(goal.parts) else None


def supposed(sequent: Sequent, using: tuple[int, ...] | None) -> Iterator[Statement]:
    for place, premise in enumerate(sequent.premises):
        if using is not None and place not in using:
            continue
        if isinstance(premise.goal, Atom):
            yield premise.goal.statement
        elif isinstance(premise.goal, Both) and (atoms := atoms_of(premise.goal)) is not None:
            yield from (atom.statement for atom in atoms)
        elif using is not None:
            raise NotShown(f"premise {place} is {kind_of(premise.goal)}, which the kernel cannot suppose")


def refuse_used(sequent: Sequent, variables: tuple[Variable, ...]) -> None:
    """Raises NotShown if a premise contains one of the letters, which would no longer be arbitrary."""
    names = {variable.name for variable in variables}
    for premise in sequent.premises:
        free = _free_names(premise.goal, sequent.scope)
        if both := ", ".join(map(str, names & free)):
            raise NotShown(f"{both} stands in a premise already; bind another letter")


def _free_names(goal: Goal, scope: Scope) -> set[Name]:
    match goal:
        case Atom(statement):
            return {
                n
                for r in relations_of(statement)
                for side in (r.left, r.right)
                for n in names_of(side, scope)
            }
        case AtLeast(left, right):
            return names_of(left, scope) | names_of(right, scope)
        case All(variables, body) | Exists(variables, body):
            return _free_names(body, scope) - {variable.name for variable in variables}
    return set().union(*(_free_names(part, scope) for part in inside(goal)))


def integers_of(goal: Goal) -> set[str]:
    """Returns the free integers of the goal."""
    match goal:
        case Atom(statement):
            return {n for r in relations_of(statement) for s in (r.left, r.right) for n in free_integers(s)}
        case AtLeast(left, right):
            return {*free_integers(left), *free_integers(right)}
    names = set().union(*map(integers_of, inside(goal)))
    if isinstance(goal, AllBelow):
        return names - {goal.integer} | goal.bound.variables
    return names - {goal.integer} if isinstance(goal, AllFrom) else names


def relations_of(statement: Statement) -> Iterator[Relation]:
    match statement:
        case Relation():
            yield statement
        case Naming(parts=parts, given=given):
            for part in (*parts, *given):
                yield from relations_of(part)
        case Extremum(body=body, value=value):
            yield Relation("=", body, value)
        case _ if hasattr(statement, "parts"):
            for part in statement.parts:
                yield from relations_of(part)
        case _:
            yield from relations_of(statement.left)
            yield from relations_of(statement.right)


def names_of(term: Term, scope: Scope) -> set[Name]:
    """Returns the names that the term depends on; a member of a family depends on the names in its
    definitions."""
    names: set[Name] = set()
    waiting: list[tuple[Term, frozenset[Name]]] = [(term, frozenset())]
    while waiting:
        body, formals = waiting.pop()
        for part in body.walk():
            if isinstance(part, Symbol) and part.declaration.name not in names | formals:
                names.add(part.declaration.name)
                own = scope.definitions.about(part)
                waiting += [(d.body, frozenset(p.name for p in d.parameters)) for d in own]
    return names
