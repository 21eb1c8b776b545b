"""All that a verdict tells: what was decided, why, under which hypothesis, for which n, and the point at which it fails."""

from pathlib import Path

import pytest

from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read
from workbench.prover.decide.decide import Judge

TABLE = SymbolTable.build(
    {
        **{name: {"kind": "scalar"} for name in "fgh"},
        **{name: {"kind": "vector"} for name in "abc"},
        "T": {"kind": "tensor"},
        "u": {"kind": "vector", "unit": True},
        r"\delta": {"kind": "scalar", "small": True},
    }
)


ARROW, OPTION = "  ⟶  ", "  ‖ "
LINES = (Path(__file__).parent / "what_is_told.txt").read_text("utf-8").splitlines()[2:]


def told(row: str) -> str:
    """Returns the verdict in words, with the point where the claim fails."""
    latex, *options = row.split(OPTION)
    premises, hypotheses = (
        [read(option.removeprefix(key), TABLE)[0] for option in options if option.startswith(key)]
        for key in ("assume: ", "under: ")
    )
    (claim,) = read(latex, TABLE)
    found = Judge(Definitions()).judge(claim, premises, *hypotheses)
    assert found.read_back == to_latex(claim)
    said = {"for": found.scope, "under": found.hypothesis, "why:": found.reason}
    parts = [str(found.outcome), *(f"{word} {text}" for word, text in said.items() if text is not None)]
    if (point := found.counterexample) is not None:
        values = ", ".join(f"{name} = ({' '.join(value)})" for name, value in point.values.items())
        parts.append(f"at {values}: {' '.join(point.left)} against {' '.join(point.right)}")
    return ";  ".join(parts)


@pytest.mark.parametrize("line", LINES, ids=lambda line: line.partition(ARROW)[0])
def test_what_is_told(line: str) -> None:
    row, _ = line.split(ARROW)
    assert f"{row}{ARROW}{told(row)}" == line
