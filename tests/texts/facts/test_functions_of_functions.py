"""Functions of functions: the chain rule holds, the other arguments are kept, and a slope is no rate."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import shown, verdicts
from workbench.core.verdict import Outcome

MODEL = """[symbols]
'q' = { kind = "scalar", independent = true }
'p' = { kind = "scalar", independent = true }
'Q' = { kind = "scalar", of = ['q', 'p'] }
'P' = { kind = "scalar", of = ['q', 'p'] }
'H' = { kind = "scalar", of = ['Q', 'P'] }
'F' = { kind = "scalar", of = ['q', 'p'] }
'G' = { kind = "scalar", of = ['P'] }
"""
FIRST, SECOND = r"\dot{q} = \frac{\partial %s}{\partial p}", r"\dot{p} = -\frac{\partial %s}{\partial q}"


@pytest.mark.parametrize("function", ["H", "F"])
@pytest.mark.parametrize("laws", [(FIRST, SECOND), (SECOND, FIRST), (FIRST,), (SECOND,)])
def test_two_laws_with_slopes_are_laws(tmp_path: Path, function: str, laws: tuple[str, ...]) -> None:
    found = verdicts(tmp_path, shown(*(each % function for each in laws)), MODEL)
    assert [each.outcome for each in found] == ["definition"] * len(laws)


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        (
            r"\frac{\partial H}{\partial q} = \frac{\partial H}{\partial Q} \frac{\partial Q}{\partial q}"
            r" + \frac{\partial H}{\partial P} \frac{\partial P}{\partial q}",
            Outcome.PROVED,
        ),
        (
            r"\frac{\partial H}{\partial q} = \frac{\partial H}{\partial Q} \frac{\partial Q}{\partial q}"
            r" - \frac{\partial H}{\partial P} \frac{\partial P}{\partial q}",
            Outcome.REFUTED,
        ),
        (
            r"\dot{H} = \frac{\partial H}{\partial Q} \dot{Q} + \frac{\partial H}{\partial P} \dot{P}",
            Outcome.PROVED,
        ),
        (
            r"\frac{\partial}{\partial p} \frac{\partial H}{\partial Q} ="
            r" \frac{\partial^2 H}{\partial Q^2} \frac{\partial Q}{\partial p}"
            r" + \frac{\partial^2 H}{\partial P \partial Q} \frac{\partial P}{\partial p}",
            Outcome.PROVED,
        ),
        (r"\frac{\partial G}{\partial Q} = 0 \cdot H", Outcome.UNCHECKED),
        (r"\frac{\partial (P H)}{\partial Q} = P \frac{\partial H}{\partial Q}", Outcome.UNCHECKED),
    ],
)
def test_chain_rule(tmp_path: Path, formula: str, expected: Outcome) -> None:
    (found,) = verdicts(tmp_path, shown(formula), MODEL)
    assert found.outcome == expected
