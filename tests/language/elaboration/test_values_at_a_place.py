"""Bars that say where: f |_{x = c} is f under the condition x = c, after all derivatives are taken."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import expm

from workbench import check
from workbench.context.claims import Notation
from workbench.context.read_formulas import read_statement
from workbench.core.formula_errors import ReadError
from workbench.core.terms import Implication, Relation
from workbench.core.verdict import Outcome
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read, read_term
from workbench.papers.notation_tables import with_definitions

SCALAR = {"kind": "scalar", "constant": True}
VECTOR = {"kind": "vector", "constant": True}
FREE = {"constant": True, "independent": True}
SYMBOLS = {
    **{name: {"kind": "scalar", **FREE} for name in ("s", "x", "y")},
    **{name: VECTOR for name in ("b", "w")},
    "a": SCALAR,
    "e": {"kind": "vector", **FREE},
    "R": {"kind": "rotation", "constant": True},
    "z": {"kind": "scalar", "independent": True},
    "f": {"kind": "scalar", "of": ["z"]},
    "u": {"kind": "scalar"},
    "v": {"kind": "vector"},
}


def test_definition_outside_of_the_bar_is_free_of_its_variable() -> None:
    notation = with_definitions(Notation(SymbolTable.build(SYMBOLS), Definitions(), {}), {"u": "x^2"})
    with pytest.raises(ReadError, match="outside of the bar"):
        read_statement(r"\left. a x \right|_{x = 0} = u", notation, None)


def test_bar_outside_of_an_equation_is_refused() -> None:
    with pytest.raises(ReadError, match="outside of an equation"):
        read_term(r"\left. x^2 \right|_{x = 1}", SymbolTable.build(SYMBOLS))


@pytest.mark.parametrize("order", [1, 2, 3])
def test_series_has_the_derivatives_of_the_exponential(order: int) -> None:
    """Finite differences of SciPy's exponential, against the series in the statement."""
    power = "" if order == 1 else f"^{order}"
    latex = rf"\left. \frac{{\partial{power}}}{{\partial s{power}}} \exp(s \operatorname{{skew}} w) \right|_{{s = 0}} = (\operatorname{{skew}} w)^{order}"
    assert check(latex, SYMBOLS).outcome is Outcome.PROVED
    spin = np.array([[0.0, -0.3, 0.5], [0.3, 0.0, -0.2], [-0.5, 0.2, 0.0]])
    h, points = 1e-2, np.arange(-3, 4)
    weights = np.linalg.solve(np.vander(points * h, increasing=True).T, np.eye(7)[order]) * np.prod(
        range(1, order + 1)
    )
    found = sum(weight * expm(k * h * spin) for weight, k in zip(weights, points, strict=True))
    assert np.allclose(found, np.linalg.matrix_power(spin, order), atol=1e-5)


def test_statement_has_the_place_as_its_condition() -> None:
    (said,) = read(r"\left. x^2 \right|_{x = 1} = a", SymbolTable.build(SYMBOLS))
    assert isinstance(said, Implication) and isinstance(said.left, Relation)
