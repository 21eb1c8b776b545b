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


@pytest.mark.parametrize(
    ("latex", "message"),
    [
        (r"\nabla v = 0", "which index is that of ∇"),
        (r"\nabla T = 0", "which index is that of ∇"),
        (r"\nabla f g = 0", "how far does ∇ reach"),
        (r"\nabla \cdot u \times v = 0", "how far does ∇ reach"),
        (r"u \times \nabla \times v = 0", "what does ∇ act on"),
        (r"u \cdot \nabla \cdot v = 0", "what does ∇ act on"),
        (r"\nabla = 0", "∇ of what"),
        (r"(u \cdot \nabla) = 0", "∇ of what"),
        (r"\nabla (f)^2 = 0", "a power of the derivative"),
        (r"\nabla^2 v = 0", "a power of ∇"),
        (r"\nabla^3 f = 0", "a power of ∇"),
        (r"\nabla_h f = 0", "a column that is a symbol"),
        (r"\nabla' f = 0", "a prime on ∇"),
        (r"u (\nabla f) = 0", "a function at another place"),
        (r"\nabla f \cdot g = 0", "how far does gradient reach"),
        (r"\nabla^2 f \cdot v = 0", "how far does ∇ reach"),
    ],
)
def test_ambiguous_derivatives_of_fields_are_rejected(latex, message):
    with pytest.raises(ValueError, match=message):
        check(latex, symbols=SYMBOLS)


@pytest.mark.parametrize("latex", [r"\nabla \cdot f = 0", r"\nabla \times c = 0", r"\nabla \cdot q = 0"])
def test_ill_typed_derivatives_of_fields_are_ill_formed(latex):
    assert check(latex, symbols=SYMBOLS).outcome is Outcome.ILL_FORMED


@pytest.mark.parametrize(
    ("latex", "why"),
    [
        (r"\nabla h = 0", "h in the partial derivative may depend on it"),
        (r"\nabla \cdot \dot{x} = 0", "the rate of x depends on the place"),
        (r"\nabla \dot{f} = 0", "the rate of f depends on the place"),
        (r"\nabla \cdot (\mathbf{D} v) = 0", "the rate of v depends on the place"),
    ],
)
def test_symbols_that_may_depend_on_position_are_not_constant(latex, why):
    verdict = check(latex, symbols=SYMBOLS)
    assert verdict.outcome is Outcome.UNCHECKED and why in verdict.verdict.reason


def test_proposals_keep_the_coordinate():
    found = check(r"\nabla \times (a \times x) = a", symbols=SYMBOLS).repair().proposals
    assert found and all(r"\partial x" in each.latex for each in found)


def test_the_place_is_to_be_declared():
    known = {name: SYMBOLS[name] for name in ("q", "V")}
    for symbols in (known, known | {"x": SYMBOLS["x"], "y": SYMBOLS["x"]}):
        with pytest.raises(ValueError, match="∇ by which place"):
            check(r"\nabla V = 0", symbols=symbols)
