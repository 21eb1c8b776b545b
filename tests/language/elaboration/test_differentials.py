"""Differentials: d x by any sign of it, the d that is a symbol, and equations that are not homogeneous."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench import check
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.formula_errors import ReadError
from workbench.core.verdict import Outcome
from workbench.papers.drafting.inference.differential_letters import has_differentials

SYMBOLS = {
    **dict.fromkeys(("f", "g", "r", r"\phi"), "scalar"),
    **dict.fromkeys(("x", "y"), "vector"),
    **dict.fromkeys(("A", "B"), "matrix 2×2"),
    "R": "rotation",
    "c": {"kind": "scalar", "constant": True},
}
#: Right sides of d(…) = …, and a false form of each.
RULES = {
    "f g": (r"g\, %d f + f\, %d g", r"g\, %d f - f\, %d g"),
    r"x \cdot y": (r"%d x \cdot y + x \cdot %d y", r"%d x \cdot y + y \cdot %d y"),
    "A B": (r"(%d A) B + A\, %d B", r"(%d A) B + (%d B) A"),
    "A^{-1}": (r"-A^{-1} (%d A) A^{-1}", r"A^{-1} (%d A) A^{-1}"),
    r"r \cos\phi": (r"\cos\phi\, %d r - r \sin\phi\, %d \phi", r"\cos\phi\, %d r + r \sin\phi\, %d \phi"),
    r"\frac{f}{g}": (r"\frac{g\, %d f - f\, %d g}{g^2}", r"\frac{f\, %d g - g\, %d f}{g^2}"),
    "c f": (r"c\, %d f", r"c\, %d f + f"),
    "R x": (r"%d R\, x + R\, %d x", r"%d R\, x - R\, %d x"),
}


@pytest.mark.parametrize("sign", ["d", r"\mathrm{d}"])
@pytest.mark.parametrize("inside", RULES)
def test_differential_obeys_the_rules_of_derivatives(inside: str, sign: str) -> None:
    true, false = (side.replace("%d", sign) for side in RULES[inside])
    assert check(f"{sign}({inside}) = {true}", SYMBOLS).outcome in (Outcome.PROVED, Outcome.CONDITIONAL)
    if inside != "c f" or sign != "d":
        assert check(f"{sign}({inside}) = {false}", SYMBOLS).outcome is Outcome.REFUTED


def test_differential_reads_back_as_a_rate() -> None:
    assert check("d(f g) = g df + f dg", SYMBOLS).verdict.read_back == (
        r"\left(f g\right)^{(1)} = g \dot{f} + f \dot{g}"
    )


def test_increment_of_time_is_a_factor() -> None:
    assert check(r"\mathrm{d} f = \dot{f}\, \mathrm{d}t", SYMBOLS).verdict.code is VerdictCode.SAME_TERM
    assert check(r"d(f g) = (\dot{f} g + f \dot{g})\, dt", SYMBOLS).outcome is Outcome.PROVED
    assert check(r"\mathrm{d} f = \dot{f}", SYMBOLS).outcome is Outcome.REFUTED


@pytest.mark.parametrize("formula", ["d f = f", "d f + 1 = f", "f d = d f", r"d f = \dot{f}"])
def test_italic_d_elsewhere_is_an_unknown_symbol(formula: str) -> None:
    with pytest.raises(ReadError, match="unknown symbol d"):
        check(formula, SYMBOLS)


def test_declared_d_is_a_factor() -> None:
    assert check("d f g = d g f", {**SYMBOLS, "d": "scalar"}).outcome is Outcome.PROVED
    assert check("d(f g) = g d f + f d g", {**SYMBOLS, "d": "scalar"}).outcome is Outcome.REFUTED


def test_notation_of_the_paper_goes_first(tmp_path: Path) -> None:
    file = tmp_path / "notation.toml"
    file.write_text(
        "[notation]\n'\\mathrm{d} X' = { where = { X = \"scalar\" }, means = '2 X' }\n"
        "[symbols]\n'f' = \"scalar\"\n",
        encoding="utf-8",
    )
    assert check(r"\mathrm{d} f = f + f", None, notation=file).outcome is Outcome.PROVED


@pytest.mark.parametrize("formula", ["df^2 = f dg", "d(f)^2 = f dg", "dA^{-1} = dB"])
def test_power_behind_a_differential_is_asked_about(formula: str) -> None:
    with pytest.raises(ReadError, match="a power of the derivative or of its argument"):
        check(formula, SYMBOLS)


@pytest.mark.parametrize(
    ("formulas", "is_sign"),
    [
        (["d(x y) = x dy + y dx"], True),
        ([r"\begin{bmatrix} dx \\ 0 \end{bmatrix} = A \begin{bmatrix} du \\ dv \end{bmatrix}"], True),
        ([r"\frac{d}{dt} x = y"], False),
        (["d x = x d"], False),
        (["d(x y) = x dy", "x = y + d"], False),
        (["x = y"], False),
    ],
)
def test_italic_d_of_a_text_is_a_sign_by_its_formulas(formulas: list[str], is_sign: bool) -> None:
    assert has_differentials(formulas) is is_sign
