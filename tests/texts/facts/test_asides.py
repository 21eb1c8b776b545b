r"""What a text supposes in its sentences: a formula that is false only without it holds by it."""

import json
from pathlib import Path

import pytest

from tests.texts.written import told, verdicts
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Outcome
from workbench.papers import load_paper

MODEL = "source = 'p.{}'\n[symbols]\n" + "\n".join(
    f"'{name}' = {{{{ kind = '{kind}' }}}}"
    for name, kind in {"a": "vector", "b": "vector", "f": "scalar", "g": "scalar", "m": "scalar"}.items()
)
_AFTER = {"<<": "", "[[": " "}
CANCELLED = r"f g = f \Rightarrow g = 1"
DISPLAYS = {
    "tex": ("${}$", r"\[ {} \]"),
    "md": ("${}$", "\n\n$$\n{}\n$$\n\n"),
    "rst": (":math:`{}`", "\n\n.. math::\n\n   {}\n\n"),
    "html": (r"\({}\)", "$${}$$"),
    "ipynb": ("${}$", "\n\n$$\n{}\n$$\n\n"),
}


def outcomes_of(folder: Path, text: str, ending: str = "tex") -> list[str]:
    (folder / f"p.{ending}").write_text(notebook([text]) if ending == "ipynb" else text)
    (folder / "p.toml").write_text(MODEL.format(ending))
    return [told(result.verdict) for result in judge_paper(load_paper(folder / "p.toml"))]


def notebook(cells: list[str]) -> str:
    sources = [
        {"cell_type": "markdown", "metadata": {}, "source": each.splitlines(keepends=True)} for each in cells
    ]
    return json.dumps({"cells": sources}, indent=1)


def written(text: str, ending: str) -> str:
    """The text with (…) for a formula in a sentence and […] for a display."""
    inline, display = DISPLAYS[ending]
    for mark, spelling in (("<<", inline), ("[[", display)):
        pieces = text.split(mark)
        closing = {"<<": ">>", "[[": "]]"}[mark]
        text = pieces[0] + "".join(
            spelling.format(*piece.split(closing)[:1]) + piece.split(closing)[1].lstrip(_AFTER[mark])
            for piece in pieces[1:]
        )
    return text


