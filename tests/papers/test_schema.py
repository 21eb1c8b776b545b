"""The schema of keys: every key that it lists is accepted, every other key is refused."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench.core.schema import SCHEMA, choices, flag_names, key_names
from workbench.papers import PaperError, load_paper

PLACES = {
    "paper file": "{key} = 0\n",
    "conventions": "[conventions]\n{key} = 0\n",
    "symbol": "[symbols]\na = {{ {key} = 0 }}\n",
    "notation entry": "[notation]\n'\\hat{{x}}' = {{ {key} = 0 }}\n",
    "frames": "[frames]\nbase = 'N'\n{key} = 0\n",
    "points": "[frames]\nbase = 'N'\n[points]\n{key} = 0\n",
    "budget": "[budget]\n{key} = 0\n",
    "citation": "[citation]\n{key} = 0\n",
    "claim of a paper file": "[[claim]]\n{key} = 0\n",
}
CLAIM = "[[claim]]\nid = '1'\nprinted = '1 = 1'\n"


def refusal(tmp_path: Path, table: str, key: str) -> str:
    """What the loader says of a paper file with the key at the place, its value never usable."""
    text = PLACES[table].format(key=key)
    path = tmp_path / "paper.toml"
    path.write_text(text + CLAIM if "[[claim]]" not in text else text, encoding="utf-8")
    with pytest.raises(PaperError) as caught:
        load_paper(path)
    return "\n".join(str(fault) for fault in caught.value.faults)


@pytest.mark.parametrize("table", PLACES)
def test_unknown_key_is_refused(table: str, tmp_path: Path) -> None:
    assert "zyzzyva" in refusal(tmp_path, table, "zyzzyva")


@pytest.mark.parametrize(
    ("table", "key"),
    [
        (table, key)
        for table in ("paper file", "claim of a paper file", "citation", "budget")
        for key in key_names(table)
    ],
)
def test_listed_key_is_refused_for_its_value_only(table: str, key: str, tmp_path: Path) -> None:
    assert f"unknown key {key!r}" not in refusal(tmp_path, table, key)


def test_keys_of_a_table_are_unique() -> None:
    assert [table for table in SCHEMA if len(set(key_names(table))) < len(key_names(table))] == []


def test_meanings_are_sentences() -> None:
    assert [k.name for keys in SCHEMA.values() for k in keys if not k.meaning.endswith((".", "…"))] == []


def test_choices_and_flags_are_those_of_the_loader() -> None:
    assert choices("conventions")["gradient"] == ("row", "column") and "free" in flag_names()
