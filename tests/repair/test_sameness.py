"""What counts as the same statement: rearranged, rescaled, with other names for the same; and what does not."""

from fractions import Fraction
from random import Random

import pytest
from repair.damage import damages, read_or_fault, right_claims, same

from workbench.core.construct import relation
from workbench.core.terms import Conjunction, IllFormed, Relation, Zero
from workbench.papers import find_paper
from workbench.repair.terms.term_arithmetic import times


@pytest.fixture(scope="module")
def paper():
    return find_paper()


def claim_of(paper, name):
    return next(claim for claim in paper.claims if claim.id == name)


def statements(claim, *texts):
    return [read_or_fault(text, claim).statement for text in texts]


ALIKE = [
    (
        "20.a_1",
        r"\mathbf{a}_1 = \mathbf{v}_Q - \boldsymbol{\Phi}_1 \boldsymbol{\rho}_Q",
        r"\mathbf{a}_1 + \boldsymbol{\Phi}_1 \boldsymbol{\rho}_Q = \mathbf{v}_Q",
    ),
    (
        "20.a_1",
        r"\mathbf{a}_1 = \mathbf{v}_Q - \boldsymbol{\Phi}_1 \boldsymbol{\rho}_Q",
        r"\mathbf{a}_1 = \dot{\boldsymbol{\rho}}_Q - \boldsymbol{\omega} \times \boldsymbol{\rho}_Q",
    ),
    (
        "20.a_1",
        r"\mathbf{a}_1 = \mathbf{v}_Q - \boldsymbol{\Phi}_1 \boldsymbol{\rho}_Q",
        r"2 \mathbf{v}_Q - 2 \boldsymbol{\Phi}_1 \boldsymbol{\rho}_Q = 2 \mathbf{a}_1",
    ),
    (
        "58.det",
        r"\det \Phi_2 = 0 \Leftrightarrow \omega \times \dot{\omega} = 0",
        r"\dot{\omega} \times \omega = 0 \Leftrightarrow \det \Phi_2 = 0",
    ),
    ("58.det", r"\det \Phi_2 \neq 0", r"-\det \Phi_2 \neq 0"),
    (
        "4.velocity",
        r"\mathbf{a}_1 = \mathbf{v} - \boldsymbol{\Phi}_1 \boldsymbol{\rho} = \mathbf{v}_Q - \boldsymbol{\Phi}_1 \boldsymbol{\rho}_Q",
        r"\mathbf{a}_1 = -\boldsymbol{\Phi}_1 \boldsymbol{\rho} + \mathbf{v} = \mathbf{v}_Q - \boldsymbol{\omega} \times \boldsymbol{\rho}_Q",
    ),
]

DIFFERENT = [
    (
        "20.a_1",
        r"\mathbf{a}_1 = \mathbf{v}_Q - \boldsymbol{\Phi}_1 \boldsymbol{\rho}_Q",
        r"\mathbf{v}_Q = \dot{\boldsymbol{\rho}}_Q",
    ),
    (
        "20.a_1",
        r"\mathbf{a}_1 = \mathbf{v}_Q - \boldsymbol{\Phi}_1 \boldsymbol{\rho}_Q",
        r"\boldsymbol{\Phi}_1 \boldsymbol{\rho}_Q = \boldsymbol{\omega} \times \boldsymbol{\rho}_Q",
    ),
    ("58.det", r"\omega \times \omega = 0", r"\dot{\omega} \times \dot{\omega} = 0"),
    ("58.det", r"\det \Phi_2 \neq 0", r"\det \Phi_2 = 0"),
    (
        "58.det",
        r"\det \Phi_2 = 0 \Leftrightarrow \omega \times \dot{\omega} = 0",
        r"\det \Phi_2 = 0 \Leftrightarrow \dot{\omega} = 0",
    ),
    (
        "4.velocity",
        r"\mathbf{a}_1 = \mathbf{v} - \boldsymbol{\Phi}_1 \boldsymbol{\rho} = \mathbf{v}_Q - \boldsymbol{\Phi}_1 \boldsymbol{\rho}_Q",
        r"\mathbf{a}_1 = \mathbf{v} - \boldsymbol{\Phi}_1 \boldsymbol{\rho}",
    ),
]


@pytest.mark.parametrize(("name", "one", "other"), ALIKE)
def test_alike(paper, name, one, other):
    claim = claim_of(paper, name)
    assert same(claim, *statements(claim, one, other))
    assert same(claim, *statements(claim, other, one))


@pytest.mark.parametrize(("name", "one", "other"), DIFFERENT)
def test_different(paper, name, one, other):
    claim = claim_of(paper, name)
    assert not same(claim, *statements(claim, one, other))
    assert not same(claim, *statements(claim, other, one))


def test_a_multiple_is_the_same_and_a_damaged_equation_is_not(paper):
    random = Random(3)
    rearranged = false = 0
    for claim, formula in right_claims(paper)[::18]:
        statement = formula.statement
        assert same(claim, statement, statement)
        for damaged in damages(claim, formula, random, 1):
            if damaged.claim.printed.statement is not None and not isinstance(statement, Conjunction):
                assert not same(claim, statement, damaged.claim.printed.statement), (claim.id, damaged.kind)
                false += 1
        if isinstance(statement, Relation) and statement.operator == "=":
            factor = Fraction(random.choice((-3, 2, 5)), random.choice((1, 2)))
            sides = (
                side if isinstance(side, Zero) else times(factor, side)
                for side in (statement.right, statement.left)
            )
            try:
                scaled = relation("=", *sides)
            except IllFormed:  # the n-th derivative of a symbol without a weight
                continue
            assert same(claim, statement, scaled), claim.id
            rearranged += 1
    assert rearranged > 5 and false > 25
