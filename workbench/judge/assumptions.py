"""What a claim supposes, at the instant at which it is judged: inequations and equations.

An equation is supposed at the instant only, not for all times: what is proved under the weaker hypothesis
also holds under the stronger one. Of a quantity that vanishes for all times each derivative that occurs is
assumed to vanish, too.
"""

from __future__ import annotations

from collections.abc import Sequence

from workbench.judge.inventory import NotExact
from workbench.language.terms import Conjunction, Derivative, Relation, Statement, Symbol, Zero


class Unsatisfiable(ValueError):
    """No values of the symbols satisfy the assumptions."""


class Assumptions:
    """The assumptions of one claim, sorted."""

    def __init__(self, statements: Sequence[Statement]) -> None:
        self.relations = [relation for s in statements for relation in _relations(s)]
        self.nonzero = [r for r in self.relations if r.operator == "≠"]
        self.equations = [r for r in self.relations if r.operator == "="]

    @property
    def pinned(self) -> frozenset[tuple[Symbol, int]]:
        """(symbol, order of derivative) that an equation `x = 0` puts to zero: a help for choosing points."""
        pinned = set()
        for relation in self.equations:
            match relation.left:
                case Symbol() if isinstance(relation.right, Zero):
                    pinned.add((relation.left, 0))
                case Derivative(body=Symbol() as x, order=order) if (
                    isinstance(relation.right, Zero) and order.is_number
                ):
                    pinned.add((x, order.constant))
        return frozenset(pinned)


def _relations(statement: Statement) -> list[Relation]:
    match statement:
        case Relation():
            return [statement]
        case Conjunction():
            return [relation for part in statement.parts for relation in _relations(part)]
    raise NotExact("an assumption is an equation or an inequation (= or ≠)")
