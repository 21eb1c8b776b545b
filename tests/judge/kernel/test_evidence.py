"""What a verdict says it rests on: each check that was made, once, in order, with its figures; no other."""

import pytest
from judge.test_judge import PHI, PHI_TABLE, judged

from workbench import check
from workbench.context.index_values import Orders
from workbench.core.verdict import EngineDisagreement, Outcome
from workbench.engines.jet import consequences, drake_ring
from workbench.language.definitions import Definitions
from workbench.language.reader import read
from workbench.prover.decide.decide import Judge
from workbench.prover.decide.equation import Equation

VANISHES = "residual is 0"
PRIME = f"random point modulo {2**61 - 1}", VANISHES, {}
SYMPY = "SymPy PolyRing on Python integers, Leibniz jets", VANISHES, {}
DRAKE = "Drake symbolic Polynomial, Leibniz jets", VANISHES, {}


def flint(components, indeterminates):
    return (
        "exact ring over ℚ (FLINT)",
        VANISHES,
        {"components": components, "indeterminates": indeterminates},
    )


APART = "the sides differ by a number that is not 0"
PLACE = "rational point, exact arithmetic", "the two sides differ", {}

SAID = {
    r"a \times b = -b \times a": [PRIME, flint(3, 6), SYMPY, DRAKE],
    r"u \cdot u = 1": [PRIME, flint(1, 3), SYMPY],
    r"f = g": [PLACE],
    r"\frac{f g}{f} = g": [
        PRIME,
        flint(1, 3),
        SYMPY,
        ("denominators", "not excluded by the assumptions", {"factors": 1}),
    ],
    r"\frac{f g}{f (f + 1)} = \frac{g}{f + 1}": [
        PRIME,
        flint(1, 4),
        SYMPY,
        ("denominators", "not excluded by the assumptions", {"factors": 3}),
    ],
    r"\frac{f^2 + f + 1}{f^2 + f + 1} = 1": [
        PRIME,
        flint(1, 2),
        SYMPY,
        ("denominators", "not excluded by the assumptions", {"factors": 1}),
    ],
    r"\frac{f}{f} = 1 \text{ for } f = 0": [
        flint(1, 2),
        SYMPY,
        ("denominators", "not excluded by the assumptions", {"factors": 1}),
    ],
    r"f \neq f + 1": [
        ("exact ring over ℚ (FLINT)", APART, {}),
        ("SymPy PolyRing on Python integers", APART, {}),
    ],
    r"f \neq 0": [PLACE],
    r"f^2 = 0 \Leftrightarrow f = 0": [flint(1, 1), SYMPY, flint(1, 1), SYMPY],
    r"f = 0 \Rightarrow f g = 0": [flint(1, 2), SYMPY],
    r"(R T R^T)^3 = R T^3 R^T": [
        PRIME,
        ("rotated frame", "holds where this does", {"relation": "T T T = T T T"}),
        flint(9, 9),
        SYMPY,
        DRAKE,
    ],
    r"f g = f g = g f": [
        PRIME,
        flint(1, 2),
        SYMPY,
        DRAKE,
        PRIME,
        flint(1, 2),
        SYMPY,
        DRAKE,
        (
            "trivial part",
            "both sides are the same term, so nothing is tested",
            {"formula": r"f g = f g"},
        ),
    ],
    r"\min_{x \in V_3} x^2 = 0": [
        (
            "least value",
            "the bound for all values, and where it is reached: 5 equations, residual is 0",
            {"engines": [method for method, _, _ in (PRIME, flint(1, 3), SYMPY, DRAKE)]},
        )
    ],
}


def told(verdict):
    return [(e.method, e.outcome, e.figures) for e in verdict.evidence]


@pytest.mark.parametrize("latex", SAID)
def test_the_evidence_lists_the_checks(latex):
    assert told(judged(latex)) == SAID[latex]


