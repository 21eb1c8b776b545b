"""No verdict changes without a line of the ledger, and a commit that says why."""

import re

import pytest
from ledger.verdict_ledger import SECTIONS, TESTS, chapter_results, frozen, lines_of

from workbench.report.document import document_of


@pytest.mark.parametrize("section", SECTIONS)
def test_verdicts_are_those_of_the_ledger(section: str) -> None:
    now, before = set(lines_of(SECTIONS[section]())), set(frozen(section))
    gone, new = sorted(before - now), sorted(now - before)
    difference = "\n".join([*(f"- {line}" for line in gone), *(f"+ {line}" for line in new)])
    assert not difference, f"verdicts changed; see tests/ledger/verdict_ledger.py:\n{difference}"


def test_readme_counts_the_equations_of_the_report() -> None:
    document = document_of(*chapter_results())
    counts = {each.kind.name: each.count for each in document.classes}
    readme = (TESTS.parent / "README.md").read_text(encoding="utf-8")
    told = re.search(
        r"(\d+) of (\d+) equations of the chapter are wrong, (\d+) misprinted, (\d+) hold as printed; "
        r"our copy probably lost marks in (\d+) others",
        readme,
    )
    kinds = ("error", "misprint", "holds", "transcription")
    error, misprint, holds, transcription = (counts[kind] for kind in kinds)
    assert told is not None and tuple(map(int, told.groups())) == (
        error,
        sum(counts.values()),
        misprint,
        holds,
        transcription,
    )
