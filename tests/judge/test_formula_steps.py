"""Steps from formulas: what holds is shown, what is false is not, and a control that holds is noticed."""

import pytest

from workbench.judge.theorems.arguments import Engine, argue
from workbench.judge.theorems.formula_steps import Letters
from workbench.judge.verdict import Outcome
from workbench.language.typed.errors import IllFormedAt, ReadError

LETTERS = Letters(
    {
        "a": {"kind": "vector"},
        "b": {"kind": "vector"},
        r"\omega": {"kind": "vector"},
        "R": {"kind": "rotation"},
        "s": {"kind": "dual scalar"},
        "f": {"kind": "scalar"},
    },
    {r"\Phi_1": r"\tilde{\omega}", r"\Phi_{n+1}": r"\dot{\Phi}_n + \Phi_n \Phi_1"},
)
FALSE = r"a \times b = f b"


def outcome(*formulas, but_not=FALSE, orders=None):
    return argue([LETTERS.step("shown", *formulas, but_not=but_not, orders=orders)])


@pytest.mark.parametrize(
    "formula",
    [
        r"a \times b = -b \times a",
        r"(R a) \times (R b) = R (a \times b)",
        r"\tilde{a} \tilde{b} - \tilde{b} \tilde{a} = \widetilde{a \times b}",
        r"\frac{d}{dt}(a \cdot b) = \dot{a} \cdot b + a \cdot \dot{b}",
        r"(s + \varepsilon f)^2 = s^2 + 2 \varepsilon s f",
        r"a \cdot a = a^2 = \|a\|^2",
        r"\frac{a}{f} f = a",
    ],
)
def test_what_holds_is_proved_by_two_engines(formula):
    verdict = outcome(formula)
    assert verdict.outcome == Outcome.PROVED, verdict.reason
    assert [e.method for e in verdict.evidence] == [str(Engine.FLINT), str(Engine.SYMPY)]
    assert all(e.figures["checks"] > 0 for e in verdict.evidence)


@pytest.mark.parametrize("formula", [FALSE, r"a^2 = b^2", r"\dot{R} = R", r"\varepsilon f = f"])
def test_what_is_false_is_not_proved(formula):
    control = r"a = b" if formula == FALSE else FALSE
    assert outcome(formula, but_not=control).outcome == Outcome.UNCHECKED


def test_each_of_several_formulas_counts():
    assert outcome(r"a \times a = 0", r"a \cdot b = b \cdot a").outcome == Outcome.PROVED
    assert outcome(r"a \times a = 0", r"a \cdot b = b^2").outcome == Outcome.UNCHECKED


def test_a_control_that_holds_is_a_defect():
    verdict = outcome(r"a \times a = 0", but_not=r"b \times b = 0")
    assert verdict.outcome == Outcome.UNCHECKED and "tests nothing" in verdict.reason


def test_every_order_of_a_family_is_checked():
    split = r"\Phi_n = \operatorname{sym} \Phi_n + \widetilde{\operatorname{vect} \Phi_n}"
    skew = r"\operatorname{sym} \Phi_n = 0"
    assert outcome(split, but_not=skew, orders={"n": range(1, 5)}).outcome == Outcome.PROVED
    # true for n = 1, false for n = 2
    assert outcome(skew, but_not=r"\Phi_n = 0", orders={"n": [1]}).outcome == Outcome.PROVED
    assert outcome(skew, but_not=r"\Phi_n = 0", orders={"n": [1, 2]}).outcome == Outcome.UNCHECKED


@pytest.mark.parametrize(
    ("formula", "error"),
    [
        (r"a \Phi_1 = 0", IllFormedAt),
        (r"a + c = 0", ReadError),
        (r"a \neq b", ValueError),
        (r"a = 0 \Rightarrow b = 0", ValueError),
    ],
)
def test_only_equations_make_a_step(formula, error):
    with pytest.raises(error):
        outcome(formula)
    with pytest.raises(error):
        outcome(r"a = a", but_not=formula)


@pytest.mark.parametrize(
    ("formula", "control"),
    [
        (r"a \times b = -b \times a", r"a \times b = b \times a"),
        (r"a \times b + b \times a = 0", r"a \times b = b \times a"),
        (r"(a + b)^2 = a^2 + 2 a \cdot b + b^2", r"b^2 - 2 a \cdot b = (a + b)^2 - a^2"),
        (r"\tilde{a} b = a \times b", r"\tilde{a} b = b \times a"),
        (r"\tilde{a}^T = -\tilde{a}", r"\tilde{a}^T = \tilde{a}"),
        (r"(-1) f = -f", r"(-1) f = f"),
    ],
)
def test_a_control_that_flips_signs_alone_is_refused(formula, control):
    with pytest.raises(ValueError, match="more than signs"):
        LETTERS.step("shown", formula, but_not=control)


@pytest.mark.parametrize(
    ("formula", "control"),
    [
        (r"(R a)^2 = a^2", r"(R^T b)^2 = a^2"),
        (r"\Phi_2 = \dot{\Phi}_1 + \Phi_1^2", r"\Phi_2 = \dot{\Phi}_1"),
        (r"2 f = f + f", r"3 f = f + f"),
        (r"\frac{d}{dt}(R a) = \dot{R} a + R \dot{a}", r"\frac{d}{dt}(R a) = \dot{R} a + R a"),
    ],
)
def test_a_control_of_substance_is_kept(formula, control):
    assert argue([LETTERS.step("shown", formula, but_not=control)]).outcome == Outcome.PROVED
