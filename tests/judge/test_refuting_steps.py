"""Steps that say a formula is false: they stand for false ones, and for nothing else."""

import pytest

from workbench.judge.theorems.arguments import argue
from workbench.judge.theorems.formula_steps import Letters
from workbench.judge.verdict import Counterexample, Outcome

LETTERS = Letters({"a": {"kind": "vector"}, "b": {"kind": "vector"}, "R": {"kind": "rotation"}})
FALSE = (r"a \times b = b \times a", r"R a = a", r"(a \cdot b)^2 = a^2 b^2")
EXAMPLE = Counterexample({"a": ("1", "0", "0"), "b": ("0", "1", "0")}, ("0", "0", "1"), ("0", "0", "-1"))
TRUE = (r"a \times b = -b \times a", r"R^T R a = a", r"(a \cdot b)^2 + (a \times b)^2 = a^2 b^2")


def outcome(formula: str, but_not: str) -> Outcome:
    step = LETTERS.refutation("it does not hold", formula, but_not)
    return argue([step], refutes=True, counterexample=EXAMPLE).outcome


@pytest.mark.parametrize("false", FALSE)
@pytest.mark.parametrize("true", TRUE)
def test_false_formulas_are_refuted(false, true):
    assert outcome(false, true) == Outcome.REFUTED


@pytest.mark.parametrize("true", TRUE)
def test_true_formulas_are_not(true):
    assert outcome(true, TRUE[0]) == Outcome.UNCHECKED


@pytest.mark.parametrize("false", FALSE)
def test_a_false_control_tests_nothing(false):
    assert outcome(FALSE[0], false) == Outcome.UNCHECKED
