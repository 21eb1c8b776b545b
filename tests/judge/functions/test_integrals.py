"""Integrals and limits: what follows from their linearity, what is pulled out, and what is not refuted."""

from __future__ import annotations

from typing import Any

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


def test_integral_of_a_product_by_a_definition() -> None:
    inertia = {"J": r"\int_B ((r \cdot r) \mathbf{I} - r r^T)\, dm"}
    true = check(r"J \omega = \int_B r \times (\omega \times r)\, dm", SYMBOLS, definitions=inertia)
    assert (true.outcome, true.verdict.code) == (Outcome.CONDITIONAL, VerdictCode.KEPT_IN_INTEGRAL)
    assert str(true.verdict.hypothesis) == r"\omega \text{ is the same for each } m"
    false = check(r"J \omega = -\int_B r \times (\omega \times r)\, dm", SYMBOLS, definitions=inertia)
    assert false.outcome is Outcome.REFUTED


def test_integral_reads_back_with_its_bounds() -> None:
    checked = check(r"\int_0^k 2 f\, dt = 2 \int_{0}^{k} f\, \mathrm{d}t", SYMBOLS)
    assert checked.outcome is Outcome.PROVED
    assert checked.verdict.read_back == (
        r"\int_{0}^{k} 2 f \, \mathrm{d}t = 2 \left(\int_{0}^{k} f \, \mathrm{d}t\right)"
    )
