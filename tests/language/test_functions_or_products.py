"""A bracket behind a symbol: the argument of a function under any notation before it, or asked about."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import pytest

from workbench import check
from workbench.core.formula_errors import ReadError
from workbench.core.verdict import Outcome
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read

MODEL = r"""
[conventions]
arguments = ['g']
[notation]
'\mathrm{d} X' = { where = { X = "matrix 2×2" }, means = '\dot{X}' }
'\delta X' = { where = { X = "matrix 2×2" }, means = '2 X' }
'\hat{X}' = { where = { X = "matrix 2×2" }, means = 'X^T' }
'\lfloor x \times \rfloor' = { where = { x = "vector" }, means = '\operatorname{skew}(x)' }
[symbols]
'A' = "matrix 2×2"
'B' = "matrix 2×2"
'g' = "matrix 2×2"
'x' = "vector"
'y' = "vector"
'R' = "rotation"
"""
#: A notation before A(g), and the same without it.
BEFORE = {
    r"\mathrm{d} %s": r"\dot{A}",
    r"\delta %s": "2 A",
    r"\operatorname{tr} %s": r"\operatorname{tr}(A)",
    r"\det %s": r"\det(A)",
    r"%s^{-1} A": "A^{-1} A",
    r"%s^T": "A^T",
}
AROUND = ["2 (%s) = %s + (%s)", "(%s) + 1 \\cdot (%s) = 2 (%s)"]


@pytest.fixture(scope="module")
def notation(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("arguments") / "notation.toml"
    file.write_text(MODEL, encoding="utf-8")
    return file


@pytest.mark.parametrize(("before", "around"), product(BEFORE, AROUND))
def test_notation_before_a_function_takes_its_value(before: str, around: str, notation: Path) -> None:
    shown, plain = before % "A(g)", BEFORE[before]
    sides = [shown, *[plain] * (around.count("%s") - 1)]
    wanted = (Outcome.PROVED, Outcome.CONDITIONAL) if "-1" in before else (Outcome.PROVED,)
    assert check(around % tuple(sides), None, notation=notation).outcome in wanted
    false = check(f"{shown} = 3 ({plain})", None, notation=notation).outcome
    assert false == Outcome.REFUTED


@pytest.mark.parametrize("before", ["%s", *BEFORE])
@pytest.mark.parametrize("argument", ["B", "B^{-1}"])
def test_bracket_of_a_matrix_after_a_matrix_raises_a_question(
    before: str, argument: str, notation: Path
) -> None:
    with pytest.raises(ReadError, match="a function of what is in the bracket, or a product"):
        check(f"{before % f'A({argument})'} = B", None, notation=notation)


@pytest.mark.parametrize("argument", [r"\theta", r"-\theta", r"2 \theta", r"-2 \theta"])
def test_bracket_that_fits_as_an_argument_only_raises_a_question(argument: str) -> None:
    kinds = {"J": "tensor", r"\theta": "vector"}
    with pytest.raises(ReadError, match=r"\[conventions\] arguments says the former"):
        check(rf"J({argument}) = \mathbf{{I}} - J", kinds)
    assert check(rf"J({argument}) - J ({argument}) = 0", kinds).holds


@pytest.mark.parametrize("matrix", ["A B", "A [B]", r"A \cdot (B)", "A (B + B)", "A (2 B)"])
def test_product_of_matrices_is_read(matrix: str, notation: Path) -> None:
    if r"\cdot" not in matrix:
        assert check(f"{matrix} = {matrix} + 0", None, notation=notation).outcome != Outcome.ILL_FORMED


@pytest.mark.parametrize(("vector", "spelled"), [("x", "x"), ("x + y", "(x + y)"), ("x - 2 y", "(x - 2 y)")])
def test_sign_behind_a_sum_in_a_bracket(vector: str, spelled: str, notation: Path) -> None:
    right = rf"{spelled} \times y"
    assert check(rf"\lfloor {vector} \times\rfloor y = {right}", None, notation=notation).holds
    wrong = check(rf"\lfloor {vector} \times\rfloor y = -{right}", None, notation=notation)
    assert wrong.outcome == Outcome.REFUTED


def test_rotation_before_an_exponential_is_a_product(notation: Path) -> None:
    assert check(r"Re^{\tilde{x}} y = R (e^{\tilde{x}} y)", None, notation=notation).holds


@pytest.mark.parametrize(
    ("formula", "readings"),
    [
        (r"A(B) = A", [r"arguments = ['B']", "A at B", r"A \cdot (B)"]),
    ],
)
def test_the_question_writes_both_readings(formula: str, readings: list[str]) -> None:
    table = SymbolTable.build({"A": {"kind": "tensor"}, "B": {"kind": "tensor"}, "x": {"kind": "vector"}})
    with pytest.raises(ReadError) as error:
        read(formula, table)
    assert all(each in str(error.value) for each in [*readings, "brackets = 'factors'"])
