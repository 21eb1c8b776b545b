"""Goals that are false, or true under a hypothesis only: counterexamples, and what does not refute."""

import pytest

from tests.judge.goals.test_goals import outcome, scope
from workbench.core.verdict import Outcome
from workbench.language.goals.goal_reader import read_goal
from workbench.language.goals.proofs import (
    At,
    Broken,
    Congruence,
    False_,
    IffIntroduction,
    Instance,
    Introductions,
    Kernel,
    Proven,
)
from workbench.prover.decide.decide import Judge
from workbench.prover.goals.prove_goal import prove


@pytest.mark.parametrize(
    ("goal", "bare", "against", "found"),
    [
        (r"a = b \Rightarrow b = a", "b = a", False_(), Outcome.CONDITIONAL),
        (r"a = b \Rightarrow b = 2 a", "b = 2 a", False_(), Outcome.UNCHECKED),
        (r"a = b \Rightarrow 2 b = a + b", "2 b = b + b", False_(), Outcome.UNCHECKED),
        (r"a = b \Rightarrow b = a", "b = a", None, Outcome.UNCHECKED),
    ],
)
def test_a_hypothesis_suffices_and_is_needed(goal, bare, against, found):
    where = scope()
    goals = [read_goal(text, where) for text in (goal, bare)]
    proven = Proven(Kernel(), against)
    assert prove(goals[0], where, Judge(where.definitions), proven, bare=goals[1]).outcome == found


def test_a_conditional_goal_holds_for_its_integers():
    where = scope()
    goal, bare = (
        read_goal(rf"\forall n \geq 2 : {text}", where)
        for text in (r"a = b \Rightarrow F_n a = F_n b", "F_n a = F_n b")
    )
    proven = Proven(Introductions(Congruence("F_n Y", Y=Instance(0))), At({"n": "2"}, False_()))
    found = prove(goal, where, Judge(where.definitions), proven, bare=bare)
    assert (found.outcome, found.scope) == (Outcome.CONDITIONAL, "all n ≥ 2")


def test_steps_to_the_same_term_are_in_the_evidence():
    back = Congruence("Y", Y=Instance(0, back=True))
    found = outcome(r"a = b \Leftrightarrow b = a", IffIntroduction(back, back))
    told = {each.method: each.outcome for each in found.evidence}
    same = "both sides are the same term"
    assert (told["goal, left side"], told["goal, right side"]) == (same, same)


def test_a_conditional_goal_has_the_evidence_of_both_forms():
    where = scope()
    goal, bare = (read_goal(text, where) for text in (r"a = b \Rightarrow b = a", "b = a"))
    found, shown, without = (
        prove(each, where, Judge(where.definitions), proven, bare=more)
        for each, proven, more in (
            (goal, Proven(Kernel(), False_()), bare),
            (goal, Proven(Kernel()), None),
            (bare, Proven(None, False_()), None),
        )
    )
    assert (shown.outcome, without.outcome) == (Outcome.PROVED, Outcome.REFUTED)
    assert found.evidence == (*shown.evidence, *without.evidence)
    assert shown.evidence and without.evidence and without.counterexample
    assert found.counterexample == without.counterexample


def test_a_claim_is_not_refuted_without_what_it_supposes():
    where = scope()
    goal, assume = read_goal("b = a", where), [where.statement("a = b")]

    def found(using):
        proven = Proven(Kernel(using))
        return prove(goal, where, Judge(where.definitions), proven, assume=assume).outcome

    assert (found(None), found(())) == (Outcome.PROVED, Outcome.UNCHECKED)


def test_a_counterexample_satisfies_the_premises():
    where = scope()
    goal, assume = read_goal("b = a", where), [where.statement("a = b")]
    judge = Judge(where.definitions)
    against = Proven(against=False_())
    assert prove(goal, where, judge, against, assume).outcome == Outcome.UNCHECKED
    assert prove(goal, where, judge, against).outcome == Outcome.REFUTED
    narrower = read_goal(r"a = 2 b \Rightarrow b = a", where)
    both = Proven(Kernel(), False_())
    assert prove(narrower, where, judge, both, assume, bare=goal).outcome == Outcome.UNCHECKED


def test_a_premise_at_an_instant_does_not_hold_at_all_times():
    where = scope()
    goal = read_goal(r"a = b \Longrightarrow \dot{a} = \dot{b}", where)
    proven = Proven(against=Broken(False_(), Congruence("Y", Y=Instance(0))))
    assume = [where.statement("a = b")]
    assert prove(goal, where, Judge(where.definitions), proven, assume).outcome == Outcome.UNCHECKED
