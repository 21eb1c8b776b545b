"""Fractions of angles, tangents and square roots."""

from __future__ import annotations

import pytest

from workbench import check
from workbench.core.verdict import Outcome

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
