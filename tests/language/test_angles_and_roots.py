"""Fractions of angles, tangents and square roots."""

from __future__ import annotations

import pytest

from workbench import check
from workbench.core.formula_errors import ReadError
from workbench.core.verdict import Outcome

SYMBOLS = {
    **{name: "scalar" for name in (r"\theta", r"\phi", "f", "g")},
    "u": {"kind": "vector", "unit": True},
    "v": "vector",
    "q": "hamilton quaternion",
}
HALF = r"\cos\frac{\theta}{2}, \sin\frac{\theta}{2} u"


@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"\sin^2 \frac{\theta}{2} = \frac{1 - \cos\theta}{2}", Outcome.PROVED),
        (r"\sin^2 \frac{\theta}{2} = \frac{1 + \cos\theta}{2}", Outcome.REFUTED),
        (r"\sin^2 \theta = \frac{1 - \cos\theta}{2}", Outcome.REFUTED),
        (r"\tan\frac{\theta}{2} = \frac{\sin\theta}{1+\cos\theta}", Outcome.CONDITIONAL),
        (r"\frac{d}{dt} \tan\theta = \frac{\dot{\theta}}{\cos^2 \theta}", Outcome.CONDITIONAL),
        (r"\frac{d}{dt} \cos\frac{\theta}{2} = -\dot{\theta} \sin\frac{\theta}{2}", Outcome.REFUTED),
        (r"\exp(\frac{\theta}{2} \tilde{u}) \exp(\frac{\theta}{2} \tilde{u}) = \exp(\theta \tilde{u})", Outcome.PROVED),
        (rf"\operatorname{{Vec}}([{HALF}] v [{HALF}]^*) = \exp(\theta \tilde{{u}}) v", Outcome.PROVED),
        (rf"\operatorname{{Vec}}([{HALF}]^* v [{HALF}]) = \exp(\theta \tilde{{u}}) v", Outcome.REFUTED),
        (r"\sin((1 - f)\theta) = \sin\theta \cos(f\theta) - \cos\theta \sin(f\theta)", Outcome.PROVED),
        (r"\sin((1 - f)\theta) = \sin\theta \cos(f\theta) + \cos\theta \sin(f\theta)", Outcome.REFUTED),
        (r"\cos((3 - \frac{f}{2})\theta + \phi) = \cos(3\theta + \phi - \theta f/2)", Outcome.PROVED),
        (r"\sin(\theta \cos\phi) = \sin(\phi \cos\theta)", Outcome.UNCHECKED),
        (r"\cos(\|v + u \sin\theta\|) = 1", Outcome.UNCHECKED),
        (r"\sqrt{f^2} = f", Outcome.REFUTED),
        (r"(f^2 + g^2)^{3/2} = (f^2 + g^2) \sqrt{f^2 + g^2}", Outcome.PROVED),
        (r"(1 + f^2)^{-\frac12} = \frac{1}{\sqrt{1 + f^2}}", Outcome.PROVED),
        (r"(v \cdot v)^{1/2} = \|v\|", Outcome.PROVED),
        (r"(f^2)^{1/2} = f", Outcome.REFUTED),
        (r"v^{1/2} = v", Outcome.ILL_FORMED),
        (r"\sqrt{f^2 + g^2} = f + g", Outcome.REFUTED),
        (r"|q| = \sqrt{(\operatorname{Sc} q)^2 + (\operatorname{Vec} q)^2}", Outcome.PROVED),
        (r"\sqrt{f} \sqrt{f} = f", Outcome.UNCHECKED),
        (r"\theta = 2 \sin\frac{\theta}{2}", Outcome.REFUTED),
        (r"\cos\theta^2 + \sin\theta^2 = 1", Outcome.UNCHECKED),
    ],
)  # fmt: skip
def test_verdicts(formula: str, outcome: Outcome) -> None:
    assert check(formula, SYMBOLS).outcome == outcome


def test_a_part_of_a_defined_angle() -> None:
    definitions = {r"\psi": r"\theta + \frac{\phi}{3}"}
    said = check(
        r"\cos\psi = \cos\theta \cos\frac{\phi}{3} - \sin\theta \sin\frac{\phi}{3}",
        SYMBOLS,
        definitions=definitions,
    )
    assert said.outcome == Outcome.PROVED


@pytest.mark.parametrize("formula", [r"\sqrt[3]{f} = f", r"\sqrt{} = f", r"\sqrt{v} = f"])
def test_roots_that_cannot_be_read(formula: str) -> None:
    try:
        assert check(formula, SYMBOLS).outcome == Outcome.ILL_FORMED
    except ReadError as error:
        assert "square root" in str(error) or "expected" in str(error)


RATES = ["2", "3", r"\frac{1}{2}", r"\frac{2}{3}", r"(f + \frac{1}{2})"]


@pytest.mark.parametrize("rate", RATES)
@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"\frac{d}{dt} \sin({0} t) = {0} \cos({0} t)", Outcome.PROVED),
        (r"\frac{d}{dt} \sin({0} t) = \cos({0} t)", Outcome.REFUTED),
        (r"\frac{d}{dt} \cos({0} t) = -{0} \cdot 2 \sin({0} t)", Outcome.REFUTED),
        (r"\frac{d^2}{dt^2} \cos({0} t + g) = -{0}^2 \cos({0} t + g)", Outcome.PROVED),
        (r"\frac{d}{dt} \exp({0} t \tilde{u}) = {0} \tilde{u} \exp({0} t \tilde{u})", Outcome.PROVED),
        (r"\frac{d}{dt} \exp({0} t \tilde{u}) = \tilde{u} \exp({0} t \tilde{u})", Outcome.REFUTED),
        (r"\cos({0} t) \cos t - \sin({0} t) \sin t = \cos({0} t + t)", Outcome.PROVED),
        (r"\frac{d}{dt} (t \sin\frac{t}{3} \cos({0} t)) = \sin\frac{t}{3} \cos({0} t) + \frac{t}{3} \cos\frac{t}{3} \cos({0} t) - {0} t \sin\frac{t}{3} \sin({0} t)", Outcome.PROVED),
    ],
)  # fmt: skip
def test_the_time_in_an_angle_goes_on_at_one(formula: str, outcome: Outcome, rate: str) -> None:
    symbols = {
        **{name: {"kind": "scalar", "constant": True} for name in "fg"},
        "u": {"kind": "vector", "unit": True, "constant": True},
    }
    assert check(formula.replace("{0}", rate), symbols=symbols).outcome is outcome


def test_the_rate_of_a_constant_is_nothing_to_differentiate_by() -> None:
    formula = r"\frac{\partial}{\partial\dot\theta} (\dot\theta \cos\theta) = \cos\theta"
    with pytest.raises(ReadError, match="by the rate of a constant"):
        check(formula, symbols={r"\theta": {"kind": "scalar", "constant": True}})
    assert check(formula, symbols={r"\theta": "scalar"}).outcome is Outcome.PROVED
