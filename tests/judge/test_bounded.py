r"""\forall k < n, and induction from all that is below: proofs of true goals, and of false ones of their form."""

import pytest

from tests.judge.goals.test_goals import outcome, scope
from workbench.core.integer_expressions import Linear
from workbench.core.verdict import Outcome
from workbench.language.goals.goal_reader import read_goal
from workbench.language.goals.goals import AllBelow, GoalError
from workbench.language.goals.proofs import (
    At,
    Congruence,
    Cut,
    False_,
    Induction,
    Instance,
    Introductions,
    Kernel,
    SumCongruence,
)


def below(bound: str) -> str:
    return rf"\Big( \forall k < {bound} : a^{{(k)}} = b^{{(k)}} \Big)"


def used(**at: str) -> Congruence:
    return Congruence("Y", Y=Instance(-1, at))


LEMMA = rf"\forall m \geq 0 : {below('m+1')} \Rightarrow a^{{(m)}} = b^{{(m)}}"
BY_LEMMA = Cut(LEMMA, Introductions(used(k="m")), Introductions(Congruence("Y", Y=Instance(0, {"m": "n"}))))
ALL_ORDERS = r"\forall n \geq 0 : a^{(n)} = b^{(n)}"
DERIVED = Induction(
    Congruence("Y", Y=Instance(0)),
    Introductions(Congruence(r"\dot{Y}", Y=Instance(-1, {"i": "n"}))),
    letter="i",
)
SUMS = r"\sum_{{l=0}}^{{{0}}} a^{{(l)}} = \sum_{{l=0}}^{{{0}}} b^{{(l)}}"


@pytest.mark.parametrize(
    ("true", "false", "proof"),
    [
        (  # at n = 0 there is no k
            rf"\forall n \geq 1 : {below('n')} \Rightarrow a = b",
            rf"\forall n \geq 0 : {below('n')} \Rightarrow a = b",
            Introductions(used(k="0")),
        ),
        (
            rf"\forall n \geq 0 : {below('n+1')} \Rightarrow a^{{(n)}} = b^{{(n)}}",
            rf"\forall n \geq 0 : {below('n')} \Rightarrow a^{{(n)}} = b^{{(n)}}",
            Introductions(used(k="n")),
        ),
        (  # for more k than are asked for, and for fewer
            rf"\forall n \geq 0 : {below('n+2')} \Rightarrow a^{{(n)}} = b^{{(n)}}",
            rf"\forall n \geq 0 : {below('n')} \Rightarrow a^{{(n)}} = b^{{(n)}}",
            BY_LEMMA,
        ),
        (  # of the same members
            rf"\forall n \geq 0 : {below('n+2')} \Rightarrow a^{{(n)}} = b^{{(n)}}",
            r"\forall n \geq 0 : \Big( \forall k < n+2 : k a^{(k)} = k b^{(k)} \Big) \Rightarrow a^{(n)} = b^{(n)}",
            BY_LEMMA,
        ),
        (  # another n
            rf"\forall n \geq 0 : \forall j \geq 0 : {below('n+j+1')} \Rightarrow a^{{(n)}} = b^{{(n)}}",
            rf"\forall n \geq 0 : \forall j \geq 0 : {below('j+1')} \Rightarrow a^{{(n)}} = b^{{(n)}}",
            BY_LEMMA,
        ),
        (  # at one instant
            rf"\forall n \geq 1 : {below('n')} \Longrightarrow a^{{(n)}} = b^{{(n)}}",
            rf"\forall n \geq 1 : {below('n')} \Rightarrow a^{{(n)}} = b^{{(n)}}",
            Introductions(Congruence(r"\dot{Y}", Y=Instance(-1, {"k": "n-1"}))),
        ),
        (rf"a = b \Longrightarrow {ALL_ORDERS}", rf"a = b \Rightarrow {ALL_ORDERS}", DERIVED),
        (rf"a = b \Longrightarrow {ALL_ORDERS}", rf"a^2 = b^2 \Longrightarrow {ALL_ORDERS}", DERIVED),
        (
            rf"\forall n \geq 1 : {below('n')} \Rightarrow {SUMS.format('n-1')}",
            rf"\forall n \geq 1 : {below('n')} \Rightarrow {SUMS.format('n')}",
            Introductions(SumCongruence("l", Introductions(used(k="l")))),
        ),
        (  # what is left of n at each addend
            rf"\forall n \geq 1 : {below('n')} \Rightarrow \sum_{{l=1}}^{{n}} a^{{(n-l)}} = \sum_{{l=1}}^{{n}} b^{{(n-l)}}",
            rf"\forall n \geq 1 : {below('n')} \Rightarrow \sum_{{l=0}}^{{n}} a^{{(n-l)}} = \sum_{{l=0}}^{{n}} b^{{(n-l)}}",
            Introductions(SumCongruence("l", Introductions(used(k="j")))),
        ),
        (  # a premise about n is none about the letter of the sum
            r"\forall n \geq 0 : a^{(n)} = b^{(n)} \Rightarrow"
            r" \sum_{l=0}^{n} C_n^l a^{(n)} = \sum_{l=0}^{n} C_n^l b^{(n)}",
            r"\forall n \geq 0 : a^{(n)} = b^{(n)} \Rightarrow"
            r" \sum_{l=0}^{n} C_n^l a^{(l)} = \sum_{l=0}^{n} C_n^l b^{(l)}",
            Introductions(SumCongruence("l", Introductions(Congruence("C_{l+j}^l Y", Y=Instance(-1))))),
        ),
    ],
)
def test_below_a_bound(true, false, proof):
    shown = outcome(true, proof)
    assert shown.outcome == Outcome.PROVED, shown.reason
    assert outcome(false, proof).outcome == Outcome.UNCHECKED


