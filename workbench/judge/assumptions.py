"""What a claim supposes, at the instant at which it is judged: inequations and equations.

An equation is supposed at the instant only, not for all times: what is proved under the weaker hypothesis
also holds under the stronger one. Of a quantity that vanishes for all times each derivative that occurs is
assumed to vanish, too.
"""

from __future__ import annotations

from collections.abc import Sequence

from workbench.judge.inventory import NotExact
from workbench.language.terms import Conjunction, Relation, Statement


class Unsatisfiable(ValueError):
    """No values of the symbols satisfy the assumptions."""


class Assumptions:
    """The assumptions of one claim, sorted."""

    def __init__(self, statements: Sequence[Statement]) -> None:
        self.relations = [relation for s in statements for relation in _relations(s)]
        self.nonzero = [r for r in self.relations if r.operator == "≠"]
        self.equations = [r for r in self.relations if r.operator == "="]


def _relations(statement: Statement) -> list[Relation]:
    match statement:
        case Relation():
            return [statement]
        case Conjunction():
            return [relation for part in statement.parts for relation in _relations(part)]
    raise NotExact("an assumption is an equation or an inequation (= or ≠)")
