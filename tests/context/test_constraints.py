"""An equation that may say what a symbol is: a claim where the facts leave nothing to be said."""

from pathlib import Path

import pytest

from tests.context.judged_texts import judged, model, text_of
from workbench.core.verdict import Grade, Outcome

#: The words before a formula that is false under what they say, and the formula.
FALSE = [
    (r"As $a \perp b$, we have", "(a + b)^2 = a^2"),
    (r"As $a$ and $b$ are orthogonal, we have", "(a + b)^2 = a^2"),
    (r"For $a \cdot b = 0$ we have", "(a - b)^2 = a^2"),
    (r"For $a = g b$ we have", r"a \times b = b"),
    ("We have", r"\hat{n} \cdot \hat{n} = 2 \hat{k} \cdot \hat{k}"),
    ("We have", r"\hat{n} \cdot \hat{n} = 3"),
]
MODEL = model({"a": "vector", "b": "vector", "g": "scalar", r"\hat{n}": "vector", r"\hat{k}": "vector"})


@pytest.mark.parametrize(("words", "formula"), FALSE)
def test_falsehood_under_facts_is_reported(tmp_path: Path, words: str, formula: str) -> None:
    (verdict,) = judged(tmp_path, text_of([formula], words), MODEL)
    assert verdict.outcome is Outcome.REFUTED and verdict.counterexample is not None
    assert verdict.grade in (Grade.WARNING, Grade.ERROR)


def test_product_of_parallel_vectors_is_no_vector_itself(tmp_path: Path) -> None:
    _, verdict = judged(tmp_path, text_of(["a = g b", r"a \times b = b"]), MODEL)
    assert (verdict.outcome, verdict.grade) == (Outcome.REFUTED, Grade.ERROR)


@pytest.mark.parametrize("formula", [r"a \times b = 0", r"a \cdot b = 0", r"a \cdot a = g^2"])
def test_equation_alone_is_note_with_counterexample(tmp_path: Path, formula: str) -> None:
    (verdict,) = judged(tmp_path, text_of([formula]), MODEL)
    assert (verdict.outcome, verdict.grade) == (Outcome.DEFINITION, Grade.NOTE)
    assert verdict.counterexample is not None


def test_quaternion_1_is_no_value_that_a_formula_gives(tmp_path: Path) -> None:
    formula = r"\frac{\operatorname{Sc}(q) + q}{|q|^2} = 1"
    *_, verdict = judged(tmp_path, text_of([formula]), model({"q": "hamilton quaternion", "a": "vector"}))
    assert (verdict.outcome, verdict.grade) == (Outcome.REFUTED, Grade.ERROR)


def test_condition_of_another_symbol_makes_no_claim(tmp_path: Path) -> None:
    (verdict,) = judged(tmp_path, text_of([r"a \cdot b = g"], r"For $a \cdot a = 1$ we have"), MODEL)
    assert verdict.grade is Grade.NOTE
