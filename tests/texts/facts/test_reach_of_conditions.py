"""A condition of one claim reaches no claim of another paragraph; what a sentence declares reaches its section."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import (
    ALPHABETS,
    FORMATS,
    display,
    heading,
    inline,
    model_of,
    renamed,
    text_of,
    verdicts,
)
from workbench.core.verdict import Grade, Outcome

#: A value of a symbol, and a formula that is true with it and false without it.
VALUES = [
    ("<f> = 0", "<f> <g> <h> + <f>^2 <h> = <f> (<g> + <h>)"),
    ("<f> = 1", "<f> <g> <h> + <f>^2 <h> = <g> <h> + <f>^3 <h>"),
    (r"<x> = \pi/2", r"\sin <x> + <g> <h> = 1 + <g> <h> + \cos <x>"),
]
#: Sentences that end where the display of their claim begins; {} is the value.
CASES = [
    *(f"{words} {{}}, we have" for words in ("If", "When", "For", "At", "Provided that", "While", "Given")),
    *(f"{words} {{}}. Then" for words in ("Suppose that", "We assume that", "Assume")),
    "With {}, we get",
    "In the case where {}, we get",
]
#: Words between a display and the value that explains it; with a blank line before them or not.
EXPLAINS = ["where {}.", "with {}.", "in which {}.", "when {}.", "if {}.", "provided that {}."]
#: Sentences that stand in a paragraph of their own, or define.
DECLARED = [
    "Assume {}.\n\nThen",
    "Suppose that {}.\n\nSo we have",
    "Let {}. Then",
    "We set {}. Then",
    "Put {}, which gives",
    "In this section {}.\n\nWe have",
]


def _section(said: str, claim: str, form: str, again: str) -> list[str]:
    """Returns a section with the claim in the sentence, and in another paragraph."""
    shown = display(claim, form)
    first = f"{said}\n\n{shown}" if form == "rst" else f"{said}\n{shown}"
    return [heading("One", form), first, again, shown]


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("sentence", CASES)
def test_case_reaches_no_other_paragraph(tmp_path: Path, form: str, sentence: str) -> None:
    letters = ALPHABETS[len(sentence) % 3]
    for value, formula in VALUES:
        value, formula = renamed(value, letters), renamed(formula, letters)
        said = sentence.format(inline(value, form))
        text = text_of(_section(said, formula, form, "This is different:"), form)
        first, again = verdicts(tmp_path, text, model_of(letters, form), form)
        assert (first.outcome, again.outcome) == (Outcome.CONDITIONAL, Outcome.REFUTED), text
        assert again.grade is Grade.WARNING
        assert value.replace(" ", "") in " ".join(again.unless).replace(" ", "")


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("sentence", EXPLAINS)
def test_value_behind_a_display_reaches_no_other_paragraph(tmp_path: Path, form: str, sentence: str) -> None:
    letters = ALPHABETS[len(sentence) % 3]
    for value, formula in VALUES:
        shown = display(renamed(formula, letters), form)
        words = sentence.format(inline(renamed(value, letters), form))
        for parts in ([f"{shown}\n{words}"], [shown, words]):
            text = text_of([*parts, "This is different:", shown], form)
            first, again = verdicts(tmp_path, text, model_of(letters, form), form)
            assert (first.outcome, again.outcome) == (Outcome.CONDITIONAL, Outcome.REFUTED), text
            assert again.grade is Grade.WARNING


@pytest.mark.parametrize("form", FORMATS)
def test_sentence_speaks_of_the_symbols_by_which_it_defines(tmp_path: Path, form: str) -> None:
    letters = ALPHABETS[0]
    parts = (r"<g> = <f> <x>", r"<h> = <m> <x>", "<x>^2 = 1")
    words = "where " + ", ".join(inline(renamed(each, letters), form) for each in parts) + "."
    for formula, expected in (
        ("<g> <h> = <f> <m>", Outcome.CONDITIONAL),
        ("<g> <h> = 2 <f> <m>", Outcome.REFUTED),
    ):
        text = text_of([display(renamed(formula, letters), form), words], form)
        (found,) = verdicts(tmp_path, text, model_of(letters, form), form)
        assert found.outcome is expected, formula


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("sentence", DECLARED)
def test_declaration_reaches_the_paragraphs_of_its_section(tmp_path: Path, form: str, sentence: str) -> None:
    letters = ALPHABETS[len(sentence) % 3]
    for value, formula in VALUES:
        said = sentence.format(inline(renamed(value, letters), form))
        formula = renamed(formula, letters)
        section = _section(said, formula, form, "The same once more:")
        other = [heading("Two", form), "So", display(formula, form)]
        text = text_of([*section, *other], form)
        found = verdicts(tmp_path, text, model_of(letters, form), form)
        assert [each.outcome for each in found] == [Outcome.CONDITIONAL] * 2 + [Outcome.REFUTED], text


@pytest.mark.parametrize("form", FORMATS)
def test_case_reaches_the_displays_of_its_sentence(tmp_path: Path, form: str) -> None:
    letters = ALPHABETS[0]
    value, formula = (renamed(each, letters) for each in VALUES[0])
    shown = display(formula, form)
    text = text_of([f"If {inline(value, form)}, we have", shown, "and also", shown], form)
    found = verdicts(tmp_path, text, model_of(letters, form), form)
    assert [each.outcome for each in found] == [Outcome.CONDITIONAL] * 2


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("sentence", ["Let {}. Then", "If {}, we have", "Suppose {}. Then"])
def test_case_excuses_no_formula_of_the_next_section(tmp_path: Path, form: str, sentence: str) -> None:
    letters = ALPHABETS[1]
    said = sentence.format(inline(renamed("<f> = 2 <g>", letters), form))
    shown = display(renamed("<f>^2 = 4 <g>^2", letters), form)
    text = text_of(
        [heading("One", form), said, shown, heading("Two", form), "Now both are arbitrary:", shown], form
    )
    first, again = verdicts(tmp_path, text, model_of(letters, form), form)
    assert first.outcome is Outcome.CONDITIONAL
    assert again.outcome in (Outcome.REFUTED, Outcome.DEFINITION)  # it says what a symbol is


def test_value_of_a_section_does_not_count_in_the_next_one(tmp_path: Path) -> None:
    letters = ALPHABETS[0]
    value, formula = (renamed(each, letters) for each in VALUES[0])
    parts = [heading("One", "tex"), f"Here ${value}$.", display(formula, "tex")]
    line = " ".join([*parts, heading("Two", "tex"), display(formula, "tex")]).replace("\n", " ")
    first, again = verdicts(tmp_path, text_of([line], "tex"), model_of(letters, "tex"), "tex")
    assert (first.outcome, again.outcome) == (Outcome.CONDITIONAL, Outcome.REFUTED)
