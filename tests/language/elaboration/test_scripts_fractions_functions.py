"""What stands above a term, in fractions and behind functions: what it is read as, or where and why not."""

from __future__ import annotations

import pytest

from tests.language.as_read import PLAIN, term_reads


def test_a_transpose_is_no_power() -> None:
    term_reads("A^T", "refused 3: the transpose, or a power", PLAIN, "T")


@pytest.mark.parametrize(
    "operator",
    [r"\frac{d}{dt}", r"\frac{\partial}{\partial \mu}", r"\frac{\mathrm{d}}{\mathrm{d}\mu}", r"\nabla"],
)
@pytest.mark.parametrize("bracket", [r"(\lambda)", r"[\lambda]", r"\{\lambda\}"])
def test_a_power_behind_the_bracket_that_is_differentiated(operator: str, bracket: str) -> None:
    term_reads(
        f"{operator} {bracket}^2",
        f"refused {len(operator) + 2}: a power of the derivative or of its argument?",
        PLAIN,
    )


@pytest.mark.parametrize("by", ["s_1", "s_{1}", "s'", "s'_1", r"\mathbf{s}", r"\mathbf{s}_1"])
@pytest.mark.parametrize("d", [r"\partial", r"\mathrm{d}", "d"])
def test_a_variable_of_differentiation_keeps_its_scripts(d: str, by: str) -> None:
    kinds = dict.fromkeys([by, "f", "s"], "scalar")
    once, printed = rf"\frac{{{d} f}}{{{d} {by}}}", by.replace("_1", "_{1}")
    sign = r"\partial" if d == r"\partial" else r"\mathrm{d}"
    first = rf"\frac{{{sign} f}}{{{sign} {printed}}}"
    term_reads(once, first, kinds)
    term_reads(rf"\frac{{{d}^2 f}}{{{d} {by}^2}}", rf"\frac{{{sign} {first}}}{{{sign} {printed}}}", kinds)


@pytest.mark.parametrize(
    "name", [r"\atan2", r"\arctan2", "atan2", r"\operatorname{atan2}", r"\mathrm{atan2}"]
)
@pytest.mark.parametrize("inside", [r"(\lambda, \mu)", r"\left(\lambda, \mu\right)", r" (\lambda, \mu)"])
def test_spellings_of_the_angle_of_two(name: str, inside: str) -> None:
    term_reads(name + inside, r"\operatorname{atan2}\left(\lambda, \mu\right)", PLAIN)
