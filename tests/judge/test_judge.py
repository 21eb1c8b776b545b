"""Verdicts: true and false statements that anyone knows, and what the judge must not be fooled by."""

from dataclasses import replace
from fractions import Fraction

import pytest

from workbench.context.index_values import Orders
from workbench.core.verdict import EngineDisagreement, Outcome
from workbench.engines.inventory.assumptions import Unsatisfiable
from workbench.language.definition_entries import read_definition
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read
from workbench.prover.decide.decide import Judge

TABLE = SymbolTable.build(
    {
        "a": {"kind": "vector"},
        "b": {"kind": "vector"},
        "c": {"kind": "vector"},
        "d": {"kind": "vector"},
        "f": {"kind": "scalar"},
        "g": {"kind": "scalar"},
        "T": {"kind": "tensor"},
        "S": {"kind": "tensor"},
        "R": {"kind": "rotation"},
        "r": {"kind": "vector", "constant": True},
        "u": {"kind": "vector", "unit": True},
        r"\alpha": {"kind": "scalar"},
        r"\beta": {"kind": "scalar"},
        r"\underline{a}": {"kind": "dual vector"},
        r"\underline{b}": {"kind": "dual vector"},
        r"\underline{u}": {"kind": "dual vector", "unit": True},
        r"\underline{R}": {"kind": "dual rotation"},
        r"\underline{\alpha}": {"kind": "dual scalar"},
        r"\omega": {"kind": "vector", "weight": 1},
    }
)


def defined(**bodies):
    table, found = TABLE, []
    for key, body in bodies.items():
        definition, table = read_definition(key, body, table)
        found.append(definition)
    return Definitions(found), table


PHI, PHI_TABLE = defined(**{r"\Phi_1": r"\tilde{\omega}", r"\Phi_{n+1}": r"\dot{\Phi}_n + \Phi_n \Phi_1"})


def judged(latex, assume=(), hypothesis=None, orders=None, definitions=None, table=TABLE, **options):
    integers = orders.variables if orders else ()
    (statement,) = read(latex, table, integers)
    return Judge(definitions or Definitions(), **options).judge(
        statement,
        tuple(read(a, table, integers)[0] for a in assume),
        hypothesis and read(hypothesis, table, integers)[0],
        orders,
    )


TRUE = {
    "Lagrange": r"a \times (b \times c) = (a \cdot c) b - (a \cdot b) c",
    "Jacobi": r"a \times (b \times c) + b \times (c \times a) + c \times (a \times b) = 0",
    "Binet-Cauchy": r"(a \times b) \cdot (c \times d) = (a \cdot c)(b \cdot d) - (a \cdot d)(b \cdot c)",
    "triple product": r"(a, b, c) = a \cdot (b \times c)",
    "transport": r"\frac{d}{dt}(a \cdot b) = \dot{a} \cdot b + a \cdot \dot{b}",
    "adjugate": r"T T^* = (\det T) \mathbf{I}",
    "adjugate of a product": r"(T S)^* = S^* T^*",
    "determinant of a product": r"\det (T S) = (\det T)(\det S)",
    "transposed skew": r"\tilde{a}^T = -\tilde{a}",
    "Cayley-Hamilton of a skew tensor": r"\tilde{a}^3 = -a^2 \tilde{a}",
    "rotation keeps products": r"(R a) \cdot (R b) = a \cdot b",
    "rotation keeps cross products": r"R (a \times b) = (R a) \times (R b)",
    "rotation is its inverse's transpose": r"R^{-1} = R^T",
    "angular velocity is skew": r"\dot{R} R^T = -(\dot{R} R^T)^T",
    "second order of orthogonality": r"\ddot{R} R^T + 2 \dot{R} \dot{R}^T + R \ddot{R}^T = 0",
    "unit vector moves across itself": r"u \cdot \dot{u} = 0",
    "unit vector, second order": r"u \cdot \ddot{u} = -\dot{u}^2",
    "unit projector": r"\tilde{u}^2 = u \otimes u - \mathbf{I}",
    "Pythagoras": r"\sin^2 \alpha + \cos^2 \alpha = 1",
    "sine of a sum": r"\sin(\alpha + \beta) = \sin \alpha \cos \beta + \cos \alpha \sin \beta",
    "double angle": r"\cos(2 \alpha) = 1 - 2 \sin^2 \alpha",
    "derivative of a sine": r"\frac{d}{dt} \sin \alpha = \dot{\alpha} \cos \alpha",
    "dual orthogonality": r"\underline{R} \underline{R}^T = \mathbf{I}",
    "dual rotation keeps cross products": r"\underline{R} (\underline{a} \times \underline{b}) = (\underline{R} \underline{a}) \times (\underline{R} \underline{b})",
    "dual unit": r"\underline{u} \cdot \underline{u} = 1",
    "dual sine": r"\operatorname{Du} \sin \underline{\alpha} = \operatorname{Du} \underline{\alpha} \cos \operatorname{Re} \underline{\alpha}",
    "norm of a multiple": r"\|-2 a\| = 2 \|a\|",
    "norm of a unit vector": r"\|u\| = 1",
    "operator product": r"\mathbf{D} \circ T = \dot{T} + T \mathbf{D}",
    "turn back": r"e^{\alpha \tilde{u}} e^{-\alpha \tilde{u}} = \mathbf{I}",
    "turn about a scaled axis": r"e^{2 \alpha \tilde{u}} = e^{\widetilde{\alpha u}} e^{\tilde{u} \alpha}",
    "sum with numbers as bounds": r"\sum_{k=1}^3 k a = 6 a",
    "a matrix acts on a column of vectors": r"\begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix} \begin{bmatrix} a \\ b \end{bmatrix} = \begin{bmatrix} a + 2 b \\ 3 a + 4 b \end{bmatrix}",
    "operators beside a tensor": r"T = T + \mathbf{D} - \mathbf{D}",
    "a tensor beside operators": r"T + \mathbf{D} - \mathbf{D} = T",
    "operator acts": r"(\mathbf{D} + \tilde{a}) b = \dot{b} + a \times b",
}

