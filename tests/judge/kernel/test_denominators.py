"""Denominators that a condition keeps from vanishing, however deep they stand, and those that none does."""

from judge.test_judge import judged

from workbench import check
from workbench.core.verdict import Outcome


def test_conditional_verdicts_have_evidence_of_both_engines():
    evidence = [e.method for e in judged(r"\frac{f g}{f} = g").evidence]
    assert any("FLINT" in method for method in evidence) and any("SymPy" in method for method in evidence)


def test_a_half_turn_is_looked_at():
    """cos θ = -1 is the one point of a circle that no rational slope gives: μ h² + C cos θ vanishes there."""
    positive = {"kind": "scalar", "positive": True, "constant": True}
    symbols = {"m": positive, "C": positive, "h": positive, r"\theta": "scalar", "x": "scalar"}
    formula = r"\frac{x}{m + \frac{C}{h^2} \cos\theta} = \frac{h^2 x}{h^2 m + C \cos\theta}"
    verdict = check(formula, symbols=symbols).verdict
    assert verdict.outcome is Outcome.CONDITIONAL
    assert verdict.counterexample.values[r"\cos \theta"] == ("-1",)
