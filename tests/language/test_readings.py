"""`readings/`, line by line: what stands before ⟶ is read as what stands behind it, and what is printed is read the same."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.language.reading_tables import VARIABLES, said, tables
from workbench.core.construct import rebuild
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read_term

ARROW = "  ⟶  "
PLACE = Path(__file__).parent / "readings"


def sections() -> Iterator[tuple[str, str, str, dict[str, str]]]:
    """File, sort, table and lines of each section, which begins with a line [sort, table]."""
    for path in sorted(PLACE.glob("*.txt")):
        head, lines = "", {}
        for line in [*path.read_text(encoding="utf-8").splitlines(), "[end, end]"]:
            if line.startswith("[") and ARROW not in line:
                if lines:
                    sort, table = head.strip("[]").split(", ")
                    yield path.stem, sort, table, lines
                head, lines = line, {}
            elif ARROW in line:
                text, expected = line.split(ARROW)
                assert text not in lines, f"{path.name} has {text} twice"
                lines[text] = expected


SECTIONS = list(sections())


@pytest.mark.parametrize(
    ("name", "sort", "table", "lines"), SECTIONS, ids=lambda value: value if isinstance(value, str) else ""
)
def test_each_line_is_read_as_it_says(name: str, sort: str, table: str, lines: dict[str, str]) -> None:
    assert {text: said(sort, table, text) for text in lines} == lines


TABLES = sorted({table for _, sort, table, _ in SECTIONS if sort == "term"})


@pytest.mark.parametrize("table", [t for t in TABLES if t not in ("frames without a dot", "columns")])
def test_printed_terms_read_back_as_the_same_well_typed_term(table: str) -> None:
    """∇ is printed as the ∂ that it is, and a gradient as a row: both are read where the paper says so."""
    known = tables()[table]
    for _, sort, own, lines in SECTIONS:
        for latex, expected in lines.items() if (sort, own) == ("term", table) else ():
            if not expected.startswith(("refused", "misfit")) and "nabla" not in latex:
                term = read_term(latex, known, VARIABLES)
                assert read_term(to_latex(term), known, VARIABLES) == term, latex
                assert all(rebuild(part, part.children) == part for part in term.walk()), latex
