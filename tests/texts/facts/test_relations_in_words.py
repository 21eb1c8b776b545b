"""A sentence that says how two symbols are related is the premise of the formula beside it."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench.app.pipeline.judge_claims import judge_claims
from workbench.core.verdict import Outcome, Verdict
from workbench.papers.texts.load_texts import load_text

RELATIONS = [
    ("orthogonal", "(a + b)^2 = a^2 + b^2"),
    ("mutually perpendicular", "(a - b)^2 = a^2 + b^2"),
    ("parallel", r"a \times b = 0"),
    ("equal", "a + b = 2 a"),
]
SENTENCES = [
    r"As {} and {} are W, \[ F \]",
    r"Because {} and {} are W, we find \[ F. \]",
    r"\[ F \] since {} and {} are W.",
    r"We suppose that {} and {} are W. Then \[ F \]",
]


def verdict(tmp_path: Path, sentence: str) -> Verdict:
    (tmp_path / "p.tex").write_text(f"\\begin{{document}}\n{sentence}\n\\end{{document}}")
    kinds = "a = 'vector'\nb = 'vector'\nA = 'tensor'\nB = 'tensor'\n"
    (tmp_path / "p.toml").write_text(f"source = 'p.tex'\n[symbols]\n{kinds}")
    (result,) = judge_claims(load_text(tmp_path / "p.tex").claims)
    return result.verdict


@pytest.mark.parametrize("sentence", SENTENCES)
@pytest.mark.parametrize(("words", "formula"), RELATIONS)
def test_a_relation_in_words_is_a_premise(tmp_path: Path, sentence: str, words: str, formula: str) -> None:
    said = sentence.replace("W", words).replace("F", formula).format("$a$", r"\(b\)")
    found = verdict(tmp_path, said)
    assert found.outcome is Outcome.CONDITIONAL
    assert found.reason.startswith("holds by $a ")


def test_matrices_that_commute_are_a_premise(tmp_path: Path) -> None:
    assert verdict(tmp_path, r"As $A$ and $B$ commute, \[ A B A = A A B \]").outcome is Outcome.CONDITIONAL


@pytest.mark.parametrize("sentence", SENTENCES)
def test_claims_false_under_the_relation_are_refuted(tmp_path: Path, sentence: str) -> None:
    said = sentence.replace("W", "orthogonal").format("$a$", "$b$")
    assert verdict(tmp_path, said.replace("F", r"(a + b)^2 = a^2 + 2 b^2")).outcome is Outcome.REFUTED
    b_may_be_0 = said.replace("F", "(a + b)^2 = a^2")
    assert verdict(tmp_path, b_may_be_0).outcome is Outcome.REFUTED


@pytest.mark.parametrize("words", ["Without assuming that", "We do not suppose that", "Not only if"])
def test_denied_supposition_is_no_premise(tmp_path: Path, words: str) -> None:
    said = rf"{words} $a$ and $b$ are orthogonal, \[ (a + b)^2 = a^2 + b^2 \]"
    assert verdict(tmp_path, said).outcome is Outcome.REFUTED


@pytest.mark.parametrize("words", ["not orthogonal", "rarely parallel", "almost equal"])
def test_words_that_deny_or_weaken_are_no_premise(tmp_path: Path, words: str) -> None:
    said = rf"As $a$ and $b$ are {words}, \[ (a + b)^2 = a^2 + b^2 \]"
    assert verdict(tmp_path, said).outcome is Outcome.REFUTED
