"""Goals and proofs of goals, each with one thing changed."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import fields, is_dataclass, replace

from workbench.core.construct import apply, number, relation, symbol
from workbench.core.names import Name
from workbench.core.terms import Conjunction, Equivalence, Implication, Relation, Statement
from workbench.core.types import Declaration
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
)
from workbench.language.goals.proofs import (
    Congruence,
    ExistsIntroduction,
    SumOfSquares,
    TwoWitnesses,
    UniqueExists,
)

Change = Callable[[Relation], Relation]


def made_false(said: Relation) -> Relation:
    """a = b + z with a free z, or a ≠ a."""
    if said.operator != "=":
        return relation(said.operator, said.left, said.left)
    kind = said.left.type.with_dual(said.left.type.dual or said.right.type.dual)
    return relation(
        "=", said.left, apply("add", said.right, symbol(Declaration(Name("z", (r"\mathsf",)), kind)))
    )


def made_idle(said: Relation) -> Relation:
    return relation("=", said.right, said.right)


def with_idle_conclusions(goal: Goal) -> Goal:
    """The goal that comes to nothing: every equation that it comes to is a = a."""
    while (new := next(with_a_changed_conclusion(goal, made_idle, only=_is_busy), None)) is not None:
        goal = new
    return goal


def _is_busy(said: Relation) -> bool:
    return said.left != said.right


def with_a_changed_conclusion(
    goal: Goal, change: Change, only: Callable[[Relation], bool] = lambda said: True
) -> Iterator[Goal]:
    """The goal with one of the equations changed that it comes to, for each of them."""
    match goal:
        case Atom(statement):
            yield from (Atom(new) for new in _statements(statement, change, only))
        case AtLeast(left, right):
            yield AtLeast(left, apply("add", right, number(1)))
        case All(body=body) | AllFrom(body=body) | AllBelow(body=body) | Exists(body=body):
            yield from (replace(goal, body=new) for new in with_a_changed_conclusion(body, change, only))
        case Implies(conclusion=conclusion):
            yield from (
                replace(goal, conclusion=new) for new in with_a_changed_conclusion(conclusion, change, only)
            )
        case Iff(left, right):
            yield from (Iff(new, right) for new in with_a_changed_conclusion(left, change, only))
            yield from (Iff(left, new) for new in with_a_changed_conclusion(right, change, only))
        case Both(parts):
            for place, part in enumerate(parts):
                for new in with_a_changed_conclusion(part, change, only):
                    yield Both((*parts[:place], new, *parts[place + 1 :]))


def _statements(
    statement: Statement, change: Change, only: Callable[[Relation], bool]
) -> Iterator[Statement]:
    match statement:
        case Relation():
            if only(statement):
                yield change(statement)
        case Conjunction(parts):
            for place, part in enumerate(parts):
                for new in _statements(part, change, only):
                    yield Conjunction((*parts[:place], new, *parts[place + 1 :]))
        case Implication(left, right) | Equivalence(left, right):
            yield from (type(statement)(left, new) for new in _statements(right, change, only))


def without_a_premise(goal: Goal) -> Iterator[Goal]:
    match goal:
        case All(body=body) | AllFrom(body=body) | AllBelow(body=body) | Exists(body=body):
            yield from (replace(goal, body=new) for new in without_a_premise(body))
        case Implies(conclusion=conclusion):
            yield conclusion
            yield from (replace(goal, conclusion=new) for new in without_a_premise(conclusion))
        case Both(parts):
            for place, part in enumerate(parts):
                for new in without_a_premise(part):
                    yield Both((*parts[:place], new, *parts[place + 1 :]))


def with_another_member(proof: object) -> Iterator[object]:
    """The proof with one of its witnesses or expressions wrong, for each of them."""
    match proof:
        case ExistsIntroduction(members) | UniqueExists(members):
            for letter, latex in members.items():
                if latex not in ("0", r"\mathbf{0}"):
                    yield replace(proof, members={**members, letter: f"2 ({latex})"})
        case TwoWitnesses(second=second):
            yield replace(proof, first=second)
        case Congruence(expression, uses):
            yield Congruence(f"2 ({expression})", **uses)
        case SumOfSquares(terms):
            yield SumOfSquares(*(f"2 ({term})" for term in terms))
    if not is_dataclass(proof):
        return
    for field in fields(proof):
        value = getattr(proof, field.name)
        if isinstance(value, tuple):
            for place, part in enumerate(value):
                for new in with_another_member(part):
                    changed = (*value[:place], new, *value[place + 1 :])
                    yield (
                        type(proof)(*changed)
                        if field.name == "proofs"
                        else replace(proof, **{field.name: changed})
                    )
        else:
            for new in with_another_member(value):
                yield replace(proof, **{field.name: new})
