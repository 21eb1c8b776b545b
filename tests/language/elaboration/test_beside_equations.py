"""Ranges of integers, sums, least and greatest values: as they are read, or why not."""

from __future__ import annotations

import pytest

from tests.language.as_read import reads
from workbench import check
from workbench.core.formula_errors import ReadError
from workbench.core.verdict import Outcome


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\lambda = \lambda, n = 1 = 2", "refused 20: unknown symbol n"),
        (r"\lambda = \lambda, n \neq m", "refused 20: unknown symbol n"),
        (r"\lambda = \lambda, \forall n \neq m", "refused 28: unknown symbol n"),
    ],
)
def test_condition_on_an_unknown_letter_is_no_range(latex: str, expected: str) -> None:
    reads(latex, expected)


@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"\delta_i = 0, \forall i \neq 3, i = \overline{1, 3}", Outcome.REFUTED),
        (r"\delta_i^2 = 0, \forall i \neq 3, i = \overline{1, 3}", Outcome.REFUTED),
        (r"\delta_i^2 = 0, \forall i \neq 1", None),
    ],
)
def test_for_all_indices_but_one_is_no_range_from_it_on(formula: str, outcome: Outcome | None) -> None:
    known = [r"\delta_1 = 1", r"\delta_2 = 0", r"\delta_3 = 0"]
    if outcome is None:
        with pytest.raises(ReadError, match="has no range here"):
            check(formula, {r"\delta_n": "scalar"}, definitions=known)
    else:
        assert check(formula, {r"\delta_n": "scalar"}, definitions=known).verdict.outcome == outcome
