"""What drafts take from the sentences of a text."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.drafts import draft_of
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Grade, Outcome
from workbench.papers.drafting import ingest
from workbench.papers.drafting.draft_model import Ingested
from workbench.papers.drafting.formula_shapes import components_of
from workbench.papers.drafting.judged_draft import on_drafted_kinds
from workbench.papers.drafting.marked_text import MarkedText
from workbench.papers.drafting.sentence_kinds import Facts, facts_of
from workbench.source.documents import read_text

PAPER = Path(__file__).parent / "papers" / "two_link_arm.tex"


def facts(tmp_path: Path, words: str) -> Facts:
    path = tmp_path / "p.md"
    path.write_text(f"{words}\n\n$$ x = y $$\n")
    return facts_of(MarkedText(read_text(path)))


@pytest.mark.parametrize(
    "words",
    [
        r"Here $\omega_{B/A}$ is the angular velocity of $B$ in $A$.",
        r"Let $\omega_{B/A}$ denote the angular velocity of the frame $B$ relative to the frame $A$.",
        r"The angular velocity $\omega_{B/A}$ of $B$ with respect to $A$ is constant.",
        r"The angular velocity of $B$ in $A$ is $\omega_{B/A}$.",
    ],
)
def test_angular_velocity_of_one_frame_in_another(tmp_path: Path, words: str) -> None:
    (spin,) = facts(tmp_path, words).spins
    assert (spin.name, spin.frame, spin.base) == (r"\omega_{B / A}", "B", "A")


@pytest.mark.parametrize(
    ("words", "rates"),
    [
        (r"where $v$ is the time derivative of $r$.", {"v": ("r", "")}),
        (r"where $v$ is the derivative of $r$ in $B$.", {"v": ("r", "B")}),
        (r"Let $r$ be a position, and let $v$ and $a$ be its first and second derivative in $B$.", {"v": ("r", "B"), "a": ("v", "B")}),
    ],
)  # fmt: skip
def test_rates_with_their_frame(tmp_path: Path, words: str, rates: dict[str, tuple[str, str]]) -> None:
    assert {name: each[:2] for name, each in facts(tmp_path, words).rates.items()} == rates


def test_constants_any_vectors_and_quaternions(tmp_path: Path) -> None:
    found = facts(
        tmp_path, "The lengths $l_1, l_2$ and any vectors $a$ and $b$. The unit quaternion $q = (q_0, q_v)$."
    )
    assert {*found.constants} == {"l_{1}", "l_{2}"} and {*found.free} == {"a", "b"}
    assert [(each.name, each.parts) for each in found.quaternions] == [("q", ("q_{0}", "q_{v}"))]


def test_a_sentence_without_facts_says_none(tmp_path: Path) -> None:
    found = facts(tmp_path, "Let $r$ be a vector; we compute $v$ from $r$ in $B$, and $a$ is small.")
    assert found == Facts()


def test_brackets_of_a_text_are_no_marks_of_formulas(tmp_path: Path) -> None:
    found = facts(tmp_path, "With ⟦7⟧ as in [7], ⟦0⟧ and the lengths $l_1$ and ⟦1⟧.")
    assert {*found.constants} == {"l_{1}"}


def test_the_sample_paper_is_judged_without_a_model() -> None:
    draft = draft_of(PAPER)
    results = on_drafted_kinds(draft, judge_paper(draft.paper, motions=False))
    shown = {result.claim.id: result.shown for result in results}
    assert [name for name, grade in shown.items() if grade is Grade.WARNING] == ["eq-coriolis.2", "eq-jac.1"]
    assert [name for name, grade in shown.items() if grade is Grade.NOT_JUDGED] == ["eq-jac.2"]
    assert Grade.ERROR not in shown.values() and len(shown) == 25


def test_columns_and_jacobians_are_defined() -> None:
    found: Ingested = ingest(PAPER)
    bodies = {each.name: each.body for each in found.definitions if each.sure}
    assert bodies[r"\boldsymbol{\theta}"].startswith(r"\begin{bmatrix} \theta_{1}")
    assert r"\frac{\partial x}{\partial \theta_{1}}" in bodies[r"\boldsymbol{J}"]


def test_an_angle_that_is_a_sum_has_no_components(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text(
        r"""$$ q = \theta_{1} + \theta_{2} $$

$$ x = l \cos q $$

$$ y = l \sin q $$

$$ \begin{bmatrix} \dot x \\ \dot y \end{bmatrix} = J \dot q $$

$$ J = \begin{bmatrix} -l \sin q \\ l \cos q \end{bmatrix} $$
"""
    )
    draft = draft_of(path)
    results = on_drafted_kinds(draft, judge_paper(draft.paper, motions=False))
    assert Grade.NOT_JUDGED not in [result.shown for result in results]


@pytest.mark.parametrize(
    ("body", "components"),
    [
        (r"\begin{bmatrix} q_1 \\ q_2 \end{bmatrix}", ["q_{1}", "q_{2}"]),
        (r"(q_1, q_2)^T", ["q_{1}", "q_{2}"]),
        (r"\left[ q_2 \; q_1 \; q_3 \right]^T", ["q_{2}", "q_{1}", "q_{3}"]),
        (r"q_1 + q_2", []),
        (r"R p_{1}", []),
        (r"\begin{bmatrix} q_1 & q_2 \\ q_3 & q_4 \end{bmatrix}", []),
    ],
)
def test_components_are_those_of_a_column(body: str, components: list[str]) -> None:
    assert components_of(body) == components


def test_a_rotation_is_defined_by_its_parameters_in_its_section(tmp_path: Path) -> None:
    path = tmp_path / "p.tex"
    path.write_text(
        r"""\begin{document}\section{One}The rotation matrix $R$: \[ R R^T = I_3 \]
        With an angle $\theta$ and the unit vector $u$: \[ R = I_3 + \sin\theta [u]_\times + (1 - \cos\theta) [u]_\times^2 \]
        \[ \operatorname{tr} R = 1 + 3 \cos\theta \]
        \section{Two}\[ R R^T = I_3 \]\end{document}"""
    )
    draft = draft_of(path)
    results = on_drafted_kinds(draft, judge_paper(draft.paper, motions=False))
    assert [result.verdict.outcome for result in results] == [
        Outcome.PROVED,
        Outcome.DEFINITION,
        Outcome.REFUTED,
        Outcome.PROVED,
    ]


def test_a_letter_that_is_said_to_be_the_identity_is_it(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text("For the rotation matrix $R$ and where $E$ is the identity matrix:\n\n$$ R R^T = E $$\n")
    draft = draft_of(path)
    (result,) = judge_paper(draft.paper, motions=False)
    assert result.verdict.outcome is Outcome.PROVED
