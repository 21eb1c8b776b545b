"""Steps that are shown whatever their sums and other unsaid terms are."""

from contextlib import suppress

import pytest

from tests.planted import planted
from workbench.app.pipeline.judge_claims import ClaimResult
from workbench.certificates.emission.emitted_families import general
from workbench.certificates.emission.emitted_nodes import NotCertified
from workbench.certificates.generalized import Generalizer
from workbench.certificates.steps import steps_of
from workbench.certificates.theorem import theorem
from workbench.certificates.values.trial import holds_whatever_they_are
from workbench.core.construct import apply, big_sum, derivative, integer, number, relation, symbol
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.types import VECTOR, Declaration
from workbench.core.verdict import Outcome
from workbench.language.definitions import Definitions
from workbench.papers import find_paper

N = Linear.variable("n")
X, Y = (symbol(Declaration(Name(name), VECTOR)) for name in "xy")


def sum_of(upper):
    return big_sum(["k"], 0, upper, derivative(X, Linear.variable("k")))


def plus(*terms):
    return apply("add", *terms)


def minus(a, b):
    return plus(a, apply("neg", b))


def holds(left, right):
    made = Generalizer(Definitions(()), {"n": 0})
    said, integers = relation("=", left, right), []
    with suppress(NotCertified):
        said, _, integers = general(made.equation(said), ())
    theorem_ = theorem("t", said, (), Definitions(()), integers, several=True)
    assert theorem_.read_back_faults() == []
    assert len(made.said) == len(made.meant)
    return holds_whatever_they_are(theorem_)


def test_only_terms_that_cancel_hold_for_all_values():
    total, other = sum_of(N), sum_of(N + 1)
    assert holds(plus(minus(total, Y), Y), total)
    assert holds(minus(plus(total, other), total), other)
    assert holds(plus(total, derivative(X, N + 1)), other)
    assert not holds(plus(total, derivative(X, N)), other)
    assert not holds(plus(minus(total, Y), Y), other)
    assert not holds(plus(total, X), other)
    assert not holds(total, apply("neg", total))


def test_derivatives_of_any_order_are_those_of_the_lowest():
    product = apply("cross", X, Y)
    high, low = derivative(product, N + 1), derivative(product, N)
    assert holds(minus(high, derivative(low, 1)), minus(Y, Y))
    assert not holds(high, low)


def test_a_number_that_depends_on_n_is_a_constant_and_may_be_any():
    n = integer(N)
    assert holds(apply("mul", n, plus(X, Y)), plus(apply("mul", n, X), apply("mul", n, Y)))
    assert not holds(apply("mul", n, X), X)


def test_premises_are_used_and_disequations_rejected():
    product = apply("dot", X, Y)
    unit = symbol(Declaration(Name("u"), VECTOR).with_flags(unit=True))
    assert holds(plus(apply("dot", unit, unit), product), plus(number(1), product))
    assert not holds(plus(apply("dot", unit, unit), product), plus(number(2), product))
    with pytest.raises(NotCertified):
        Generalizer(Definitions(()), {}).equation(relation("≠", X, Y))


@pytest.mark.parametrize("name", ["37.step", "127", "130.from_twist", "132.all", "135.all"])
def test_recurrences_and_values_of_operators_are_premises(name):
    paper = find_paper("chapter")
    (claim,) = [c for c in paper.claims if c.id == name]
    result = ClaimResult(claim, planted(Outcome.PROVED), None, None, Outcome.PROVED, True)
    written = [step for step in steps_of(result, paper.theorems).steps if step.certificate]
    general = [step.certificate for step in written if " is " in step.certificate.title]
    assert general
    assert not any(step.misread for step in written)
    for certificate in general:
        assert certificate.statement.startswith("(* ")
        (made,) = certificate.theorems
        assert holds_whatever_they_are(made)
        made.goals = [[(left, f"(Plus {right} {right})") for left, right in pairs] for pairs in made.goals]
        assert not holds_whatever_they_are(made)
