"""Polynomials packed into one indeterminate are those in many."""

from random import Random

import pytest

from workbench.engines.inventory import NotExact
from workbench.engines.jet.packed_polynomials import WIDTH, PackedPolynomials


def some(packed, random, terms=4):
    """A random polynomial."""
    total = packed.integers.zero
    for _ in range(terms):
        term = packed.integers.ground_new(random.randint(-3, 3))
        for g in random.choices(packed.generators, k=random.randint(0, 3)):
            term = term * g ** random.randint(1, 9)
        total = total + term
    return total


def polynomials_in(count):
    packed = PackedPolynomials()
    assert [packed.make() for _ in range(count)] == list(range(count))
    return packed


def cases():
    for seed in range(25):
        random = Random(f"packed{seed}")
        packed = polynomials_in(random.randint(1, 6))
        yield packed, some(packed, random), some(packed, random), random


def spread(packed, p):
    return packed.spread(p, packed.many)


def test_sums_and_products_are_those_of_the_polynomials_in_many():
    for packed, p, q, _ in cases():
        assert spread(packed, p + q) == spread(packed, p) + spread(packed, q)
        assert spread(packed, p * q) == spread(packed, p) * spread(packed, q)
        assert packed.packed(spread(packed, p)) == p.set_ring(packed.rationals)
        assert bool(p.LC > 0) == bool(spread(packed, p).LC > 0)


def test_generators_in_a_polynomial_are_found():
    alone = 0
    for packed, p, _, random in cases():
        place, x = random.choice(list(enumerate(packed.generators)))
        for q in (p, p + x, p + x + x * p):
            powers = [each[-1 - place] for each in spread(packed, q)]
            assert (place in packed.places(q)) == any(powers)
            assert (place in packed.odd_places(q)) == any(power % 2 for power in powers)
            once = [power for power in powers if power] == [1]
            assert packed.is_alone(place, q) == (once and any(monomial in q for monomial in x))
            alone += once
    assert alone > 2


@pytest.mark.parametrize("power", [1, 2, 3])
def test_a_power_is_rewritten_wherever_it_is(power):
    """As SymPy divides by x^power − value."""
    for packed, p, q, random in cases():
        place = random.randrange(len(packed.generators))
        value = packed.rewritten(q, place, 1, packed.integers.one)
        x = spread(packed, packed.generators[place])
        remainder = spread(packed, p)
        while high := [term for term in remainder.terms() if term[0][-1 - place] >= power]:
            for monomial, c in high:
                term = remainder.ring.from_dict({monomial: c})
                remainder += term.exquo(x**power) * spread(packed, value) - term
        assert spread(packed, packed.rewritten(p, place, power, value)) == remainder


def test_factors_multiply_to_the_polynomial():
    for packed, p, q, _ in cases():
        product = packed.rationals.one
        for factor, power in packed.factors(p * q):
            product = product * factor**power
        whole = (p * q).set_ring(packed.rationals)
        assert product * whole.LC == whole * product.LC


@pytest.mark.parametrize("place", [0, 1, 2])
def test_a_power_that_would_reach_into_the_next_digit_is_refused(place):
    """Before it does: the highest that passes can be multiplied by itself."""
    packed = polynomials_in(3)
    x = packed.generators[place]
    highest = x ** ((1 << (WIDTH - 1)) - 1)
    assert packed.normal(highest + 1) == packed.checked(highest + 1) == highest + 1
    assert spread(packed, highest * highest).LM[-1 - place] == (1 << WIDTH) - 2
    for refused in (highest * x, highest * highest, highest * x + 1):
        with pytest.raises(NotExact, match="a power of 32768 or more"):
            packed.normal(refused)
        with pytest.raises(NotExact, match="a power of 32768 or more"):
            packed.checked(refused)


def test_a_square_that_grows_too_high_is_refused():
    packed = polynomials_in(2)
    x, y = packed.generators
    packed.set_square(0, y ** (1 << (WIDTH - 3)))
    assert packed.normal(x**2 * y) == y ** ((1 << (WIDTH - 3)) + 1)
    for power in (8, 16, 1 << (WIDTH - 2)):
        with pytest.raises(NotExact):
            packed.normal(x**power)
