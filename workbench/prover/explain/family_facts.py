"""Facts about families: what a text says of q_n, it says of the q_2 and q_{k+1} of a claim."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

from workbench.context.claims import Claim
from workbench.context.facts import Fact, Supposition
from workbench.context.index_values import Orders
from workbench.core.construct import symbol
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import free_integers, instantiate
from workbench.core.terms import Definition, IllFormed, Symbol, Term, sides_of

#: The number of members of which a claim is told.
_MOST = 6


def for_members(claim: Claim) -> Claim:
    """Returns the claim with each fact about a family for the members that the claim holds.

    A fact about members in a range is opaque where the claim goes beyond it.
    """
    definitions = claim.notation.definitions
    reached = dict.fromkeys(definitions.symbols_in(*sides_of(claim.printed.parsed)))
    members = [each for each in reached if len(each.index) == 1]
    facts = tuple(made for fact in claim.context.facts for made in _instances(fact, claim, members))
    return claim if facts == claim.context.facts else claim.with_context(facts=facts)


def _instances(fact: Fact, claim: Claim, members: Sequence[Symbol]) -> Iterator[Fact]:
    said = fact.content
    if said is None or isinstance(said, Supposition):
        yield fact
        return
    if isinstance(said, Definition):
        sides = [symbol(said.declaration, said.index), said.body]
    else:
        sides = [*sides_of(said)]
    names = {name for side in sides for name in free_integers(side)}
    name = names.pop() if len(names) == 1 else ""
    values = sorted(_values(sides, name, members), key=str)[:_MOST] if name else []
    if not values:
        yield fact
        return
    if not all(_is_within(value, name, fact.orders, claim.orders) for value in values):
        yield replace(fact, content=None)
    elif isinstance(said, Definition) or values == [Linear.variable(name)]:
        yield fact
    else:
        for value in values:
            with suppress(IllFormed):
                yield replace(fact, content=instantiate(said, {name: value}))


def _values(sides: Sequence[Term], name: str, members: Sequence[Symbol]) -> set[Linear]:
    """Returns the values of the integer at which the sides hold a member of the claim."""
    variable = Linear.variable(name)
    parts = {part for side in sides for part in side.symbols()}
    shifts = {
        (part.declaration, (part.index[0] - variable).constant)
        for part in parts
        if len(part.index) == 1 and (part.index[0] - variable).is_number
    }
    return {each.index[0] - shift for each in members for own, shift in shifts if own == each.declaration}


def _is_within(value: Linear, name: str, said: Orders | None, claimed: Orders | None) -> bool:
    """True if the value of the integer is one of which the fact is said, for all integers of the claim."""
    if said is None or name in said.generic:
        return True
    if claimed is not None and any(each in claimed.generic for each in value.variables):
        return False
    assigned = claimed.assignments() if claimed is not None else iter([{}])
    return all(said.holds(name, int(value.substitute(values))) for values in assigned)
