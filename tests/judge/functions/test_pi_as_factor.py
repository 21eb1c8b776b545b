"""Formulas in which π is a factor: refuted at the number π, and never because of another value of it."""

from __future__ import annotations

import pytest

from workbench import check
from workbench.core.verdict import Outcome

SYMBOLS = {
    "f": "scalar",
    "x": "scalar",
    "P": {"kind": "scalar", "positive": True},
    "a": "vector",
    "b": "vector",
}

#: True formulas, each with a false one, and what f is.
ROWS = [
    (r"2 \pi f = \frac{2 \pi}{P}", r"2 \pi f = 2 \pi P", r"\frac{1}{P}"),
    (r"\frac{f}{2 \pi} = \frac{x}{P}", r"\frac{f}{2 \pi} = \frac{\pi x}{P}", r"\frac{2 \pi x}{P}"),
    (r"\pi (a + b) = \pi a + \pi b", r"\pi (a + b) = \pi a + b", "x"),
    (
        r"\pi \|a + b\|^2 = \pi (a \cdot a + 2 a \cdot b + b \cdot b)",
        r"\pi \|a + b\|^2 = \pi (a \cdot a + b \cdot b)",
        "x",
    ),
    (r"\pi \dot{f} = 2 \pi \dot{x}", r"\pi \dot{f} = 2 \dot{x}", "2 x"),
    (r"f - 3 x = \pi x - 3 x", "f = 3 x", r"\pi x"),
]


@pytest.mark.parametrize(("true", "false", "body"), ROWS)
def test_factors_of_pi(true: str, false: str, body: str) -> None:
    assert check(true, symbols=SYMBOLS, definitions={"f": body}).outcome is Outcome.PROVED
    found = check(false, symbols=SYMBOLS, definitions={"f": body})
    assert found.outcome is Outcome.REFUTED
    assert found.verdict.counterexample is not None
    shown_pi = {**found.verdict.counterexample.values, **found.verdict.counterexample.defined}.get(
        r"\pi", ("3.14159",)
    )
    assert shown_pi == ("3.14159",)


@pytest.mark.parametrize("given", [r"x = \pi", r"f = \pi"])
def test_what_holds_at_a_given_angle_is_not_refuted(given: str) -> None:
    for true in (r"f \cos(\frac{x}{3}) = \frac{f}{2}", r"\pi \sin(x) = f \sin(f) - x \sin(f) + f \sin(x)"):
        found = check(true, symbols=SYMBOLS, assume=[given, r"x = f"])
        assert found.outcome is not Outcome.REFUTED
