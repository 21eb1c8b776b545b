"""The verdicts on goals and their proofs are those of `rows/*.txt`."""

from __future__ import annotations

from pathlib import Path

from tests.judge.goals.goal_rows import said_of_goal
from tests.verdict_rows import Section, parametrized


@parametrized(Path(__file__).parent / "rows")
def test_verdicts_on_goals_are_those_of_the_table(section: Section) -> None:
    assert section.told(said_of_goal) == section.expected()
