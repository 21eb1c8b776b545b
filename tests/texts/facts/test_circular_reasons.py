"""A formula does not follow from itself: a condition that states it anew is told, and proves nothing."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.facts.test_conditions_by_words import BEFORE, PLACES, WORDS, by_each_door
from tests.texts.written import ALPHABETS, renamed
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.verdict import Outcome, Verdict

#: Both sides of a formula that is false in general, and a different condition that is equivalent to it.
CLAIMS = [
    (r"<a> \times <b>", r"<b> \times <a>", r"<a> \times <b> = 0"),
    (r"(<a> + <b>)^2", r"<a>^2 + <b>^2", r"<a> \cdot <b> = 0"),
    (r"<f> <g> + <h>^2", r"<g> <h> + <f>^2", r"<f> (<g> - <f>) = <h> (<g> - <h>)"),
    (r"<f> (<g> + <h>)", r"<g> <h> + <f>^2", r"<f> <g> = <g> <h> + <f> (<f> - <h>)"),
]
FORMS = ["{0} = {1}", "{1} = {0}", "{0} - ({1}) = 0", "0 = {1} - ({0})", "-({1}) = -({0})"]
TRUE = (r"<a> \cdot <b>", r"<b> \cdot <a>")
MARKS = [words for words in WORDS.split("|") if words != "let"]


def _told(verdict: Verdict) -> tuple[Outcome, object]:
    return verdict.outcome, verdict.code


@pytest.mark.parametrize("place", [*PLACES, *BEFORE])
@pytest.mark.parametrize("claim", CLAIMS, ids=[left for left, _, _ in CLAIMS])
def test_formula_needs_an_equivalent_condition_not_itself(
    tmp_path: Path, place: str, claim: tuple[str, str, str]
) -> None:
    left, right, other = claim
    at = [*PLACES, *BEFORE].index(place) + CLAIMS.index(claim)
    for number, form in enumerate(FORMS):
        words, letters = MARKS[(at + 3 * number) % len(MARKS)], ALPHABETS[(at + number) % len(ALPHABETS)]
        for condition, is_circular in ((form.format(left, right), True), (other, False)):
            stated = f"{left} = {right}"
            parts = (stated, words, condition) if place in PLACES else (words, condition, stated)
            latex = renamed((PLACES | BEFORE)[place] % parts, letters)
            wanted = [
                (Outcome.UNCHECKED, VerdictCode.CONDITION_IS_THE_CLAIM)
                if is_circular
                else (Outcome.PROVED, None)
            ]
            if not is_circular and words in ("where", "with"):
                continue  # tests/texts/facts/test_conditions_by_words.py
            found = by_each_door(latex, tmp_path, letters)
            assert [[*map(_told, verdicts)] for verdicts in found] == [wanted] * 3, latex


@pytest.mark.parametrize("words", MARKS)
@pytest.mark.parametrize("form", FORMS)
def test_true_formula_stays_proved_beside_itself(tmp_path: Path, words: str, form: str) -> None:
    latex = rf"{TRUE[0]} = {TRUE[1]} \quad \text{{{words} }} {form.format(*TRUE)}"
    found = by_each_door(renamed(latex, ALPHABETS[0]), tmp_path, ALPHABETS[0])
    assert [[verdict.outcome for verdict in each] for each in found] == [[Outcome.PROVED]] * 3


@pytest.mark.parametrize("sign", [r"\Rightarrow", r"\implies"])
def test_implication_of_itself_is_a_law(tmp_path: Path, sign: str) -> None:
    latex = renamed(rf"<f> = <g> {sign} <g> = <f>", ALPHABETS[0])
    found = by_each_door(latex, tmp_path, ALPHABETS[0])
    assert [[verdict.outcome for verdict in each] for each in found] == [[Outcome.PROVED]] * 3


@pytest.mark.parametrize(
    ("claim", "condition"),
    [
        (r"<f> <g> + <h>^2 = <g> <h> + <f>^2", r"<f>^2 + <h> <g> = <h>^2 + <g> <f>"),
        (
            r"<f> (<a> \cdot <b>) + <g> <a>^2 = <f> <b>^2 + <g> (<a> \cdot <b>)",
            r"<f> (<b> \cdot <a>) + <g> <a>^2 = (<b> \cdot <a>) <g> + <f> <b>^2",
        ),
    ],
)
def test_order_of_factors_makes_no_other_condition(tmp_path: Path, claim: str, condition: str) -> None:
    latex = renamed(rf"{claim} \quad \text{{since }} {condition}", ALPHABETS[2])
    for found in by_each_door(latex, tmp_path, ALPHABETS[2]):
        assert [*map(_told, found)] == [(Outcome.UNCHECKED, VerdictCode.CONDITION_IS_THE_CLAIM)]
