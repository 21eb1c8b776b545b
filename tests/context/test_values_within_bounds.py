"""A counterexample satisfies a stated bound exactly, and that of a sine or cosine as far as it is known."""

from __future__ import annotations

import operator
from fractions import Fraction
from math import cos, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbench.context.facts import Bound

SIGNS = {"<": operator.lt, ">": operator.gt, "≤": operator.le, "≥": operator.ge, "≠": operator.ne}
NUMBERS = st.fractions(-4, 4, max_denominator=12)


@pytest.mark.parametrize("sign", SIGNS)
@given(value=NUMBERS, number=NUMBERS)
def test_value_is_compared_exactly(sign: str, value: Fraction, number: Fraction) -> None:
    for bound in (number, value):
        assert Bound("x", sign, bound).allows({"x": (str(value),)}) == SIGNS[sign](value, bound)


@pytest.mark.parametrize("sign", SIGNS)
@pytest.mark.parametrize(("head", "turned"), [("\\sin", sin), ("\\cos", cos)])
@given(angle=NUMBERS, number=NUMBERS)
def test_rounded_value_is_not_on_its_bound(
    head: str, turned: object, sign: str, angle: Fraction, number: Fraction
) -> None:
    """sin 0 and cos 0 are exact; the sine of another rational number is none."""
    value = Fraction(turned(angle))  # type: ignore[operator]
    values = {"x": (str(angle),)}
    assert Bound(f"{head} x", sign, value).allows(values) == (not angle and SIGNS[sign](value, value))
    if value != number:
        assert Bound(f"{head} x", sign, number).allows(values) == SIGNS[sign](value, number)