@pytest.mark.parametrize("ending", DISPLAYS)
@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (f"Suppose that <<f \\neq 0>>. Then [[{CANCELLED}]]", "conditional"),
        (f"For <<f \\neq 0>> it is said that [[{CANCELLED[:-1]}2]]", "refuted"),
        (f"It holds that [[{CANCELLED}]] where <<f \\neq 0>> is given.", "conditional"),
        (f"It holds that [[{CANCELLED}]] without more.", "refuted"),
        (r"With <<m > 0>> it is [[\sqrt{m^2} = m]]", "conditional"),
        (r"With <<m > 0>> it is [[\sqrt{m^2} = -m]]", "refuted"),
        (r"It is [[\sqrt{m^2} = m, \quad m > 0]]", "conditional"),
        (r"It is [[\sqrt{m^2} = m \quad \text{for } m \geq 0]]", "conditional"),
        (r"It is [[\sqrt{m^2} = -m, \quad m > 0]]", "refuted"),
        (r"It is [[a \times b = b \times a, \quad m > 0]]", "refuted"),
        (r"It is [[a \times b = b \times a, \quad m \in (0, 1)]]", "refuted"),
        (r"It is [[a \times b = b \times a, \quad 0 \leq m < 1]]", "refuted"),
        (r"It is [[a \times b = -b \times a, \quad m \in (0, 1)]]", "proved"),
        (r"When <<f>> approaches zero, [[f a = 0]]", "said"),
        (r"In this case [[a \times b = b \times a]]", "refuted"),
        (r"With <<0 > m>> it is [[\sqrt{m^2} = -m]]", "unchecked"),
        (r"With <<m \geq 1>> it is [[|m| = m]]", "conditional"),
        (r"With <<0 < m < 1>> it is [[\sqrt{m^2} = m]]", "conditional"),
        (r"With <<m \in (0, 1]>> it is [[\sqrt{m^2} = m]]", "conditional"),
        (r"With <<m \in (0, 1]>> it is [[\sqrt{m^2} = -m]]", "refuted"),
        (r"With <<\cos f > 0>> it is [[\sqrt{1 - \sin^2 f} = \cos f]]", "unchecked"),
        (r"With <<\cos f > 0>> it is [[\sqrt{1 - \sin^2 f} = -\cos f]]", "refuted"),
        (r"Unless <<\cos f > 0>> it is [[\sqrt{1 - \sin^2 f} = -\cos f]]", "unchecked"),
        (r"Unless <<\cos f > 0>> it is [[\sqrt{1 - \sin^2 f} = \cos f]]", "refuted"),
        (r"With <<0 < f < \pi>> it is [[\sqrt{1 - \cos^2 f} = \sin f]]", "unchecked"),
        (r"With <<f \in [0, \pi)>> it is [[\sqrt{1 - \cos^2 f} = \sin f]]", "unchecked"),
        (r"With <<f \in (0, \pi)>> it is [[\sqrt{1 - \cos^2 f} = -\sin f]]", "refuted"),
        (r"With <<f \in [0, 2\pi)>> it is [[\sqrt{1 - \cos^2 f} = \sin f]]", "refuted"),
        (r"With <<-\pi \leq f < \pi>> it is [[\sin^2 f = 1 + \cos^2 f]]", "refuted"),
        (r"With <<m > f>> it is [[|m - f| = m - f]]", "unchecked"),
        (r"If <<0 = a - g b>>, then [[a \times b = 0]]", "conditional"),
        (r"If <<0 = a - g b>>, then [[a \times b = b]]", "doubtful"),
        (r"If <<0 = a - g b>>, then it is so. The next one is [[a \times b = b \times a]]", "refuted"),
        (r"Suppose that <<f \neq 0>>. Then [[a \times b = b \times a]]", "refuted"),
        (r"Suppose that <<a>> and <<b>> do not change. Then [[a \times b = b \times a]]", "refuted"),
        (r"Suppose that <<a>> and <<b>> do not change. It is [[a \times b = b \times a]]", "refuted"),
        (r"It is [[a \times b = b \times a]] where <<a>> is fixed.", "refuted"),
        (r"It is [[a \times b = b \times a.]] The same holds where <<a>> is fixed.", "refuted"),
        (r"Let <<g \neq 0>> be given. It is [[a \times b = b \times a]]", "refuted"),
    ],
)  # fmt: skip
def test_a_condition_in_the_sentence(tmp_path: Path, ending: str, text: str, expected: str) -> None:
    assert outcomes_of(tmp_path, written(text, ending), ending) == [expected]


def test_a_condition_on_other_symbols_does_not_settle_a_formula(tmp_path: Path) -> None:
    """f is what nothing defines and stands there once; the sentence speaks of g."""
    text = r"It is [[a \times b = f g b \times a]] where <<0 = g - 2>> holds."
    assert outcomes_of(tmp_path, written(text, "tex")) == ["said"]
    text = r"It is [[a \times b = f b \times a]] where <<0 = f - 2>> holds."
    assert outcomes_of(tmp_path, written(text, "tex")) == ["refuted"]


def test_the_sentence_of_a_display_may_hold_others_before_it(tmp_path: Path) -> None:
    displays = r"\[a \times b = b \times a\]" + "\n" + r"\[a \times b = 2 b \times a\]"
    assert outcomes_of(tmp_path, f"For parallel vectors {displays}") == ["conditional"] * 2
    assert outcomes_of(tmp_path, f"It is so for parallel vectors. But {displays}") == ["refuted"] * 2


def test_the_condition_is_shown_with_its_line(tmp_path: Path) -> None:
    (verdict,) = verdicts(
        tmp_path,
        "\\newcommand{\\ff}{f}\nFor $\\ff \\neq 0$ it is\n\\[" + CANCELLED + "\\]",
        MODEL.format("tex"),
        "tex",
    )
    assert r"$f\neq0$ (line 2)" in verdict.reason
    assert str(verdict.hypothesis) == r"f\neq0"


def test_the_hypothesis_is_the_condition_that_is_needed(tmp_path: Path) -> None:
    for more in (r"<<g \neq 0>> and <<f \neq 0>>", r"<<f \neq 0>> and <<g \neq 0>>"):
        (tmp_path / "p.tex").write_text(written(f"For {more} it is [[{CANCELLED}]]", "tex"))
        (tmp_path / "p.toml").write_text(MODEL.format("tex"))
        (result,) = judge_paper(load_paper(tmp_path / "p.toml"))
        assert str(result.verdict.hypothesis) == r"f \neq0"
        assert result.verdict.counterexample.values["f"] == ("0",)
    both = r"f g m = f g \Rightarrow m = 1"
    (tmp_path / "p.tex").write_text(written(rf"For <<f \neq 0>> and <<g \neq 0>> it is [[{both}]]", "tex"))
    (result,) = judge_paper(load_paper(tmp_path / "p.toml"))
    assert str(result.verdict.hypothesis) == r"f \neq0, g \neq0"


