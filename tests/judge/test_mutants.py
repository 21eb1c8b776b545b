"""Every claim that is proved, changed in one place: the judge must not prove what is not the same.

A mutant is refused by types or weights, or refuted, or the claim itself in other words (a factor swapped
inside a symmetric product, say); then both engines find that both sides are equal, as they do for the claim.
A residual that is not zero modulo the prime refutes (see `workbench/repair/screen.py`), and where there is
one the search for a small rational counterexample is left out; all other mutants go through the judge.
"""

from __future__ import annotations

from collections import Counter
from random import Random

import pytest

from tests.screens import is_refuted_by
from workbench.core.integer_instances import instantiate
from workbench.core.terms import Conjunction, IllFormed, Relation
from workbench.core.verdict import Outcome
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.assumptions import Unsatisfiable
from workbench.engines.inventory.inventory import take_inventory
from workbench.papers import find_paper
from workbench.prover.decide.decide import Judge
from workbench.prover.results.claim_results import HOLDS
from workbench.repair.screening.screen import Screen
from workbench.repair.terms.subterm_positions import sides
from workbench.repair.terms.term_edits import KINDS, Edit, Refused, edits

SAMPLE = 40
SEED = 53
#: A change can leave what is exact (sin α², 1/det Ṙ); the judge then says so, and nothing counts as passed.
OUTCOMES = ("refuted", "ill-formed", "equal", "unchecked")


@pytest.fixture(scope="module")
def originals():
    """(claim, statement) for each printed form, reading or correction that the paper holds to be right."""
    found = []
    for claim in find_paper().claims:
        formula = claim.corrected or claim.reading or claim.printed
        if (
            claim.proof.theorem is None
            and claim.correction.hypothesis is None
            and formula.statement is not None
        ):
            found.append((claim, formula.statement))
    return found


class Campaign:
    """The judge and the screen for the mutants of one claim."""

    def __init__(self, claim, statement):
        self.claim, self.statement = claim, statement
        self.assume = claim.supposed
        self.judge = Judge(claim.notation.definitions)
        self.assignments = claim.instances
        self.screens = []
        try:
            for values in self.assignments:
                screen = Screen(claim.notation.definitions, self.assume, [values])
                screen.keep(statement)
                self.screens.append(screen)
        except NotExact:
            pass

    def original_holds(self):
        return self.verdict(self.statement).outcome in HOLDS

    def verdict(self, statement):
        return self.judge.judge(statement, assume=self.assume, orders=self.claim.orders)

    def outcome(self, edit):
        """One of OUTCOMES; anything else is a mutant that got away."""
        if isinstance(edit, Refused) or not self.is_defined(edit.statement):
            return "ill-formed"
        if self.refuted_modulo_the_prime(edit.statement):
            return "refuted"
        try:
            verdict = self.verdict(edit.statement)
        except Unsatisfiable:  # a premise that nothing satisfies is refused
            return "ill-formed"
        except ArithmeticError as error:
            return f"{type(error).__name__}: {error}"
        if verdict.outcome in HOLDS or _says_nothing(edit.statement):
            return "equal"
        if verdict.outcome == Outcome.REFUTED:
            return "refuted"
        if verdict.outcome == Outcome.UNCHECKED and verdict.reason:
            return "unchecked"
        return f"{verdict.outcome}: {verdict.reason}"

    def is_defined(self, statement):
        """No index or order lies below the first of its family, for any of the claim's integers."""
        for values in self.assignments:
            try:
                instance = instantiate(statement, values)
                take_inventory([side for _, side in sides(instance)], self.judge.definitions)
            except (IllFormed, NotExact):
                return False
        return True

    def refuted_modulo_the_prime(self, statement):
        return any(is_refuted_by(screen, statement) for screen in self.screens)


def _says_nothing(statement):
    """Both sides have become the same term, so it holds whatever the symbols are."""
    if isinstance(statement, Conjunction):
        return all(map(_says_nothing, statement.parts))
    return isinstance(statement, Relation) and statement.operator == "=" and statement.left == statement.right


def run(pairs):
    """Counts by kind and outcome, and the mutants that got away."""
    counts, escaped, campaigns = Counter(), [], {}
    for claim, statement, edit in pairs:
        if claim.id not in campaigns:
            campaigns[claim.id] = Campaign(claim, statement)
            assert campaigns[claim.id].original_holds(), claim.id
        outcome = campaigns[claim.id].outcome(edit)
        counts[edit.kind, outcome.partition(":")[0]] += 1
        if outcome not in OUTCOMES:
            escaped.append(f"{claim.id}: {edit.description}: {outcome}")
    return counts, escaped


def test_a_sample_of_mutants(originals):
    pool = [(claim, statement, edit) for claim, statement in originals for edit in edits(statement)]
    well_formed = [mutant for mutant in pool if isinstance(mutant[2], Edit)]
    chosen = Random(SEED).sample(well_formed, SAMPLE)
    counts, escaped = run(sorted(chosen, key=lambda mutant: mutant[0].id))
    assert not escaped, "\n".join(escaped)
    refuted = sum(n for (_, outcome), n in counts.items() if outcome == "refuted")
    assert refuted > SAMPLE // 2
    assert sum(n for (_, outcome), n in counts.items() if outcome == "unchecked") <= SAMPLE // 20
    assert sum(counts.values()) == SAMPLE


@pytest.mark.slow
def test_all_mutants(originals, capsys):
    pool = ((claim, statement, edit) for claim, statement in originals for edit in edits(statement))
    counts, escaped = run(pool)
    with capsys.disabled():
        print(f"\n{'mutants':<16}" + "".join(f"{outcome:>12}" for outcome in OUTCOMES))
        for kind in KINDS:
            if any(counts[kind, outcome] for outcome in OUTCOMES):
                print(f"{kind:<16}" + "".join(f"{counts[kind, outcome]:>12}" for outcome in OUTCOMES))
        totals = [sum(counts[kind, outcome] for kind in KINDS) for outcome in OUTCOMES]
        print(f"{'all':<16}" + "".join(f"{total:>12}" for total in totals))
    assert not escaped, "\n".join(escaped)
    assert sum(counts.values()) > 10_000
    assert (
        sum(n for (_, outcome), n in counts.items() if outcome == "unchecked") < sum(counts.values()) // 100
    )


def test_a_refutation_modulo_the_prime_is_one_by_the_judge(originals):
    """The shortcut agrees with the judge's own verdict, counterexample included."""
    compared = 0
    for claim, statement in Random(SEED).sample(originals, 12):
        campaign = Campaign(claim, statement)
        mutants = [e for e in edits(statement) if isinstance(e, Edit)]
        for edit in Random(claim.id).sample(mutants, min(2, len(mutants))):
            if not claim.assume and campaign.refuted_modulo_the_prime(edit.statement):
                verdict = campaign.verdict(edit.statement)
                if verdict.outcome == Outcome.UNCHECKED and "states a law" in (verdict.reason or ""):
                    continue
                assert verdict.outcome == Outcome.REFUTED, (claim.id, edit.description)
                assert verdict.counterexample is not None
                compared += 1
    assert compared >= 8