@pytest.mark.parametrize(
    "latex", [key for key, said in SAID.items() if flint(1, 3) in said or APART in said[0]]
)
def test_with_one_engine_it_is_the_first_one(latex):
    verdict = judged(latex, second_engine=False)
    assert verdict.outcome == Outcome.PROBABLE and verdict.reason == "second engine left out"
    assert told(verdict) == [said for said in SAID[latex] if "FLINT" in said[0]]


def test_under_a_hypothesis():
    verdict = judged("f g = g", hypothesis="f = 1")
    assert told(verdict) == [
        flint(1, 2),
        SYMPY,
        ("witness against the bare statement", "a point where it fails", {}),
    ]


ALL_N = "the n-th members are free functions, the next ones by recurrence"
FREE_N = "the n-th derivatives and the n-th members are free functions"
STEP = r"\frac{d}{dt} \Phi_{n+1} = \ddot{\Phi}_n + \frac{d}{dt} (\Phi_n \Phi_1)"
FAMILIES = {
    r"\Phi_{n+1} = \dot{\Phi}_n + \Phi_n \Phi_1": [
        ("definitions", "well-formed, and the one in force", {}),
        ("each instance", VANISHES, {"instances": 3}),
    ],
    STEP: [
        PRIME,
        flint(9, 33),
        SYMPY,
        ("all n at once", ALL_N, {}),
        ("each instance, exact ring", VANISHES, {"orders": "n = 1..3"}),
    ],
    r"(a + b)^{(n)} = a^{(n)} + b^{(n)}": [
        PRIME,
        flint(3, 6),
        SYMPY,
        DRAKE,
        ("all n at once", FREE_N, {}),
        ("each instance, exact ring", VANISHES, {"orders": "n = 1..3"}),
    ],
    r"\sum_{k=0}^{n} C_n^k f = 2^n f": [
        PRIME,
        flint(1, 1),
        SYMPY,
        DRAKE,
        ("each instance", VANISHES, {"instances": 3}),
    ],
    r"\det \Phi_n = 0": [PLACE, ("each instance", "fails for n = 2", {"held before": 1})],
    r"\det \Phi_n = f": [PLACE, ("each instance", "fails for n = 1", {"held before": 0})],
    r"f^n = f^n + f - f": [PRIME, flint(1, 1), SYMPY, DRAKE, ("each instance", VANISHES, {"instances": 3})],
}


@pytest.mark.parametrize("latex", FAMILIES)
def test_the_evidence_lists_the_checks_for_each_n(latex):
    verdict = judged(latex, orders=Orders.parse("n = 1..3"), definitions=PHI, table=PHI_TABLE)
    assert told(verdict) == FAMILIES[latex]


def test_a_member_that_says_nothing_hides_none_that_does():
    verdict = judged("f^n = f", orders=Orders.parse("n = 1..3"))
    assert (verdict.outcome, verdict.reason) == (Outcome.REFUTED, "for n = 2")
    assert told(verdict)[-1] == ("each instance", "fails for n = 2", {"held before": 0})
    verdict = judged("f^{n} = f^{n-1} f", orders=Orders.parse("n = 1..3"))
    assert verdict.outcome == Outcome.PROVED


@pytest.mark.parametrize(
    ("latex", "screened"),
    [("f g = g f", True), ("f = g", False), ("f g = f g + f - g", False), (r"\|a\|^2 = a^2", None)],
)
def test_a_random_point_tells_what_differs(latex, screened):
    (statement,) = read(latex, PHI_TABLE)
    equation = Equation(Judge(Definitions()), statement, ())
    assert equation.screen() is screened


FALSE_RECHECKS = [
    (consequences, "recheck", r"a \times b = -b \times a"),
    (drake_ring, "recheck_by_drake", r"a \times b = -b \times a"),
    (consequences, "recheck_distance", r"f \neq f + 1"),
]


@pytest.mark.parametrize(("module", "name", "latex"), FALSE_RECHECKS)
def test_a_result_of_one_engine_alone_is_a_disagreement(monkeypatch, module, name, latex):
    assert judged(latex).outcome == Outcome.PROVED
    monkeypatch.setattr(module, name, lambda *arguments: False)
    with pytest.raises(EngineDisagreement):
        judged(latex)


