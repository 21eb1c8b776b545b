"""The catalogue of messages: each example of a code gives that code; each code has a meaning and a way out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.guide.message_examples import EXAMPLES, told_codes
from workbench.core.reasons import Code
from workbench.guide.message_page import all_codes, entries, meaning_of, message_page

#: The codes without an example, and why.
WITHOUT_EXAMPLE = {
    "DEFECT": "a defect of the workbench",
    "ENGINES-DISAGREE": "a defect of the workbench",
    "WITHOUT-EVIDENCE": "a defect of the workbench",
    "ERROR": "an error without a code of its own",
    "REFUSED": "an error without a code of its own",
    "LAW-NOT-COMPARED": "a limit on time or depth, which depends on the machine",
    "NESTS-TOO-DEEP": "a limit on time or depth, which depends on the machine",
    "NOTATION-LEADS-BACK-ITSELF": "a limit on time or depth, which depends on the machine",
    "NO-LETTER-LEFT": "needs as many sums in one another as there are letters",
    "INDEX-COUNT": "told to the writer of certificates only",
    "ARGUMENT-COUNT": "the grammar counts the arguments before",
    "WORDS": "each claim that is judged has a formula or a goal",
    "NO-BOUND": "a search that failed; no short formula is known for which it fails",
    "NO-WITNESS": "a search that failed; no short formula is known for which it fails",
    "NOT-SHOWN": "a search that failed; no short formula is known for which it fails",
    "SECOND-ENGINE-OPEN": "a search that failed; no short formula is known for which it fails",
    "FITS": "a proposal of a long text",
    "NOT-AS-DRAFTED": "a guess in a long text",
    "OPAQUE-MACROS": "a macro that only TeX expands, in a style file",
    "TWO-READINGS": "rows that may be joined, in a long text",
}
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
    assert sorted(set(all_codes()) - given) == sorted(f"WB-{name}" for name in WITHOUT_EXAMPLE)


def test_no_code_is_an_alias_of_another() -> None:
    tables = {type(code) for code in all_codes().values()}
    assert [name for table in tables for name, code in table.__members__.items() if code.name != name] == []


def test_page_has_every_code() -> None:
    page = message_page()
    assert all(f"### {name}\n" in page for name in all_codes())
