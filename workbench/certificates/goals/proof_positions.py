"""Positions in a proof, with the known facts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from workbench.certificates.emission.emitted_nodes import KINDS, NotCertified, flag
from workbench.certificates.theorem import relations
from workbench.core.construct import relation, symbol
from workbench.core.properties import members_of
from workbench.core.terms import Relation, Statement, Term
from workbench.language.definitions import expand
from workbench.language.goals.goals import Atom, Both, Goal, Scope, Variable
from workbench.prover.goals.sequents import kind_of


@dataclass(frozen=True)
class Known:
    """A premise with its proof in Coq, for any `now` if it holds at all times."""

    goal: Goal
    proof: str
    lasts: bool = False


@dataclass(frozen=True)
class Alias:
    """A letter with the value of the term at the instant. proof: of that equality."""

    letter: Variable
    term: Term
    proof: str


@dataclass(frozen=True)
class Place:
    """A position in a proof: the goal, the scope, and the known facts."""

    goal: Goal
    scope: Scope
    known: tuple[Known, ...] = ()
    aliases: tuple[Alias, ...] = ()

    def of(self, goal: Goal) -> Place:
        return replace(self, goal=goal)

    def given(self, goal: Goal, proof: str, lasts: bool = False) -> Place:
        return replace(self, known=(*self.known, Known(goal, proof, lasts)))

    @property
    def lasts(self) -> bool:
        """True if everything that follows here holds at all times."""
        return not self.aliases and all(known.lasts for known in self.known)

    def at_all_times(self) -> Place:
        return replace(self, known=tuple(known for known in self.known if known.lasts), aliases=())


def flattened(goal: Goal, proof: str) -> list[tuple[Relation, str]]:
    """Returns the equations and disequations of a conjunction, each with its proof."""
    match goal:
        case Atom(statement):
            said = list(relations(statement))
            return [(one, _projected(proof, i, len(said))) for i, one in enumerate(said)]
        case Both(parts):
            return [
                pair
                for i, part in enumerate(parts)
                for pair in flattened(part, _projected(proof, i, len(parts)))
            ]
    raise NotCertified(f"{kind_of(goal)} among equations")


def _projected(proof: str, place: int, count: int) -> str:
    for _ in range(place):
        proof = f"(proj2 {proof})"
    return f"(proj1 {proof})" if place < count - 1 else proof


def conj(proofs: Sequence[str]) -> str:
    first, *rest = proofs
    return f"(conj {first} {conj(rest)})" if rest else first


def same(variable: Variable) -> str:
    own = variable.declaration.type
    return f"(@same_at now {flag(own.dual)} {KINDS[own.kind]} _)"


def one_of(statement: Statement) -> Relation:
    (one,) = relations(statement)
    return one


def relation_of(goal: Goal) -> Relation:
    """Returns the relation of an atomic goal. Raises NotCertified for other goals."""
    if not isinstance(goal, Atom):
        raise NotCertified(f"{kind_of(goal)} where one relation is expected")
    return one_of(goal.statement)


def has(alias: Alias, term: Term, at: Place) -> bool:
    letter = symbol(alias.letter.declaration)
    return any(part == letter for part in expand(term, at.scope.definitions).walk())


def as_given(alias: Alias) -> tuple[Relation, str]:
    return relation("=", symbol(alias.letter.declaration), alias.term), alias.proof


def belongs(variable: Variable, term: Term) -> list[Relation]:
    return members_of(variable.declaration, term)
