"""a ≈ b: equal to first order in all that is declared small, and in its rates."""

from __future__ import annotations

import random

import pytest

from workbench import check

SYMBOLS = {
    r"\theta": {"kind": "scalar", "small": True},
    r"\phi": {"kind": "scalar", "small": True},
    r"\delta": {"kind": "vector", "small": True},
    r"\alpha": "scalar",
    "a": "scalar",
    "b": "scalar",
    "g": {"kind": "scalar", "constant": True},
    "u": {"kind": "vector", "unit": True},
    "v": "vector",
    "R": "rotation",
    "p": "hamilton quaternion",
}
LEAVES = (
    (r"\theta", "0", r"\theta"),
    (r"\phi", "0", r"\phi"),
    (r"\dot{\theta}", "0", r"\dot{\theta}"),
    ("a", "a", "0"),
    ("b", "b", "0"),
    (r"\sin(\alpha + \theta)", r"\sin\alpha", r"\theta \cos\alpha"),
    (r"\cos(\alpha - \phi)", r"\cos\alpha", r"\phi \sin\alpha"),
    (r"\frac{1}{2 + \theta}", r"\frac{1}{2}", r"-\frac{\theta}{4}"),
)


def _expression(source: random.Random, depth: int) -> tuple[str, str, str]:
    """An expression, its value where nothing small is there, and its part of first order."""
    if not depth:
        return source.choice(LEAVES)
    (f, f_0, f_1), (g, g_0, g_1) = (_expression(source, depth - 1) for _ in range(2))
    if source.random() < 0.5:
        return f"({f} - ({g}))", f"({f_0} - ({g_0}))", f"({f_1} - ({g_1}))"
    return f"({f}) ({g})", f"({f_0}) ({g_0})", f"(({f_0}) ({g_1}) + ({f_1}) ({g_0}))"


@pytest.mark.parametrize("seed", range(4))
def test_sums_and_products_are_as_worked_out_by_hand(seed: int) -> None:
    source = random.Random(seed)
    whole, rest, first = _expression(source, 2)
    assert check(rf"{whole} \approx {rest} + {first}", SYMBOLS).verdict.outcome == "proved"
    more = source.choice([r"\theta", r"b \phi", r"\dot{\theta}"])
    assert check(rf"{whole} \approx {rest} + {first} + {more}", SYMBOLS).verdict.outcome == "refuted"


@pytest.mark.parametrize(
    "formula",
    [
        r"\sin\theta \approx \theta \approx \tan\theta",
        r"\exp(\tilde{\delta}) \approx \mathbf{I} + \tilde{\delta}",
        r"\exp(\theta \tilde{u}) \approx \mathbf{I} + \theta \tilde{u}",
        r"\exp\left(\left[0, \frac{1}{2} \delta\right]\right) p \approx p + \frac{1}{2} [0, \delta] p",
        r"\frac{d}{dt} \exp([0, \delta]) \approx [0, \dot{\delta}]",
        r"(\mathbf{I} + \tilde{\delta})^{-1} R \approx R - \tilde{\delta} R",
        r"\det(\mathbf{I} + \tilde{\delta}) \approx 1",
        r"\ddot{\theta} + g \sin\theta \approx \ddot{\theta} + g \theta",
    ],
)
def test_approximations_of_the_field_are_proved(formula: str) -> None:
    verdict = check(formula, SYMBOLS).verdict
    assert verdict.outcome == "proved" and "to first order in" in verdict.scope
    assert verdict.read_back.count(r"\approx") == formula.count(r"\approx")


def test_small_symbols_are_found_in_definitions_not_functions() -> None:
    found = check(r"x \approx \theta", {**SYMBOLS, "x": "scalar"}, definitions=[r"x = \sin\theta"])
    assert found.verdict.outcome == "proved"
    function = {"kind": "scalar", "of": [r"\theta"]}
    verdict = check(r"V \theta \approx \theta", {**SYMBOLS, "V": function}).verdict
    assert verdict.outcome == "unchecked" and "a function of what is small" in verdict.reason


def test_the_right_form_is_found() -> None:
    proposed = check(r"\tan\theta \approx 2 \theta", SYMBOLS).repair().proposals
    assert any(proposal.latex.endswith(r"\approx \theta") for proposal in proposed)


def test_an_approximation_needs_a_small_symbol() -> None:
    with pytest.raises(ValueError, match="a condition is an equation"):
        check(r"a = 1 \text{ where } \theta \approx a", SYMBOLS)
    with pytest.raises(ValueError, match=r"column 3: .*an approximation is not read"):
        check(r"a \approx 1", {"a": "scalar"})
    with pytest.raises(ValueError, match="small is for real quantities"):
        check("R = R", {"R": {"kind": "rotation", "small": True}})
