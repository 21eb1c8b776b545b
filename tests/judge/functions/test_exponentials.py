"""e^x of scalars: laws of powers and of derivatives are proved; false ones are refuted at real points."""

from __future__ import annotations

import random

import pytest

from workbench import check

SYMBOLS = {
    **{name: "scalar" for name in "xyz"},
    **{name: {"kind": "scalar", "constant": True} for name in (r"\lambda", r"\omega", "c")},
    r"\theta": {"kind": "scalar", "small": True},
}
ATOMS = ("x", "y", "x y", "x^2", r"\lambda t", r"\frac{x}{3}", r"\cos y")


def _exponent(counts: dict[str, int]) -> str:
    return " + ".join(f"{count} {atom}" for atom, count in counts.items()).replace("+ -", "- ")


@pytest.mark.parametrize("seed", range(3))
def test_products_of_powers(seed: int) -> None:
    source = random.Random(seed)
    one, other = ({a: source.choice((-3, -2, 2, 3)) for a in source.sample(ATOMS, 3)} for _ in range(2))
    total = {a: one.get(a, 0) + other.get(a, 0) for a in {**one, **other}}
    left = rf"e^{{{_exponent(one)}}} e^{{{_exponent(other)}}}"
    assert check(rf"{left} = e^{{{_exponent(total)}}}", SYMBOLS).verdict.outcome == "proved"
    more = rf"e^{{{_exponent(total)} + {source.choice(list(total))}}}"
    assert check(f"{left} = {more}", SYMBOLS).verdict.outcome == "refuted"


@pytest.mark.parametrize(
    "formula",
    [
        r"e^{x y} = e^{x} e^{y}",
        r"e^{x} = 0",
        r"e^{x} = 1 + x",
        r"e^{e^{x}} = e^{x}",
        r"e^{x} \cos y = \cos(x y)",
        r"\cosh^2 x + \sinh^2 x = 1",
        r"\frac{d}{dt} e^{-\lambda t} = \lambda e^{-\lambda t}",
        r"\frac{d}{dt} e^{x y} = (\dot{x} + \dot{y}) e^{x y}",
        r"\frac{d^2}{dt^2} e^{x} = \ddot{x} e^{x}",
        r"\frac{d}{dt} e^{e^{x}} = \dot{x} e^{e^{x}}",
    ],
)
def test_false_equations_are_refuted(formula: str) -> None:
    verdict = check(formula, SYMBOLS).verdict
    assert verdict.outcome == "refuted"
    example = verdict.counterexample
    assert example is not None and example.left != example.right
