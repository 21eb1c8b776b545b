"""An equation beside a formula, without a word, is its condition only where the formula is false without it."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.facts.test_conditions_by_words import CONDITIONS, TRUE, by_each_door
from tests.texts.written import ALPHABETS, renamed
from workbench.core.verdict import Outcome

GAPS = [r"%s \quad %s", r"%s, \quad %s", r"%s \qquad %s", r"%s, \; \; \quad %s"]


@pytest.mark.parametrize("gap", GAPS)
@pytest.mark.parametrize(
    ("condition", "under", "never"), CONDITIONS, ids=[condition for condition, _, _ in CONDITIONS]
)
def test_formula_is_conditional_on_its_neighbour_by_each_door(
    tmp_path: Path, gap: str, condition: str, under: str, never: str
) -> None:
    letters = ALPHABETS[(len(gap) + len(condition)) % 3]
    for formula, wanted in ((under, {Outcome.CONDITIONAL}), (never, {Outcome.REFUTED})):
        latex = renamed(gap % (formula, condition), letters)
        found = by_each_door(latex, tmp_path, letters)
        assert [verdicts[0].outcome in wanted for verdicts in found] == [True] * 3, latex
    for found in by_each_door(renamed(gap % (under, condition), letters), tmp_path, letters):
        assert str(found[0].hypothesis or "").replace(" ", "") == renamed(condition, letters).replace(" ", "")


@pytest.mark.parametrize("gap", GAPS)
def test_what_stands_beside_a_true_formula_is_no_condition(tmp_path: Path, gap: str) -> None:
    letters = ALPHABETS[0]
    false = r"<f> <g> + <h>^2 = <g> <h> + <f>^2"
    checked, *texts = by_each_door(renamed(gap % (TRUE, false), letters), tmp_path, letters)
    assert [each.outcome for each in checked] == [Outcome.REFUTED]
    assert [[each.outcome for each in verdicts] for verdicts in texts] == [
        [Outcome.PROVED, Outcome.REFUTED]
    ] * 2


@pytest.mark.parametrize("gap", GAPS)
@pytest.mark.parametrize(
    "mirrored", [r"<b> \times <a> = <a> \times <b>", r"<a> \times <b> - <b> \times <a> = 0"]
)
def test_formula_beside_itself_is_no_condition(tmp_path: Path, gap: str, mirrored: str) -> None:
    letters = ALPHABETS[1]
    latex = renamed(gap % (r"<a> \times <b> = <b> \times <a>", mirrored), letters)
    for found in by_each_door(latex, tmp_path, letters):
        assert {each.outcome for each in found} == {Outcome.REFUTED}
