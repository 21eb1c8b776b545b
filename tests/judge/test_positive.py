"""`positive = true`: a number that is more than 0 has a root, and may be divided by."""

from __future__ import annotations

import pytest

from workbench import check
from workbench.core.formula_errors import SpecError
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


def test_a_counterexample_is_positive() -> None:
    against = check(r"m^2 = m", symbols=SYMBOLS).verdict.counterexample
    assert against.left != against.right
    assert all(float(entry) >= 0 for entries in against.defined.values() for entry in entries)


@pytest.mark.parametrize(
    "spec", [{"kind": "vector", "positive": True}, {"kind": "dual scalar", "positive": True}]
)
def test_only_scalars_are(spec: dict) -> None:
    with pytest.raises(SpecError, match="positive"):
        SymbolTable.build({"a": spec})


def test_a_counterexample_tells_it_and_not_its_root() -> None:
    against = check(r"\sqrt{m r} = \sqrt{m} r", symbols=SYMBOLS).verdict.counterexample
    (m,), (r,), (left,), (right,) = against.values["m"], against.values["r"], against.left, against.right
    assert float(left) ** 2 == float(m) * float(r) and float(right) ** 2 == float(m) * float(r) ** 2
