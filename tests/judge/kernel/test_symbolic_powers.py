"""Powers with an unbound exponent: judged value by value, never for all n at once."""

import pytest

from workbench.context.index_values import Orders
from workbench.core.verdict import Outcome
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.inventory import take_inventory
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read, read_term
from workbench.prover.decide.decide import Judge

TABLE = SymbolTable.build({"A": {"kind": "tensor"}, "x": {"kind": "vector"}})


@pytest.mark.parametrize("power", ["A^n", r"(\mathbf{D} - A)^{n+1} x", r"A^{n-1} x"])
def test_they_are_outside_the_exact_world(power):
    with pytest.raises(NotExact, match="exponent n"):
        take_inventory([read_term(power, TABLE, {"n"})], Definitions())


@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"(\mathbf{D} - A)^n x = (\mathbf{D} - A)^{n-1} (\dot{x} - A x)", Outcome.PROVED),
        (r"\det (A^n) = (\det A)^n", Outcome.PROVED),
        (r"\operatorname{trace} (A^n) = (\operatorname{trace} A)^n", Outcome.REFUTED),
    ],
)
def test_they_are_judged_over_a_range(formula, outcome):
    (statement,) = read(formula, TABLE, {"n"})
    verdict = Judge(Definitions()).judge(statement, orders=Orders.parse("n = 1..2"))
    assert verdict.outcome == outcome
    assert verdict.scope in ("n = 1..2", None)
