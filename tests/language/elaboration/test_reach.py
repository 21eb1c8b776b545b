"""How far a function, d/dt or an operator reaches: where a reader may disagree, brackets are asked for."""

import pytest

from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read

TABLE = SymbolTable.build(
    {
        "a": {"kind": "vector"},
        "b": {"kind": "vector"},
        "f": {"kind": "scalar"},
        "A": {"kind": "tensor"},
        "B": {"kind": "tensor"},
        r"\rho": {"kind": "vector", "coordinate": True},
        r"\underline{a}": {"kind": "dual vector"},
        r"\mathbf{P}": {"kind": "operator"},
    }
)

#: (what a reader may take in two ways, the two ways)
AMBIGUOUS = [
    (r"\frac{d}{dt} a \times b", r"\frac{d}{dt} (a) \times b", r"\frac{d}{dt} (a \times b)"),
    (r"\frac{d}{dt} a \cdot b", r"\frac{d}{dt} (a) \cdot b", r"\frac{d}{dt} (a \cdot b)"),
    (r"f \frac{d^2}{dt^2} a \otimes b", r"f \ddot{a} \otimes b", r"f \frac{d^2}{dt^2} (a \otimes b)"),
    (r"\operatorname{curl} \rho \times b", r"\operatorname{curl}(\rho) \times b", r"\operatorname{curl}(\rho \times b)"),
    (r"\operatorname{Du} \underline{a} \cdot \underline{a}", r"\operatorname{Du}(\underline{a}) \cdot \underline{a}",
     r"\operatorname{Du}(\underline{a} \cdot \underline{a})"),
    (r"\det A \cdot B", r"\det (A) B", r"\det (A B)"),
    (r"\mathbf{D} A b", r"(\mathbf{D} (A)) b", r"\mathbf{D} (A b)"),
    (r"\mathbf{D} A B", r"(\mathbf{D} (A)) B", r"\mathbf{D} (A B)"),
    (r"\mathbf{D} a \times b", r"\mathbf{D} (a) \times b", r"\mathbf{D} (a \times b)"),
    (r"\mathbf{D} A + \mathbf{P}", r"\mathbf{D} (A) + \mathbf{P}", r"\mathbf{D} \circ A + \mathbf{P}"),
]  # fmt: skip


@pytest.mark.parametrize(("latex", "one", "other"), AMBIGUOUS)
def test_ambiguous_arguments_of_functions_are_rejected(latex, one, other):
    with pytest.raises((ReadError, IllFormedAt), match=r"how far|or their product"):
        read(f"{latex} = 0", TABLE)
    first, second = (read(f"{way} = 0", TABLE) for way in (one, other))
    assert first != second


@pytest.mark.parametrize(
    "latex",
    [
        r"\frac{d}{dt} a + b = 0",
        r"a \times \frac{d}{dt} b = 0",
        r"\operatorname{Re} \underline{a} \times \operatorname{Du} \underline{a} = 0",
        r"\mathbf{P} \mathbf{D} a = 0",
        r"\mathbf{P}(A) + \mathbf{P} = 0",
        r"\mathbf{D} A = \dot{A}",
        r"f A \mathbf{D} a = 0",
        r"2 \cdot 3 f = 6 f",
        r"2 (3) f = 6 f",
    ],
)
def test_unambiguous_arguments_of_functions_are_read(latex):
    assert read(latex, TABLE)


@pytest.mark.parametrize("latex", ["1 2 f = 12 f", "2 3^2 f = 0", "1.5 2 f = 0"])
def test_numbers_that_print_as_one_are_refused(latex):
    with pytest.raises(ReadError, match="printed as one"):
        read(latex, TABLE)
