"""What a judge has computed for one statement it keeps for the next, and that changes no verdict."""

from dataclasses import replace
from random import Random

import pytest
from evaluator.identities import IDENTITIES, TABLE

from workbench.core.construct import apply, derivative, relation
from workbench.engines.inventory.inventory import take_inventory
from workbench.language import reader
from workbench.language.definition_entries import read_definitions
from workbench.language.definitions import Definitions
from workbench.prover.decide import both_engines
from workbench.prover.decide.case import Case
from workbench.prover.decide.decide import Judge
from workbench.prover.decide.equation import Equation


def read(latex, table=TABLE):
    (statement,) = reader.read(latex, table)
    return statement


def statements(random, table):
    """Identities, their derivatives, and what is false, in any order."""
    right = [read(line, table) for line in random.sample(IDENTITIES, 25)]
    right = [said for said in right if hasattr(said, "left") and said.operator == "="]
    once = [
        relation("=", *(derivative(x, 1) for x in (r.left, r.right)))
        for r in right
        if r.left.type.kind != "operator"
    ]
    wrong = [relation("=", apply("add", r.left, r.left), r.right) for r in right]
    return random.sample([*right, *once, *wrong], len(right) + len(once) + len(wrong))


def told(judge, statement):
    try:
        return judge.judge(statement).to_dict()
    except ValueError as error:
        return str(error)


@pytest.mark.parametrize("seed", range(4))
def test_the_verdict_is_that_of_a_judge_that_has_seen_nothing(seed, monkeypatch):
    monkeypatch.setattr(both_engines, "_MOST", (20, 60, 120, 500)[seed])
    monkeypatch.setattr(both_engines, "_KEPT", (1, 3, 10, 60)[seed])
    bodies = {"T": r"\dot{R} R^T", "g": r"a \cdot b"}
    free = {key: value for key, value in TABLE.symbols.items() if key not in bodies}
    definitions, table = read_definitions(bodies, replace(TABLE, symbols=free))
    known = Judge(definitions)
    for statement in statements(Random(seed), table):
        assert told(known, statement) == told(Judge(definitions), statement)


def case(latex, judge):
    return Case(judge, [read(latex)], ())


def test_statements_about_the_same_share_an_engine():
    judge = Judge(Definitions())
    first, again = case(r"a \times b = -b \times a", judge), case(r"b + a = a \times b", judge)
    assert first.exact is again.exact
    assert first.second is again.second is case(r"R a = b", judge).second
    assert case(r"\dot{a} = b", judge).exact is not first.exact
    assert case(r"a \times b = -b \times a", Judge(Definitions())).exact is not first.exact
    assert case(r"a \times b = -b \times a", replace(judge, laws=False)).exact is first.exact


@pytest.mark.parametrize(
    "other",
    [
        r"f \frac{a}{f} = a",
        r"\|a\| f = f \|a\|",
        r"\cos (\omega f) a = a \cos (\omega f)",
        r"f (f \mathbf{I})^{-1} a = a",
    ],
)
def test_statements_with_divisions_share_no_engine(other):
    """Its engine remembers what it divided by, and the next statement would be asked for it."""
    judge = Judge(Definitions())
    for latex in (other, r"f a = a f", other):
        statement = read(latex)
        inventory = take_inventory([statement.left, statement.right], judge.definitions)
        made = (
            judge.engines.first(inventory, judge.definitions),
            judge.engines.second(inventory, judge.definitions),
        )
        again = (
            judge.engines.first(inventory, judge.definitions),
            judge.engines.second(inventory, judge.definitions),
        )
        assert [x is y for x, y in zip(made, again, strict=True)] == [latex != other] * 2
        residues = judge.engines.residues(inventory, judge.definitions)
        assert (residues is judge.engines.residues(inventory, judge.definitions)) == (latex != other)


def test_under_an_assumption_the_engine_is_its_own():
    judge = Judge(Definitions())
    said, supposed = read(r"f a = a f"), read(r"f = g")
    under = Equation(judge, said, (supposed,))
    assert under.exact is not Equation(judge, said, (supposed,)).exact
    assert under.second is not under.second


def test_an_engine_that_has_grown_is_replaced(monkeypatch):
    monkeypatch.setattr(both_engines, "_MOST", 5)
    judge = Judge(Definitions())
    small = case(r"a = c", judge)
    before = small.second
    assert before is small.second
    before.residuals(read(r"a = c"))
    assert len(before.ring.point) == 6
    assert small.second is not before
    assert len(small.second.ring.point) == 0


def test_so_many_are_kept(monkeypatch):
    monkeypatch.setattr(both_engines, "_KEPT", 2)
    judge = Judge(Definitions())
    first = case(r"a = b", judge).exact
    assert case(r"a = c", judge).exact is not first
    assert case(r"a = b", judge).exact is first
    assert case(r"b = c", judge).exact is not first
    assert case(r"a = b", judge).exact is not first
