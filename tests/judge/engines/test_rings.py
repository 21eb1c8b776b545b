"""The rings of the second engine: the laws of rings, and what each of them is besides."""

from fractions import Fraction
from math import gcd
from random import Random

import pytest
from judge.test_judge import TABLE

from workbench.engines.inventory.inventory import take_inventory
from workbench.engines.jet.rings import PRIME, FloatRing, RationalRing, Residue, ResidueRing
from workbench.engines.jet.sympy_ring import Ratio, SympyRing
from workbench.engines.jet.tangents import Tangent, TangentRing, pushed
from workbench.language.definitions import Definitions
from workbench.language.reader import read


def sympy_elements():
    """Ratios of polynomials, some with a common denominator."""
    (claim,) = read(r"f g = a \cdot b", TABLE)
    ring = SympyRing(take_inventory([claim.left, claim.right], Definitions()))
    symbols = list(ring.point.values())

    def element(random):
        x, y, z = (random.choice(symbols) for _ in range(3))
        below = random.choice([ring.constant(3, 2), x, x + y, x + y, x * x + 1])
        return ring.divide(x * y - random.randint(-2, 2) * z, below)

    return ring, element


def tangent_elements(base, entry):
    ring = TangentRing(base)
    return ring, lambda random: Tangent(ring, entry(random), entry(random))


def rationals(random):
    return Fraction(random.randint(-9, 9), random.randint(1, 5))


RATIONALS = RationalRing(), rationals
RESIDUES = ResidueRing(), ResidueRing().random
TANGENTS = tangent_elements(*RATIONALS)
RINGS = {
    "rationals": RATIONALS,
    "residues": RESIDUES,
    "polynomials": sympy_elements(),
    "tangents": TANGENTS,
    "tangents over residues": tangent_elements(*RESIDUES),
    "tangents of tangents": tangent_elements(*TANGENTS),
}


@pytest.mark.parametrize("name", RINGS)
def test_the_laws_of_a_commutative_ring(name):
    ring, element = RINGS[name]
    random, zero, one = Random(7), ring.constant(0, 1), ring.constant(1, 1)
    for _ in range(12):
        x, y, z = (element(random) for _ in range(3))
        assert (x + y) + z == x + (y + z) and x + y == y + x and x + zero == x
        assert (x * y) * z == x * (y * z) and x * y == y * x and x * one == x
        assert x * (y + z) == x * y + x * z and not x - x and x - y == x + -y
        assert 2 * x == x + x and x * 3 == x + x + x and 1 - x == -(x - 1) and 0 + x == x + 0 == x
        assert x * ring.constant(3, 4) == 3 * x * ring.constant(1, 4)
        assert (x == y) == (not x - y) and x != x + 1 and x != x + one
        assert bool(x * y) == bool(x * y - zero)


@pytest.mark.parametrize("name", RINGS)
def test_a_quotient_is_what_its_divisor_makes_the_dividend(name):
    ring, element = RINGS[name]
    random = Random(8)
    for _ in range(12):
        x, y = element(random), element(random)
        y = y * y + 1  # with a value that is not 0
        assert ring.divide(x, y) * y == x
        assert ring.divide(ring.divide(x, y), y) * (y * y) == x
        assert ring.divide(x * y, y) == x
    with pytest.raises(ZeroDivisionError):
        ring.divide(x, x - x)


def test_ratios_are_reduced_with_each_denominator_named_once():
    """Numbers go below with numbers; a denominator is primitive, and its first coefficient is positive."""
    ring, element = sympy_elements()
    random = Random(11)
    for _ in range(30):
        x, y, z = (element(random) for _ in range(3))
        for r in (x + y, x * z, x - y * 6, ring.divide(x, 4 - y * y), ring.divide(x * 2, z * z + y)):
            assert r.number > 0 and gcd(r.number, *r.top.values()) == 1
            assert all(power > 0 for power in r.below.values())
    assert type(x * 0) is type(x - x) is type(ring.constant(4, 2)) is int  # numbers are no ratios
    for p in ring.denominators:
        assert gcd(*p.values()) == 1 and p.LC > 0 and not p.is_ground
    assert len({str(p) for p in ring.denominators}) == len(ring.denominators)
    known = len(ring.denominators)
    for x in (ring.divide(2, -3), ring.constant(2, -3), ring.constant(-4, 6), ring.lift(Fraction(-2, 3))):
        assert (x.top, x.number, x.below) == (-2, 3, {}) and x == Fraction(-2, 3)
    x = ring.divide(ring.constant(5, 1), next(iter(ring.point.values())) * Fraction(-10, 7))
    assert (x.top, x.number, len(x.below)) == (-7, 2, 1) and len(ring.denominators) == known


