"""A sentence that says that a quaternion is a unit makes its parts those of a unit quaternion."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.drafts import draft_of
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Outcome
from workbench.papers.drafting.judged_draft import on_drafted_kinds
from workbench.papers.drafting.marked_text import MarkedText
from workbench.papers.drafting.sentence_kinds import Quaternion, facts_of
from workbench.source.documents import read_text

SENTENCES = [
    "The attitude is the unit quaternion $q = {}$.",
    "Let $q = {}$ be a unit quaternion.",
    "The unit-norm quaternion $q$ has the parts $q = {}$.",
    "Here $q$ is a unit quaternion, $q = {}$.",
    "The quaternion $q = {}$ is normalised.",
    "A rotation is represented by a normalized quaternion $q = {}$.",
]
#: The parts as written, their names, and the norm of the quaternion.
PARTS = [
    ("(s, v)", ("s", "v"), "s^2 + v^T v"),
    ("[v, s]", ("v", "s"), "s^2 + v^T v"),
    (r"\begin{bmatrix} v \\ s \end{bmatrix}", ("v", "s"), "s^2 + v^T v"),
    ("[q_0, q_1, q_2, q_3]", tuple(f"q_{{{k}}}" for k in range(4)), "q_0^2 + q_1^2 + q_2^2 + q_3^2"),
    ("[q_1, q_2, q_3, q_4]^T", tuple(f"q_{{{k}}}" for k in range(1, 5)), "q_1^2 + q_2^2 + q_3^2 + q_4^2"),
    ("q_w + q_x i + q_y j + q_z k", tuple(f"q_{{{k}}}" for k in "wxyz"), "q_w^2 + q_x^2 + q_y^2 + q_z^2"),
    (r"q_w + \mathbf{q}_v", ("q_{w}", r"\mathbf{q}_{v}"), r"q_w^2 + \mathbf{q}_v^T \mathbf{q}_v"),
]
ABOUT = "Quaternions: the quaternion product of $s$, its scalar part, and the vector $v$.\n\n"


def written(folder: Path, words: str, *formulas: str) -> Path:
    path = folder / "p.md"
    path.write_text(ABOUT + words + "\n\n" + "\n\n".join(f"$$ {latex} $$" for latex in formulas) + "\n")
    return path


@pytest.mark.parametrize("sentence", SENTENCES)
@pytest.mark.parametrize(("body", "names", "_"), PARTS, ids=[body for body, *_ in PARTS])
def test_parts_of_a_unit_quaternion(
    tmp_path: Path, sentence: str, body: str, names: tuple[str, ...], _: str
) -> None:
    text = read_text(written(tmp_path, sentence.format(body), "x = y"))
    assert [(each.name, each.parts) for each in facts_of(MarkedText(text)).quaternions] == [("q", names)]


@pytest.mark.parametrize("number", ["1", "2"])
@pytest.mark.parametrize(("body", "_", "norm"), PARTS, ids=[body for body, *_ in PARTS])
def test_the_parts_of_a_unit_quaternion_have_norm_1(
    tmp_path: Path, body: str, _: tuple[str, ...], norm: str, number: str
) -> None:
    draft = draft_of(written(tmp_path, SENTENCES[0].format(body), "s = s", f"{norm} = {number}"))
    results = on_drafted_kinds(draft, judge_paper(draft.paper, motions=False))
    expected = Outcome.PROVED if number == "1" else Outcome.REFUTED
    assert results[-1].verdict.outcome is expected, results[-1].verdict.reason


@pytest.mark.parametrize(
    "words",
    [
        "A quaternion $q = (s, v)$ has the norm $n$.",
        "Not every quaternion $q = (s, v)$ is one.",
        "The unit vector $q = (s, v)$.",
    ],
)
def test_a_quaternion_of_any_norm_is_no_unit(tmp_path: Path, words: str) -> None:
    assert facts_of(MarkedText(read_text(written(tmp_path, words, "x = y")))).quaternions == []


def test_an_equation_elsewhere_lists_the_parts(tmp_path: Path) -> None:
    path = written(tmp_path, "Let $q$ be a unit quaternion.", r"q = \begin{bmatrix} s \\ v \end{bmatrix}")
    (found,) = facts_of(MarkedText(read_text(path))).quaternions
    assert found == Quaternion("q", ("s", "v"), found.line)