FALSE = {
    "cross product commutes": r"a \times b = b \times a",
    "cross product associates": r"a \times (b \times c) = (a \times b) \times c",
    "tensors commute": r"T S = S T",
    "adjugate of a product, wrong order": r"(T S)^* = T^* S^*",
    "a rotation fixes everything": r"R r = r",
    "a rotation is symmetric": r"R = R^T",
    "a rotation is constant": r"\dot{R} = 0",
    "a unit vector is constant": r"\dot{u} = 0",
    "sine is odd and even": r"\sin \alpha = \sin(-\alpha)",
    "double angle, wrong": r"\sin(2 \alpha) = 2 \sin \alpha",
    "norm is linear": r"\|a + b\| = \|a\| + \|b\|",
    "norm loses its sign": r"\|-2 a\| = -2 \|a\|",
    "dual parts are real": r"\operatorname{Du}(\underline{a} \cdot \underline{b}) = 0",
    "a matrix acts by its rows": r"\begin{bmatrix} 1 & 2 \\ 3 & 4 \end{bmatrix} \begin{bmatrix} a \\ b \end{bmatrix} = \begin{bmatrix} a + 3 b \\ 2 a + 4 b \end{bmatrix}",
    "operators commute with tensors": r"\mathbf{D} \circ T = T \mathbf{D}",
    "differs in one dual part only": r"\underline{a} \times \underline{b} = \underline{a} \times \underline{b} + \varepsilon (\operatorname{Re}\underline{a} \cdot \operatorname{Re}\underline{b}) \operatorname{Re}\underline{a}",
}


@pytest.mark.parametrize("name", TRUE)
def test_true_claims_are_proved(name):
    verdict = judged(TRUE[name])
    assert verdict.outcome == Outcome.PROVED, verdict
    engines = {e.method.split()[0] for e in verdict.evidence}
    assert {"exact", "SymPy"} <= engines


@pytest.mark.parametrize("name", FALSE)
def test_false_claims_are_refuted_by_small_numbers(name):
    verdict = judged(FALSE[name])
    assert verdict.outcome == Outcome.REFUTED, verdict
    example = verdict.counterexample
    assert example.left != example.right
    entries = [Fraction(x) for values in example.values.values() for x in values]
    assert entries and max(abs(x.numerator) for x in entries) <= 100


@pytest.mark.parametrize("name", TRUE)
def test_without_the_second_engine_nothing_is_proved(name):
    assert judged(TRUE[name], second_engine=False).outcome == Outcome.PROBABLE


