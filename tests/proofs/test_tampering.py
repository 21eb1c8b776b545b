"""Each goal of the chapter, and each proof of one, tampered with: none is shown any more. In every place in the
slow suite, else in one of each."""

from collections.abc import Iterable, Iterator
from functools import partial
from random import Random
from typing import TypeVar

import pytest

import proofs
from tests.proofs.tampering import (
    made_false,
    with_a_changed_conclusion,
    with_another_member,
    with_idle_conclusions,
    without_a_premise,
)
from workbench.context.claims import Claim
from workbench.core.verdict import Outcome
from workbench.language.goals.goals import All, AllFrom, Exists, Goal, Scope
from workbench.language.goals.proofs import False_, Kernel, Proven
from workbench.papers.load import find_paper
from workbench.prover.decide.decide import Judge
from workbench.prover.goals.prove_goal import prove
from workbench.runtime import Budget, OutOfBudget, Workers

T = TypeVar("T")

GOALS = [claim for claim in find_paper().claims if claim.proof.goal is not None]


#: Of whole chains: a false step is judged on chains of three free motions, until the time is up.
LONG = {
    "motion_of_last_body",
    "twists_add",
    "relative_twist_is_the_difference",
    "twists_of_two_add",
    "theorem_11",
    "closed_form_3c",
    "closed_form_3c_expanded",
    "closed_form_133",
}

#: Their proofs hold that of Theorem 6 once more.
BEYOND_THEOREM_6 = {"exponential_is_onto", "logarithm_is_a_set"}


def of(claims):
    """Of the claims that rest on one theorem the first; the others, and the long ones, in the slow suite."""
    seen: set[str | None] = LONG | BEYOND_THEOREM_6
    for claim in claims:
        slow = [pytest.mark.slow] if claim.proof.theorem in seen and claim.proof.theorem else []
        seen.add(claim.proof.theorem)
        yield pytest.param(claim, id=claim.id, marks=slow)


SHOWN = list(of(claim for claim in GOALS if claim.expected != Outcome.REFUTED))
REFUTED = list(of(claim for claim in GOALS if claim.expected == Outcome.REFUTED))


#: Of a goal, and of a proof, by default.
PLACES = 1


@pytest.fixture(params=["some", pytest.param("all", marks=pytest.mark.slow)])
def places(request):
    """Of what is changed in one place each: those that are tried."""

    def chosen(claim: Claim, changed: Iterable[T]) -> Iterator[T]:
        changed = list(changed)
        count = len(changed) if request.param == "all" else min(PLACES, len(changed))
        yield from Random(claim.id).sample(changed, count)

    return chosen


def theorem(claim: Claim) -> Proven:
    if claim.proof.theorem is not None:
        return proofs.chapter.theorems[claim.proof.theorem]
    return Proven(None, False_()) if claim.corrected is not None else Proven(Kernel())


def outcome(claim: Claim, goal: Goal, proven: Proven) -> Outcome:
    notation = claim.notation
    scope = Scope(notation.symbols, notation.definitions, {})
    bare = claim.proof.goal.bare if claim.correction.hypothesis else None

    def shown(_: None) -> Outcome:
        return prove(goal, scope, Judge(notation.definitions), proven, claim.supposed, bare).outcome

    if claim.proof.theorem not in LONG:
        return shown(None)
    with Workers(shown, Budget(seconds=10)) as workers:
        (found,) = workers.map([None])
    return Outcome.UNCHECKED if isinstance(found, OutOfBudget) else found


@pytest.mark.parametrize("claim", SHOWN)
def test_a_goal_with_a_conclusion_made_false_is_not_shown(claim, places):
    changed = list(places(claim, with_a_changed_conclusion(claim.proof.goal.goal, made_false)))
    assert changed
    for goal in changed:
        assert outcome(claim, goal, theorem(claim)) in (Outcome.UNCHECKED, Outcome.REFUTED)


#: Goals with a premise that another one says, too, by dividing: a ≠ 0 before n = a₀ · a / ‖a‖.
SAID_TWICE = {"74": 1, "82.rotation": 1}


@pytest.mark.parametrize("claim", SHOWN)
def test_no_premise_of_a_goal_is_idle(claim):
    found = [outcome(claim, goal, theorem(claim)) for goal in without_a_premise(claim.proof.goal.goal)]
    assert sum(one != Outcome.UNCHECKED for one in found) == SAID_TWICE.get(claim.id, 0)


@pytest.mark.parametrize("claim", REFUTED)
def test_a_refutation_does_not_refute_an_idle_goal(claim):
    goal = with_idle_conclusions(claim.proof.goal.goal)
    expected = Outcome.REFUTED if _asks_for_one_only(goal) else Outcome.UNCHECKED
    assert outcome(claim, goal, theorem(claim)) == expected


def _asks_for_one_only(goal: Goal) -> bool:
    while isinstance(goal, All | AllFrom):
        goal = goal.body
    return isinstance(goal, Exists) and goal.unique


@pytest.mark.parametrize("claim", list(of(GOALS)))
def test_a_proof_with_a_wrong_witness_proves_nothing(claim, places):
    shown = partial(outcome, claim, claim.proof.goal.goal)
    for proven in places(claim, with_another_member(theorem(claim))):
        assert shown(proven) == Outcome.UNCHECKED
