"""Refutations of equations of exponentials: an equation that fails for some E fails for e^x at some point."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import derivative
from workbench.core.terms import Relation, Statement
from workbench.core.verdict import Evidence, Outcome, Verdict
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.exponentials import Exponentials
from workbench.engines.inventory.inventory import take_inventory
from workbench.language.printing.printer import to_latex
from workbench.prover.counterexamples.rational_points import counterexample
from workbench.prover.counterexamples.real_angles import real_trials, surely_differ
from workbench.prover.decide.law_statements import law_for


def refuted_exponential(
    found: Exponentials, assume: Sequence[Statement], definitions: Lookup, laws: bool
) -> Verdict | None:
    """Returns the verdict at a real point where the sides differ; None if none is found.

    assume: the conditions at the point; no point is found unless all have the form a ≠ b.   laws: whether an
    equation that can be solved for a rate states a law, which is not refuted.
    """
    relation = found.relation
    apart = [each for each in assume if isinstance(each, Relation) and each.operator == "≠"]
    if found.varied or len(apart) < len(assume):
        return None
    inventory = take_inventory((relation.left, relation.right), definitions)
    orders = [(exponent, inventory.orders.get(own, 0)) for own, exponent in found.exponents.items()]
    behind = [derivative(exponent, order) if order else exponent for exponent, order in orders]
    sides = [side for each in (relation, *apart) for side in (each.left, each.right)]
    inventory = take_inventory((*sides, *behind), definitions)
    try:
        law = law_for(relation, inventory, definitions) if laws else None
    except NotExact:
        return None
    if law is not None and not any(each in found.exponents for each in law.walk()):
        return Verdict(Outcome.UNCHECKED, reason=VerdictCode.STATES_A_LAW(name=to_latex(law)))
    for trial in real_trials(inventory, definitions, found.exponents):
        with suppress(NotExact):
            if all(surely_differ(trial, each) for each in (relation, *apart)):
                known = {s: order for s, order in inventory.orders.items() if s not in found.exponents}
                example = counterexample(trial, relation, replace(inventory, orders=known), ())
                evidence = Evidence("real balls (Arb)", "the two sides differ")
                shown = replace(example, defined={}, behind=())
                return Verdict(Outcome.REFUTED, counterexample=shown, evidence=(evidence,))
    return None
