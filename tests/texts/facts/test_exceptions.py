"""What a text excludes is no condition: "unless f = 0" says nothing of f = 0, and another sentence nothing of f."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import (
    ALPHABETS,
    FORMATS,
    KINDS,
    display,
    inline,
    model_of,
    renamed,
    text_of,
    verdicts,
)
from workbench import check
from workbench.app.checked import Checked
from workbench.core.verdict import Grade, Outcome
from workbench.papers.drafting import ingest, model_text

EXCEPTIONS = ("unless", "except for", "except when", "apart from", "other than for", "excluding")
#: True for f = 0 alone, and true for all f but 0.
ONLY_AT_ZERO = r"<f> <g> <h> + <f>^2 <h> = <f> (<g> + <h>)"
BUT_AT_ZERO = r"\frac{<f> <g>}{<f>} = <g>"
#: Sentences behind a display without a full stop, of the next display; {} is f = 0.
OTHER_SENTENCES = (
    "If {}, we have",
    "For {}, we find",
    "With {}, this is",
    "Since {}, it follows that",
    "When {} then",
)
OWN_CONDITIONS = ("If {}.", "For {}.", "When {} and in no other case.", "where {}.", "if {}, of course.")


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("words", EXCEPTIONS)
def test_excluded_value_is_no_condition(tmp_path: Path, form: str, words: str) -> None:
    letters = ALPHABETS[len(words) % 3]
    value = inline(renamed("<f> = 0", letters), form)
    for formula, wanted in ((ONLY_AT_ZERO, Outcome.REFUTED), (BUT_AT_ZERO, Outcome.PROVED)):
        shown = display(renamed(formula, letters), form)
        for parts in ([f"{shown}\n{words} {value}."], [shown, f"{words} {value}."]):
            (found,) = verdicts(tmp_path, text_of(parts, form), model_of(letters, form), form)
            assert found.outcome in (wanted, Outcome.CONDITIONAL), parts
            assert (found.outcome is Outcome.REFUTED) is (wanted is Outcome.REFUTED), parts
            assert found.grade in (Grade.ERROR, Grade.OK), parts


@pytest.mark.parametrize("words", EXCEPTIONS)
@pytest.mark.parametrize(
    "place", [r"%s \quad \text{%s } %s", r"%s \quad \text{%s $%s$}", r"%s, \text{%s } %s"]
)
def test_excluded_value_in_a_display_proves_nothing(tmp_path: Path, words: str, place: str) -> None:
    letters = ALPHABETS[len(words) % 3]
    latex = renamed(place % (ONLY_AT_ZERO, words, "<f> = 0"), letters)
    checked = []
    try:
        made = check(latex, symbols={letters[mark]: kind for mark, kind in KINDS.items()})
        checked = [made] if isinstance(made, Checked) else list(made)
    except ValueError:  # words in a formula are not read
        pass
    text = text_of([display(latex, "tex")], "tex")
    found = [*(each.verdict for each in checked), *verdicts(tmp_path, text, model_of(letters, "tex"), "tex")]
    assert {each.outcome for each in found} <= {Outcome.UNCHECKED, Outcome.REFUTED}, latex


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("sentence", [*OTHER_SENTENCES, *OWN_CONDITIONS])
def test_condition_of_another_sentence_proves_no_display(tmp_path: Path, form: str, sentence: str) -> None:
    letters = ALPHABETS[len(sentence) % 3]
    said = sentence.format(inline(renamed("<f> = 0", letters), form))
    is_other = sentence in OTHER_SENTENCES
    shown, more = (display(renamed(each, letters), form) for each in (ONLY_AT_ZERO, "<f> <g> = 0"))
    for parts in ([f"{shown}\n{said}"], [shown, said]):
        text = text_of([*parts, *[more] * is_other], form)
        found, *_ = verdicts(tmp_path, text, model_of(letters, form), form)
        assert found.outcome is (Outcome.REFUTED if is_other else Outcome.CONDITIONAL), text
        assert not is_other or found.grade is Grade.WARNING, text


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("sentence", ["For constant {},", "If {} is constant,", "As long as {} is constant,"])
def test_draft_takes_no_constant_from_a_case(tmp_path: Path, form: str, sentence: str) -> None:
    formulas = (r"\dot{p} = m \dot{v} + \dot{m} v", r"\dot{p} = m \dot{v}")
    for words, is_constant in ((sentence, False), ("Here {} is constant.", True)):
        shown, other = (display(each, form) for each in formulas)
        parts = [f"With {inline('p = m v', form)} the rate is", shown, words.format(inline("m", form)), other]
        (tmp_path / f"p.{form}").write_text(text_of(parts, form))
        model = model_text(ingest(tmp_path / f"p.{form}"), tmp_path / "p.toml")
        assert ("constant = true" in model) is is_constant, model
