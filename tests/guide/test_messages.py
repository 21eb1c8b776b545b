"""The catalogue of messages: each example of a code gives that code; each code has a meaning and a way out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.guide.message_examples import EXAMPLES, told_codes
from workbench.core.reasons import Code
from workbench.guide.message_page import all_codes, entries, meaning_of, message_page

#: The codes without an example: of proofs of goals, of defects, and of what no short input was found for.
WITHOUT_EXAMPLE = """
ARGUED ARGUMENT-COUNT CONTRADICTORY-PREMISES DEFECT DEFINITION-OF-ANOTHER-TYPE DOES-NOT-COMMUTE
ENGINES-DISAGREE ERROR EXISTENCE EXPECTED-EXPRESSION-NOT-STATEMENT EXPECTED-TO-FAIL FITS FOR-THOUGH-HOLDS
FORMULA-CHARACTERS-UP-READ GOAL-NOT-SHOWN INDEX-COUNT LAW-NOT-COMPARED NESTS-TOO-DEEP NO-ANGLE NO-BOUND
NO-LETTER-LEFT NO-MOTION-HAS NO-WITNESS NONE-EXISTS NOT-AS-DRAFTED NOT-JUDGED NOT-SHOWN
NOTATION-LEADS-BACK-ITSELF OF-FRAMES OF-QUATERNIONS OPAQUE-MACROS REFUSED
SECOND-ENGINE-LEFT-OUT SECOND-ENGINE-OPEN SINGULAR-PART STEP-NOT-SHOWN STEP-NOT-SHOWN-BECAUSE
TENSOR-RATE-IN-FRAME TIED-ON-MOTIONS TWO-OF-THEM TWO-READINGS WITHOUT-EVIDENCE WORDS
"""
GIVEN = [(name, entry) for name, entry in entries().items() if not set(EXAMPLES).isdisjoint(entry)]


@pytest.mark.parametrize(("name", "entry"), GIVEN, ids=[name for name, _ in GIVEN])
def test_example_gives_its_code(name: str, entry: dict[str, Any], tmp_path: Path) -> None:
    assert name in told_codes(entry, tmp_path)


@pytest.mark.parametrize("code", all_codes().values(), ids=all_codes())
def test_code_has_meaning_and_way_out(code: Code) -> None:
    said = meaning_of(code)
    assert said.get("meaning", "").endswith((".", "?")) and said.get("way_out", "").endswith((".", "`."))


def test_each_other_code_has_an_example() -> None:
    given = {name for name, _ in GIVEN}
    assert sorted(set(all_codes()) - given) == [f"WB-{name}" for name in WITHOUT_EXAMPLE.split()]


def test_no_code_is_an_alias_of_another() -> None:
    tables = {type(code) for code in all_codes().values()}
    assert [name for table in tables for name, code in table.__members__.items() if code.name != name] == []


def test_page_has_every_code() -> None:
    page = message_page()
    assert all(f"### {name}\n" in page for name in all_codes())
