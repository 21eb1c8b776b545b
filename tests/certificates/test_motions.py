"""Motions that meet premises, and on which false statements fail."""

import itertools
import math
from fractions import Fraction

import pytest

from tests.certificates.emitted import all_certificates, one
from workbench.certificates.refutation import not_empty
from workbench.certificates.theorem import theorem
from workbench.certificates.values import trigonometric
from workbench.certificates.values.motion_instances import _CHOICES, instances
from workbench.certificates.values.motion_instances import BASE as BASE_SLOTS
from workbench.certificates.values.trigonometric import COSINE, SINE, TIME, Pair, Wave, flat, value, wave

BASE = {("false", "Scalar", str(i)): w for i, w in enumerate((COSINE, SINE, TIME))}
SOME = (COSINE, SINE, TIME, wave(Fraction(2, 3)), COSINE * SINE + TIME * TIME, COSINE * COSINE * TIME)


def at(w, t):
    return sum(float(a) * math.cos(t) ** i * math.sin(t) ** j * t**k for (i, j, k), a in w.terms.items())


@pytest.mark.parametrize(("x", "y"), list(itertools.product(SOME, repeat=2)))
def test_waves_are_a_differential_ring_with_correct_values(x, y):
    assert (x * y).rate() == x.rate() * y + x * y.rate()
    assert (x + y) * x == x * x + y * x
    for t in (-0.7, 0.3, 1.9):
        assert at(x * y, t) == pytest.approx(at(x, t) * at(y, t))
        assert at(x.rate(), t) == pytest.approx((at(x, t + 1e-6) - at(x, t - 1e-6)) / 2e-6, abs=1e-5)
    assert (x * y).at_zero == x.at_zero * y.at_zero


def test_sine_and_cosine_have_the_length_1():
    assert wave(1) == SINE * SINE + COSINE * COSINE
    assert (Pair(COSINE, SINE) * Pair(COSINE, -SINE)).du == wave(0)


@pytest.mark.parametrize(
    ("kind", "how", "deep"), [(*key, deep) for key, many in _CHOICES.items() for deep in many]
)
def test_each_motion_is_what_it_is_said_to_be(kind, how, deep):
    moved = {**BASE, ("false", kind, "9"): value(deep, BASE)}
    x = f"(Var false {kind} 9)"
    if "rotation" in how:
        assert flat(value(f"(Prod {x} (Transpose {x}))", moved)) == flat(value("(Idt false)", moved))
        assert value(f"(Det {x})", moved) == wave(1)
    if "unit" in how:
        assert value(f"(Dot {x} {x})", moved) == wave(1)
    if "constant" in how:
        assert not any(w.terms for w in flat(value(f"(DD {x})", moved)))


def test_the_order_is_that_of_the_derivatives():
    assert trigonometric.order(trigonometric.parsed("(Plus (DD (DD (Var a b 1))) (DD (Var a b 2)))"), {}) == 2
    assert trigonometric.order(trigonometric.parsed("(DD (Var a b 1))"), {("a", "b", "1"): 3}) == 4


def test_theorems_with_equal_premises_share_a_motion():
    motions = {not_empty(one(name)).text for name in ("3.skew", "3.omega")}
    assert len(motions) == 1
    (text,) = motions
    assert "~ forall (R : tensor K) (R_rotation : rotation R),\n  False." in text


def test_premises_are_met_as_the_theorem_states_them():
    certificate = one("59", "reading")
    (met,) = not_empty(certificate).theorems
    (theorem,) = certificate.theorems
    lines = theorem.statement.splitlines()[1:-1]
    assert [line for line in lines if "->" in line]
    assert met.statement.splitlines()[1:-1] == lines
    assert met.statement.endswith("False.")


def test_all_premises_are_met_by_a_motion():
    for _, made in all_certificates():
        if not isinstance(made, str):
            not_empty(made)


def test_a_quotient_is_the_series_of_one_over_its_quadratic():
    (motion,) = itertools.islice(instances(_emitted("62.inverse", "corrected")), 1)
    assert len(motion.quotients) == 2
    for quotient in motion.quotients.values():
        p, q, r = quotient.coefficients
        assert 4 * p * r > q * q
        product = quotient.value * value(quotient.quadratic, BASE)
        assert {place: x for place, x in product.terms.items() if place[2] <= 6} == wave(1).terms


def _emitted(claim_id, name):
    (made,) = one(claim_id, name).theorems
    statement, assume, _ = made.source
    return theorem("t", statement, assume, made.emitter.definitions, slots=BASE_SLOTS).emitter


def test_no_motion_meets_premises_that_exclude_each_other():
    emitter = _emitted("59", "reading")
    assert next(instances(emitter)).agree("(Var false Scalar 2)", "(Var false Scalar 2)")
    emitter.holes["never"] = [("(Num false (0 # 1))", "(Num false (1 # 1))")]
    assert list(instances(emitter)) == []


@pytest.mark.parametrize("bad", [Wave({(0, 0, 0): Fraction(0)})])
def test_nothing_is_said_of_a_symbol_without_a_value(bad):
    with pytest.raises(KeyError):
        value("(Var false Scalar 77)", {("false", "Scalar", "0"): bad})