@pytest.mark.parametrize("where", ["value", "relation", "denominator"])
def test_a_number_of_another_library_is_found_in_any_position(where):
    ring, _ = sympy_elements()
    foreign = ring.polynomials.integers.one.new({(0,): Residue(1)})
    assert ring.tops([2]) == [2]
    if where == "relation":
        ring.polynomials.set_square(0, foreign)
    elif where == "denominator":
        ring.denominators.append(foreign)
    with pytest.raises(RuntimeError, match=r"computes with workbench\.engines\.jet\.rings\.Residue"):
        ring.tops([Ratio(ring, foreign, 1, {}) if where == "value" else 2])


def test_residues_are_numbers_modulo_the_prime():
    random = Random(9)
    for _ in range(20):
        x, y = random.randrange(-PRIME, PRIME), random.randrange(PRIME)
        a, b = Residue(x), Residue(y)
        assert (a + b).value == (x + y) % PRIME and (a - b).value == (x - y) % PRIME
        assert (
            (a * b).value == x * y % PRIME and (x - b).value == (x - y) % PRIME and (-b).value == -y % PRIME
        )
        assert a == x and a == x + PRIME and a != x + 1 and a != "x"
    assert not Residue(PRIME) and Residue(PRIME + 1) and not Residue(0)
    assert ResidueRing().constant(1, 3) * 3 == 1
    assert all(ResidueRing().random(random) for _ in range(20))


def test_a_tangent_is_a_change_along_a_line():
    """p(h) = x(h) y(h) is quadratic in h, so its slope is (p(1) − p(−1))/2."""
    ring, element = TANGENTS
    random = Random(10)
    for _ in range(20):
        x, y = element(random), element(random)

        def at(h, x=x, y=y):
            return (x.value + h * x.slope) * (y.value + h * y.slope)

        assert (x * y).value == at(0) and (x * y).slope == (at(1) - at(-1)) / 2
        assert (2 - x).value == 2 - x.value and (2 - x).slope == -x.slope
        root = ring.root(x * x) if x.value else None
        assert root is None or root == x or root == -x
    a, zero, one = Fraction(2, 3), Fraction(0), Fraction(1)
    assert Tangent(ring, zero, one) and Tangent(ring, one, zero) and not Tangent(ring, zero, zero)
    assert Tangent(ring, a, one) != Tangent(ring, a, zero) != Tangent(ring, one, zero)
    assert Tangent(ring, a, zero) == a and Tangent(ring, a, one) != a
    assert (ring.depth, TangentRing(ring).depth) == (1, 2)


def test_doubles():
    ring = FloatRing()
    assert (ring.divide(1.0, 4.0), ring.constant(3, 4), ring.root(2.25)) == (0.25, 0.75, 1.5)


@pytest.mark.parametrize("depth", [1, 2, 3])
def test_cosine_and_sine_of_a_moved_angle_are_those_of_the_sum(depth):
    """Of a step ε₁ + … with ε² = 0: the second powers of the sum are not 0, those beyond the depth are."""
    ring = RATIONALS[0]
    steps = []
    for _ in range(depth):
        ring = TangentRing(ring)
        steps = [Tangent(ring, step, step * 0) for step in steps]
        steps.append(Tangent(ring, ring.constant(0, 1).value, ring.constant(1, 1).value))
    start = ring.constant(3, 5), ring.constant(4, 5)
    at_once = pushed(start, sum(steps[1:], steps[0]), ring)
    one_by_one = start
    for step in steps:
        one_by_one = one_by_one[0] - one_by_one[1] * step, one_by_one[1] + one_by_one[0] * step
    assert at_once == one_by_one
