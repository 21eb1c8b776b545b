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
    Impossible,
    Instance,
    Introductions,
    Kernel,
    Part,
    Proven,
    SumOfSquares,
    TwoWitnesses,
)
from workbench.prover.decide.decide import Judge
from workbench.prover.goals.prove_goal import prove


@pytest.mark.parametrize(
    ("goal", "against"),
    [
        (r"\forall c, d \in V_3 : c \times d = d \times c", False_()),
        (r"\exists! X \in L(V_3, V_3) : 0 T = X - X", TwoWitnesses({"X": "T"}, {"X": "2 T"})),
        (
            r"\forall f \in V_3 \to V_3 : f(2 a) = 2 f(a) \Rightarrow f(a) = a",
            At({"f": "2 X"}, Broken(False_())),
        ),
        (r"\exists c \in V_3 : c = a \wedge c = b", Impossible(Congruence("Y - Z + b", Y=Instance(-1, back=True), Z=Instance(-1, part=1, back=True)), so="a = b")),
        (r"\forall n \geq 1 : F_n = F_{n+1}", At({"n": "1"}, False_())),
        (r"a \cdot b = 0 \Leftrightarrow a = \mathbf{0}", Part(0, False_())),
    ],
)  # fmt: skip
def test_refutations(goal, against):
    found = outcome(goal, against=against)
    assert found.outcome == Outcome.REFUTED, found.reason
    assert outcome(goal).outcome != Outcome.PROVED


@pytest.mark.parametrize(
    ("goal", "against"),
    [
        (r"\forall c \in V_3 : c \times c = \mathbf{0}", False_()),
        (r"\exists! c \in V_3 : c = a", TwoWitnesses({"c": "a"}, {"c": "a + 0 b"})),
        (r"\exists! c \in V_3 : c = a", TwoWitnesses({"c": "a"}, {"c": "b"})),
        (r"\forall n \geq 2 : F_n = F_{n+1}", At({"n": "1"}, False_())),
        (r"a = b \Rightarrow b = a", Broken(False_())),
        # true under a premise that the judge of formulas cannot suppose
        (r"\Big( \forall c \in V_3 : c \cdot a = c \cdot b \Big) \Rightarrow a = b", False_()),
        (r"\Big( 2 a = a + a \Rightarrow a = b \Big) \Rightarrow a = b", False_()),
        (r"\Big( \exists c \in V_3 : c = a \wedge c = b \Big) \Rightarrow a = b", False_()),
        (r"\Big( a \cdot b \geqslant a^2 + b^2 \Big) \Rightarrow a = b", False_()),
        # two are no reason against one; what is not shown, or holds, is no reason against any
        (r"\exists c \in V_3 : c \times c = \mathbf{0}", TwoWitnesses({"c": "a"}, {"c": "b"})),
        (r"\exists c \in V_3 : c = a", Impossible(Kernel())),
        (r"\exists c \in V_3 : c = a", Impossible(Kernel(), so="a = b")),
        (r"\exists c \in V_3 : c = a", Impossible(Kernel(), so="2 a = a + a")),
        # no members of the set, and values that nothing binds
        (r"\forall Q \in SO_3 : \det Q = 1", At({"Q": r"2 \mathbf{I}"}, False_())),
        (r"\forall u \in S^2 : u^2 = 1", At({"u": "a"}, False_())),
        (r"\forall n \geq 1 : F_n = F_{n+1}", At({"n": "1", "m": "1"}, False_())),
        # the other way
        (r"a \cdot b = 0 \Leftrightarrow a = \mathbf{0}", Part(1, False_())),
    ],
)
def test_invalid_refutations_are_unchecked(goal, against):
    assert outcome(goal, against=against).outcome == Outcome.UNCHECKED


@pytest.mark.parametrize(
    ("goal", "found"),
    [
        (r"\forall c \in V_3 : 2 c = c + c = c", Outcome.REFUTED),
        (r"a + b = b + a \wedge a \times b = b \times a", Outcome.UNCHECKED),
        (r"\Big( \forall c \in V_3 : c \cdot a = c \cdot b \Big) \Rightarrow a = b", Outcome.UNCHECKED),
    ],
)
def test_only_universal_equations_of_a_goal_are_refuted(goal, found):
    assert outcome(goal, Kernel()).outcome == found


@pytest.mark.parametrize(
    ("squares", "found"),
    [("cd", Outcome.PROVED), ("dc", Outcome.PROVED), ("c", Outcome.UNCHECKED), ("cdd", Outcome.UNCHECKED)],
)
def test_all_squares_are_added(squares, found):
    goal = r"\forall c, d \in \mathbb{R} : c^2 + d^2 \geqslant 0"
    assert outcome(goal, SumOfSquares(*squares)).outcome == found


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
