"""Consequences of premises beyond the ideal that they span.

    x = t ⇒ P(x)    is equivalent to    P(t)

for an x that does not occur in t and is not differentiated: x = t may be a definition of x. Also, equal
angles have equal sines and cosines.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from workbench.core.construct import apply, number, power, relation, symbol
from workbench.core.names import Name
from workbench.core.terms import Apply, Derivative, Relation, Statement, Symbol, Term, TimeOperator
from workbench.core.types import SCALAR, VECTOR, Declaration
from workbench.engines.inventory import Lookup, WithDefinitions, reached
from workbench.engines.inventory.assumptions import Assumptions
from workbench.engines.inventory.divisions import never_divides
from workbench.engines.inventory.inventory import take_inventory


def with_premise_as_definition(
    claim: Relation, assume: Sequence[Statement], definitions: Lookup, bound: Collection[Name]
) -> tuple[Relation, list[Relation], Lookup] | None:
    """Returns the claim with the first premise x = t that can define x, the other premises, and the
    definitions.

    bound: the names of symbols that are not free.
    """
    premises = Assumptions(assume).relations
    for place, premise in enumerate(premises):
        others = [*premises[:place], *premises[place + 1 :]]
        for own, value in _said(premise):
            if premise.operator != "=" or not isinstance(own, Symbol) or not _is_any(own, bound):
                continue
            if own.type != value.type or not _is_total(value, definitions):
                continue
            if own.declaration.constant and not is_constant(value, definitions):
                continue
            sides = [side for r in (claim, *others) for side in (r.left, r.right)]
            orders = take_inventory(sides, definitions).orders  # orders of the free symbols
            if orders.get(own) == 0 and own not in take_inventory([value], definitions).orders:
                return premise, others, WithDefinitions(definitions, {own: value})
    return None


def equal_sines_and_cosines(
    claim: Relation, assume: Sequence[Statement], definitions: Lookup
) -> list[Relation]:
    """Returns the equal sines and cosines of both sides of premises that equate angles of the claim."""
    premises = [premise for premise in Assumptions(assume).equations if premise.left.type == SCALAR]
    angles = set(take_inventory((claim.left, claim.right), definitions).angles)
    found = []
    for premise in premises:
        own = take_inventory((premise.left, premise.right), definitions)
        if angles.intersection(own.orders) and not own.angles:
            found += [
                relation("=", *(apply(head, side) for side in (premise.left, premise.right)))
                for head in ("sin", "cos")
            ]
    return found


def _said(premise: Relation) -> Iterator[tuple[Term, Term]]:
    """Yields pairs of a possible symbol and its value; a vector of length 1 is given as a unit vector."""
    sides = premise.left, premise.right
    yield from (sides, sides[::-1])
    for part in dict.fromkeys((*premise.left.walk(), *premise.right.walk())):
        if isinstance(part, Symbol) and part.type == VECTOR and number(1) in sides:
            length, squared = apply("norm", part), apply("mul", apply("transpose", part), part)
            lengths = (length, power(length, 2), power(part, 2), apply("dot", part, part), squared)
            if any(each in sides for each in lengths):
                yield part, symbol(part.declaration.with_flags(unit=True), part.index)


def _is_any(term: Term, bound: Collection[Name]) -> bool:
    """True for a symbol without further properties, perhaps constant."""
    if not isinstance(term, Symbol):
        return False
    said = term.declaration
    plain = Declaration(said.name, said.type, said.weight)
    return said in (plain, plain.with_flags(constant=True)) and said.name not in bound


def is_constant(value: Term, definitions: Lookup) -> bool:
    """True if all undefined symbols of the value are constant."""
    free = (part for part in reached(value, definitions) if isinstance(part, Symbol))
    return all(part.declaration.constant or definitions.lookup(part) is not None for part in free)


def _is_total(value: Term, definitions: Lookup) -> bool:
    """True if the value is defined for all values of its symbols. Only the derivatives of a norm may be
    undefined."""
    parts = list(reached(value, definitions))
    is_still = not any(isinstance(part, Derivative | TimeOperator) for part in parts)
    return all(never_divides(p) or (is_still and isinstance(p, Apply) and p.head == "norm") for p in parts)
