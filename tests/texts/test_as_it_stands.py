"""What a model may say of one claim or spelling, and what one scope or false premise must not do to others."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import shown, told, verdicts
from workbench.core.paper_errors import PaperError
from workbench.language.printing.printer import to_latex
from workbench.papers.load import load_paper
from workbench.prover.decide.decide import Judge
from workbench.runtime import Budget


def outcomes(folder: Path, text: str, model: str, suffix: str = "md") -> list[str]:
    return [told(each) for each in verdicts(folder, text, model, suffix)]


@pytest.mark.parametrize(
    ("claim", "excused", "alone"),
    [
        (r"w = a \times b", "said", "refuted"),
        (r"a \times (b + c) = a \times b + a \times c", "proved", "proved"),
        (r"\dot a = a \times b", "said", "refuted"),
    ],
)
def test_a_closed_context_excuses_nothing(tmp_path: Path, claim: str, excused: str, alone: str) -> None:
    text = shown("a = 2 d", "b = c", claim)
    model = "[symbols]\na = 'vector'\nb = 'vector'\nc = 'vector'\nd = 'vector'\nw = 'vector'\n"
    assert outcomes(tmp_path, text, model)[-1] == excused
    assert outcomes(tmp_path, text, f"{model}[[claim]]\nat = 'line 5'\ngiven = []\n")[-1] == alone


FALSE = "y = 3 x"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (shown(FALSE, "y = 5 x"), "[[claim]]\nat = 'line 3'\ngiven = ['line 1']\n"),
        (shown(rf"{FALSE} \Rightarrow y = 5 x"), ""),
    ],
)
def test_nothing_is_proved_from_what_contradicts_its_definition(tmp_path: Path, text: str, said: str) -> None:
    model = f"[symbols]\nx = 'scalar'\n[definitions]\ny = '2 x'\n{said}"
    assert outcomes(tmp_path, text, model)[-1] == "conditional"


ROWS = {
    r"y = \Big(2 x\Big) \\ \Big/ \Big(2\Big)": "proved",
    r"y = (2 x) \\ / (2)": "proved",
    r"y = \frac{1}{2} \\ (2 x)": "proved",
    r"y = \frac{1}{2} (x \\ + x)": "proved",
    r"y = \frac{1}{2} \\ (3 x)": "refuted",
    r"y^2 + y \\ - x y = y": "proved",
    r"y^2 + y \\ - x y + x = y": "refuted",
    r"y = 2 x \\ - x = y": "proved",
}


@pytest.mark.parametrize("rows", ROWS)
def test_the_rows_of_a_multline_are_one_formula(tmp_path: Path, rows: str) -> None:
    text = rf"\begin{{document}}\begin{{multline}}{rows}\end{{multline}}\end{{document}}"
    model = "[symbols]\nx = { kind = 'scalar', free = true }\n[definitions]\ny = 'x'\n"
    assert set(outcomes(tmp_path, text, model, "tex")) == {ROWS[rows]}


def test_a_model_says_what_a_judgement_may_cost(tmp_path: Path) -> None:
    (tmp_path / "p.md").write_text(shown("1 = 1"))
    (tmp_path / "p.toml").write_text("source = 'p.md'\nbudget = { seconds = 3 }\n")
    assert load_paper(tmp_path / "p.toml").budget == Budget(seconds=3)
    (tmp_path / "p.toml").write_text("source = 'p.md'\nbudget = { seconds = -1 }\n")
    with pytest.raises(PaperError, match="budget: seconds: expected a positive number"):
        load_paper(tmp_path / "p.toml")


def test_a_sentence_that_is_indented_is_none_of_the_display(tmp_path: Path) -> None:
    text = (
        "T\n\n.. math::\n\n   y = 2 x\n\n Since :math:`y = x` here, it holds.\n\n.. math::\n\n   y - x = x\n"
    )
    model = "[symbols]\nx = { kind = 'scalar', free = true }\n[definitions]\ny = '2 x'\n"
    assert outcomes(tmp_path, text, model, "rst") == ["definition", "proved"]


def test_a_crash_on_one_formula_keeps_the_other_verdicts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def judge(self: Judge, statement, *arguments, **options):
        if "b" in to_latex(statement):
            raise ValueError("matmul: a mismatch")
        return whole(self, statement, *arguments, **options)

    whole = Judge.judge
    monkeypatch.setattr(Judge, "judge", judge)
    first, second = verdicts(
        tmp_path,
        shown("a + a = 2 a", "b + b = 2 b"),
        "source = 'p.md'\n[symbols]\na = 'scalar'\nb = 'scalar'\n",
    )
    assert (first.outcome, second.outcome) == ("proved", "unchecked")
    assert "a defect of the workbench" in second.reason and "matmul" in second.reason
