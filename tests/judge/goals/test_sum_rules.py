"""Sums to a symbolic n and chains of any number of bodies: what the rules show, and what they must not."""

import pytest

from workbench.core.codes.verdict_codes import VerdictCode
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
    SumCongruence,
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
OPERATORS = r"\forall n \geq 0 : a^{(n)} = \sum_{k=0}^n C_n^k F_{n-k}(x) ((\mathbf{D} - \tilde{x})^k a)"
TENSORS = r"\forall n \geq 0 : F_n(a + b) = \sum_{k=0}^n C_n^k F_{n-k}(a) G_k(a, b)"
PROOFS = {
    LEIBNIZ: BinomialInduction(r"T^{(j)} a^{(k)}"),
    OPERATORS: BinomialInduction(r"F_j(x) ((\mathbf{D} - \tilde{x})^k a)"),
    TENSORS: BinomialInduction(r"F_j(a) G_k(a, b)", step=r"\dot{Y} + Y \widetilde{a + b}"),
}


class TestPascal:
    @pytest.mark.parametrize("goal", PROOFS)
    def test_sums_with_binomials(self, goal):
        found = outcome(goal, PROOFS[goal])
        assert (found.outcome, found.scope) == (Outcome.PROVED, "all n ≥ 0"), found.reason

    @pytest.mark.parametrize("goal", PROOFS)
    @pytest.mark.parametrize(
        ("old", "new"),
        [
            ("C_n^k", "C_{n+1}^k"),
            ("C_n^k", "2 C_n^k"),
            ("k=0", "k=1"),
            ("^n C", "^{n+1} C"),
            (r"n \geq 0", r"n \geq 1"),
            ("= ", "= 2 "),
        ],
    )
    def test_a_false_one_is_not_shown(self, goal, old, new):
        assert old in goal
        assert outcome(goal.replace(old, new, 1), PROOFS[goal]).outcome != Outcome.PROVED

    @pytest.mark.parametrize(
        ("goal", "proof"),
        [
            (LEIBNIZ, BinomialInduction(r"T^{(k)} a^{(j)}")),  # the wrong way round
            (LEIBNIZ, BinomialInduction(r"T^{(j)} a^{(k)}", step=r"2 \dot{Y}")),
            (LEIBNIZ, BinomialInduction(r"T^{(j+1)} a^{(k)}")),  # begins with another
            (TENSORS, BinomialInduction(r"F_j(a) G_k(a, b)")),  # the step of another family
            (TENSORS, BinomialInduction(r"F_j(a) G_k(b, a)", step=r"\dot{Y} + Y \widetilde{a + b}")),
            (r"\forall n \geq 0 : F_n(a + b) = \sum_{k=0}^n C_n^k F_{n-k}(a) F_k(b)",
             BinomialInduction(r"F_j(a) F_k(b)", step=r"\dot{Y} + Y \widetilde{a + b}")),
            (r"\forall n \geq 0 : f = \sum_{k=0}^n C_n^k f", BinomialInduction("f", step="Y Y")),  # not additive
            (r"\forall n \geq 0 : f = \sum_{k=0}^n C_n^k f", BinomialInduction("f", step="2 Y")),
            (r"\forall n \geq 0 : (T a)^{(n)} = T^{(n)} a", BinomialInduction(r"T^{(j)} a^{(k)}")),  # no sum
            (LEIBNIZ.replace("(T a)", "(2 T a)"), BinomialInduction(r"T^{(j)} a^{(k)}")),  # begins with another
            (LEIBNIZ, BinomialInduction(r"T^{(n)} a^{(k)}")),  # no integer there
            (r"\forall n \geq 0 : z_n = \sum_{k=0}^n C_n^k 1", BinomialInduction("1", step="2 Y^2")),  # not additive
            (LEIBNIZ.replace("n", "j"), BinomialInduction(r"T^{(j)} a^{(k)}")),  # j is bound already
            (rf"\forall k \geq 0 : {LEIBNIZ.replace('k', 'l')}", BinomialInduction(r"T^{(j)} a^{(k)}")),
        ],
    )  # fmt: skip
    def test_a_wrong_term_or_step_shows_nothing(self, goal, proof):
        assert outcome(goal, proof).outcome == Outcome.UNCHECKED

    def test_the_letters_of_a_step_are_no_symbols(self):
        table = SymbolTable.build(
            {name: {"kind": kind} for name, kind in (SYMBOLS | {"Z": "vector"}).items()}
        )
        definitions, table = read_definitions(DEFINITIONS, table)
        where = Scope(table, definitions, {})
        found = prove(read_goal(LEIBNIZ, where), where, Judge(definitions), Proven(PROOFS[LEIBNIZ]))
        assert found.outcome == Outcome.UNCHECKED and "Y or Z is a symbol already" in found.reason

    def test_premises_at_an_instant_do_not_last(self):
        once = rf"T a = b \Rightarrow {LEIBNIZ.replace('(T a)', 'b')}"
        begin = Congruence("Y", Y=Instance(0, back=True))
        follow = Kernel()
        proof = BinomialInduction(r"T^{(j)} a^{(k)}", begin=begin, follow=follow)
        found = outcome(once, proof)
        assert found.outcome == Outcome.UNCHECKED and "may not be differentiated" in found.reason
        assert outcome(once.replace("Rightarrow", "Longrightarrow"), proof).outcome == Outcome.PROVED


