"""The judge against values, kind by kind: ≈, sums to n, e^x, J_l and J_r, Ad and ad, quaternions, ∂, frames, …

An identity of `evaluator.kits` is perhaps made a special case of, and most often changed in one place. What is
proved then must hold where its symbols are curves of numbers, and what is refuted must fail there, or at the
counterexample.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache, partial
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory

import pytest
from evaluator.frames import Triads
from evaluator.kits import KITS
from evaluator.mutations import degenerate, mutated_once
from evaluator.series import NotRead
from evaluator.values import World
from test_values import Wrong, campaign, verdict_on

from tests.planted import planted
from workbench.context.claims import Notation
from workbench.context.index_values import Orders, orders_within
from workbench.context.read_formulas import read_statement
from workbench.core.construct import apply, derivative, number, relation, symbol
from workbench.core.names import Name
from workbench.core.terms import IllFormed, Implication, Statement, Zero
from workbench.core.verdict import Outcome, Verdict
from workbench.language.author_notation import AuthorNotation
from workbench.language.definition_entries import read_definitions
from workbench.language.definitions import Definitions
from workbench.language.printing.author_spelling import printed_for
from workbench.language.printing.printer import to_latex
from workbench.papers.load import load_notation
from workbench.prover.decide.decide import Judge
from workbench.runtime import STANDARD, OutOfBudget, Workers

#: Taylor coefficients: more than two derivatives of what the kits define.
LENGTH = 6


@cache
def notation_of(kind: str) -> Notation:
    with TemporaryDirectory() as folder:
        file = Path(folder) / "notation.toml"
        file.write_text(KITS[kind].notation, encoding="utf-8")
        return load_notation(file)


@cache
def claims_of(kind: str) -> list[tuple[Statement, Orders | None]]:
    found = []
    for latex in KITS[kind].identities:
        statement, ranges = read_statement(latex, notation_of(kind), None)
        found.append((statement, orders_within(None, ranges)))
    return found


@cache
def judge_of(kind: str) -> Judge:
    return Judge(notation_of(kind).definitions)


def worlds(kind: str, count: int, fixed: dict | None = None) -> Iterator[World]:
    kit, notation = KITS[kind], notation_of(kind)
    known = list(notation.definitions)
    if fixed is None:
        known += read_definitions(kit.supposing, notation.symbols)[0]
    own = Triads("U" if kind == "homogeneous" else "N", kit.places) if kit.places else None
    for seed in range(count):
        yield World(Definitions(known), seed, fixed, length=LENGTH, own=own)


@pytest.fixture(scope="module")
def aside() -> Iterator[Workers]:
    with Workers(verdict_on, STANDARD) as workers:
        yield workers


def changed(random: Random, statement: Statement, kind: str) -> Statement:
    """Raises IllFormed where the change fits nowhere."""
    if isinstance(statement, Implication):
        return Implication(statement.left, changed(random, statement.right, kind))
    table, claim = notation_of(kind).symbols, statement
    if random.random() < 0.25 and not KITS[kind].supposing:
        claim = degenerate(random, claim, table)
    if random.random() < 0.1 and kind not in ("exponentials", "slopes"):
        claim = relation(claim.operator, derivative(claim.left, 1), derivative(claim.right, 1))
    if random.random() < 0.1 and Name("f") in table.symbols:
        f = symbol(table.symbols[Name("f")])
        claim = relation(claim.operator, apply("mul", f, claim.left), apply("mul", f, claim.right))
    for _ in range(random.choice((0, 1, 1, 1, 2))):
        claim = mutated_once(random, claim, table)
    return claim


def check_one(aside: Workers, kind: str, random: Random) -> str:
    statement, orders = random.choice(claims_of(kind))
    try:
        statement = changed(random, statement, kind)
    except IllFormed:
        return "ill-formed"
    claim = statement.right if isinstance(statement, Implication) else statement
    if claim.left == claim.right or (isinstance(claim.left, Zero) and isinstance(claim.right, Zero)):
        return "same"
    try:
        verdict = aside.call((judge_of(kind), statement, orders))
    except OutOfBudget:
        return "out of budget"
    if verdict is None:
        return "unchecked"
    try:
        refuse_contradicted(kind, statement, orders, verdict)
    except NotRead:
        return "not evaluated"
    return str(verdict.outcome)


def refuse_contradicted(kind: str, statement: Statement, orders: Orders | None, verdict: Verdict) -> None:
    """Raises Wrong where values contradict the verdict."""
    instances = list(orders.assignments()) if orders else [{}]
    if orders and (verdict.scope or "").startswith("all"):
        instances += [dict.fromkeys(orders.variables, n) for n in (5, 6)]
    is_true = verdict.outcome in (Outcome.PROVED, Outcome.DEFINITION, Outcome.CONDITIONAL)
    if not is_true and verdict.outcome is not Outcome.REFUTED:
        return
    values = [world.holds(statement, n) for world in worlds(kind, 3) for n in instances]
    is_false = False in values
    if is_true and (is_false or not any(values)):
        raise Wrong(f"{kind}, {verdict.outcome}: {shown(kind, statement)}: {values}")
    if verdict.outcome is Outcome.REFUTED and not (is_false or fails_at(kind, statement, instances, verdict)):
        raise Wrong(f"{kind}, refuted: {shown(kind, statement)}: {values}, {verdict.counterexample}")


def fails_at(kind: str, statement: Statement, instances: list[dict], verdict: Verdict) -> bool:
    """Whether it is false where the counterexample has its symbols, whatever their derivatives are."""
    against = verdict.counterexample
    if against is None:
        return False
    said = [world.holds(statement, n) for world in worlds(kind, 3, dict(against.values)) for n in instances]
    return False in said


def shown(kind: str, statement: Statement) -> str:
    with printed_for(AuthorNotation(notation_of(kind).symbols)):
        return to_latex(statement)


_SHORT = ("sums", "exponentials", "quaternions", "angles", "oriented")
ALL = [pytest.param(kind, marks=() if kind in _SHORT else pytest.mark.slow) for kind in KITS]


@pytest.mark.parametrize("kind", ALL)
def test_a_verdict_that_values_contradict_is_detected(kind: str) -> None:
    """And the identities are true, whatever the judge says."""
    for statement, orders in claims_of(kind):
        refuse_contradicted(kind, statement, orders, planted(Outcome.PROVED))
    with pytest.raises(Wrong, match="refuted"):
        refuse_contradicted(kind, statement, orders, Verdict(Outcome.REFUTED))
    claim = statement.right if isinstance(statement, Implication) else statement
    false = relation(claim.operator, apply("mul", number(2), claim.left), claim.right)
    with pytest.raises(Wrong, match="proved"):
        refuse_contradicted(kind, false, orders, planted(Outcome.PROVED))


@pytest.mark.parametrize("kind", ALL)
def test_some_by_values(aside, kind: str) -> None:
    assert campaign(3, f"some {kind}", partial(check_one, aside, kind)).total() == 3


@pytest.mark.slow
@pytest.mark.parametrize("part", range(2))
@pytest.mark.parametrize("kind", KITS)
def test_many_by_values(aside, kind: str, part: int) -> None:
    found = campaign(120, f"{kind} {part}", partial(check_one, aside, kind))
    print(kind, dict(found))
    assert found["refuted"] + found["proved"] > 40, found
