"""A bracket behind a symbol: the argument of a function under any notation before it, or asked about."""

from __future__ import annotations

import re
from itertools import product
from pathlib import Path

import pytest

from workbench import check
from workbench.core.formula_errors import ReadError
from workbench.core.verdict import Outcome

MODEL = r"""
[conventions]
arguments = ['g']
[notation]
'\mathrm{d} X' = { where = { X = "matrix 2×2" }, means = '\dot{X}' }
'\delta X' = { where = { X = "matrix 2×2" }, means = '2 X' }
'\hat{X}' = { where = { X = "matrix 2×2" }, means = 'X^T' }
'\lfloor x \times \rfloor' = { where = { x = "vector" }, means = '\operatorname{skew}(x)' }
[symbols]
'A' = "matrix 2×2"
'B' = "matrix 2×2"
'g' = "matrix 2×2"
'x' = "vector"
'y' = "vector"
'R' = "rotation"
"""
#: A notation before A(g), and the same without it.
BEFORE = {
    r"\mathrm{d} %s": r"\dot{A}",
    r"\delta %s": "2 A",
    r"\operatorname{tr} %s": r"\operatorname{tr}(A)",
    r"\det %s": r"\det(A)",
    r"%s^{-1} A": "A^{-1} A",
    r"%s^T": "A^T",
}
AROUND = ["2 (%s) = %s + (%s)", "(%s) + 1 \\cdot (%s) = 2 (%s)"]