class TestDerivativesOfAnyOrder:
    """Of sums of orders, of matrices of any size, and of sums."""

    SHIFTED = r"\forall m, n \geq 0 : (M N^{(m)})^{(n)} = \sum_{i=0}^n C_n^i M^{(n-i)} N^{(m+i)}"
    PASCAL = BinomialInduction("M^{(j)} N^{(m+k)}")

    def test_leibniz_of_matrices_with_two_orders(self):
        found = outcome(self.SHIFTED, self.PASCAL)
        assert (found.outcome, found.scope) == (Outcome.PROVED, "all m ≥ 0, n ≥ 0"), found.reason

    @pytest.mark.parametrize(
        ("old", "new"),
        [
            ("N^{(m+i)}", "N^{(i)}"),
            ("N^{(m+i)}", "N^{(m+i+1)}"),
            ("M^{(n-i)} N^{(m+i)}", "N^{(m+i)} M^{(n-i)}"),
        ],
    )
    def test_no_other(self, old, new):
        assert outcome(self.SHIFTED.replace(old, new), self.PASCAL).outcome != Outcome.PROVED

    @pytest.mark.parametrize(
        "goal",
        [
            r"\forall n, m \geq 0 : (N^{(m)})^{(n)} = N^{(n+m)}",
            r"\forall n, m \geq 0 : \frac{d}{dt} N^{(n+m)} = N^{(n+m+1)}",
            r"\forall n, m \geq 0 : \frac{d}{dt} (M N^{(n+m)}) = \dot{M} N^{(n+m)} + M N^{(n+m+1)}",
            r"\forall n, q \geq 0 : T (\sum_{m=0}^{q} \sum_{k=0}^{n} C_n^k c_m) = \sum_{m=0}^{q} \sum_{k=0}^{n} C_n^k T c_m",
            r"\forall n, q \geq 0 : (\sum_{m=0}^{q} c_m)^{(n)} = \sum_{m=0}^{q} c_m^{(n)}",
        ],
    )
    def test_true_ones(self, goal):
        found = outcome(goal, Kernel())
        assert found.outcome == Outcome.PROVED or found.code is VerdictCode.SAME_TERM, found.reason

    @pytest.mark.parametrize(
        "goal",
        [
            r"\forall n, m \geq 0 : N^{(n+m)} = N^{(n)}",
            r"\forall n, m \geq 0 : \frac{d}{dt} N^{(n+m)} = N^{(n+m)}",
            r"\forall n, m \geq 0 : (M N)^{(n+m)} = M N^{(n+m)}",
            r"\forall n, m \geq 0 : (M N^{(m)})^{(n)} = M N^{(n+m)}",
            r"\forall n, q \geq 0 : T (\sum_{m=0}^{q} \sum_{k=0}^{n} C_n^k c_m) = \sum_{m=0}^{q} \sum_{k=0}^{n} T C_n^k c_k",
            r"\forall n, q \geq 0 : (\sum_{m=0}^{q} c_m)^{(n)} = \sum_{m=0}^{q} c_m",
            r"\forall n, q \geq 0 : (\sum_{m=0}^{q} c_m)^{(n)} = \sum_{m=0}^{q} c_m^{(q)}",
            r"\forall m, q \geq 0 : (\sum_{n=0}^{q} c_n)^{(m)} = \sum_{n=0}^{q} c_n^{(n)}",
        ],
    )
    def test_false_ones(self, goal):
        assert outcome(goal, Kernel()).outcome != Outcome.PROVED

    def test_bound_variables_of_sums_are_not_captured(self):
        where = scope().with_integer("n", 0).with_integer("q", 0)
        total, other = where.term(r"\sum_{k=0}^{q} c_k"), where.term("c_n")
        bound = instantiate(other, {"n": Linear.variable("k")})
        for outer in (derivative(total, Linear.variable("k")), apply("cross", bound, total)):
            assert spread(outer) == outer
        for outer in (derivative(total, Linear.variable("n")), apply("cross", other, total)):
            assert isinstance(spread(outer), BigSum)


