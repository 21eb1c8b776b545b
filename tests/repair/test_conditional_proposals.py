"""A correction is found whether the formula divides by something or multiplies with it."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench.core.verdict import Outcome
from workbench.papers import load_paper
from workbench.prover.results.proposed_form import Proposed
from workbench.repair.propose.repair import repair

#: A sign error, printed with a denominator and without, by the letters e, r, s, k.
PRINTED = [
    (r"<k> = \frac{1}{4} \frac{<r> + <s>}{<e>}", Outcome.CONDITIONAL),
    (r"<k> <e> = \frac{<r> + <s>}{4}", Outcome.PROVED),
    (r"\frac{<r> + <s>}{4 <e>} = <k>", Outcome.CONDITIONAL),
]
MODEL = """source = 'p.md'
[symbols]
'<e>' = 'scalar'
'<k>' = 'scalar'
[definitions]
'<r>' = '2 <e> <k> + <e>'
'<s>' = '<e> - 2 <e> <k>'
"""
ALPHABETS = [dict(zip("erks", "erks", strict=True)), {"e": "x", "r": r"\rho ", "s": r"\sigma ", "k": "y"}]


def renamed(text: str, letters: dict[str, str]) -> str:
    for mark, letter in letters.items():
        text = text.replace(f"<{mark}>", letter)
    return text


@pytest.mark.parametrize("letters", ALPHABETS)
@pytest.mark.parametrize(("printed", "outcome"), PRINTED)
def test_a_denominator_hides_no_correction(
    tmp_path: Path, letters: dict[str, str], printed: str, outcome: Outcome
) -> None:
    (tmp_path / "p.md").write_text(f"$$ {renamed(printed, letters)} $$\n")
    (tmp_path / "p.toml").write_text(renamed(MODEL, letters))
    first: Proposed = repair(load_paper(tmp_path / "p.toml").claims[0]).proposed()[0]
    assert first.verdict is outcome and "sign" in first.edit


def test_a_new_denominator_is_not_proposed(tmp_path: Path) -> None:
    (tmp_path / "p.md").write_text("$$ x y = x $$\n")
    (tmp_path / "p.toml").write_text("source = 'p.md'\n[symbols]\nx = 'scalar'\ny = 'scalar'\n")
    found = repair(load_paper(tmp_path / "p.toml").claims[0]).proposed()
    assert all(r"\frac" not in each.latex and each.verdict is Outcome.PROVED for each in found)
