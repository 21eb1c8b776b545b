"""The verdicts on formulas of each subject are those of `verdicts/*.txt`."""

from __future__ import annotations

from pathlib import Path

from tests.verdict_rows import Section, parametrized, said_of


@parametrized(Path(__file__).parent / "verdicts")
def test_verdicts_are_those_of_the_table(section: Section) -> None:
    assert section.told(said_of) == section.expected()