class TestTermwise:
    PREMISE = r"\Big( \forall n \geq 0 : F_n(a) = F_n(b) \Big) \Longrightarrow \forall n \geq 0 : "

    @pytest.mark.parametrize(
        ("goal", "value"),
        [
            (r"\sum_{k=0}^n C_n^k F_{n-k}(a) c_k = \sum_{k=0}^n C_n^k F_{n-k}(b) c_k", "j"),
            (r"\sum_{k=0}^{n+1} C_n^k F_{k}(a) c_k = \sum_{k=0}^{n+1} C_n^k F_{k}(b) c_k", "k"),
        ],
    )
    def test_a_premise_for_each_addend(self, goal, value):
        n = "{j+k}" if value == "j" else "{k+j-1}"
        proof = Introductions(SumCongruence("k", Congruence(f"C_{n}^k Y c_k", Y=Instance(0, {"n": value}))))
        assert outcome(self.PREMISE + goal, proof).outcome == Outcome.PROVED
        other = {"j": "k", "k": "j"}[value]
        wrong = Introductions(SumCongruence("k", Congruence(f"C_{n}^k Y c_k", Y=Instance(0, {"n": other}))))
        assert outcome(self.PREMISE + goal, wrong).outcome == Outcome.UNCHECKED

    @pytest.mark.parametrize(
        "goal",
        [
            r"\sum_{k=0}^n F_k(a) c_k = \sum_{k=1}^n F_k(b) c_k",
            r"\sum_{k=0}^n F_k(a) c_k = \sum_{k=0}^{n+1} F_k(b) c_k",
            r"\sum_{k=0}^n F_k(a) c_k = 2 \sum_{k=0}^n F_k(b) c_k",
            r"\sum_{k=0}^n F_k(a) c_k = \sum_{k=0}^n F_k(b) c_{k+1}",
        ],
    )
    def test_other_sums_are_not_equal_by_it(self, goal):
        proof = Introductions(SumCongruence("k", Congruence("Y c_k", Y=Instance(0, {"n": "k"}))))
        assert outcome(self.PREMISE + goal, proof).outcome == Outcome.UNCHECKED

    ALIKE = r"\Big( \forall m \geq 1 : a^{(m)} = b^{(m)} \Big) \Rightarrow \forall n \geq 0 : "

    @pytest.mark.parametrize(
        ("order", "value", "other"), [("k", "k", r"\sum_{k=1}^n"), ("n-k", "j", r"\sum_{k=0}^{n-1}")]
    )
    def test_each_addend_is_looked_at(self, order, value, other):
        """For k = 0, and for k = n, the premise says nothing."""
        goal = rf"\sum_{{k=0}}^n a^{{({order})}} = \sum_{{k=0}}^n b^{{({order})}}"
        proof = Introductions(SumCongruence("k", Congruence("Y", Y=Instance(0, {"m": value}))))
        later = Introductions(
            SumCongruence("k", Congruence("Y", Y=Instance(0, {"m": value if value == "k" else "j+1"})))
        )
        assert outcome(self.ALIKE + goal, proof).outcome == Outcome.UNCHECKED
        shorter = goal.replace(r"\sum_{k=0}^n", other)
        if value == "j":
            shorter = shorter.replace(r"\sum_{k=0}^{n-1}", r"\sum_{k=0}^{n}").replace("(n-k)", "(n-k+1)")
        assert outcome(self.ALIKE + shorter, later).outcome == Outcome.PROVED

    @pytest.mark.parametrize(
        ("goal", "why"),
        [
            (r"\sum_{k=0}^{2n} F_k(a) c_k = \sum_{k=0}^{2n} F_k(b) c_k", "expected sums to n"),
            (r"\sum_{k=-1}^n F_{k+1}(a) a = \sum_{k=-1}^n F_{k+1}(b) a", "begin with a number"),
            (r"\sum_{k=n}^{n+1} F_k(a) c_k = \sum_{k=n}^{n+1} F_k(b) c_k", "begin with a number"),
            (r"\sum_{k=0}^n F_k(a) c_k = F_n(b) c_n", "one sum on either side"),
        ],
    )
    def test_invalid_sums_to_n_are_unchecked(self, goal, why):
        found = outcome(
            self.PREMISE + goal,
            Introductions(SumCongruence("k", Congruence("Y c_k", Y=Instance(0, {"n": "k"})))),
        )
        assert found.outcome == Outcome.UNCHECKED and why in found.reason

    def test_its_letter_is_no_other(self):
        goal = self.PREMISE + r"\sum_{k=0}^n F_k(a) c_k = \sum_{k=0}^n F_k(b) c_k"
        found = outcome(
            goal, Introductions(SumCongruence("n", Congruence("Y c_n", Y=Instance(0, {"n": "n"}))))
        )
        assert found.outcome == Outcome.UNCHECKED and "n is an integer already" in found.reason


