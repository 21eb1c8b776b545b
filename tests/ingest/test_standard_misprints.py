"""Formulas of a text that are one misprint away from a standard formula, which differs by names."""

from __future__ import annotations

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
from workbench.papers.drafting.formulary.misprints import misprints_of
from workbench.papers.drafting.formulary.normal_sums import Sum, equation_sum, leaves_of
from workbench.papers.drafting.formulary.standard_formulas import StandardFormula, standard_formulas

FORMULAS = [each for each in standard_formulas() if each.size >= 5]
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
def test_misprint_of_renamed_formula_is_found_or_equal(own: StandardFormula) -> None:
    printed = equation_sum(with_new_labels(own))
    leaves = list(dict.fromkeys(leaves_of(printed)))
    rest = [each for each in printed.monomials if len([*leaves_of(each)]) > 1]
    chosen = Random(3).choice(rest)
    others = [each for each in printed.monomials if each is not chosen]
    for sign in (-1, 2):
        wrong = Sum((*others, chosen.times(sign)))
        is_equal = next(renamings(own.sum, wrong), None) is not None
        is_left = chosen.cell == (-1, -1) and any(len([*leaves_of(each)]) == 1 for each in own.left)
        assert is_equal or is_left or misprint_of(own.sum, wrong, own.left) is not None, (chosen, sign)
    changed = Random(5).choice(list(misprints_of(chosen, leaves)))
    assert next(renamings(own.sum, Sum((*others, changed))), None) is None or changed != chosen


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