def test_a_counterexample_can_be_checked_by_hand():
    example = judged(r"a \times b = b \times a").counterexample
    a, b = ([Fraction(x) for x in example.values[name]] for name in "ab")
    cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    assert [str(x) for x in cross] == list(example.left)
    assert [str(-x) for x in cross] == list(example.right)


class TestHypotheses:
    def test_a_denominator_that_can_vanish_makes_a_claim_conditional(self):
        verdict = judged(r"\frac{(a \cdot b) f}{f} = a \cdot b")
        assert verdict.outcome == Outcome.CONDITIONAL
        assert verdict.counterexample.left == ("undefined",)

    @pytest.mark.parametrize(
        ("latex", "assume"),
        [
            (r"\frac{(a \cdot b) f}{f} = a \cdot b", r"f \neq 0"),
            (r"\frac{(a \cdot b) f}{f} = a \cdot b", r"f g \neq 0"),
            (r"\frac{a^2 b}{a^2} = b", r"a \neq 0"),
            (r"T^{-1} T = \mathbf{I}", r"\det T \neq 0"),
            (r"\frac{a}{\|a\|} \cdot a = \|a\|", r"a \neq 0"),
            (r"\frac{f}{1 + f^2} + \frac{f^3}{1 + f^2} = f", r"f \neq 0"),
        ],
    )
    def test_an_assumption_that_excludes_the_zeros_suffices(self, latex, assume):
        assert judged(latex, [assume]).outcome == Outcome.PROVED

    def test_an_assumption_that_allows_a_zero_does_not_suffice(self):
        assert judged(r"T^{-1} T = \mathbf{I}", [r"T \neq 0"]).outcome == Outcome.CONDITIONAL
        assert judged(r"\frac{f g}{f} = g", [r"f + g \neq 0"]).outcome == Outcome.CONDITIONAL

    def test_an_unstated_hypothesis_makes_a_claim_conditional(self):
        verdict = judged(r"a \times (b \times c) = (a \times b) \times c", hypothesis=r"a \times c = 0")
        assert verdict.outcome != Outcome.PROVED
        verdict = judged(r"T^{-1} = \frac{T^*}{\det T}", hypothesis=r"\det T \neq 0")
        assert verdict.outcome == Outcome.CONDITIONAL and verdict.hypothesis
        assert verdict.counterexample and verdict.evidence[-1].method.startswith("witness")

    def test_a_hypothesis_that_is_not_needed_leaves_a_proof(self):
        assert judged(TRUE["Lagrange"], hypothesis=r"a \neq 0").outcome == Outcome.PROVED

    def test_a_wrong_hypothesis_does_not_help(self):
        assert judged(r"a \times b = b \times a", hypothesis=r"a \neq 0").outcome == Outcome.REFUTED

    @pytest.mark.parametrize("assume", [[r"a = 0", r"a \neq 0"], [r"f^2 = -1"], [r"R = 0"]])
    def test_assumptions_that_nothing_satisfies_are_an_error(self, assume):
        with pytest.raises(Unsatisfiable):
            judged(r"f a = a f + b", assume)

    def test_an_equation_is_supposed_at_the_instant_only(self):
        assert judged(r"a \times b = 0", [r"a = 0"]).outcome == Outcome.PROVED
        assert judged(r"\dot{a} = 0", [r"a = 0"]).outcome == Outcome.UNCHECKED  # true if it lasts
        assert judged(r"\dot{a} = b", [r"a = 0"]).outcome == Outcome.REFUTED
        assert judged(r"\dot{a} \cdot b = 0", [r"\dot{a} = 0"]).outcome == Outcome.PROVED

    def test_an_equation_is_solved_for_a_symbol(self):
        assert judged(r"c \cdot a = 0", [r"c = a \times b"]).outcome == Outcome.PROVED
        assert judged(r"c \cdot b = 1", [r"c = a \times b"]).outcome == Outcome.REFUTED