def test_facts_and_conditions_are_hypotheses_together(tmp_path: Path) -> None:
    for claimed, expected in (
        (r"f a = f m b \Rightarrow a = 2 g b", r"m = 2 g, f \neq0"),
        (r"m f = 2 g f", "m = 2 g"),
    ):
        text = rf"It is [[m = 2 g]] always. For <<f \neq 0>> it is [[{claimed}]]"
        last = verdicts(tmp_path, written(text, "tex"), MODEL.format("tex"), "tex")[-1]
        assert (last.outcome, str(last.hypothesis)) == (Outcome.CONDITIONAL, expected)


def test_an_assumption_of_the_model_is_a_premise(tmp_path: Path) -> None:
    model = MODEL.format("tex") + "\n[[claim]]\nat = 'line 1'\nassume = ['a = g b']\n"
    (verdict,) = verdicts(
        tmp_path, written(r"If <<0 = a - g b>>, then [[a \times b = 0]]", "tex"), model, "tex"
    )
    assert verdict.outcome == Outcome.PROVED


@pytest.mark.parametrize(
    ("sentence", "outcome"),
    [
        ("For parallel axes we have", "conditional"),
        ("As both vectors are non-parallel vectors,", "refuted"),
        ("For perpendicular vectors we have", "refuted"),
        ("When the two vectors coincide,", "refuted"),
        ("In the special case of no slip,", "refuted"),
        ("The first can be approximated by", "refuted"),
        ("Note that this is of the form", "refuted"),
        ("If you want to use a fixed frame, it is", "refuted"),
        ("The axes may be parallel. For any motion", "refuted"),
        ("For example, whatever they are:", "refuted"),
    ],
)
def test_a_sentence_counts_where_it_names_what_it_speaks_of(
    tmp_path: Path, sentence: str, outcome: str
) -> None:
    assert outcomes_of(tmp_path, sentence + r" \[ a \times b = b \times a \]") == [outcome]
    assert outcomes_of(tmp_path, sentence + r" \[ a \cdot b = b \cdot a \]") == ["proved"]


def test_an_example_says_nothing_of_what_the_model_defines(tmp_path: Path) -> None:
    (verdict,) = verdicts(
        tmp_path,
        r"For instance, the speed \[ f = 10 - 3 m \] is one.",
        MODEL.format("tex") + "\n[definitions]\n'f' = 'g + m'\n",
        "tex",
    )
    assert verdict.outcome is Outcome.REFUTED


DEFINED = "\n[definitions]\n'a' = '\\dot{m} b + f b'\n'g' = 'm^2'\n"


@pytest.mark.parametrize(
    ("text", "outcome"),
    [
        (r"With <<m = 0>> it is [[a^2 = f^2 b^2]]", "doubtful"),  # and if m stays 0, it holds
        (r"With <<m = 0>> it is [[a^2 = 4 f^2 b^2]]", "refuted"),
        (r"Let <<\dot{g} = f>> always. It is so. Now [[\dot{g}^2 = f^2]]", "conditional"),
        (r"Let <<\dot{g} = f>> always. It is so. Now [[\dot{g}^2 = 2 f^2]]", "refuted"),
    ],
)
def test_conditions_on_definitions_and_earlier_rates_apply(tmp_path: Path, text: str, outcome: str) -> None:
    (tmp_path / "p.tex").write_text(written(text, "tex"))
    (tmp_path / "p.toml").write_text(MODEL.format("tex") + DEFINED)
    assert [told(result.verdict) for result in judge_paper(load_paper(tmp_path / "p.toml"))] == [outcome]


def test_a_sentence_ends_with_its_cell(tmp_path):
    cells = [f"It holds that\n$$\n{CANCELLED}\n$$\n", "where $f \\neq 0$ is given"]
    (tmp_path / "p.toml").write_text(MODEL.format("ipynb"))
    for parts, expected in ((cells, Outcome.REFUTED), (["".join(cells)], Outcome.CONDITIONAL)):
        (tmp_path / "p.ipynb").write_text(notebook(parts))
        (result,) = judge_paper(load_paper(tmp_path / "p.toml"))
        assert result.verdict.outcome is expected
