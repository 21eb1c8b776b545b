"""Zeros and unit tensors, with signs and factors, take the shape that what stands beside them needs."""

from __future__ import annotations

import pytest

from workbench import check
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.verdict import Outcome
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read, read_term

KINDS = {
    "A": "tensor",
    "B": "tensor",
    "x": "vector",
    "y": "vector",
    r"\lambda": "scalar",
    r"\underline{s}": "dual scalar",
}
TABLE = SymbolTable.build({name: {"kind": kind} for name, kind in KINDS.items()})

DIAGONAL = r"\begin{bmatrix} A & \mathbf{0} \\ \mathbf{0} & B \end{bmatrix}"
COLUMN = r"\begin{bmatrix} x \\ y \end{bmatrix}"
NESTED = rf"\begin{{bmatrix}} {DIAGONAL} & M \\ 0 & {DIAGONAL} \end{{bmatrix}}"

MULTIPLES = [
    "{}",
    "-{}",
    "2{}",
    r"-2{}",
    r"\lambda {}",
    r"{} \lambda",
    r"\frac{{{}}}{{2}}",
    r"-({0} + 3 {0})",
    r"\underline{{s}} {}",
]


@pytest.mark.parametrize("multiple", MULTIPLES)
def test_a_multiple_of_the_unit_matrix_fits_its_neighbours(multiple: str) -> None:
    unit = multiple.format(r"\mathbf{I}")
    blocks = rf"\begin{{bmatrix}} {unit} & \mathbf{{0}} \\ \mathbf{{0}} & {unit} \end{{bmatrix}}"
    assert check(rf"{DIAGONAL} + ({unit}) = {DIAGONAL} + {blocks}", KINDS).holds
    assert check(rf"{unit} = {blocks}", KINDS).holds
    assert check(rf"({DIAGONAL} + ({unit})) {COLUMN} = {DIAGONAL} {COLUMN} + ({unit}) {COLUMN}", KINDS).holds


@pytest.mark.parametrize("multiple", MULTIPLES)
@pytest.mark.parametrize("beside", ["A", "x", r"\lambda", DIAGONAL, COLUMN, "x^T"])
def test_a_multiple_of_zero_has_any_shape(multiple: str, beside: str) -> None:
    zero = multiple.format(r"\mathbf{0}")
    assert check(rf"{beside} + ({zero}) = {beside}", KINDS).holds


@pytest.mark.parametrize("multiple", MULTIPLES)
def test_entries_of_a_block_matrix_take_the_shape_of_their_place(multiple: str) -> None:
    zero, unit = (multiple.format(symbol) for symbol in (r"\mathbf{0}", r"\mathbf{I}"))
    matrix = rf"\begin{{bmatrix}} A & {zero} \\ {zero} & 1 \end{{bmatrix}}"
    assert str(read_term(matrix, TABLE).type.with_dual(False)) == "matrix 4×4"
    assert str(read_term(NESTED.replace("M", unit), TABLE).type.with_dual(False)) == "matrix 12×12"


@pytest.mark.parametrize("unit", [r"\mathbf{I}", r"-\mathbf{I}", r"2\mathbf{I}"])
@pytest.mark.parametrize("beside", ["x", r"\lambda", COLUMN, r"\begin{bmatrix} A & x \end{bmatrix}"])
def test_the_unit_tensor_is_square(unit: str, beside: str) -> None:
    for formula in (f"{beside} = {unit}", f"{unit} = {beside}", f"{beside} + ({unit}) = {beside}"):
        with pytest.raises(IllFormedAt, match="the unit tensor and"):
            read(formula, TABLE)


@pytest.mark.parametrize(
    ("formula", "message"),
    [
        (r"\begin{bmatrix} x \\ x \end{bmatrix} \mathbf{I} = 0", "one row and one column"),
        (r"\begin{bmatrix} A & x \\ \mathbf{0} & \mathbf{I} \end{bmatrix} = 0", "one row and one column"),
        (
            r"\begin{bmatrix} x & \mathbf{I} \\ \mathbf{I} & A \end{bmatrix} = 0",
            "column 1 of the matrix holds",
        ),
        (r"\begin{bmatrix} A & B \\ x \end{bmatrix} = 0", "unequal lengths"),
        (
            r"\begin{bmatrix} \mathbf{D} & B \end{bmatrix} = 0",
            "expected matrices as entries of a matrix, got an operator",
        ),
        (rf"{DIAGONAL} = -A", "differ in type"),
        (rf"\mathbf{{I}} x = {COLUMN}", "differ in type"),
    ],
)
def test_shapes_that_do_not_fit_are_ill_formed(formula: str, message: str) -> None:
    with pytest.raises(IllFormedAt, match=message):
        read(formula, TABLE)


