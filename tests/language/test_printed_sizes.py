"""The size that is printed below a zero or a unit matrix binds: it fits and is read back, or the formula is ill-formed."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import pytest

from workbench import check
from workbench.judge.verdict import Outcome
from workbench.language.typed.errors import ReadError

SIZES = range(1, 7)
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
    "-A + A = %s - %s",
]
BESIDE_ZERO = ["A - A = %s", "A + %s = A", "A = A - 2 %s", "%s + %s = A - A"]


@pytest.fixture(scope="module")
def notation(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("sizes") / "notation.toml"
    file.write_text(NOTATION, encoding="utf-8")
    return file


def outcome(formula: str, symbol: tuple[int, int], notation: Path) -> tuple[Outcome, str]:
    kind = "scalar" if symbol == (1, 1) else f"matrix {symbol[0]}×{symbol[1]}"
    result = check(formula, {"A": kind}, notation=notation)
    return result.outcome, f"{result.verdict.reason} {result.verdict.read_back}"


def both(one: tuple[int, int], other: tuple[int, int], said: str) -> bool:
    return all(f"{rows}×{columns}" in said for rows, columns in (one, other))


@pytest.mark.parametrize("layout", BESIDE_ZERO)
@pytest.mark.parametrize("spelling", ZEROS)
def test_zero_of_a_printed_size_fits_that_size_alone(layout: str, spelling: str, notation: Path) -> None:
    for own, printed in product(
        product(SIZES, SIZES), [(1, 1), (3, 1), (1, 3), (3, 3), (4, 4), (6, 1), (2, 5)]
    ):
        zero = spelling % printed
        found, said = outcome(layout.replace("%s", zero), own, notation)
        if own == printed:
            assert found == Outcome.PROVED, (layout, zero, own, said)
            assert rf"{printed[0]} \times {printed[1]}" in said
        else:
            assert found == Outcome.ILL_FORMED, (layout, zero, own, said)
            assert both(own, printed, said), said


@pytest.mark.parametrize("layout", BESIDE_UNIT)
@pytest.mark.parametrize("spelling", [*UNITS, *SIZED_UNITS])
def test_unit_matrix_of_a_printed_size_fits_it_alone(layout: str, spelling: str, notation: Path) -> None:
    for own, size in product(SIZES[1:], SIZES[1:]):
        unit = spelling % ((size,) * spelling.count("%d"))
        found, said = outcome(layout.replace("%s", unit), (own, own), notation)
        if own != size:
            assert found == Outcome.ILL_FORMED, (layout, unit, own, said)
            assert both((own, own), (size, size), said), said
        else:
            expected = {Outcome.CONDITIONAL, Outcome.PROVED} if "-1" in layout else {Outcome.PROVED}
            assert found in ({Outcome.REFUTED} if layout.startswith("-A") else expected), (layout, unit, said)


@pytest.mark.parametrize("zero", [r"0_%d", r"\mathbf{0}_{%d}", r"\mathbb{O}_%d"])
def test_zero_of_one_number_is_a_column_or_a_square(zero: str, notation: Path) -> None:
    for rows, columns, size in product(SIZES[1:], SIZES, SIZES[1:]):
        found, said = outcome(f"A - A = {zero % size}", (rows, columns), notation)
        fits = rows == size and columns in (1, size)
        assert found == (Outcome.PROVED if fits else Outcome.ILL_FORMED), (rows, columns, size, said)


def test_zero_of_one_number_beside_a_row_is_asked_about() -> None:
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


@pytest.mark.parametrize("name", ["I_3", "I_{3 \\times 3}", "E_4", "\\mathbf{1}_3", "\\mathbb{O}_3"])
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
