"""What the table of operators says of linearity, asked of both engines: f(x + y) = f(x) + f(y), and d/dt through
f, hold where it says so; the first nowhere else."""

from __future__ import annotations

from itertools import product
from typing import get_args

import pytest

from workbench.core.construct import apply, derivative, relation, symbol
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.operations import GRADIENTS, LINEAR, OPERATORS, PARTIALS
from workbench.core.terms import Head, IllFormed
from workbench.core.types import QUATERNION, SCALAR, TENSOR, VECTOR, Declaration
from workbench.core.verdict import Outcome
from workbench.engines.inventory import NoDefinitions
from workbench.prover.decide.decide import Judge

TYPES = (VECTOR, TENSOR, SCALAR, QUATERNION)
PLACE = symbol(Declaration(Name("r"), VECTOR).with_flags(coordinate=True))
#: P D and partial derivatives are linear in what they act on; tests/judge/functions/test_slopes.py has laws of their own.
HEADS = sorted(set(OPERATORS) - {"compose", *PARTIALS})


def test_each_head_has_a_row():
    in_certificates = {"reciprocal", "turn"}  # terms of the emitter only
    assert set(get_args(Head)) - in_certificates == set(OPERATORS)


def free(letter, type_):
    return symbol(Declaration(Name(letter), type_, Linear(0)))


def field(letter):
    return apply("mul", symbol(Declaration(Name(letter), TENSOR).with_flags(uniform=True)), PLACE)


def arguments_of(head):
    """Twice the arguments of the first types that the operation takes."""
    if head in GRADIENTS:
        return [field("A")], [field("B")]
    types = [t.with_dual(True) for t in TYPES] if head in ("re", "du") else TYPES
    for chosen in (chosen for count in (1, 2, 3) for chosen in product(types, repeat=count)):
        xs, ys = ([free(f"{letter}_{i}", type_) for i, type_ in enumerate(chosen)] for letter in "xy")
        try:
            apply(head, *xs)
        except (IllFormed, ValueError, TypeError, IndexError):
            continue
        if head != "add" or len(chosen) > 1:
            return xs, ys
    raise AssertionError(head)


def holds(left, right):
    return Judge(NoDefinitions()).judge(relation("=", left, right)).outcome == Outcome.PROVED


def put(terms, place, term):
    return [*terms[:place], term, *terms[place + 1 :]]


@pytest.mark.parametrize("head", HEADS)
def test_linear_operations_are_linear_in_each_argument(head):
    xs, ys = arguments_of(head)
    additive = [
        holds(
            apply(head, *put(xs, place, apply("add", x, y))),
            apply("add", apply(head, *xs), apply(head, *put(xs, place, y))),
        )
        for place, (x, y) in enumerate(zip(xs, ys, strict=True))
    ]
    assert all(additive) == (head in LINEAR)


@pytest.mark.parametrize("head", [head for head in HEADS if OPERATORS[head].linear == "components"])
def test_the_product_rule_holds_for_each_operation(head):
    xs, _ = arguments_of(head)
    still = [symbol(x.declaration.with_flags(constant=True)) for x in xs]
    for place, x in enumerate(xs):
        moved = apply(head, *put(still, place, x))
        assert holds(derivative(moved, 1), apply(head, *put(still, place, derivative(x, 1))))


@pytest.mark.parametrize("head", [head for head, operator in OPERATORS.items() if operator.partner])
def test_a_partner_takes_the_same(head):
    xs, _ = arguments_of(head)
    assert OPERATORS[OPERATORS[head].partner].partner == head
    apply(OPERATORS[head].partner, *xs)
