"""The table of spellings: each example has the verdict that the table gives."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench import check, judge, load
from workbench.app.commands.try_formula import judged_formula
from workbench.guide.spelling_page import Spelling, spelling_page, spellings

ROWS = list(spellings())


def outcomes(row: Spelling, folder: Path) -> set[str]:
    """The verdicts on the example: of `check`, or of a text that displays it."""
    if not row.only_in_texts:
        found = check(row.example, symbols=row.symbols)
        return {str(each.outcome) for each in (found if isinstance(found, tuple) else [found])}
    entries = "\n".join(f"'{name}' = \"{kind}\"" for name, kind in row.symbols.items())
    (folder / "text.tex").write_text(f"\\[ {row.example} \\]\n", encoding="utf-8")
    (folder / "text.toml").write_text(f'source = "text.tex"\n[symbols]\n{entries}\n', encoding="utf-8")
    return {str(result.verdict.outcome) for result in judge(load(folder / "text.toml"), motions=False)}


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row.written)
def test_spelling_is_read_as_the_table_says(row: Spelling, tmp_path: Path) -> None:
    assert outcomes(row, tmp_path) == {row.outcome}


BY_KIND = [row for row in ROWS if all(isinstance(kind, str) for kind in row.symbols.values())]


@pytest.mark.parametrize("row", BY_KIND, ids=lambda row: row.written)
def test_spelling_is_read_by_the_command_try(row: Spelling) -> None:
    """`try` reads one formula as a text would."""
    found, _ = judged_formula(row.example, row.symbols, ())
    assert {str(each.outcome) for each in found} == {row.outcome}


def test_page_has_every_spelling() -> None:
    page = spelling_page()
    assert all(f"`{row.example.replace('|', chr(92) + '|')}`" in page for row in ROWS)
