"""Corrections of formulas in rows: an edit keeps rows and columns, and no bracket is closed in another cell."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from workbench.app.pipeline.judged_files import judged_file, with_corrections
from workbench.core.verdict import Grade
from workbench.source.documents.source_edits import applied

HEAD = "".join(f"%! workbench: symbols.'{name}' = \"scalar\"\n" for name in "abcd")
CELL = re.compile(r"&|\\\\|\\begin\{align\}|\\end\{align\}")
ROWS = {
    "factor at the end of a row": r"(a+b)^2 &= a^2 + b^2 + ab \\ &= a^2+b^2+2ab",
    "the second row is false": r"(a+b)^2 &= a^2 + 2ab + b^2 \\ &= a^2 + ab + b^2",
    "ampersand behind the sign": r"(a-b)^2 =& a^2 + b^2 - ab \\ =& a^2+b^2-2ab",
    "a term goes on in the next row": r"(a+b)(c+d) &= a c + a d \\ &\quad - b c + b d",
    "a sign at the end of a row": r"(a+b)(c+d) = & a c + a d - \\ & b c + b d",
    "three rows": r"(a+b)^2 - c &= a^2 + 2ab + b^2 - c \\ &= a(a+b) + b(a+b) - c \\ &= a^2 + ab + b^2 - c",
}


def corrected(text: str, folder: Path) -> list[tuple[str, bool]]:
    """The text with each of its corrections made, and whether that leaves fewer errors."""
    path = folder / "p.tex"
    path.write_text(text)
    judged = with_corrections(judged_file(path))
    before = sum(result.shown is Grade.ERROR for result in judged.results)
    made = []
    for result in judged.results:
        if result.edits:
            after = applied(result.edits[0].source.text, result.edits)
            path.write_text(after)
            errors = sum(each.shown is Grade.ERROR for each in judged_file(path).results)
            made.append((after, errors <= before))
    return made


@pytest.mark.parametrize("rows", ROWS.values(), ids=ROWS)
def test_an_edit_keeps_rows_columns_and_brackets(rows: str, tmp_path: Path) -> None:
    text = f"{HEAD}\\begin{{align}}\n{rows}\n\\end{{align}}\n"
    found = corrected(text, tmp_path)
    assert found, "there is a correction"
    for after, helps in found:
        assert helps and CELL.findall(after) == CELL.findall(text), after
        for cell in CELL.split(after):
            for left, right in ((r"\\left(?![A-Za-z])", r"\\right(?![A-Za-z])"), (r"\(", r"\)"), ("{", "}")):
                assert len(re.findall(left, cell)) == len(re.findall(right, cell)), after
