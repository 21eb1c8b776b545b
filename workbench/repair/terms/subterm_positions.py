"""Positions in a statement: access to and replacement of subterms."""

from __future__ import annotations

from collections.abc import Iterator
from typing import overload

from workbench.core.construct import rebuild, relation, zero
from workbench.core.operations import PARTIALS
from workbench.core.terms import (
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
from workbench.language.printing.author_spelling import is_spelt_as_one

#: The path from a statement to a subterm: the number of the part or side, then of the child, and so on.
Place = tuple[int, ...]


def sides(statement: Statement) -> Iterator[tuple[Place, Term]]:
    """Yields the sides of all relations. In a chain a = b = c the side b is given once."""
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
    """Yields all subterms that can be changed independently, with their positions, parents first."""
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
    """True for ∂/∂x of a field by its only coordinate x, which is equivalent to ∇."""
    if not isinstance(term, Apply) or term.head not in PARTIALS:
        return False
    variable = term.arguments[1]
    return isinstance(variable, Symbol) and variable.declaration.coordinate


def node_at(statement: Statement, place: Place) -> Statement | Term:
    """Returns the statement, part or term at a position. Raises IndexError if there is none."""
    node: Statement | Term = statement
    for number in place:
        match node:
            case Conjunction(parts=parts):
                node = parts[number]
            case Relation() | Equivalence() | Implication():
                node = (node.left, node.right)[number]
            case Term():
                node = node.children[number]
            case _:
                raise IndexError(f"a {type(node).__name__} has no places")
    return node


def subterm(statement: Statement, place: Place) -> Term:
    """Returns the term at a position. Raises IndexError if there is none."""
    node = node_at(statement, place)
    if not isinstance(node, Term):
        raise IndexError(f"a {type(node).__name__} stands at {place}")
    return node


def find(statement: Statement, place: Place) -> Term | None:
    """Returns the term at a position; None if there is none."""
    try:
        return subterm(statement, place)
    except IndexError:
        return None


@overload
def replaced(statement: Relation, place: Place, new: Term) -> Relation: ...
@overload
def replaced(statement: Statement, place: Place, new: Term) -> Statement: ...
def replaced(statement: Statement, place: Place, new: Term) -> Statement:
    """Returns the statement with `new` at the position; objects off the path are shared.

    Raises IllFormed if `new` does not fit.
    """
    number, rest = place[0], place[1:]
    match statement:
        case Relation():
            both = [statement.left, statement.right]
            both[number] = _replaced_in(both[number], rest, new)
            if isinstance(both[1 - number], Zero):
                both[1 - number] = zero()  # typed like the other side now
            return relation(statement.operator, *both)
        case Equivalence() | Implication():
            ways = [statement.left, statement.right]
            ways[number] = replaced(ways[number], rest, new)
            return type(statement)(*ways)
        case Conjunction(parts=before):
            parts = list(before)
            parts[number] = made = replaced(before[number], rest, new)
            if rest[0] == 1 and number + 1 < len(before):
                following = _following(before[number], before[number + 1], made)
                parts[number + 1] = before[number + 1] if following is None else following
            return Conjunction(tuple(parts))
    raise TypeError(f"a {type(statement).__name__} has no places")


def _following(old: Statement, part: Statement, new: Statement) -> Relation | None:
    """Returns the part of a chain that continues an old part, continuing the new one; None for another
    part."""
    if isinstance(new, Relation) and isinstance(part, Relation) and _goes_on(old, part):
        return relation(part.operator, new.right, part.right)
    return None


def _replaced_in(term: Term, place: Place, new: Term) -> Term:
    if not place:
        return new
    children = list(term.children)
    children[place[0]] = _replaced_in(children[place[0]], place[1:], new)
    return rebuild(term, children)


def _goes_on(before: Statement, part: Statement) -> bool:
    return isinstance(before, Relation) and isinstance(part, Relation) and before.right is part.left
