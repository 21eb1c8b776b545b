"""Matrices that the words of a text call Jacobians."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.drafts import judged_draft_of
from workbench.core.verdict import Grade, Outcome
from workbench.prover.results.claim_results import ClaimResult

#: Functions of variables, and their partial derivatives by rows.
FUNCTIONS = [
    (
        (r"x = d\cos\theta\sin\phi", r"y = d\sin\theta\sin\phi", r"z = h + d\cos\phi"),
        (
            (r"-d\sin\theta\sin\phi", r"d\cos\theta\cos\phi", r"\cos\theta\sin\phi"),
            (r"d\cos\theta\sin\phi", r"d\sin\theta\cos\phi", r"\sin\theta\sin\phi"),
            ("0", r"-d\sin\phi", r"\cos\phi"),
        ),
    ),
    (
        (r"x = a\cos\alpha + b\cos\beta", r"y = a\sin\alpha + b\sin\beta"),
        ((r"-a\sin\alpha", r"-b\sin\beta"), (r"a\cos\alpha", r"b\cos\beta")),
    ),
    (
        (r"r = \sqrt{x^2 + y^2}", r"u = x y - z"),
        (("x/r", "y/r", "0"), ("y", "x", "-1")),
    ),
]
ENTRIES = [
    (number, i, j)
    for number, (_, rows) in enumerate(FUNCTIONS)
    for i, row in enumerate(rows)
    for j, entry in enumerate(row)
    if entry != "0"
]


def _judged(functions: tuple[str, ...], rows: list[list[str]], words: str, folder: Path) -> ClaimResult:
    matrix = r" \\ ".join(" & ".join(row) for row in rows)
    given = "\n".join(f"\n$$\n{each}\n$$\n" for each in functions)
    path = folder / "text.md"
    path.write_text(
        f"The point has the coordinates\n{given}\n{words}\n\n$$\nJ = \\begin{{bmatrix}} {matrix} \\end{{bmatrix}}\n$$\n"
    )
    return judged_draft_of(path)[-1]


@pytest.mark.parametrize(("functions", "rows"), FUNCTIONS)
def test_printed_jacobian_holds(
    functions: tuple[str, ...], rows: tuple[tuple[str, ...], ...], tmp_path: Path
) -> None:
    found = _judged(functions, [list(row) for row in rows], "The Jacobian is", tmp_path)
    assert found.verdict.outcome in (Outcome.PROVED, Outcome.CONDITIONAL)


@pytest.mark.parametrize(("number", "i", "j"), ENTRIES)
def test_other_sign_of_an_entry_is_false(number: int, i: int, j: int, tmp_path: Path) -> None:
    functions, rows = FUNCTIONS[number]
    changed = [list(row) for row in rows]
    changed[i][j] = changed[i][j][1:] if changed[i][j].startswith("-") else f"-{changed[i][j]}"
    found = _judged(functions, changed, "The Jacobian is", tmp_path)
    assert (found.verdict.outcome, found.verdict.grade) == (Outcome.REFUTED, Grade.WARNING)


def test_matrix_without_the_word_is_a_definition(tmp_path: Path) -> None:
    functions, rows = FUNCTIONS[0]
    found = _judged(functions, [list(row) for row in rows], "We put", tmp_path)
    assert found.verdict.outcome is Outcome.DEFINITION
