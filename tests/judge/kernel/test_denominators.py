"""Denominators that a condition keeps from vanishing, however deep they stand, and those that none does."""

import pytest
from judge.test_judge import judged

from workbench import check
from workbench.context.index_values import Orders
from workbench.core.verdict import Outcome

NESTED = [
    (r"\frac{1}{1 - \frac{1}{f}} = \frac{f}{f-1}", [r"f \neq 0", r"f \neq 1"]),
    (r"\frac{1}{\frac{1}{f} + \frac{1}{g}} = \frac{f g}{f + g}", [r"f \neq 0", r"g \neq 0", r"f + g \neq 0"]),
    (r"\frac{\frac{f}{g}}{\frac{g}{f}} = \frac{f^2}{g^2}", [r"f \neq 0", r"g \neq 0"]),
    (r"\frac{1}{1 - \frac{1}{1 - \frac{1}{f}}} = 1 - f", [r"f \neq 0", r"f \neq 1"]),
    (r"\frac{a \cdot b}{\|a\| \|b\|} = \frac{b \cdot a}{\|b\| \|a\|}", [r"a \neq 0", r"b \neq 0"]),
    (r"\frac{(a \cdot b)^2}{(\|a\| \|b\|)^2} = \frac{(a \cdot b)^2}{a^2 b^2}", [r"a \neq 0", r"b \neq 0"]),
    (r"\frac{a}{\|a\|} \cdot \frac{a}{\|a\|} = 1", [r"\|a\| \neq 0"]),
    (r"\frac{a \cdot a}{\|a\|} = \|a\|", [r"a \cdot a \neq 0"]),
    (r"\frac{f}{f^2 g} = \frac{1}{f g}", [r"f g \neq 0"]),
]


@pytest.mark.parametrize(("latex", "assume"), NESTED)
def test_an_excluded_zero_leaves_no_condition(latex, assume):
    assert judged(latex, assume).outcome == Outcome.PROVED


@pytest.mark.parametrize(("latex", "assume"), NESTED)
def test_each_condition_is_needed(latex, assume):
    for missing in assume:
        verdict = judged(latex, [a for a in assume if a != missing])
        assert verdict.outcome in (Outcome.CONDITIONAL, Outcome.UNCHECKED), missing


@pytest.mark.parametrize(
    ("latex", "assume", "orders", "outcome"),
    [
        ("f^{-n} f^n = 1", [r"f \neq 0"], "n = 0..4", Outcome.PROVED),
        ("f^{-n} f^n = 1", [], "n = 1..4", Outcome.CONDITIONAL),
        ("f^{n-2} f^2 = f^n", [r"f \neq 0"], "n = 0..4", Outcome.PROVED),
        (r"T^{-n} T^n = \mathbf{I}", [r"\det T \neq 0"], "n = 0..2", Outcome.PROVED),
        (r"R^{-n} = (R^T)^n", [], "n = 0..3", Outcome.PROVED),
        ("f^{-n} f^n = f", [r"f \neq 0"], "n = 0..4", Outcome.REFUTED),
        ("f^{-n} = -f^n", [r"f \neq 0"], "n = 1..2", Outcome.REFUTED),
    ],
)
def test_negative_powers(latex, assume, orders, outcome):
    assert judged(latex, assume, orders=Orders.parse(orders)).outcome == outcome


def test_conditional_verdicts_have_evidence_of_both_engines():
    evidence = [e.method for e in judged(r"\frac{f g}{f} = g").evidence]
    assert any("FLINT" in method for method in evidence) and any("SymPy" in method for method in evidence)


@pytest.mark.parametrize(
    ("denominator", "outcome"),
    [
        ("f^2 + 1", Outcome.PROVED),
        ("3 f^2 g^4 + g^2 + 2", Outcome.PROVED),
        (r"a \cdot a + 1", Outcome.PROVED),
        ("f^2", Outcome.CONDITIONAL),
        ("f^2 + g^2", Outcome.CONDITIONAL),
        ("f^2 - 1", Outcome.CONDITIONAL),
        ("f + 1", Outcome.CONDITIONAL),
        ("1 - f^2 g^2", Outcome.CONDITIONAL),
    ],
)
def test_a_positive_number_and_squares_need_no_condition(denominator, outcome):
    assert (
        judged(rf"\frac{{h ({denominator})}}{{{denominator}}} = h".replace("h", "(a, b, c)")).outcome
        == outcome
    )


