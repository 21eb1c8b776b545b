"""Each formula of the formulary is right: it is proved, and with the sign of one addend changed it is not."""

from __future__ import annotations

import re
import tomllib
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

import workbench
from workbench.app.checked import Checked
from workbench.context.free_symbols import free_in, terms_of
from workbench.core.verdict import Outcome
from workbench.language.definitions import Definitions

FOLDER = Path(workbench.__file__).parent / "papers" / "drafting" / "formulary"
KEYS = {"name", "words", "source", "symbols", "formula", "given", "definition"}
Entry = dict[str, Any]
ENTRIES: list[tuple[str, Entry]] = [
    (f"{path.stem}-{number}", entry)
    for path in sorted(FOLDER.glob("*.toml"))
    for number, entry in enumerate(tomllib.loads(path.read_text("utf-8"))["formula"], start=1)
]
PROVED = [(where, entry) for where, entry in ENTRIES if "definition" not in entry]
DEFINED = [(where, entry) for where, entry in ENTRIES if "definition" in entry]


def checked(entry: Entry, formula: str) -> Checked:
    result = workbench.check(formula, symbols=entry["symbols"], assume=entry.get("given", []))
    assert isinstance(result, Checked)
    return result


def with_one_sign_changed(formula: str) -> str:
    """Returns the formula with another sign of the first addend on the right side; on the left, if 0 is there."""
    left, _, right = formula.rpartition(" = ")
    changed = [side[1:] if side.startswith("-") else f"-{side}" for side in (left, right)]
    return f"{changed[0]} = 0" if right == "0" else f"{left} = {changed[1]}"


@pytest.mark.parametrize(("where", "entry"), PROVED, ids=[where for where, _ in PROVED])
def test_a_formula_is_proved_and_a_changed_one_not(where: str, entry: Entry) -> None:
    right = checked(entry, entry["formula"])
    assert right.outcome is Outcome.PROVED, right
    wrong = checked(entry, with_one_sign_changed(entry["formula"]))
    assert wrong.outcome in (Outcome.REFUTED, Outcome.UNCHECKED), wrong
    assert_each_symbol_is_used(right, entry)


@pytest.mark.parametrize(("where", "entry"), DEFINED, ids=[where for where, _ in DEFINED])
def test_a_definition_is_well_formed(where: str, entry: Entry) -> None:
    read = checked(entry, entry["formula"])
    assert entry["definition"] is True and "given" not in entry
    assert read.outcome in (Outcome.REFUTED, Outcome.UNCHECKED), f"give its proof: {read}"
    assert_each_symbol_is_used(read, entry)


def assert_each_symbol_is_used(read: Checked, entry: Entry) -> None:
    claim = read.result.claim
    terms = [
        t
        for formula in (claim.printed, *claim.assume)
        if formula.statement
        for t in terms_of(formula.statement)
    ]
    used = {str(declaration.name) for declaration in free_in(terms, Definitions([]))}
    assert len(used - {"t"}) == len(entry["symbols"]), used


def test_each_entry_has_all_keys_and_words_that_compile() -> None:
    for where, entry in ENTRIES:
        assert entry.keys() <= KEYS and KEYS - {"given", "definition"} <= entry.keys(), where
        assert "given" in entry or "definition" in entry, where
        assert re.compile(entry["words"], re.IGNORECASE).search("") is None, where
        assert all(
            entry[key] == entry[key].strip() != "" for key in ("name", "words", "source", "formula")
        ), where


def test_no_formula_stands_twice_under_the_same_kinds() -> None:
    counted = Counter((entry["formula"], str(entry["symbols"])) for _, entry in ENTRIES)
    assert [formula for (formula, _), count in counted.items() if count > 1] == []
