"""A pair in round brackets is a row of two blocks, as in Ψₙ = (aₙ, Φₙ)."""

import pytest

from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.terms import Block
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read, read_term

TABLE = SymbolTable.build(
    {
        "a": {"kind": "vector", "weight": 1},
        "b": {"kind": "vector", "weight": 2},
        "A": {"kind": "tensor", "weight": 1},
        r"\mathbf{D}_x": {"kind": "operator"},
    }
)


def test_a_pair_is_the_matrix_of_one_row():
    pair = read_term("(a, A)", TABLE)
    assert isinstance(pair, Block)
    assert pair == read_term(r"\begin{bmatrix} a & A \end{bmatrix}", TABLE)
    assert str(pair.type) == "matrix 3×4"
    assert pair.weight == read_term("a", TABLE).weight


def test_entries_of_unequal_weight_leave_the_pair_without_one():
    assert read_term("(b, A)", TABLE).weight is None


def test_two_vectors_in_brackets_are_no_pair():
    """Many write a scalar product so."""
    with pytest.raises(ReadError):
        read_term("(a, b)", TABLE)


def test_a_tensor_acts_on_each_entry():
    (product,) = read(r"A (a, A) = (A a, A A)", TABLE)
    assert product.left.type == product.right.type


@pytest.mark.parametrize("pair", ["(a, 2)", r"(a, \mathbf{D}_x)"])
def test_parts_of_different_height_are_no_pair(pair):
    with pytest.raises((ReadError, IllFormedAt)):
        read_term(pair, TABLE)
