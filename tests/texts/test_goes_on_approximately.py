"""A display that begins with a relation goes on with the last side of the one before it."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench.app.pipeline.judge_claims import judge_claims
from workbench.papers.load import load_paper

MODEL = """
source = "text.tex"
[symbols]
'\\theta' = { kind = "scalar", small = true }
'n' = { kind = "vector", unit = true }
[definitions]
'Q' = '\\cos\\theta \\mathbf{I} + \\sin\\theta \\tilde{n} + (1 - \\cos\\theta) n n^T'
"""
FIRST = r"\[ Q = \cos\theta \mathbf{I} + \sin\theta \tilde{n} + (1 - \cos\theta) n n^T \]"


@pytest.mark.parametrize(
    ("behind", "outcomes"),
    [
        (r"\[ \approx \mathbf{I} + \theta \tilde{n} \]", ["definition", "proved"]),
        (r"\[ \approx \mathbf{I} - \theta \tilde{n} \]", ["definition", "refuted"]),
        (
            r"\[ = \mathbf{I} + \sin\theta \tilde{n} + (1 - \cos\theta) \tilde{n}^2 \]",
            ["definition", "proved"],
        ),
        (r"that is \[ \approx \mathbf{I} + \theta \tilde{n} \]", ["definition", "unchecked"]),
    ],
)
def test_display_with_approximation_goes_on(tmp_path: Path, behind: str, outcomes: list[str]) -> None:
    (tmp_path / "text.tex").write_text(f"{FIRST}\n\n{behind}\n")
    (tmp_path / "text.toml").write_text(MODEL)
    results = judge_claims(load_paper(tmp_path / "text.toml").claims)
    assert [str(result.verdict.outcome) for result in results] == outcomes
