"""Two labels under an arrow or a line are one name, if it is declared: \\vec{AB}."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Outcome
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read_term
from workbench.papers import load_paper

SYMBOLS = {
    r"\overrightarrow{OA}": "vector",
    r"\vec{OB'}": "vector",
    r"\vec{O_1 O_2}": "vector",
    r"\overline{A B}": "scalar",
    r"\hat{\mathbf{AB}}": "vector",
    r"\vec{\alpha B}": "vector",
    "a": "vector",
    "b": "vector",
}


@pytest.mark.parametrize("name", SYMBOLS)
def test_printed_pairs_of_labels_read_back(name: str) -> None:
    table = SymbolTable.build({key: {"kind": kind} for key, kind in SYMBOLS.items()})
    term = read_term(name, table)
    assert read_term(to_latex(term), table) == term


def test_points_in_turn(tmp_path: Path) -> None:
    (tmp_path / "p.md").write_text(
        "\n\n".join(
            f"$$ {each} $$"
            for each in (
                r"\overrightarrow{AC} = \overrightarrow{AB} + \overrightarrow{BC}",
                r"\overrightarrow{AB} = -\overrightarrow{BA}",
                r"\overrightarrow{AB} = \overrightarrow{BA}",
            )
        )
    )
    points = '[points]\nnames = ["A", "B", "C"]\n\'\\overrightarrow{PO}\' = "to O from P"\n'
    (tmp_path / "p.toml").write_text('source = "p.md"\n[frames]\nbase = "N"\ndot = "N"\n' + points)
    found = [result.verdict.outcome for result in judge_paper(load_paper(tmp_path / "p.toml"))]
    assert found == [Outcome.PROVED, Outcome.PROVED, Outcome.REFUTED]
