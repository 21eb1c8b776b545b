"""Functions without a definition that a text takes at other values, and the letters of each."""

from __future__ import annotations

import pytest

from workbench.papers.drafting.drafted_functions import functions_elsewhere

ROWS = [
    (["R(t + \\Delta t) = R(t) Q"], {"R": ("t",)}),
    (["R(t + h) = R(t)", "\\dot{R}(t + h) = 0"], {"R": ("t",)}),
    (["T(g h) = T(g) T(h)"], {"T": ("g",)}),
    (["f(x + y) = f(x) + f(y)"], {"f": ("x",)}),
    (["\\theta(t) = \\omega (t - t_0)"], {}),
    (["\\omega(t) = 1", "\\theta = \\omega (t - t_0)"], {}),
    (["v(t) = a (t + b)"], {}),
    (["x(t + h) = x(t - h)"], {}),
    (["k (x + y) = k x + k y"], {}),
    (["R(t + h) = R(t)", "\\frac{\\partial R}{\\partial q} = 0"], {}),
]


@pytest.mark.parametrize(("formulas", "found"), ROWS)
def test_other_values_make_a_function(formulas: list[str], found: dict[str, tuple[str, ...]]) -> None:
    assert functions_elsewhere(formulas) == found
