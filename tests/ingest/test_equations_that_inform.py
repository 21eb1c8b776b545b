"""An equation that says what a symbol is, and a shape that the draft guessed, are notes beside true findings."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.ingest.test_draft import judged
from tests.ingest.test_guesses_borne_out import grades
from workbench.core.verdict import Grade

KNOWN = (r"(x - y)(x + y) = x^2 - y^2", r"(x + y)^2 = x^2 + 2 x y + y^2")
NEW = [
    (r"E = \frac{1}{2} m v^2 - \frac{k a b}{r} = \frac{1}{2} m v^2 - \frac{k m (a + b)}{r}", Grade.NOTE),
    (r"\vec{g} = \frac{\vec{F}}{m} + w \vec{r} = \vec{c} + w \vec{r}", Grade.NOTE),
    (r"E = \frac{1}{2} m v^2 + m g h = \frac{1}{2} m v^2 + g h", Grade.WARNING),  # for m = 1 only
    (r"E = \frac{1}{2} m v^2 + m g h = m v^2 + m g h", Grade.WARNING),
]


@pytest.mark.parametrize(("formula", "grade"), NEW)
def test_equation_for_a_symbol_that_is_new_in_it(tmp_path: Path, formula: str, grade: Grade) -> None:
    assert grades(tmp_path, *KNOWN, formula)[-1] is grade


@pytest.mark.parametrize(
    ("known", "formula", "grade"),
    [
        (("F = m a", "p = m v"), r"\dot{p} = m a", Grade.NOTE),  # a is the rate of v
        (("F = m a", "p = m v"), r"\dot{p} = 2 m a", Grade.WARNING),
        (
            (r"\vec{L} = m \vec{r} \times \vec{v}", r"\vec{h} = \vec{r} \times \vec{v}"),
            r"\dot{\vec{h}} = \dot{\vec{r}} \times \dot{\vec{r}} + \dot{\vec{r}} \times \ddot{\vec{r}}",
            Grade.WARNING,  # also where v is the rate of r
        ),
    ],
)
def test_symbol_that_may_be_a_rate(
    tmp_path: Path, known: tuple[str, ...], formula: str, grade: Grade
) -> None:
    assert grades(tmp_path, *KNOWN, *known, formula)[-1] is grade


SEVERAL = (r"r = \sqrt{x^2 + y^2 + z^2}", r"r = a (1 - x)", r"r = \frac{y}{1 + a x}")


@pytest.mark.parametrize(("count", "grade"), [(1, Grade.WARNING), (3, Grade.NOTE)])
def test_definition_beside_other_formulas_for_its_symbol(tmp_path: Path, count: int, grade: Grade) -> None:
    assert grades(tmp_path, *KNOWN, *SEVERAL[:count], "r^2 - x^2 = y^2")[-1] is grade


VECTORS = (
    r"\mathbf{v} = \dot{\mathbf{r}}",
    r"\mathbf{p} = m \mathbf{v}",
    r"\mathbf{h} = \mathbf{r} \times \mathbf{p}",
)


@pytest.mark.parametrize(
    ("formula", "grade"),
    [
        (r"s \begin{bmatrix} \mathbf{A} & \mathbf{B} \end{bmatrix} = \mathbf{r} \times \mathbf{h}", Grade.NOTE),
        (r"\frac{\mathbf{h}}{m} = 2 m", Grade.WARNING),
    ],
)  # fmt: skip
def test_sizes_of_blocks_are_guesses(tmp_path: Path, formula: str, grade: Grade) -> None:
    assert grades(tmp_path, *VECTORS, formula)[-1] is grade


def test_letter_with_entries_in_a_row_is_a_matrix(tmp_path: Path) -> None:
    words = r"For generalized coordinates $q = \begin{bmatrix} s & u \end{bmatrix}^\top$ the state and its limit are"
    state = r"x &= \begin{bmatrix} q \\ \dot{q} \end{bmatrix} = \begin{bmatrix} s & u & \dot{s} & \dot{u} \end{bmatrix}^\top"
    (tmp_path / "p.md").write_text(f"{words}\n\n$$ \\begin{{aligned}} {state} \\end{{aligned}} $$\n")
    assert all(result.verdict.grade is not Grade.WARNING for result in judged(tmp_path / "p.md"))


def test_letter_that_fits_no_other_formula_either(tmp_path: Path) -> None:
    odd = (r"\mathbf{B} \mathbf{r} = \mathbf{h}", r"s = \sqrt{\mathbf{B}}")
    assert grades(tmp_path, *VECTORS, *odd, r"u = \frac{s}{\mathbf{B}}")[-1] is not Grade.WARNING


@pytest.mark.parametrize(
    ("words", "grade"),
    [
        ("We consider the set of velocities of unit norm that is defined by the equation", Grade.NOTE),
        ("The constraint describes a surface given by", Grade.NOTE),
        ("The set of such matrices is a group, and", Grade.WARNING),
    ],
)
def test_equation_of_a_set(tmp_path: Path, words: str, grade: Grade) -> None:
    known = (*KNOWN, r"W = F \dot{x}", r"\dot{x} = u + v")
    assert grades(tmp_path, *known, words, r"(u + v)^2 = u^2 + v^2")[-1] is grade


@pytest.mark.parametrize(
    ("known", "formula", "grade"),
    [
        (("v = r f + u",), r"f = \frac{v - u}{r^2}", Grade.WARNING),  # solved for f, wrongly
        (("q = u + w",), "p = 2 p + q", Grade.NOTE),
        (
            (r"F = \begin{bmatrix} 1 & 0 \\ 0 & 1 \end{bmatrix}",),
            r"X = F X + \begin{bmatrix} u \\ w \end{bmatrix}",
            Grade.NOTE,
        ),
        (("q = u + w",), "2 p + w = 2 (p + w)", Grade.WARNING),
    ],
)
def test_symbol_alone_on_the_left_and_on_the_right(
    tmp_path: Path, known: tuple[str, ...], formula: str, grade: Grade
) -> None:
    assert grades(tmp_path, *KNOWN, *known, formula)[-1] is grade


ANGLE = (r"A = \sqrt{x^2 + y^2}", r"p = \arctan\frac{y}{x}")


@pytest.mark.parametrize(
    ("formula", "grade"),
    [(r"A \cos p = x", Grade.NOTE), (r"A \cos p = y", Grade.WARNING), ("A = x + y", Grade.WARNING)],
)
def test_equation_of_one_branch(tmp_path: Path, formula: str, grade: Grade) -> None:
    assert grades(tmp_path, *KNOWN, *ANGLE, formula)[-1] is grade
