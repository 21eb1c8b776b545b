"""The size that is printed below a zero or a unit matrix binds: it fits and is read back, or the formula is ill-formed."""

from __future__ import annotations

from functools import cache
from itertools import product
from pathlib import Path

import pytest

from workbench import check
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.verdict import Outcome
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read
from workbench.papers import load_notation
from workbench.papers.notation_tables import extended

SIZES = range(1, 7)
PAIRS = [(1, 1), (3, 1), (1, 3), (3, 3), (4, 4), (6, 1), (2, 5), (6, 6)]
NOTATION = """
[notation]
'E' = { means = '\\mathbf{I}' }
'\\mathbf{1}' = { means = '\\mathbf{I}' }
'\\mathbb{1}_{3\\times 3}' = { means = '\\mathbf{I}' }
'\\mathbb{O}' = { means = '\\mathbf{0}' }
"""
#: Spellings of a unit matrix with one number below it, and with two.
UNITS = [r"\mathbf{I}_%d", r"\mathbf{I}_{%d}", "E_%d", r"\mathbf{1}_{%d}"]
SIZED_UNITS = [
    r"I_{%d \times %d}",
    r"\mathbf{I}_{%d\times%d}",
    r"\mathbb{I}_{%d \times %d}",
    r"E_{%d \times %d}",
]
ZEROS = [r"0_{%d \times %d}", r"\mathbf{0}_{%d\times%d}", r"\mathbb{O}_{%d\times %d}", r"(0)_{%d \times %d}"]
#: A unit matrix or a zero of the size of the symbol A, and how it stands there.
BESIDE_UNIT = [
    "A A^{-1} = %s",
    "A + %s = %s + A",
    "A %s = A",
    "%s A = A",
    "2 A - A (2 %s) = A - A",
    "A - A = %s - %s",
]
BESIDE_ZERO = ["A - A = %s", "A + %s = A", "A = A - (%s)", "%s + %s = A - A"]


