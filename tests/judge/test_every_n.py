"""What is judged for some n: shown for every n by the rules of goals, or said of those alone."""

from __future__ import annotations

import pytest

from workbench import check

SYMBOLS = {"a": "vector", "b": "vector", "h": "scalar", "y_k": "vector"}
LEIBNIZ = r"(a \times b)^{(n)} = \sum_{k=0}^{n} C_n^k a^{(k)} \times b^{(n-k)}"
#: N₇ is apart from its recurrence, and z₃ is not 0 as those before it are.
DEFINITIONS = [r"N_0 = h", r"N_7 = 0 h", r"N_{n+1} = \dot{N}_n", "z_0 = 0 h", "z_1 = 0 h", "z_2 = 0 h", "z_{n+3} = h + z_n"]  # fmt: skip


@pytest.mark.parametrize(
    ("formula", "orders", "scope"),
    [
        (LEIBNIZ, "n = 0..2", "all n ≥ 0"),
        (LEIBNIZ, "n = 2..3", "all n ≥ 2"),
        (r"z_n = 0", "n = 0..2", "n = 0..2"),
        (r"\sum_{k=0}^{n} C_k^3 y_k = \mathbf{0}", "n = 0..2", "n = 0..2"),
        (r"\sum_{k=0}^{n} N_{k+1} = \sum_{k=0}^{n} \dot{N}_k", "n = 0..2", "n = 0..2"),
    ],
)
def test_the_scope_is_what_is_shown(formula: str, orders: str, scope: str) -> None:
    verdict = check(formula, SYMBOLS, definitions=DEFINITIONS, orders=orders).verdict
    assert (verdict.outcome, verdict.scope) == ("proved", scope), verdict.reason


@pytest.mark.parametrize(("old", "new"), [("C_n^k", "C_{n+1}^k"), ("k=0", "k=1"), ("C_n^k", "2 C_n^k")])
def test_false_ones_are_refuted(old: str, new: str) -> None:
    verdict = check(LEIBNIZ.replace(old, new), SYMBOLS, orders="n = 0..2").verdict
    assert verdict.outcome == "refuted", verdict
