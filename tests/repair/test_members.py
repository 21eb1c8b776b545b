"""A false membership is mended in its member, or not at all."""

from __future__ import annotations

import pytest

from workbench import check
from workbench.core.verdict import Outcome
from workbench.repair.terms.false_members import membership

SYMBOLS = {
    "R": "rotation", "S": "rotation", "T": "tensor", "a": "vector", "b": "vector", "p": "vector",
    "u": {"kind": "vector", "unit": True}, "v": {"kind": "vector", "unit": True},
}  # fmt: skip
#: true → false, by one misprint
DAMAGED = {
    r"R S \in SO(3)": [r"-R S \in SO(3)", r"2 R S \in SO(3)", r"R S + \tilde{a} \in SO(3)"],
    r"R \tilde{a} R^{T} \in so(3)": [r"R \tilde{a} R \in so(3)"],
    r"\dot{R} R^{T} \in so(3)": [r"\dot{R} R \in so(3)"],
    r"-a \otimes b + b \otimes a \in so(3)": [r"a \otimes b + b \otimes a \in so(3)"],
    r"\begin{bmatrix} R & p \\ \mathbf{0} & 1 \end{bmatrix} \in SE(3)": [
        r"\begin{bmatrix} 2 R & p \\ 0 & 1 \end{bmatrix} \in SE(3)"
    ],
}
BEYOND = [
    r"R + S \in SO(3)",
    r"R T \in SO(3)",
    r"\tilde{a} \tilde{b} \in so(3)",
    r"u \times v \in S^2",
    r"2 R \in SO(3)",  # what is declared to be a member says nothing
    r"T T^T \in SO(3)",  # and so does I
]


@pytest.mark.parametrize(("right", "wrong"), [(right, each) for right in DAMAGED for each in DAMAGED[right]])
def test_the_member_is_mended_in_all_equations_that_say_it(right, wrong):
    assert check(wrong, symbols=SYMBOLS).outcome is Outcome.REFUTED
    proposed = [each.latex for each in check(wrong, symbols=SYMBOLS).repair().proposals]
    assert right in proposed
    for latex in proposed:
        _, where = membership(latex)
        assert where.strip() == membership(wrong)[1].strip()
        assert check(latex, symbols=SYMBOLS).outcome is Outcome.PROVED


@pytest.mark.parametrize("latex", BEYOND)
def test_no_repair_dresses_a_falsehood_up(latex):
    checked = check(latex, symbols=SYMBOLS)
    assert checked.outcome is Outcome.REFUTED and not checked.repair().proposals


@pytest.mark.parametrize(
    "latex", [r"R S = S R", r"a \cdot b = b \cdot a, R S \in SO(3)", r"R S \in SO(3) = T"]
)
def test_compound_formulas_are_no_memberships(latex):
    assert membership(latex) is None
