"""Corrections by their kind: rows and columns of signs, exchanged rows, what is missing in ill-formed prints; and
no proposal that says nothing."""

from __future__ import annotations

from typing import Any

import pytest

from workbench import Checked, check
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read
from workbench.repair.screening.vacuous import is_trivial

SYMBOLS: dict[str, Any] = {
    **{name: {"kind": "vector"} for name in ("a", "b", "c")},
    **{name: {"kind": "scalar"} for name in ("x", "y", "z", r"\theta")},
    "M": {"kind": "tensor"},
    "R": {"kind": "rotation"},
    "n": {"kind": "vector", "unit": True},
}
ATTITUDE = {"q": {"kind": "hamilton quaternion", "unit": True}}
SKEW = r"\operatorname{skew} \begin{bmatrix} x \\ y \\ z \end{bmatrix} = "
TURN = r"\exp(\theta \operatorname{skew} \begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix}) = "


@pytest.mark.parametrize(
    ("latex", "right"),
    [
        (
            SKEW + r"\begin{bmatrix} 0 & z & -y \\ z & 0 & -x \\ -y & x & 0 \end{bmatrix}",
            r"0 & -z & y \\ z & 0 & -x \\ -y & x & 0",
        ),
        (
            SKEW + r"\begin{bmatrix} 0 & -z & -y \\ z & 0 & x \\ -y & x & 0 \end{bmatrix}",
            r"0 & -z & y \\ z & 0 & -x \\ -y & x & 0",
        ),
        (
            TURN + r"\begin{bmatrix} \sin\theta & \cos\theta & 0 \\ \cos\theta & -\sin\theta & 0 \\ 0 & 0 & 1 \end{bmatrix}",
            r"\cos \theta & -\sin \theta & 0 \\ \sin \theta & \cos \theta & 0 \\ 0 & 0 & 1",
        ),
        (
            TURN + r"\begin{bmatrix} -\sin\theta & \cos\theta & 0 \\ \cos\theta & \sin\theta & 0 \\ 0 & 0 & 1 \end{bmatrix}",
            r"\cos \theta & -\sin \theta & 0 \\ \sin \theta & \cos \theta & 0 \\ 0 & 0 & 1",
        ),
        (r"a \times (b \times c) = b (a \cdot c) - (a \cdot b)", r"- (a \cdot b) c"),
        (r"a b = b^T a", r"a^{T} b = b^{T} a"),
        (r"R R a = a", r"R^{T} R a = a"),
        (
            r"\begin{bmatrix} x \\ y \\ z \end{bmatrix} \times \begin{bmatrix} 0 \\ 0 \\ 1 \end{bmatrix} = \begin{bmatrix} y \\ -x \end{bmatrix}",
            r"\begin{bmatrix} y \\ - x \\ 0 \end{bmatrix}",
        ),
        (
            r"\exp(\theta \operatorname{skew} n) = \mathbf{I} + \sin\theta \operatorname{skew} n + \cos\theta (\operatorname{skew} n)^2",
            r"1 - \cos \theta",
        ),
    ],
    ids=["row of signs", "column of signs", "rows", "columns", "factor", "transpose", "other transpose", "row", "1 -"],
)  # fmt: skip
def test_correction_of_a_kind(latex: str, right: str) -> None:
    found = check(latex, SYMBOLS)
    assert isinstance(found, Checked)
    assert right in found.repair().proposed()[0].latex


@pytest.mark.parametrize(
    ("latex", "trivial"),
    [
        (r"(M^T)^T = M", True),
        (r"M = -(M - 2 M)", True),
        (r"(-(M - 2 M))^T = M^T", True),
        (r"(R^{-1})^{-1} = R", True),
        (r"(q^*)^* = q", True),
        (r"3 a = a + 2 a", True),
        (r"a = a 1", True),
        (r"M^T = -(M - 2 M)", False),
        (r"(M^T)^T = M^T", False),
        (r"R^{-1} = R^T", False),
        (r"3 a = a + a", False),
    ],
)
def test_equation_that_says_nothing(latex: str, trivial: bool) -> None:
    (said,) = read(latex, SymbolTable.build(SYMBOLS | ATTITUDE))
    assert is_trivial(said) is trivial


@pytest.mark.parametrize("latex", [r"M^T = M", r"q^* = q", r"M^T = -(M - 2 M)"])
def test_no_void_proposal(latex: str) -> None:
    found = check(latex, SYMBOLS | ATTITUDE)
    assert isinstance(found, Checked)
    for proposal in found.repair().proposed():
        (said,) = read(proposal.latex, SymbolTable.build(SYMBOLS | ATTITUDE))
        assert not is_trivial(said), proposal.latex


@pytest.mark.parametrize(
    "latex", [r"\sqrt{1 + f^2} = 1 + f", r"f^2 + 1 = f + 1", r"\frac{1 + f}{2 + f^2} = \frac{1}{2}"]
)
def test_proposals_keep_a_symbol(latex: str) -> None:
    found = check(latex, {"f": "scalar"})
    assert isinstance(found, Checked)
    assert all("f" in proposal.latex.replace("frac", "") for proposal in found.repair().proposed())
