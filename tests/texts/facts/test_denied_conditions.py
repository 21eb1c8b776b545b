"""A formula that a sentence denies is no condition, and a condition ends where the words say so."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import ALPHABETS, FORMATS, display, inline, model_of, renamed, text_of, verdicts
from workbench.core.verdict import Grade, Outcome
from workbench.papers.drafting import ingest

#: True for f = 0 alone.
ONLY_AT_ZERO = r"<f> <g> <h> + <f>^2 <h> = <f> (<g> + <h>)"
DENIALS = (
    "It is not assumed that {}. Then",
    "We do not suppose that {}, and find",
    "Whether or not {}, we find",
    "Regardless of whether {},",
    "Without assuming {} we find",
    "Even if {} is allowed,",
    "One might think that {}. Then",
    "It need not be true that {}. Then",
    "Here {} is not required, and",
    "Suppose {}, but this is wrong, and",
    "We never use that {}, so",
)
SUPPOSITIONS = (
    "So long as {},",
    "In the event that {},",
    "On the assumption that {} we have",
    "Under the condition {},",
    "Let us suppose that {}. Then",
    "It does not matter why, but for {} we have",
    "If it were true that {}, we would have",
)
ENDS = ("Otherwise,", "In the general case,", "In general,", "Dropping this restriction,", "For all values,")


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("words", DENIALS)
def test_denied_formula_is_no_condition(tmp_path: Path, form: str, words: str) -> None:
    letters = ALPHABETS[len(words) % 3]
    said = words.format(inline(renamed("<f> = 0", letters), form))
    shown = display(renamed(ONLY_AT_ZERO, letters), form)
    for parts in ([f"{said}\n{shown}"], [said, shown]):
        (found,) = verdicts(tmp_path, text_of(parts, form), model_of(letters, form), form)
        assert (found.outcome, found.grade) == (Outcome.REFUTED, Grade.ERROR), parts


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("words", SUPPOSITIONS)
def test_supposed_formula_is_a_condition(tmp_path: Path, form: str, words: str) -> None:
    letters = ALPHABETS[len(words) % 3]
    said = words.format(inline(renamed("<f> = 0", letters), form))
    text = text_of([f"{said}\n{display(renamed(ONLY_AT_ZERO, letters), form)}"], form)
    (found,) = verdicts(tmp_path, text, model_of(letters, form), form)
    assert found.outcome in (Outcome.PROVED, Outcome.CONDITIONAL)


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("value", ["<f> = 0", r"\dot{<f>} = 0"])
@pytest.mark.parametrize("end", ENDS)
def test_case_ends_where_words_end_it(tmp_path: Path, form: str, value: str, end: str) -> None:
    letters = ALPHABETS[len(end) % 3]
    formula = ONLY_AT_ZERO if "dot" not in value else r"\frac{d}{dt} (<f> <g>) = <f> \dot{<g>}"
    said, shown = inline(renamed(value, letters), form), display(renamed(formula, letters), form)
    for between in ("\n", "\n\n"):
        text = text_of([f"If {said}, we have\n{shown}{between}{end} we find\n{shown}"], form)
        first, second = verdicts(tmp_path, text, model_of(letters, form), form)
        assert first.outcome in (Outcome.PROVED, Outcome.CONDITIONAL)
        assert second.outcome is Outcome.REFUTED, text
        assert second.grade is (Grade.ERROR if value == "<f> = 0" else Grade.WARNING), text  # or f rests


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("words", [*DENIALS, "For {} we have", "Case 1: {}.", "If {},", "At {} we see that"])
def test_draft_defines_no_symbol_by_a_condition(tmp_path: Path, form: str, words: str) -> None:
    letters = ALPHABETS[len(words) % 3]
    more = display(renamed("(<f> + <g>)^2 = 4 <f> <g>", letters), form)
    for value in ("<f> = <g>", "<f> = 0"):
        said = words.format(inline(renamed(value, letters), form))
        path = tmp_path / f"p.{form}"
        path.write_text(text_of([f"{said}\n{more}", f"Further\n{more}"], form))
        assert not ingest(path).definitions, said


@pytest.mark.parametrize("form", FORMATS)
def test_draft_keeps_the_definition_of_a_sentence(tmp_path: Path, form: str) -> None:
    letters = ALPHABETS[0]
    said = inline(renamed("<f> = <g>^2", letters), form)
    more = display(renamed("<f> <g> = <g>^3", letters), form)
    path = tmp_path / f"p.{form}"
    for words in (f"The area is {said}, so that", f"For a square, the area is {said}.", f"Let {said}. Then"):
        path.write_text(text_of([f"{words}\n{more}"], form))
        assert [each.name for each in ingest(path).definitions] == [letters["f"]], words


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("words", ["For", "If", "Whenever", "So long as", "Suppose that"])
def test_case_is_no_doubt_of_an_earlier_sentence(tmp_path: Path, form: str, words: str) -> None:
    letters = ALPHABETS[len(words) % 3]
    shown = display(renamed(ONLY_AT_ZERO, letters) + ".", form)
    more = display(renamed("<f> <g>^2 = <f> <h>", letters), form)  # holds in the case, and says what h is
    text = text_of(
        ["Now", shown, f"{words} {inline(renamed('<f> = 0', letters), form)}, we have\n{more}"], form
    )
    found, _ = verdicts(tmp_path, text, model_of(letters, form), form)
    assert (found.outcome, found.grade) == (Outcome.REFUTED, Grade.ERROR), text


@pytest.mark.parametrize("form", ["tex", "md"])
@pytest.mark.parametrize("value", ["<f> = 0", r"\dot{<f>} = 0"])
@pytest.mark.parametrize("words", ["{} yields", "If {}, then", "Since {},", "Suppose {}. Then"])
def test_case_of_an_item_is_no_doubt_of_another(tmp_path: Path, form: str, value: str, words: str) -> None:
    letters = ALPHABETS[len(words) % 3]
    said = words.format(inline(renamed(value, letters), form))
    formula = renamed(
        ONLY_AT_ZERO if "dot" not in value else r"\frac{d}{dt} \cos <f> = \dot{<f>} \sin <f>", letters
    )
    mark, inside = {"tex": (r"\item", f"$${formula}$$"), "md": ("1.", f"$$ {formula} $$")}[form]
    text = f"{mark} {said}\n   {inside}\n{mark} Further\n   {inside}\n"
    text = f"\\begin{{enumerate}}\n{text}\\end{{enumerate}}\n" if form == "tex" else text
    first, other = verdicts(tmp_path, text, model_of(letters, form), form)
    assert first.outcome in (Outcome.PROVED, Outcome.CONDITIONAL), text
    assert (other.outcome, other.grade) == (Outcome.REFUTED, Grade.ERROR), text
