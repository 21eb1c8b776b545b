"""Positions in which a side of an equation is linear: its addends, also those inside brackets."""

from __future__ import annotations

from collections.abc import Iterator

from workbench.core.construct import rebuild
from workbench.core.operations import LINEAR
from workbench.core.terms import Apply, Derivative, Term
from workbench.repair.terms.subterm_positions import Place


def addend_places(side: Term) -> Iterator[tuple[Place, ...]]:
    """Yields sets of addend positions in which the side is jointly linear; one set for each factor that is a
    sum."""
    yield from _choices(side, ())


def _choices(term: Term, place: Place) -> Iterator[tuple[Place, ...]]:
    if not has_sum(term):
        yield (place,)
    elif isinstance(term, Apply) and term.head == "add":
        chosen: list[tuple[Place, ...]] = [()]
        for number, addend in enumerate(term.arguments):
            ways = list(_choices(addend, (*place, number)))[:2]
            chosen = [(*before, *way) for before in chosen for way in ways][:4]
        yield from chosen
    elif isinstance(term, Apply) and term.head == "div":
        yield from _choices(term.arguments[0], (*place, 0))
    elif isinstance(term, Derivative):
        yield from _choices(term.body, (*place, 0))
    else:
        for number, argument in enumerate(term.children):
            if has_sum(argument):
                yield from _choices(argument, (*place, number))


def has_sum(term: Term) -> bool:
    """True if the term contains a sum in which it is linear."""
    match term:
        case Apply(head="add"):
            return True
        case Apply(head="div", arguments=(numerator, _)):
            return has_sum(numerator)
        case Derivative(body=body):
            return has_sum(body)
        case Apply(head=head, arguments=arguments) if head in LINEAR:
            return any(map(has_sum, arguments))
    return False


def alone(side: Term, place: Place) -> Term:
    """Returns the side with each sum on the path reduced to the addend that contains the position."""
    if not place:
        return side
    number, *rest = place
    if isinstance(side, Apply) and side.head == "add":
        return alone(side.arguments[number], tuple(rest))
    children = list(side.children)
    children[number] = alone(children[number], tuple(rest))
    return rebuild(side, children)
