"""A text that states two laws of one symbol is told so, and the second one proves nothing."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import ALPHABETS, display, doubts, model_of, renamed, text_of, verdicts
from workbench.core.verdict import Grade, Outcome, Verdict

#: The first law, and a second one that contradicts it.
CONTRADICTIONS = [
    ("<f> = <g> <h>", "<f> = <g> + <h>"),
    ("<f> := <g> <h>", "<f> := <g> - <h>"),
    ("<f> = <g>^2", "<g>^3 = <f>"),
    (r"\dot{<f>} = <g>", r"\dot{<f>} = 2 <g>"),
    (r"\dot{<f>} = <g> <h>", r"<g> + <h> = \dot{<f>}"),
    (r"\ddot{<f>} = -<g> <f>", r"\ddot{<f>} = <g> <f>"),
    (r"\dot{<f>} = 0", r"\dot{<f>} = 1"),
]
#: A second formula that follows from the first one, or says what another symbol is.
OTHERS = [
    ("<f> = <g> <h>", "<f> = <h> <g>"),
    ("<f> = <g>", "<f> = <h>"),
    (r"\dot{<f>} = <g>", r"\dot{<f>} = <h>"),
    (r"\dot{<f>} = <g> <h>", r"\dot{<f>} = <h> <g>"),
    (r"<f> = <m> <g>", r"\dot{<f>} = 0"),
    (r"\dot{<f>} = 0", r"\dot{<f>} = <g>"),
]


def judged(folder: Path, formulas: list[str], letters: dict[str, str]) -> list[Verdict]:
    parts = [f"We use\n{display(renamed(each, letters), 'tex')}" for each in formulas]
    return verdicts(folder, text_of(parts, "tex"), model_of(letters, "tex"), "tex")


@pytest.mark.parametrize(("first", "second"), CONTRADICTIONS)
def test_second_law_is_refuted_and_names_the_first(tmp_path: Path, first: str, second: str) -> None:
    """A warning: the second may be of another case, as in two examples of one section."""
    for letters in ALPHABETS[:2]:
        law, other = judged(tmp_path, [first, second], letters)
        assert law.outcome is Outcome.DEFINITION
        assert other.outcome is Outcome.REFUTED and other.grade is Grade.WARNING
        assert "(1)" in doubts(other)


def test_false_consequence_of_a_definition_is_an_error(tmp_path: Path) -> None:
    law, other = judged(tmp_path, [r"<a> \cdot <b> = <f>", r"<a> \cdot <b> = 2 <f>"], ALPHABETS[0])
    assert law.outcome is Outcome.DEFINITION
    assert other.grade is Grade.ERROR and "(1)" in doubts(other)


@pytest.mark.parametrize(("first", "second"), OTHERS)
def test_second_formula_that_may_hold_is_not_refuted(tmp_path: Path, first: str, second: str) -> None:
    law, other = judged(tmp_path, [first, second], ALPHABETS[0])
    assert law.outcome is Outcome.DEFINITION
    assert other.outcome in (Outcome.DEFINITION, Outcome.CONDITIONAL, Outcome.PROVED)


@pytest.mark.parametrize(
    ("law", "false", "claim"),
    [
        (r"<f> = <x>^2", r"\dot{<f>} = 3 <x> \dot{<x>}", r"\dot{<f>} = 5 <x> \dot{<x>}"),
        (r"<f> = <m> <x>^2", r"\dot{<f>} = 3 <m> <x> \dot{<x>}", r"\dot{<f>} = 5 <m> <x> \dot{<x>}"),
        (r"\dot{<f>} = <g> <x>", r"\dot{<f>} = 2 <g> <x>", r"\dot{<f>} = 3 <g> <x>"),
        (r"<f> = <g> <h>", r"<f> = <g> + <h>", r"<g> <h> = <g> + <h>"),
    ],
)
def test_false_second_law_proves_no_other(tmp_path: Path, law: str, false: str, claim: str) -> None:
    for letters in ALPHABETS[:2]:
        found = judged(tmp_path, [law, false, claim], letters)
        assert [each.outcome for each in found[1:]] == [Outcome.REFUTED] * 2
