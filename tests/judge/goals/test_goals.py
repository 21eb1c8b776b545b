"""Goals: what is read, what the rules derive, and what they must refuse."""

import pytest

from workbench.core.formula_errors import ReadError
from workbench.core.terms import Conjunction
from workbench.core.verdict import Outcome, Verdict
from workbench.language.definition_entries import read_definitions
from workbench.language.goals.goal_reader import read_goal
from workbench.language.goals.goals import All, AllFrom, Exists, GoalError, Implies, Scope
from workbench.language.goals.proofs import (
    AndIntroduction,
    Cases,
    Congruence,
    Cut,
    Instance,
    Introductions,
    Kernel,
    Proven,
)
from workbench.language.naming.symbols import SymbolTable
from workbench.prover.decide.decide import Judge
from workbench.prover.goals.prove_goal import prove

SYMBOLS = {
    "a": {"kind": "vector"},
    "b": {"kind": "vector"},
    "T": {"kind": "tensor"},
    "R": {"kind": "rotation"},
    r"\omega": {"kind": "vector"},
    "s": {"kind": "vector", "constant": True},
}
DEFINITIONS = {
    "F_1": r"\tilde{\omega}",
    "F_{n+1}": r"\dot{F}_n + F_n F_1",
    "x": "a + T s",
}


def scope() -> Scope:
    definitions, table = read_definitions(DEFINITIONS, SymbolTable.build(SYMBOLS))
    return Scope(table, definitions, {})


def outcome(goal: str, proof=None, against=None) -> Verdict:
    where = scope()
    proven = Proven(Kernel() if proof is None and against is None else proof, against)
    return prove(read_goal(goal, where), where, Judge(where.definitions), proven)


def test_lemmas_of_other_proofs_change_no_verdict():
    """What was judged is found again by what is claimed, supposed and for which integers, and by no less."""
    goals = [
        r"\forall c \in V_3 : c \times c = \mathbf{0}",
        r"a \times b = \mathbf{0}",
        r"a = b \Rightarrow a \times b = \mathbf{0}",
        r"a = -b \Rightarrow a \times b = \mathbf{0}",
        r"a \times b = \mathbf{0}",
        r"\forall n \geq 1 : \det F_n = \det F_n^T",
        r"\forall n \geq 1 : F_n = F_n^T",
        r"\forall n \geq 2 : F_n = \dot{F}_{n-1} + F_{n-1} F_1",
        r"\forall n \geq 1 : F_n = \dot{F}_{n-1} + F_{n-1} F_1",
    ]
    where, lemmas, found = scope(), {}, []
    judge = Judge(where.definitions)
    for goal in goals * 2:
        read, proven = read_goal(goal, where), Proven(Kernel())
        known = len(lemmas)
        shared = prove(read, where, judge, proven, lemmas=lemmas)
        assert shared == prove(read, where, judge, proven), goal
        found.append((str(shared.outcome), len(lemmas) - known))
    first, again = found[: len(goals)], found[len(goals) :]
    assert {outcome for outcome, _ in first} == {"proved", "refuted", "unchecked"}
    assert [outcome for outcome, _ in again] == [outcome for outcome, _ in first]
    assert sum(new for _, new in first) > 4 and not any(new for _, new in again)


def test_quantifiers_reach_to_the_right():
    goal = read_goal(
        r"\forall n \geq 1 : \exists! X \in L(V_3, V_3) : \forall c \in V_3 : X c = F_n c", scope()
    )
    assert isinstance(goal, AllFrom) and goal.least == 1
    assert isinstance(goal.body, Exists) and goal.body.unique
    assert isinstance(goal.body.body, All)
    assert isinstance(
        read_goal(r"a = b \Rightarrow \forall c \in V_3 : c \cdot a = c \cdot b", scope()), Implies
    )


@pytest.mark.parametrize(
    "goal",
    [
        r"\forall c \in W : c = a",
        r"\forall c : c = a",
        r"\exists a \in V_3 : a = b",  # a letter of the paper
        r"\forall a \in \mathbb{R} : a = b",  # another thing than it is declared
        r"\forall x \in V_3^\mathbb{R} : x = b",  # a defined symbol
        r"\exists n \geq 1 : F_n = T",
        r"\Big( a = b",
        r"a = b ;",
        r"\forall c \in V_3 c = a",
    ],
)
def test_invalid_goals_are_rejected(goal):
    with pytest.raises((GoalError, ReadError)):
        read_goal(goal, scope())


@pytest.mark.parametrize("between", [", ", r", \quad ", r" \\ ", r" \text{ and } "])
def test_formulas_beside_each_other_are_all_said(between):
    where = scope()
    parts = where.statement("a = b"), where.statement("T a = x")
    assert where.statement(f"a = b{between}T a = x") == Conjunction(parts)
    assert outcome(rf"a = b \Rightarrow a = b{between}T a = x", Kernel()).outcome == Outcome.UNCHECKED


def test_cases_and_lemmas():
    goal = r"\forall c \in V_3 : \Big( c \neq \mathbf{0} \Rightarrow c^2 \frac{1}{c^2} = 1 \Big)"
    assert outcome(goal).outcome == Outcome.PROVED
    cases = Cases(r"a = \mathbf{0}", Congruence(r"Y \times b", Y=Instance(-1)), Kernel())
    assert outcome(r"a \times b = \mathbf{0}", cases).outcome == Outcome.UNCHECKED
    lemma = Cut(r"a \times b = -b \times a", Kernel(), Congruence("2 Y", Y=Instance(-1)))
    assert outcome(r"2 (a \times b) = -2 b \times a", lemma).outcome == Outcome.PROVED
    false = Cut(r"a \times b = b \times a", Kernel(), Congruence("Y", Y=Instance(-1)))
    assert outcome(r"a \times b = b \times a", false).outcome == Outcome.UNCHECKED
    parts = AndIntroduction(Kernel(), Kernel())
    assert outcome(r"a + b = b + a ; a \times b = b \times a", parts).outcome == Outcome.UNCHECKED


def test_members_of_a_set_are_shown_letter_by_letter():
    """That T is a rotation is a premise; of R the judge knows it."""
    premise = r"T T^T = \mathbf{I} \wedge \det T = 1 \Rightarrow \det (R T) = 1"
    product = r"\forall P, Q \in SO_3 : \det (P Q) = 1"
    is_one = AndIntroduction(Congruence("Y", Y=Instance(1)), Congruence("Y", Y=Instance(1, part=1)))
    is_none = AndIntroduction(Congruence("Y", Y=Instance(1, part=1)), Congruence("Y", Y=Instance(1)))

    def of(values, **members):
        use = Instance(0, values, members=members)
        return outcome(premise, Cut(product, Kernel(), Introductions(Congruence("Y", Y=use)))).outcome

    assert of({"P": "R", "Q": "T"}, Q=is_one) == Outcome.PROVED
    assert of({"P": "R", "Q": "T"}, Q=is_none) == Outcome.UNCHECKED
    assert of({"P": "R", "Q": "T"}, P=is_one) == Outcome.PROVED  # of T by the judge, from the premise
    assert of({"P": "R", "Q": "2 T"}, Q=is_one) == Outcome.UNCHECKED
