"""`positive = true`: a number that is more than 0 has a root, and may be divided by."""

from __future__ import annotations

import pytest

from workbench import check
from workbench.core.formula_errors import SpecError
from workbench.core.verdict import Outcome
from workbench.language.naming.symbols import SymbolTable

POSITIVE = {"kind": "scalar", "positive": True}
SYMBOLS = {
    "m": {**POSITIVE, "constant": True},
    "M": {**POSITIVE, "constant": True},
    r"\mu": {**POSITIVE, "constant": True},
    "r": POSITIVE,
    "r_n": POSITIVE,
    "x": "scalar",
    "a": "vector",
    "b": "vector",
    "T": "scalar",
}
TRUE = [
    r"\sqrt{m} \sqrt{m} = m",
    r"\sqrt{m^2} = m",
    r"\sqrt{m r} = \sqrt{m} \sqrt{r}",
    r"\sqrt{\frac{m}{r^3}} = \frac{\sqrt{m}}{r^{3/2}}",
    r"\sqrt{\frac{r^2}{m + M}} = \frac{r}{\sqrt{m + M}}",
    r"\sqrt{\mu (m + M) r} = \sqrt{\mu} \sqrt{m + M} \sqrt{r}",
    r"\frac{d}{dt} r^{3/2} = \frac{3}{2} \sqrt{r} \dot r",
    r"\frac{d}{dt} (\sqrt{r}) = \frac{\dot r}{2 \sqrt{r}}",
    r"|r| = r",
    r"\|m a\| = m \|a\|",
    r"\frac{m}{m} = 1",
    r"\frac{m + M}{m + M} = 1",
    r"\frac{m r + M}{m r + M} x = x",
    r"\sqrt{r_1 r_2} = \sqrt{r_1} \sqrt{r_2}",
    r"\dot m = 0",
    r"\cos^2(\sqrt{\frac{\mu}{m}} t) + \sin^2(\sqrt{\frac{\mu}{m}} t) = 1",
    r"\sin^2 r + \cos^2 r = 1",
    r"\sin 2 r = 2 \sin r \cos r",
    r"2 \sin^2 \frac{r}{2} = 1 - \cos r",
    r"\frac{d}{dt} \sin r = \dot r \cos r",
    r"\sin(r + x) = \sin r \cos x + \cos r \sin x",
]
NORMS = [
    r"\|\frac{a}{x}\|^2 = \frac{a \cdot a}{x^2}",
    r"\|\frac{m a}{m + M} + b\|^2 (m + M)^2 = \|m a + (m + M) b\|^2",
    r"\|\frac{a}{m}\|^2 = \frac{a \cdot a}{m^2}",
]
FALSE = [
    r"\|\frac{a}{x}\| = \frac{\|a\|}{x}",
    r"\|\frac{a}{m + M}\| = \frac{2 \|a\|}{m + M}",
    r"\sqrt{m^2} = -m",
    r"\sqrt{m r} = \sqrt{m} r",
    r"\sqrt{\frac{m}{r^3}} = \frac{\sqrt{m}}{r^{1/2}}",
    r"\frac{d}{dt} r^{3/2} = \frac{1}{2} \sqrt{r} \dot r",
    r"\dot r = 0",
    r"\sqrt{x^2} = x",
    r"\sin 2 r = \sin r \cos r",
    r"2 \sin^2 \frac{r}{2} = 1 + \cos r",
]
ONLY_IF_POSITIVE = [r"|r| = r", r"\|m a\| = m \|a\|", r"\sqrt{m^2} = m"]


def _outcome(formula: str, symbols=SYMBOLS) -> Outcome:
    return check(formula, symbols=symbols).outcome


@pytest.mark.parametrize("formula", TRUE)
def test_claims_on_positive_numbers_are_proved(formula: str) -> None:
    assert _outcome(formula) is Outcome.PROVED


@pytest.mark.parametrize("formula", NORMS)
def test_the_norm_of_a_quotient(formula: str) -> None:
    assert _outcome(formula) in (Outcome.PROVED, Outcome.CONDITIONAL)


@pytest.mark.parametrize("formula", FALSE)
def test_false_claims_on_positive_numbers_are_refuted(formula: str) -> None:
    assert _outcome(formula) is Outcome.REFUTED


