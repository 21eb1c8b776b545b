"""Partial derivatives, functions of coordinates, angles in time and exponentials: laws, and what is refused."""

from __future__ import annotations

from dataclasses import replace

import pytest

from workbench import check
from workbench.core.formula_errors import ReadError, SpecError
from workbench.core.verdict import Outcome
from workbench.engines.inventory import NotExact
from workbench.language.definition_entries import read_definitions
from workbench.language.definitions import Definitions
from workbench.language.naming.reading_conventions import Conventions, Gradient
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read
from workbench.prover.decide.decide import Judge

SPECS = {
    **{name: {"kind": "scalar"} for name in ("q", "p", "k", r"\theta")},
    **{name: {"kind": "vector"} for name in ("x", "y")},
    "m": {"kind": "scalar", "constant": True},
    r"\underline{m}": {"kind": "dual scalar", "constant": True},
    r"\omega": {"kind": "scalar", "constant": True},
    "r": {"kind": "vector", "of": ["q", "p"]},
    "V": {"kind": "scalar", "of": ["q"]},
    "W": {"kind": "scalar", "of": ["x"]},
    "L": {"kind": "scalar", "of": ["q", "p", "t"]},
    "G": {"kind": "scalar", "of": ["r"]},
}
DEFINED = {
    "T": r"\frac{m}{2} \dot{r}^2",
    "n": r"\|x\|",
    "R": r"\exp(\tilde{x})",
    "J": r"\mathbf{I} + \frac{1 - \cos n}{n^2} \tilde{x} + \frac{n - \sin n}{n^3} \tilde{x}^2",
    "K": r"\mathbf{I} - \frac{1 - \cos n}{n^2} \tilde{x} + \frac{n - \sin n}{n^3} \tilde{x}^2",
}
DEFINITIONS, TABLE = read_definitions(
    DEFINED, replace(SymbolTable.build(SPECS), conventions=Conventions(gradient=Gradient.ROW))
)


def verdict(latex: str):
    (statement,) = read(latex, TABLE)
    return Judge(Definitions(DEFINITIONS)).judge(statement)


@pytest.mark.parametrize(
    "latex",
    [
        r"\frac{d}{dt} \frac{\partial r}{\partial q} = \frac{\partial \dot{r}}{\partial q}",
        r"\frac{\partial \dot{r}}{\partial \dot{q}} = \frac{\partial r}{\partial q}",
        r"\frac{\partial^2 r}{\partial q \partial p} = \frac{\partial^2 r}{\partial p \partial q}",
        r"\frac{d}{dt} \frac{\partial T}{\partial \dot{q}} - \frac{\partial T}{\partial q} = m \ddot{r} \cdot \frac{\partial r}{\partial q}",
        r"\dot{L} = \frac{\partial L}{\partial q} \dot{q} + \frac{\partial L}{\partial p} \dot{p} + \frac{\partial L}{\partial t}",
        r"\frac{\partial G}{\partial q} = \frac{dG}{dr} \frac{\partial r}{\partial q}",
        r"\frac{d^2 V}{dt^2} = \frac{d^2 V}{dq^2} \dot{q}^2 + \frac{dV}{dq} \ddot{q}",
        r"\dot{W} = \frac{\partial W}{\partial x} \dot{x}",
        r"\ddot{x} = -\omega^2 x \text{ for } x = \cos(\omega t) y, \dot{x} = -\omega \sin(\omega t) y, \ddot{x} = -\omega^2 \cos(\omega t) y",
        r"R J^T = J",
        r"\frac{\partial (\underline{m} x)}{\partial x} = \underline{m} \mathbf{I}",
    ],
)  # fmt: skip
def test_laws(latex: str) -> None:
    assert verdict(latex).outcome in (Outcome.PROVED, Outcome.CONDITIONAL)


def test_the_jacobians_of_the_exponential() -> None:
    for latex in (r"\dot{R} = \widetilde{J \dot{x}} R", r"\dot{R} = R \widetilde{K \dot{x}}", "R K = J"):
        assert verdict(latex).outcome == Outcome.CONDITIONAL  # J divides by the length of x
    assert verdict(r"\dot{R} = \widetilde{K \dot{x}} R").outcome == Outcome.REFUTED


@pytest.mark.parametrize(
    ("latex", "reason"),
    [
        (r"\frac{\partial (k V)}{\partial q} = k \frac{\partial V}{\partial q}", "may depend on it"),
        (r"\frac{d r}{d q} = \frac{\partial r}{\partial q}", "may change with"),
        (r"\frac{d \dot{V}}{d q} = 0", "a time derivative under"),
        (r"\frac{\partial V}{\partial n} = 0", "no free coordinate"),
    ],
)
def test_undeclared_independence_is_unchecked(latex: str, reason: str) -> None:
    try:
        found = verdict(latex)
    except NotExact as error:
        assert reason in str(error)
    else:
        assert found.outcome == Outcome.UNCHECKED and reason in found.reason


@pytest.mark.parametrize(
    ("latex", "message"),
    [
        (r"\dot{V}(q + p) = V", "another place"),
        (r"\frac{\partial V}{\partial} = 0", "by nothing"),
        (r"\frac{\partial V}{q} = 0", "expected a partial derivative"),
        (r"\frac{\partial}{\partial q} = 0", "the partial derivative of what"),
        (r"\frac{\partial V}{\partial (q p)} = 0", "by anything but a symbol"),
        (r"\frac{\partial^n V}{\partial q^n} = 0", "of the order n"),
        (r"\frac{\partial^{-1} V}{\partial q^{-1}} = 0", "of the order -1"),
    ],
)
def test_invalid_partial_derivatives_are_rejected(latex: str, message: str) -> None:
    with pytest.raises(ReadError, match=message):
        read(latex, TABLE, ["n"])


@pytest.mark.parametrize(
    ("spec", "message"),
    [
        ({"f": {"kind": "scalar", "of": "q"}}, "expected a list"),
        ({"f": {"kind": "scalar", "of": ["q"]}}, "no declared symbol"),
        ({"f": {"kind": "scalar", "of": ["f"]}}, "function of itself"),
    ],
)
def test_declarations_that_make_no_sense(spec: dict, message: str) -> None:
    with pytest.raises(SpecError, match=message):
        SymbolTable.build(spec)


def test_rows_or_columns_are_said() -> None:
    with pytest.raises(ReadError, match="rows or columns"):
        read(r"\frac{\partial W}{\partial x} = 0", SymbolTable.build(SPECS))


@pytest.mark.parametrize(("operator", "of_place"), [("div", "3"), ("curl", "0")])
def test_a_field_of_numbers_has_no_slope(operator, of_place):
    place = {"p": {"kind": "vector", "coordinate": True}}
    numbers = r"\begin{bmatrix} 1 \\ 2 \\ 3 \end{bmatrix}"
    latex = rf"\operatorname{{{operator}}} p + \operatorname{{{operator}}} {numbers} = {of_place}"
    assert check(latex, symbols=place).outcome == Outcome.PROVED
