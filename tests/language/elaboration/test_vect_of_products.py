"""vect A · B reaches over the dot where a tensor follows it, and only there."""

import pytest

from workbench.core.formula_errors import ReadError
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read_term

TABLE = SymbolTable.build({"A": {"kind": "tensor"}, "B": {"kind": "tensor"}, "a": {"kind": "vector"}})


@pytest.mark.parametrize(
    "written", [r"\text{vect} A \cdot B", r"\text{vect} A \cdot B^T \cdot A", r"\text{vect} A B \cdot A"]
)
def test_it_reaches_over_tensors(written):
    inside = written.removeprefix(r"\text{vect}")
    assert read_term(written, TABLE) == read_term(rf"\text{{vect}} \left( {inside} \right)", TABLE)


def test_a_vector_behind_the_dot_is_multiplied_by_the_vector():
    assert read_term(r"\text{vect} A \cdot a", TABLE) == read_term(r"(\text{vect} A) \cdot a", TABLE)


def test_brackets_end_its_reach():
    with pytest.raises(ReadError, match="dyads"):
        read_term(r"\text{vect} (A) \cdot B", TABLE)
