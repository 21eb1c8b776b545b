"""What can be solved for a free symbol's derivative is a law, and neither true nor false."""

from __future__ import annotations

from dataclasses import replace

import pytest
from evaluator.identities import TABLE

from workbench import check
from workbench.context.claims import Notation
from workbench.context.read_formulas import read_statement
from workbench.core.integer_expressions import Linear
from workbench.core.terms import Derivative, Relation
from workbench.core.verdict import Outcome
from workbench.engines.inventory.inventory import take_inventory
from workbench.language.definitions import Definitions
from workbench.prover.decide.law_statements import law_for

UNIT_COLUMNS = ("(1, 0, 0)", "(0, 1, 0)", "(0, 0, 1)")


NUMBERS = {name: "scalar" for name in ("x", "y", "f", "h")}


RESOLVED = {**dict(zip(("e_1", "e_2", "e_3"), UNIT_COLUMNS, strict=True)), "r": "x e_1 + y e_2 + f e_3"}


@pytest.mark.parametrize(
    ("formula", "named"),
    [
        (r"\ddot{r} = -r", r"\ddot{r}"),
        (r"\dot{v} = -v", r"\dot{v}"),
        (r"v = 2 r", "v"),
        (r"\dot{v} = g", r"\dot{v}"),
        (r"\dot{r} = \dot{x} e_1 + \dot{y} e_2", None),
        (r"v = \dot{x} e_1 + \dot{y} e_2", None),
        (r"\dot{v} = \ddot{x} e_1 + g", None),
        (r"\frac{d}{dt}(h r) = h v", None),
        ("r = g", None),
    ],
)
def test_a_sum_along_fixed_axes_is_free(formula: str, named: str | None) -> None:
    symbols = {**dict.fromkeys(("e_1", "e_2", "e_3", "r", "v", "g"), "vector"), **NUMBERS}
    said = check(formula, symbols, definitions={**RESOLVED, "v": r"\dot{r}"})
    if named is None:
        assert said.outcome == Outcome.REFUTED
    else:
        assert f"states a law for {named}," in (said.verdict.reason or "")


def test_a_derivative_of_a_general_order_is_no_law() -> None:
    """The text of notebook 2 states aₙ = v⁽ⁿ⁾ + … for each n."""
    notation = Notation(TABLE, Definitions([]), {})
    relation = read_statement(r"\dot{a} = \dot{b}", notation, None)[0]
    assert isinstance(relation, Relation) and isinstance(relation.left, Derivative)
    general = replace(relation, left=replace(relation.left, order=Linear.variable("n")))
    inventory = take_inventory([relation.left, relation.right], notation.definitions)
    assert law_for(relation, inventory, notation.definitions) is not None
    assert law_for(general, inventory, notation.definitions) is None
