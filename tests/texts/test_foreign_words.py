"""Words in other languages between the formulas of a display: what they say is asked, nothing is dropped."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench.app.pipeline.judge_claims import judge_claims
from workbench.core.verdict import Outcome
from workbench.papers.texts.load_texts import load_text

WORDS = ["falls", "si", "wobei", "donde", "dans le cas où", "jeśli", "если", "mit", "hvis"]
LAYOUTS = [
    r"\[ A \quad \text{W} \quad C \]",
    r"\[ A \text{ W } C \]",
    r"\[ A, \quad \mbox{W } C. \]",
    r"\begin{align} L &= R \quad \text{W } C \\ &= b^2 + a^2 \end{align}",
    r"\begin{align} L &= R && \text{W } C \end{align}",
    r"\begin{gather} A \text{ W } C \end{gather}",
]
FALSE, TRUE = ("(a + b)^2", "a^2 + b^2"), ("(a + b)^2", r"a^2 + 2 a \cdot b + b^2")


def outcomes(tmp_path: Path, sides: tuple[str, str], beside: str, layout: str, words: str) -> list[Outcome]:
    body = layout.replace("A", " = ".join(sides)).replace("L", sides[0]).replace("R", sides[1])
    body = body.replace("C", beside).replace("W", words)
    (tmp_path / "p.tex").write_text(f"\\begin{{document}}\n{body}\n\\end{{document}}")
    model = tmp_path / "p.toml"
    model.write_text('source = "p.tex"\n[symbols]\na = "vector"\nb = "vector"\n')
    return [each.verdict.outcome for each in judge_claims(load_text(tmp_path / "p.tex").claims)]


@pytest.mark.parametrize("layout", LAYOUTS)
@pytest.mark.parametrize("words", WORDS[:3])
def test_foreign_words_may_say_a_condition(tmp_path: Path, layout: str, words: str) -> None:
    found = outcomes(tmp_path, FALSE, r"a \cdot b = 0", layout, words)
    assert [each for each in found if each is not Outcome.PROVED] == [Outcome.CONDITIONAL, Outcome.UNCHECKED]


@pytest.mark.parametrize("words", WORDS)
def test_foreign_words_prove_nothing_false(tmp_path: Path, words: str) -> None:
    found = outcomes(tmp_path, FALSE, r"a \times b = - b \times a", LAYOUTS[1], words)
    assert found == [Outcome.REFUTED, Outcome.PROVED]


@pytest.mark.parametrize("layout", LAYOUTS[:3])
def test_both_formulas_around_foreign_words_are_judged(tmp_path: Path, layout: str) -> None:
    found = outcomes(tmp_path, TRUE, r"a \times b = b \times a", layout, "und")
    assert found == [Outcome.PROVED, Outcome.REFUTED]


def test_a_row_goes_on_with_what_is_at_the_mark(tmp_path: Path) -> None:
    layout = r"\begin{align} L &= R, \quad C \\ &= b^2 + 2 a \cdot b + a^2 \end{align}"
    found = outcomes(tmp_path, TRUE, r"a \times b = - b \times a", layout, "")
    assert found == [Outcome.PROVED, Outcome.PROVED, Outcome.PROVED]
