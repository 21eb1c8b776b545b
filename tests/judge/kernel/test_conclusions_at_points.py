"""Conclusions between random polynomial equations, against zeros that NumPy finds: a proved one fails nowhere."""

from random import Random

import numpy as np
import pytest

from workbench import check
from workbench.core.paper_errors import PaperError
from workbench.core.verdict import Outcome

LETTERS = "fgh"
SYMBOLS = dict.fromkeys(LETTERS, "scalar")


def polynomial(random, most=3):
    """Addends: a coefficient and letters."""
    return [
        (random.choice([-2, -1, 1, 1, 2, 3]), random.choices(LETTERS, k=random.randint(0, 2)))
        for _ in range(random.randint(1, most))
    ]


def product(p, q):
    return [(a * b, m + n) for a, m in p for b, n in q]


def written(p):
    return "".join(f" {c:+d} {' '.join(letters)}" for c, letters in p).strip().removeprefix("+")


def value(p, point):
    return sum(c * np.prod([point[letter] for letter in letters]) for c, letters in p)


def zeros(p, random):
    """Points on lines along one letter."""
    for _ in range(60):
        point = {letter: random.choice([-2.0, -1.0, 0.0, 0.5, 1.0, random.gauss(0, 1)]) for letter in LETTERS}
        along = random.choice(LETTERS)
        coefficients = np.zeros(9)
        for c, letters in p:
            others = [point[letter] for letter in letters if letter != along]
            coefficients[letters.count(along)] += c * np.prod(others)
        for root in np.roots(coefficients[::-1]) if coefficients.any() else [np.float64(point[along])]:
            found = {**point, along: float(root.real)}
            if abs(root.imag) < 1e-9 and abs(value(p, found)) < 1e-10:
                yield found


def related(random):
    """Two polynomials, the second often a multiple of the first or the first a power of it."""
    p, q = polynomial(random), polynomial(random)
    return random.choice([(p, q), (p, product(p, q)), (product(p, q), q), (product(q, q), q)])


@pytest.mark.parametrize(
    "seed", [*range(12), *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(12, 400))]
)
def test_a_conclusion_holds_at_the_zeros_of_its_premise(seed):
    random = Random(seed)
    p, q = related(random)
    both_ways, sign = random.random() < 0.5, random.choice(["=", r"\neq"])
    arrow = r"\Leftrightarrow" if both_ways else r"\Rightarrow"
    try:
        outcome = check(f"{written(p)} {sign} 0 {arrow} {written(q)} {sign} 0", symbols=SYMBOLS).outcome
    except PaperError as error:
        assert "no values" in str(error)
        return
    premise, conclusion = (p, q) if sign == "=" else (q, p)
    ways = [(premise, conclusion), *([(conclusion, premise)] if both_ways else [])]
    fails = any(abs(value(then, point)) > 1e-5 for given, then in ways for point in zeros(given, random))
    assert not (outcome == Outcome.PROVED and fails)
    assert outcome != Outcome.REFUTED or fails
