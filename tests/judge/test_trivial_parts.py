"""A part of a chain or of a system whose two sides are the same term: the other parts decide, and it is said."""

import pytest

from workbench import check
from workbench.core.verdict import Outcome

SYMBOLS = {"a": "vector", "b": "vector", "f": "scalar", "T": "tensor", "F_n": "tensor"}
WITH_ONE = [
    (r"a \times b = {} -b \times a", r"a \times b =", Outcome.PROVED),
    (r"a \times b = -b \times a {}", r"= -b \times a", Outcome.PROVED),
    (r"a \times b = {} b \times a", r"a \times b =", Outcome.REFUTED),
    (r"{} a \times a = \mathbf{{0}}", r"f = f,", Outcome.PROVED),
    (r"{} \frac{{f}}{{f}} = 1", r"f = f,", Outcome.CONDITIONAL),
]


def verdict(formula, orders=None):
    return check(formula, symbols=SYMBOLS, orders=orders).verdict


@pytest.mark.parametrize(("formula", "part", "found"), WITH_ONE)
def test_the_other_parts_decide(formula, part, found):
    without, whole = verdict(formula.format("")), verdict(formula.format(part))
    assert without.outcome == whole.outcome == found
    said = [e.method for e in whole.evidence]
    assert said.count("trivial part") == 1 and "trivial part" not in [e.method for e in without.evidence]


@pytest.mark.parametrize("formula", ["a = a", "a = a = a", "a = a, f = f", r"f \neq 0 \Rightarrow a = a"])
def test_a_fully_trivial_claim_is_not_proved(formula):
    assert verdict(formula).outcome == Outcome.UNCHECKED


@pytest.mark.parametrize("part", [r"\frac{1}{f} = \frac{1}{f}", "T^{-1} = T^{-1}"])
def test_a_trivial_part_is_defined_or_the_whole_is_not_proved(part):
    assert verdict(rf"{part}, a \times a = \mathbf{{0}}").outcome == Outcome.CONDITIONAL


def test_a_chain_for_many_n():
    found = verdict(r"F_n F_1 = F_n F_1 = F_n F_1 + F_n - F_n", orders="n = 1..3")
    assert (found.outcome, found.scope) == (Outcome.PROVED, "all n")
    assert verdict("F_n = F_n", orders="n = 1..3").outcome == Outcome.UNCHECKED
