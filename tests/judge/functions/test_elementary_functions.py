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
#: Left side, true and false right sides.
LAWS = [
    (r"\ln(x y)", r"\ln x + \ln y", r"\ln x \ln y"),
    (r"\ln \frac{x^3}{y}", r"3 \ln x - \ln y", r"3 \ln x + \ln y"),
    (r"\ln(2 x + 2 y)", r"\ln 2 + \ln(x + y)", r"2 \ln(x + y)"),
    (r"\ln e^{x y}", "x y", "x + y"),
    (r"e^{y \ln x}", "x^y", "y^x"),
    (r"\ln 12", r"2 \ln 2 + \ln 3", r"3 \ln 2 + \ln 3"),
    (r"x^{1/3} x^{1/3} x^{1/3}", "x", "x^2"),
    (r"m^{x} m^{y}", "m^{x + y}", "m^{x y}"),
    (r"(m k)^{x}", "m^{x} k^{x}", "m^{x} + k^{x}"),
    (r"\sqrt{8 - 4 x^2}", r"2 \sqrt{2 - x^2}", r"4 \sqrt{2 - x^2}"),
    (r"\sin(\arccos x)", r"\sqrt{1 - x^2}", "1 - x^2"),
    (r"\tan(\arctan x)", "x", "-x"),
    (r"\sin(\arctan x) + \sqrt{m}", r"x \cos(\arctan x) + \sqrt{m}", r"\cos(\arctan x) + \sqrt{m}"),
    (r"\cos(\operatorname{atan2}(y, x))", r"\frac{x}{\sqrt{x^2 + y^2}}", r"\frac{y}{\sqrt{x^2 + y^2}}"),
    (
        r"\frac{d}{dt} \operatorname{atan2}(y, x)",
        r"\frac{x \dot{y} - y \dot{x}}{x^2 + y^2}",
        r"\frac{y \dot{x} - x \dot{y}}{x^2 + y^2}",
    ),
    (
        r"\frac{\partial}{\partial p} \operatorname{atan2}(p, q)",
        r"\frac{q}{p^2 + q^2}",
        r"\frac{p}{p^2 + q^2}",
    ),
    (r"\frac{\partial^2}{\partial p^2} \ln p", r"-\frac{1}{p^2}", r"\frac{1}{p^2}"),
]


@pytest.mark.parametrize("inside", INSIDE)
@pytest.mark.parametrize("function", SLOPES)
def test_rate_of_a_function_by_the_chain_rule(function: str, inside: str) -> None:
    left = rf"\frac{{d}}{{dt}} ({function.replace('u', inside)})"
    slope = SLOPES[function].replace("u", inside)
    assert check(f"{left} = {INSIDE[inside]} {slope}", SYMBOLS).verdict.outcome == "proved"
    for wrong in (f"-{INSIDE[inside]} {slope}", f"2 {INSIDE[inside]} {slope}"):
        assert check(f"{left} = {wrong}", SYMBOLS).verdict.outcome == "refuted"


@pytest.mark.parametrize(("left", "true", "false"), LAWS)
def test_law_of_a_function(left: str, true: str, false: str) -> None:
    assert check(f"{left} = {true}", SYMBOLS).verdict.outcome in ("proved", "conditional")
    assert check(f"{left} = {false}", SYMBOLS).verdict.outcome == "refuted"


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


@pytest.mark.parametrize("formula", ["(x^2)^{1/2} = x", "(x^4)^{1/4} = x", r"(x^2 y^2)^{1/4} = (x y)^{1/2}"])
def test_root_of_a_power_is_its_absolute_value(formula: str) -> None:
    assert check(formula, SYMBOLS).verdict.outcome != "proved"
    positive = formula.replace("x", "m").replace("y", "k")
    assert check(positive, SYMBOLS).verdict.outcome == "proved"


@pytest.mark.parametrize(
    "formula", [r"\ln(-m) = \ln m", r"\sqrt{-1 - x^2} = \sqrt{-1 - x^2} + 0", r"(-m)^{1/3} = -m^{1/3}"]
)
def test_equation_that_is_defined_nowhere_is_not_judged(formula: str) -> None:
    assert check(formula, SYMBOLS).verdict.outcome == "unchecked"


@pytest.mark.parametrize(
    "angle",
    [
        r"\theta = \operatorname{atan2}(y, x)",
        r"\theta = \operatorname{atan2}(y, x) + \arctan 0",
        r"2 \theta = \operatorname{atan2}(y, x) + \arctan \frac{y}{x}",
        r"\theta + \phi = \operatorname{atan2}(y, x) + \operatorname{atan2}(\sin \phi, \cos \phi)",
        r"\theta = \arccos \frac{x}{k} + \arcsin 0",
    ],
)
def test_angle_of_another_branch_refutes_nothing(angle: str) -> None:
    symbols = {"k": POSITIVE, r"\theta": "scalar", r"\phi": "scalar", "x": "scalar", "y": "scalar"}
    place = [r"x = k \cos \theta", r"y = k \sin \theta"]
    assert check(angle, symbols, definitions=place).verdict.outcome != "refuted"
    rate = angle.replace("y, x", "y, -x").replace(r"\arccos", r"2 \arccos")
    if "atan2(y" in rate.replace("operatorname{atan2}", "atan2"):
        left, right = rate.split(" = ")
        wrong = rf"\frac{{d}}{{dt}} ({left}) = \frac{{d}}{{dt}} ({right})"
        assert check(wrong, symbols, definitions=place).verdict.outcome == "refuted"
