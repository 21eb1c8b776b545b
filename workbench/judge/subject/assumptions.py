"""What a claim supposes, at the instant at which it is judged: inequations and equations.

An equation is supposed at the instant only, not for all times: what is proved under the weaker hypothesis
also holds under the stronger one. Of a quantity that vanishes for all times each derivative that occurs is
assumed to vanish, too.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from workbench.judge.subject.inventory import Lookup, NotExact, take_inventory
from workbench.language.typed.construct import derivative
from workbench.language.typed.construct import relation as equated
from workbench.language.typed.terms import Conjunction, Extremum, Naming, Relation, Statement, Term


class Unsatisfiable(ValueError):
    """No values of the symbols satisfy the assumptions."""


class Assumptions:
    """The assumptions of one claim, sorted."""

    def __init__(self, statements: Sequence[Statement]) -> None:
        self.relations = [relation for s in statements for relation in _relations(s)]
        self.nonzero = [r for r in self.relations if r.operator == "≠"]
        self.equations = [r for r in self.relations if r.operator == "="]


def derivatives_of(premise: Statement, claim: Statement, definitions: Lookup) -> tuple[Relation, ...]:
    """The derivatives of the premise's equations, as far as the claim differentiates what they speak of.

    f = 1 says nothing of ḟ at one instant, and ḟ = 0 if it lasts.
    """
    orders = take_inventory(sides_of(claim), definitions).orders
    found = []
    for relation in _relations(premise):
        sides = (relation.left, relation.right)
        if relation.operator == "≠" or relation.left.type.kind == "operator":
            continue
        own = take_inventory(sides, definitions).orders
        more = max((orders.get(symbol, 0) - order for symbol, order in own.items()), default=0)
        found += [equated("=", *(derivative(side, k) for side in sides)) for k in range(1, more + 1)]
    return tuple(found)


def sides_of(statement: Statement) -> Iterator[Term]:
    """The terms of which something is said."""
    match statement:
        case Relation():
            yield from (statement.left, statement.right)
        case Conjunction(parts=parts):
            for part in parts:
                yield from sides_of(part)
        case Extremum():
            yield from (statement.body, statement.value)
        case Naming():
            yield from statement.terms
        case _:
            yield from sides_of(statement.left)
            yield from sides_of(statement.right)


def _relations(statement: Statement) -> list[Relation]:
    match statement:
        case Relation(operator="=" | "≠"):
            return [statement]
        case Conjunction():
            return [relation for part in statement.parts for relation in _relations(part)]
    raise NotExact("an assumption is an equation or an inequation (= or ≠)")
