"""Letters above symbols in texts without a model: labels of frames, or powers."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.drafts import judged_draft_of
from workbench.core.verdict import Outcome
from workbench.papers.drafting.draft_model import ingest

TURNED = r"""The matrix $C_n^b$ turns coordinates in the frame $n$ into those in the frame $b$; it is orthogonal.

$$
x^b = C_n^b\, x^n
$$

$$
x^{b} \cdot x^{b} = x^n \cdot x^n
$$

$$
\omega_{in}^n = \omega_{ie}^n + \omega_{en}^n
$$
"""
POWERS = r"""Numbers $x$ and $n$ are given.

$$
y = x^n, \qquad x y = x^{n+1}
$$
"""


@pytest.mark.parametrize("letter", "nmk")
def test_letter_above_is_a_label_beside_others(letter: str, tmp_path: Path) -> None:
    path = tmp_path / "turned.md"
    path.write_text(
        TURNED.replace("n$", f"{letter}$").replace("^n", f"^{letter}").replace("_n", f"_{letter}")
    )
    assert f"x^{{{letter}}}" in ingest(path).guesses
    assert all(each.verdict.outcome is not Outcome.UNCHECKED for each in judged_draft_of(path)[:1])


def test_letter_above_is_a_power_without_others(tmp_path: Path) -> None:
    path = tmp_path / "powers.md"
    path.write_text(POWERS)
    assert not any("^" in name for name in ingest(path).guesses)
