"""The equations in a goal that can be evaluated at numbers, with their premises and integers."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product

from workbench.core.terms import Conjunction, Equivalence, Statement
from workbench.language.goals.goals import All, AllFrom, Atom, Both, Goal, Iff, Implies

#: Number of values of each integer that are tested, from the least one on.
MEMBERS = 3


@dataclass(frozen=True)
class GoalEquation:
    """A statement, its premises at the same instant, and its integers with their least values."""

    statement: Statement
    premises: tuple[Statement, ...] = ()
    integers: tuple[tuple[str, int], ...] = ()

    def assignments(self) -> Iterator[dict[str, int]]:
        """Yields the lowest values of the integers, all distinct; {} without integers."""
        names = [name for name, _ in self.integers]
        for values in product(*(range(least, least + MEMBERS) for _, least in self.integers)):
            yield dict(zip(names, values, strict=True))


#: The initial value, before any part of a goal.
_NOTHING = Conjunction(())


def equations_of_goal(goal: Goal, under: GoalEquation | None = None) -> Iterator[GoalEquation]:
    """Yields the equations of a goal that are not under ∃, and under ⟹ only if the premises are equations,
    too."""
    here = under or GoalEquation(_NOTHING)
    match goal:
        case Atom(statement):
            yield replace(here, statement=statement)
        case All(body=body):
            yield from equations_of_goal(body, here)
        case AllFrom(integer, least, body):
            yield from equations_of_goal(body, replace(here, integers=(*here.integers, (integer, least))))
        case Implies(premise, conclusion, lasting=False) if (given := _plain(premise)) is not None:
            yield from equations_of_goal(conclusion, replace(here, premises=(*here.premises, *given)))
        case Iff(Atom(left), Atom(right)):
            yield replace(here, statement=Equivalence(left, right))
        case Both(parts):
            for part in parts:
                yield from equations_of_goal(part, here)


def _plain(premise: Goal) -> tuple[Statement, ...] | None:
    """Returns the equations and disequations that the premise consists of, else None."""
    match premise:
        case Atom(statement):
            return (statement,)
        case Both(parts):
            found = [given for part in parts if (given := _plain(part)) is not None]
            return tuple(s for given in found for s in given) if len(found) == len(parts) else None
    return None
