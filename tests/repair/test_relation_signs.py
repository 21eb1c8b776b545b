"""Corrections that write another sign between two sides."""

from __future__ import annotations

from typing import Any

import pytest

from workbench import Checked, check

SYMBOLS: dict[str, Any] = {
    "a": "vector",
    "b": "vector",
    "x": "scalar",
    r"\epsilon": {"kind": "scalar", "small": True},
}


@pytest.mark.parametrize(
    ("printed", "right"),
    [
        (r"a \times b \neq -b \times a", r"a \times b = -b \times a"),
        (r"\sin\epsilon = \epsilon", r"\sin \epsilon \approx \epsilon"),
        (r"(1 + \epsilon)^2 = 1 + 2 \epsilon", r"\left(1 + \epsilon\right)^{2} \approx 1 + 2 \epsilon"),
    ],
)
def test_other_sign_is_proposed_where_it_holds(printed: str, right: str) -> None:
    checked = check(printed, SYMBOLS)
    assert isinstance(checked, Checked)
    (proposal,) = checked.repair().proposals
    assert (proposal.latex, proposal.changes[0].kind) == (right, "relation")


@pytest.mark.parametrize("printed", [r"(1 + \epsilon)^2 = 1 + \epsilon", r"(1 + x)^2 = 1 + x"])
def test_other_sign_is_not_proposed_where_it_is_false(printed: str) -> None:
    checked = check(printed, SYMBOLS)
    assert isinstance(checked, Checked)
    assert all(change.kind != "relation" for each in checked.repair().proposals for change in each.changes)