@pytest.mark.parametrize("latex", [r"a \times b = -b \times a", r"\dot{R} R^T = -R \dot{R}^T"])
def test_zero_in_the_first_engine_alone_is_a_disagreement(monkeypatch, latex):
    monkeypatch.setattr(Equation, "_at_random_point", lambda equation: False)
    with pytest.raises(EngineDisagreement, match="not modulo"):
        judged(latex)


def test_a_counterexample_of_the_jet_engine_alone_disagrees(monkeypatch):
    from workbench.engines.polynomial.polynomial_engine import ExactEngine

    monkeypatch.setattr(ExactEngine, "at", lambda *arguments: 0)
    with pytest.raises(EngineDisagreement, match="one engine only"):
        judged("f = g")
    with pytest.raises(EngineDisagreement, match="one engine only"):
        judged(r"\|a\| = f")
    assert judged("f = g", ["f = 1"]).outcome == Outcome.REFUTED


MEANS = {
    r"x = 2 y \text{ and } y = f \Rightarrow \cos x = \cos 2 f": [
        ("premise", "put in as a definition", {"formula": "x = 2 y"}),
        ("premise", "put in as a definition", {"formula": "y = f"}),
        PRIME,
        flint(1, 3),
        SYMPY,
    ],
    "e^{f} e^{g} = e^{f+g}": [
        PRIME,
        flint(1, 2),
        SYMPY,
        DRAKE,
        ("exponentials", "any functions E that are nowhere 0, with the rates of e^x", {}),
    ],
    r"\sin \delta \approx \delta": [
        PRIME,
        flint(2, 1),
        SYMPY,
        ("dual numbers", r"to first order in \delta and their rates, taken together", {}),
    ],
    r"\sin \delta \approx 2 \delta": [
        PLACE,
        ("dual numbers", r"to first order in \delta and their rates, taken together", {}),
    ],
    r"\sin f = f": [("real balls (Arb)", "the two sides differ", {})],
    r"S = \{ a \in V_3 \mid a \cdot b = 0 \}": [("sets and maps", "well-formed", {})],
    r"h : V_3 \to \mathbb{R}, h(a) = a \cdot b": [("sets and maps", "well-formed", {})],
}


@pytest.mark.parametrize("latex", MEANS)
def test_the_evidence_lists_other_methods(latex):
    symbols = {name: "vector" for name in "ab"} | {name: "scalar" for name in "fgxy"}
    found = check(latex, symbols=symbols | {r"\delta": {"kind": "scalar", "small": True}})
    assert told(found.verdict) == MEANS[latex]


@pytest.mark.parametrize("definition", [r"k = e^{f} g", "k = f g"])
def test_a_definition_rests_on_itself(definition):
    found = check(definition, symbols={"f": "scalar", "g": "scalar"}, definitions=[definition]).verdict
    assert found.outcome == Outcome.DEFINITION
    assert told(found) == [("definitions", "well-formed, and the one in force", {})]


WHY = {
    r"\delta \approx f": "to first order the sides differ; to order 0 is open",
    r"S = \{ a \in V_3 \mid a \cdot a = -1 \}": "the set is empty: nothing satisfies its conditions",
    r"h : V_3 \to \mathbb{R}, h(a) = \frac{1}{\|a\|}": r"\frac{1}{\left\|a\right\|} is not seen to be defined for all of "
    r"these: the denominator \left\|a\right\| can vanish, and nothing that the claim assumes excludes it",
}


@pytest.mark.parametrize("latex", WHY)
def test_why_it_is_open(latex):
    symbols = {"a": "vector", "f": "scalar", r"\delta": {"kind": "scalar", "small": True}}
    found = check(latex, symbols=symbols).verdict
    assert (found.outcome, found.reason) == (Outcome.UNCHECKED, WHY[latex])
