"""Drake's polynomials as another ring of the jet engine, as long as their double coefficients are exact.

Sums and products of integers, and of fractions whose denominator is a power of two, are exact in doubles as
long as they stay below 2⁵³. Otherwise Drake is not used; see `MOST_INDETERMINATES` and `constant`.
"""

from __future__ import annotations

from typing import Any

from workbench.core.terms import Relation
from workbench.drake.gate import Polynomial, Variable
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.inventory import Inventory
from workbench.engines.inventory.parameters import SPHERES, parameters
from workbench.engines.jet.jets import JetEngine
from workbench.engines.jet.rings import PointSource

#: With more indeterminates Drake's polynomials are too slow.
MOST_INDETERMINATES = 15


class DrakeRing:
    """pydrake.symbolic.Polynomial as a ring without division and roots."""

    def __init__(self, inventory: Inventory) -> None:
        names = list(parameters(inventory))
        if len(names) > MOST_INDETERMINATES or any(p.part in SPHERES for p in names):
            raise NotExact(
                "too many indeterminates for Drake's polynomials, or indeterminates with relations"
            )
        self.point = {p: Polynomial(Variable(f"x{i}")) for i, p in enumerate(names)}

    def constant(self, numerator: int, denominator: int) -> Polynomial:
        if denominator & (denominator - 1):
            raise NotExact(f"{numerator}/{denominator} is no double")
        return Polynomial(numerator / denominator)

    def divide(self, a: Any, b: Any) -> Polynomial:
        raise NotExact("Drake's polynomials do not divide")

    def root(self, square: Any) -> Polynomial:
        raise NotExact("Drake's polynomials have no roots")


def recheck_by_drake(relation: Relation, inventory: Inventory, definitions: Lookup) -> bool | None:
    """Returns whether left − right expands to 0 in Drake; None if doubles are not exact or it takes too
    long."""
    try:
        ring = DrakeRing(inventory)
        engine = JetEngine(PointSource(ring, ring.point), definitions)
        differences = engine.differences(relation.left, relation.right)
    except NotExact:
        return None
    zero = Polynomial(0.0)
    return all(zero.EqualTo(d) for d in differences)
