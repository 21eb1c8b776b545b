"""A property that a sentence states of one symbol holds for no other; a fact that is used is no doubt."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import FORMATS, display, inline, text_of, verdicts
from workbench.core.verdict import Grade, Outcome

MODEL = """source = 'p.{}'
[symbols]
'm' = 'scalar'
'r' = 'vector'
'n' = 'vector'
[definitions]
'J' = 'm \\left( (r \\cdot r) \\mathbf{{I}} - r r^T \\right)'
"""
#: True, and true for J = 0 only.
TRUE, FALSE = r"J = - m \tilde{r} \tilde{r}", r"\operatorname{tr} J = m\, r \cdot r"
SENTENCES = (
    r"where {} is the skew matrix of {},",
    r"with {} being a skew-symmetric matrix, and {} the place,",
    r"where the skew-symmetric matrix of {} is {},",
)


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("sentence", SENTENCES)
def test_property_of_one_matrix_holds_for_no_other(tmp_path: Path, form: str, sentence: str) -> None:
    said = "Then, " + sentence.format(inline(r"\tilde{r}", form), inline("r", form))
    shown = [said, display(TRUE, form), said, display(FALSE, form)]
    true, false = verdicts(tmp_path, text_of(shown, form), MODEL.format(form), form)
    assert (true.outcome, false.outcome) == (Outcome.PROVED, Outcome.REFUTED)
    assert false.grade is Grade.ERROR


@pytest.mark.parametrize("form", FORMATS)
def test_condition_that_a_refutation_meets_is_no_doubt(tmp_path: Path, form: str) -> None:
    rest = inline(r"\dot{n} = 0", form)
    shown = display(r"\frac{d}{dt} (n \cdot r) = 2 n \cdot \dot{r}", form)
    (found,) = verdicts(
        tmp_path, text_of([f"Since {rest}, we have\n\n{shown}"], form), MODEL.format(form), form
    )
    assert found.outcome is Outcome.REFUTED
    assert "the text says more" not in "; ".join(found.unless)
