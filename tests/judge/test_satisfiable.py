"""What is supposed must be possible: points that satisfy it are found, rational or not, and "no values satisfy
it" is said only where that is proved."""

from fractions import Fraction
from random import Random

import pytest
from judge.test_judge import judged

from workbench.core.verdict import Outcome
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.assumptions import Unsatisfiable
from workbench.engines.jet.number_field import Algebraic, NumberField, NumberFieldRing

SATISFIABLE = [
    [r"\cos \alpha = -1"],
    [r"\cos \alpha = \frac{1}{2}"],
    [r"\sin \alpha = \frac{3}{5}"],
    ["f^2 = 2"],
    ["f^3 = 2"],
    ["f^5 - f = 1"],
    [r"a \cdot b = 100"],
    [r"a \cdot b = 100", r"a \times b \neq 0"],
    [r"a \cdot a = 7", r"a \cdot b = 1"],
    [r"\|a\| = 2", r"\|a\| = \|b\|"],
    [r"\operatorname{trace} R = 2"],
    [r"\operatorname{trace} R = -1"],
    [r"u \cdot a = \frac{1}{3}"],
    [r"\dot{a} \cdot a = 5"],
    [r"\det T = 2"],
    [r"f (g^2 \cos\alpha - \dot{g}^2 \sin\alpha) = 0", r"f \neq 0", r"g \neq 0", r"\cos\alpha \neq 0"],
]
IMPOSSIBLE = [
    ["f^2 = -1"],
    [r"\cos \alpha = 2"],
    [r"\cos \alpha = \frac{1}{2}", r"\sin \alpha = \frac{1}{2}"],
    [r"a \cdot a = -1"],
    [r"\|a\| = -1"],
    [r"\operatorname{trace} R = -2"],
    [r"\operatorname{trace} R = 4"],
    [r"u = 0"],
    ["R = 0"],
    ["a = 0", r"a \neq 0"],
    [r"f \neq f"],
    [r"f g = 1", "f = 0"],
    [r"a \times b = c", r"c \neq 0", r"a \cdot c = 3"],
]


@pytest.mark.parametrize("assume", SATISFIABLE, ids=" and ".join)
def test_a_point_is_found(assume):
    verdict = judged("g = 17 f + 19", assume)
    assert verdict.outcome == Outcome.REFUTED
    assert verdict.counterexample.left != verdict.counterexample.right


@pytest.mark.parametrize("assume", IMPOSSIBLE, ids=" and ".join)
def test_the_impossible_is_refused(assume):
    with pytest.raises(Unsatisfiable):
        judged("g = 17 f + 19", assume)


@pytest.mark.parametrize(
    ("latex", "assume", "outcome"),
    [
        (r"\sin^2 \alpha = \frac{3}{4}", [r"\cos \alpha = \frac{1}{2}"], Outcome.PROVED),
        (r"\sin \alpha = \frac{3}{4}", [r"\cos \alpha = \frac{1}{2}"], Outcome.REFUTED),
        (r"\sin \alpha = 0", [r"\cos \alpha = -1"], Outcome.PROVED),
        (r"b \cdot a = 100", [r"a \cdot b = 100"], Outcome.PROVED),
        (r"\operatorname{trace} R^2 = 0", [r"\operatorname{trace} R = 2"], Outcome.PROVED),
        (r"\operatorname{trace} R^2 = 1", [r"\operatorname{trace} R = 2"], Outcome.REFUTED),
        ("f^4 = 4", ["f^2 = 2"], Outcome.PROVED),
        ("f = 1", ["f^2 = 2"], Outcome.REFUTED),
        ("f^3 = f^2", ["f^3 = 2"], Outcome.REFUTED),
        ("f = 0", ["f^2 = 0"], Outcome.PROVED),
    ],
)
def test_consequences_of_assumptions_are_judged(latex, assume, outcome):
    assert judged(latex, assume).outcome == outcome


def random_element(field, random):
    return Algebraic(field, [Fraction(random.randint(-5, 5), random.randint(1, 4)) for _ in range(3)])


FIELDS = {
    "cube root of 2": NumberField((-2, 0, 0, 1), (Fraction(1), Fraction(2))),
    "of degree 5": NumberField((-1, -1, 0, 0, 0, 1), (Fraction(1), Fraction(2))),
}


@pytest.mark.parametrize("name", FIELDS)
def test_the_laws_of_a_field(name):
    field, random, divide = FIELDS[name], Random(3), NumberFieldRing().divide
    for _ in range(30):
        x, y, z = (random_element(field, random) for _ in range(3))
        assert x + y == y + x and x * y == y * x
        assert (x * y) * z == x * (y * z) and x * (y + z) == x * y + x * z
        assert x - x == 0 and 2 * x - x == x and 1 - x == -(x - 1)
        assert float(x * y) == pytest.approx(float(x) * float(y))
        if y:
            assert divide(x, y) * y == x and divide(Fraction(3), y) * y == 3
    assert divide(x, Fraction(2)) * 2 == x


def test_a_root_is_a_root():
    field = FIELDS["cube root of 2"]
    assert field.generator * field.generator * field.generator == 2
    assert field.generator != 1 and float(field.generator) == pytest.approx(2 ** (1 / 3))
    assert (field.generator * 0).rational() == 0 and field.generator.rational() is None


def test_how_numbers_are_written():
    root = NumberField((-3, 0, 1), (Fraction(0), Fraction(3))).generator
    other = NumberField((-3, 0, 1), (Fraction(-3), Fraction(0))).generator
    assert [str(x) for x in (other, other * -2 + 1, other * other)] == ["-√3", "1 + 2 √3", "3"]
    half = NumberField((-1, 0, 2), (Fraction(0), Fraction(1))).generator
    assert str(half * 3 - 1) == "-1 + 3 √(1/2)"
    assert str(root * Fraction(1, 2) + 1) == "1 + 1/2 √3" and str(-root) == "-√3" and str(root * root) == "3"
    cubic = FIELDS["cube root of 2"].generator
    assert str(cubic * cubic - 1) == "-1 + θ^2 where -2 + θ^3 = 0, θ ≈ 1.25992"
    assert str(cubic * 0 + Fraction(1, 2)) == "1/2"


@pytest.mark.parametrize("bounds", [(2, 3), (-1, 1)])
def test_an_interval_without_a_root_is_refused(bounds):
    with pytest.raises(ValueError, match="changes its sign"):
        NumberField((-2, 0, 0, 1), tuple(map(Fraction, bounds)))


def test_there_is_no_inverse_of_zero_and_no_irrational_root():
    field = FIELDS["cube root of 2"]
    with pytest.raises(ZeroDivisionError):
        NumberFieldRing().divide(field.generator, field.generator * 0)
    with pytest.raises(NotExact):
        NumberFieldRing().root(field.generator)
    assert NumberFieldRing().root(field.generator * 0 + 4) == 2
