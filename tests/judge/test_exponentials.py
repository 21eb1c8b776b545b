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
        r"\frac{d^2}{dt^2} e^{x y} = (\ddot{x} y + 2 \dot{x} \dot{y} + x \ddot{y} + (\dot{x} y + x \dot{y})^2) e^{x y}",
        r"\frac{d}{dt} (e^{-\lambda t} \cos(\omega t)) = -e^{-\lambda t} (\lambda \cos(\omega t) + \omega \sin(\omega t))",
        r"\frac{d}{dt} e^{e^{x}} = \dot{x} e^{x} e^{e^{x}}",
        r"\frac{d}{dt} (e^{x/2} e^{x/3}) = \frac{5}{6} \dot{x} e^{5x/6}",
        r"e^{x/2} e^{-x} = \frac{1}{e^{x/2}}",
        r"e^{\theta} \approx 1 + \theta",
        r"\cosh^2 x - \sinh^2 x = 1",
        r"\sinh(x + y) = \sinh x \cosh y + \cosh x \sinh y",
        r"\frac{d}{dt} (\tanh x) = \dot{x} (1 - \tanh^2 x)",
    ],
)  # fmt: skip
def test_rates_and_quotients(formula: str) -> None:
    assert check(formula, SYMBOLS).verdict.outcome == "proved"


def test_a_damped_oscillation_satisfies_its_equation() -> None:
    z = [r"z = c e^{-\lambda t} \sin(\omega t)"]
    equation = r"\ddot{z} + 2 \lambda \dot{z} + (\lambda^2 {} \omega^2) z = 0"
    assert check(equation.replace("{}", "+"), SYMBOLS, definitions=z).verdict.outcome == "proved"
    assert check(equation.replace("{}", "-"), SYMBOLS, definitions=z).verdict.outcome == "refuted"
    assert check(z[0], SYMBOLS, definitions=z).verdict.outcome == "definition"


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


def test_rate_of_another_dimension_is_ill_formed() -> None:
    assert check(r"\frac{d}{dt} e^{x} = e^{x}", SYMBOLS).verdict.outcome == "ill-formed"


def test_law_of_a_rate_is_not_refuted() -> None:
    assert check(r"\dot{y} = c e^{-\lambda t}", SYMBOLS).verdict.outcome == "unchecked"


def test_a_symbol_e_is_no_exponential() -> None:
    assert check("e^2 = 2 e", {"e": "scalar"}).verdict.outcome == "refuted"
    with pytest.raises(ValueError, match="expected an integer"):
        check("x^{y/2} = x", SYMBOLS)


COORDINATES = {
    **SYMBOLS,
    "p": {"kind": "scalar", "independent": True},
    "q": {"kind": "scalar", "independent": True},
    "A": {"kind": "scalar", "of": ["p", "q"]},
}


@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"\frac{\partial}{\partial p} e^{2 p} = 2 e^{2 p}", "proved"),
        (r"\frac{\partial}{\partial p} e^{A} = \frac{\partial A}{\partial p} e^{A}", "proved"),
        (r"\frac{\partial}{\partial p} (q e^{p q}) = q^2 e^{p q}", "proved"),
        (r"\frac{\partial^2}{\partial p^2} e^{-\lambda p} = \lambda^2 e^{-\lambda p}", "proved"),
        (r"\frac{\partial}{\partial p} e^{e^{p}} = e^{p} e^{e^{p}}", "proved"),
        (r"\frac{d}{dt} (\frac{\partial}{\partial p} e^{c p}) = c^2 \dot{p} e^{c p}", "proved"),
        (r"\frac{\partial}{\partial p} e^{p q} = p e^{p q}", "unchecked"),
        (r"\frac{\partial}{\partial p} e^{2 p} = e^{2 p}", "unchecked"),
        (r"\frac{\partial}{\partial p} e^{x p} = x e^{x p}", "unchecked"),  # x may depend on p
        (r"\frac{\partial}{\partial p} e^{p} + \dot{x} e^x = e^p", "unchecked"),
        (r"\frac{\partial}{\partial p} e^{\dot{p}} = e^{\dot{p}}", "unchecked"),
    ],
)
def test_slopes(formula: str, outcome: str) -> None:
    assert check(formula, COORDINATES).verdict.outcome == outcome


TWISTS = {
    "c": {"kind": "vector", "constant": True},
    "d": {"kind": "vector", "constant": True},
    "w": "vector",
    "v": "vector",
    "S": "matrix 4×4",
    "V": "matrix 6×1",
}
MATRICES = [
    rf"{name} = \begin{{bmatrix}} \operatorname{{skew}}({turning}) & {moving} \\ 0 & 0 \end{{bmatrix}}"
    for name, turning, moving in (("B", "w", "v"), ("C", "c", "d"))
]


@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"\frac{d}{dt} e^{C t} = C e^{C t}", {"proved", "conditional"}),
        (r"\frac{d}{dt} e^{B} = \dot{B} e^{B}", {"refuted"}),
        (r"\frac{d}{dt} e^{C t} = e^{C t} B", {"refuted", "unchecked"}),
        (r"e^{B} e^{C} = e^{B + C}", {"refuted"}),
        (r"e^{B} = \mathbf{I}_{4 \times 4} + B", {"refuted"}),
        (r"e^{S} e^{S} = e^{2 S}", {"unchecked"}),
        (r"e^{B} e^{-B} = \mathbf{I}_{4 \times 4}", {"proved"}),
        (r"e^{B} B = B e^{B}", {"proved"}),
        (r"e^{B} B = B e^{-B}", {"refuted"}),
    ],
)
def test_exponentials_of_twists(formula: str, outcome: set[str]) -> None:
    assert check(formula, TWISTS, definitions=MATRICES).outcome in outcome


def test_a_twist_is_no_exponent_and_no_fault() -> None:
    """By e^V authors mean that of its 4×4 matrix, as by e^w that of the skew tensor."""
    with pytest.raises(ValueError, match="is not read"):
        check("e^{V} = e^{V}", TWISTS)
