"""Sums over k and derivatives of order n: what the theorems say, and what the proof knows of them."""

from fractions import Fraction
from random import Random

import pytest

from workbench.certificates.emission.emitted_families import general
from workbench.certificates.emission.emitted_nodes import NotCertified
from workbench.certificates.emission.emitted_sums import Summed, cores_of, count
from workbench.certificates.theorem import theorem
from workbench.certificates.values.trial import holds_whatever_they_are
from workbench.core.construct import apply, big_sum, counting, derivative, relation, symbol
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.types import VECTOR, Declaration
from workbench.language.definitions import Definitions

N, K = map(Linear.variable, "nk")
X, Y = (symbol(Declaration(Name(name), VECTOR)) for name in "xy")
CROSS = apply("cross", X, Y)


def family(index):
    return symbol(Declaration(Name("z", sub=("", "")), VECTOR, indices=1), (index,))


def written(left, right):
    said, _, integers = general(relation("=", left, right), ())
    return theorem("t", said, (), Definitions(()), integers, several=True)


def leibniz(upper):
    factors = apply("cross", derivative(X, N - K), derivative(Y, K))
    return big_sum(["k"], 0, upper, apply("mul", counting("binomial", N, K), factors))


def test_leibniz_rule_holds_and_no_other():
    made = written(derivative(CROSS, N), leibniz(N))
    assert holds_whatever_they_are(made)
    assert made.read_back_faults() == []
    assert (
        "der n (x × y) ≡ sum_from 0 (S n) (fun k => whole (choose n k) • (der (nat_minus n k) x"
        in made.statement
    )
    assert not holds_whatever_they_are(written(apply("neg", derivative(CROSS, N)), leibniz(N)))
    assert not holds_whatever_they_are(written(derivative(apply("cross", Y, X), N), leibniz(N)))


def test_the_derivative_passes_sums_and_derivatives():
    total = apply("add", X, apply("neg", Y))
    assert holds_whatever_they_are(
        written(derivative(total, N), apply("add", derivative(X, N), apply("neg", derivative(Y, N))))
    )
    assert holds_whatever_they_are(written(derivative(derivative(X, 2), N), derivative(X, N + 2)))
    assert not holds_whatever_they_are(written(derivative(derivative(X, 2), N), derivative(X, N + 1)))
    shifted = big_sum(["k"], 1, N + 1, derivative(family(N + 1 - K), K))
    made = written(derivative(big_sum(["k"], 0, N, derivative(family(N - K), K)), 1), shifted)
    assert holds_whatever_they_are(made)
    assert made.read_back_faults() == []


def worth(total, values):
    """For n = 12."""
    places = range(int(total.lower), int(total.upper.substitute({"n": 12})) + 1)
    return sum(values[int(total.body.index[0].substitute({"k": k}))] for k in places)


def test_alike_sums_share_what_they_have_in_common():
    chance = Random(0)
    for _ in range(200):
        many = chance.randint(1, 4)
        ranges = [(chance.randint(0, 3), chance.randint(-1, 3), chance.randint(-2, 2)) for _ in range(many)]
        met = [
            Summed(big_sum(["k"], low - shift, N + high - shift, family(K + shift + 2)), False)
            for low, high, shift in ranges
        ]
        values = {n: Fraction(chance.randint(-9, 9)) for n in range(-9, 40)}
        for core in cores_of(met):
            assert core.total.lower.is_number
            assert (count(core.total) - N).is_number
        (core, *others) = cores_of(met)
        if others:
            continue
        for one in met:
            ends = worth(one.total, values) - worth(core.total, values)
            low, high, _ = ranges[met.index(one)]
            first = int(core.total.lower) + int(core.total.body.index[0] - K)
            last = int(core.total.upper - N) + int(core.total.body.index[0] - K)
            beside = [*range(low + 2, first), *range(12 + last + 1, 12 + high + 3)]
            assert ends == sum(values[place] for place in beside)


@pytest.mark.parametrize(
    ("old", "new"),
    [("sum_from 0 (S n)", "sum_from 0 n"), ("sum_from 0 (S n)", "sum_from 1 (S n)"), ("choose n k", "choose k n"),
     ("(nat_minus n k) x", "(nat_minus n (S k)) x"), ("der k y", "der n y"), ("der n (x", "der (S n) (x")],
)  # fmt: skip
def test_a_text_with_another_sum_is_detected(old, new):
    made = written(derivative(CROSS, N), leibniz(N))
    (said,) = made.conclusions
    assert old in said
    made.conclusions = [said.replace(old, new)]
    assert made.read_back_faults()


def test_an_index_that_may_be_below_0_is_refused():
    for addend in (family(N - K - 1), family(K - 1), derivative(X, N - K - 1)):
        with pytest.raises(NotCertified, match="the index"):
            written(big_sum(["k"], 0, N, addend), X)