@pytest.mark.parametrize(
    ("formula", "firm"),
    [
        (r"M = \begin{bmatrix} 0 & 0 \\ x^T & 1 \end{bmatrix}", r"-\mathbf{0}^T & 0"),
        (r"M = \begin{bmatrix} 0 & x \\ 0 & 1 \end{bmatrix}^T", "0 & 0"),
        (r"M \begin{bmatrix} 0 & 0 \\ x^T & 1 \end{bmatrix} = M", "x^T & 0"),
    ],
)
def test_a_row_of_zeros_of_unknown_height_raises_a_question(formula: str, firm: str) -> None:
    table = SymbolTable.build({name: {"kind": kind} for name, kind in {**KINDS, "M": "matrix 4×4"}.items()})
    with pytest.raises(ReadError, match="more zeros"):
        read(formula, table)
    with pytest.raises(IllFormedAt, match="x") as error:
        read(formula.replace("0 & 0", firm).replace("0 & x", "x^T & x"), table)
    assert "more zeros" not in str(error.value)


@pytest.mark.parametrize(
    ("beside", "zero"),
    [
        ("x", r"\mathbf{0}_{3\times 3}"),
        (r"\lambda", r"\mathbf{0}_{3\times 3}"),
        ("x", r"\mathbf{0}_{1\times 3}"),
        (DIAGONAL, r"-\mathbf{0}_{3\times 3}"),
    ],
)
def test_a_zero_that_is_printed_with_its_shape_has_that_shape(beside: str, zero: str) -> None:
    for formula in (f"{beside} = {zero}", f"{beside} + ({zero}) = 0"):
        with pytest.raises(IllFormedAt, match="differ in type"):
            read(formula, TABLE)
    assert check(r"A + \mathbf{0}_{3\times 3} = A", KINDS).holds


def test_zeros_do_not_hide_the_weight_of_a_block_matrix() -> None:
    table = SymbolTable.build({"A": {"kind": "tensor", "weight": 2}, "x": {"kind": "vector", "weight": 2}})
    for zero in (r"\mathbf{0}", "0", r"-\mathbf{0}", r"2\mathbf{0}"):
        term = read_term(rf"\begin{{bmatrix}} A & x \\ {zero} & 0 \end{{bmatrix}}", table)
        assert str(term.weight) == "2"


def test_a_product_with_the_unit_tensor_is_no_multiple_of_it() -> None:
    assert str(read_term(r"\mathbf{I} x", TABLE).type) == "vector"
    assert check(r"\mathbf{I} x + y = y + x", KINDS).holds
    assert check(rf"\mathbf{{I}} {DIAGONAL} = {DIAGONAL} (-\mathbf{{I}})", KINDS).outcome == Outcome.REFUTED


@pytest.mark.parametrize(
    "formula",
    [
        rf"{DIAGONAL} = -\mathbf{{I}}",
        rf"-\mathbf{{0}} = {COLUMN}",
        r"\begin{bmatrix} A & -\mathbf{0} \\ 2\mathbf{0} & 1 \end{bmatrix} = \lambda \mathbf{I}",
    ],
)
def test_read_formulas_print_back(formula: str) -> None:
    (statement,) = read(formula, TABLE)
    assert read(to_latex(statement), TABLE) == (statement,)


@pytest.mark.parametrize(
    ("spelt", "meant"),
    [
        (r"\begin{bmatrix} 1 & 0 \\ A & 1 \end{bmatrix}", r"\begin{bmatrix} \mathbf{I} & 0 \\ A & \mathbf{I} \end{bmatrix}"),
        (r"\begin{bmatrix} A & x \\ 0 & 1 \end{bmatrix}", None),
        (r"\begin{bmatrix} A & 0 \\ 0 & 1 \end{bmatrix}", None),
    ],
)  # fmt: skip
def test_a_one_beside_a_square_block_is_a_unit_matrix(spelt: str, meant: str | None) -> None:
    term = read_term(spelt, TABLE)
    assert term.type.rows == (4 if meant is None else 6)
    assert meant is None or term == read_term(meant, TABLE)


def test_another_number_beside_a_square_block_does_not_fit() -> None:
    with pytest.raises(IllFormedAt, match="blocks of size"):
        read_term(r"\begin{bmatrix} A & 2 \end{bmatrix}", TABLE)


def test_numbers_in_a_column_are_no_blocks() -> None:
    with pytest.raises(IllFormedAt, match="differ in type"):
        read(r"\begin{bmatrix} x \\ y \end{bmatrix} = \begin{bmatrix} 0 \\ 1 \\ 2 \\ 3 \end{bmatrix}", TABLE)


@pytest.mark.parametrize("numbers", [r"0.5 \\ 0 \\ -1", r"2 \\ 1 \\ 0"])
def test_a_column_of_nothing_but_numbers_has_units_of_some_kind(numbers: str) -> None:
    table = SymbolTable.build({"w": {"kind": "vector", "weight": 1}, "s": {"kind": "scalar", "weight": 0}})
    column = rf"\begin{{bmatrix}} {numbers} \end{{bmatrix}}"
    assert read(rf"\dot{{w}} = {column}", table)
    for formula in (rf"\dot{{w}} = s {column}", rf"w = \dot{{w}} + {column}", r"\dot{w} = w"):
        with pytest.raises(IllFormedAt, match="weight"):
            read(formula, table)
