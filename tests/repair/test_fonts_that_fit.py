"""A letter in another font or without an arrow makes a formula well-typed that defines its left side."""

from __future__ import annotations

import pytest

from workbench import check
from workbench.core.verdict import Outcome
from workbench.repair.propose.search_limits import Limits

SYMBOLS = {
    "r": "scalar",
    r"\vec{r}": "vector",
    r"\mathbf{m}": "vector",
    "m": "scalar",
    r"\vec{v}": "vector",
    "u": "vector",
}


@pytest.mark.parametrize(
    ("printed", "right"),
    [
        (r"\vec{v} = -\vec{r} u", r"\vec{v} = - r u"),
        (r"\vec{v} = u \times \vec{r} u", r"\vec{v} = u \times r u"),
        (r"\vec{v} = \mathbf{m} u + \vec{r}", r"\vec{v} = m u + \vec{r}"),
    ],
)
def test_letter_in_the_wrong_font_is_replaced(printed: str, right: str) -> None:
    checked = check(printed, SYMBOLS)
    assert checked.outcome is Outcome.ILL_FORMED
    found = [each.latex.replace(" ", "") for each in checked.repair(Limits(seconds=60)).proposals]
    assert right.replace(" ", "") in found
