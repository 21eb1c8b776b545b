"""Logarithms, powers, roots and inverse angles of scalars: laws and rates are proved, false ones refuted."""

from __future__ import annotations

import random

import pytest

from workbench import check

POSITIVE = {"kind": "scalar", "positive": True}
PLACE = {"kind": "scalar", "independent": True}
SYMBOLS = {
    **dict.fromkeys(("x", "y", "z"), "scalar"),
    **dict.fromkeys(("m", "k"), POSITIVE),
    **dict.fromkeys(("p", "q"), PLACE),
}
#: A function of u, and its derivative by u.
SLOPES = {
    r"\ln(u)": r"\frac{1}{u}",
    r"\arctan(u)": r"\frac{1}{1 + (u)^2}",
    r"\arcsin(u)": r"\frac{1}{\sqrt{1 - (u)^2}}",
    r"\arccos(u)": r"\frac{-1}{\sqrt{1 - (u)^2}}",
    r"(u)^{2/3}": r"\frac{2}{3} (u)^{-1/3}",
    r"\sqrt{3 - (u)}": r"\frac{-1}{2 \sqrt{3 - (u)}}",
    r"2^{u}": r"2^{u} \ln 2",
    r"\tanh(u)": r"(1 - \tanh^2(u))",
}
INSIDE = {
    r"x": r"\dot{x}",
    r"x y": r"(\dot{x} y + x \dot{y})",
    r"x^2 + y": r"(2 x \dot{x} + \dot{y})",
    r"\sin x": r"\cos(x) \dot{x}",
}


@pytest.mark.parametrize("inside", INSIDE)
@pytest.mark.parametrize("function", SLOPES)
def test_rate_of_a_function_by_the_chain_rule(function: str, inside: str) -> None:
    left = rf"\frac{{d}}{{dt}} ({function.replace('u', inside)})"
    slope = SLOPES[function].replace("u", inside)
    assert check(f"{left} = {INSIDE[inside]} {slope}", SYMBOLS).verdict.outcome == "proved"
    for wrong in (f"-{INSIDE[inside]} {slope}", f"2 {INSIDE[inside]} {slope}"):
        assert check(f"{left} = {wrong}", SYMBOLS).verdict.outcome == "refuted"


@pytest.mark.parametrize("seed", range(4))
def test_logarithm_of_a_product_is_a_sum(seed: int) -> None:
    source = random.Random(seed)
    counts = {
        base: source.choice((-2, -1, 2, 3)) for base in source.sample(("x", "y", "m", "(x + y)", "6"), 3)
    }
    product = r" \cdot ".join(f"{base}^{{{count}}}" for base, count in counts.items())
    total = " + ".join(rf"({count}) \ln {base}" for base, count in counts.items())
    assert check(rf"\ln({product}) = {total}", SYMBOLS).verdict.outcome == "proved"
    assert (
        check(rf"\ln({product}) = {total} + \ln {source.choice(list(counts))}", SYMBOLS).outcome == "refuted"
    )


@pytest.mark.parametrize("function", SLOPES)
def test_partial_derivative_by_a_constant(function: str) -> None:
    constant = {"kind": "scalar", "constant": True, "independent": True}
    symbols = {"a": constant, "b": constant, "p": PLACE}
    left = rf"\frac{{\partial}}{{\partial a}} \left({function.replace('u', 'a b - p')}\right)"
    slope = SLOPES[function].replace("u", "a b - p")
    assert check(f"{left} = b {slope}", symbols).verdict.outcome == "proved"
    for wrong in ("0", slope):
        assert check(f"{left} = {wrong}", symbols).verdict.outcome == "refuted"
