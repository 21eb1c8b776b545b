"""A member that is defined apart is not what the definition for all n says: goals for all n that one member
refutes, far behind those that are looked at one by one, and the same goals where no member is apart."""

import pytest

from tests.judge.goals.test_goals import DEFINITIONS, SYMBOLS
from workbench.core.verdict import Outcome
from workbench.language.definition_entries import read_definitions
from workbench.language.goals.goal_reader import read_goal
from workbench.language.goals.goals import Scope
from workbench.language.goals.proofs import Congruence, Induction, Instance, Kernel, Proven, SumCongruence
from workbench.language.naming.symbols import SymbolTable
from workbench.prover.decide.decide import Judge
from workbench.prover.goals.prove_goal import prove

FAMILIES = {"K_n": r"a^{(n)}", "P_1": r"\mathbf{I}", "P_{n+1}": r"\mathbf{D} P_n + P_n(F_1)"}
APART = {"F_5": "T", "K_5": "b", "P_5": "T"}  # K_5 = b: it is refuted that K_n is a derivative
KINDS = {"K_n": {"kind": "vector"}, "P_n": {"kind": "operator"}}


def outcome(goal, proof, apart):
    definitions, table = read_definitions(DEFINITIONS | FAMILIES | apart, SymbolTable.build(SYMBOLS | KINDS))
    scope = Scope(table, definitions, {})
    return prove(read_goal(goal, scope), scope, Judge(definitions), Proven(proof)).outcome


@pytest.mark.parametrize(
    ("goal", "proof"),
    [
        (r"\forall n \geq 1 : F_{n+1} = \dot{F}_n + F_n F_1", Kernel()),
        (r"\forall n \geq 1 : F_{n+1} - F_n F_1 = \dot{F}_n", Kernel()),
        (r"\forall n \geq 1 : K_n = a^{(n)}", Kernel()),
        (r"\forall n \geq 1 : K_n + b = b + a^{(n)}", Kernel()),
        (r"\forall n, m \geq 1 : F_{n+1} K_m = (\dot{F}_n + F_n F_1) K_m", Kernel()),
        (r"\forall n \geq 1 : \sum_{k=1}^n F_{k+1} = \sum_{k=1}^n (\dot{F}_k + F_k F_1)", Kernel()),
        (r"\forall n \geq 1 : \sum_{k=1}^n F_{k+1} = \sum_{k=1}^n (\dot{F}_k + F_k F_1)", SumCongruence("k")),
        (r"\forall n \geq 1 : \sum_{k=0}^n C_n^k K_k \times b^{(n-k)} = (a \times b)^{(n)}", Kernel()),
        (r"\forall n \geq 1 : P_{n+1} a = \frac{d}{dt} (P_n a) + (P_n F_1) a", Kernel()),
        (r"\forall n \geq 1 : P_n F_1 = F_n", Induction(step=Congruence(r"\dot{Y} + Y F_1", Y=Instance(-1)))),
    ],
)
def test_a_separately_defined_member_is_detected(goal, proof):
    assert outcome(goal, proof, {}) == Outcome.PROVED
    assert outcome(goal, proof, APART) in (Outcome.UNCHECKED, Outcome.REFUTED)
