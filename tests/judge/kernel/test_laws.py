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

SYMBOLS = {
    **{name: "vector" for name in ("p", "g", "a", "b", "v", "F", r"\omega", "M", "d")},
    **{name: "scalar" for name in ("f", "h")},
    "m": {"kind": "scalar", "constant": True},
    r"\mu": {"kind": "scalar", "constant": True},
    "J": {"kind": "tensor", "symmetric": True, "constant": True},
    "T": "tensor",
    "R": "rotation",
    "u": {"kind": "vector", "unit": True},
    "q": {"kind": "hamilton quaternion", "unit": True},
}


@pytest.mark.parametrize(
    ("law", "derivative"),
    [
        (r"m \ddot{p} = m g", r"\ddot{p}"),
        (r"\frac{d}{dt}(m v) = F", r"\dot{v}"),
        (r"J \dot{\omega} + \omega \times (J \omega) = M", r"\dot{\omega}"),
        (r"\frac{d}{dt}(J \omega) = -\omega \times (J \omega)", r"\dot{\omega}"),
        (r"\dot{R} = \tilde{\omega} R", r"\dot{R}"),
        (r"\dot{u} = \omega \times u", r"\dot{u}"),
        (r"\dot{q} = \frac{1}{2} \operatorname{quat}(0, \omega) q", r"\dot{q}"),
        (r"\ddot{p} = -\frac{\mu}{\|p\|^3} p", r"\ddot{p}"),
    ],
)
def test_laws(law: str, derivative: str) -> None:
    said = check(law, SYMBOLS)
    assert said.outcome == Outcome.UNCHECKED
    assert f"states a law for {derivative}," in said.verdict.reason


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
