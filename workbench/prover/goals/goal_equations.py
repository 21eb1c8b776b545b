"""What a goal says that numbers can be put into: its equations, each for all that it is said of."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product

from workbench.core.terms import Conjunction, Equivalence, Statement
from workbench.language.goals.goals import All, AllFrom, Atom, Both, Goal, Iff, Implies

#: Values of each integer that are looked at, from the least one on.
MEMBERS = 3


@dataclass(frozen=True)
class Said:
    """A statement, what it supposes at the same instant, and the integers that it holds for, each with its
    least value."""

    statement: Statement
    premises: tuple[Statement, ...] = ()
    integers: tuple[tuple[str, int], ...] = ()

    def assignments(self) -> Iterator[dict[str, int]]:
        """The lowest values of the integers, no two alike; {} alone without any."""
        names = [name for name, _ in self.integers]
        for values in product(*(range(least, least + MEMBERS) for _, least in self.integers)):
            yield dict(zip(names, values, strict=True))


#: Of no goal yet.
_NOTHING = Conjunction(())


def said(goal: Goal, under: Said | None = None) -> Iterator[Said]:
    """The equations of a goal that stand behind no ∃ and no ⟹, whose premises are equations too."""
    here = under or Said(_NOTHING)
    match goal:
        case Atom(statement):
            yield replace(here, statement=statement)
        case All(body=body):
            yield from said(body, here)
        case AllFrom(integer, least, body):
            yield from said(body, replace(here, integers=(*here.integers, (integer, least))))
        case Implies(premise, conclusion, lasting=False) if (given := _plain(premise)) is not None:
            yield from said(conclusion, replace(here, premises=(*here.premises, *given)))
        case Iff(Atom(left), Atom(right)):
            yield replace(here, statement=Equivalence(left, right))
        case Both(parts):
            for part in parts:
                yield from said(part, here)


def _plain(premise: Goal) -> tuple[Statement, ...] | None:
    """The equations and inequations that the premise is made of, if it has nothing else."""
    match premise:
        case Atom(statement):
            return (statement,)
        case Both(parts):
            found = [given for part in parts if (given := _plain(part)) is not None]
            return tuple(s for given in found for s in given) if len(found) == len(parts) else None
    return None
