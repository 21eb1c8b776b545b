"""The catalogue of messages: each example of a code gives that code; each code has a meaning and a way out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from workbench import check
from workbench.core.code_labels import label
from workbench.core.reasons import Code, Reason
from workbench.guide.message_page import all_codes, entries, meaning_of, message_page

EXAMPLES = [(name, entry) for name, entry in entries().items() if "example" in entry and name in all_codes()]


def told_codes(entry: dict[str, Any], folder: Path) -> set[str]:
    """The labels of all reasons of the verdicts on the example, or of the error."""
    given: dict[str, Any] = {"symbols": entry.get("symbols", {}), "definitions": entry.get("definitions", {})}
    if "notation" in entry:
        given["notation"] = folder / "notation.toml"
        given["notation"].write_text(entry["notation"], encoding="utf-8")
    try:
        found = check(entry["example"], **given)
    except ValueError as error:
        reasons = [each for each in (*error.args, *vars(error).values()) if isinstance(each, Reason)]
    else:
        verdicts = [each.verdict for each in (found if isinstance(found, tuple) else [found])]
        reasons = [verdict.reason for verdict in verdicts if isinstance(verdict.reason, Reason)]
    return {label(code) for reason in reasons for code in reason.codes}


@pytest.mark.slow
@pytest.mark.parametrize(("name", "entry"), EXAMPLES, ids=[name for name, _ in EXAMPLES])
def test_example_gives_its_code(name: str, entry: dict[str, Any], tmp_path: Path) -> None:
    assert name in told_codes(entry, tmp_path)


@pytest.mark.parametrize("code", all_codes().values(), ids=all_codes())
def test_code_has_meaning_and_way_out(code: Code) -> None:
    said = meaning_of(code)
    assert said.get("meaning", "").endswith((".", "?")) and said.get("way_out", "").endswith((".", "`."))


def test_page_has_every_code() -> None:
    page = message_page()
    assert all(f"### {name}\n" in page for name in all_codes())
