"""A falsehood that rests on guesses is shown if the text bears them out, and is a note if it does not."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.drafts import draft_of
from tests.ingest.test_draft import judged
from workbench.core.verdict import Grade

TRUE = [r"(x + y)^2 = x^2 + 2 x y + y^2", r"(x - y)(x + y) = x^2 - y^2", r"(x - y)^2 + 4 x y = (x + y)^2"]
FALSE = [r"(x - y)^2 = x^2 + 2 x y + y^2", r"x (x + y) = x^2 + y^2"]


def grades(folder: Path, *parts: str) -> list[Grade]:
    """Returns the grades of the displays of a text; a part without an equation is a sentence."""
    (folder / "p.md").write_text("\n\n".join(f"$$ {part} $$" if "=" in part else part for part in parts))
    return [result.verdict.grade for result in judged(folder / "p.md")]


def test_single_falsehood_is_a_warning(tmp_path: Path) -> None:
    assert grades(tmp_path, FALSE[0]) == [Grade.WARNING]


def test_falsehoods_without_a_true_formula_are_notes(tmp_path: Path) -> None:
    far = [r"x (x - y) = x^2 + y^2 + 7 x", r"x (x + y) = x^2 + y^2 - 5 y"]
    assert grades(tmp_path, *far) == [Grade.NOTE] * 2


def test_falsehood_that_one_change_mends_bears_kinds_out(tmp_path: Path) -> None:
    assert grades(tmp_path, *FALSE) == [Grade.WARNING, Grade.NOTE]


def test_true_formulas_bear_kinds_out(tmp_path: Path) -> None:
    assert grades(tmp_path, *TRUE, *FALSE)[3:] == [Grade.WARNING] * 2


def test_marked_letters_need_no_true_formula(tmp_path: Path) -> None:
    wrong = [
        r"\vec{a} \times \vec{b} = \vec{b} \times \vec{a}",
        r"\vec{a} \cdot \vec{b} = -\vec{b} \cdot \vec{a}",
    ]
    assert grades(tmp_path, *wrong) == [Grade.WARNING] * 2


@pytest.mark.parametrize(("more", "grade"), [((), Grade.NOTE), (("x (y + 1) = x y + x",), Grade.WARNING)])
def test_definition_of_another_section(tmp_path: Path, more: tuple[str, ...], grade: Grade) -> None:
    first = ["# One", "We set", "x = 2 y + z"]
    *_, last = grades(tmp_path, *first, "# Two", *more, "x + y = 3 y - z")
    assert last is grade


def test_function_of_another_section(tmp_path: Path) -> None:
    first = ["# One", "We set", "f(x) = 2 - 4 x", "f(2) = -6"]
    *_, alike, last = grades(tmp_path, *first, "# Two", "f(x) = 4 x - x y", "(x - y)^2 = x^2 - y^2")
    assert (alike, last) == (Grade.NOTE, Grade.WARNING)


@pytest.mark.parametrize("formula", ["i^2 = -1", "s^2 + 1 = 0"])
def test_equation_that_no_number_fulfils_is_no_warning(tmp_path: Path, formula: str) -> None:
    assert grades(tmp_path, formula) == [Grade.NOTE]


def test_dimension_is_neither_a_definition_nor_a_warning(tmp_path: Path) -> None:
    assert Grade.WARNING not in grades(tmp_path, r"[v] = \frac{L}{T}", r"[w] = \frac{1}{T}")
    assert not draft_of(tmp_path / "p.md").ingested.definitions


@pytest.mark.parametrize(("dot", "grade"), [(r"\cdot ", Grade.NOTE), ("", Grade.WARNING)])
def test_dot_between_letters_may_be_that_of_vectors(tmp_path: Path, dot: str, grade: Grade) -> None:
    *_, last = grades(tmp_path, f"x {dot}u + y {dot}u + x {dot}y = x {dot}u + y {dot}u - x {dot}y")
    assert last is grade


VECTORS = (
    r"\mathbf{v} = \dot{\mathbf{r}}",
    r"\mathbf{p} = m \mathbf{v}",
    r"\mathbf{h} = \mathbf{r} \times \mathbf{p}",
)


def test_fault_of_another_operation_is_no_warning(tmp_path: Path) -> None:
    called = (r"f(m) = 2 m^2", r"\mathbf{h} \cdot \mathbf{v} = m \mathbf{r} + f(\mathbf{p})")
    assert grades(tmp_path, *VECTORS, *called)[-1] is not Grade.WARNING
    wrong = r"\mathbf{h} \cdot \mathbf{v} = m \mathbf{r} + \mathbf{p} \cdot \mathbf{v}"
    assert grades(tmp_path, *VECTORS, wrong)[-1] is Grade.WARNING


def test_misfits_of_one_shape_are_one_misread_notation(tmp_path: Path) -> None:
    wrong = [rf"A_{i} = \mathbf{{{a}}} \cdot \mathbf{{h}} + m \mathbf{{r}}" for i, a in ((1, "v"), (2, "p"))]
    assert grades(tmp_path, *VECTORS, *wrong)[-2:] == [Grade.NOTE] * 2
    assert grades(tmp_path, *VECTORS, wrong[0])[-1] is Grade.WARNING


def test_several_misfits_are_a_misread_notation(tmp_path: Path) -> None:
    wrong = [
        r"\mathbf{h} \cdot \mathbf{v} = m \mathbf{r} + \mathbf{p} \cdot \mathbf{v}",
        r"\mathbf{r} \cdot \mathbf{p} = \mathbf{v} + \mathbf{h} \cdot \mathbf{h}",
        r"\mathbf{p} \cdot \mathbf{h} = m^2 \mathbf{h} + \mathbf{v} \cdot \mathbf{p} + m",
        r"2 m \mathbf{v} \cdot \mathbf{v} = 3 \mathbf{r} + m",
    ]
    assert grades(tmp_path, *VECTORS, *wrong)[-4:] == [Grade.NOTE] * 4
    assert grades(tmp_path, *VECTORS, *wrong[:2])[-2:] == [Grade.WARNING] * 2


def test_late_formula_defines_behind_where_only(tmp_path: Path) -> None:
    first = [r"m \mathbf{p} = \mathbf{v} + \mathbf{h}", r"\mathbf{q} = \mathbf{p} + \mathbf{h}"]
    for words, count in (("Finally, we find the place", 0), ("We have this, where", 1)):
        (tmp_path / "p.md").write_text("\n\n".join(f"$$ {each} $$" for each in first))
        with (tmp_path / "p.md").open("a") as page:
            page.write(f"\n\n{words} $\\mathbf{{p}} = 2 \\mathbf{{h}}$.\n")
        found = draft_of(tmp_path / "p.md").ingested.definitions
        assert sum(each.symbol == r"\mathbf{p}" for each in found) == count


@pytest.mark.parametrize(("left", "grade"), [("f(y)", Grade.NOTE), ("f(2)", Grade.WARNING)])
def test_function_of_another_symbol_may_be_another(tmp_path: Path, left: str, grade: Grade) -> None:
    given = ["f(x) = x^2 + x", "y = 3 z", "f(1) = 2", "(x - y)^2 = x^2 - 2 x y + y^2"]
    right = "y^3 + y" if "y" in left else "7"
    assert grades(tmp_path, *given, f"{left} = {right}")[-1] is grade


@pytest.mark.parametrize(
    ("formula", "grade"),
    [
        (r"(a + m)^2 - a^2 = \frac{200}{1500}", Grade.NOTE),
        (r"\frac{F}{m} = \frac{200}{1500}", Grade.NOTE),
        (r"(a + m)^2 - (a - m)^2 - 4 a m = 12", Grade.WARNING),
    ],
)
def test_figures_of_an_example_say_what_symbols_are(tmp_path: Path, formula: str, grade: Grade) -> None:
    known = (r"(a + m)^2 = a^2 + 2 a m + m^2", "The net force is $F = 400 - 200 = 200$. So:")
    assert grades(tmp_path, *known, formula)[-1] is grade


@pytest.mark.parametrize(("value", "grade"), [("11.0", Grade.NOT_JUDGED), ("17.0", Grade.WARNING)])
def test_rounded_figures_with_units_are_no_error(tmp_path: Path, value: str, grade: Grade) -> None:
    root = r"\sqrt{2 (0.62) (9.81 \frac{\mathrm{m}}{\mathrm{s}^{2}}) (10 \mathrm{~m})}"
    figures = rf"\begin{{aligned}} v & = {root} \\ & = {value} \mathrm{{~m}} / \mathrm{{s}} \end{{aligned}}"
    assert grades(tmp_path, "Substituting the given numbers:", figures)[-1] is grade


@pytest.mark.parametrize(("count", "seconds"), [(2, 10.0), (40, 2.5), (90, 2.0)])
def test_long_text_gets_less_time_for_each_claim(tmp_path: Path, count: int, seconds: float) -> None:
    (tmp_path / "p.md").write_text("\n\n".join(f"$$ x + {n} y = {n} y + x $$" for n in range(2, count + 2)))
    assert draft_of(tmp_path / "p.md").paper.budget.seconds == seconds


@pytest.mark.parametrize(
    ("words", "grade"),
    [
        ("When it moves away:", Grade.NOTE),
        ("In this ill-determined case, it is found by", Grade.NOTE),
        ("Hence", Grade.WARNING),
    ],
)
def test_symbol_given_for_another_case(tmp_path: Path, words: str, grade: Grade) -> None:
    given = ["The source moves:", "f = g v + s", "(v - s)(v + s) = v^2 - s^2"]
    assert grades(tmp_path, *given, words, "f = g v - s")[-1] is grade


@pytest.mark.parametrize(
    ("formula", "grade"),
    [
        ("y = v^2", Grade.NOTE),  # at one t
        ("y = 2 v t - g t^2", Grade.WARNING),
        ("s = 2 r^2", Grade.WARNING),  # s does not depend on φ
    ],
)
def test_value_at_one_instant(tmp_path: Path, formula: str, grade: Grade) -> None:
    known = ["y = v t - g t^2", r"x_1 = r \cos\phi, \qquad x_2 = r \sin\phi", "s = x_1^2 + x_2^2"]
    assert grades(tmp_path, *known, "(v - g)(v + g) = v^2 - g^2", formula)[-1] is grade


@pytest.mark.parametrize(
    ("letter", "more", "grade"),
    [
        ("j", (), Grade.NOTE),
        ("i", (), Grade.NOTE),
        ("b", (), Grade.WARNING),
        ("j", ("s_j = r x",), Grade.WARNING),  # an index
    ],
)
def test_imaginary_unit_is_no_number(
    tmp_path: Path, letter: str, more: tuple[str, ...], grade: Grade
) -> None:
    first = [f"Z = r + {letter} x", "(r - x)(r + x) = r^2 - x^2", *more]
    assert grades(tmp_path, *first, f"(Z - r)^2 = {letter} x^2 - x^2")[-1] is grade


@pytest.mark.parametrize(("more", "grade"), [((), Grade.WARNING), (("E = 3 m + 2 p",), Grade.NOTE)])
def test_symbol_with_several_values(tmp_path: Path, more: tuple[str, ...], grade: Grade) -> None:
    first = ["E = p^2 + m", "(p - m)(p + m) = p^2 - m^2"]
    assert grades(tmp_path, *first, "E^2 = p^2 + m^2", *more)[2] is grade


def test_rate_at_an_instant(tmp_path: Path) -> None:
    known = [
        r"\theta(t) = a_0 + a_1 t",
        r"\theta(t_f) = a_0 + a_1 t_f",
        "(a_0 - a_1)(a_0 + a_1) = a_0^2 - a_1^2",
    ]
    assert grades(tmp_path, *known, r"\dot\theta(0) = a_1")[-1] is Grade.NOTE


def test_known_symbol_among_others_makes_no_claim(tmp_path: Path) -> None:
    known = ["(a + b)^2 = a^2 + 2 a b + b^2", "c = 0"]
    assert grades(tmp_path, *known, "c + 2 a s + 3 b s^2 = 0")[-1] is Grade.NOTE


@pytest.mark.parametrize(
    ("formula", "grade"),
    [
        ("p = 3 (12)", Grade.NOTE),  # another example
        ("p = 3 v", Grade.WARNING),
    ],
)
def test_value_of_an_example(tmp_path: Path, formula: str, grade: Grade) -> None:
    known = ["p = 2 v", "(m + v)(m - v) = m^2 - v^2"]
    assert grades(tmp_path, *known, formula)[-1] is grade


@pytest.mark.parametrize(
    ("formula", "grade"),
    [
        (r"\frac{\mathbf{h}}{m} = \mathbf{1}(m) m", Grade.NOTE),
        (r"\frac{\mathbf{h}}{m} = 2 m", Grade.WARNING),
        (r"\frac{m}{RMS(\mathbf{h})} = 2 m", Grade.NOTE),
        (
            r"s^0 = \begin{bmatrix} \mathbf{h} \cdot \mathbf{v} \\ m \\ m \end{bmatrix}",
            Grade.NOTE,
        ),  # in frame 0
        (r"m \mathbf{h} = \begin{bmatrix} 0 \\ 0 \end{bmatrix}", Grade.NOTE),
        (r"\frac{d}{m} = 2 m", Grade.NOTE),  # the magnitude of d
    ],
)
def test_misfit_of_letters_that_are_something_else(tmp_path: Path, formula: str, grade: Grade) -> None:
    more = (r"\mathbf{d} = \mathbf{r} + \mathbf{h}", "The displacement $d$ is a vector.", "d = \\mathbf{d}")
    assert grades(tmp_path, *VECTORS, *more, formula)[-1] is grade


@pytest.mark.parametrize(
    ("words", "grade"),
    [("We solve the Lyapunov equation", Grade.NOTE), ("It is easy to see that", Grade.WARNING)],
)
def test_equation_to_solve(tmp_path: Path, words: str, grade: Grade) -> None:
    known = ["(x + y)^2 = x^2 + 2 x y + y^2", "(x - y)(x + y) = x^2 - y^2"]
    assert grades(tmp_path, *known, words, "x^2 + y^2 = 2 x y")[-1] is grade