@pytest.fixture(scope="module")
def notation(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("arguments") / "notation.toml"
    file.write_text(MODEL, encoding="utf-8")
    return file


@pytest.mark.parametrize(("before", "around"), [*product(BEFORE, AROUND)])
def test_notation_before_a_function_takes_its_value(before: str, around: str, notation: Path) -> None:
    shown, plain = before % "A(g)", BEFORE[before]
    sides = [shown, *[plain] * (around.count("%s") - 1)]
    wanted = (Outcome.PROVED, Outcome.CONDITIONAL) if "-1" in before else (Outcome.PROVED,)
    assert check(around % tuple(sides), None, notation=notation).outcome in wanted
    false = check(f"{shown} = 3 ({plain})", None, notation=notation).outcome
    assert false == Outcome.REFUTED


@pytest.mark.parametrize("before", ["%s", *BEFORE])
@pytest.mark.parametrize("argument", ["B", "B^{-1}"])
def test_bracket_of_a_matrix_after_a_matrix_raises_a_question(
    before: str, argument: str, notation: Path
) -> None:
    with pytest.raises(ReadError, match="a function of what is in the bracket, or a product"):
        check(f"{before % f'A({argument})'} = B", None, notation=notation)


@pytest.mark.parametrize("argument", [r"\theta", r"-\theta", r"2 \theta", r"-2 \theta"])
def test_bracket_that_fits_as_an_argument_only_raises_a_question(argument: str) -> None:
    kinds = {"J": "tensor", r"\theta": "vector"}
    with pytest.raises(ReadError, match="a function of what is in the bracket, or a product"):
        check(rf"J({argument}) = \mathbf{{I}} - J", kinds)
    assert check(rf"J({argument}) - J ({argument}) = 0", kinds).holds


@pytest.mark.parametrize("matrix", ["A B", "A [B]", r"A \cdot (B)", "A (B + B)", "A (2 B)"])
def test_product_of_matrices_is_read(matrix: str, notation: Path) -> None:
    if r"\cdot" not in matrix:
        assert check(f"{matrix} = {matrix} + 0", None, notation=notation).outcome != Outcome.ILL_FORMED


@pytest.mark.parametrize(("vector", "spelled"), [("x", "x"), ("x + y", "(x + y)"), ("x - 2 y", "(x - 2 y)")])
def test_sign_behind_a_sum_in_a_bracket(vector: str, spelled: str, notation: Path) -> None:
    right = rf"{spelled} \times y"
    assert check(rf"\lfloor {vector} \times\rfloor y = {right}", None, notation=notation).holds
    wrong = check(rf"\lfloor {vector} \times\rfloor y = -{right}", None, notation=notation)
    assert wrong.outcome == Outcome.REFUTED


def test_rotation_before_an_exponential_is_a_product(notation: Path) -> None:
    assert check(r"Re^{\tilde{x}} y = R (e^{\tilde{x}} y)", None, notation=notation).holds


#: Formulas that are asked about, with the two readings that the question writes out.
ASKED = {
    r"A(B) = A": ("A at B", r"A \cdot (B)"),
    r"x(f) = x": ("x at f", r"x \cdot (f)"),
    r"x(f)(t) = x": ("x at f", r"x \cdot (f)"),
    r"A(f)^T = A": ("A at f", r"A \cdot (f)"),
    r"J(x) = A": ("J at x", r"J \cdot (x)"),
    r"J(-x) = A": ("J at - x", r"J \cdot (- x)"),
    r"J(2 x) = A": ("J at 2 x", r"J \cdot (2 x)"),
    r"A (x) + J(-x) y = A x + A y": ("J at - x", r"J \cdot (- x)"),
    r"A(f + 1) = A": ("A at f + 1", r"A \cdot (f + 1)"),
    r"x(f, g) = x": ("x at f, g", r"x \cdot (f, g)"),
}
NAMES = "'A' = 'tensor'\n'B' = 'tensor'\n'x' = 'vector'\n'y' = 'vector'\n'f' = 'scalar'\n'g' = 'scalar'\n"
BODIES = {"J": r"\mathbf{I} + \tilde{x}", "A": "f B"}
_LINE = re.compile(r"\[(conventions|definitions)\] (.+?) says")


def asked(formula: str, conventions: str, definitions: str, folder: Path) -> str | None:
    """The question about a formula; None where it is read."""
    file = folder / "notation.toml"
    file.write_text(
        f"[conventions]\n{conventions}\n[symbols]\n{NAMES}[definitions]\n{definitions}\n", encoding="utf-8"
    )
    try:
        check(formula, None, notation=file)
    except ReadError as error:
        return error.message
    return None


@pytest.mark.parametrize("formula", ASKED)
def test_question_writes_readings_and_line_that_answers(formula: str, tmp_path: Path) -> None:
    plain = f"'J' = '{BODIES['J']}'"
    question = asked(formula, "", plain, tmp_path)
    assert question is not None
    assert all(each in question for each in ASKED[formula])
    table, line = _LINE.search(question).groups()
    if table == "conventions":
        assert asked(formula, line, plain, tmp_path) is None
    else:
        own = line.partition("(")[0].lstrip("'")
        others = "" if own == "J" else plain
        defined = line.replace("…", f"'{BODIES[own]}'")
        assert asked(formula, "", f"{others}\n{defined}", tmp_path) is None


@pytest.mark.parametrize("formula", [each for each in ASKED if "(t)" not in each and "," not in each])
def test_brackets_that_are_factors_are_not_asked_about(formula: str, tmp_path: Path) -> None:
    assert asked(formula, "brackets = 'factors'", f"'J' = '{BODIES['J']}'", tmp_path) is None


def test_definition_with_its_argument_is_taken_at_another(tmp_path: Path) -> None:
    file = tmp_path / "notation.toml"
    file.write_text(f"[symbols]\n{NAMES}[definitions]\n'J(x)' = '{BODIES['J']}'\n", encoding="utf-8")
    assert check(r"J(-x) = \mathbf{I} - \tilde{x}", None, notation=file).outcome == Outcome.PROVED
    assert check(r"J(-x) = \mathbf{I} + \tilde{x}", None, notation=file).outcome == Outcome.REFUTED


@pytest.mark.parametrize("right", ["x", "y"])
def test_function_taken_at_a_time_is_the_function(right: str, tmp_path: Path) -> None:
    file = tmp_path / "notation.toml"
    file.write_text(f"[conventions]\narguments = ['f']\n[symbols]\n{NAMES}", encoding="utf-8")
    holds = check(f"x(f)(t) + y = y + {right}", None, notation=file).holds
    assert holds is (right == "x")
