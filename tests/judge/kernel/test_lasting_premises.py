"""Premises that last: what their derivatives imply is not refuted, whichever names the rates have."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from workbench import check
from workbench.core.verdict import Outcome
from workbench.engines.inventory.prolonged_premises import prolonged
from workbench.language import reader
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable

VECTORS = ("x", "X", "r", "a", "A", "u", "U", "b", "v_r", "a_r", r"\omega")
SYMBOLS = dict.fromkeys(VECTORS, "vector")

SUM = "x = X + r"
RATE = r"\dot{r} = v_r + \omega \times r"
SECOND = r"\dot{v}_r = a_r + \omega \times v_r"
SPEEDS = (r"u = \dot{x}", r"U = \dot{X}")
ACCELERATIONS = (r"a = \ddot{x}", r"A = \ddot{X}")
BY_SPEEDS = (r"a = \dot{u}", r"A = \dot{U}")
MOVING = r"A + a_r + {two} \omega \times v_r + \dot{{\omega}} \times r + \omega \times (\omega \times r)"


def _laws() -> Iterator[tuple[str, str, tuple[str, ...]]]:
    """Yields a true formula, a false one, and the premises from whose derivatives the first follows."""
    yield r"u = U + v_r + \omega \times r", r"u = U + v_r - \omega \times r", (SUM, RATE, *SPEEDS)
    for named in (ACCELERATIONS, (*SPEEDS, *BY_SPEEDS)):
        true, false = (f"a = {MOVING.format(two=two)}" for two in ("2", "3"))
        yield true, false, (SUM, RATE, SECOND, *named)
        yield r"a = A + \ddot{r}", r"a = A - \ddot{r}", (SUM, *named)
        yield "a = A", "a = 2 A", ("x = X + b", r"\dot{b} = 0", *named)
    circle = (r"x \cdot x = 4", r"u = \dot{x}", r"a = \dot{u}")
    yield r"a \cdot x = -u \cdot u", r"a \cdot x = u \cdot u", circle


@pytest.mark.parametrize(("true", "false", "premises"), list(_laws()))
def test_consequences_of_derivatives_are_not_refuted(
    true: str, false: str, premises: tuple[str, ...]
) -> None:
    assert check(true, symbols=SYMBOLS, assume=premises).outcome != Outcome.REFUTED
    assert check(true, symbols=SYMBOLS, assume=premises[::-1]).outcome != Outcome.REFUTED
    assert check(false, symbols=SYMBOLS, assume=premises).outcome == Outcome.REFUTED


def test_laws_of_each_other_are_differentiated_as_needed() -> None:
    laws = (r"\dot{x} = \omega \times X", r"\dot{X} = x \times \omega", r"x \cdot x + X \cdot X = 1")
    table = SymbolTable.build({name: {"kind": "vector"} for name in ("x", "X", "r", r"\omega")})
    claim, *premises = (reader.read(latex, table)[0] for latex in (r"\ddot{x} = r", *laws))
    definitions = Definitions([])
    found = prolonged(premises, claim, definitions)
    assert len(found) == 4
    given = prolonged([*premises, *found[:1]], claim, definitions)
    assert given == found[1:]
    assert prolonged([*premises, *found], claim, definitions) == []
