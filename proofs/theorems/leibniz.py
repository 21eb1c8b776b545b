"""Leibniz' rule for every order, from its step: what (103)–(110) and (114)–(116) need for all n."""

from __future__ import annotations

from workbench.judge.theorems.arguments import Step
from workbench.judge.theorems.formula_steps import Letters

_LETTERS = Letters(
    {name: {"kind": "vector"} for name in "xy"}
    | {name: {"kind": "tensor"} for name in "XY"}
    | {name: {"kind": "scalar"} for name in ("n", "k", "c")},
)


def leibniz_rule() -> list[Step]:
    """(x ∗ y)⁽ⁿ⁾ = Σ C(n, k) x⁽ᵏ⁾ ∗ y⁽ⁿ⁻ᵏ⁾ for all n and each product ∗, by induction from n = 0."""
    return [
        _LETTERS.step(
            "a derivative of x⁽ʲ⁾ ∗ y⁽ᵐ⁾, whatever functions these are, is x⁽ʲ⁺¹⁾ ∗ y⁽ᵐ⁾ + x⁽ʲ⁾ ∗ y⁽ᵐ⁺¹⁾",
            r"\frac{d}{dt}(x \times y) = \dot{x} \times y + x \times \dot{y}",
            r"\frac{d}{dt}(X Y) = \dot{X} Y + X \dot{Y}",
            r"\frac{d}{dt}(X y) = \dot{X} y + X \dot{y}",
            but_not=r"\frac{d}{dt}(x \times y) = \dot{x} \times y + y \times \dot{x}",
        ),
        _LETTERS.step(
            "C(n, k−1) = c k/(n+1) and C(n, k) = c (n+1−k)/(n+1) with c = C(n+1, k), so their sum is c,"
            " for all n and k",
            r"c \frac{k}{n + 1} + c \frac{n + 1 - k}{n + 1} = c",
            but_not=r"c \frac{k}{n + 1} + c \frac{n - k}{n + 1} = c",
        ),
    ]