class TestChains:
    """Sums and products over m bodies by recursion."""

    SUM = r"\forall m \geq 0 : s_m = \sum_{k=0}^m c_k"
    BY_SUM = Induction(step=Congruence("Y + c_{m+1}", Y=Instance(-1)))
    ORTHOGONAL = r"\forall m \geq 0 : Q_m Q_m^T = \mathbf{I} \wedge \det Q_m = 1"
    BY_FACTORS = Induction(
        step=AndIntroduction(Congruence("Y", Y=Instance(-1)), Congruence("Y", Y=Instance(-1, part=1)))
    )

    def test_by_induction(self):
        assert outcome(self.SUM, self.BY_SUM).scope == "all m ≥ 0"
        assert outcome(self.ORTHOGONAL, self.BY_FACTORS).scope == "all m ≥ 0"

    @pytest.mark.parametrize(
        "goal",
        [
            SUM.replace("k=0", "k=1"),  # the base is missing
            SUM.replace("^m", "^{m+1}"),
            SUM.replace("s_m", "s_{m+1}"),
            SUM.replace("c_k", "c_{k+1}"),
            SUM.replace("= ", "= b + "),
            ORTHOGONAL.replace("Q_m^T", "Q_{m+1}^T"),
            ORTHOGONAL.replace("= 1", "= 2"),
            ORTHOGONAL.replace("Q_m Q_m^T", "Q_m Q_m"),
        ],
    )
    def test_a_false_one_is_not_shown(self, goal):
        proof = self.BY_FACTORS if "Q" in goal else self.BY_SUM
        assert outcome(goal, proof).outcome != Outcome.PROVED

    def test_a_product_is_a_rotation_by_its_proof_alone(self):
        turned = r"\forall S \in SO_3 : (S a) \times (S b) = S (a \times b)"
        goal = r"\forall m \geq 0 : (Q_m a) \times (Q_m b) = Q_m (a \times b)"
        members = AndIntroduction(
            Congruence("Y", Y=Instance(0, {"m": "m"})), Congruence("Y", Y=Instance(0, {"m": "m"}, part=1))
        )

        def proof(**options):
            instance = Congruence("Y", Y=Instance(1, {"S": "Q_m"}, **options))
            return Cut(self.ORTHOGONAL, self.BY_FACTORS, Cut(turned, Kernel(), Introductions(instance)))

        assert outcome(goal, proof(members=members)).outcome == Outcome.PROVED
        assert outcome(goal, proof()).outcome == Outcome.UNCHECKED
        other = AndIntroduction(members.proofs[0], members.proofs[0])
        assert outcome(goal, proof(members=other)).outcome == Outcome.UNCHECKED