@pytest.mark.parametrize("formula", ONLY_IF_POSITIVE)
def test_it_is_refuted_of_any_number(formula: str) -> None:
    any_number = {name: "scalar" if isinstance(spec, dict) else spec for name, spec in SYMBOLS.items()}
    assert _outcome(formula, any_number) is Outcome.REFUTED


def test_a_counterexample_is_positive() -> None:
    against = check(r"m^2 = m", symbols=SYMBOLS).verdict.counterexample
    assert against.left != against.right
    assert all(float(entry) >= 0 for entries in against.defined.values() for entry in entries)


@pytest.mark.parametrize(
    "derived", [r"\frac{d}{dt} (\sin r)", r"\dot{r} \frac{\partial}{\partial r} (\sin r)"]
)
def test_its_sine_depends_on_it_and_not_on_its_root(derived: str) -> None:
    symbols = SYMBOLS | {"r": {**POSITIVE, "independent": True}}
    rates = {r"\dot{r} \cos r": "proved", r"\cos(r) \dot{r}": "proved", r"2 \dot{r} \cos r": "refuted"}
    assert {rate: check(f"{derived} = {rate}", symbols=symbols).outcome for rate in rates} == rates


@pytest.mark.parametrize(
    "spec", [{"kind": "vector", "positive": True}, {"kind": "dual scalar", "positive": True}]
)
def test_only_scalars_are(spec: dict) -> None:
    with pytest.raises(SpecError, match="positive"):
        SymbolTable.build({"a": spec})


PLACES = {
    "r": {**POSITIVE, "independent": True},
    r"\theta": {"kind": "scalar", "independent": True},
    "m": {**POSITIVE, "constant": True},
    r"\mu": {**POSITIVE, "constant": True},
    "L": "scalar",
}
LAGRANGIAN = [r"L = \frac{1}{2} m (\dot r^2 + r^2 \dot\theta^2) + \frac{\mu m}{r}"]
SLOPES = {
    r"\frac{\partial}{\partial r} (r \cos \theta)": r"\cos \theta",
    r"\frac{\partial}{\partial r} r^3": "3 r^2",
    r"\frac{\partial^2}{\partial r^2} (r^2 \theta)": r"2 \theta",
    r"\frac{\partial L}{\partial r}": r"m r \dot\theta^2 - \frac{\mu m}{r^2}",
    r"\frac{\partial L}{\partial \dot r}": r"m \dot r",
    r"\frac{\partial L}{\partial \dot\theta}": r"m r^2 \dot\theta",
    r"\frac{d}{dt} \frac{\partial L}{\partial \dot r}": r"m \ddot r",
}


def _slope(left: str, right: str):
    return check(f"{left} = {right}", symbols=PLACES, definitions=LAGRANGIAN).verdict


@pytest.mark.parametrize(("left", "right"), SLOPES.items())
def test_it_is_a_coordinate_that_is_differentiated_by(left: str, right: str) -> None:
    assert _slope(left, right).outcome is Outcome.PROVED
    for wrong in (f"-({right})", f"2 ({right})", f"{right} + 1"):
        refuted = _slope(left, wrong)
        assert refuted.outcome in (Outcome.REFUTED, Outcome.UNCHECKED)
        if refuted.outcome is Outcome.REFUTED:
            assert float(*refuted.counterexample.values.get("r", ("1",))) > 0


def test_claims_that_hold_for_positive_values_are_not_refuted() -> None:
    assert _slope(r"\frac{\partial}{\partial r} \sqrt{r^2}", "1").outcome is not Outcome.REFUTED
    assert _slope(r"\frac{\partial}{\partial r} \sqrt{r^2}", "-1").outcome is not Outcome.PROVED


def test_a_counterexample_tells_it_and_not_its_root() -> None:
    against = check(r"\sqrt{m r} = \sqrt{m} r", symbols=SYMBOLS).verdict.counterexample
    (m,), (r,), (left,), (right,) = against.values["m"], against.values["r"], against.left, against.right
    assert float(left) ** 2 == float(m) * float(r) and float(right) ** 2 == float(m) * float(r) ** 2
