"""`spelled_steps.txt`, line by line: what a text writes is read as the steps behind ⟶, in Markdown and in LaTeX."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench.source.documents import read_text
from workbench.source.rows.chains import steps_of

ROWS = (Path(__file__).parent / "spelled_steps.txt").read_text("utf-8").splitlines()[2:]
SHELLS = {"md": "$$ {} $$", "tex": "\\begin{{document}}\n\\[{}\\]\n\\end{{document}}"}


@pytest.mark.parametrize("form", SHELLS)
@pytest.mark.parametrize("row", ROWS, ids=lambda row: row.partition("  ⟶  ")[0])
def test_spellings_are_rewritten_and_keep_their_places(tmp_path: Path, row: str, form: str) -> None:
    written, steps = row.split("  ⟶  ")
    path = tmp_path / f"p.{form}"
    path.write_text(SHELLS[form].format(written))
    (display,) = read_text(path).displays
    spelled = [step.spelled() for line in steps_of(display) for step in line]
    assert ["".join(latex.split()) for latex, _ in spelled] == [
        "".join(each.split()) for each in steps.split(" ;; ")
    ]
    assert all(written in token.source.text for _, owners in spelled for token in owners)
