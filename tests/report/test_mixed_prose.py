"""A reason in words is split into text and the formulas in it."""

from __future__ import annotations

import pytest

from workbench.report.mixed_prose import Run, runs_with_symbols

SPLIT = [
    (r"the rate of a_{12} is unknown", ["the rate of ", r"*a_{12}", " is unknown"]),
    (r"\left\|\omega\right\|^{2}, \left\|\omega\right\| can vanish",
     [r"*\left\|\omega\right\|^{2}", ", ", r"*\left\|\omega\right\|", " can vanish"]),
    (r"\left(\left(a\right) b\right)^2 is 0", [r"*\left(\left(a\right) b\right)^2", " is 0"]),
    (r"a_1 \leftarrow b_2", ["*a_1", " ", r"*\leftarrow", " ", "*b_2"]),
    ("it is $a + b$ here", ["it is ", "*a + b", " here"]),
]  # fmt: skip


@pytest.mark.parametrize(("words", "runs"), SPLIT)
def test_words_are_split_from_formulas(words: str, runs: list[str]) -> None:
    assert runs_with_symbols(words) == [Run(each.lstrip("*"), each.startswith("*")) for each in runs]