class TestEquivalences:
    @pytest.mark.parametrize(
        ("latex", "outcome"),
        [
            (r"a \cdot a \neq 0 \Leftrightarrow a \neq 0", Outcome.PROVED),
            (r"(a \times b)^2 = 0 \Leftrightarrow a \times b = 0", Outcome.PROVED),
            (r"f^2 g \neq 0 \Leftrightarrow f g^3 \neq 0", Outcome.PROVED),
            (r"f g \neq 0 \Rightarrow f \neq 0", Outcome.PROVED),
            (r"f \neq 0 \Rightarrow f g \neq 0", Outcome.REFUTED),
            (r"f^2 + 3 g f - 10 g^2 + f \neq 0 \Rightarrow f g - 7 a^2 \neq 0", Outcome.REFUTED),
            (r"f = 0 \Rightarrow f g = 0", Outcome.PROVED),
            (r"f g = 0 \Rightarrow f = 0", Outcome.REFUTED),
            (r"a \cdot b \neq 0 \Leftrightarrow a \neq 0", Outcome.REFUTED),
            (r"a \times b = 0 \Leftrightarrow a \cdot b = 0", Outcome.REFUTED),
        ],
    )
    def test_zero_sets(self, latex, outcome):
        assert judged(latex).outcome == outcome


class TestFamilies:
    def test_a_recurrence_proves_for_all_n(self):
        verdict = judged(
            r"\operatorname{trace} \Phi_{n+1} = \operatorname{trace} \dot{\Phi}_n + \operatorname{trace}(\tilde{\omega} \Phi_n)",
            orders=Orders.parse("n = 1..6"),
            definitions=PHI,
            table=PHI_TABLE,
        )
        assert (verdict.outcome, verdict.scope) == (Outcome.PROVED, "all n ≥ 1")

    def test_a_range_says_that_it_is_a_range(self):
        verdict = judged(r"\sum_{k=0}^{n} C_n^k a = 2^n a", orders=Orders.parse("n = 0..6"))
        assert (verdict.outcome, verdict.scope) == (Outcome.PROVED, "n = 0..6")

    def test_a_claim_for_small_n_only_is_refuted_where_it_fails(self):
        verdict = judged(
            r"\det \Phi_n = 0", orders=Orders.parse("n = 1..4"), definitions=PHI, table=PHI_TABLE
        )
        assert verdict.outcome == Outcome.REFUTED and "n = 2" in verdict.reason

    def test_restating_a_definition_is_a_definition(self):
        verdict = judged(
            r"\Phi_{n+1} = \dot{\Phi}_n + \Phi_n \Phi_1",
            orders=Orders.parse("n = 1..4"),
            definitions=PHI,
            table=PHI_TABLE,
        )
        assert verdict.outcome == Outcome.DEFINITION


class TestDefects:
    def test_the_same_term_on_both_sides_tests_nothing(self):
        assert judged(r"a \times b = a \times b").outcome == Outcome.UNCHECKED

    def test_engines_that_disagree_are_a_defect(self, monkeypatch):
        import workbench.engines.jet.consequences as second

        monkeypatch.setattr(second, "recheck", lambda *arguments: False)
        with pytest.raises(EngineDisagreement):
            judged(TRUE["Lagrange"])

    def test_a_wrong_first_engine_is_found_out(self, monkeypatch):
        import workbench.engines.polynomial.polynomial_engine as exact

        monkeypatch.setitem(exact._HEADS, "cross", exact._HEADS["add"])
        with pytest.raises(EngineDisagreement):
            judged(r"a \times b = a + b")


def test_a_verdict_is_computed_again_only_for_other_settings(monkeypatch):
    """Neither other assumptions, nor a hypothesis, nor other engines share a verdict."""
    (claim,), (given,) = read(r"a \cdot b = 0", TABLE), read("a = 0", TABLE)
    judge, asked = Judge(Definitions()), []
    inner = Judge._judge
    monkeypatch.setattr(Judge, "_judge", lambda self, *said: asked.append(said) or inner(self, *said))
    one_engine = replace(judge, second_engine=False)
    for _ in range(2):
        assert judge.judge(claim).outcome is Outcome.REFUTED
        assert judge.judge(claim, (given,)).outcome is Outcome.PROVED
        assert judge.judge(claim, hypothesis=given).outcome is Outcome.CONDITIONAL
        assert one_engine.judge(claim, (given,)).outcome is Outcome.PROBABLE
        assert len(asked) == 5  # two for the hypothesis
    assert Judge(Definitions()).judge(claim).outcome is Outcome.REFUTED
    assert len(asked) == 6
