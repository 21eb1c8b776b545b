"""Derivatives of premises that last, as far as they constrain a claim: x = X + r gives ẍ = Ẍ + r̈.

a = ẍ and A = Ẍ need the second derivative of x = X + r, although the claim a = A + r̈ has no rate of x. The
derivatives are counted first, by the orders of their symbols, and then made: laws such as ẋ = y and ẏ = −x
have no last one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

from workbench.core.construct import derivative, relation
from workbench.core.terms import Apply, Derivative, Relation, Statement, Symbol, Term, sides_of
from workbench.engines.inventory import Lookup, NotExact, reached
from workbench.engines.inventory.assumptions import each_side, relations_of, slopes_of, takes_rate
from workbench.engines.inventory.inventory import take_inventory

#: What constrains the rate of a symbol.
_BOUND_BY = frozenset({"constant", "clock", "unit", "rotation", "transform", "symmetric", "diagonal"})

_Orders = Mapping[Symbol, int]


@dataclass(frozen=True)
class _Base:
    """An equation that is differentiated.

    Attributes:
        orders: Of the rates of its symbols that move.
        alone: Those of these symbols whose highest rate is an addend, so that the equation says what it is.
        least: The order of the first derivative that is not among the premises: 0 for a slope.
    """

    equation: Relation
    orders: _Orders
    alone: tuple[Symbol, ...]
    least: int

    def times(self, order: int) -> Relation:
        return each_side(self.equation, partial(derivative, order=order)) if order else self.equation

    def says_only(self, order: int, others: Iterable[tuple[_Orders, int]]) -> bool:
        """Whether its derivative of this order only says what a rate is that no other equation has."""
        known = [(orders, more) for orders, more in others if orders is not self.orders or more != order]
        return any(
            all(own not in orders or orders[own] + more < self.orders[own] + order for orders, more in known)
            for own in self.alone
        )


def prolonged(premises: Sequence[Statement], claim: Statement, definitions: Lookup) -> list[Relation]:
    """Returns the derivatives of the premises that constrain the rates in the claim or in other premises.

    Premises that are derivatives of others are not differentiated again. Raises NotExact, IllFormed.
    """
    equations = [each for premise in premises for each in relations_of(premise) if each.operator == "="]
    own = {each for each in equations if each.left.type.kind != "operator"}
    first = [each for each in dict.fromkeys(equations) if each in own and _antiderivative(each) not in own]
    others = [each for premise in premises for each in relations_of(premise) if each not in own]
    known = (claim, *first, *others)
    said = [_orders(sides_of(each), definitions) for each in known]
    sides = [side for each in known for side in sides_of(each)]
    bases = [base for each in first for base in _bases(each, sides, definitions)]
    kept = _constraining(bases, _counts(bases, said), [(orders, 0) for orders in said])
    return [made for base, order in kept if (made := base.times(order)) not in own]


def _antiderivative(equation: Relation) -> Relation | None:
    """Returns the equation of which this one is a derivative, as it is written; None if it is none."""
    match equation:
        case Relation(left=Derivative() as left, right=Derivative() as right) if left.order == right.order:
            return relation("=", left.body, right.body) if left.body.type == right.body.type else None
    return None


def _bases(equation: Relation, sides: Sequence[Term], definitions: Lookup) -> Iterator[_Base]:
    own = (equation.left, equation.right)
    orders = _orders(own, definitions)
    if not any(symbol.declaration.of for symbol in orders):
        yield _Base(equation, orders, tuple(_alone(own, orders, definitions)), 1)
        return
    yield _Base(equation, orders, (), 1)
    for slope in slopes_of(equation, sides, definitions):
        yield _Base(slope, _orders((slope.left, slope.right), definitions), (), 0)


def _orders(terms: Iterable[Term], definitions: Lookup) -> _Orders:
    known = list(terms)
    try:
        orders = take_inventory(known, definitions, slopes=False).orders
    except NotExact:  # as for inverse functions
        parts = list(reached(definitions, *known))
        if any(map(takes_rate, parts)):
            raise
        orders = dict.fromkeys((each for each in parts if isinstance(each, Symbol)), 0)
    return {own: k for own, k in orders.items() if not (own.declaration.constant or own.declaration.clock)}


def _alone(sides: Sequence[Term], orders: _Orders, definitions: Lookup) -> Iterator[Symbol]:
    """Yields the symbols whose highest rate is an addend and in no other one, as r in ṙ = v + ω × r."""
    addends = [each for side in sides for each in _addends(side, 0)]
    within = [_orders([derivative(term, k) if k else term], definitions) for term, k in addends]
    for place, (term, order) in enumerate(addends):
        if not isinstance(term, Symbol) or term not in orders or term.declaration.flags & _BOUND_BY:
            continue
        others = (*within[:place], *within[place + 1 :])
        if all(other.get(term, -1) < order for other in others):
            yield term


def _addends(term: Term, order: int) -> Iterator[tuple[Term, int]]:
    """Yields the addends that are no sums, each with the order of the derivative that is taken of it."""
    match term:
        case Derivative() if term.order.is_number:
            yield from _addends(term.body, order + int(term.order))
        case Apply(head="add" | "neg"):
            for each in term.arguments:
                yield from _addends(each, order)
        case _:
            yield term, order


def _counts(bases: Sequence[_Base], said: Sequence[_Orders]) -> list[int]:
    """Returns how often each equation is differentiated for the rates that the claim or equations have.

    An equation in which no rate is alone, as q · q = 1, follows the others, since laws of q would follow it.
    """
    counts = [0] * len(bases)
    leading = [place for place, base in enumerate(bases) if base.alone]
    led = [place for place, base in enumerate(bases) if not base.alone]
    written = _highest((orders, 0) for orders in said)

    def counted(places: Sequence[int]) -> list[int]:
        known = ((base.orders, count) for base, count in zip(bases, counts, strict=True))
        highest = _highest([(written, 0), *known])
        again = list(counts)
        for place in places:
            base = bases[place]
            more = (highest[symbol] - base.orders[symbol] for symbol in base.alone or base.orders)
            again[place] = max(more, default=0)
        return again

    for places in (*[leading] * len(leading), led, *[leading] * len(leading)):
        counts = counted(places)
    return counts


def _highest(known: Iterable[tuple[_Orders, int]]) -> dict[Symbol, int]:
    found: dict[Symbol, int] = {}
    for orders, more in known:
        for symbol, order in orders.items():
            found[symbol] = max(found.get(symbol, 0), order + more)
    return found


def _constraining(
    bases: Sequence[_Base], counts: Sequence[int], said: Sequence[tuple[_Orders, int]]
) -> list[tuple[_Base, int]]:
    """Returns the derivatives without those that only say what a rate is that no other equation has."""
    kept = [(base, k) for base, n in zip(bases, counts, strict=True) for k in range(base.least, n + 1)]
    while True:
        known = [*said, *((base.orders, order) for base, order in kept)]
        shared = [(base, order) for base, order in kept if not base.says_only(order, known)]
        if len(shared) == len(kept):
            return kept
        kept = shared
