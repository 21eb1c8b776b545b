"""Two factors in the wrong order change places, where the printed order has no type and where it is false."""

from __future__ import annotations

import pytest

from workbench import check
from workbench.core.verdict import Outcome
from workbench.repair.propose.search_limits import Limits

SYMBOLS = {
    "T": "tensor",
    "u": "vector",
    "r": "vector",
    "A": "matrix 3×4",
    "B": "matrix 4×2",
    "x": "matrix 2×1",
    **dict.fromkeys("ijk", "hamilton quaternion"),
}
UNITS = {
    "i": r"\operatorname{quat}(0, (1, 0, 0))",
    "j": r"\operatorname{quat}(0, (0, 1, 0))",
    "k": r"\operatorname{quat}(0, (0, 0, 1))",
}
PATIENT = Limits(seconds=60)


@pytest.mark.parametrize(
    ("printed", "right"),
    [
        (r"u \times r = r \tilde{u}", r"u \times r = \tilde{u} r"),
        (r"T^T r \cdot u = r \cdot (u T)", r"T^{T} r \cdot u = r \cdot (T u)"),
        (r"x^T B^T A^T = (B A x)^T", r"x^{T} B^{T} A^{T} = (A B x)^{T}"),
    ],
)
def test_factors_without_a_type_change_places(printed: str, right: str) -> None:
    checked = check(printed, SYMBOLS)
    assert checked.outcome is Outcome.ILL_FORMED
    found = [proposal.latex for proposal in checked.repair(PATIENT).proposals]
    assert any(right.replace(" ", "") in each.replace(" ", "") for each in found), found


@pytest.mark.parametrize(("printed", "right"), [("i k j = -1", "i j k"), ("k j = i", "j k = i")])
def test_units_of_quaternions_change_places(printed: str, right: str) -> None:
    """Their values are numbers: that both sides are the same numbers does not make two forms one."""
    found = check(printed, SYMBOLS, definitions=UNITS).repair(PATIENT).proposals
    assert len(found) > 1
    assert any(right in proposal.latex for proposal in found), found