def step(**at: str) -> Induction:
    return Induction(Kernel(), used(**at), letter="i")


@pytest.mark.parametrize(
    ("goal", "proof", "why"),
    [
        # each from itself; from what is below the first; from what is no integer of the goal
        (r"\forall n \geq 0 : n a = n b", step(i="n+1"), "not seen to be less than n+1"),
        (r"\forall n \geq 1 : (n-1) a = (n-1) b", step(i="0"), "not seen to be 1 or more"),
        (r"\forall n \geq 1 : (n-1) a = (n-1) b", step(i="n-1"), "not seen to be 1 or more"),
        (r"\forall n \geq 1 : (n-1) a = (n-1) b", step(), "no value is given for i"),
        # without the first
        (r"\forall n \geq 0 : a = b", step(i="n"), "a = b is refuted"),
        # letters that are bound already
        (r"\forall n \geq 0 : \forall i \geq 0 : n i a = n i b", step(i="n"), "i is bound twice"),
        (
            r"\forall i \geq 0 : \Big( \forall n \geq 0 : n i a = n i b \Big)",
            step(i="n"),
            "i is an integer already",
        ),
        (
            r"\forall n \geq 0 : n a = n b",
            Induction(Kernel(), used(n="n"), letter="n"),
            "n is an integer already",
        ),
        (
            rf"\forall n \geq 1 : {below('n')} \Rightarrow {SUMS.format('n')}",
            Introductions(SumCongruence("k", Introductions(used(k="k")))),
            "k is bound twice",
        ),
        # what the rules do not do
        (r"\forall n \geq 1 : \forall k < n : k a = k b", Kernel(), "no rule for ∀ k < n"),
        (
            rf"{below('3')} \Rightarrow a^{{(3)}} = b^{{(3)}}",
            Introductions(used(k="3")),
            "not seen to be less than 3",
        ),
    ],
)
def test_invalid_proofs_below_a_bound_are_unchecked(goal, proof, why):
    found = outcome(goal, proof)
    assert found.outcome == Outcome.UNCHECKED
    assert why in found.reason


def test_no_value_beyond_the_bound_refutes_a_goal():
    goal = r"\forall n \geq 1 : \forall k < n : k a = \mathbf{0}"
    assert outcome(goal, against=At({"n": "1", "k": "3"}, False_())).outcome == Outcome.UNCHECKED


def test_bounded_quantifiers_are_read():
    goal = read_goal(rf"\forall n \geq 1 : {below('n-1')} \Rightarrow a = b", scope()).body.premise
    assert isinstance(goal, AllBelow)
    assert (goal.integer, goal.least, goal.bound) == ("k", 0, Linear(-1, (("n", 1),)))
    for wrong in (r"\exists k < 3", r"\forall k < q", r"\forall k < a", r"\forall n \geq 1 : \forall n < n"):
        with pytest.raises(GoalError):
            read_goal(f"{wrong} : a = b", scope())
