"""Simpler forms of an equation for all n: without sums, operators applied, definitions expanded."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from workbench.core.construct import relation
from workbench.core.integer_instances import free_integers
from workbench.core.terms import BigSum, Relation, Statement, Term
from workbench.engines.inventory import reached
from workbench.engines.inventory.addend_expansion import spread
from workbench.language.definitions import Definitions, expand
from workbench.prover.decide.families.recurrence_range import InstanceJudge, exceptions, rewritten
from workbench.prover.goals.applied_operators import with_free_values, with_operators_applied
from workbench.prover.goals.definedness import is_defined_everywhere
from workbench.prover.goals.product_normal_form import is_same_sum, tidy
from workbench.prover.goals.symbolic_sums import without_sums


@dataclass(frozen=True)
class Form:
    """An equivalent equation for all integers from `since` on, where its definitions apply."""

    equation: Relation
    since: Mapping[str, int]

    @property
    def is_same_sum(self) -> bool:
        return is_same_sum(self.equation)

    def holds_from(self, least: Mapping[str, int], looked_at: int = 0) -> bool:
        """True if it covers all integers from `least` on, except for so many of one integer, tested one by
        one."""
        looked_at = looked_at if len(least) == 1 else 0
        return all(self.since.get(name, 0) <= value + looked_at for name, value in least.items())


def forms(statement: Statement, judge: InstanceJudge, least: Mapping[str, int]) -> Iterator[Form]:
    """Yields the equation without sums; then with operators applied and definitions expanded, too.

    Yields nothing if something divides: removing a sum could hide that.

    least: the least value of each integer.
    """
    if not isinstance(statement, Relation) or statement.operator != "=":
        return
    definitions = judge.definitions
    whole = relation("=", expand(statement.left, definitions), expand(statement.right, definitions))
    if not all(is_defined_everywhere(side, definitions) for side in (whole.left, whole.right)):
        return
    applied = (with_operators_applied(form, definitions) for form in (statement, whole))
    since = _since(statement, judge)
    for form, begin in ((statement, {}), *((form, since) for form in applied)):
        if begin is None:
            continue
        tidied = tidy(form)
        addends = tidy(relation("=", spread(tidied.left), spread(tidied.right)))
        rest = with_free_values(tidy(without_sums(addends, least)), definitions)
        if rest != statement:
            yield Form(rest, begin)


def _since(equation: Relation, judge: InstanceJudge) -> Mapping[str, int] | None:
    """Returns the integers from which the expansion matches the definitions; None if an addend of a sum is an
    exception."""
    sides = (equation.left, equation.right)
    start = exceptions(judge).start(rewritten(sides, judge.definitions))
    free = frozenset().union(*map(free_integers, sides))
    lowest = _lower_bounds(sides, judge.definitions)
    if any(start[name] > lowest[name] for name in start.keys() & lowest.keys()):
        return None
    return {name: value for name, value in start.items() if name in free}


def _lower_bounds(terms: tuple[Term, ...], definitions: Definitions) -> dict[str, int]:
    """Returns the letters of all sums, recursively, with their least values."""
    lowest: dict[str, int] = {}
    for term in reached(definitions, *terms):
        if isinstance(term, BigSum):
            lower = 0 if term.lower is None or not term.lower.is_number else int(term.lower)
            for name in term.variables:
                lowest[name] = min(lower, lowest.get(name, lower))
    return lowest