class TestFunctions:
    """A function of the paper may differentiate its argument."""

    @pytest.mark.parametrize("function", ["q({})", "F_2({})"])
    def test_no_equation_at_an_instant_goes_into_it(self, function):
        goal = rf"a = b \Rightarrow {function.format('a')} = {function.format('b')}"
        proof = Congruence(function.format("Y"), Y=Instance(0))
        assert outcome(goal, proof).outcome == Outcome.UNCHECKED
        assert outcome(goal.replace("Rightarrow", "Longrightarrow"), proof).outcome == Outcome.PROVED

    def test_moving_arguments_are_no_constants_in_a_premise(self):
        goal = r"\Big( \forall d \in V_3 : q(d) = \mathbf{0} \Big) \Rightarrow q(a) = \mathbf{0}"
        assert outcome(goal, Congruence("Y", Y=Instance(0, {"d": "a"}))).outcome == Outcome.UNCHECKED


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


def test_powers_of_operators():
    power = r"\forall n \geq 0 : (\mathbf{D} + T)^{n+1} a"
    goal = power + r" = \frac{d}{dt} ((\mathbf{D} + T)^n a) + T ((\mathbf{D} + T)^n a)"
    assert outcome(goal, Kernel()).outcome == Outcome.PROVED
    for wrong in (goal.replace("{n+1} a", "{n+2} a"), goal.replace("+ T ((", "+ 2 T ((")):
        assert outcome(wrong, Kernel()).outcome != Outcome.PROVED


