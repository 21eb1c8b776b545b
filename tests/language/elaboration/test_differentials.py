"""Differentials: d x by any sign of it, the d that is a symbol, and equations that are not homogeneous."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench import check
from workbench.core.verdict import Outcome
from workbench.papers.drafting.inference.differential_letters import has_differentials

SYMBOLS = {
    **dict.fromkeys(("f", "g", "r", r"\phi"), "scalar"),
    **dict.fromkeys(("x", "y"), "vector"),
    **dict.fromkeys(("A", "B"), "matrix 2×2"),
    "R": "rotation",
    "c": {"kind": "scalar", "constant": True},
}


def test_differential_reads_back_as_a_rate() -> None:
    assert check("d(f g) = g df + f dg", SYMBOLS).verdict.read_back == (
        r"\left(f g\right)^{(1)} = g \dot{f} + f \dot{g}"
    )


def test_notation_of_the_paper_goes_first(tmp_path: Path) -> None:
    file = tmp_path / "notation.toml"
    file.write_text(
        "[notation]\n'\\mathrm{d} X' = { where = { X = \"scalar\" }, means = '2 X' }\n"
        "[symbols]\n'f' = \"scalar\"\n",
        encoding="utf-8",
    )
    assert check(r"\mathrm{d} f = f + f", None, notation=file).outcome is Outcome.PROVED


@pytest.mark.parametrize(
    ("formulas", "is_sign"),
    [
        (["d(x y) = x dy + y dx"], True),
        ([r"\begin{bmatrix} dx \\ 0 \end{bmatrix} = A \begin{bmatrix} du \\ dv \end{bmatrix}"], True),
        ([r"\frac{d}{dt} x = y"], False),
        (["d x = x d"], False),
        (["d(x y) = x dy", "x = y + d"], False),
        (["x = y"], False),
    ],
)
def test_italic_d_of_a_text_is_a_sign_by_its_formulas(formulas: list[str], is_sign: bool) -> None:
    assert has_differentials(formulas) is is_sign
