"""Each formula of the formulary is right: it is proved, and with the sign of one addend changed it is not."""

from __future__ import annotations

import re
import tomllib
from collections import Counter
from pathlib import Path

import pytest

import workbench
from workbench.app.checked import Checked
from workbench.core.verdict import Outcome
from workbench.papers.drafting.formulary.standard_formulas import (
    Entry,
    StandardFormula,
    profile_of,
    standard_formulas,
)

FOLDER = Path(workbench.__file__).parent / "papers" / "drafting" / "formulary" / "formulas"
KEYS = {"name", "words", "source", "symbols", "form"}
FORMULAS = standard_formulas()
BY_ENTRY: dict[Entry, list[StandardFormula]] = {}
for each in FORMULAS:
    if not each.definition:
        BY_ENTRY.setdefault(each.entry, []).append(each)


def checked(own: StandardFormula, formula: str) -> Checked:
    result = workbench.check(formula, symbols=own.symbols, assume=own.given)
    assert isinstance(result, Checked)
    return result


def with_one_sign_changed(formula: str) -> str:
    """Returns the formula with another sign of the first addend on the right side."""
    left, _, right = formula.rpartition(" = ")
    return f"{left} = {right[1:] if right.startswith('-') else f'-{right}'}"


@pytest.mark.parametrize("forms", BY_ENTRY.values(), ids=[each.name for each in BY_ENTRY])
def test_formula_is_proved_and_changed_one_not(forms: list[StandardFormula]) -> None:
    for own in forms:
        right = checked(own, own.formula)
        assert right.outcome is Outcome.PROVED, right
        if not own.formula.endswith(" = 0"):  # which may be one addend
            wrong = checked(own, with_one_sign_changed(own.formula))
            assert wrong.outcome in (Outcome.REFUTED, Outcome.UNCHECKED), wrong


def test_definition_is_read_and_has_no_premises() -> None:
    for own in (each for each in FORMULAS if each.definition):
        assert own.statement.operator == "=" and not own.given


def test_profile_read_from_latex_is_that_of_the_terms() -> None:
    for own in FORMULAS:
        is_product = own.formula.startswith(("\\begin", "p q", "(p q)"))  # in which symbols vanish
        if own.sum.monomials and "\\pm" not in own.formula and not is_product:
            assert own.profile.may_be(profile_of(own.sum)), own.formula


def test_each_entry_has_all_keys_and_words_that_compile() -> None:
    for path in FOLDER.glob("*.toml"):
        for entry in tomllib.loads(path.read_text("utf-8"))["formula"]:
            assert entry.keys() == KEYS, entry
            assert all(form.keys() - {"formula"} in ({"given"}, {"definition"}) for form in entry["form"]), (
                entry
            )
            assert re.compile(entry["words"]).search("") is None, entry
            said = "".join(
                each for form in entry["form"] for each in (form["formula"], *form.get("given", ()))
            )
            plain = re.sub(r"\\d*dot\{([^{}]*)\}", r"\1", said)
            assert [name for name in entry["symbols"] if spelled(name) not in spelled(plain)] == [], entry[
                "name"
            ]


def spelled(latex: str) -> str:
    return re.sub(r"[{} ]", "", latex)


def test_no_formula_stands_twice_under_the_same_kinds() -> None:
    counted = Counter((each.formula, str(each.symbols)) for each in FORMULAS)
    assert [formula for (formula, _), count in counted.items() if count > 1] == []
