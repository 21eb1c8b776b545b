"""x_{12}, x_{1 2} and x_{1,2} mean the declared symbol, or the member of the family that has two indices."""

from __future__ import annotations

import pytest

from workbench.core.formula_errors import ReadError
from workbench.core.terms import Symbol
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read_term


def named(latex: str, *declared: str) -> str:
    term = read_term(latex, SymbolTable.build({key: {"kind": "scalar"} for key in declared}), {"j"})
    assert isinstance(term, Symbol)
    return term.declaration.name.latex(term.index)


@pytest.mark.parametrize("declared", ["x_{i j}", "x_{ij}", "x_{i,j}"])
@pytest.mark.parametrize("written", ["x_{12}", "x_{1 2}", "x_{1,2}"])
def test_a_family_of_two_indices_has_each_spelling(declared: str, written: str) -> None:
    between = "," if "," in declared else " "
    assert named(written, declared) == named(written, declared, "x_i") == f"x_{{1{between}2}}"


@pytest.mark.parametrize("written", ["x_{12}", "x_{1 2}", "x_{1,2}"])
def test_a_symbol_has_each_spelling(written: str) -> None:
    assert named(written, "x_{12}") == "x_{12}"


@pytest.mark.parametrize(
    ("written", "declared", "expected"),
    [
        ("x_{12}", ["x_i"], "x_{12}"),
        ("x_{1j}", ["x_{ij}", "x_i"], "x_{1 j}"),
        ("x_{2j}", ["x_{ij}", "x_i"], "x_{2 j}"),
        ("x_{j}", ["x_{ij}", "x_i"], "x_{j}"),
        ("x_{2j}", ["x_i"], "x_{2j}"),
        ("x_{123}", ["x_{ijk}"], "x_{1 2 3}"),
    ],
)
def test_indices_are_distinguished(written: str, declared: list[str], expected: str) -> None:
    assert named(written, *declared) == expected


@pytest.mark.parametrize(
    ("written", "declared"), [("x_{0 1}", "x_1"), ("x_{1j}", "x_i"), ("x_{12}", "x_{ijk}")]
)
def test_no_figure_is_lost(written: str, declared: str) -> None:
    with pytest.raises(ReadError, match="unknown symbol"):
        named(written, declared)
