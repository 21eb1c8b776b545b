"""Formulas whose verdict was wrong once, or that made the judge stop: the verdicts of `*.txt` are those of today."""

from __future__ import annotations

from pathlib import Path

from tests.verdict_rows import Section, parametrized, said_of


@parametrized(Path(__file__).parent)
def test_verdicts_are_those_of_the_table(section: Section) -> None:
    assert section.told(said_of) == section.expected()
