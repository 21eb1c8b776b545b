"""What is declared of a defined symbol is asked of its definition."""

from pathlib import Path

import pytest

from tests.texts.written import verdicts
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.paper_errors import PaperError
from workbench.core.verdict import Outcome
from workbench.papers.load import load_paper

TURN = r"\begin{bmatrix} \cos a & -\sin a & 0 \\ \sin a & \cos a & 0 \\ 0 & 0 & 1 \end{bmatrix}"
KEPT = [
    ("rotation", "", TURN, r"X^{-1} = X^T"),
    ("rotation", "", r"R^T " + TURN, r"\det X = 1"),
    ("tensor", "constant", r"m (\mathbf{I} + S)", r"\dot X = 0"),
    ("tensor", "symmetric", r"R S R^T", "X^T = X"),
    ("tensor", "constant symmetric", "S S", r"\dot X^T = \dot X"),
    ("vector", "unit", r"[\cos a, \sin a, 0]^T", r"X \cdot X = 1"),
    ("vector", "unit constant", r"\begin{bmatrix} 3/5 \\ 0 \\ 4/5 \end{bmatrix}", r"X \cdot \dot X = 0"),
    ("scalar", "constant", "m + 2", r"\dot X = 0"),
]
BROKEN = [
    ("rotation", "", TURN.replace("-", ""), "rotation"),
    ("rotation", "", "-" + TURN, "rotation"),
    ("tensor", "constant", f"m {TURN}", "constant"),
    ("tensor", "symmetric", "R S", "symmetric"),
    ("vector", "unit", r"[\cos a, \sin a, 1]^T", "unit"),
    ("scalar", "constant", "m a", "constant"),
]


def written(folder: Path, kind: str, flags: str, body: str, formula: str) -> Path:
    (folder / "p.md").write_text(f"$$ {formula} $$")
    declared = ", ".join([f"kind = '{kind}'", *(f"{flag} = true" for flag in flags.split())])
    symbols = (
        f"X = {{ {declared} }}\na = 'scalar'\nR = 'rotation'\nm = {{ kind = 'scalar', constant = true }}\n"
    )
    symbols += "S = { kind = 'tensor', symmetric = true, constant = true }\n"
    (folder / "p.toml").write_text(f"source = 'p.md'\n[symbols]\n{symbols}[definitions]\nX = '{body}'\n")
    return folder / "p.toml"


@pytest.mark.parametrize(("kind", "flags", "body", "formula"), KEPT)
def test_a_definition_may_keep_it(tmp_path: Path, kind: str, flags: str, body: str, formula: str) -> None:
    (result,) = judge_paper(load_paper(written(tmp_path, kind, flags, body, formula)))
    assert result.verdict.outcome is Outcome.PROVED


@pytest.mark.parametrize(("kind", "flags", "body", "flag"), BROKEN)
def test_one_that_is_not_seen_to_is_refused_at_its_place(
    tmp_path: Path, kind: str, flags: str, body: str, flag: str
) -> None:
    with pytest.raises(
        PaperError, match=f"declared as {flag}, which its definition is not seen to be"
    ) as told:
        load_paper(written(tmp_path, kind, flags, body, "X = X"))
    assert told.value.line == 9


def test_a_letter_that_is_a_symbol_is_no_index_of_what_is_kept(tmp_path: Path) -> None:
    symbols = "X_m = { kind = 'scalar', constant = true }\nm = { kind = 'scalar', constant = true }\n"
    (verdict,) = verdicts(
        tmp_path, "$$ \\dot X_m = 0 $$", f"source = 'p.md'\n[symbols]\n{symbols}[definitions]\nX_m = '2 m'\n"
    )
    assert verdict.outcome is Outcome.PROVED
