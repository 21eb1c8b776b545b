"""Where a paper has only columns of components, a dot is that of the components, and needs no frame."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Outcome
from workbench.language.printing.author_spelling import printed_for
from workbench.language.printing.printer import to_latex
from workbench.papers import load_paper

NAVIGATION = r"""
source = "p.md"
[conventions]
functions = ["cos"]
arguments = ["t"]
[notation]
'[x]_\times' = { where = { x = "vector" }, means = '\operatorname{skew}(x)' }
[frames]
base = "i"
names = ['\alpha', '\beta', '\gamma']
'R^F_G' = "rotation to F from G"
'\omega^R_{FG}' = "angular velocity of G in F, resolved in R"
'r^R_{FG}' = "origin of G in F, resolved in R"
'v^R_{FG}' = "velocity of the origin of G in F, resolved in R"
'a^R_{FG}' = "acceleration of the origin of G in F, resolved in R"
MORE
[symbols]
'\rho' = { kind = "scalar", constant = true }
'\Omega_{i\beta}' = { kind = "scalar", constant = true }
[definitions]
'x^i_{i\alpha}' = '\rho \cos(\Omega_{i\beta} t)'
"""
TRUE = [
    r"v^\beta_{\beta\alpha} = \dot{r}^\beta_{\beta\alpha}",
    r"a^\gamma_{\beta\alpha} = R^\gamma_\beta \ddot{r}^\beta_{\beta\alpha}",
    r"\dot{R}^\gamma_\beta = R^\gamma_\beta [\omega^\beta_{\gamma\beta}]_\times",
    r"\dot{r}^\gamma_{\beta\alpha} = \omega^\gamma_{\gamma\beta} \times r^\gamma_{\beta\alpha} + v^\gamma_{\beta\alpha}",
    r"\ddot{x}^i_{i\alpha}(t) = -\Omega^2_{i\beta} \rho \text{cos}\left(\Omega_{i\beta} t\right)",
]
FALSE = [
    r"R^\gamma_\beta \dot{r}^\beta_{\beta\alpha} = \dot{v}^\gamma_{\beta\alpha}",
    r"\ddot{R}^\gamma_\beta = [\dot{\omega}^\gamma_{\gamma\beta}]_\times R^\gamma_\beta - [\omega^\gamma_{\gamma\beta}]_\times \dot{R}^\gamma_\beta",
    r"\ddot{x}^i_{i\alpha}(t) = \Omega^2_{i\beta} \rho \text{cos}\left(\Omega_{i\beta} t\right)",
]
#: What makes a vector of the paper more than a column.
ABSTRACT = [
    "'{}^F w^G' = \"angular velocity of G in F\"",
    "axes = { i = ['n_1', 'n_2', 'n_3'] }",
]


def paper(tmp_path: Path, formula: str, more: str = "") -> Path:
    (tmp_path / "p.md").write_text(f"$$\n{formula}\n$$")
    (tmp_path / "p.toml").write_text(NAVIGATION.replace("MORE", more))
    return tmp_path / "p.toml"


@pytest.mark.parametrize(("formula", "is_true"), [(f, True) for f in TRUE] + [(f, False) for f in FALSE])
def test_components_are_differentiated_as_they_are(tmp_path: Path, formula: str, is_true: bool) -> None:
    (result,) = judge_paper(load_paper(paper(tmp_path, formula)))
    assert result.verdict.outcome is (Outcome.PROVED if is_true else Outcome.REFUTED)


def test_a_dot_is_printed_as_a_dot(tmp_path: Path) -> None:
    (claim,) = load_paper(paper(tmp_path, TRUE[1])).claims
    with printed_for(claim.notation.author_notation):
        shown = to_latex(claim.printed.statement)
    assert r"\ddot{r}_{\beta \alpha}^{\beta}" in shown and r"\frac" not in shown


@pytest.mark.parametrize("more", ABSTRACT, ids=["angular velocity", "axes"])
def test_vectors_that_are_no_columns_raise_a_frame_question(tmp_path: Path, more: str) -> None:
    (result,) = judge_paper(load_paper(paper(tmp_path, TRUE[0], more)))
    assert "in which frame" in result.verdict.reason
