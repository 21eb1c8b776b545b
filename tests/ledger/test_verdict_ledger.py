"""No verdict changes without a line of the ledger, and a commit that says why."""

import pytest
from ledger.verdict_ledger import SECTIONS, frozen, lines_of


@pytest.mark.parametrize("section", SECTIONS)
def test_verdicts_are_those_of_the_ledger(section: str) -> None:
    now, before = set(lines_of(SECTIONS[section]())), set(frozen(section))
    gone, new = sorted(before - now), sorted(now - before)
    difference = "\n".join([*(f"- {line}" for line in gone), *(f"+ {line}" for line in new)])
    assert not difference, f"verdicts changed; see tests/ledger/verdict_ledger.py:\n{difference}"
