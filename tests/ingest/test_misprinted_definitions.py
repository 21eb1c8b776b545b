"""Definitions whose misprint makes another formula of a text false."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.drafts import judged_draft_of
from workbench.core.verdict import Grade, Outcome

#: Definitions, and formulas that hold under the right ones.
SQUARES = (["u = x^2 + y^2", "v = 2 x y", "w = x^2 - y^2"], ["u^2 = v^2 + w^2"])
FACTORS = (["p = a + b", "q = a - b"], ["p q = a^2 - b^2", "p^2 - q^2 = 4 a b"])
MISPRINTS = [
    (SQUARES, 2, "w = x^2 - y"),
    (SQUARES, 0, "u = x^2 + y^3"),
    (FACTORS, 0, "p = a + 2 b"),
]


def _warned(formulas: list[str], folder: Path) -> list[str]:
    given = "\n\n".join(f"$$\n{each}\n$$" for each in formulas)
    path = folder / "text.md"
    path.write_text(f"We put the numbers\n\n{given}\n")
    results = judged_draft_of(path)
    return [each.claim.printed.latex for each in results if each.verdict.grade is Grade.WARNING]


@pytest.mark.parametrize(("page", "place", "misprint"), MISPRINTS)
def test_misprinted_definition_is_warned(
    page: tuple[list[str], list[str]], place: int, misprint: str, tmp_path: Path
) -> None:
    given, others = page
    assert _warned([*given[:place], misprint, *given[place + 1 :], *others], tmp_path) == [misprint]


def test_second_misprint_hides_no_definition(tmp_path: Path) -> None:
    given, others = FACTORS
    other = "p^2 + q^2 = 3 a^2 + 7 b^3"
    assert _warned(["p = a + 2 b", given[1], others[0], other], tmp_path) == ["p = a + 2 b", other]


@pytest.mark.parametrize("page", [SQUARES, FACTORS])
def test_right_definitions_prove_the_formulas(page: tuple[list[str], list[str]], tmp_path: Path) -> None:
    given, others = page
    assert _warned([*given, *others], tmp_path) == []
    results = judged_draft_of(tmp_path / "text.md")
    assert {each.verdict.outcome for each in results[-len(others) :]} == {Outcome.PROVED}
