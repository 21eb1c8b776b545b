"""∇ of fields: the identities of vector analysis, of any smooth fields and of given ones, and what is refused."""

from __future__ import annotations

import pytest

from workbench import check
from workbench.core.verdict import Outcome

SYMBOLS = {
    "x": {"kind": "vector", "coordinate": True},
    "f": {"kind": "scalar", "of": ["x"]},
    "g": {"kind": "scalar", "of": ["x"]},
    "u": {"kind": "vector", "of": ["x"]},
    "v": {"kind": "vector", "of": ["x"]},
    "a": {"kind": "vector", "uniform": True},
    "c": {"kind": "scalar", "uniform": True},
    "q": {"kind": "matrix 2×1", "independent": True},
    "V": {"kind": "scalar", "of": ["q"]},
    "T": {"kind": "tensor", "uniform": True},
    "h": "scalar",
}
OF_ANY_FIELDS = [
    r"\nabla (f g) = f \nabla g + g \nabla f",
    r"\nabla \times \nabla f = 0",
    r"\nabla \cdot (\nabla \times v) = 0",
    r"\nabla \cdot \nabla \times v = 0",
    r"\nabla \cdot (f v) = v \cdot \nabla f + f \nabla \cdot v",
    r"\nabla \times (f v) = \nabla f \times v + f \nabla \times v",
    r"\nabla \cdot (u \times v) = v \cdot (\nabla \times u) - u \cdot (\nabla \times v)",
    r"\nabla (u \cdot v) = (u \cdot \nabla) v + (v \cdot \nabla) u + u \times (\nabla \times v) + v \times (\nabla \times u)",
    r"\nabla \times (u \times v) = u (\nabla \cdot v) - v (\nabla \cdot u) + (v \cdot \nabla) u - (u \cdot \nabla) v",
    r"(v \cdot \nabla) v = \frac{1}{2} \nabla (v \cdot v) - v \times (\nabla \times v)",
    r"(u \cdot \nabla) f = u \cdot \nabla f",
    r"\nabla^2 f = \nabla \cdot (\nabla f + a)",
    r"\nabla^2 (f g) = f \nabla^2 g + 2 \nabla f \cdot \nabla g + g \nabla^2 f",
    r"\nabla (a \cdot v) = (a \cdot \nabla) v + a \times (\nabla \times v)",
]
OF_GIVEN_FIELDS = [
    r"\nabla \cdot x = 3",
    r"\nabla \cdot (\dot{a} \times x) = 0",
    r"\nabla \times x = 0",
    r"\nabla \times (a \times x) = 2 a",
    r"\nabla (a \cdot x) = a",
    r"\nabla \|x\|^2 = 2 x",
    r"(a \cdot \nabla) x = a",
    r"\nabla \cdot (a \times x) = \operatorname{div}(a \times x)",
    r"\nabla \times (T x) = \operatorname{curl}(T x)",
    r"\nabla \cdot (T x) = \operatorname{tr} T",
    r"\nabla^2 \|x\|^2 = 6",
    r"\nabla_x (f + g) = \boldsymbol{\nabla} f + \vec{\nabla} g",
    r"\nabla_q (q \cdot q + V) = 2 q + \nabla_q V",
]
FALSE = [
    r"\nabla (f g) = f \nabla g - g \nabla f",
    r"\nabla \times v = 0",
    r"\nabla \cdot (f v) = f \nabla \cdot v",
    r"\nabla \cdot (u \times v) = v \cdot (\nabla \times u) + u \cdot (\nabla \times v)",
    r"\nabla \times (u \times v) = u (\nabla \cdot v) - v (\nabla \cdot u)",
    r"(v \cdot \nabla) v = \frac{1}{2} \nabla (v \cdot v)",
    r"\nabla \times (a \times x) = a",
    r"\nabla^2 (f g) = f \nabla^2 g + g \nabla^2 f",
]


@pytest.mark.parametrize("latex", OF_ANY_FIELDS + OF_GIVEN_FIELDS)
def test_the_identities_of_vector_analysis(latex):
    verdict = check(latex, symbols=SYMBOLS)
    assert verdict.outcome is Outcome.PROVED, verdict


@pytest.mark.parametrize("latex", FALSE)
def test_false_derivatives_of_fields_are_refuted(latex):
    assert check(latex, symbols=SYMBOLS).outcome is Outcome.REFUTED


def test_proposals_keep_the_coordinate():
    found = check(r"\nabla \times (a \times x) = a", symbols=SYMBOLS).repair().proposals
    assert found and all(r"\partial x" in each.latex for each in found)
