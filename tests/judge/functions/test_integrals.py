"""Integrals and limits: what follows from their linearity, what is pulled out, and what is not refuted."""

from __future__ import annotations

from typing import Any

import pytest

from workbench import check
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.verdict import Outcome

SYMBOLS: dict[str, Any] = {
    **dict.fromkeys(("f", "g", "m", "h", r"\theta"), "scalar"),
    **dict.fromkeys(("r", "v", r"\omega"), "vector"),
    "c": {"kind": "vector", "constant": True},
    "k": {"kind": "scalar", "constant": True},
    "A": "matrix 2×2",
}
LINEAR = [
    (r"\int (f + 2 g)\, dt = %s", r"\int f\, dt + 2 \int g\, dt", r"\int f\, dt + \int g\, dt"),
    (r"\int_0^1 k f\, \mathrm{d}t = %s", r"k \int_0^1 f\, \mathrm{d}t", r"\int_0^1 f\, \mathrm{d}t"),
    (r"\int_B c \times r\, dm = %s", r"c \times \int_B r\, dm", r"\int_B r\, dm \times c"),
    (r"\int_B r \times v\, dm = %s", r"-\int_B v \times r\, dm", r"\int_B v \times r\, dm"),
    (r"\int_B (\tilde{r} v)\, dm = %s", r"\int_B r \times v\, dm", r"\int_B -r \times v\, dm"),
    (r"\left(\int A\, dt\right)^T = %s", r"\int A^T\, dt", r"\int A\, dt"),
    (r"\iint f\, dA - \iint g\, dA = %s", r"\iint (f - g)\, dA", r"\iint (g - f)\, dA"),
    (r"\lim_{h \to 0} (f + g) = %s", r"\lim_{h \to 0} f + \lim_{h \to 0} g", r"\lim_{h \to 0} f - \lim_{h \to 0} g"),
]  # fmt: skip


@pytest.mark.parametrize(("formula", "true", "false"), LINEAR)
def test_integral_is_linear(formula: str, true: str, false: str) -> None:
    assert check(formula % true, SYMBOLS).outcome is Outcome.PROVED
    assert check(formula % false, SYMBOLS).outcome in (Outcome.REFUTED, Outcome.ILL_FORMED)


def test_integral_of_a_product_by_a_definition() -> None:
    inertia = {"J": r"\int_B ((r \cdot r) \mathbf{I} - r r^T)\, dm"}
    true = check(r"J \omega = \int_B r \times (\omega \times r)\, dm", SYMBOLS, definitions=inertia)
    assert (true.outcome, true.verdict.code) == (Outcome.CONDITIONAL, VerdictCode.KEPT_IN_INTEGRAL)
    assert true.verdict.hypothesis == r"\omega \text{ is the same for each } m"
    false = check(r"J \omega = -\int_B r \times (\omega \times r)\, dm", SYMBOLS, definitions=inertia)
    assert false.outcome is Outcome.REFUTED


def test_integral_reads_back_with_its_bounds() -> None:
    checked = check(r"\int_0^k 2 f\, dt = 2 \int_{0}^{k} f\, \mathrm{d}t", SYMBOLS)
    assert checked.outcome is Outcome.PROVED
    assert checked.verdict.read_back == (
        r"\int_{0}^{k} 2 f \, \mathrm{d}t = 2 \left(\int_{0}^{k} f \, \mathrm{d}t\right)"
    )
