"""Sums to a symbolic n and chains of any number of bodies: what the rules show, and what they must not."""

import pytest

from workbench.core.construct import apply, derivative
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import instantiate
from workbench.core.terms import BigSum
from workbench.core.verdict import Outcome
from workbench.engines.inventory.addend_expansion import spread
from workbench.language.definition_entries import read_definitions
from workbench.language.goals.goal_reader import read_goal
from workbench.language.goals.goals import Scope
from workbench.language.goals.proofs import (
    AndIntroduction,
    BinomialInduction,
    Congruence,
    Cut,
    Induction,
    Instance,
    Introductions,
    Kernel,
    Proven,
)
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read_formula
from workbench.prover.decide.decide import Judge
from workbench.prover.goals.product_normal_form import is_same_sum, tidy
from workbench.prover.goals.prove_goal import SAME_ADDENDS, prove

SYMBOLS = {
    "a": "vector", "b": "vector", "x": "vector", "f": "scalar", "c_k": "vector", "T": "tensor", "U": "tensor",
    "R_k": "rotation", "P": "operator", "y": "vector", "Q_m": "tensor",
    "M": "matrix 4×4", "N": "matrix 4×4",
}  # fmt: skip
DEFINITIONS = {
    "F_0(x)": r"\mathbf{I}",
    "F_{n+1}(x)": r"\dot{F}_n(x) + F_n(x) \tilde{x}",
    "G_0(x, y)": r"\mathbf{I}",
    "G_{n+1}(x, y)": r"\dot{G}_n(x, y) - \tilde{x} G_n(x, y) + G_n(x, y) \tilde{x} + G_n(x, y) \tilde{y}",
    "q(x)": r"\dot{x}",
    "z_0": "1",
    "z_{n+1}": "2 z_n^2",
    "s_0": "c_0",
    "s_{m+1}": "s_m + c_{m+1}",
    "Q_0": r"\mathbf{I}",
    "Q_{m+1}": "Q_m R_{m+1}",
}


def scope() -> Scope:
    table = SymbolTable.build({name: {"kind": kind} for name, kind in SYMBOLS.items()})
    definitions, table = read_definitions(DEFINITIONS, table)
    return Scope(table, definitions, {})


def outcome(goal, proof):
    where = scope()
    return prove(read_goal(goal, where), where, Judge(where.definitions), Proven(proof))


LEIBNIZ = r"\forall n \geq 0 : (T a)^{(n)} = \sum_{k=0}^n C_n^k T^{(n-k)} a^{(k)}"
BY_PASCAL = BinomialInduction(r"T^{(j)} a^{(k)}")
ORTHOGONAL = r"\forall m \geq 0 : Q_m Q_m^T = \mathbf{I} \wedge \det Q_m = 1"
BY_FACTORS = Induction(
    step=AndIntroduction(Congruence("Y", Y=Instance(-1)), Congruence("Y", Y=Instance(-1, part=1)))
)


def test_the_letters_of_a_step_are_no_symbols():
    table = SymbolTable.build({name: {"kind": kind} for name, kind in (SYMBOLS | {"Z": "vector"}).items()})
    definitions, table = read_definitions(DEFINITIONS, table)
    where = Scope(table, definitions, {})
    found = prove(read_goal(LEIBNIZ, where), where, Judge(definitions), Proven(BY_PASCAL))
    assert found.outcome == Outcome.UNCHECKED and "Y or Z is a symbol already" in found.reason


def test_bound_variables_of_sums_are_not_captured():
    where = scope().with_integer("n", 0).with_integer("q", 0)
    total, other = where.term(r"\sum_{k=0}^{q} c_k"), where.term("c_n")
    bound = instantiate(other, {"n": Linear.variable("k")})
    for outer in (derivative(total, Linear.variable("k")), apply("cross", bound, total)):
        assert spread(outer) == outer
    for outer in (derivative(total, Linear.variable("n")), apply("cross", other, total)):
        assert isinstance(spread(outer), BigSum)


def test_a_product_is_a_rotation_by_its_proof_alone():
    turned = r"\forall S \in SO_3 : (S a) \times (S b) = S (a \times b)"
    goal = r"\forall m \geq 0 : (Q_m a) \times (Q_m b) = Q_m (a \times b)"
    members = AndIntroduction(
        Congruence("Y", Y=Instance(0, {"m": "m"})), Congruence("Y", Y=Instance(0, {"m": "m"}, part=1))
    )

    def proof(**options):
        instance = Congruence("Y", Y=Instance(1, {"S": "Q_m"}, **options))
        return Cut(ORTHOGONAL, BY_FACTORS, Cut(turned, Kernel(), Introductions(instance)))

    assert outcome(goal, proof(members=members)).outcome == Outcome.PROVED
    assert outcome(goal, proof()).outcome == Outcome.UNCHECKED
    other = AndIntroduction(members.proofs[0], members.proofs[0])
    assert outcome(goal, proof(members=other)).outcome == Outcome.UNCHECKED


@pytest.mark.parametrize(
    ("left", "right", "same"),
    [
        (r"(T U)^T a", r"U^T (T^T a)", True),
        (r"\det(T U)", r"\det T \det U", True),
        (r"T (f a) + b", r"b + f T a", True),
        (r"\mathbf{I} T a - (b - b)", r"T a", True),
        (r"\frac{d^3}{dt^3} (a + b)", r"a^{(3)} + b^{(3)}", True),
        (r"T \mathbf{I} U a", r"T U a", True),
        (r"f \mathbf{I} T", r"f T", True),
        (r"-(T (-a)) + (-T) b", r"T a - T b", True),
        (r"(T^T)^T \mathbf{I}^T", r"T", True),
        (r"T + f \mathbf{I}", r"f \mathbf{I} + T", True),
        (r"T + \mathbf{I} f", r"\mathbf{I} f + T", True),
        (r"(f \mathbf{I}) a", r"\mathbf{I} a", False),
        (r"(f T) a + \mathbf{I} b", r"T a + b", False),
        (r"(T U)^T a", r"T^T (U^T a)", False),
        (r"T (U a)", r"U (T a)", False),
        (r"(f T)^T a", r"T a", False),
        (r"a + b", r"a - b", False),
        (r"2 a", r"a", False),
        (r"\frac{d}{dt} (f a)", r"f \dot{a}", False),
    ],
)
def test_the_form_of_products(left, right, same):
    (said,) = read_formula(f"{left} = {right}", scope().table, {}).statements
    assert is_same_sum(tidy(said)) == same
    assert Judge(scope().definitions).judge(said).outcome == (Outcome.PROVED if same else Outcome.REFUTED)


def test_without_integers_the_engines_say_what_holds():
    """That the addends are the same is a reason where no engine has one."""
    (said,) = outcome("P a + P b = P b + P a", Kernel()).evidence
    assert len(said.figures["engines"]) > 1 and SAME_ADDENDS.method not in said.figures["engines"]
