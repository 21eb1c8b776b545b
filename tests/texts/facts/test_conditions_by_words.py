"""A formula with its condition in words has one verdict, by `check`, in LaTeX and in Markdown."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import pytest

from tests.texts.written import ALPHABETS, KINDS, display, model_of, renamed, text_of, verdicts
from workbench import check
from workbench.app.checked import Checked
from workbench.core.verdict import Outcome, Verdict

#: A condition; a formula that is true under it, one that is false even under it, and one that is true anyway.
CONDITIONS = [
    (r"<a> \cdot <b> = 0", r"(<a> + <b>)^2 = <a>^2 + <b>^2", r"(<a> + <b>)^2 = 2 <a>^2 + <b>^2"),
    (
        r"<f> = <g>",
        r"<f>^2 <h> - <g>^2 <h> = <f> <h> - <g> <h>",
        r"<f>^2 <h> - <g>^2 <h> = <f> <h> - <g> <h> + <f> <g>",
    ),
    (r"<f> = <g>^2", r"<f> <h> = <g>^2 <h>", r"<f> <h> = <g>^3 <h>"),
    (
        r"<f> = 0",
        r"<f> <g> <h> + <f>^2 = <f> (<g> + <h>)",
        r"<f> <g> <h> + <h>^2 = <f> (<g> + <h>) + <g> <h>",
    ),
]
TRUE = r"<f> (<a> \times <b>) = -<f> <b> \times <a>"
WORDS = (
    "where|with|given|given that|provided that|if|when|for|assuming|since|because|as|using|suppose|assume|let"
)
PLACES = {
    "after": r"%s \quad \text{%s } %s",
    "behind a comma": r"%s, \quad \text{%s } %s",
    "in a row of its own": r"%s \\ \text{%s } %s",
    "in words in a row of its own": r"%s \\ \text{%s $%s$}",
    "in parentheses": r"%s \quad \text{(%s } %s\text{)}",
    "in parentheses across the words": r"%s \quad \text{(%s } %s)",
    "in parentheses in words": r"%s \quad \text{(%s $%s$)}",
}
BEFORE = {"with a colon": r"\text{%s } %s: \quad %s", "with a comma": r"\text{%s } %s, \quad %s"}


def by_each_door(latex: str, folder: Path, letters: dict[str, str]) -> list[list[Verdict]]:
    """Returns the verdicts by `check`, in a LaTeX text and in a Markdown text."""
    symbols = {letters[mark]: kind for mark, kind in KINDS.items()}
    checked = check(latex, symbols=symbols)
    checked = (checked,) if isinstance(checked, Checked) else checked
    found = [[each.verdict for each in checked]]
    for form in ("tex", "md"):
        text = text_of([display(latex, form)], form)
        found.append(verdicts(folder, text, model_of(letters, form), form))
    return found


def is_said(verdict: Verdict) -> bool:
    """True for "where f = g", which is a formula of its own in a text, and says what f is."""
    return verdict.outcome is Outcome.DEFINITION


DEFINED = {
    r"\dot{<f>} = 2 <g> \dot{<g>} \quad \text{where } <f> = <g>^2": Outcome.PROVED,
    r"\dot{<f>} = 3 <g> \dot{<g>}, \quad \text{with } <f> = <g>^2": Outcome.REFUTED,
    r"<f> <h> = <g>^2 <x>, \quad \text{where } <f> = <g>^2, \; <h> = <x>": Outcome.PROVED,
    r"<f> <h> = <g>^2 <x>, \quad \text{where } <f> = <g>^2 \text{ and } <h> = <x>": Outcome.PROVED,
    r"<f> <h> = <g>^2 <x>, \quad \text{where } <f> = <g>^2 \text{ and } <h> = 2 <x>": Outcome.REFUTED,
    r"\text{let } <f> = <g>^2, \quad <h> = <x>: \quad <f> <h> = <g>^2 <x>": Outcome.PROVED,
}


@pytest.mark.parametrize("latex", DEFINED)
def test_definition_by_words_counts_alike_by_each_door(tmp_path: Path, latex: str) -> None:
    for letters in ALPHABETS[:2]:
        for found in by_each_door(renamed(latex, letters), tmp_path, letters):
            assert [each.outcome for each in found if not is_said(each)] == [DEFINED[latex]]


@pytest.mark.parametrize("words", WORDS.split("|"))
@pytest.mark.parametrize("place", ["after", "behind a comma"])
def test_formula_is_not_proved_by_itself_beside_it(tmp_path: Path, words: str, place: str) -> None:
    letters = ALPHABETS[len(words) % 2]
    for formula in (r"<f> = <g>^2", r"<f> <h> = <g>"):
        latex = renamed(PLACES[place] % (formula, words, formula), letters)
        for found in by_each_door(latex, tmp_path, letters):
            assert all(each.outcome in (Outcome.UNCHECKED, Outcome.DEFINITION) for each in found), latex


@pytest.mark.parametrize("place", [*PLACES, *BEFORE])
@pytest.mark.parametrize(
    ("condition", "under", "never"), CONDITIONS, ids=[condition for condition, _, _ in CONDITIONS]
)
def test_condition_counts_alike_by_each_door(
    tmp_path: Path, place: str, condition: str, under: str, never: str
) -> None:
    wanted = {under: Outcome.PROVED, never: Outcome.REFUTED, TRUE: Outcome.PROVED}
    words_here = WORDS.split("|")[CONDITIONS.index((condition, under, never)) :: 2]
    for words, formula in product(words_here, wanted):
        letters = ALPHABETS[len(words) % 2]
        parts = (formula, words, condition) if place in PLACES else (words, condition, formula)
        latex = renamed((PLACES | BEFORE)[place] % parts, letters)
        found = by_each_door(latex, tmp_path, letters)
        judged = [[each.outcome for each in verdicts if not is_said(each)] for verdicts in found]
        assert judged == [[wanted[formula]]] * 3, latex


@pytest.mark.parametrize(("condition", "under", "never"), CONDITIONS)
def test_reason_of_a_later_step_counts_for_no_earlier_one(
    tmp_path: Path, condition: str, under: str, never: str
) -> None:
    left, right = under.split(" = ")
    letters = ALPHABETS[0]
    latex = renamed(
        rf"\begin{{aligned}} {left} &= {right} \\ &= {right} + 0 \quad \text{{(since }} {condition}) \end{{aligned}}",
        letters,
    )
    for found in by_each_door(latex, tmp_path, letters):
        first, later = found
        assert first.outcome in (Outcome.REFUTED, Outcome.DEFINITION) and later.outcome is Outcome.PROVED


SENTENCES = [
    *(
        f"{words} ${{}}$. Then"
        for words in ("Suppose", "Suppose that", "Assume", "Let", "We assume", "Now let")
    ),
    *(f"{words} ${{}}$. We have" for words in ("Suppose", "Let", "We now assume that")),
    *(f"{words} ${{}}$, we have" for words in ("If", "When", "With", "Given", "Since", "Because", "For")),
]


@pytest.mark.parametrize("form", ["tex", "md"])
@pytest.mark.parametrize("sentence", SENTENCES)
def test_sentence_states_the_condition_of_its_display_only(tmp_path: Path, form: str, sentence: str) -> None:
    letters = ALPHABETS[len(sentence) % 3]
    for condition, under, never in CONDITIONS[:2]:  # f = 0 in a sentence is said of the whole section
        said = renamed(sentence.format(condition), letters)
        shown = [f"{display(renamed(each, letters), form)}" for each in (under, never, under)]
        texts = [f"{said}\n{shown[0]}\n\nIn general,\n{shown[2]}", f"{said}\n{shown[1]}"]
        (holds, again), (fails,) = (
            verdicts(tmp_path, text_of([text], form), model_of(letters, form), form) for text in texts
        )
        assert (holds.outcome, again.outcome) == (Outcome.CONDITIONAL, Outcome.REFUTED), said
        assert str(holds.hypothesis or "").replace(" ", "") == renamed(condition, letters).replace(" ", "")
        assert fails.outcome is Outcome.REFUTED, said