@pytest.mark.parametrize(
    ("true", "false"),
    [
        (
            r"\sum_{k=0}^{n} C_n^k f^{(k)} a^{(n-k)} = (f a)^{(n)}",
            r"\sum_{k=0}^{n} C_n^k f^{(k)} a^{(n-k)} k! = (f a)^{(n)}",
        ),
        (
            r"\sum_{k=0}^{n} C_n^k (a^{(n-k)} \times b^{(k)}) = (a \times b)^{(n)}",
            r"\sum_{k=0}^{n} C_n^k ((k! a^{(n-k)}) \times b^{(k)}) = (a \times b)^{(n)}",
        ),
        (
            r"\sum_{k=0}^{n} C_n^{n-k} f^{(k)} a^{(n-k)} = (f a)^{(n)}",
            r"\sum_{k=0}^{n} C_{n+k}^k f^{(k)} a^{(n-k)} = (f a)^{(n)}",
        ),
        (
            r"\sum_{k=n}^{2 n} C_n^{k-n} f^{(k-n)} a^{(2n-k)} = (f a)^{(n)}",
            r"\sum_{k=n}^{2 n} C_n^{k-n} f^{(k-n)} a^{(2n-k)} = (f a)^{(2 n)}",
        ),
        (
            r"\sum_{k=0}^{n} C_n^k C_{n+2}^2 f^{(k)} a^{(n-k)} = C_{n+2}^2 (f a)^{(n)}",
            r"\sum_{k=0}^{n} C_n^k C_{n+2}^k f^{(k)} a^{(n-k)} = C_{n+2}^2 (f a)^{(n)}",
        ),
        (
            r"\sum_{k=0}^{n} C_n^k [T^{(k)}]^T a^{(n-k)} = (T^T a)^{(n)}",
            r"\sum_{k=0}^{n} C_n^k [T^{(k)}]^T a^{(n-k)} = (T a)^{(n)}",
        ),
        (
            r"\sum_{k=0}^{n} C_{2n}^k f^{(k)} a^{(2n-k)} = \sum_{k=1}^{n+1} C_{2n}^{k-1} f^{(k-1)} a^{(2n-k+1)}",
            r"\sum_{k=0}^{n} C_{2n}^k f^{(k)} a^{(2n-k)} = (f a)^{(2n)}",
        ),
        (
            r"\sum_{k=n}^{2n} C_{2n}^k f^{(k)} a^{(2n-k)} = \sum_{k=n+1}^{2n+1} C_{2n}^{k-1} f^{(k-1)} a^{(2n-k+1)}",
            r"\sum_{k=n}^{2n} C_{2n}^k f^{(k)} a^{(2n-k)} = (f a)^{(2n)}",
        ),
        (
            r"\sum_{k=0}^{n} C_n^k (k! a^{(k)}) \times b = (\sum_{k=0}^{n} C_n^k k! a^{(k)}) \times b",
            r"\sum_{k=0}^{n} C_n^k (k! a^{(k)}) \times b = (\sum_{k=0}^{n} C_n^k a^{(k)}) \times b",
        ),
        (
            r"\sum_{k=0}^{n} P c_k = \sum_{k=1}^{n+1} P c_{k-1}",
            r"\sum_{k=0}^{n} P c_k = \sum_{k=1}^{n+1} P c_k",
        ),
        (
            r"\sum_{k=0}^{n} P c_k + \sum_{k=0}^{2 n} P c_k = \sum_{k=0}^{2 n} P c_k + \sum_{k=1}^{n+1} P c_{k-1}",
            r"\sum_{k=0}^{n} P c_k + \sum_{k=0}^{2 n} P c_k = \sum_{k=0}^{2 n} P c_k + \sum_{k=0}^{2 n} P c_k",
        ),
        (
            r"\sum_{k=n}^{2 n} P c_k + \sum_{k=0}^{2 n} P c_k = \sum_{k=0}^{2 n} P c_k + \sum_{k=n}^{2 n} P c_k",
            r"\sum_{k=n}^{2 n} P c_k + \sum_{k=0}^{2 n} P c_k = \sum_{k=0}^{2 n} P c_k + \sum_{k=0}^{2 n} P c_k",
        ),
        (
            r"\sum_{k=0}^{n} P a^{(k)} = P a + \sum_{k=1}^{n} P a^{(k)}",
            r"\sum_{k=0}^{n} P a^{(k)} = P a^{(n)} + \sum_{k=1}^{n} P a^{(k)}",
        ),
        (  # Q_{m-1} is none at m = 0
            r"\sum_{k=1}^{n} Q_{k-1} T = (\sum_{k=1}^{n} Q_{k-1}) T",
            r"\sum_{k=0}^{n} Q_{k-1} T = (\sum_{k=0}^{n} Q_{k-1}) T",
        ),
        (  # nor is Q_{-1} where the sums begin to have addends
            r"\sum_{k=1}^{n} T Q_{k-1} = T (\sum_{k=1}^{n} Q_{k-1})",
            r"\sum_{k=1}^{n} T Q_{k-2} = T (\sum_{k=1}^{n} Q_{k-2})",
        ),
        (
            r"\sum_{k=n}^{2 n} T Q_k = T (\sum_{k=n}^{2 n} Q_k)",
            r"\sum_{k=n-1}^{2 n} T Q_k = T (\sum_{k=n-1}^{2 n} Q_k)",
        ),
        (
            r"\sum_{k=0}^{n} (f T)^{(k)} U = (\sum_{k=0}^{n} (f T)^{(k)}) U",
            r"\sum_{k=0}^{n} \frac{1}{f} T^{(k)} U = (\sum_{k=0}^{n} \frac{1}{f} T^{(k)}) U",
        ),
    ],
)
def test_addends_that_are_compared_as_terms(true, false):
    """No engine sees sums to n: what is left of an equation is compared term by term."""
    assert outcome(rf"\forall n \geq 0 : {true}", Kernel()).outcome == Outcome.PROVED
    assert outcome(rf"\forall n \geq 0 : {false}", Kernel()).outcome in (Outcome.REFUTED, Outcome.UNCHECKED)
