"""Sums to an n that nothing states a range for: proved for every n, addend by addend, or not at all."""

from __future__ import annotations

import random

import pytest

from workbench import check

SYMBOLS = {
    "m_i": {"kind": "scalar", "constant": True},
    "a_i": "scalar",
    "b_i": "scalar",
    "x_i": "vector",
    "y_i": "vector",
    "M": "scalar",
    r"\omega": "vector",
}
SUMS = (r"\sum_{{i=1}}^{{n}} {0}", r"\sum_{{i=1}}^{{N}} {0}", r"\sum_i {0}", r"\sum_{{i=0}}^{{n+1}} {0}")
LAWS = (
    (r"(a_i + b_i) x_i", r"{a_i x_i} + {b_i x_i}"),
    (r"m_i x_i \times (\omega \times x_i)", r"{m_i (x_i^2 \mathbf{I} - x_i \otimes x_i)} \omega"),
    (r"m_i x_i \cdot \omega", r"\omega \cdot {m_i x_i}"),
    (r"m_i \dot{x}_i", r"\frac{d}{dt} {m_i x_i}"),
    (r"M x_i \times y_i", r"-M {y_i \times x_i}"),
)


def _summed(text: str, total: str) -> str:
    """The text with a sum for each {…} in it that holds an addend."""
    parts = text.replace(r"\mathbf{I}", "\0").split("{")
    found = parts[0]
    for part in parts[1:]:
        inside, _, rest = part.partition("}")
        is_addend = "_i" in inside
        found += (rf"\left({total.format(inside)}\right)" if is_addend else f"{{{inside}}}") + rest
    return found.replace("\0", r"\mathbf{I}")


@pytest.mark.parametrize(("addend", "other"), LAWS)
def test_laws_hold_for_every_n_and_damaged_ones_do_not(addend: str, other: str) -> None:
    total = random.Random(addend).choice(SUMS)
    other = other.replace(r"\dot{x}", r"\dot x")
    found = check(f"{total.format(addend)} = {_summed(other, total)}", SYMBOLS)
    assert found.verdict.outcome == "proved", found
    assert found.verdict.scope.startswith("all")
    damaged = check(rf"{total.format(addend)} = 2 \left({_summed(other, total)}\right)", SYMBOLS)
    assert damaged.verdict.outcome == "refuted", damaged


@pytest.mark.parametrize(
    ("formula", "reason"),
    [
        (r"\sum_{i=1}^{n} a_i = a_1 + a_2 + \sum_{i=3}^{n} a_i", "fails for some sums"),  # false for n = 1
        (
            r"\sum_{i=1}^{n} m_i x_i = m_1 x_1 + m_2 x_2",
            "fails for some sums",
        ),  # a text may say n = 2 somewhere
        (r"\sum_{i=1}^{n} a_i = \sum_{i=1}^{20} a_i + \sum_{i=21}^{n} a_i", "fails for some sums"),
        (r"\sum_{i=1}^{n} i = \frac{n(n+1)}{2}", "no range is stated for n"),
        (r"M y_1 = \sum_i m_i x_i", "it may say something of"),
        (r"\sum_i m_i x_i = 0", "it may say something of"),
    ],
)
def test_sums_not_proved_for_every_n_are_unchecked(formula: str, reason: str) -> None:
    verdict = check(formula, SYMBOLS).verdict
    assert verdict.outcome == "unchecked" and reason in verdict.reason


def test_a_false_sum_is_refuted_by_one_that_is_long_enough() -> None:
    product = r"\sum_{i=1}^{n} a_i b_i = \left(\sum_{i=1}^{n} a_i\right) \left(\sum_{i=1}^{n} b_i\right)"
    verdict = check(product, SYMBOLS).verdict
    assert verdict.outcome == "refuted" and verdict.reason == "for n = 2"


@pytest.mark.parametrize(
    ("formula", "definitions"),
    [
        (r"\sum_{i=1}^{n} x_i = \sum_{i=1}^{n} a_i \omega", [r"x_i = a_i \omega"]),
        (r"\sum_i x_i = \omega \sum_i b_i (1 + b_i)", [r"a_i = b_i^2", r"x_i = (a_i + b_i) \omega"]),
        (r"\sum_i m_i \dot{x}_i = \sum_i m_i (\dot{\omega} + \dot{y}_i)", [r"x_k = \omega + y_k"]),
        (
            r"\frac{d}{dt} \sum_i x_i = \sum_i \dot{a}_i \omega + \sum_i a_i \dot{\omega}",
            [r"x_i = a_i \omega"],
        ),
    ],
)
def test_definitions_for_each_index_are_substituted(formula: str, definitions: list[str]) -> None:
    found = check(formula, SYMBOLS, definitions=definitions)
    assert found.verdict.outcome == "proved" and found.verdict.scope.startswith("all"), found
    left, right = formula.split("=", 1) if r"\sum_{" not in formula else formula.split(" = ")
    damaged = check(rf"{left} = 2 \left({right}\right)", SYMBOLS, definitions=definitions)
    assert damaged.verdict.outcome == "refuted", damaged


@pytest.mark.parametrize(
    "definitions",
    [
        [r"x_1 = a_1 \omega", r"x_{i+1} = a_{i+1} \omega"],
        [r"y_1 = \omega", r"a_i = y_i \cdot y_i", r"x_i = y_i^2 \omega"],
    ],
)
def test_a_family_with_a_separately_defined_member_is_not_free(definitions: list[str]) -> None:
    formula = r"\sum_{i=1}^{n} x_i = \sum_{i=1}^{n} a_i \omega"
    assert check(formula, SYMBOLS, definitions=definitions).verdict.outcome == "unchecked"


def test_a_sum_over_nothing_or_in_a_definition_needs_bounds() -> None:
    for formula, definitions in ((r"\sum_k \omega = \omega", []), ("M = 0", [r"M = \sum_i a_i"])):
        with pytest.raises(ValueError, match="expected the bounds of the sum"):
            check(formula, SYMBOLS, definitions=definitions)


def test_an_inequation_of_sums_is_not_proved_by_addends():
    found = check(r"\sum_{k=1}^{n} m_k x_k \neq \sum_{k=1}^{n} x_k m_k", SYMBOLS)
    assert found.verdict.outcome == "refuted", found.verdict.reason
