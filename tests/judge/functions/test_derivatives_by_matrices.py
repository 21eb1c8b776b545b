"""Derivatives of scalars by matrices: the known rules, the layout, and what is no free matrix."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench import Checked, check
from workbench.core.verdict import Outcome

CONSTANT = "constant = true"
RULES = {
    r"\operatorname{tr}(A X)": ("A^T", "A"),
    r"\operatorname{tr}(X^T A X)": ("(A + A^T) X", "2 A X"),
    r"\operatorname{tr}(X B X^T)": ("X (B + B^T)", "(B + B^T) X"),
    r"\det X": (r"(\det X) X^{-T}", r"(\det X) X^{-1}"),
    r"a^T X b": ("a b^T", "b a^T"),
    r"\operatorname{tr}(X^{-1} A)": ("-(X^{-1} A X^{-1})^T", "(X^{-1} A X^{-1})^T"),
}


def judged(formula: str, layout: str, size: int, folder: Path, **more: str) -> Checked:
    square, column = f"matrix {size}×{size}", f"matrix {size}×1"
    kinds = {"X": square, "A": square, "B": square, "a": column, "b": column} | more
    symbols = "".join(
        f"'{name}' = {{ kind = \"{kind}\"{'' if name == 'X' else ', ' + CONSTANT} }}\n"
        for name, kind in kinds.items()
    )
    file = folder / "notation.toml"
    file.write_text(f"[conventions]\ngradient = '{layout}'\n[symbols]\n{symbols}", encoding="utf-8")
    checked = check(formula, None, notation=file)
    assert isinstance(checked, Checked)
    return checked


@pytest.mark.parametrize("size", [2, 3])
@pytest.mark.parametrize("of", RULES)
def test_derivative_of_a_scalar_by_a_matrix(of: str, size: int, tmp_path: Path) -> None:
    if size == 3 and "^{-1}" in of:
        pytest.skip("the inverse of a free matrix of 3×3 has too many terms")
    true, false = RULES[of]
    for value, outcomes in (
        (true, (Outcome.PROVED, Outcome.CONDITIONAL)),
        (false, (Outcome.REFUTED,)),
    ):
        column = judged(rf"\frac{{\partial}}{{\partial X}} ({of}) = {value}", "column", size, tmp_path)
        assert column.outcome in outcomes, value
    row = judged(rf"\frac{{\partial}}{{\partial X}} ({of}) = ({true})^T", "row", size, tmp_path)
    assert row.outcome in (Outcome.PROVED, Outcome.CONDITIONAL)


def test_derivative_by_a_matrix_that_is_not_square(tmp_path: Path) -> None:
    kinds = {"X": "matrix 2×3", "a": "matrix 2×1", "b": "matrix 3×1"}
    formula = r"\frac{\partial}{\partial X} (a^T X b) = %s"
    assert judged(formula % "a b^T", "column", 2, tmp_path, **kinds).outcome is Outcome.PROVED
    assert judged(formula % "2 a b^T", "column", 2, tmp_path, **kinds).outcome is Outcome.REFUTED


@pytest.mark.parametrize("said", ['"rotation"', '{ kind = "tensor", symmetric = true }'])
def test_constrained_matrix_is_no_variable(said: str, tmp_path: Path) -> None:
    file = tmp_path / "notation.toml"
    file.write_text(f"[conventions]\ngradient = 'column'\n[symbols]\n'X' = {said}\n", encoding="utf-8")
    formula = r"\frac{\partial}{\partial X} (\operatorname{tr} X) = \mathbf{I}"
    assert check(formula, None, notation=file).outcome is Outcome.UNCHECKED
