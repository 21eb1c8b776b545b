"""Families: what is assumed and what hypothesis they need reaches each member, however they are judged."""

from dataclasses import replace

import pytest
from evaluator.identities import TABLE as IDENTITIES
from judge.test_judge import TABLE, defined, judged

from workbench.context.index_values import Orders
from workbench.core.integer_expressions import Linear
from workbench.core.verdict import Outcome
from workbench.language.definition_entries import read_definition
from workbench.language.definitions import Definitions
from workbench.language.elaboration.ranges import Range
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read
from workbench.prover.decide.decide import Judge

TANGLED = Definitions(
    [read_definition(key, body, IDENTITIES)[0] for key, body in {"k_{0,0}": "g", "k_{m,n}": "f"}.items()]
)
RECURRENCE, RECURRENT = defined(**{"s_0": "f", "s_{n+1}": r"\dot{s}_n"})
FIRST = Orders.parse("n = 0..2")

#: Claims that hold for f = g, by each way of judging them: definitions, table, scope.
WAYS = {
    "k_{n,n+1} = g": (TANGLED, IDENTITIES, "n = 0..2"),
    "f^n g = f^{n+1}": (None, TABLE, "n = 0..2"),
    "f a^{(n)} = a^{(n)} g": (None, TABLE, "all n"),
    "f s_{n+1} = g s_{n+1}": (RECURRENCE, RECURRENT, "all n"),
}


@pytest.mark.parametrize("latex", WAYS)
def test_premises_and_hypotheses_reach_each_member(latex):
    definitions, table, scope = WAYS[latex]
    common = {"orders": FIRST, "definitions": definitions, "table": table}
    found = judged(latex, ["f = g"], **common)
    assert (found.outcome, found.scope) == (Outcome.PROVED, scope)
    found = judged(latex, hypothesis="f = g", **common)
    assert (found.outcome, found.scope, str(found.hypothesis)) == (Outcome.CONDITIONAL, scope, "f = g")
    assert found.counterexample is not None
    assert judged(latex, **common).outcome == Outcome.REFUTED
    assert judged(latex, ["f = g + 1"], **common).outcome == Outcome.REFUTED


def test_behind_the_numbers_of_a_formula_the_premises_hold_too():
    """C(n, 4) is 0 up to n = 3 only."""
    endless = replace(Orders.parse("n = 0..3"), endless=frozenset("n"))
    for latex, assume, outcome in (
        ("C_n^4 f = 0", [], Outcome.REFUTED),
        ("C_n^4 f = 0", ["f = 0"], Outcome.UNCHECKED),
        ("C_n^4 f = 0", ["f = 1"], Outcome.REFUTED),
        ("C_n^4 f + g = g", [], Outcome.REFUTED),
    ):
        found = judged(latex, assume, orders=endless)
        assert found.outcome == outcome, found.reason
    found = judged("C_n^4 f = 0", orders=endless)
    assert found.reason == "for n = 4, though it holds for n = 0..3"
    found = judged("C_n^4 f = 0", ["f = 0"], orders=endless)
    assert found.reason == "holds for n = 0..3; no proof for all of the endless range of n was found"
    assert found.evidence == () and found.scope is None
    found = judged("C_n^4 f = 0", hypothesis="f = 0", orders=endless)
    assert found.outcome == Outcome.UNCHECKED


@pytest.mark.parametrize("latex", ["f = g", "f + g = g + f", "f = g + 1"])
@pytest.mark.parametrize("orders", ["n = 0..3", "m = 1..2, n = 0..3"])
def test_orders_without_their_letter_change_nothing(latex, orders):
    with_orders, without = judged(latex, orders=Orders.parse(orders)), judged(latex, orders=None)
    assert with_orders == without and with_orders.scope is None
    under = judged(latex, hypothesis="f = g", orders=Orders.parse(orders))
    assert under == judged(latex, hypothesis="f = g", orders=None)


def generic(text, *names):
    stated = tuple(Range(name, Linear(0), None, True) for name in names)
    return replace(Orders.parse(text), stated=stated)


