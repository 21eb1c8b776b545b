"""Places in a statement: which subterm stands where, and the statement with another one put there."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeVar

from workbench.language.printing.authors import is_spelt_as_one
from workbench.language.typed.construct import rebuild, relation, zero
from workbench.language.typed.operators import PARTIALS
from workbench.language.typed.terms import (
    Apply,
    Conjunction,
    Equivalence,
    Implication,
    Relation,
    Statement,
    Symbol,
    Term,
    Zero,
)

#: The way from a statement to a subterm: which part or side, then which child, and so on.
Place = tuple[int, ...]

Changed = TypeVar("Changed", Term, Statement)


def sides(statement: Statement) -> Iterator[tuple[Place, Term]]:
    """The sides of all relations. In a chain a = b = c the side b is given once."""
    match statement:
        case Relation():
            yield (0,), statement.left
            yield (1,), statement.right
        case Equivalence() | Implication():
            for number, part in enumerate((statement.left, statement.right)):
                yield from (((number, *place), side) for place, side in sides(part))
        case Conjunction(parts=parts):
            for number, part in enumerate(parts):
                for place, side in sides(part):
                    if not (place == (0,) and number and _goes_on(parts[number - 1], part)):
                        yield (number, *place), side


def places(statement: Statement) -> Iterator[tuple[Place, Term]]:
    """All subterms that can be changed by themselves, with their places, parents first."""
    for place, side in sides(statement):
        yield from _below(place, side)


def _below(place: Place, term: Term) -> Iterator[tuple[Place, Term]]:
    yield place, term
    if is_spelt_as_one(term):
        return
    for number, child in enumerate(term.children):
        if not (number and _is_by_place(term)):
            yield from _below((*place, number), child)


def _is_by_place(term: Term) -> bool:
    """Whether it is ∂/∂x of a field, by the one place x that there is, as ∇ is."""
    is_partial = isinstance(term, Apply) and term.head in PARTIALS and isinstance(term.arguments[1], Symbol)
    return is_partial and term.arguments[1].declaration.coordinate


def subterm(statement: Statement, place: Place) -> Term:
    node: Statement | Term = statement
    for number in place:
        if isinstance(node, Conjunction):
            node = node.parts[number]
        elif isinstance(node, Relation | Equivalence | Implication):
            node = (node.left, node.right)[number]
        else:
            node = node.children[number]
    return node


def find(statement: Statement, place: Place) -> Term | None:
    """The same; None where there is no such place."""
    try:
        return subterm(statement, place)
    except IndexError:
        return None


def replaced(node: Changed, place: Place, new: Term) -> Changed:
    """The statement or term with `new` at the place; all that does not lie above the place stays the same
    object. Raises IllFormed where `new` does not fit."""
    if not place:
        return new
    number, *rest = place
    rest = tuple(rest)
    match node:
        case Relation():
            both = [node.left, node.right]
            both[number] = replaced(both[number], rest, new)
            if isinstance(both[1 - number], Zero):
                both[1 - number] = zero()  # of whatever stands there now
            return relation(node.operator, *both)
        case Equivalence() | Implication():
            both = [node.left, node.right]
            both[number] = replaced(both[number], rest, new)
            return type(node)(*both)
        case Conjunction(parts=parts):
            parts = list(parts)
            shared = rest[0] == 1 and number + 1 < len(parts) and _goes_on(parts[number], parts[number + 1])
            parts[number] = replaced(parts[number], rest, new)
            if shared:
                following = parts[number + 1]
                parts[number + 1] = relation(following.operator, parts[number].right, following.right)
            return Conjunction(tuple(parts))
    children = list(node.children)
    children[number] = replaced(children[number], rest, new)
    return rebuild(node, children)


def _goes_on(before: Statement, part: Statement) -> bool:
    return isinstance(before, Relation) and isinstance(part, Relation) and before.right is part.left