@pytest.fixture(scope="module")
def notation(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("sizes") / "notation.toml"
    file.write_text(NOTATION, encoding="utf-8")
    return file


@cache
def table(rows: int, columns: int, notation: Path) -> SymbolTable:
    return extended(load_notation(notation), {"A": {"kind": kind(rows, columns)}}).symbols


def kind(rows: int, columns: int) -> str:
    return "scalar" if (rows, columns) == (1, 1) else f"matrix {rows}×{columns}"


def misfit(formula: str, symbol: tuple[int, int], notation: Path) -> str:
    """Why the formula is ill-formed with a symbol A of that size; nothing where it is not. It is read back as
    it is printed."""
    known = table(*symbol, notation)
    try:
        (statement,) = read(formula, known)
    except IllFormedAt as error:
        return str(error)
    assert read(to_latex(statement), known) == (statement,)
    return ""


def both(one: tuple[int, int], other: tuple[int, int], said: str) -> bool:
    return all(f"{rows}×{columns}" in said for rows, columns in (one, other))


@pytest.mark.parametrize("layout", BESIDE_ZERO)
@pytest.mark.parametrize("spelling", ZEROS)
def test_zero_of_a_printed_size_fits_that_size_alone(layout: str, spelling: str, notation: Path) -> None:
    for own, printed in product(PAIRS, PAIRS):
        formula = layout.replace("%s", spelling % printed)
        said = misfit(formula, own, notation)
        assert bool(said) == (own != printed), (formula, own)
        assert both(own, printed, said) if said else True, said
    assert check(layout.replace("%s", spelling % (2, 5)), {"A": kind(2, 5)}, notation=notation).holds


@pytest.mark.parametrize("layout", BESIDE_UNIT)
@pytest.mark.parametrize("spelling", [*UNITS, *SIZED_UNITS])
def test_unit_matrix_of_a_printed_size_fits_it_alone(layout: str, spelling: str, notation: Path) -> None:
    for own, size in product(SIZES[1:], SIZES[1:]):
        formula = layout.replace("%s", spelling % ((size,) * spelling.count("%d")))
        said = misfit(formula, (own, own), notation)
        assert bool(said) == (own != size), (formula, own)
        assert both((own, own), (size, size), said) if said else True, said
    proved = layout.replace("%s", spelling % ((2,) * spelling.count("%d")))
    found = check(proved, {"A": kind(2, 2)}, notation=notation).outcome
    assert found == (Outcome.CONDITIONAL if "-1" in layout else Outcome.PROVED)


@pytest.mark.parametrize("zero", [r"0_%d", r"\mathbf{0}_{%d}", r"\mathbb{O}_%d"])
def test_zero_of_one_number_is_a_column_or_a_square(zero: str, notation: Path) -> None:
    for rows, columns, size in product(SIZES[1:], SIZES, SIZES[1:]):
        if (rows, columns) != (1, size):
            fits = rows == size and columns in (1, size)
            assert (misfit(f"A - A = {zero % size}", (rows, columns), notation) == "") == fits
    assert check(f"A - A = {zero % 2}", {"A": kind(2, 2)}, notation=notation).holds


def test_a_sized_zero_beside_a_row_raises_a_question() -> None:
    with pytest.raises(ReadError, match=r"a row of zeros is written 0_\{1 \\times 3\}"):
        check("x^T - x^T = 0_3", {"x": "vector"})


@pytest.mark.parametrize(
    ("corner", "fits"),
    [
        (r"0_{1 \times 3}", True),
        (r"0_3", True),
        (r"0_3^T", True),
        (r"0_{3 \times 1}^T", True),
        (r"0_{3 \times 1}", False),
        (r"0_{3 \times 3}", False),
        (r"0_{1 \times 4}", False),
        (r"0_4", False),
        (r"0_4^T", False),
    ],
)
def test_zero_in_a_block_matrix_has_the_size_of_its_place(corner: str, fits: bool) -> None:
    matrix = rf"\begin{{bmatrix}} R & v \\ {corner} & 1 \end{{bmatrix}}"
    kinds = {"R": "rotation", "v": "vector", "Y": "matrix 4×4"}
    found = check(rf"{matrix} Y - {matrix} Y = 0_{{4 \times 4}}", kinds).outcome
    assert found == (Outcome.PROVED if fits else Outcome.ILL_FORMED)


@pytest.mark.parametrize("name", ["I_3", "I_{3 \\times 3}", "E_4", "\\mathbb{O}_3"])
def test_declared_symbol_keeps_its_meaning(name: str, notation: Path) -> None:
    symbols = {name: "tensor", "B": "tensor"}
    assert check(f"{name} B - {name} B = 0_{{3 \\times 3}}", symbols, notation=notation).holds
    assert check(f"{name} B = B", symbols, notation=notation).outcome == Outcome.REFUTED


def test_unit_matrix_of_unequal_sizes_is_ill_formed() -> None:
    found = check(r"A = I_{3 \times 4}", {"A": "tensor"})
    assert found.outcome == Outcome.ILL_FORMED
    assert "3×4" in found.verdict.reason


def test_sizes_bind_in_definitions(notation: Path) -> None:
    symbols = {"R": "rotation", "Y": "matrix 4×4"}
    for unit in (r"I_{4 \times 4}", r"\mathbf{I}_4", "E_4"):
        defined = {"U": unit}
        wrong = check("R R^T = U", symbols, notation=notation, definitions=defined)
        assert wrong.outcome == Outcome.ILL_FORMED
        assert check("Y U = Y", symbols, notation=notation, definitions=defined).holds


@pytest.mark.parametrize("size", SIZES[1:])
def test_trace_and_determinant_take_the_printed_size(size: int) -> None:
    for right in SIZES:
        trace = check(rf"\operatorname{{tr}} \mathbf{{I}}_{size} = {right}", {})
        assert trace.outcome == (Outcome.PROVED if right == size else Outcome.REFUTED)
        scaled = check(rf"\det(2 I_{{{size} \times {size}}}) = {2**right}", {})
        assert scaled.outcome == (Outcome.PROVED if right == size else Outcome.REFUTED)