MASSES = {name: {"kind": "scalar", "positive": True} for name in "mk"} | dict.fromkeys("fghuw", "scalar")


@pytest.mark.parametrize(
    ("denominator", "holds"),
    [
        (r"m + k \sin^2 f", True),
        (r"m + k (1 - \cos^2 f)", True),
        (r"m + k \cos^2 f + k \sin^2 g", True),
        (r"m + k \sin^2 f \cos^2 g", True),
        (r"2 m k + m^2 \sin^2 f", True),
        (r"u^2 \sin^2 f + m", True),
        (r"m - k \sin^2 f", False),
        (r"m \sin^2 f", False),
        (r"m + w \sin^2 f", False),
        (r"m + k \sin f", False),
        (r"u^2 + k \sin^2 f", False),
    ],
)
def test_positive_numbers_and_squares_of_sines_need_no_condition(denominator, holds):
    latex = rf"\frac{{h ({denominator})}}{{{denominator}}} = h"
    outcome = check(latex, symbols=MASSES).outcome
    assert outcome == Outcome.PROVED if holds else outcome in (Outcome.CONDITIONAL, Outcome.UNCHECKED)


def test_a_half_turn_is_looked_at():
    """cos θ = -1 is the one point of a circle that no rational slope gives: μ h² + C cos θ vanishes there."""
    positive = {"kind": "scalar", "positive": True, "constant": True}
    symbols = {"m": positive, "C": positive, "h": positive, r"\theta": "scalar", "x": "scalar"}
    formula = r"\frac{x}{m + \frac{C}{h^2} \cos\theta} = \frac{h^2 x}{h^2 m + C \cos\theta}"
    verdict = check(formula, symbols=symbols).verdict
    assert verdict.outcome is Outcome.CONDITIONAL
    assert verdict.counterexample.values[r"\cos \theta"] == ("-1",)


@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"\frac{d}{dt} (b + \exp(\tilde{a}) c) - \frac{d}{dt} (\exp(\tilde{a}) c) = \dot b", Outcome.PROVED),
        (r"\frac{d}{dt} (\exp(\tilde{a}) a) = \dot a", Outcome.PROVED),
        (r"\frac{\partial}{\partial f} (f \exp(\tilde{u}) w) = \exp(\tilde{u}) w", Outcome.PROVED),
        (r"\frac{\partial}{\partial f} (f \exp(\tilde{u}) w) = \exp(-\tilde{u}) w", Outcome.REFUTED),
        (r"\frac{d}{dt} (\|a\| \exp(\tilde{a}) a) = \frac{d}{dt} (\|a\| a)", Outcome.CONDITIONAL),
        (r"\frac{d}{dt} (\|a\| + a \cdot \exp(\tilde{a}) a) = \frac{d}{dt} (\|a\| + a \cdot a)", Outcome.CONDITIONAL),
        (r"\frac{d}{dt} (\exp(\tilde{a}) a \cdot c + \sin\|a\|) = \frac{d}{dt} (a \cdot c + \sin\|a\|)", Outcome.CONDITIONAL),
        (r"\frac{d}{dt} (\exp(\tilde{a}) a \frac{1}{a \cdot a}) = \frac{d}{dt} (\frac{a}{a \cdot a})", Outcome.CONDITIONAL),
    ],
)  # fmt: skip
def test_a_turn_is_smooth_where_its_vector_vanishes(formula, outcome):
    """The derivative of ‖a‖ is none at a = 0, but of exp ã it is a limit there."""
    constant = {"kind": "vector", "constant": True}
    symbols = dict.fromkeys("abc", "vector") | {"f": {"kind": "scalar", "independent": True}}
    symbols |= dict.fromkeys("uw", constant)
    assert check(formula, symbols=symbols).outcome is outcome
