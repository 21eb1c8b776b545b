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


def test_a_sum_over_nothing_or_in_a_definition_needs_bounds() -> None:
    for formula, definitions in ((r"\sum_k \omega = \omega", []), ("M = 0", [r"M = \sum_i a_i"])):
        with pytest.raises(ValueError, match="expected the bounds of the sum"):
            check(formula, SYMBOLS, definitions=definitions)
