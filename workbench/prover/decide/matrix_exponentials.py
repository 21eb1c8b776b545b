"""Decides equations of exponentials of matrices that have no formula: by their laws, and at real points."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.terms import Relation, Statement, Symbol
from workbench.core.verdict import Evidence, Outcome, Verdict
from workbench.engines.inventory import Lookup, reached
from workbench.engines.inventory.elementary_functions import without_functions
from workbench.engines.inventory.exponentials_of_matrices import without_matrix_exponentials
from workbench.prover.decide.elementary_equations import difference, refuted_at_real_point


def judge_matrix_exponentials(
    said: Relation,
    assume: Sequence[Statement],
    setting: tuple[Lookup, bool],
    judge: Callable[[Statement, tuple[Statement, ...]], Verdict],
) -> Verdict:
    """Returns the verdict.

    setting: the definitions, and whether an equation that can be solved for a rate states a law. R = exp A
    may say what R is, and is not refuted. Raises NotExact where no exponential is replaced.
    """
    definitions, laws = setting
    found = without_matrix_exponentials(said, definitions)
    sides = said.left, said.right
    names_it = any(
        isinstance(side, Symbol)
        and definitions.lookup(side) is None
        and side not in reached(definitions, other)
        for side, other in (sides, sides[::-1])
    )
    if not (names_it and laws):
        free = without_functions(found.free, definitions)
        free = replace(free, values={**free.values, **found.values})
        refuted = refuted_at_real_point(free, assume, definitions, laws)
        if refuted is not None:
            return refuted
    relation = found.relation
    if relation.left == relation.right and said.left != said.right:
        relation = difference(relation)
    verdict = judge(relation, (*assume, *found.supposed))
    if verdict.outcome not in (Outcome.PROVED, Outcome.CONDITIONAL):
        return Verdict(Outcome.UNCHECKED, reason=VerdictCode.NOT_FROM_FUNCTIONS())
    evidence = Evidence("exponentials of matrices", "any polynomials of the exponents with their rates")
    return replace(verdict, evidence=(*verdict.evidence, evidence))
