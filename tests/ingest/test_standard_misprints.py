"""Formulas of a text that are one misprint away from a standard formula, which differs by names."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from random import Random

import pytest

from tests.drafts import judged_draft_of
from workbench.core.construct import symbol
from workbench.core.names import Name
from workbench.core.terms import Relation, Symbol, Term
from workbench.core.types import PI, Declaration
from workbench.core.verdict import Grade, Outcome
from workbench.language.definitions import replaced
from workbench.papers.drafting.formulary.comparison import misprint_of, renamings
from workbench.papers.drafting.formulary.normal_sums import Monomial, Sum, equation_sum, leaves_of
from workbench.papers.drafting.formulary.standard_formulas import StandardFormula, standard_formulas

FORMULAS = [each for each in standard_formulas() if 5 <= each.size <= 16]
SOME = Random(7).sample(FORMULAS, 60)


def with_new_labels(own: StandardFormula) -> Relation:
    """Returns the formula with a new label on each symbol."""

    def change(part: Symbol) -> Term | None:
        name = part.declaration.name
        if part.declaration == PI or part.index or str(name) == "t":
            return None
        new = Declaration(Name(name.letter, sub=(f"{name.latex(())}new",)), part.type)
        return symbol(new.with_flags(**{flag: True for flag in part.declaration.flags}))

    said = own.statement
    return Relation("=", replaced(said.left, change), replaced(said.right, change))


@pytest.mark.parametrize("own", SOME, ids=[each.formula for each in SOME])
def test_renamed_formula_is_equal(own: StandardFormula) -> None:
    printed = equation_sum(with_new_labels(own))
    assert next(renamings(own.sum, printed), None) is not None


@pytest.mark.parametrize("own", SOME, ids=[each.formula for each in SOME])
def test_wrong_sign_or_factor_of_an_addend_is_found(own: StandardFormula) -> None:
    printed = equation_sum(with_new_labels(own))
    for chosen in printed.monomials:
        others = [each for each in printed.monomials if each is not chosen]
        is_symbol = len([*leaves_of(chosen)]) == 1 or not [*leaves_of(chosen)]
        for factor in (-1, 2) if not is_symbol else ():
            wrong = Sum((*others, chosen.times(Fraction(factor))))
            is_equal = next(renamings(own.sum, wrong), None) is not None
            is_left = len(own.left) == 1 and len(printed.monomials) > 2 and is_of_left(chosen, own)
            assert is_equal or is_left or misprint_of(own.sum, wrong, own.left) is not None, (chosen, factor)


def is_of_left(chosen: Monomial, own: StandardFormula) -> bool:
    """True if a monomial may be that of the left side, which is taken as right."""
    (left,) = own.left
    return chosen.factor == left.factor and len([*leaves_of(chosen)]) == len([*leaves_of(left)])


FRAME = r"""# Motion in a rotating frame

The point has the position $\mathbf{r}$ in a frame that turns with the angular velocity $\boldsymbol\Omega$; its relative
velocity is $\mathbf{u}$ and its relative acceleration is $\mathbf{b}$. With the Coriolis term, its acceleration is

$$
\mathbf{a} = \mathbf{b} + %s \boldsymbol\Omega \times \mathbf{u} + \dot{\boldsymbol\Omega} \times \mathbf{r}
 + \boldsymbol\Omega \times (\boldsymbol\Omega \times \mathbf{r}) .
$$
"""
ARM = r"""# Jacobian of a planar arm

The arm with two links of the lengths $a$ and $b$ has the joint angles $\alpha$ and $\beta$. Its Jacobian is

$$
J = \begin{bmatrix} -a \sin\alpha - b \sin(\alpha + \beta) & -b \sin(\alpha + \beta) \\
 a \cos\alpha + b \cos(\alpha + \beta) & b \%s(\alpha + \beta) \end{bmatrix} .
$$
"""


@pytest.mark.parametrize(("page", "wrong", "right"), [(FRAME, "", "2"), (ARM, "sin", "cos")])
def test_misprinted_page_is_warned_and_right_one_not(
    tmp_path: Path, page: str, wrong: str, right: str
) -> None:
    for said, grade in ((wrong, Grade.WARNING), (right, Grade.NOTE)):
        path = tmp_path / f"{grade.name}.md"
        path.write_text(page % said, encoding="utf-8")
        verdicts = [each.verdict for each in judged_draft_of(path)]
        warned = [each for each in verdicts if each.grade is Grade.WARNING]
        assert len(warned) == (grade is Grade.WARNING), verdicts
        for each in warned:
            assert each.outcome is Outcome.REFUTED and each.counterexample is not None
            assert "usual formula" in str(each.reason)


@pytest.mark.parametrize("words", ["It is not", "For small angles it is", "Its derivative is"])
def test_words_that_deny_the_standard_formula_leave_it(tmp_path: Path, words: str) -> None:
    path = tmp_path / "page.md"
    path.write_text((ARM % "sin").replace("Its Jacobian is", words), encoding="utf-8")
    assert [each.verdict.outcome for each in judged_draft_of(path)] == [Outcome.DEFINITION]


def test_other_order_of_variables_is_no_misprint(tmp_path: Path) -> None:
    columns = [
        (r"r\cos\theta\cos\phi", r"-r\sin\theta\sin\phi", r"\sin\theta\cos\phi"),
        (r"r\cos\theta\sin\phi", r"r\sin\theta\cos\phi", r"\sin\theta\sin\phi"),
        (r"-r\sin\theta", "0", r"\cos\theta"),
    ]
    matrix = r" \\ ".join(" & ".join(row) for row in columns)
    path = tmp_path / "text.md"
    path.write_text(
        f"For spherical coordinates, the Jacobian is\n\n$$\nB = \\begin{{bmatrix}} {matrix} \\end{{bmatrix}}\n$$\n"
    )
    assert judged_draft_of(path)[-1].verdict.outcome is Outcome.DEFINITION


EXCHANGED = [
    (
        "The understeer gradient of the bicycle model with the cornering stiffnesses $C_f$, $C_r$ is",
        r"K = \frac{m}{L}\left(\frac{l_f}{C_f} - \frac{l_r}{C_r}\right)",
        r"K = \frac{m}{L}\left(\frac{l_r}{C_f} - \frac{l_f}{C_r}\right)",
    ),
]


@pytest.mark.parametrize(("words", "printed", "right"), EXCHANGED)
def test_exchanged_names_are_a_misprint(words: str, printed: str, right: str, tmp_path: Path) -> None:
    grades = []
    for formula in (printed, right):
        path = tmp_path / "text.md"
        path.write_text(f"{words}\n\n$$\n{formula}\n$$\n")
        grades.append(judged_draft_of(path)[-1].verdict.grade)
    assert grades[0] is Grade.WARNING and grades[1] is not Grade.WARNING


def test_angles_by_the_other_names_are_no_misprint(tmp_path: Path) -> None:
    path = tmp_path / "text.md"
    path.write_text(
        "In spherical coordinates with the azimuth $\\theta$ and the polar angle $\\phi$\n\n"
        "$$\nx = r\\sin\\phi\\cos\\theta, \\qquad y = r\\sin\\phi\\sin\\theta\n$$\n"
    )
    assert all(each.verdict.grade is not Grade.WARNING for each in judged_draft_of(path))