def test_examples_of_indices_that_may_be_any_prove_nothing():
    table = SymbolTable.build({"f_i": {"kind": "scalar"}, "g": {"kind": "scalar"}})

    def found(latex, text, *names, assume=()):
        orders = generic(text, *names)
        (claim,) = read(latex, table, orders.variables)
        return Judge(Definitions()).judge(
            claim, [read(a, table, orders.variables)[0] for a in assume], orders=orders
        )

    one = found("f_i = f_j", "i = 1..2, j = 1..2", "i", "j")
    assert (one.outcome, one.reason) == (Outcome.REFUTED, "for i = 1, j = 2")
    same = found("f_i = f_j", "i = 1..1, j = 1..1", "i", "j")
    assert same.outcome == Outcome.UNCHECKED
    held = found("g^i + g = 2 g", "i = 1..1", "i")
    assert (held.outcome, held.reason) == (
        Outcome.UNCHECKED,
        "holds for i = 1..1; no range is stated for i",
    )
    under = found("f_i = f_j", "i = 1..2, j = 1..2", "i", "j", assume=["f_i = f_j"])
    assert under.outcome == Outcome.PROVED
    refuted = found("f_i = f_j", "i = 1..2, j = 1..2", "i", "j", assume=["f_i = f_j + 1"])
    assert refuted.outcome == Outcome.REFUTED
    both = found("f_i = f_j + (i - j)^2 g", "i = 1..2, j = 1..2", "i", "j", assume=["f_i = 0", "f_j = 0"])
    assert both.outcome == Outcome.REFUTED and both.reason == "for i = 1, j = 2"


@pytest.mark.parametrize(
    ("latex", "proved"),
    [
        (r"\operatorname{div}(x_n + \rho) = \operatorname{div} x_n + 3", False),
        (r"\operatorname{div}(y_n + \rho) = \operatorname{div} y_n + 3", True),
        (r"\operatorname{curl}(\rho^{(n)} + \rho) = \operatorname{curl} \rho^{(n)}", False),
        (r"\operatorname{div}(f^{(n)} \rho) = 3 f^{(n)}", True),
        (r"\frac{\partial q_n}{\partial q_n} = 1", True),
        (r"\frac{\partial}{\partial q_n} (q_n q_{n+1}^2) = q_{n+1}^2", True),
        (r"\frac{\partial}{\partial q_n} (q_n + q) = 1", True),
        (r"\frac{\partial}{\partial q_n} (q_n + q_4) = 1", False),
        (r"\frac{\partial q_n}{\partial q_m} = 0", False),
        (r"\frac{\partial h}{\partial q_n} = 0", False),
        (r"\frac{\partial z_n}{\partial q_n} = 0", False),
        (r"\frac{\partial c_n}{\partial q_n} = 2 q_n", True),
        (r"\frac{\partial}{\partial q} (q + p_n) = 1", False),
        (r"\frac{\partial q^2}{\partial q} p_n = 2 q p_n", True),
    ],
)
def test_derivatives_of_fields_of_any_order_are_judged_by_member(latex, proved):
    table = SymbolTable.build(
        {
            r"\rho": {"kind": "vector", "coordinate": True},
            "y_n": {"kind": "vector", "uniform": True},
            "f": {"kind": "scalar", "uniform": True},
            **{name: {"kind": "scalar", "independent": True} for name in ("q", "q_n", "z_n")},
            "p_n": {"kind": "scalar", "of": ["q"]},
            "h": {"kind": "scalar", "of": ["q_1"]},
        }
    )
    known = []
    bodies = {"x_0": r"\rho", "x_{n+1}": r"\dot{x}_n", "z_5": "q_5", "c_n": "q_n^2"}
    for key, body in bodies.items():
        definition, table = read_definition(key, body, table)
        known.append(definition)
    (claim,) = read(latex, table, "nm")
    ranges = "n = 1..2, m = 3..3" if "_m" in latex else "n = 1..2"
    found = Judge(Definitions(known)).judge(claim, orders=Orders.parse(ranges))
    assert (found.scope or "").startswith("all") == proved, (found.outcome, found.reason, found.scope)
