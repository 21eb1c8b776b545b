"""Of several formulas that say what a symbol is, the first one in the text defines it."""

from pathlib import Path

import pytest

from tests.context.judged_texts import KINDS, judged, model, text_of
from workbench.core.verdict import Outcome

MODEL = model({**KINDS, "y": "scalar"})
OTHER = "f (g a) = g f a"


@pytest.mark.parametrize("before", range(3))
def test_first_definition_counts_on_whatever_line_it_stands(tmp_path: Path, before: int) -> None:
    formulas = ["x = 2 f", "y = x + g", OTHER, OTHER, "x = 3 f", "y = 2 f + g", "y = 3 f + g"]
    *_, again, right, wrong = judged(tmp_path, text_of([OTHER] * before + formulas), MODEL)
    assert (again.outcome, wrong.outcome) == (Outcome.REFUTED, Outcome.REFUTED)
    assert right.outcome is Outcome.CONDITIONAL and "x = 2 f" in str(right.reason)


def test_definition_of_a_family_is_the_first_one_of_its_members(tmp_path: Path) -> None:
    formulas = ["J_n = f q_n", "J_2 = 3 f q_2", "J_1 + J_2 = f (q_1 + q_2)", "J_1 + J_2 = f (q_1 + 3 q_2)"]
    of = model({"f": "scalar", "q_n": "scalar", "J_n": "scalar"})
    _, again, right, wrong = judged(tmp_path, text_of(formulas), of)
    assert (again.outcome, wrong.outcome) == (Outcome.REFUTED, Outcome.REFUTED)
    assert right.outcome is Outcome.CONDITIONAL
