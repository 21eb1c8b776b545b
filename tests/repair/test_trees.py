"""Trees back to LaTeX: whatever the parser reads is spelled so that it is read as the same tree."""

from __future__ import annotations

import pytest

from tests.language.chapter import PARTS
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.parser import parse
from workbench.source.rows.formula_lines import split_lines

FORMULAS = [latex for part in PARTS.values() for _, latex in part.formulas]
#: What else the grammar has.
OTHERS = [
    r"\min_{\rho \in V_3} \|a_\rho\| = b",
    r"\max f = 1",
    r"f : \mathbf{V}_3 \to \mathbf{V}_3, \quad f(u) = R u",
    r"x \mapsto 2 x",
    r"\forall a = b \Leftrightarrow c = d \Rightarrow e \neq f",
    r"a = b \text{ if } c = d",
    r"a \geq b, n > 1, x \in \mathbb{R}",
    r"\binom{n}{k} n! + \sum_{k=0}^{n} \tan \alpha \arccos(x) \sqrt{2}",
    r"a \wedge b \vee c \oplus d * e",
    r"{}^0 x_1' + A^T + A^\infty + \left| \frac{a}{b} \right|",
]


@pytest.mark.parametrize("latex", [*FORMULAS, *OTHERS])
def test_spelled_trees_parse_again(latex: str) -> None:
    for line in split_lines(latex):
        spelled = latex_of(parse(line.latex))
        assert latex_of(parse(spelled)) == spelled
