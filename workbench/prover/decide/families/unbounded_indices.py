"""Indices without a stated range, and sums up to an arbitrary n."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from workbench.core.integer_instances import free_integers
from workbench.core.terms import BigSum, Conjunction, Definition, IllFormed, Relation, Statement, Term
from workbench.core.verdict import Evidence, Outcome, Verdict
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.addend_expansion import addend_by_addend, has_sums
from workbench.language.definitions import Definitions, expand
from workbench.prover.decide.families.orders_past_literals import OrderRanges, integer_past_literals
from workbench.prover.decide.families.recurrence_range import InstanceJudge
from workbench.prover.decide.inference import generalization


@dataclass(frozen=True)
class Distinct:
    """Index values for refutations: all indices are distinct.

    lasts: the upper bounds of sums that are otherwise arbitrary.
    """

    orders: OrderRanges
    lasts: Mapping[str, int]
    generic: tuple[str, ...] = ()
    endless: frozenset[str] = frozenset()

    def assignments(self) -> Iterator[dict[str, int]]:
        indices = [name for name in self.orders.generic if name not in self.lasts]
        first = next(self.orders.assignments())
        for values in self.orders.assignments():
            is_first = all(values[name] == first[name] for name in self.lasts)
            if is_first and len({values[name] for name in indices}) == len(indices):
                yield {**values, **self.lasts}


def ranges_apart(
    orders: OrderRanges, statement: Statement, terms: Sequence[Term], definitions: Definitions
) -> list[Distinct]:
    """Returns ranges that must all refute: with sums of two addends, and up to sums past all literals of the
    formula.

    The text may state the number of addends elsewhere. Returns [] if the sums would be too long, and for M c
    = Σ m_i x_i or Σ a_i = 0, which may be definitions.
    """
    sums = [part for term in terms for part in term.walk() if isinstance(part, BigSum)]
    lasts = [name for name in orders.generic if any(name in each.upper.variables for each in sums)]
    if not lasts:
        return [Distinct(orders, {})]
    longest = integer_past_literals(terms, definitions)
    if longest is None or not (isinstance(statement, Relation) and all(map(has_sums, terms))):
        return []
    lengths = range(2, max(longest, len(orders.generic) + 2) + 1)
    return [Distinct(orders, dict.fromkeys(lasts, length)) for length in lengths]


def _for_each(statement: Relation, definitions: Definitions) -> Relation | None:
    """Returns the equation of free members, if all definitions are uniform in the index; else None."""
    members = {each for each in definitions.symbols_in(statement.left, statement.right) if each.index}
    known = {each for member in members for each in definitions.about(member)}
    if any(member.declaration.apart for member in members) or not all(map(_is_for_each, known)):
        return None
    return replace(
        statement, left=expand(statement.left, definitions), right=expand(statement.right, definitions)
    )


def _is_for_each(definition: Definition) -> bool:
    places = definition.index
    return bool(places) and all(not place.is_number and place.constant == 0 for place in places)


def judge_addends(judge: InstanceJudge, statement: Statement) -> Verdict | None:
    """Returns `proved` for an equation of sums that holds addend by addend for a free one; None for other
    statements."""
    if not isinstance(statement, Relation) or statement.operator != "=":
        return None
    try:
        free = _for_each(statement, judge.definitions)
        said = None if free is None else addend_by_addend(free)
        verdict = None if said is None else judge.judge_instance(Conjunction(tuple(said)), (), None)
    except (NotExact, IllFormed):
        return None
    if verdict is None or verdict.outcome != Outcome.PROVED:
        return None
    names = sorted(free_integers(statement.left) | free_integers(statement.right))
    evidence = (*verdict.evidence, Evidence("all n at once", "addend by addend, each a free function"))
    return generalization(verdict, f"all {', '.join(names)}", evidence)
